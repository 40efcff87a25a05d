// REAL operations are taken as any value by the bit-level engines: what depends on them says so, is never called violated
// by a run that the engine does not repeat, and what does not depend on them is decided as ever.
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
    return std::any_of(run.approximations.begin(), run.approximations.end(), [&](const std::string& text) { return text.find(mnemonic + " at test.awl:") == 0; });
  };
  EXPECT_TRUE(names("SIN"));
  EXPECT_TRUE(names("LDR>"));
  EXPECT_FALSE(names("LD"));
}

TEST(Real, WhatDoesNotDependOnThemIsProvedWithoutAWord) {
  // Without a comparison that could end the program.
  const ProgramInput input = inputOf("//@ prove lamp: Q0.1 implies I0.1\n", "Network 1\nLD I0.1\n= Q0.1\nNetwork 2\nLD SM0.0\nDTR ID4, VD0\nSIN VD0, VD4\n");
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
  EXPECT_TRUE(result.outcome == Outcome::NotCovered || (result.outcome == Outcome::Violated && result.witness)) << static_cast<int>(result.outcome);
  EXPECT_TRUE(hasNote(result, "depends on SIN at test.awl:"));
  EXPECT_TRUE(run.disagreements.empty());
}

TEST(Real, ComparisonsOfThePropertyItselfCount) {
  const ProofRun run = provedSine("prove bounded: VD4 < 3.0");
  const ProofResult& result = *resultNamed(run, "bounded");
  EXPECT_NE(result.outcome, Outcome::Violated);
  EXPECT_TRUE(hasNote(result, "depends on a REAL operation in a property"));
}

}  // namespace
}  // namespace rungproof::test
