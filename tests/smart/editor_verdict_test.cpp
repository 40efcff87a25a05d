// The editor's verdict on networks: one rung in ladder, several in STL, and what no program can hold.
#include "analysis/drawing/editor_verdict.hpp"

#include <gtest/gtest.h>

#include "analysis/flow/facts.hpp"
#include "analysis/lint/lint.hpp"
#include "frontend/input/program_input.hpp"
#include "ir/s7200/cpu.hpp"

namespace rungproof {
namespace {

constexpr Target st40{s7200Cpu("ST40"), Edition::Smart28};

Program programOf(const std::string& lines) {
  std::string text = "ORGANIZATION_BLOCK MAIN:OB1\nBEGIN\n";
  for (const char c : lines) text += c == ';' ? '\n' : c;
  return readText("a.awl",
                  text +
                      "\nEND_ORGANIZATION_BLOCK\nSUBROUTINE_BLOCK SBR_0:SBR0\nVAR_INPUT\nA:BOOL;\nB:INT;\n"
                      "END_VAR\nBEGIN\nNetwork 1\nEND_SUBROUTINE_BLOCK\n",
                  {.target = st40});
}

/// Why the first network is invalid; empty: it is valid.
std::string reasonOf(const std::string& lines, EditorLanguage language = EditorLanguage::Ladder) {
  const Program program = programOf("Network 1;" + lines);
  const UnreadCode unread(program);
  return editorVerdicts(program, unread, language).front().reason;
}

TEST(EditorVerdict, OneRungIsValid) {
  for (const char* rung :
       {"LD I0.0;= Q0.0", "LD I0.0;O I0.1;LD I0.2;O I0.3;ALD;= Q0.0",  // loads in front of the first output join
        "LD I0.0;LD I0.1;CTU C1,5",                                    // a counter takes two
        "LD I0.0;LD I0.1;LD I0.2;CTUD C1,5",                           // or three
        "LD I0.0;LPS;A I0.1;= Q0.0;LPP;A I0.2;= Q0.1",                 // branches behind the first output
        "LD I0.0;LPS;LD I0.1;O I0.2;ALD;= Q0.0;LPP;= Q0.1",            // a load at depth 1
        "LD I0.0;LPS;A I0.3;= Q0.0;LPP;LD I0.1;O I0.2;ALD;= Q0.1",     // behind LPP, joined by ALD
        "LD I0.0;= Q0.0;= Q0.1", "LD SM0.0;MOVW 1,VW0;MOVW 2,VW2", "", "LBL 1", "END",
        "LD I0.0;= L60.0;LD I0.1;= L63.7;LD L60.0;CALL SBR0,L63.7,VW0"}) {  // the editor's own scratch
    EXPECT_EQ(reasonOf(rung), "") << rung;
  }
}

TEST(EditorVerdict, ASecondRungIsInvalidInLadderOnly) {
  for (const char* rungs :
       {"LD I0.0;= Q0.0;LD I0.1;= Q0.1", "LD SM0.0;MOVW 1,VW0;LD I0.1;MOVW 2,VW0", "LD I0.0;TON T37,10;LD T37;= Q0.0",
        "LD I0.0;S Q0.0,1;LDN I0.0;R Q0.0,1", "LD SM0.0;CALL SBR0,I0.0,VW0;LD I0.1;= Q0.1",
        "LD I0.0;= Q0.0;LDW= VW0,1;= Q0.1", "LD I0.0;LPS;A I0.1;= Q0.0;LPP;= Q0.1;LD I0.2;= Q0.2"}) {
    EXPECT_NE(reasonOf(rungs).find("second rung"), std::string::npos) << rungs;
    EXPECT_EQ(reasonOf(rungs, EditorLanguage::Stl), "") << rungs;
  }
}

TEST(EditorVerdict, ARungBeginsWithALoad) {
  for (const char* rung : {"A I0.0;= Q0.0", "= Q0.0", "O I0.0;= Q0.0", "MOVW 1,VW0", "NOT;= Q0.0", "EU;= Q0.0"})
    EXPECT_NE(reasonOf(rung).find("begins with a load"), std::string::npos) << rung;
}

TEST(EditorVerdict, WhatMarksAPlaceStandsAlone) {
  for (const char* lines : {"Network 1;LSCR S0.0;Network 2;LD I0.0;= Q0.0;Network 3;SCRE",
                            "Network 1;LD SM0.0;FOR VW0,1,5;Network 2;LD I0.0;= Q0.0;Network 3;NEXT"}) {
    const Program program = programOf(lines);
    const UnreadCode unread(program);
    for (const NetworkVerdict& verdict : editorVerdicts(program, unread, EditorLanguage::Ladder))
      EXPECT_EQ(verdict.reason, "") << lines;
  }
}

TEST(EditorVerdict, ForAndNextNeedNetworksOfTheirOwn) {
  EXPECT_NE(reasonOf("LD SM0.0;FOR VW0,1,5;NEXT").find("FOR and NEXT"), std::string::npos);
  EXPECT_EQ(reasonOf("LD SM0.0;FOR VW0,1,5;Network 2;NEXT"), "");
}

TEST(EditorVerdict, WhatNoLanguageTakesIsInvalidInBoth) {
  for (const char* rung : {"LD Foo;= Q0.0", "LD I0.0;FOO VW0", "LD I0.0;MOVW VW0", "LD I0.0;MOVW VW0,5",
                           "LD SM0.0;CALL Pump", "LD I0.0;MOVW VW12288,VW20480"}) {
    EXPECT_NE(reasonOf(rung), "") << rung;
    EXPECT_NE(reasonOf(rung, EditorLanguage::Stl), "") << rung;
  }
  EXPECT_NE(reasonOf("LD I0.0;NETR VB0,0").find("NETR"), std::string::npos) << "another family's instruction";
}

TEST(EditorVerdict, ProgramsOfManyRungsAreWrittenAsStl) {
  const std::string two = "LD I0.0;= Q0.0;LD I0.1;= Q0.1", one = "LD I0.2;= Q0.2";
  const auto isStl = [](const std::string& lines) { return isWrittenAsStl(programOf(lines)); };
  EXPECT_TRUE(isStl("Network 1;" + two + ";Network 2;" + two + ";Network 3;" + two + ";Network 4;" + one));
  EXPECT_FALSE(isStl("Network 1;" + two + ";Network 2;" + two)) << "too few to tell";
  EXPECT_FALSE(isStl("Network 1;" + two + ";Network 2;" + two + ";Network 3;" + two + ";Network 4;" + one +
                     ";Network 5;" + one + ";Network 6;" + one))
      << "as many that hold one";
  // STK006 speaks once a block from a third on.
  const auto notes = [](const std::string& lines) {
    const Program program = programOf(lines);
    std::size_t count = 0;
    for (const Finding& finding : runRules(Facts(program), RuleSelection({"STK006"}, {}), {}))
      count += finding.rule == "STK006";
    return count;
  };
  const auto program = [&](int several, int single) {
    std::string text;
    for (int i = 0; i < several + single; ++i)
      text += (i == 0 ? "Network " : ";Network ") + std::to_string(i + 1) + ";" + (i < several ? two : one);
    return text;
  };
  EXPECT_EQ(notes(program(3, 3)), 1U);
  EXPECT_EQ(notes(program(3, 6)), 1U) << "a third";
  EXPECT_EQ(notes(program(3, 7)), 3U) << "less than a third";
  EXPECT_EQ(notes(program(2, 0)), 2U) << "too few to tell";
  EXPECT_EQ(notes(program(0, 4)), 0U);
}

}  // namespace
}  // namespace rungproof
