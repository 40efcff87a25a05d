// Random programs with organization blocks that interrupt OB1: scans of the transition system, with interrupts at
// random places, against the engine. RUNGPROOF_SEED chooses other programs, RUNGPROOF_INTERRUPTED how many scans are
// compared.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>

#include "tests/agreement7/encoder_run.hpp"
#include "tests/agreement7/ir_of_text.hpp"
#include "tests/differential/random_source.hpp"
#include "tests/naive7/machine.hpp"

namespace rungproof::agreement7 {
namespace {

/// Statements on few bits and words, so that OB1 and what interrupts it meet.
class InterruptedProgram {
 public:
  explicit InterruptedProgram(std::uint64_t seed) : random_(seed) {}

  std::string text() {
    std::string program = block("FUNCTION FC 1 : VOID", statements(3), "END_FUNCTION");
    program += ob(1, statements(3) + "  CALL FC 1 ;\n" + statements(4));
    if (random_.chance(70)) program += ob(35, statements(3) + (random_.chance(30) ? "  CALL FC 1 ;\n" : ""));
    if (random_.chance(50)) program += ob(random_.chance(50) ? 40 : 82, statements(3));
    if (random_.chance(30)) program += ob(34, statements(2));
    return program;
  }

 private:
  static std::string block(const std::string& head, const std::string& statements, const std::string& end) {
    return head + "\nBEGIN\nNETWORK\n" + statements + end + "\n";
  }
  static std::string ob(int number, const std::string& statements) {
    return block(fmt::format("ORGANIZATION_BLOCK OB {}", number), statements, "END_ORGANIZATION_BLOCK");
  }
  std::string bit() { return fmt::format("{} {}.{}", random_.chance(30) ? "I" : "M", 0, random_.below(3)); }
  std::string word() { return fmt::format("MW {}", 10 + 2 * random_.below(3)); }
  std::string statement() {
    switch (random_.below(8)) {
      case 0: return fmt::format("A {}\n= M 0.{}", bit(), random_.below(3));
      case 1: return fmt::format("AN {}\nS M 0.{}", bit(), random_.below(3));
      case 2: return fmt::format("O {}\nR M 0.{}", bit(), random_.below(3));
      case 3: return fmt::format("A {}\nFP M 1.{}\n= M 0.{}", bit(), random_.below(2), random_.below(3));
      case 4: return fmt::format("L {}\nL 1\n+I\nT {}", word(), word());
      case 5: return fmt::format("L {}\nL {}\n-I\nT {}", word(), word(), word());
      case 6: return fmt::format("L {}\nT {}", word(), word());
      default: return fmt::format("L 0\nT {}", word());
    }
  }
  std::string statements(int count) {
    std::string text;
    for (int i = 0; i < count; ++i) {
      std::string lines = statement() + "\n";
      for (std::size_t end = lines.find('\n'); end != std::string::npos; end = lines.find('\n')) {
        text += "  " + lines.substr(0, end) + " ;\n";
        lines.erase(0, end + 1);
      }
    }
    return text;
  }

  RandomSource random_;
};

TEST(InterruptAgreement, TransitionSystemAndEngineInterruptAlike) {
  const char* chosen = std::getenv("RUNGPROOF_SEED");
  const char* many = std::getenv("RUNGPROOF_INTERRUPTED");
  const std::uint64_t seed = chosen == nullptr ? 35040 : std::strtoull(chosen, nullptr, 10);
  const int wanted = many == nullptr ? 400 : std::atoi(many);
  int scans = 0, programs = 0, compared = 0;
  for (; scans < wanted && programs < wanted; ++programs) {
    const std::uint64_t one = seed + static_cast<std::uint64_t>(programs);
    const std::string text = InterruptedProgram(one).text();
    std::string faults;
    const Program program = irOf(naive7::readProgram(text), one % 2 == 0, faults);
    ASSERT_EQ(faults, "") << text;
    const AgreementOutcome outcome = compareWithEngine(program, one, 10);
    scans += outcome.scans;
    compared += outcome.scans > 0 ? 1 : 0;
    ASSERT_EQ(outcome.difference, "") << "seed " << one << "\n" << text;
  }
  std::printf("seed %llu: %d scans of %d programs, %d of them compared\n", static_cast<unsigned long long>(seed), scans,
              programs, compared);
  EXPECT_GE(scans, wanted);
}

}  // namespace
}  // namespace rungproof::agreement7
