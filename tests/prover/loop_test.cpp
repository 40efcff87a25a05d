// Loops of more rounds than are followed one by one: what they leave alone is proved, what leaves them is kept, and
// nothing is concluded about what only late rounds do.
#include <gtest/gtest.h>

#include "tests/prover/proved_text.hpp"

namespace rungproof {
namespace {

ProofRun proofOf(const std::string& properties, const std::string& networks, const std::string& otherBlocks = "") {
  const ProgramInput input = test::inputOf(properties, networks, otherBlocks);
  ProofRun run = prove(input.program, input.properties, test::usualOptions());
  EXPECT_TRUE(run.disagreements.empty());
  return run;
}

TEST(Loops, EndOfForFromAnInput) {
  // IW2 is any number: below 1 the body is skipped, above 256 the rounds are not followed one by one (001:5762).
  const ProofRun run = proofOf(
      "//@ prove few: VW2 = 7 implies VW10 = 7\n"
      "//@ prove none: VW2 < 1 implies VW10 = 0\n"
      "//@ prove beside: Q0.1 = I1.1\n"
      "//@ reach three: VW10 = 3\n"
      "//@ reach many: VW10 = 300\n"
      "//@ prove bounded: VW10 <= 256\n",
      "NETWORK 1\nLD I1.1\n= Q0.1\nNETWORK 2\nLD SM0.0\nMOVW IW2, VW2\nMOVW 0, VW10\n"
      "NETWORK 3\nLD SM0.0\nFOR VW0, +1, VW2\nNETWORK 4\nLD SM0.0\nINCW VW10\nNETWORK 5\nNEXT\n");
  EXPECT_EQ(test::outcomeOf(run, "few"), Outcome::Proved);
  EXPECT_EQ(test::outcomeOf(run, "none"), Outcome::Proved);
  EXPECT_EQ(test::outcomeOf(run, "beside"), Outcome::Proved);
  EXPECT_EQ(test::outcomeOf(run, "three"), Outcome::Reachable);
  EXPECT_NE(test::outcomeOf(run, "many"), Outcome::Unreachable);  // VW2 = 300
  EXPECT_NE(test::outcomeOf(run, "bounded"), Outcome::Proved);    // likewise
}

TEST(Loops, LimitFromAnInputThatIsClampedIsFollowedToItsEnd) {
  const ProofRun run =
      proofOf("//@ prove few: VW10 <= 20\n//@ prove each: VW10 = VW2 or VW2 < 1\n//@ reach all: VW10 = 20\n",
              "NETWORK 1\nLD SM0.0\nMOVW IW2, VW2\nMOVW 0, VW10\nNETWORK 2\nLDW> VW2, +20\nMOVW 20, VW2\n"
              "NETWORK 3\nLD SM0.0\nFOR VW0, +1, VW2\nNETWORK 4\nLD SM0.0\nINCW VW10\nNETWORK 5\nNEXT\n");
  for (const char* name : {"few", "each"}) EXPECT_EQ(test::outcomeOf(run, name), Outcome::Proved) << name;
  EXPECT_EQ(test::outcomeOf(run, "all"), Outcome::Reachable);
  EXPECT_TRUE(run.approximations.empty());
}

TEST(Loops, LimitThatWasClampedInAnEarlierScanIsFollowedToItsEnd) {
  // VW2 counts to 6 and is kept there; the loop stands in front of that, so it sees what the scan before has left.
  const ProofRun run = proofOf(
      "//@ prove few: VW10 <= 6\n//@ reach all: VW10 = 6\n",
      "NETWORK 1\nLD SM0.0\nMOVW 0, VW10\nNETWORK 2\nLD SM0.0\nFOR VW0, +1, VW2\nNETWORK 3\nLD SM0.0\nINCW VW10\n"
      "NETWORK 4\nNEXT\nNETWORK 5\nLD I0.0\nEU\nINCW VW2\nNETWORK 6\nLDW> VW2, +6\nMOVW 6, VW2\n");
  EXPECT_EQ(test::outcomeOf(run, "few"), Outcome::Proved);
  EXPECT_EQ(test::outcomeOf(run, "all"), Outcome::Reachable);
  EXPECT_TRUE(run.approximations.empty());
}

TEST(Loops, JumpBackOnAnInput) {
  // I0.0 is read once a scan: with it the loop never ends, without it there is one round (001:13920).
  const ProofRun run = proofOf(
      "//@ reach on: Q0.0\n//@ reach later: not first_scan\n//@ prove beside: Q0.1 = I1.1\n"
      "//@ prove follow: Q0.0 = I0.1\n",
      "NETWORK 1\nLD I1.1\n= Q0.1\nNETWORK 2\nLBL 1\nNETWORK 3\nLD I0.0\nJMP 1\n"
      "NETWORK 4\nLD I0.1\n= Q0.0\n");
  EXPECT_EQ(test::outcomeOf(run, "on"), Outcome::Reachable);
  EXPECT_EQ(test::outcomeOf(run, "later"), Outcome::Reachable);
  EXPECT_EQ(test::outcomeOf(run, "beside"), Outcome::Proved);
  EXPECT_EQ(test::outcomeOf(run, "follow"), Outcome::Proved);  // the watchdog ends the other scans before their end
}

TEST(Loops, JumpBackOnAnInputThatIsReadAtOnce) {
  const ProofRun run = proofOf("//@ reach on: Q0.0\n//@ prove beside: Q0.1 = I1.1\n//@ prove follow: Q0.0 = I0.1\n",
                               "NETWORK 1\nLD I1.1\n= Q0.1\nNETWORK 2\nLBL 1\nNETWORK 3\nLDI I0.0\nJMP 1\n"
                               "NETWORK 4\nLD I0.1\n= Q0.0\n");
  EXPECT_EQ(test::outcomeOf(run, "on"), Outcome::Reachable);
  EXPECT_EQ(test::outcomeOf(run, "beside"), Outcome::Proved);
  EXPECT_EQ(test::outcomeOf(run, "follow"), Outcome::Proved);
}

TEST(Loops, WhatFollowsALongLoopIsAsWithoutIt) {
  // Behind FOR with any end (001:5762), and behind a jump back inside an SCR segment, whose coil follows the segment.
  const ProofRun loop = proofOf("//@ prove follow: Q0.0 = I1.0\n//@ reach on: Q0.0\n",
                                "NETWORK 1\nLD SM0.0\nMOVW IW2, VW2\nFOR VW0, +1, VW2\nNETWORK 2\nLD SM0.0\nINCW VW4\n"
                                "NETWORK 3\nNEXT\nNETWORK 4\nLD I1.0\n= Q0.0\n");
  EXPECT_EQ(test::outcomeOf(loop, "follow"), Outcome::Proved);
  EXPECT_EQ(test::outcomeOf(loop, "on"), Outcome::Reachable);
  const ProofRun segment = proofOf("//@ prove follow: S0.0 implies Q0.0 = I0.1\n//@ reach on: Q0.0\n",
                                   "NETWORK 1\nLD I0.2\n= S0.0\nNETWORK 2\nLSCR S0.0\nNETWORK 3\nLBL 1\n"
                                   "NETWORK 4\nLDI I0.0\nJMP 1\nNETWORK 5\nLD I0.1\n= Q0.0\nNETWORK 6\nSCRE\n");
  EXPECT_EQ(test::outcomeOf(segment, "follow"), Outcome::Proved);
  EXPECT_EQ(test::outcomeOf(segment, "on"), Outcome::Reachable);
}

TEST(Loops, SegmentThatALoopGoesThroughIsAnyOneBehindIt) {
  // The jump back leads in front of LSCR, and V0.0 is what decides: the coil behind the loop follows the last round.
  const ProofRun run = proofOf("//@ prove off: never Q0.0\n//@ prove beside: Q0.1 = I1.1\n",
                               "NETWORK 1\nLD I1.1\n= Q0.1\nNETWORK 2\nLD SM0.0\nMOVW 0, VW0\nNETWORK 3\nLBL 1\n"
                               "NETWORK 4\nLD SM0.0\nINCW VW0\nLDW= VW0, +300\n= S0.0\nNETWORK 5\nLSCR S0.0\n"
                               "NETWORK 6\nLD SM0.0\n= M0.0\nNETWORK 7\nSCRE\nNETWORK 8\nLDW< VW0, +300\nJMP 1\n"
                               "NETWORK 9\nLD M0.0\n= Q0.0\n");
  EXPECT_NE(test::outcomeOf(run, "off"), Outcome::Proved);  // in round 300 the segment is active
  EXPECT_EQ(test::outcomeOf(run, "beside"), Outcome::Proved);
}

TEST(Loops, EndlessOnesAreShownByTheWatchdog) {
  const ProgramInput input = test::inputOf("", "NETWORK 1\nLBL 1\nNETWORK 2\nLD I0.0\nJMP 1\n");
  ProverOptions options = test::usualOptions();
  options.checks.builtin = true;
  const ProofRun run = prove(input.program, input.properties, options);
  EXPECT_TRUE(run.disagreements.empty());
  EXPECT_EQ(test::outcomeOf(run, "JMP 1: never 'scan watchdog expired'"), Outcome::Violated);
}

TEST(Loops, WayOutOfALateRoundIsKept) {
  // The loop is left when VW0 has come to 300, which is more than the rounds that are followed.
  const ProofRun run = proofOf("//@ reach out: Q0.0\n//@ prove beside: Q0.1 = I1.1\n",
                               "NETWORK 1\nLD I1.1\n= Q0.1\nNETWORK 2\nLD SM0.0\nMOVW 0, VW0\nNETWORK 3\nLBL 1\n"
                               "NETWORK 4\nLD SM0.0\nINCW VW0\nNETWORK 5\nLDW= VW0, +300\nJMP 2\n"
                               "NETWORK 6\nLD SM0.0\nJMP 1\nNETWORK 7\nLBL 2\nNETWORK 8\nLDW= VW0, +300\n= Q0.0\n");
  EXPECT_NE(test::outcomeOf(run, "out"), Outcome::Unreachable);
  EXPECT_EQ(test::outcomeOf(run, "beside"), Outcome::Proved);
}

TEST(Loops, WhatOnlyALateRoundDoesIsNotOverlooked) {
  // M0.0 is set in round 280 only: no earlier one shows the write.
  const ProofRun run = proofOf("//@ prove off: not M0.0\n//@ prove beside: Q0.1 = I1.1\n",
                               "NETWORK 1\nLD I1.1\n= Q0.1\nNETWORK 2\nLD SM0.0\nFOR VW0, +1, +300\n"
                               "NETWORK 3\nLDW= VW0, +280\nS M0.0, 1\nNETWORK 4\nNEXT\n");
  EXPECT_NE(test::outcomeOf(run, "off"), Outcome::Proved);
  EXPECT_EQ(test::outcomeOf(run, "beside"), Outcome::Proved);
}

TEST(Loops, InsideEachOther) {
  // 2 times 300 rounds: VW10 is 600 at the end of every scan.
  const ProofRun run = proofOf("//@ prove never: VW10 <> 600\n//@ prove beside: Q0.1 = I1.1\n",
                               "NETWORK 1\nLD I1.1\n= Q0.1\nNETWORK 2\nLD SM0.0\nMOVW 0, VW10\n"
                               "NETWORK 3\nLD SM0.0\nFOR VW0, +1, +2\nNETWORK 4\nLD SM0.0\nFOR VW4, +1, +300\n"
                               "NETWORK 5\nLD SM0.0\nINCW VW10\nNETWORK 6\nNEXT\nNETWORK 7\nNEXT\n");
  EXPECT_NE(test::outcomeOf(run, "never"), Outcome::Proved);
  EXPECT_EQ(test::outcomeOf(run, "beside"), Outcome::Proved);
}

}  // namespace
}  // namespace rungproof
