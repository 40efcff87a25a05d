// The one-text dialect of the S7-212/214 time: MEND, SBR n, INT n, RET, RETI, no Network lines (dialect notes 9.2).
#include <gtest/gtest.h>

#include "tests/reader/read.hpp"

namespace rungproof {
namespace {

TEST(OlderDialect, OneTextWithAllBlocks) {
  const Program program = readText("a.txt",
                                   "// title: pump\n"
                                   "LD      SM0.1   // first scan\n"
                                   "CALL    1\n"
                                   "ATCH    0, 10\n"
                                   "ENI\n"
                                   "// second rung\n"
                                   "LD      I0.0\n"
                                   "=       Q0.0\n"
                                   "MEND\n"
                                   "// the subroutine\n"
                                   "SBR     1       // sets\n"
                                   "S       M0.0, 1\n"
                                   "LD      I0.1\n"
                                   "R       M0.0, 1\n"
                                   "RET\n"
                                   "INT0\n"
                                   "INCB    VB0\n"
                                   "RETI\n");
  EXPECT_EQ(findings(program), "");
  EXPECT_TRUE(program.olderDialect);
  ASSERT_EQ(program.pous.size(), 3U);
  EXPECT_EQ(show(program.pous[0]), "LD SM0.1; CALL 1; ATCH 0,10; ENI | LD I0.0; = Q0.0 | MEND");
  EXPECT_EQ(show(program.pous[1]), "S M0.0,1 | LD I0.1; R M0.0,1 | RET");
  EXPECT_EQ(show(program.pous[2]), "INCB VB0 | RETI");
  EXPECT_EQ(program.pous[0].name, "MAIN");
  EXPECT_EQ(program.pous[1].name, "SBR_1");
  EXPECT_EQ(program.pous[1].number, 1);
  EXPECT_EQ(program.pous[2].name, "INT_0");
  EXPECT_EQ(program.pous[2].kind, PouKind::Interrupt);
  ASSERT_EQ(program.pous[0].networks[1].comments.size(), 1U);
  EXPECT_EQ(program.sources->text(program.pous[0].networks[1].comments[0].span), "// second rung");
  ASSERT_EQ(program.pous[1].comments.size(), 1U);
  EXPECT_EQ(program.sources->text(program.pous[1].comments[0].span), "// the subroutine");
}

TEST(OlderDialect, HeaderForms) {
  const Program program = readText("a.txt",
                                   "LD I0.0\nCALL 2\nMEND\nSBR 2\nLD I0.1\nRET\nSBR50\nLD I0.2\nRET\nINT O\nLD "
                                   "I0.3\nRETI\nINT_120\nLD I0.4\nRETI\nINT\nLD I0.5\nRETI\n");
  ASSERT_EQ(program.pous.size(), 6U);
  EXPECT_EQ(program.pous[1].number, 2);
  EXPECT_EQ(program.pous[2].number, 50);
  EXPECT_EQ(program.pous[3].number, 0);
  EXPECT_EQ(program.pous[4].number, 120);
  EXPECT_EQ(program.pous[5].number, 121);  // without number: the next free one, reported
  EXPECT_EQ(findings(program), "SYN023<INT>");
}

TEST(OlderDialect, RungsEndWhereTheStackIsNotNeeded) {
  // The second load is combined by ALD, so it does not begin a rung; the load behind the coil does.
  const Program program =
      readText("a.txt", "LD I0.0\nO Q0.0\nLD I0.1\nON I0.2\nALD\n= Q0.0\nLD I0.3\nTON T37, 50\nLD T37\n= Q0.1\n");
  EXPECT_EQ(show(program.pous[0]),
            "LD I0.0; O Q0.0; LD I0.1; ON I0.2; ALD; = Q0.0 | LD I0.3; TON T37,50 | LD T37; = Q0.1");
}

TEST(OlderDialect, ContactsBehindABoxStayInTheRung) {
  const Program program = readText("a.txt", "LD M2.0\nTON T33, +200\nAN T33\n= Q0.0\nNOT\n= Q0.1\nLD I0.0\n= Q0.2\n");
  EXPECT_EQ(show(program.pous[0]), "LD M2.0; TON T33,+200; AN T33; = Q0.0; NOT; = Q0.1 | LD I0.0; = Q0.2");
}

TEST(OlderDialect, LoadBehindACoilThatIsCombinedLaterStays) {
  const Program program = readText("a.txt", "LD I0.0\n= Q0.0\nLD I0.1\nALD\n= Q0.1\nLD I0.2\n= Q0.2\n");
  EXPECT_EQ(show(program.pous[0]), "LD I0.0; = Q0.0; LD I0.1; ALD; = Q0.1 | LD I0.2; = Q0.2");
}

TEST(OlderDialect, DamagedLinesMarkTheirRung) {
  const Program program = readText("a.txt", "LD I0.0\n= Q0.0\nLD I0.1\nFOO Q0.1\nBAR\nLD I0.2\n= Q0.2\n");
  EXPECT_EQ(show(program.pous[0]), "LD I0.0; = Q0.0 | !LD I0.1; LD I0.2; = Q0.2");
  EXPECT_EQ(findings(program), "SYN010<FOO> SYN010<BAR>");
  EXPECT_EQ(program.findings[0].network, 2);
  const Program border = readText("a.txt", "LD I0.0\n= Q0.0\nFOO I0.1\nLD I0.2\n= Q0.2\n");
  EXPECT_EQ(show(border.pous[0]), "!LD I0.0; = Q0.0 | !LD I0.2; = Q0.2");
}

TEST(OlderDialect, DataUnderTheListing) {
  const Program program = readText("a.txt",
                                   "LD I0.0\n= Q0.0\nMEND\nB 100 5\nB 101 16#41\nB 102 \xE2\x80\x9C"
                                   "AB\xE2\x80\x9D\nVW200 7\n");
  EXPECT_EQ(findings(program), "");
  ASSERT_EQ(program.data.size(), 4U);
  EXPECT_EQ(program.data[2].offset, 102U);
  EXPECT_EQ(program.data[2].bytes, (std::vector<std::uint8_t>{'A', 'B'}));
  EXPECT_EQ(program.data[3].bytes, (std::vector<std::uint8_t>{0, 7}));
}

TEST(OlderDialect, BannersAndStrayTextAreNotes) {
  const Program program = readText("a.txt",
                                   "* * * * MAIN * * * *\nLD I0.0\n\xE5\xBD\x93 I0.1\n= Q0.0\nMEND\n/* * * * SBR * * "
                                   "*\nSBR 0\nLD I0.1\n= Q0.1\nRET\n");
  EXPECT_EQ(program.findings.size(), 3U);
  EXPECT_FALSE(hasReadErrors(program));
  EXPECT_EQ(show(program.pous[0]), "LD I0.0; = Q0.0 | MEND");
}

TEST(OlderDialect, SequencerSegmentsAndLoops) {
  const Program program = readText("a.txt",
                                   "LSCR S0.0\nLD SM0.0\nS Q0.0, 1\nLD I0.0\nSCRT S0.1\nSCRE\nLD I0.1\nFOR VW0, 1, "
                                   "10\nINCW VW2\nNEXT\nLD I0.2\nJMP 1\nLBL 1\n");
  EXPECT_EQ(show(program.pous[0]),
            "LSCR S0.0 | LD SM0.0; S Q0.0,1 | LD I0.0; SCRT S0.1 | SCRE | LD I0.1; FOR VW0,1,10; INCW VW2 | NEXT | LD "
            "I0.2; JMP 1 | LBL 1");
}

}  // namespace
}  // namespace rungproof
