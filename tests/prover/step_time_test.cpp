// Steps that end themselves by their own timer, alone and in a chain: how long they have lasted is proved from the
// timers' presets, whatever these are.
#include <gtest/gtest.h>

#include "tests/prover/proved_text.hpp"

namespace rungproof {
namespace {

/// M0.0 is set by I0.0, starts T37 (100 ms) and is reset by it.
std::string ownStep(int preset) {
  return "NETWORK 1\nLD I0.0\nS M0.0, 1\nNETWORK 2\nLD M0.0\nTON T37, " + std::to_string(preset) +
         "\nNETWORK 3\nLD T37\nR M0.0, 1\n= M0.1\n";
}

TEST(StepTime, StepThatItsOwnTimerResets) {
  // The bit rises when 150 ticks of 100 ms have passed (001:6590). Of these at most one interval was cut short, and
  // the scans in which the step began and ended take at most 500 ms each: 12 s and more lie between scan ends.
  for (const int preset : {150, 300}) {
    const ProgramInput input = test::inputOf("//@ prove long: rises(M0.1) implies prev(held(M0.0, " +
                                                 std::to_string(preset * 8 / 100) + "s))\n//@ reach end: M0.1\n",
                                             ownStep(preset));
    const ProofRun run = prove(input.program, input.properties, test::usualOptions(60));
    EXPECT_TRUE(run.disagreements.empty());
    EXPECT_EQ(test::outcomeOf(run, "long"), Outcome::Proved) << preset;
    EXPECT_EQ(test::outcomeOf(run, "end"), Outcome::Reachable) << preset;
  }
}

TEST(StepTime, LongerThanThePresetIsViolated) {
  // 15 s of ticks are never 16 s between scan ends if scans are short: the run of 10 ms scans shows it.
  const ProgramInput input = test::inputOf("//@ prove long: rises(M0.1) implies prev(held(M0.0, 16s))\n", ownStep(150));
  const ProofRun run = prove(input.program, input.properties, test::usualOptions(60));
  EXPECT_TRUE(run.disagreements.empty());
  EXPECT_EQ(test::outcomeOf(run, "long"), Outcome::Violated);
}

}  // namespace
}  // namespace rungproof
