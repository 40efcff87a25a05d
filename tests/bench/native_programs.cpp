// Writes the programs.
#include "tests/bench/native_programs.hpp"

#include <fmt/format.h>

#include <random>

namespace rungproof::bench {

namespace {

class Writer {
 public:
  explicit Writer(std::uint64_t seed) : random_(seed) {}

  std::uint32_t below(std::uint32_t limit) { return static_cast<std::uint32_t>(random_() % limit); }
  std::string bit(const char* area, std::uint32_t count) {
    const std::uint32_t number = below(count);
    return fmt::format("{}{}.{}", area, number / 8, number % 8);
  }
  std::string contact() { return below(2) == 0 ? bit("I", 64) : bit("M", 200); }
  std::string word() { return fmt::format("VW{}", 2 * below(200)); }
  void line(const std::string& text) {
    text_ += text + "\n";
    ++count_;
  }
  /// The condition of a rung: two to six contacts, in one or two branches.
  void condition() {
    const char* const loads[] = {"LD ", "LDN "};
    const char* const joins[] = {"A ", "AN ", "O ", "ON "};
    const auto branch = [&] {
      line(loads[below(2)] + contact());
      for (std::uint32_t more = 1 + below(3); more > 0; --more) line(joins[below(4)] + contact());
    };
    branch();
    if (below(2) != 0) return;
    branch();
    line(below(2) == 0 ? "OLD" : "ALD");
  }
  void bitRung() {
    condition();
    const std::uint32_t kind = below(8);
    if (kind < 4) line("= " + bit("M", 200));
    if (kind == 4 || kind == 5) line("= " + bit("Q", 64));
    if (kind == 6) line("S " + bit("M", 200) + ", 1");
    if (kind == 7) line("R " + bit("M", 200) + ", 1");
  }
  void wordRung() {
    if (below(3) == 0)
      line("LDW>= " + word() + ", " + fmt::format("{}", below(2000)));
    else
      condition();
    for (std::uint32_t more = 1 + below(3); more > 0; --more) {
      switch (below(7)) {
        case 0: line("MOVW " + word() + ", " + word()); break;
        case 1: line(fmt::format("MOVW {}, {}", below(3000), word())); break;
        case 2: line("+I " + word() + ", " + word()); break;
        case 3: line(fmt::format("+I {}, {}", below(50), word())); break;
        case 4: line("-I " + word() + ", " + word()); break;
        case 5: line("ANDW " + word() + ", " + word()); break;
        default: line("INCW " + word()); break;
      }
    }
  }
  std::size_t count() const { return count_; }
  std::string take() { return "ORGANIZATION_BLOCK MAIN:OB1\nBEGIN\nNetwork 1\n" + text_ + "END_ORGANIZATION_BLOCK\n"; }

 private:
  std::mt19937_64 random_;
  std::string text_;
  std::size_t count_ = 0;
};

std::string bits(std::uint64_t seed, std::size_t size) {
  Writer writer(seed);
  while (writer.count() < size) writer.bitRung();
  return writer.take();
}

/// Two instructions of five on words.
std::string mixed(std::uint64_t seed, std::size_t size) {
  Writer writer(seed);
  while (writer.count() < size) writer.below(2) == 0 ? writer.bitRung() : writer.wordRung();
  return writer.take();
}

/// A hundred calls of four subroutines with parameters.
std::string calls(std::uint64_t seed) {
  Writer writer(seed);
  for (std::uint32_t i = 0; i < 100; ++i) {
    writer.line("LD " + writer.contact());
    writer.line(fmt::format("CALL SBR{}, {}, {}, {}", i % 4, writer.contact(), writer.word(), writer.word()));
  }
  std::string text = writer.take();
  for (std::uint32_t k = 0; k < 4; ++k) {
    text += fmt::format(
        "SUBROUTINE_BLOCK SBR_{0}:SBR{0}\nVAR_INPUT\non:BOOL;\nvalue:INT;\nEND_VAR\nVAR_OUTPUT\nresult:INT;\nEND_VAR\n"
        "BEGIN\nNetwork 1\nLD #on\nMOVW #value, #result\n+I {1}, #result\nLDN #on\nMOVW #value, #result\n-I {2}, "
        "#result\n"
        "Network 2\nLDW>= #result, {3}\nA #on\n= M{4}.{0}\nLDN M{4}.{0}\nAN #on\nS Q{0}.1, 1\nEND_SUBROUTINE_BLOCK\n",
        k, 3 + k, 5 + k, 100 * k, 20 + k);
  }
  return text;
}

/// Sums, copies and searches over 100 words through pointers.
std::string pointers() {
  return "ORGANIZATION_BLOCK MAIN:OB1\nBEGIN\n"
         "Network 1\nLD SM0.0\nMOVD &VB1000, AC1\nMOVW 0, AC0\nMOVD &VB2000, AC2\n"
         "Network 2\nLD SM0.0\nFOR VW0, 1, 100\n"
         "Network 3\nLD SM0.0\nMOVW *AC1, VW4\nANDW 255, VW4\n+I VW4, AC0\nMOVW AC0, *AC2\n+D 2, AC1\n+D 2, AC2\n"
         "Network 4\nNEXT\n"
         "Network 5\nLD SM0.0\nMOVD &VB1000, AC1\nMOVW 0, VW10\nFOR VW2, 1, 100\n"
         "Network 6\nLDW> *AC1, VW10\nMOVW *AC1, VW10\nMOVW VW2, VW12\n"
         "Network 7\nLD SM0.0\nINCW *AC1\nANDW 1023, *AC1\n+D 2, AC1\n"
         "Network 8\nNEXT\n"
         "Network 9\nLDW>= VW10, 500\n= Q0.0\nEND_ORGANIZATION_BLOCK\n";
}

}  // namespace

std::vector<NativeProgram> nativePrograms(std::uint64_t seed) {
  return {{"bit logic, 1,000 instructions", bits(seed, 1000), 0.5, 0.4, 22},
          {"bit logic, 10,000 instructions", bits(seed + 1, 10000), 0.5, 0.75, 70},
          {"bits and words, 1,000 instructions", mixed(seed + 2, 1000), 0.3, 0.25, 4.4},
          {"100 calls with parameters", calls(seed + 3), 0.3, 0.2, 4.4},
          {"pointer loops", pointers(), 0.3, 0.24, 4}};
}

}  // namespace rungproof::bench
