// REAL arithmetic, comparisons and conversions are exact where any value is not enough. Sine, logarithm and the like
// are taken as any value: what depends on them says so, is never called violated by a run that the engine does not
// repeat, and what does not depend on them is decided as ever.
#include "proved_text.hpp"

namespace rungproof::test {
namespace {

/// VD4 is the sine of an input; M0.0 is set while it is above 2, which no sine is, and I0.0 is on.
const char* const sineProgram =
    "Network 1\nLD I0.1\n= Q0.1\n"  // first: a comparison of what is no number ends the program (001:13935)
    "Network 2\nLD SM0.0\nDTR ID4, VD0\nSIN VD0, VD4\n"
    "Network 3\nLDR> VD4, 2.0\n= Q0.0\n"
    "Network 4\nLDR> VD4, 2.0\nA I0.0\nS M0.0, 1\n"
    "Network 5\nLDR> VD4, 0.5\n= Q0.2\n";

ProofRun provedSine(const std::string& statement, double timeout = 3) {
  const ProgramInput input = inputOf("//@ " + statement + "\n", sineProgram);
  return prove(input.program, input.properties, usualOptions(timeout));
}

TEST(Real, FunctionsAreListedAsApproximated) {
  const ProofRun run = provedSine("prove lamp: Q0.1 implies I0.1");
  const auto names = [&](const std::string& mnemonic) {
    return std::any_of(run.approximations.begin(), run.approximations.end(),
                       [&](const std::string& text) { return text.find(mnemonic + " at test.awl:") == 0; });
  };
  EXPECT_TRUE(names("SIN"));
  EXPECT_FALSE(names("LDR>"));
  EXPECT_FALSE(names("LD"));
}

TEST(Real, WhatDoesNotDependOnThemIsProvedWithoutAWord) {
  // Without a comparison that could end the program.
  const ProgramInput input = inputOf("//@ prove lamp: Q0.1 implies I0.1\n",
                                     "Network 1\nLD I0.1\n= Q0.1\nNetwork 2\nLD SM0.0\nDTR ID4, VD0\nSIN VD0, VD4\n");
  const ProofRun run = prove(input.program, input.properties, usualOptions(3));
  ASSERT_EQ(outcomeOf(run, "lamp"), Outcome::Proved);
  EXPECT_FALSE(hasNote(*resultNamed(run, "lamp"), "depends on"));
}

TEST(Real, AProofThatAllowsAnyValueSaysSo) {
  const ProofRun run = provedSine("prove start: M0.0 implies once(I0.0)");
  ASSERT_EQ(outcomeOf(run, "start"), Outcome::Proved);
  EXPECT_TRUE(hasNote(*resultNamed(run, "start"), "depends on SIN at test.awl:"));
}

TEST(Real, ARunThatTheEngineDoesNotRepeatIsNoViolation) {
  // True, but only for who knows the sine.
  const ProofRun run = provedSine("prove below two: not Q0.0");
  EXPECT_EQ(outcomeOf(run, "below two"), Outcome::NotCovered);
  EXPECT_TRUE(hasNote(*resultNamed(run, "below two"), "depends on SIN at test.awl:"));
  EXPECT_TRUE(run.disagreements.empty());
}

TEST(Real, WhatIsFalseIsNeverProved) {
  // The sine of 1.0 is 0.84.
  const ProofRun run = provedSine("prove below a half: not Q0.2");
  const ProofResult& result = *resultNamed(run, "below a half");
  EXPECT_TRUE(result.outcome == Outcome::NotCovered || (result.outcome == Outcome::Violated && result.witness))
      << static_cast<int>(result.outcome);
  EXPECT_TRUE(hasNote(result, "depends on SIN at test.awl:"));
  EXPECT_TRUE(run.disagreements.empty());
}

TEST(Real, WhatThePropertyComparesCounts) {
  const ProofRun run = provedSine("prove bounded: VD4 < 3.0");
  const ProofResult& result = *resultNamed(run, "bounded");
  EXPECT_NE(result.outcome, Outcome::Violated);
  EXPECT_TRUE(hasNote(result, "depends on SIN at test.awl:"));
}

/// AIW0, 6400 to 32000 from the sensor, as degrees 0.0 to 100.0 in VD10; the heater is on below 50 and off from 75.
const char* const scaledProgram =
    "Network 1\nLD SM0.0\nITD AIW0, AC0\nDTR AC0, AC0\n-R 6400.0, AC0\n/R 25600.0, AC0\n*R 100.0, AC0\nMOVR AC0, VD10\n"
    "Network 2\nLDR< VD10, 50.0\nS Q0.0, 1\n"
    "Network 3\nLDR>= VD10, 75.0\nR Q0.0, 1\n";

Outcome outcomeScaled(const std::string& statement) {
  const ProgramInput input =
      inputOf("//@ assume sensor: AIW0 >= 6400 and AIW0 <= 32000\n//@ " + statement + "\n", scaledProgram);
  const ProofRun run = prove(input.program, input.properties, usualOptions(20));
  EXPECT_TRUE(run.approximations.empty());
  EXPECT_TRUE(run.disagreements.empty());
  return run.results.at(0).outcome;
}

TEST(Real, ScalingIsExact) {
  // 75.0 is reached at 6400 + 0.75 * 25600 = 25600, 50.0 at 19200; the ends of the range are exact in single precision.
  EXPECT_EQ(outcomeScaled("prove off when hot: AIW0 >= 25600 implies not Q0.0"), Outcome::Proved);
  EXPECT_EQ(outcomeScaled("prove on when cold: AIW0 < 19200 implies Q0.0"), Outcome::Proved);
  EXPECT_EQ(outcomeScaled("prove in range: VD10 >= 0.0 and VD10 <= 100.0"), Outcome::Proved);
  EXPECT_EQ(outcomeScaled("prove off one degree earlier: AIW0 >= 25599 implies not Q0.0"), Outcome::Violated);
  EXPECT_EQ(outcomeScaled("prove not the end of the range: VD10 < 100.0"), Outcome::Violated);
  EXPECT_EQ(outcomeScaled("reach beyond the range: VD10 > 100.0"), Outcome::Unreachable);
}

TEST(Real, ConversionsAreExact) {
  // 2.5 is rounded to 3 (halves away from zero) and cut to 2; the root of 2 lies between 1.41 and 1.42.
  const ProgramInput input =
      inputOf("//@ prove rounded: VD0 = 3\n//@ prove cut: VD4 = 2\n//@ prove root: VD8 > 1.41 and VD8 < 1.42\n",
              "LD SM0.0\nMOVR 2.5, AC0\nROUND AC0, VD0\nTRUNC AC0, VD4\nSQRT 2.0, VD8\n");
  const ProofRun run = prove(input.program, input.properties, usualOptions(5));
  for (const ProofResult& result : run.results) EXPECT_EQ(result.outcome, Outcome::Proved) << result.property.name;
}

TEST(Real, LoopControlIsFoundViolatedByItsRealOutput) {
  // Proportional gain 0.25 and a set point of 0.75 give 0.1875 at an empty tank as soon as the loop runs.
  const ProgramInput input = inputOf(
      "//@ prove pump rests: VD108 < 0.18\n//@ prove output is limited: VD108 <= 1.0\n",
      "Network 1\nLD SM0.1\nMOVR 0.75, VD104\nMOVR 0.25, VD112\nMOVR 0.1, VD116\nMOVR 30.0, VD120\nMOVR 0.0, VD124\n"
      "Network 2\nLD I0.2\nPID VB100, 0\n");
  const ProofRun run = prove(input.program, input.properties, usualOptions(20));
  EXPECT_EQ(outcomeOf(run, "pump rests"), Outcome::Violated);
  EXPECT_EQ(outcomeOf(run, "output is limited"), Outcome::Proved);
}

}  // namespace
}  // namespace rungproof::test
