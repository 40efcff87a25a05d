// What could not be read or is not legal decides nothing: verdicts that may depend on it are NOT COVERED, in both
// directions, and the others are as if it did nothing. Table C-3 (001:13978-14008) lists what the CPU refuses.
#include <gtest/gtest.h>

#include "tests/prover/proved_text.hpp"

namespace rungproof {
namespace {

using test::outcomeOf;
using test::usualOptions;

/// Verdicts over a text that need not be legal. `one` is about Q0.0, `other` about Q0.1, which is never on.
struct Verdicts {
  Outcome one = Outcome::Unknown;
  Outcome other = Outcome::Unknown;
  std::string text;  ///< what is unread
};

constexpr const char* properties = "//@ reach one: Q0.0 and prev(not Q0.0)\n//@ prove other: never Q0.1\n";
constexpr const char* otherNetwork = "Network 9\nLD I1.0\nAN I1.0\n= Q0.1\n";

Verdicts verdictsOf(const std::string& networks, const std::string& otherBlocks = "") {
  ProgramInput input;
  input.program = readText("test.awl", std::string("ORGANIZATION_BLOCK MAIN:OB1\n") + properties + "BEGIN\n" +
                                           networks + otherNetwork + "END_ORGANIZATION_BLOCK\n" + otherBlocks);
  input.properties = readProperties(input.program, {}, lookupIn(input.program));
  const UnreadCode unread(input.program);
  ProverOptions options = usualOptions();
  options.unread = &unread;
  const ProofRun run = prove(unread.executable(), input.properties, options);
  EXPECT_TRUE(run.disagreements.empty()) << networks;
  Verdicts verdicts{outcomeOf(run, "one"), outcomeOf(run, "other"), ""};
  for (const std::string& line : unread.texts()) verdicts.text += line + "\n";
  return verdicts;
}

/// The network is unread and writes only what `one` is about.
void expectOnlyOne(const std::string& networks) {
  const Verdicts verdicts = verdictsOf(networks);
  EXPECT_EQ(verdicts.one, Outcome::NotCovered) << networks << verdicts.text;
  EXPECT_EQ(verdicts.other, Outcome::Proved) << networks << verdicts.text;
}

/// The network is unread and may write anything.
void expectNone(const std::string& networks, const std::string& otherBlocks = "") {
  const Verdicts verdicts = verdictsOf(networks, otherBlocks);
  EXPECT_EQ(verdicts.one, Outcome::NotCovered) << networks << verdicts.text;
  EXPECT_EQ(verdicts.other, Outcome::NotCovered) << networks << verdicts.text;
}

TEST(UnreadCode, AnUndefinedNameThatIsReadLeavesItsOutputsOpen) {
  expectOnlyOne("Network 1\nLD Start\n= Q0.0\n");
  expectOnlyOne("Network 1\nLD I0.0\nTON T37, Foo\nNetwork 2\nLD T37\n= Q0.0\n");
  expectOnlyOne("Network 1\nLD I0.0\nMOVD &Foo, AC1\nNetwork 2\nLDD> AC1, 5\n= Q0.0\n");
  expectOnlyOne("Network 1\nLDW> Foo, 5\n= Q0.0\n");
}

TEST(UnreadCode, AnUndefinedNameThatIsWrittenMayBeAnything) {
  expectNone("Network 1\nLD I0.0\nMOVB 3, Foo\nNetwork 2\nLD I0.0\n= Q0.0\n");
  expectNone("Network 1\nLD I0.0\n= Foo\nNetwork 2\nLD I0.0\n= Q0.0\n");
  expectNone("Network 1\nLD I0.0\nS Foo, 1\nNetwork 2\nLD I0.0\n= Q0.0\n");
  expectNone("Network 1\nLD I0.0\nMOVD 1, *Foo\nNetwork 2\nLD I0.0\n= Q0.0\n");
}

TEST(UnreadCode, WhatTheCpuDoesNotHaveIsNotRun) {  // errors 0090 and 0091 (001:13996-13997)
  expectOnlyOne("Network 1\nLD I0.9\n= Q0.0\n");
  expectOnlyOne("Network 1\nLD T256\n= Q0.0\n");
  expectOnlyOne("Network 1\nLD C256\n= Q0.0\n");
  expectOnlyOne("Network 1\nLD I0.0\nMOVB 300, VB0\nNetwork 2\nLDB= VB0, 44\n= Q0.0\n");
  expectOnlyOne("Network 1\nLD I0.0\nMOVW VW20000, VW0\nNetwork 2\nLDW> VW0, 0\n= Q0.0\n");
  expectOnlyOne("Network 1\nLD I0.0\nMOVW AC9, VW0\nNetwork 2\nLDW> VW0, 0\n= Q0.0\n");
  expectOnlyOne("Network 1\nLD I0.0\nMOVB VW0, VB4\nNetwork 2\nLDB> VB4, 0\n= Q0.0\n");
  expectNone("Network 1\nLD I0.0\nTON T300, 5\n");
  expectNone("Network 1\nLD I0.0\nTON T65535, 5\n");
  expectNone("Network 1\nLD I0.0\nLD I0.1\nCTU C256, 5\n");
  expectNone("Network 1\nLD I0.0\nS T65535, 1\n");
  expectNone("Network 1\nLD I0.0\n= Q0.9\n");
  expectNone("Network 1\nLD I0.0\nMOVW 1, AC9\n");
}

TEST(UnreadCode, ATimerOfTheWrongKindIsNotRun) {  // T5 belongs to TONR (001:6595-6603)
  expectOnlyOne("Network 1\nLD I0.0\nTON T5, 10\nNetwork 2\nLD T5\n= Q0.0\n");
  expectOnlyOne("Network 1\nLD I0.0\nTONR T37, 10\nNetwork 2\nLD T37\n= Q0.0\n");
  expectOnlyOne("Network 1\nLD I0.0\nTOF T5, 10\nNetwork 2\nLDW> T5, 3\n= Q0.0\n");
}

TEST(UnreadCode, AStructureThatIsRefusedMayDoAnything) {  // errors 0085 to 008C, 0095, 0096
  expectNone("Network 1\nLD I0.0\nFOR VW0, 1, 3\nNetwork 2\nLD I0.0\n= Q0.0\n");
  expectNone("Network 1\nNEXT\n");
  expectNone("Network 1\nLD I0.0\nJMP 5\n");
  expectNone("Network 1\nLD I0.0\nJMP 5\nNetwork 2\nLBL 5\nNetwork 3\nLBL 5\n");
  expectNone("Network 1\nLSCR S0.0\n");
  expectNone("Network 1\nLD I0.0\nCRET\n");
}

TEST(UnreadCode, ACallOfABlockThatIsNotThereMayDoAnything) {  // error 0087 (001:13989)
  expectNone("Network 1\nLD I0.0\nCALL SBR5\n");
  expectNone("Network 1\nLD I0.0\nCALL Cleaning\n");
  expectNone("Network 1\nLD SM0.1\nATCH INT_5, 0\nENI\n");
}

TEST(UnreadCode, ACallWithOtherParametersMayDoAnything) {  // 001:6813, 001:6823
  const std::string callee =
      "SUBROUTINE_BLOCK SBR_0:SBR0\nVAR_INPUT\nLevel:WORD;\nEND_VAR\nBEGIN\nNetwork 1\nLDW> LW0, 5\n= M0.0\n"
      "END_SUBROUTINE_BLOCK\n";
  expectNone("Network 1\nLD SM0.0\nCALL SBR0, VB10\n", callee);
  expectNone("Network 1\nLD SM0.0\nCALL SBR0\n", callee);
  expectNone("Network 1\nLD SM0.0\nCALL SBR0, VW10, VW12\n", callee);
}

const std::string protectedBlock =
    "SUBROUTINE_BLOCK SBR_0:SBR0\nBEGIN\nNetwork 1 // This POU is password-protected against editing and viewing.\n"
    "END_SUBROUTINE_BLOCK\n";

TEST(UnreadCode, AProtectedBlockMayDoAnything) {
  expectNone("Network 1\nLD I0.0\nCALL SBR0\n", protectedBlock);
  std::string routine = protectedBlock;
  for (const auto& [from, to] : {std::pair{"SUBROUTINE_BLOCK SBR_0:SBR0", "INTERRUPT_BLOCK INT_0:INT0"},
                                 std::pair{"END_SUBROUTINE_BLOCK", "END_INTERRUPT_BLOCK"}})
    routine.replace(routine.find(from), std::string(from).size(), to);
  expectNone("Network 1\nLD SM0.1\nATCH INT_0, 0\nENI\n", routine);
}

TEST(UnreadCode, AProtectedBlockThatNobodyCallsDoesNothing) {
  const Verdicts verdicts = verdictsOf("Network 1\nLD I0.0\n= Q0.0\n", protectedBlock);
  EXPECT_EQ(verdicts.one, Outcome::Reachable) << verdicts.text;
  EXPECT_EQ(verdicts.other, Outcome::Proved) << verdicts.text;
}

/// No power flow reaches the call (001:14063: SM0.0 is always 1), or the block that calls it; a routine is attached but
/// nothing enables interrupts (001:5444).
TEST(UnreadCode, AProtectedBlockThatNeverRunsDoesNothing) {
  const auto expectCovered = [](const std::string& main, const std::string& blocks) {
    const Verdicts verdicts = verdictsOf("Network 8\nLD I0.0\n= Q0.0\n" + main, blocks);
    EXPECT_EQ(verdicts.one, Outcome::Reachable) << verdicts.text;
    EXPECT_EQ(verdicts.other, Outcome::Proved) << verdicts.text;
  };
  const std::string caller =
      "SUBROUTINE_BLOCK SBR_1:SBR1\nBEGIN\nNetwork 1\nLD I0.3\nCALL SBR0\nEND_SUBROUTINE_BLOCK\n";
  std::string routine = protectedBlock;
  for (const auto& [from, to] : {std::pair{"SUBROUTINE_BLOCK SBR_0:SBR0", "INTERRUPT_BLOCK INT_0:INT0"},
                                 std::pair{"END_SUBROUTINE_BLOCK", "END_INTERRUPT_BLOCK"}})
    routine.replace(routine.find(from), std::string(from).size(), to);
  expectCovered("Network 1\nLDN SM0.0\nCALL SBR0\n", protectedBlock);
  expectCovered("Network 1\nLDN SM0.0\nCALL SBR1\n", caller + protectedBlock);
  expectCovered("Network 1\nLD SM0.1\nATCH INT_0, 0\n", routine);
  expectCovered("Network 1\nLDN SM0.0\nATCH INT_0, 0\nNetwork 2\nLD SM0.1\nENI\n", routine);
  // Siblings that run: one scan is enough, and so is a condition that nobody has worked out.
  expectNone("Network 1\nLD SM0.1\nCALL SBR0\n", protectedBlock);
  expectNone("Network 1\nLD I0.0\nCALL SBR1\n", caller + protectedBlock);
  expectNone("Network 1\nLDN SM0.0\nO I0.0\nCALL SBR0\n", protectedBlock);
}

/// Its outputs come from outside; what else it writes stands in no text (001:11020).
TEST(UnreadCode, AProtectedBlockOfALibraryIsNoEmptyBlock) {
  const std::string library =
      "SUBROUTINE_BLOCK RCP0_READ:SBR1\nVAR_INPUT\nRcp:WORD;\nEND_VAR\nVAR_OUTPUT\nError:BYTE;\nEND_VAR\nBEGIN\n"
      "Network 1 // This POU is password-protected against editing and viewing.\nEND_SUBROUTINE_BLOCK\n";
  const Verdicts verdicts =
      verdictsOf("Network 1\nLD I0.0\nCALL RCP0_READ, 1, VB10\nNetwork 2\nLDB<> VB10, 0\n= Q0.0\n", library);
  EXPECT_EQ(verdicts.one, Outcome::NotCovered);
}

TEST(UnreadCode, ALineWithoutMeaningMayDoAnything) {
  expectNone("Network 1\nLD I0.0\nBLINK Q0.5\n");
  expectNone("Network 1\nLD I0.0\nMOVB 16#GG, VB0\n");
}

/// Two networks of one number: the one that is refused is left out, not the other.
TEST(UnreadCode, NetworksOfOneNumber) {
  expectOnlyOne("Network 1\nLD I0.1\n= M5.0\nNetwork 1\nLD T256\n= Q0.0\n");
  expectNone("Network 1\nLD I0.1\n= M5.0\nNetwork 1\nLD I0.0\nEU\nATT VW0, AC9\n");
}

/// What is unread spreads over memory, the stack, jumps and calls, and no further.
TEST(UnreadCode, InfluenceSpreads) {
  expectOnlyOne("Network 1\nLD Foo\n= M0.0\nNetwork 2\nLD M0.0\n= M0.1\nNetwork 3\nLD M0.1\nO I0.0\n= Q0.0\n");
  expectOnlyOne(
      "Network 1\nLD I0.0\nMOVB 300, VB0\nNetwork 2\nLD SM0.0\nMOVW VW0, VW4\nNetwork 3\nLDB= VB4, 1\n= Q0.0\n");
  expectOnlyOne("Network 1\nLD I0.0\n= M0.5\nNetwork 2\nLD Foo\n= M0.0\nNetwork 3\nLD M0.0\nS Q0.0, 1\n");
  // A bit beside it is not touched.
  const Verdicts beside = verdictsOf("Network 1\nLD Foo\n= Q0.2\nNetwork 2\nLD I0.0\n= Q0.0\n");
  EXPECT_EQ(beside.one, Outcome::Reachable) << beside.text;
  EXPECT_EQ(beside.other, Outcome::Proved) << beside.text;
  // A jump on it decides over the whole block, a call over the callee.
  expectNone("Network 1\nLD Foo\n= M0.0\nNetwork 2\nLD M0.0\nJMP 1\nNetwork 3\nLD I0.0\n= Q0.0\nNetwork 4\nLBL 1\n");
  const std::string callee = "SUBROUTINE_BLOCK SBR_0:SBR0\nBEGIN\nNetwork 1\nLD I0.0\n= Q0.0\nEND_SUBROUTINE_BLOCK\n";
  const Verdicts called = verdictsOf("Network 1\nLD Foo\n= M0.0\nNetwork 2\nLD M0.0\nCALL SBR0\n", callee);
  EXPECT_EQ(called.one, Outcome::NotCovered) << called.text;
  EXPECT_EQ(called.other, Outcome::Proved) << called.text;
  // The value on the stack comes from the network before.
  expectOnlyOne("Network 1\nLD Foo\n= M0.0\nNetwork 2\n= Q0.0\n");
  // Status bits: the operation that sets them is not run.
  expectOnlyOne("Network 1\nLD I0.0\n+I Foo, VW0\nNetwork 2\nLD SM1.1\n= Q0.0\n");
  // A pointer may lead to it.
  expectOnlyOne("Network 1\nLD I0.0\nMOVB 300, VB0\nNetwork 2\nLDB= *VD100, 1\n= Q0.0\n");
}

/// Two hands on one place, in either order: the value at the end of the scan is not known.
TEST(UnreadCode, APlaceThatReadCodeWritesTooIsOpen) {
  expectOnlyOne("Network 1\nLD Foo\n= Q0.0\nNetwork 2\nLD I0.0\n= Q0.0\n");
  expectOnlyOne("Network 1\nLD I0.0\n= Q0.0\nNetwork 2\nLD Foo\nS Q0.0, 1\n");
}

TEST(UnreadCode, AnAssumptionAboutItLeavesEverythingOpen) {
  ProgramInput input;
  input.program =
      readText("test.awl",
               "//@ assume a: M0.0\n//@ prove p: never Q0.1\nNetwork 1\nLD Foo\n= M0.0\nNetwork 2\nLD I0.0\nAN "
               "I0.0\n= Q0.1\n");
  input.properties = readProperties(input.program, {}, lookupIn(input.program));
  const UnreadCode unread(input.program);
  ProverOptions options = usualOptions();
  options.unread = &unread;
  EXPECT_EQ(outcomeOf(prove(unread.executable(), input.properties, options), "p"), Outcome::NotCovered);
}

/// A block that nobody calls is refused all the same, but it does nothing.
TEST(UnreadCode, ABlockThatNeverRunsLeavesNothingOpen) {
  const std::string block =
      "SUBROUTINE_BLOCK SBR_0:SBR0\nBEGIN\nNetwork 1\nLD I0.0\nMOVB 3, Foo\nEND_SUBROUTINE_BLOCK\n";
  const Verdicts verdicts = verdictsOf("Network 1\nLD I0.0\n= Q0.0\n", block);
  EXPECT_EQ(verdicts.one, Outcome::Reachable) << verdicts.text;
  EXPECT_EQ(verdicts.other, Outcome::Proved) << verdicts.text;
  EXPECT_NE(verdicts.text.find("SBR_0"), std::string::npos) << verdicts.text;
}

TEST(UnreadCode, NothingIsUnreadInALegalProgram) {
  const Program program = readText("test.awl", "Network 1\nLD I0.0\nTON T37, 10\nNetwork 2\nLD T37\n= Q0.0\n");
  const UnreadCode unread(program);
  EXPECT_TRUE(unread.empty());
  EXPECT_TRUE(unread.reasons().empty());
  EXPECT_EQ(unread.instructions(), 0U);
}

}  // namespace
}  // namespace rungproof
