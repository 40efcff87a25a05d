// The Micro/WIN text export: frame, declarations, networks, titles, comments, recovery.
#include <gtest/gtest.h>

#include "tests/reader/read.hpp"

namespace rungproof {
namespace {

TEST(StlParser, ReadsTheFrameOfAnExport) {
  const Program program = readText("a.awl",
                                   "ORGANIZATION_BLOCK MAIN:OB1\r\n"
                                   "TITLE=Pump control\r\n"
                                   "// second line of the title\r\n"
                                   "BEGIN\r\n"
                                   "Network 1 // start\r\n"
                                   "// the start button\r\n"
                                   "LD     I0.0\r\n"
                                   "O      Q0.0\r\n"
                                   "AN     I0.1\r\n"
                                   "=      Q0.0\r\n"
                                   "Network 4 \r\n"
                                   "LD     SM0.1\r\n"
                                   "S      Q0.1, 2\r\n"
                                   "END_ORGANIZATION_BLOCK\r\n"
                                   "SUBROUTINE_BLOCK SBR_0:SBR0\r\n"
                                   "TITLE=SUBROUTINE COMMENTS\r\n"
                                   "BEGIN\r\n"
                                   "Network 1 // Network Title\r\n"
                                   "// Network Comment\r\n"
                                   "END_SUBROUTINE_BLOCK\r\n");
  EXPECT_EQ(findings(program), "");
  ASSERT_EQ(program.pous.size(), 2U);
  const Pou& main = program.pous[0];
  EXPECT_EQ(main.kind, PouKind::Main);
  EXPECT_EQ(main.name, "MAIN");
  EXPECT_EQ(main.number, 1);
  EXPECT_EQ(main.title, "Pump control");
  EXPECT_EQ(main.comments.size(), 1U);
  ASSERT_EQ(main.networks.size(), 2U);
  EXPECT_EQ(main.networks[0].title, "start");
  EXPECT_EQ(main.networks[1].number, 4);
  EXPECT_EQ(main.networks[1].title, "");
  ASSERT_EQ(main.networks[0].comments.size(), 1U);
  EXPECT_EQ(program.sources->text(main.networks[0].comments[0].span), "// the start button");
  EXPECT_EQ(show(main), "LD I0.0; O Q0.0; AN I0.1; = Q0.0 | LD SM0.1; S Q0.1,2");
  EXPECT_EQ(program.pous[1].kind, PouKind::Subroutine);
  EXPECT_EQ(program.pous[1].number, 0);
  EXPECT_TRUE(program.pous[1].networks[0].instructions.empty());
  EXPECT_FALSE(program.olderDialect);
}

TEST(StlParser, PlacesPointIntoTheText) {
  const Program program = readLines("LD     I0.0\nMOVW   VW10,\tVW20 // move");
  const Network& network = program.pous[0].networks[0];
  const Instruction& move = network.instructions[1];
  EXPECT_EQ(program.sources->text(move.span), "MOVW   VW10,\tVW20");
  EXPECT_EQ(program.sources->text(move.mnemonic()), "MOVW");
  EXPECT_EQ(program.sources->text(move.operands[1].span), "VW20");
  EXPECT_EQ(program.sources->text(network.comments[0].span), "// move");
  EXPECT_EQ(program.sources->position(move.span).line, 6U);
  EXPECT_EQ(program.sources->text(network.span).substr(0, 9), "Network 1");
}

TEST(StlParser, HeadingsInAllForms) {
  const Program program =
      readText("a.awl",
               "organization_block OB1\nTITLE =x\nbegin\nNETWORK 1\nld i0.0\n= q0.0\nend_organization_block\n"
               "SUBROUTINE_BLOCK \xE6\xB3\xB5:SBR12\nBEGIN\nEND_SUBROUTINE_BLOCK\n"
               "SUBROUTINE_BLOCK SBR_3\nBEGIN\nEND_SUBROUTINE_BLOCK\n"
               "INTERRUPT_BLOCK Edge up : INT 7\nBEGIN\nEND_INTERRUPT_BLOCK\n");
  EXPECT_EQ(findings(program), "");
  ASSERT_EQ(program.pous.size(), 4U);
  EXPECT_EQ(program.pous[0].name, "MAIN");
  EXPECT_EQ(program.pous[0].title, "x");
  EXPECT_EQ(show(program.pous[0]), "LD I0.0; = Q0.0");
  EXPECT_EQ(program.pous[1].name, "\xE6\xB3\xB5");
  EXPECT_EQ(program.pous[1].number, 12);
  EXPECT_EQ(program.pous[2].name, "SBR_3");
  EXPECT_EQ(program.pous[2].number, 3);
  EXPECT_EQ(program.pous[3].name, "Edge up");
  EXPECT_EQ(program.pous[3].kind, PouKind::Interrupt);
  EXPECT_EQ(program.pous[3].number, 7);
}

TEST(StlParser, HeadingWithoutNumberTakesTheNextFree) {
  const Program program = readText("a.awl",
                                   "SUBROUTINE_BLOCK A:SBR4\nBEGIN\nEND_SUBROUTINE_BLOCK\nSUBROUTINE_BLOCK "
                                   "Pump\nBEGIN\nNetwork 1\nLD I0.0\nEND_SUBROUTINE_BLOCK\n");
  ASSERT_EQ(program.pous.size(), 2U);
  EXPECT_EQ(program.pous[1].name, "Pump");
  EXPECT_EQ(program.pous[1].number, 5);
  EXPECT_EQ(findings(program), "SYN023<SUBROUTINE_BLOCK Pump>");
}

TEST(StlParser, MainStandsFirst) {
  const Program program =
      readText("a.awl",
               "SUBROUTINE_BLOCK B:SBR1\nBEGIN\nNetwork 1\n//@ reach b: Q0.1\nLD I0.0\nEND_SUBROUTINE_BLOCK\n"
               "ORGANIZATION_BLOCK MAIN:OB1\nBEGIN\nNetwork 3\n//@ reach a: Q0.0\nLD I0.0\nEND_ORGANIZATION_BLOCK\n");
  ASSERT_EQ(program.pous.size(), 2U);
  EXPECT_EQ(program.pous[0].kind, PouKind::Main);
  ASSERT_EQ(program.directives.size(), 2U);
  EXPECT_EQ(program.directives[0].pou, 1);
  EXPECT_EQ(program.directives[1].pou, 0);
  EXPECT_EQ(program.directives[1].network, 3);
  EXPECT_EQ(program.directives[1].text, "reach a: Q0.0");
}

TEST(StlParser, SmartExport) {
  // Leading tabs, tab-only lines, signed constants, empty lines between blocks, comment without blank.
  const Program program =
      readText("smart.awl",
               "ORGANIZATION_BLOCK MAIN:OB1\nTITLE=\xE7\xA8\x8B\xE5\xBA\x8F\xE6\xB3\xA8\xE9\x87\x8A\nBEGIN\nNetwork 1 "
               "\n//comment\n\t\n\t\n"
               "\tLD     Always_On\n\tCALL   Init\n\tATCH   INT_0, 10\nEND_ORGANIZATION_BLOCK\n\n"
               "SUBROUTINE_BLOCK Init:SBR1\nTITLE=\nBEGIN\nNetwork 1 \n\tLD     First_Scan_On\n\tMOVW   +100, "
               "P0_Timeout\nEND_SUBROUTINE_BLOCK\n\n"
               "INTERRUPT_BLOCK INT_0:INT0\nTITLE=\nBEGIN\nNetwork 1 \n\tLD     CPU_\xE8\xBE\x93\xE5\x85\xA5"
               "9\nEND_INTERRUPT_BLOCK\n");
  EXPECT_EQ(findings(program), "");
  ASSERT_EQ(program.pous.size(), 3U);
  EXPECT_EQ(show(program.pous[0]), "LD SM0.0; CALL 1; ATCH 0,10");
  EXPECT_EQ(show(program.pous[1]), "LD SM0.1; MOVW +100,SMW92");
  EXPECT_EQ(show(program.pous[2]), "LD I1.1");
}

TEST(StlParser, NetworkLinesInAllForms) {
  const Program program = readText("a.awl",
                                   "Network 1\nLD I0.0\nNETWORK 7 // seven\nLD I0.1\nNetwork\nLD I0.2\nnetwork12\nLD "
                                   "I0.3\nNetwork 13 plain title\nLD I0.4\n"
                                   "Network 14:\nTITLE=below\nLD I0.5\nNetwork // only title\nLD I0.6\n");
  EXPECT_EQ(findings(program), "");
  ASSERT_EQ(program.pous.size(), 1U);
  const std::vector<Network>& networks = program.pous[0].networks;
  ASSERT_EQ(networks.size(), 7U);
  EXPECT_EQ(networks[1].number, 7);
  EXPECT_EQ(networks[1].title, "seven");
  EXPECT_EQ(networks[2].number, 8);
  EXPECT_EQ(networks[3].number, 12);
  EXPECT_EQ(networks[4].title, "plain title");
  EXPECT_EQ(networks[5].number, 14);
  EXPECT_EQ(networks[5].title, "below");
  EXPECT_EQ(networks[6].number, 15);
  EXPECT_EQ(networks[6].title, "only title");
  EXPECT_FALSE(program.olderDialect);
}

TEST(StlParser, NetworkCommentLineIsAComment) {
  const Program program = readLines("NETWORK_COMMENT holds the belt; LD I9.9\nLD I0.0");
  EXPECT_EQ(show(program.pous[0]), "LD I0.0");
  ASSERT_EQ(program.pous[0].networks[0].comments.size(), 1U);
  EXPECT_EQ(program.sources->text(program.pous[0].networks[0].comments[0].span),
            "NETWORK_COMMENT holds the belt; LD I9.9");
}

TEST(StlParser, Declarations) {
  const Program program =
      readText("a.awl",
               "SUBROUTINE_BLOCK SBR_0:SBR0\nTITLE=\nVAR_INPUT\nIN:BYTE;\t// "
               "value\nRun:BOOL;\nEND_VAR\nVAR_OUTPUT\nOUT:WORD;\nEND_VAR\nVAR\nA, B : INT ;\nEND_VAR\n"
               "BEGIN\nNetwork 1\nLD #Run\nMOVB IN, LB0\nMOVW #A, #OUT\nEND_SUBROUTINE_BLOCK\n");
  EXPECT_EQ(findings(program), "");
  ASSERT_EQ(program.pous.size(), 1U);
  const std::vector<LocalVariable>& locals = program.pous[0].locals;
  ASSERT_EQ(locals.size(), 5U);
  EXPECT_EQ(toString(locals[0].address), "LB0");
  EXPECT_EQ(toString(locals[1].address), "L1.0");
  EXPECT_EQ(toString(locals[2].address), "LW2");
  EXPECT_EQ(toString(locals[3].address), "LW4");
  EXPECT_EQ(toString(locals[4].address), "LW6");
  EXPECT_EQ(locals[2].section, VarSection::Output);
  EXPECT_EQ(show(program.pous[0]), "LD L1.0; MOVB LB0,LB0; MOVW LW4,LW2");
}

TEST(StlParser, ProtectedBlockIsNoted) {
  const Program program =
      readText("a.awl",
               "ORGANIZATION_BLOCK MAIN:OB1\nBEGIN\nNetwork 1\nLD I0.0\nCALL SBR1\nEND_ORGANIZATION_BLOCK\n"
               "SUBROUTINE_BLOCK Secret:SBR1\nTITLE=\nVAR_INPUT\nx:BOOL;\nEND_VAR\nBEGIN\n"
               "Network 1 // This POU is password-protected against editing and viewing.\n\nEND_SUBROUTINE_BLOCK\n");
  ASSERT_EQ(program.pous.size(), 2U);
  EXPECT_TRUE(program.pous[1].protectedBlock);
  EXPECT_EQ(findings(program), "SYN026<SUBROUTINE_BLOCK Secret:SBR1>");
  EXPECT_FALSE(hasReadErrors(program));
}

TEST(StlParser, StatementsOnOneLine) {
  const Program program = readLines("LD I0.0; AN I0.1 ; = Q0.0; // three");
  EXPECT_EQ(findings(program), "");
  EXPECT_EQ(show(program.pous[0]), "LD I0.0; AN I0.1; = Q0.0");
  EXPECT_EQ(program.pous[0].networks[0].comments.size(), 1U);
}

TEST(StlParser, CallGoesOnBehindAComma) {
  const Program program = readText("a.awl",
                                   "ORGANIZATION_BLOCK MAIN:OB1\nBEGIN\nNetwork 1\nLD SM0.0\nCALL SBR_0, I0.1, VB10,\n "
                                   "      &VB100, *AC1, VD200\nLD I0.0,\nA I0.1\nEND_ORGANIZATION_BLOCK\n");
  EXPECT_EQ(show(program.pous[0]), "LD SM0.0; CALL 0,I0.1,VB10,&VB100,*AC1,VD200; LD I0.0; A I0.1");
  ASSERT_EQ(program.findings.size(), 1U);
  EXPECT_EQ(program.findings[0].rule, "SYN018");
}

TEST(StlParser, OneRunReportsAllErrors) {
  const Program program = readText("a.awl",
                                   "ORGANIZATION_BLOCK MAIN:OB1\nBEGIN\nNetwork 1\nLD I0.0\nFOO I0.1\n= Q0.0\nNetwork "
                                   "2\nLD I0.0, I0.1\nNetwork 3\nLD\nNetwork 4\nLD I0.2\nMOVW 16#XYZ, VW0\n"
                                   "Network 5\nLD I0.5\n= Q0.5\nEND_ORGANIZATION_BLOCK\n");
  EXPECT_EQ(findings(program), "SYN010<FOO> SYN012<I0.1> SYN012<LD> SYN014<16#XYZ>");
  EXPECT_EQ(show(program.pous[0]), "!LD I0.0; = Q0.0 | !LD I0.0 | ! | !LD I0.2 | LD I0.5; = Q0.5");
  EXPECT_EQ(program.findings[0].pou, "MAIN");
  EXPECT_EQ(program.findings[3].network, 4);
  EXPECT_TRUE(hasReadErrors(program));
}

TEST(StlParser, BlockEndsThatDoNotMatch) {
  const Program open = readText(
      "a.awl",
      "ORGANIZATION_BLOCK MAIN:OB1\nBEGIN\nNetwork 1\nLD I0.0\nSUBROUTINE_BLOCK A:SBR0\nBEGIN\nNetwork 1\nLD I0.1\n");
  EXPECT_EQ(open.pous.size(), 2U);
  EXPECT_EQ(findings(open), "SYN020<ORGANIZATION_BLOCK MAIN:OB1> SYN020<SUBROUTINE_BLOCK A:SBR0>");
  const Program wrong = readText(
      "a.awl", "ORGANIZATION_BLOCK MAIN:OB1\nBEGIN\nNetwork 1\nLD I0.0\nEND_SUBROUTINE_BLOCK\nLD I0.1\nLD I0.2\n");
  EXPECT_EQ(findings(wrong), "SYN021<END_SUBROUTINE_BLOCK> SYN025<LD I0.1\nLD I0.2>");
  EXPECT_EQ(show(wrong.pous[0]), "LD I0.0");
}

TEST(StlParser, TwinBlocks) {
  const std::string main = "ORGANIZATION_BLOCK MAIN:OB1\nBEGIN\nNetwork 1\nLD I0.0\nEND_ORGANIZATION_BLOCK\n";
  const std::string sub = "SUBROUTINE_BLOCK A:SBR0\nBEGIN\nNetwork 1\nLD I0.0\nEND_SUBROUTINE_BLOCK\n";
  const Program program =
      readText("a.awl", main + main + sub +
                            "SUBROUTINE_BLOCK B:SBR0\nBEGIN\nEND_SUBROUTINE_BLOCK\nSUBROUTINE_BLOCK "
                            "A:SBR5\nBEGIN\nEND_SUBROUTINE_BLOCK\n");
  int twins = 0;
  for (const Finding& finding : program.findings) twins += finding.rule == "SYN022" ? 1 : 0;
  EXPECT_EQ(twins, 3);
}

TEST(StlParser, TablesInTheSameText) {
  const Program program =
      readText("a.awl",
               "ORGANIZATION_BLOCK MAIN:OB1\nBEGIN\nNetwork 1\nLD Start\n= Q0.0\nEND_ORGANIZATION_BLOCK\n"
               "DATA_BLOCK_TAB USER1\n//\nBEGIN\n// values\nVB22   0\n\nVW24   16#1234, 5\nEND_DATA_BLOCK_TAB\n"
               "SYMBOL_TABLE\nStart\tI0.0\tthe start button\nEND_SYMBOL_TABLE\n");
  EXPECT_EQ(findings(program), "");
  EXPECT_EQ(show(program.pous[0]), "LD I0.0; = Q0.0");
  EXPECT_EQ(program.pous[0].networks[0].instructions[0].operands[0].text, "Start");
  ASSERT_EQ(program.data.size(), 3U);
  EXPECT_EQ(program.data[1].offset, 24U);
  EXPECT_EQ(program.data[1].bytes, (std::vector<std::uint8_t>{0x12, 0x34}));
  EXPECT_EQ(program.data[2].offset, 26U);
  ASSERT_EQ(program.symbols.size(), 1U);
  EXPECT_EQ(program.symbols[0].comment, "the start button");
}

TEST(StlParser, BlockWithoutNetworkLinesIsCutIntoRungs) {
  const Program program = readText(
      "a.awl",
      "ORGANIZATION_BLOCK MAIN:OB1\nBEGIN\n// a\nLD I0.0\n= Q0.0\n// b\nLD I0.1\n= Q0.1\nEND_ORGANIZATION_BLOCK\n");
  EXPECT_EQ(show(program.pous[0]), "LD I0.0; = Q0.0 | LD I0.1; = Q0.1");
  EXPECT_EQ(program.pous[0].networks[1].number, 2);
  EXPECT_EQ(program.pous[0].networks[1].comments.size(), 1U);
}

}  // namespace
}  // namespace rungproof
