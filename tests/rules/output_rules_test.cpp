// Rules OUT and LOG on cases that their examples do not show. Lines are those of the text, from 1.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/rules/lint.hpp"

namespace rungproof::testing {
namespace {

TEST(OutputRules, DoubleCoilIsCertainOnlyWhereBothRun) {
  const Linted certain("Network 1\nLD I0.0\n= Q0.0\nNetwork 2\nLD I0.1\n= Q0.0\n");
  ASSERT_EQ(certain.of("OUT001").size(), 1U);
  EXPECT_EQ(certain.of("OUT001")[0].confirmation, Confirmation::NotNeeded);
  const Linted maybe(
      "Network 1\nLD I0.0\nJMP 1\nNetwork 2\nLD I0.1\n= Q0.0\nNetwork 3\nLBL 1\nNetwork 4\nLD I0.2\n= Q0.0\n");
  ASSERT_EQ(maybe.of("OUT001").size(), 1U);
  EXPECT_EQ(maybe.of("OUT001")[0].confirmation, Confirmation::Unconfirmed);
}

TEST(OutputRules, FirstScanResetIsNoConflict) {
  EXPECT_EQ(lines("OUT002", "Network 1\nLD SM0.1\nR Q0.0, 1\nNetwork 2\nLD I0.0\n= Q0.0\n"), Lines());
  EXPECT_EQ(lines("OUT005", "Network 1\nLD SM0.1\nR Q0.0, 8\nNetwork 2\nLD I0.0\n= Q0.3\n"), Lines());
}

TEST(OutputRules, LatchesMayBeClearedByBytes) {
  EXPECT_EQ(lines("OUT004", "Network 1\nLD I0.0\nS M0.0, 1\nNetwork 2\nLD I0.1\nMOVB 0, MB0\n"), Lines());
  // PLS drives Q0.0, whose image bit is only cleared; nobody drives Q0.1.
  EXPECT_EQ(lines("OUT004", "Network 1\nLD SM0.1\nR Q0.0, 1\nMOVB 16#85, SMB67\nPLS 0\n"), Lines());
  EXPECT_EQ(lines("OUT004", "Network 1\nLD SM0.1\nR Q0.1, 1\nMOVB 16#85, SMB67\nPLS 0\n"), Lines{3});
  EXPECT_EQ(lines("OUT004", "Network 1\nLD I0.0\nS Q0.0, 2\nNetwork 2\nLD I0.1\nR Q0.0, 1\n"),
            Lines{3});  // Q0.1 stays on
}

TEST(OutputRules, HandshakeWithAnInterruptIsNoConflict) {
  const char* text = "LD SM0.1\nATCH 0, 0\nENI\nLD M0.0\nR M0.0, 1\nINCB QB0\nMEND\nINT 0\nS M0.0, 1\nRETI\n";
  EXPECT_EQ(lines("OUT006", text), Lines());
}

/// "address: message" of the findings of one rule.
std::vector<std::string> named(const char* rule, const std::string& text) {
  std::vector<std::string> result;
  for (const Finding& finding : Linted(text).of(rule)) result.push_back(finding.address + ": " + finding.message);
  return result;
}
using Named = std::vector<std::string>;

std::string blocks(const std::string& main, const std::vector<std::string>& subroutines) {
  std::string text = "ORGANIZATION_BLOCK MAIN:OB1\nBEGIN\n" + main + "END_ORGANIZATION_BLOCK\n";
  for (std::size_t i = 0; i < subroutines.size(); ++i) {
    const std::string number = std::to_string(i);
    text +=
        "SUBROUTINE_BLOCK SBR_" + number + ":SBR" + number + "\nBEGIN\n" + subroutines[i] + "END_SUBROUTINE_BLOCK\n";
  }
  return text;
}
const char* const callBoth = "Network 1\nLD I0.0\nCALL SBR0\nNetwork 2\nLD I0.1\nCALL SBR1\n";

TEST(BlocksOfBits, AResetBehindAllCoilsSwitchesOffInGeneral) {
  const std::string coils = "Network 1\nLD I0.0\n= Q0.1\nNetwork 2\nLD I0.1\n= Q0.5\n",
                    off = "Network 3\nLDN I1.0\nR Q0.0, 8\n", behind = "Network 4\nLD I0.2\n= Q0.6\n";
  EXPECT_EQ(named("OUT005", coils + off), Named());
  EXPECT_EQ(named("OUT005", coils + off + behind), (Named{"Q0.6: R Q0.0, 8 covers Q0.6, which = Q0.6 drives"}));
  EXPECT_EQ(named("OUT005", off + coils).size(), 1U);
  // The first bit belongs to OUT002, which knows the switch-off too; a single R says nothing about the others.
  EXPECT_EQ(named("OUT002", "Network 1\nLD I0.0\n= Q0.0\n" + off), Named());
  EXPECT_EQ(named("OUT002", off + "Network 4\nLD I0.0\n= Q0.0\n").size(), 1U);
  EXPECT_EQ(named("OUT002", "Network 1\nLD I0.0\n= Q0.0\nNetwork 2\nLDN I1.0\nR Q0.0, 1\n").size(), 1U);
}

TEST(BlocksOfBits, TheOrderOfCallsDecidesWhatIsBehind) {
  const std::string coil = "Network 1\nLD I0.2\n= Q0.3\n", off = "Network 1\nLDN I1.0\nR Q0.0, 8\n";
  EXPECT_EQ(named("OUT005", blocks(callBoth, {coil, off})), Named());
  EXPECT_EQ(named("OUT005", blocks(callBoth, {off, coil})).size(), 1U);
  const std::string lastInMain = std::string(callBoth) + "Network 3\nLDN I1.0\nR Q0.0, 8\n";
  EXPECT_EQ(named("OUT005", blocks(lastInMain, {coil, "Network 1\nLD I0.3\n= Q0.4\n"})), Named());
  // The second block calls the first again, behind the reset.
  EXPECT_EQ(named("OUT005", blocks(lastInMain + "Network 4\nLD I0.5\nCALL SBR0\n", {coil,
                                                                                    "Network 1\nLD I0.3\n"
                                                                                    "= Q0.4\n"})),
            (Named{"Q0.3: R Q0.0, 8 covers Q0.3, which = Q0.3 drives"}));
  // An interrupt comes at any point.
  const std::string interrupt = "LD SM0.1\nATCH 0, 0\nENI\nLDN I1.0\nR Q0.0, 8\nMEND\nINT 0\nLD I0.2\n= Q0.3\nRETI\n";
  EXPECT_EQ(named("OUT005", interrupt).size(), 1U);
}

TEST(BlocksOfBits, OneFindingNamesTheWholeRange) {
  EXPECT_EQ(named("OUT005",
                  "Network 1\nLD I0.0\nS Q0.0, 8\nNetwork 2\nLD I0.1\n= Q0.2\nNetwork 3\nLD I0.2\n= Q0.3\nNetwork "
                  "4\nLD I0.3\n= Q0.6\n"),
            (Named{"Q0.2: S Q0.0, 8 covers Q0.2 to Q0.3 and Q0.6, which = Q0.2 and 2 others drive"}));
  // The count reaches into the next byte.
  EXPECT_EQ(named("OUT005", "Network 1\nLD I0.0\nS Q0.6, 4\nNetwork 2\nLD I0.1\n= Q0.7\n= Q1.0\n"),
            (Named{"Q0.7: S Q0.6, 4 covers Q0.7 to Q1.0, which = Q0.7 and 1 other drive"}));
  EXPECT_EQ(named("OUT004", "Network 1\nLD I0.0\nS M0.0, 5\nNetwork 2\nLD I0.1\nR M0.0, 1\n"),
            (Named{"M0.1: M0.1 to M0.4 are set but never reset; once on they stay on"}));
  EXPECT_EQ(named("ADR011", "Network 1\nLD I0.0\nS M0.0, 4\nNetwork 2\nLD I0.1\nR M0.0, 4\n"),
            (Named{"M0.0: S M0.0, 4 writes M0.0 to M0.3, which nothing reads"}));
  EXPECT_EQ(named("ADR010", "Network 1\nLD I0.0\nBMB VB0, QB0, 4\n"),
            (Named{"VB0: BMB VB0, QB0, 4 reads VB0 to VB3, which nothing in the program writes"}));
  EXPECT_EQ(
      named("ADR005", "Network 1\nLD M0.0\nS I0.6, 4\n"),
      (Named{"I0.6: S I0.6, 4 writes the inputs I0.6 to I1.1; the next scan reads them from the terminals again"}));
}

TEST(SeveralBlocks, EveryPairOfWritersIsCompared) {
  const std::string coil = "Network 1\nLD I0.2\n= Q0.2\n";
  EXPECT_EQ(named("OUT006", blocks(std::string(callBoth) + "Network 3\nLD I0.3\n= Q0.6\n", {coil, coil})),
            (Named{"Q0.2: Q0.2 is written in SBR_0 and in SBR_1"}));
  EXPECT_EQ(named("OUT006", blocks(std::string(callBoth) + "Network 3\nLD I0.3\n= Q0.2\n", {coil, coil})),
            (Named{"Q0.2: Q0.2 is written in MAIN, in SBR_0 and in SBR_1"}));
  // A handshake with the interrupt routine does not hide the block that writes the whole byte.
  const std::string flag =
      "LD SM0.1\nATCH 0, 0\nENI\nLD M0.0\nR M0.0, 1\nLD I0.0\nMOVB 0, MB0\nMEND\nINT 0\nS M0.0, 1\nRETI\n";
  EXPECT_EQ(named("OUT006", flag),
            (Named{"M0.0: M0.0 is written in MAIN and in INT_0; the interrupt can come at any point "
                   "of the scan"}));
  const std::string word = "Network 1\nLD I0.2\nINCW VW10\n";
  EXPECT_EQ(named("OUT006", blocks(callBoth, {"Network 1\nLD I0.2\nMOVB 0, VB12\n" + word.substr(10), word})).size(),
            1U);
}

TEST(SeveralBlocks, OneFindingNamesTheWholeRange) {
  const std::string sets =
      "Network 1\nLD I0.2\nS M0.0, 1\nNetwork 2\nLD I0.3\nS M0.1, 1\nNetwork 3\nLD I0.4\nS M0.2, 1\nNetwork 4\nLD "
      "I0.5\nS M0.3, 1\n";
  EXPECT_EQ(named("OUT006", blocks(callBoth, {sets, "Network 1\nLD I0.6\nR M0.0, 5\n"})),
            (Named{"M0.0: M0.0 to M0.3 are written in SBR_0 and in SBR_1"}));
  EXPECT_EQ(named("OUT006", blocks(callBoth, {"Network 1\nLD I0.6\nFILL 0, VW10, 4\n",
                                              "Network 1\nLD I0.6\nMOVW 1, VW12\nMOVW 1, VW14\n"})),
            (Named{"VB12: VB12 to VB15 are written in SBR_0 and in SBR_1"}));
  EXPECT_EQ(named("OUT006",
                  blocks(callBoth, {"Network 1\nLD I0.6\nMOVB 1, VB10\n", "Network 1\nLD I0.6\n= V10.3\n= V11.3\n"})),
            (Named{"V10.3: V10.3 is written in SBR_0 and in SBR_1"}));
  // Two ranges without a common writer are two findings.
  EXPECT_EQ(named("OUT006", blocks(callBoth, {"Network 1\nLD I0.6\nMOVW 1, VW10\nS Q0.2, 6\n",
                                              "Network 1\nLD I0.7\nMOVW 1, VW10\nR Q0.0, 8\n"})),
            (Named{"VW10: VW10 is written in SBR_0 and in SBR_1",
                   "Q0.2: Q0.2 to Q0.7 are written in SBR_0 and in "
                   "SBR_1"}));
}

// What the same blocks write against each other is one finding, outputs apart from memory; of a range each part names
// its own writers.
TEST(SeveralBlocks, OneFindingForEachSetOfBlocks) {
  const std::string first = "Network 1\nLD I0.2\nS Q0.2, 6\nMOVW 1, VW10\nMOVW 1, VW20\n";
  const std::string second = "Network 1\nLD I0.3\nR Q0.2, 6\nMOVW 2, VW10\nMOVW 2, VW20\n";
  EXPECT_EQ(named("OUT006", blocks(callBoth, {first, second})),
            (Named{"Q0.2: Q0.2 to Q0.7 are written in SBR_0 and in SBR_1",
                   "VW10: VW10 and VW20 are written in SBR_0 and in SBR_1"}));
  EXPECT_EQ(named("OUT006", blocks(std::string(callBoth) + "Network 3\nLD I0.4\n= Q0.6\n", {first, second})),
            (Named{"Q0.6: Q0.6 is written in MAIN, in SBR_0 and in SBR_1",
                   "Q0.2: Q0.2 to Q0.5 and Q0.7 are written in SBR_0 and in SBR_1",
                   "VW10: VW10 and VW20 are written in SBR_0 and in SBR_1"}));
  std::string many[2];
  for (int i = 0; i < 2; ++i) {
    many[i] = "Network 1\nLD I0." + std::to_string(i) + "\n";
    for (int word = 0; word < 7; ++word) many[i] += "MOVW 1, VW" + std::to_string(word * 10) + "\n";
  }
  EXPECT_EQ(named("OUT006", blocks(callBoth, {many[0], many[1]})),
            (Named{"VW0: VW0, VW10, VW20, VW30 and 3 more are written in SBR_0 and in SBR_1"}));
  const std::vector<Finding> findings = Linted(blocks(callBoth, {many[0], many[1]})).of("OUT006");
  ASSERT_EQ(findings.size(), 1U);
  EXPECT_EQ(findings[0].related.size(), 7U) << "the other writer of the first, and one of each further place";
}

TEST(SeveralBlocks, CodeThatNeverRunsAndProtectedCodeAreNoRivals) {
  const std::string coil = "Network 1\nLD I0.2\n= Q0.2\n";
  EXPECT_EQ(named("OUT006", blocks("Network 1\nLD I0.0\nCALL SBR0\n", {coil, coil})), Named());
  const std::string guarded =
      "LD SM0.1\nATCH 0, 0\nENI\nLD SM0.0\nDISI\nMOVB 0, MB0\nENI\nMEND\nINT 0\nS M0.0, 1\nRETI\n";
  EXPECT_EQ(named("OUT006", guarded), Named());
}

TEST(LogicRules, OverwrittenCoilHasNoEffectUnlessRead) {
  EXPECT_EQ(lines("LOG003", "Network 1\nLD I0.0\n= M0.0\nNetwork 2\nLD M0.0\n= Q0.0\nNetwork 3\nLD I0.1\n= M0.0\n"),
            Lines());
  EXPECT_EQ(lines("LOG003", "Network 1\nLD I0.0\n= M0.0\nNetwork 2\nLD I0.1\n= M0.0\nNetwork 3\nLD M0.0\n= Q0.0\n"),
            Lines{2});
}

TEST(LogicRules, EdgeStopsTheToggle) {
  EXPECT_EQ(lines("LOG005", "Network 1\nLD I0.0\nEU\nAN M0.0\n= M0.0\nNetwork 2\nLD M0.0\n= Q0.0\n"), Lines());
  const Linted level("Network 1\nLD I0.0\nAN M0.0\n= M0.0\nNetwork 2\nLD M0.0\n= Q0.0\n");
  ASSERT_EQ(level.of("LOG005").size(), 1U);
  EXPECT_EQ(level.of("LOG005")[0].confirmation, Confirmation::Unconfirmed);
}

/// R and R, S and S: whichever comes last, the bit is the same. Set here and reset there stays a question of order.
TEST(OutputRules, SeveralBlocksThatDoTheSame) {
  const auto of = [](const std::string& main, const std::string& routine) {
    return Linted("ORGANIZATION_BLOCK MAIN:OB1\nBEGIN\nNetwork 1\nLD I0.0\nCALL SBR0\nNetwork 2\nLD I0.1\n" + main +
                  "\nEND_ORGANIZATION_BLOCK\nSUBROUTINE_BLOCK SBR_0:SBR0\nBEGIN\nNetwork 1\nLD I0.2\n" + routine +
                  "\nEND_SUBROUTINE_BLOCK\n")
        .of("OUT006")
        .size();
  };
  EXPECT_EQ(of("R Q0.0, 1", "R Q0.0, 1"), 0u);
  EXPECT_EQ(of("S Q0.0, 1", "S Q0.0, 1"), 0u);
  EXPECT_EQ(of("R Q0.0, 4", "R Q0.2, 8"), 0u);
  EXPECT_EQ(of("RI Q0.0, 1", "R Q0.0, 1"), 0u);
  EXPECT_EQ(of("S Q0.0, 1", "R Q0.0, 1"), 1u);
  EXPECT_EQ(of("R Q0.0, 1", "= Q0.0"), 1u);
}

/// A chain of three steps, each with coils: one finding that names all three. One step alone keeps its own words, and
/// coils behind a jump are a finding of their own.
TEST(OutputRules, StepsOfAChainAreOneFinding) {
  const auto step = [](int number, const std::string& coils) {
    return fmt::format(
        "Network {0}\nLSCR S0.{0}\nNetwork {0}1\nLD SM0.0\n{1}Network {0}2\nLD I0.{0}\nSCRT S0.{2}\nNetwork "
        "{0}3\nSCRE\n",
        number, coils, (number + 1) % 3);
  };
  const std::string chain = step(0, "= Q0.0\n") + step(1, "= Q0.1\n= Q1.1\n") + step(2, "= Q0.2\n");
  const Linted three(chain);
  ASSERT_EQ(three.of("OUT007").size(), 1U);
  const Finding finding = three.of("OUT007")[0];
  EXPECT_EQ(std::string(finding.message.view()),
            "the coils of 3 steps keep their last value while their step is not active: Q0.0 in LSCR S0.0, Q0.1 in "
            "LSCR S0.1 and 1 more, Q0.2 in LSCR S0.2");
  EXPECT_EQ(finding.related.size(), 3U);
  EXPECT_EQ(Linted(step(0, "= Q0.0\n")).of("OUT007").size(), 1U);
  EXPECT_EQ(Linted(chain + "Network 40\nLD I1.0\nJMP 1\nNetwork 41\nLD I1.1\n= Q1.5\nNetwork 42\nLBL 1\n")
                .of("OUT007")
                .size(),
            2U);
}

}  // namespace
}  // namespace rungproof::testing
