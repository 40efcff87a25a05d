// Bits that are on for one scan at a time: what the text shows of them, and what is no such bit. The table instructions
// must run once for each entry (001:6511), so that HSP004 shows which conditions are known to last one scan.
#include <gtest/gtest.h>

#include "tests/rules/lint.hpp"

namespace rungproof::testing {
namespace {

/// Whether ATT behind the condition `last` of these networks is taken for something that runs in many scans.
bool runsOften(const std::string& networks, const std::string& last = "LD M0.1\n") {
  const Linted linted("Network 1\nLD SM0.1\nMOVW +10, VW200\n" + networks + "Network 9\n" + last +
                      "ATT VW0, VW200\nNetwork 10\nLBL 1\n");
  return !linted.of("HSP004").empty();
}

TEST(Pulse, CoilBehindAnEdge) {
  EXPECT_FALSE(runsOften("Network 2\nLD I0.0\nEU\n= M0.1\n"));
  EXPECT_FALSE(runsOften("Network 2\nLD I0.0\nEU\n= M0.1\nNetwork 3\nLD M0.1\nA I0.1\n= M0.2\n", "LD M0.2\n"));
  EXPECT_TRUE(runsOften("Network 2\nLD I0.0\n= M0.1\n"));
  // A second coil may hold the bit.
  EXPECT_TRUE(runsOften("Network 2\nLD I0.0\nEU\n= M0.1\nNetwork 3\nLD I0.1\n= M0.1\n"));
}

TEST(Pulse, TwoEdgesJoined) {
  EXPECT_FALSE(runsOften("Network 2\nLD I0.0\nEU\nO M0.5\n= M0.1\nNetwork 3\nLD I0.5\nEU\n= M0.5\n"));
  EXPECT_TRUE(runsOften("Network 2\nLD I0.0\nEU\nO M0.5\n= M0.1\nNetwork 3\nLD I0.5\n= M0.5\n"));
}

TEST(Pulse, EdgeMadeByHand) {
  // M0.0 remembers I0.0 of the scan before; M0.1 is on in the scan in which I0.0 comes, then M0.0 blocks it.
  EXPECT_FALSE(runsOften("Network 2\nLD I0.0\nAN M0.0\n= M0.1\nNetwork 3\nLD I0.0\n= M0.0\n"));
  EXPECT_FALSE(runsOften("Network 2\nLD I0.0\nLPS\nAN M0.0\n= M0.1\nLPP\n= M0.0\n"));
  EXPECT_FALSE(runsOften("Network 2\nLDN I0.0\nA I0.3\nAN M0.0\n= M0.1\nNetwork 3\nLDN I0.0\n= M0.0\n"));
  // The memory comes first: then M0.1 is never on, which is no edge. It follows another input; it is only latched.
  EXPECT_TRUE(runsOften("Network 2\nLD I0.0\n= M0.0\nNetwork 3\nLD I0.0\nAN M0.0\n= M0.1\n"));
  EXPECT_TRUE(runsOften("Network 2\nLD I0.0\nAN M0.0\n= M0.1\nNetwork 3\nLD I0.1\n= M0.0\n"));
  EXPECT_TRUE(runsOften("Network 2\nLD I0.0\nAN M0.0\n= M0.1\nNetwork 3\nLD I0.0\nA I0.1\n= M0.0\n"));
  EXPECT_TRUE(runsOften("Network 2\nLD I0.0\nAN M0.0\n= M0.1\nNetwork 3\nLD I0.0\nAW> VW8, 3\n= M0.0\n"));
  EXPECT_TRUE(runsOften("Network 2\nLD I0.0\nA M0.0\n= M0.1\nNetwork 3\nLD I0.0\n= M0.0\n"));
  // The signal may change between the two: M0.0 then misses it.
  EXPECT_TRUE(
      runsOften("Network 2\nLD M2.0\nAN M0.0\n= M0.1\nNetwork 3\nLD I0.4\n= M2.0\nNetwork 4\nLD M2.0\n= M0.0\n"));
}

TEST(Pulse, LatchThatIsTakenBackInTheSameScan) {
  EXPECT_FALSE(runsOften("Network 2\nLD I0.0\nEU\nS M0.1, 1\nNetwork 12\nLD M0.1\nR M0.1, 1\n"));
  EXPECT_FALSE(runsOften("Network 2\nLD SM0.0\nR M0.1, 1\nNetwork 3\nLD I0.0\nEU\nS M0.1, 1\n"));
  EXPECT_TRUE(runsOften("Network 2\nLD I0.0\nEU\nS M0.1, 1\nNetwork 3\nLD I0.1\nR M0.1, 1\n"));
  EXPECT_TRUE(runsOften("Network 2\nLD I0.0\nS M0.1, 1\nNetwork 3\nLD M0.1\nR M0.1, 1\n"));
  EXPECT_TRUE(runsOften("Network 2\nLD I0.0\nEU\nS M0.1, 1\nNetwork 3\nLD M0.1\nA I0.3\nR M0.1, 1\n"));
}

TEST(Pulse, TimersAndCountersThatResetThemselves) {
  EXPECT_FALSE(runsOften("Network 2\nLDN T37\nTON T37, 50\n", "LD T37\n"));
  EXPECT_FALSE(runsOften("Network 2\nLD I0.0\nAN T37\nTON T37, 50\n", "LD T37\n"));
  EXPECT_FALSE(runsOften("Network 2\nLD I0.0\nLD C1\nCTU C1, 10\n", "LD C1\n"));
  EXPECT_FALSE(runsOften("Network 2\nLD I0.0\nLD I0.5\nO C1\nCTU C1, 10\n", "LD C1\n"));
  EXPECT_TRUE(runsOften("Network 2\nLD I0.0\nTON T37, 50\n", "LD T37\n"));
  EXPECT_TRUE(runsOften("Network 2\nLD I0.0\nLD I0.5\nA C1\nCTU C1, 10\n", "LD C1\n"));
  EXPECT_TRUE(runsOften("Network 2\nLD C1\nLD I0.0\nCTU C1, 10\n", "LD C1\n"));  // the count input
}

TEST(Pulse, CodeThatAJumpLeavesOutButForOneScan) {
  EXPECT_FALSE(runsOften("Network 2\nLD I0.0\nEU\nNOT\nJMP 1\n", "LD SM0.0\n"));
  EXPECT_FALSE(runsOften("Network 2\nLDN SM0.1\nJMP 1\n", "LD SM0.0\n"));
  EXPECT_FALSE(runsOften("Network 2\nLD I0.0\nEU\n= M0.1\nNetwork 3\nLDN M0.1\nO I0.3\nJMP 1\n", "LD SM0.0\n"));
  EXPECT_TRUE(runsOften("Network 2\nLD I0.0\nEU\nJMP 1\n", "LD SM0.0\n"));
  EXPECT_TRUE(runsOften("Network 2\nLD I0.0\nEU\nNOT\nA I0.3\nJMP 1\n", "LD SM0.0\n"));
  // Another jump leads into the middle.
  EXPECT_TRUE(runsOften("Network 2\nLD I0.4\nJMP 2\nNetwork 3\nLDN SM0.1\nJMP 1\nNetwork 4\nLBL 2\n", "LD SM0.0\n"));
}

TEST(Pulse, InitialisationBehindAJumpIsInitialisation) {
  // As behind SM0.1 itself: the reset is no second hand on the coil's bits, and no second master of the word.
  const std::string jump = "Network 1\nLDN SM0.1\nJMP 1\nNetwork 2\nLD SM0.0\nR Q0.0, 8\nNetwork 3\nLBL 1\n";
  EXPECT_EQ(Linted(jump + "Network 4\nLD I0.0\n= Q0.3\n").lines("OUT005"), Lines());
  EXPECT_EQ(Linted(jump + "Network 4\nLD I0.0\n= Q0.0\n").lines("OUT002"), Lines());
}

TEST(Pulse, AReturnThatNeverComesLeavesNothingOut) {
  const auto block = [](const std::string& condition) {
    return Linted(
               "ORGANIZATION_BLOCK MAIN:OB1\nBEGIN\nNetwork 1\nLD SM0.0\nCALL SBR0\nNetwork 2\nLD T37\n= "
               "Q0.0\nEND_ORGANIZATION_BLOCK\nSUBROUTINE_BLOCK SBR_0:SBR0\nBEGIN\nNetwork 1\n" +
               condition + "CRET\nNetwork 2\nLD I0.1\nTON T37, +10\nEND_SUBROUTINE_BLOCK\n")
        .of("TIM004")
        .size();
  };
  EXPECT_EQ(block("LDN SM0.0\n"), 0U);
  EXPECT_EQ(block("LD I0.0\nAN SM0.0\n"), 0U);
  EXPECT_EQ(block("LD I0.0\n"), 1U);
}

}  // namespace
}  // namespace rungproof::testing
