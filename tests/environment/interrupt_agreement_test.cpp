// Random small programs with interrupts: whatever value the reference engine reaches with events thrown in at random
// places, alone or many at once, `prove` does not call unreachable; and what `prove` shows, the engine repeats.
// RUNGPROOF_SEED chooses other programs, RUNGPROOF_PROGRAMS how many.
#include <cstdlib>
#include <set>

#include "engine/replay.hpp"
#include "interrupt_program.hpp"
#include "tests/differential/random_source.hpp"

namespace rungproof::test {
namespace {

class InterruptProgram {
 public:
  explicit InterruptProgram(std::uint64_t seed) : random_(seed) {
    const bool isTimed = random_.chance(25);
    events_ =
        isTimed ? std::vector<int>{10, random_.chance(50) ? 11 : 0} : std::vector<int>{0, random_.chance(50) ? 2 : 1};
    main = "LD SM0.1;";
    if (isTimed) main += "MOVB " + std::to_string(1 + random_.below(4)) + ",SMB34;MOVB 3,SMB35;";
    for (std::size_t i = 0; i < events_.size(); ++i)
      main += "ATCH INT_" + std::to_string(i) + "," + std::to_string(events_[i]) + ";";
    main += random_.chance(70) ? "ENI" : "MOVB 1,MB7";
    const std::size_t rungs = 2 + random_.below(4);
    for (std::size_t i = 0; i < rungs; ++i) main += ";" + mainRung();
    for (std::size_t i = 0; i < events_.size(); ++i) {
      std::string routine = random_.chance(15) ? edge() : rung();
      if (random_.chance(40)) routine += ";" + rung();
      routines.push_back(routine);
    }
  }

  std::string main;
  std::vector<std::string> routines;
  const std::vector<int>& events() const { return events_; }

 private:
  std::string bit() { return "M0." + std::to_string(random_.below(3)); }
  std::string byte() { return "MB" + std::to_string(1 + random_.below(3)); }
  std::string contact() {
    switch (random_.below(6)) {
      case 0: return "LD SM0.0";
      case 1: return "LD I0.4";
      case 2: return "LDN " + bit();
      case 3: return "LDB< " + byte() + ",3";
      default: return "LD " + bit();
    }
  }
  std::string action() {
    switch (random_.below(7)) {
      case 0: return "S " + bit() + ",1";
      case 1: return "R " + bit() + ",1";
      case 2: return "= " + bit();
      case 3: return "MOVB " + byte() + "," + byte();
      case 4: return "MOVB " + std::to_string(random_.below(4)) + "," + byte();
      default: return "INCB " + byte();
    }
  }
  std::string rung() { return contact() + ";" + action(); }
  /// A rising edge, kept by two coils.
  std::string edge() {
    const std::string seen = bit(), now = bit();
    return "LD " + now + ";AN " + seen + ";= " + bit() + ";LD " + now + ";= " + seen;
  }
  std::string mainRung() {
    const std::string event = std::to_string(events_[random_.below(static_cast<std::uint32_t>(events_.size()))]);
    switch (random_.below(9)) {
      case 0: return contact() + ";DISI";
      case 1: return contact() + ";ENI";
      case 2: return "LD SM0.0;DISI;" + action() + ";" + action() + ";ENI;" + action();
      case 3: return contact() + ";DTCH " + event;
      case 4: return "LD I0.5;ATCH INT_0," + event;
      default: return rung();
    }
  }

  RandomSource random_;
  std::vector<int> events_;
};

/// What M0.0 to M0.2 and MB1 to MB3 were at ends of scans of runs with random events.
std::set<std::string> reachedBy(const Program& program, const std::vector<int>& events, std::uint64_t seed) {
  RandomSource random(seed);
  std::set<std::string> reached;
  for (int run = 0; run < 12; ++run) {
    std::vector<ReplayScan> scans(6);
    for (ReplayScan& scan : scans) {
      scan.lengthMs = 1 + static_cast<std::uint32_t>(random.below(12));
      for (const std::uint32_t input : {4U, 5U})
        scan.inputs.push_back({direct(Area::I, Width::Bit, 0, input), random.below(2)});
      std::vector<std::uint32_t> places;
      for (std::size_t k = random.below(5); k-- > 0;)
        places.push_back(
            static_cast<std::uint32_t>(random.below(static_cast<std::uint32_t>(program.instructionCount()) + 1)));
      std::ranges::sort(places);
      for (const std::uint32_t place : places) {
        const bool isEnd = place == program.instructionCount();
        for (std::size_t k = 1 + (random.chance(15) ? 19 : random.below(3)); k-- > 0;) {
          scan.script.events.push_back({{isEnd ? ScanPlace::afterProgram : place, 0},
                                        events[random.below(static_cast<std::uint32_t>(events.size()))],
                                        random.chance(40)});
        }
      }
      if (!scan.script.events.empty()) scan.script.events.back().isWithNext = false;
    }
    for (const Concrete::Store& state : replay(program, Choices{}, scans).states) {
      for (std::uint32_t bit = 0; bit < 3; ++bit) {
        if (state.load(Area::M, bit, 1) != 0) reached.insert("M0." + std::to_string(bit));
      }
      for (std::uint32_t byte = 1; byte <= 3; ++byte)
        reached.insert("MB" + std::to_string(byte) + " = " + std::to_string(state.load(Area::M, byte * 8, 8)));
    }
  }
  return reached;
}

TEST(InterruptAgreement, NothingThatARunReachesIsUnreachable) {
  const char* given = std::getenv("RUNGPROOF_PROGRAMS");
  const int programs = given == nullptr ? 60 : std::atoi(given);
  int asked = 0, shown = 0;
  for (int i = 0; i < programs; ++i) {
    const std::uint64_t seed = testSeed() + 70000 + static_cast<std::uint64_t>(i);
    const InterruptProgram random(seed);
    const ProgramInput bare = interruptInput("", random.main, random.routines);
    const std::set<std::string> reached = reachedBy(bare.program, random.events(), seed);
    std::string properties;
    int number = 0;
    RandomSource pick(seed);
    for (const std::string& fact : reached) {
      if (reached.size() > 8 && !pick.chance(800 / static_cast<std::uint32_t>(reached.size()))) continue;
      properties += "//@ reach r" + std::to_string(number++) + ": " + fact + "\n";
    }
    if (properties.empty()) continue;
    const ProgramInput input = interruptInput(properties, random.main, random.routines);
    ProverOptions options = usualOptions(1);
    const ProofRun run = prove(input.program, input.properties, options);
    std::string text = "seed " + std::to_string(seed) + "\n" + random.main;
    for (const std::string& routine : random.routines) text += "\nINT: " + routine;
    EXPECT_TRUE(run.disagreements.empty()) << text << "\n"
                                           << (run.disagreements.empty() ? "" : run.disagreements[0].explanation);
    for (const ProofResult& result : run.results) {
      ++asked;
      shown += result.outcome == Outcome::Reachable ? 1 : 0;
      EXPECT_NE(result.outcome, Outcome::Unreachable) << text << "\n" << result.property.text;
    }
  }
  std::printf("%d questions, %d shown\n", asked, shown);
  EXPECT_GT(shown * 2, asked) << "too few runs are found";
}

}  // namespace
}  // namespace rungproof::test
