// Data blocks that a proof may do without, and those that only seem to be idle.
#include "analysis/unread/idle_blocks.hpp"
#include "proved_text.hpp"

namespace rungproof::test {
namespace {

std::string blockOf(int number) {
  return fmt::format(
      "DATA_BLOCK DB {}\nVERSION : 0.1\nSTRUCT\n  b : ARRAY [1 .. 20] OF BYTE ;\nEND_STRUCT ;\nBEGIN\nEND_DATA_BLOCK\n",
      number);
}

/// Numbers of the data blocks that stay of 1 to 9, with further blocks before OB1.
std::vector<std::uint32_t> kept(const std::string& statements, const std::string& directives = "",
                                const std::string& blocks = "") {
  std::string text;
  for (int i = 1; i <= 9; ++i) text += blockOf(i);
  Program program = readText(
      "idle.awl", text + blocks + "ORGANIZATION_BLOCK OB 1\n" + directives +
                      "VAR_TEMP\n  Start : ARRAY [1 .. 20] OF BYTE ;\n  number : INT ;\n  record : ANY ;\nEND_VAR\n" +
                      "BEGIN\nNETWORK\n" + statements + "END_ORGANIZATION_BLOCK\n");
  for (const Finding& finding : program.findings) EXPECT_NE(finding.severity, Severity::Error) << finding.message;
  const PropertySet set = readProperties(program, {}, lookupIn(program));
  leaveOutIdleBlocks(program, set);
  std::vector<std::uint32_t> numbers;
  for (const DataBlock& block : program.dataBlocks) numbers.push_back(block.number);
  return numbers;
}

using Numbers = std::vector<std::uint32_t>;
const Numbers all = {1, 2, 3, 4, 5, 6, 7, 8, 9};

TEST(IdleBlocks, AreThoseThatNothingNames) {
  EXPECT_EQ(kept("A I 0.0;\n= Q 0.0;\n"), Numbers{});
  EXPECT_EQ(kept("A DB3.DBX 0.0;\n= Q 0.0;\n"), Numbers{3});
  EXPECT_EQ(kept("OPN DB 4;\nL DBW 2;\nT MW 10;\n"), Numbers{4});
  EXPECT_EQ(kept("OPN DI 5;\nL DIW 2;\nT MW 10;\n"), Numbers{5});
  EXPECT_EQ(kept("L DB6.DBW 2;\nOPN DB 4;\nL DBW [DB7.DBD 4];\nT MW 10;\n"), (Numbers{4, 6, 7}));
}

TEST(IdleBlocks, AQuestionNamesBlocksToo) {
  EXPECT_EQ(kept("A I 0.0;\n= Q 0.0;\n", "//@ prove rest: DB2.DBW4 = 0\n"), Numbers{2});
  EXPECT_EQ(kept("A I 0.0;\n= Q 0.0;\n", "//@ external DB3.DBW0..DB3.DBW8\n"), Numbers{3});
}

TEST(IdleBlocks, WhatACallHandsOverIsNamed) {
  const std::string byNumber =
      "FUNCTION FC 1 : VOID\nVAR_INPUT\n  d : BLOCK_DB ;\nEND_VAR\nBEGIN\nNETWORK\nOPN #d;\nL DBW 0;\nT MW 20;\n"
      "END_FUNCTION\n";
  EXPECT_EQ(kept("CALL FC 1 (d := DB 8);\n", "", byNumber), Numbers{8});
  const std::string byPointer =
      "FUNCTION FC 1 : VOID\nVAR_INPUT\n  p : ANY ;\nEND_VAR\nBEGIN\nNETWORK\nL P##p;\nLAR1 ;\nL W [AR1,P#2.0];\n"
      "T MW 20;\nEND_FUNCTION\n";
  EXPECT_EQ(kept("CALL FC 1 (p := P#DB9.DBX0.0 BYTE 4);\n", "", byPointer), Numbers{9});
  EXPECT_EQ(kept("CALL FC 1 (p := DB7.DBW 2);\n", "", byPointer), Numbers{7});
  const std::string instance =
      "FUNCTION_BLOCK FB 1\nVAR\n  n : INT ;\nEND_VAR\nBEGIN\nNETWORK\nL #n;\nT MW 20;\nEND_FUNCTION_BLOCK\n"
      "DATA_BLOCK DB 20\nFB 1\nBEGIN\nEND_DATA_BLOCK\n";
  EXPECT_EQ(kept("CALL FB 1, DB 20;\n", "", instance), Numbers{20});
}

TEST(IdleBlocks, AComputedNumberKeepsThemAll) {
  EXPECT_EQ(kept("L IW 0;\nT #number;\nOPN DB [#number];\nL DBW 0;\nT MW 10;\n"), all);
  EXPECT_EQ(kept("L IW 0;\nT #number;\nOPN DI [#number];\nL DIW 0;\nT MW 10;\n"), all);
}

TEST(IdleBlocks, APointerThatABlockOfTheSystemFollowsKeepsThemAll) {
  EXPECT_EQ(kept("CALL SFC 20 (SRCBLK := #record, RET_VAL := MW 10, DSTBLK := P#M 20.0 BYTE 4);\n"), all);
}

// Of two programs side by side, what one of them opens stays in both.
TEST(IdleBlocks, OfTwoProgramsAreIdleInBoth) {
  const auto programOf = [](const std::string& statements) {
    return readText("side.awl", blockOf(1) + blockOf(2) + blockOf(3) + "ORGANIZATION_BLOCK OB 1\nBEGIN\nNETWORK\n" +
                                    statements + "END_ORGANIZATION_BLOCK\n");
  };
  Program before = programOf("OPN DB 1;\nL DBW 0;\nT MW 10;\n"), after = programOf("L DB2.DBW 0;\nT MW 10;\n");
  NamedBlocks named;
  named.addText(before);
  named.addText(after);
  for (Program* program : {&before, &after}) {
    leaveOutBlocks(*program, named);
    ASSERT_EQ(program->dataBlocks.size(), 2U);
    EXPECT_EQ(program->dataBlocks[0].number, 1U);
    EXPECT_EQ(program->dataBlocks[1].number, 2U);
  }
}

}  // namespace
}  // namespace rungproof::test
