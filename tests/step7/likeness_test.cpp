// Families and mnemonics are told by words that only one of them has.
#include <gtest/gtest.h>

#include "frontend/step7/mnemonic_vote.hpp"
#include "frontend/step7/step7_likeness.hpp"
#include "ir/s7200/isa.hpp"
#include "tests/step7/read7.hpp"

namespace rungproof::step7 {
namespace {

TEST(Likeness, SourcesOfTheS7300) {
  for (const char* text :
       {"FUNCTION FC 1 : VOID\nBEGIN\nEND_FUNCTION\n", "ORGANIZATION_BLOCK OB 100\nBEGIN\nEND_ORGANIZATION_BLOCK\n",
        "TYPE \"x\"\nSTRUCT\nEND_STRUCT\nEND_TYPE\n",
        "DATA_BLOCK \"x\"\nSTRUCT\n a : INT;\nEND_STRUCT;\nBEGIN\nEND_DATA_BLOCK\n",
        "DATA_BLOCK DB 1\nVERSION : 0.1\nSTRUCT\n a : INT;\nEND_STRUCT;\nBEGIN\nEND_DATA_BLOCK\n",
        "      L     MW    10\n      T     MW    12\n", "A(\nO I0.0\nO I0.1\n)\n= Q0.0\n", "CALL FC 5\n",
        "      SPB   m1\nm1: NOP 0\n"})
    EXPECT_TRUE(step7Likeness(text).isStep7()) << text;
}

TEST(Likeness, ProgramsOfTheS7200) {
  for (const char* text : {"ORGANIZATION_BLOCK MAIN:OB1\nBEGIN\nNetwork 1\nLD I0.0\n= Q0.0\nEND_ORGANIZATION_BLOCK\n",
                           "LD I0.0\nA I0.1\n= Q0.0\n", "Network 1\nLD SM0.1\nMOVW 5, VW10\nITB VW10, VB20\n",
                           "LD I0.0\nTON T37, 100\n", "LD I0.0\nCALL SBR0\n", "LDW>= VW0, 5\nS Q0.0, 1\n",
                           "DATA_BLOCK DB1\nBEGIN\nVB0 1\nEND_DATA_BLOCK\n", "SUBROUTINE_BLOCK SBR_0:SBR0\n"})
    EXPECT_FALSE(step7Likeness(text).isStep7()) << text;
}

TEST(Likeness, StructuredTextIsNoStatementList) {
  EXPECT_TRUE(
      step7Likeness("FUNCTION FC 1 : VOID\nBEGIN\nIF a THEN\n b := 1;\nEND_IF;\nEND_FUNCTION\n").isStructuredText());
  EXPECT_TRUE(step7Likeness("FUNCTION \"f\" : Void\nBEGIN\n #b := 1;\nEND_FUNCTION\n").isStructuredText());
  EXPECT_FALSE(step7Likeness("DATA_BLOCK \"d\"\nBEGIN\n b := 1;\nEND_DATA_BLOCK\n").isStructuredText());
}

// The ending of the file says so, whatever its statements end with; without it an assignment does.
TEST(Likeness, AFileOfStructuredTextIsNoStatementList) {
  const auto of = [](const std::string& statements) {
    return "ORGANIZATION_BLOCK OB1\nVAR_TEMP\n w : WORD;\nEND_VAR\nBEGIN\n" + statements + "\nEND_ORGANIZATION_BLOCK\n";
  };
  for (const char* statements : {"Q0.0 := NOT (I0.0 AND I0.1);", "w := SHL(IN := W#16#5, N := 3);", "RETURN;"}) {
    const Program program = readText("ob1.scl", of(statements));
    EXPECT_TRUE(program.findings.empty()) << statements << ": " << program.findings[0].message;
    ASSERT_FALSE(program.pous.empty()) << statements;
    EXPECT_FALSE(program.pous[0].networks.empty()) << statements;
  }
  EXPECT_TRUE(step7Likeness(of("Q0.0 := NOT (I0.0 AND I0.1);")).isStructuredText());
  EXPECT_FALSE(step7Likeness(of("CALL FC 1 (\n a := I 0.0,\n b := I 0.1);")).isStructuredText());
}

TEST(Likeness, ATieIsAnErrorThatNamesTheOptions) {
  const Program program = readText("x.awl", "LD I0.0\nL MW 10\n");
  ASSERT_EQ(program.findings.size(), 1u);
  EXPECT_EQ(program.findings[0].rule, "SYN050");
  EXPECT_NE(program.findings[0].message.find("--dialect s7-200 or s7-300"), std::string::npos);
}

TEST(Likeness, MnemonicsOfEachSource) {
  const std::vector<std::string_view> texts = {"U E 0.0;\n= A 4.0;\n", "L MW 0;\nT MW 2;\n",
                                               "A I 0.0;\nU E 0.0;\nA I 0.1;\nU E 0.1;\n", "OPN DB 1;\nA I 0.0;\n"};
  const MnemonicVote vote(texts, Mnemonics::Auto);
  EXPECT_EQ(vote.of(0), MnemonicSet::German);
  EXPECT_FALSE(vote.isTied(1));
  EXPECT_TRUE(vote.isTied(2));
  EXPECT_EQ(vote.of(3), MnemonicSet::International);
  const MnemonicVote named(texts, Mnemonics::German);
  EXPECT_EQ(named.of(3), MnemonicSet::German);
  EXPECT_FALSE(named.isTied(2));
}

// Statements that both sets have in common, and operands that only one has, given to a block.
TEST(Likeness, ParametersOfCallsTellTheSet) {
  const std::vector<std::string_view> texts = {
      "ORGANIZATION_BLOCK OB 1\nBEGIN\nNETWORK\nCALL FC 1 (x := EW 10);\nL MW 0;\nEND_ORGANIZATION_BLOCK\n",
      "ORGANIZATION_BLOCK OB 1\nBEGIN\nNETWORK\nCALL FC 1 (\n  x := IW 10,\n  y := Q 4.0);\nL MW 0;\n"
      "END_ORGANIZATION_BLOCK\n"};
  const MnemonicVote vote(texts, Mnemonics::Auto);
  EXPECT_EQ(vote.of(0), MnemonicSet::German);
  EXPECT_EQ(vote.of(1), MnemonicSet::International);
  EXPECT_FALSE(vote.isTied(0));
}

TEST(Likeness, ASilentSourceIsWrittenAsTheOthers) {
  const std::vector<std::string_view> texts = {"L MW 0;\nT MW 2;\n", "U E 0.0;\nSPB a;\n"};
  EXPECT_EQ(MnemonicVote(texts, Mnemonics::Auto).of(0), MnemonicSet::German);
}

}  // namespace
}  // namespace rungproof::step7
