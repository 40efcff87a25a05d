// Names to addresses.
#include "frontend/stl/resolve.hpp"

#include <gtest/gtest.h>

#include "tests/reader/read.hpp"

namespace rungproof {
namespace {

Program readWith(const std::string& symbols, const std::string& lines) {
  return readText("a.awl", "ORGANIZATION_BLOCK MAIN:OB1\nBEGIN\nNetwork 1\n" + lines +
                               "\nEND_ORGANIZATION_BLOCK\nSYMBOL_TABLE\n" + symbols + "END_SYMBOL_TABLE\n");
}

TEST(Resolve, SymbolsInEveryPlace) {
  const Program program = readWith(
      "Start\tI0.0\nLevel\tVW10\nPtr\tVD20\nBuf\tVB100\nTime\tT37\nMax\t+500\n\xE6\xB3\xB5\tQ0.0\n",
      "LD Start\nMOVW Max, Level\nMOVD &Buf, Ptr\nMOVB *Ptr, Buf\nTON Time, Max\nLD \"Start\"\n= \xE6\xB3\xB5");
  EXPECT_EQ(findings(program), "");
  EXPECT_EQ(show(program.pous[0]),
            "LD I0.0; MOVW +500,VW10; MOVD &VB100,VD20; MOVB *VD20,VB100; TON T37,+500; LD I0.0; = Q0.0");
  const Operand& pointer = program.pous[0].networks[0].instructions[3].operands[0];
  EXPECT_EQ(pointer.kind, OperandKind::Indirect);
  EXPECT_EQ(pointer.text, "*Ptr");
  EXPECT_EQ(program.sources->text(pointer.span), "*Ptr");
}

TEST(Resolve, SymbolAndAddressTogether) {
  // The editor can show both. The address counts; who is in the table has to have the same one.
  const std::string table = "Start\tI0.0\nLevel\tVW10\nTime\tT37\n";
  const Program program = readWith(
      table, "LD Start:I0.0\n= \"Motor on\":Q0.5\nMOVW Level:VW10, Other:VW12\nTON Time:T37, 5\nA Start:%I0.0");
  EXPECT_EQ(findings(program), "");
  EXPECT_EQ(show(program.pous[0]), "LD I0.0; = Q0.5; MOVW VW10,VW12; TON T37,5; A I0.0");
  const auto& move = program.pous[0].networks[0].instructions[2];
  EXPECT_EQ(move.operands[0].text, "Level");
  EXPECT_EQ(move.operands[1].text, "") << "no table knows the name";
  const Program differs = readWith(table, "LD Start:I0.1\n= Q0.0");
  ASSERT_EQ(differs.findings.size(), 1U);
  EXPECT_EQ(differs.findings[0].message, "Start is I0.0 by the symbol table, and I0.1 is written here");
  EXPECT_FALSE(differs.pous[0].networks[0].complete);
  for (const char* none : {"LD Start:", "LD :I0.0", "LD Start:Stop", "LD 5:I0.0", "LD \"\":I0.0"})
    EXPECT_NE(findings(readWith(table, std::string(none) + "\n= Q0.0")), "") << none;
}

TEST(Resolve, LocalsHideSymbols) {
  const Program program = readText("a.awl",
                                   "SUBROUTINE_BLOCK A:SBR0\nVAR_INPUT\nx:BOOL;\nEND_VAR\nBEGIN\nNetwork 1\nLD x\nA "
                                   "#x\nA y\nEND_SUBROUTINE_BLOCK\nSYMBOL_TABLE\nx\tI0.0\ny\tI0.1\nEND_SYMBOL_TABLE\n");
  EXPECT_EQ(show(program.pous[0]), "LD L0.0; A L0.0; A I0.1");
}

TEST(Resolve, CaseIsSecondChoice) {
  EXPECT_EQ(show(readWith("Start\tI0.0\nSTART\tI0.1\n", "LD Start\nA START\nA start").pous[0]),
            "LD I0.0; A I0.1; A I0.0");
}

TEST(Resolve, UnknownNamesStay) {
  const Program program = readWith("a\tI0.0\n", "LD nobody\nA #a\nCALL Missing\nATCH Gone, 5");
  EXPECT_EQ(findings(program), "");  // rule SYM001 speaks, not the reader
  const Network& network = program.pous[0].networks[0];
  for (const Instruction& instruction : network.instructions)
    EXPECT_EQ(instruction.operands[0].kind, OperandKind::Symbol);
  EXPECT_EQ(network.instructions[2].operands[0].value, -1);
  EXPECT_TRUE(network.complete);
}

TEST(Resolve, Routines) {
  const Program program =
      readText("a.awl",
               "ORGANIZATION_BLOCK MAIN:OB1\nBEGIN\nNetwork 1\nLD SM0.0\nCALL Pump\nCALL SBR_0\nCALL SBR7\nCALL "
               "4\nCALL T1\nATCH Edge, 0\nATCH INT3, 1\nATCH 2, 2\nCALL \"Pump\"\nCALL Other\n"
               "END_ORGANIZATION_BLOCK\nSUBROUTINE_BLOCK Pump:SBR3\nBEGIN\nEND_SUBROUTINE_BLOCK\nSUBROUTINE_BLOCK "
               "SBR_0:SBR9\nBEGIN\nEND_SUBROUTINE_BLOCK\n"
               "SUBROUTINE_BLOCK T1:SBR5\nBEGIN\nEND_SUBROUTINE_BLOCK\nINTERRUPT_BLOCK "
               "Edge:INT6\nBEGIN\nEND_INTERRUPT_BLOCK\nSYMBOL_TABLE\nOther\tSBR11\nEND_SYMBOL_TABLE\n");
  EXPECT_EQ(findings(program), "");
  EXPECT_EQ(show(program.pous[0]),
            "LD SM0.0; CALL 3; CALL 9; CALL 7; CALL 4; CALL 5; ATCH 6,0; ATCH 3,1; ATCH 2,2; CALL 3; CALL 11");
  EXPECT_EQ(program.pous[0].networks[0].instructions[1].operands[0].text, "Pump");
}

TEST(Resolve, TextsAndQuotedNamesAsParameters) {
  const Program program = readText("a.awl",
                                   "ORGANIZATION_BLOCK MAIN:OB1\nBEGIN\nNetwork 1\nLD SM0.0\nCALL SBR0, \"Start\", "
                                   "\"Hello\"\nEND_ORGANIZATION_BLOCK\nSYMBOL_TABLE\nStart\tI0.0\nEND_SYMBOL_TABLE\n");
  EXPECT_EQ(show(program.pous[0]), "LD SM0.0; CALL 0,I0.0,\"Hello\"");
}

TEST(Resolve, PointerFaults) {
  const Program program = readWith("w\tVW0\nb\tI0.0\n", "MOVB *w, VB0\nMOVD &b, AC1");
  EXPECT_EQ(findings(program), "SYN013<*w> SYN013<&b>");
  EXPECT_FALSE(program.pous[0].networks[0].complete);
}

TEST(Resolve, SystemNames) {
  EXPECT_EQ(show(readLines("LD Always_On\nA Clock_1s\nMOVB 5, P0_Config\nA CPU_Input10\n= CPU_Output3").pous[0]),
            "LD SM0.0; A SM0.5; MOVB 5,SMB30; A I1.2; = Q0.3");
  EXPECT_EQ(show(readWith("Always_On\tM5.0\n", "LD Always_On").pous[0]), "LD M5.0");
}

TEST(Resolve, LadderConstantsOnlyWhereConstantsFit) {
  EXPECT_EQ(show(readWith("K1\tQ0.3\n", "LD K1\nMOVW K5, VW0").pous[0]), "LD Q0.3; MOVW 5,VW0");
  EXPECT_EQ(readLines("LD K1").pous[0].networks[0].instructions[0].operands[0].kind, OperandKind::Symbol);
}

}  // namespace
}  // namespace rungproof
