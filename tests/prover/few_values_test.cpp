// A ramp in tens: its limits hold because the word is a multiple of ten; from 999 a step would go beyond.
#include "tests/prover/proved_text.hpp"

namespace rungproof::test {
namespace {

TEST(FewValues, OfARampKeepItsLimits) {
  const ProgramInput input = inputOf(
      "//@ prove below: always VW0 <= 1000\n"
      "//@ prove not negative: always VW0 >= 0\n"
      "//@ prove never at the end: never VW0 = 1000\n",
      "NETWORK 1\nLD I0.0\nTON T37, 1\n"
      "NETWORK 2\nLD T37\nR T37, 1\nAW< VW0, 1000\n+I 10, VW0\n"
      "NETWORK 3\nLDN I0.0\nAW> VW0, 0\n+I -10, VW0\n");
  const ProofRun run = prove(input.program, input.properties, usualOptions());
  EXPECT_EQ(outcomeOf(run, "below"), Outcome::Proved);
  EXPECT_EQ(outcomeOf(run, "not negative"), Outcome::Proved);
  // 100 steps up, each after a tick of 100 ms.
  EXPECT_EQ(outcomeOf(run, "never at the end"), Outcome::Violated);
}

// Steps of seven do not meet 1000: 994 is followed by 1001.
TEST(FewValues, OfSevensGoBeyond) {
  const ProgramInput input = inputOf("//@ prove below: always VW0 <= 1000\n//@ prove at most: always VW0 <= 1001\n",
                                     "NETWORK 1\nLD I0.0\nEU\nAW< VW0, 1000\n+I 7, VW0\n"
                                     "NETWORK 2\nLD I0.1\nEU\nAW> VW0, 0\n+I -7, VW0\n");
  const ProofRun run = prove(input.program, input.properties, usualOptions());
  EXPECT_EQ(outcomeOf(run, "at most"), Outcome::Proved);
  EXPECT_EQ(outcomeOf(run, "below"), Outcome::Violated);
}

}  // namespace
}  // namespace rungproof::test
