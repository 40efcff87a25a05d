// One line at a time: operands as users and printed listings write them, and what is said about them.
#include <gtest/gtest.h>

#include "tests/reader/read.hpp"

namespace rungproof {
namespace {

/// A line, what it is read as, and the findings.
struct Row {
  std::string line;
  std::string meant;
  std::string findings;
};

void check(const std::vector<Row>& rows) {
  for (const Row& row : rows) {
    const Program program = readLines(row.line);
    ASSERT_EQ(program.pous.size(), 1U) << row.line;
    ASSERT_EQ(program.pous[0].networks.size(), 1U) << row.line;
    EXPECT_EQ(show(program.pous[0].networks[0]), row.meant) << row.line;
    EXPECT_EQ(findings(program), row.findings) << row.line;
  }
}

TEST(Statement, AcceptsWhatTheEditorAccepts) {
  check({
      {"LD I0.0", "LD I0.0", ""},
      {"\tLD\tI0.0", "LD I0.0", ""},
      {"ld i0.0", "LD I0.0", ""},
      {"=Q0.0", "= Q0.0", ""},
      {"=I Q0.0", "=I Q0.0", ""},
      {"S Q0.0,1", "S Q0.0,1", ""},
      {"MOVB 10 VB0", "MOVB 10,VB0", ""},
      {"MOVW   *VD10, *AC1", "MOVW *VD10,*AC1", ""},
      {"MOVW   * VD10, * AC1", "MOVW *VD10,*AC1", ""},
      {"MOVD   & VB100, AC1", "MOVD &VB100,AC1", ""},
      {"MOVD   &VW100, AC1", "MOVD &VB100,AC1", ""},
      {"MOVD   &T37, AC1", "MOVD &T37,AC1", ""},
      {"MOVD   &AIW4, AC1", "MOVD &AIW4,AC1", ""},
      {"LDW>=  VW920, +10", "LDW>= VW920,+10", ""},
      {"LD %I0.0", "LD I0.0", ""},
      {"LD %IX0.0", "LD I0.0", ""},
      {"LD ??.?", "LD ????", ""},
      {"MOVW ????, VW0", "MOVW ????,VW0", ""},
      {"MOVR   1.5, VD0", "MOVR 1.5,VD0", ""},
      {"NOT", "NOT", ""},
      {"TON T37, +100", "TON T37,+100", ""},
      {"LDS= \"a, b // c\", VB0", "LDS= \"a, b // c\",VB0", ""},
      {"CALL 3", "CALL 3", ""},
      {"CALL SBR3, VB5, VW30", "CALL 3,VB5,VW30", ""},
      {"LBL 5", "LBL 5", ""},
      {"ATCH INT_2, +10", "ATCH 2,+10", ""},
  });
}

TEST(Statement, LooksAlike) {
  // s7200 dialect notes 9.3: 1 for I, O for 0; also Cyrillic, full width, typographic minus.
  check({
      {"LD 10.0", "LD I0.0", "STY004<10.0>"},
      {"LD 11.4", "LD I1.4", "STY004<11.4>"},
      {"LD IO.0", "LD I0.0", "STY004<IO.0>"},
      {"LD SMO.O", "LD SM0.0", "STY004<SMO.O>"},
      {"LD I0.l", "LD I0.1", "STY004<I0.l>"},
      {"LD 10, 1", "LD I0.1", "STY004<10, 1>"},
      {"LD I0,1", "LD I0.1", "STY004<I0,1>"},
      {"S Q0,1, 5", "S Q0.1,5", "STY004<Q0,1>"},
      {"MOVB 1B0, VB0", "MOVB IB0,VB0", "STY004<1B0>"},
      {"MOVW A1W4, VWl0", "MOVW AIW4,VW10", "STY004<A1W4> STY004<VWl0>"},
      {"MOVW 16#OF, VW0", "MOVW 16#F,VW0", "STY004<16#OF>"},
      {"MOVW 1O, VW0", "MOVW 10,VW0", "STY004<1O>"},
      {"+1 4, AC0", "+I 4,AC0", "STY004<+1>"},
      {"-1 500, VW0", "-I 500,VW0", "STY004<-1>"},
      {"0LD", "OLD", "STY004<0LD>"},
      {"LD\xD0\x90", "", "SYN010<LD\xD0\x90>"},
      {"\xD0\x90 I0.0", "A I0.0", "STY004<\xD0\x90>"},
      {"LD \xD0\x9C"
       "0.0",
       "LD M0.0",
       "STY004<\xD0\x9C"
       "0.0>"},
      {"MOVB \xD0\x9C\xD0\x92"
       "0, VB0",
       "MOVB MB0,VB0",
       "STY004<\xD0\x9C\xD0\x92"
       "0>"},
      {"\xEF\xBC\xAC\xEF\xBC\xA4 \xEF\xBC\xA9\xEF\xBC\x90.0", "LD I0.0",
       "STY004<\xEF\xBC\xAC\xEF\xBC\xA4> STY004<\xEF\xBC\xA9\xEF\xBC\x90.0>"},
      {"MOVW \xE2\x80\x93"
       "5, VW0",
       "MOVW -5,VW0",
       "STY004<\xE2\x80\x93"
       "5>"},
      {"DTCH +O", "DTCH +0", "STY004<+O>"},
  });
}

TEST(Statement, FixOfALookAlikeReplacesTheOperand) {
  const Program program = readLines("LD 10, 1");
  ASSERT_EQ(program.findings.size(), 1U);
  const Finding& finding = program.findings[0];
  ASSERT_NE(finding.fix, nullptr);
  EXPECT_EQ(finding.fix->replacement, "I0.1");
  EXPECT_EQ(program.sources->text(finding.fix->span), "10, 1");
  EXPECT_TRUE(finding.fix->safe);
  EXPECT_FALSE(hasReadErrors(program));
  EXPECT_TRUE(program.pous[0].networks[0].complete);
}

TEST(Statement, LenientSpellings) {
  check({
      {"LD VB 600", "LD VB600", "SYN018<VB 600>"},
      {"A SM 0.0", "A SM0.0", "SYN018<SM 0.0>"},
      {"MOVD+0, AC0", "MOVD +0,AC0", "SYN018<MOVD+0>"},
      {"LDW>=SMW70, VW0", "LDW>= SMW70,VW0", "SYN018<LDW>=SMW70>"},
      {"LDD >= VD0, VD4", "LDD>= VD0,VD4", "SYN018<LDD >=>"},
      {"LDW \\geq VW0, VW2", "LDW>= VW0,VW2", "SYN018<LDW \\geq>"},
      {"LDW\xE2\x89\xA4VW0, VW2", "LDW<= VW0,VW2", "STY004<LDW\xE2\x89\xA4> SYN018<LDW\xE2\x89\xA4VW0>"},
      {"CALL1", "CALL 1", "SYN018<CALL1>"},
      {"SM0.0, 1", "S M0.0,1", "SYN018<SM0.0>"},
      {"LDI0.0", "LD I0.0", "SYN018<LDI0.0>"},
      {"RI0.0, 1", "R I0.0,1", "SYN018<RI0.0>"},
      {"MOVW K9, VW10", "MOVW 9,VW10", "SYN018<K9>"},
      {"MOVW KHFF, VW10", "MOVW 16#FF,VW10", "SYN018<KHFF>"},
  });
}

TEST(Statement, LadderNames) {
  check({{"MOV_B 1, VB0", "MOVB 1,VB0", "SYN016<MOV_B>"}, {"FILL_N 0, VW0, 5", "FILL 0,VW0,5", "SYN016<FILL_N>"}});
}

TEST(Statement, LexerTraps) {
  // s7200 machine notes 25.15: LDS N against LDS=, AI against AIW, L double words, S and R.
  check({
      {"LDS 3", "LDS 3", ""},
      {"LDS= VB0, VB10", "LDS= VB0,VB10", ""},
      {"LDS = VB0, VB10", "LDS= VB0,VB10", "SYN018<LDS =>"},
      {"AI I0.0", "AI I0.0", ""},
      {"MOVW AIW0, VW0", "MOVW AIW0,VW0", ""},
      {"MOVD LD10, VD0", "MOVD LD10,VD0", ""},
      {"LD L60.0", "LD L60.0", ""},
      {"MOVB *LD10, VB0", "MOVB *LD10,VB0", ""},
      {"STR VB0, 1, VD10", "STR VB0,1,VD10", ""},
      {"R C5, 1", "R C5,1", ""},
  });
}

TEST(Statement, Errors) {
  check({
      {"FOO I0.0", "", "SYN010<FOO>"},
      {"RTUM VB0", "", "SYN011<RTUM>"},
      {"L MW0", "", "SYN011<L>"},
      {"LD I0.0, I0.1", "LD I0.0", "SYN012<I0.1>"},
      {"LD", "", "SYN012<LD>"},
      {"NOT I0.0", "NOT", "SYN012<I0.0>"},
      {"MOVW VW0", "", "SYN012<MOVW VW0>"},
      {"LD I0..0", "", "SYN013<I0..0>"},
      {"LD VB0.1", "", "SYN013<VB0.1>"},
      {"A I0.0\nLD E0.0\nA I0.1", "A I0.0; A I0.1", "SYN019<E0.0>"},
      {"MOVW *VW0, VW2", "", "SYN013<*VW0>"},
      {"MOVD &V0.1, AC1", "", "SYN013<&V0.1>"},
      {"MOVD &Q0.0, AC1", "", "SYN013<&Q0.0>"},
      {"MOVW 15#FF, VW0", "", "SYN014<15#FF>"},
      {"MOVW 16#, VW0", "", "SYN014<16#>"},
      {"MOVD 99999999999, VD0", "", "SYN014<99999999999>"},
      {"MOVD 'ABCDE', VD0", "", "SYN014<'ABCDE'>"},
      {"LDS= \"abc, VB0", "", "SYN017<LDS= \"abc, VB0>"},
      {"LD M37", "LD M37", "SYN013<M37>"},
  });
}

TEST(Statement, CommentsThatLostTheirSign) {
  check({
      {"NOT\n* * * main * * *", "NOT", "SYN015<* * * main * * *>"},
      {"NOT\n***************", "NOT", "SYN015<***************>"},
      {"NOT\n/* main", "NOT", "SYN015</* main>"},
      {"NOT\n\xE5\xBD\x93\xE8\xBE\x93\xE5\x85\xA5 I0.1", "NOT", "SYN015<\xE5\xBD\x93\xE8\xBE\x93\xE5\x85\xA5 I0.1>"},
      {"ENI \xE5\x85\x81\xE8\xAE\xB8", "ENI", "SYN015<\xE5\x85\x81\xE8\xAE\xB8>"},
  });
}

// A word as short as a mnemonic with nothing but addresses behind it is no sentence: a Russian or Chinese "and".
TEST(Statement, MnemonicsOfAnotherLanguageAreNoComments) {
  check({
      {"\xD0\x98 I0.1", "", "SYN010<\xD0\x98>"},
      {"\xD0\x98\xD0\x9B\xD0\x98 *VD10", "", "SYN010<\xD0\x98\xD0\x9B\xD0\x98>"},
      {"\xE4\xB8\x8E T37", "", "SYN010<\xE4\xB8\x8E>"},
      {"NOT\n\xD0\x98 \xD1\x81\xD1\x82\xD0\xBE\xD0\xBF", "NOT", "SYN015<\xD0\x98 \xD1\x81\xD1\x82\xD0\xBE\xD0\xBF>"},
      {"NOT\n\xE4\xB8\x8E 1", "NOT", "SYN015<\xE4\xB8\x8E 1>"},
  });
}

TEST(Statement, SuggestsTheNearestMnemonic) {
  EXPECT_NE(readLines("MOBW 1, VW0").findings[0].message.find("MOVW"), std::string::npos);
  EXPECT_NE(readLines("RNTI").findings[0].message.find("RETI"), std::string::npos);
  EXPECT_NE(readLines("SER 2").findings[0].message.find("SBR"), std::string::npos);
  EXPECT_NE(readLines("RTUM VB0").findings[0].message.find("SMART"), std::string::npos);
}

}  // namespace
}  // namespace rungproof
