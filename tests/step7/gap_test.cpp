// What is read but not modelled: for each row of the coverage table a program that holds it. An output that may depend
// on it is never PROVED, and the program is never EQUAL to a variant of itself.
#include <gtest/gtest.h>

#include <sstream>

#include "frontend/cli/cli.hpp"
#include "ir/s7300/coverage.hpp"
#include "tests/temporary_folder.hpp"

namespace rungproof {
namespace {

struct GapCase {
  s7300::Gap gap;
  std::string blocks, statements;
  std::string file = "more.awl", content{};  ///< another file of the project
};

std::vector<GapCase> gapCases() {
  using enum s7300::Gap;
  return {
      {OrganizationBlock, "ORGANIZATION_BLOCK OB 101\nBEGIN\nNETWORK\nSET;\n= Q 0.0;\nEND_ORGANIZATION_BLOCK\n",
       "NOP 0;"},
      {PointerParameter,
       "FUNCTION FC 5 : VOID\nVAR_INPUT\n  p : ANY;\nEND_VAR\nBEGIN\nNETWORK\nSET;\n= Q 0.0;\nEND_FUNCTION\n",
       "CALL FC 5 (p := MW [MD 4]);"},
      {LibraryBlock, "", "CALL SFC 61 (CIRCLE_ID := B#16#1, BLOCK_ID := B#16#1, RET_VAL := MW 4);"},
      {SystemInstance, "DATA_BLOCK DB 14\nSFB 14\nBEGIN\nEND_DATA_BLOCK\n",
       "CALL SFB 14, DB 14 (REQ := M 0.0, ID := W#16#1, NDR := M 0.1, ADDR_1 := P#M 20.0 BYTE 2, RD_1 := P#Q 0.0 BYTE "
       "2);"},
      {MissingBlock, "", "CALL FC 99;"},
      {ProtectedBlock, "FUNCTION FC 5 : VOID\nKNOW_HOW_PROTECT\nVAR_OUTPUT\n  y : BOOL;\nEND_VAR\nEND_FUNCTION\n",
       "CALL FC 5 (y := Q 0.0);"},
      {HighDataBlock, "DATA_BLOCK DB 9000\nSTRUCT\n  a : WORD;\nEND_STRUCT;\nBEGIN\nEND_DATA_BLOCK\n",
       "L DB9000.DBW 0;\nT QW 0;"},
      {Drawing, "", "CALL FC 5;", "drawn.xml",
       "<?xml version=\"1.0\" encoding=\"utf-8\"?>\n<Document><Engineering version=\"V15\"/><SW.Blocks.FC ID=\"0\">"
       "<AttributeList><Name>Drawn</Name><Number>5</Number><ProgrammingLanguage>SCL</ProgrammingLanguage>"
       "</AttributeList><ObjectList><SW.Blocks.CompileUnit ID=\"1\"><AttributeList><NetworkSource><StructuredText/>"
       "</NetworkSource></AttributeList></SW.Blocks.CompileUnit></ObjectList></SW.Blocks.FC></Document>\n"},
  };
}

/// What a command says; `exit`: its code where that is not one of things left open.
std::string outputOf(const std::vector<std::string>& arguments, int exit = -1) {
  std::istringstream in;
  std::ostringstream out, err;
  const int code = runProgram(arguments, {in, out, err});
  EXPECT_TRUE(exit >= 0 ? code == exit : code == 2 || code == 3) << out.str() << err.str();
  return out.str();
}

// What no pointer is made of: a pointer without the type of its elements, the number of a block, what a pointer finds.
TEST(Gaps, WhatHasNoPointer) {
  for (const char* actual : {"P#M 4.0", "#d", "MW [MD 4]", "W [AR1,P#0.0]", "T [MW 4]"}) {
    const test::TemporaryFolder folder;
    folder.file("main.awl",
                std::string("DATA_BLOCK DB 1\nSTRUCT\n  a : INT;\nEND_STRUCT;\nBEGIN\nEND_DATA_BLOCK\n"
                            "FUNCTION FC 5 : VOID\nVAR_INPUT\n  p : ANY;\nEND_VAR\nBEGIN\nNETWORK\nSET;\n= Q 0.0;\n"
                            "END_FUNCTION\nFUNCTION FC 6 : VOID\nVAR_INPUT\n  d : BLOCK_DB;\nEND_VAR\nBEGIN\nNETWORK\n"
                            "CALL FC 5 (p := ") +
                    actual +
                    ");\nEND_FUNCTION\nORGANIZATION_BLOCK OB 1\n//@ prove on: Q0.0\n//@ prove off: not Q0.0\nBEGIN\n"
                    "NETWORK\nCALL FC 6 (d := DB 1);\nEND_ORGANIZATION_BLOCK\n");
    const std::string proof = outputOf({"prove", folder.path("main.awl"), "--isolated", "--dialect", "s7-300"});
    EXPECT_EQ(proof.find("PROVED"), std::string::npos) << actual << proof;
    EXPECT_NE(proof.find("NOT COVERED  on"), std::string::npos) << actual << proof;
  }
}

// Blocks of the system that change more than the places that their calls name.
TEST(Gaps, BlocksOfTheSystem) {
  for (const char* call :
       {"CALL SFC 22 (LOW_LIMIT := W#16#5, UP_LIMIT := W#16#9, COUNT := W#16#4, RET_VAL := MW 4, DB_NUMBER := MW 6);",
        "CALL SFC 61 (CIRCLE_ID := B#16#1, BLOCK_ID := B#16#1, RET_VAL := MW 4);",
        "CALL SFB 46, DB 5 (LADDR := W#16#300, CHANNEL := 0);"}) {
    const test::TemporaryFolder folder;
    folder.file("main.awl", std::string("ORGANIZATION_BLOCK OB 1\n//@ prove off: not Q0.0\n//@ prove on: Q0.0\nBEGIN\n"
                                        "NETWORK\nSET;\n= Q 0.0;\n") +
                                call + "\nEND_ORGANIZATION_BLOCK\n");
    const std::string proof = outputOf({"prove", folder.path("main.awl"), "--isolated", "--dialect", "s7-300"});
    EXPECT_EQ(proof.find("PROVED"), std::string::npos) << call << proof;
    EXPECT_NE(proof.find("NOT COVERED  on"), std::string::npos) << call << proof;
  }
}

// What stands in the instance of an SFB that no table describes, by whatever way it is reached.
TEST(Gaps, DataOfUnknownInstances) {
  for (const char* access :
       {"L DB41.DBW 4;", "OPN DB 41;", "OPN DI 41;", "L \"DB41\".x;", "L 41;\nT MW 4;\nOPN DB [MW 4];",
        "CALL SFC 20 (SRCBLK := P#DB41.DBX 0.0 BYTE 2, RET_VAL := MW 4, DSTBLK := P#M 6.0 BYTE 2);"}) {
    const test::TemporaryFolder folder;
    folder.file("main.awl", std::string("DATA_BLOCK DB 41\nSFB 41\nBEGIN\nEND_DATA_BLOCK\nORGANIZATION_BLOCK OB 1\n"
                                        "//@ prove off: not Q0.0\nBEGIN\nNETWORK\nCALL SFB 41, DB 41 (MAN_ON := M "
                                        "0.0, LMN := MD 8);\n") +
                                access + "\nCLR;\n= Q 0.0;\nEND_ORGANIZATION_BLOCK\n");
    const std::string proof = outputOf({"prove", folder.path("main.awl"), "--isolated", "--dialect", "s7-300"});
    EXPECT_NE(proof.find("NOT COVERED  off"), std::string::npos) << access << proof;
  }
}

// An SFB that no table describes: every place that its call names is any value behind it, and nothing else.
TEST(Gaps, AnSfbByContract) {
  const test::TemporaryFolder folder;
  folder.file("main.awl",
              "DATA_BLOCK DB 41\nSFB 41\nBEGIN\n  GAIN := 2.0;\nEND_DATA_BLOCK\nORGANIZATION_BLOCK OB 1\n"
              "//@ prove kept: MW20 = 7\n//@ prove zero: MD8 = 0\n//@ reach some: MD8 = 5\n"
              "BEGIN\nNETWORK\nL 7;\nT MW 20;\nCALL SFB 41, DB 41 (MAN_ON := M 0.0, PV_IN := 1.5, LMN := MD 8);\n"
              "CALL SFB 41, DB 41 (LMN_PER := PQW 300);\nEND_ORGANIZATION_BLOCK\n");
  const std::string proof = outputOf({"prove", folder.path("main.awl"), "--isolated", "--dialect", "s7-300"}, 1);
  EXPECT_NE(proof.find("PROVED  kept"), std::string::npos) << proof;
  EXPECT_NE(proof.find("VIOLATED  zero"), std::string::npos) << proof;
  EXPECT_NE(proof.find("REACHABLE  some"), std::string::npos) << proof;
  EXPECT_EQ(proof.find("UNREACHABLE"), std::string::npos) << proof;
}

// A block whose declarations cannot be read counts where what depends on them is asked for: the data of FB5, but not
// the temporary data of FC5, which does nothing, and nothing to which no call leads.
TEST(Gaps, DeclarationsOfBlocksThatNeverRun) {
  const std::string wrong =
      "FUNCTION FC 5 : VOID\nVAR_TEMP\n  a : NONE;\nEND_VAR\nBEGIN\nNETWORK\nNOP 0;\nEND_FUNCTION\n";
  const std::string wrongFb =
      "FUNCTION_BLOCK FB 5\nVAR\n  a : NONE;\nEND_VAR\nBEGIN\nNETWORK\nNOP 0;\nEND_FUNCTION_BLOCK\n";
  const std::string instance = "DATA_BLOCK DB 5\nFB 5\nBEGIN\nEND_DATA_BLOCK\n";
  const auto proofOf = [](const std::string& blocks, const std::string& statements) {
    const test::TemporaryFolder folder;
    folder.file("main.awl", blocks +
                                "ORGANIZATION_BLOCK OB 1\n//@ prove off: not Q0.0\nBEGIN\nNETWORK\nCLR;\n= Q 0.0;\n" +
                                statements + "\nEND_ORGANIZATION_BLOCK\n");
    std::istringstream in;
    std::ostringstream out, err;
    runProgram({"prove", folder.path("main.awl"), "--isolated", "--dialect", "s7-300"}, {in, out, err});
    return out.str() + err.str();
  };
  for (const std::string& idle : {wrong, wrongFb}) {
    const std::string proof = proofOf(idle, "NOP 0;");
    EXPECT_NE(proof.find("PROVED  off"), std::string::npos) << proof;
    EXPECT_NE(proof.find("NONE"), std::string::npos) << proof;
  }
  for (const std::string call : {"CALL FC 5;", "A I 0.0;CC FC [MW 10];"}) {
    const std::string proof = proofOf(wrong, call);
    EXPECT_NE(proof.find("PROVED  off"), std::string::npos) << call << proof;
  }
  const std::pair<std::string, std::string> used[] = {{wrongFb + instance, "L DB5.DBW 0;"},
                                                      {wrongFb + instance, "CALL FB 5, DB 5;"}};
  for (const auto& [blocks, statements] : used) {
    const std::string proof = proofOf(blocks, statements);
    EXPECT_NE(proof.find("NOT COVERED  off"), std::string::npos) << statements << proof;
  }
}

// What a block that is called by a number does not model counts like that of any other.
TEST(Gaps, BlocksCalledByNumber) {
  const test::TemporaryFolder folder;
  folder.file("main.awl",
              "FUNCTION FC 5 : VOID\nBEGIN\nNETWORK\nCALL FC 99;\nEND_FUNCTION\nORGANIZATION_BLOCK OB 1\n"
              "//@ prove off: not Q0.0\nBEGIN\nNETWORK\nL 5;\nT MW 10;\nUC FC [MW 10];\nEND_ORGANIZATION_BLOCK\n");
  const std::string proof = outputOf({"prove", folder.path("main.awl"), "--isolated", "--dialect", "s7-300"});
  EXPECT_NE(proof.find("NOT COVERED  off"), std::string::npos) << proof;
}

TEST(Gaps, NothingThatDependsOnOneIsProvedOrEqual) {
  std::size_t rows = 0;
  for (const GapCase& c : gapCases()) {
    SCOPED_TRACE(s7300::gapRows()[static_cast<std::size_t>(c.gap)].subject);
    EXPECT_EQ(static_cast<std::size_t>(c.gap), rows++) << "a case for each row, in their order";
    const test::TemporaryFolder folder;
    const auto ob1 = [&](const std::string& last) {
      return c.blocks + "ORGANIZATION_BLOCK OB 1\n//@ prove off: not Q0.0\n//@ prove on: Q0.0\nBEGIN\nNETWORK\n" +
             c.statements + "\nA I 0.0;\n= Q 4.0;\n" + last + "END_ORGANIZATION_BLOCK\n";
    };
    folder.file("main.awl", ob1(""));
    folder.file("other.awl", ob1("NETWORK\nNOP 0;\n"));
    if (!c.content.empty()) folder.file(c.file, c.content);
    std::vector<std::string> prove = {"prove", folder.path("main.awl")};
    if (!c.content.empty()) prove.push_back(folder.path(c.file));
    prove.insert(prove.end(), {"--isolated", "--dialect", "s7-400"});
    const std::string proof = outputOf(prove);
    EXPECT_EQ(proof.find("PROVED"), std::string::npos) << proof;
    EXPECT_NE(proof.find("NOT COVERED  off"), std::string::npos) << proof;
    EXPECT_NE(proof.find("NOT COVERED  on"), std::string::npos) << proof;
    const std::string equality =
        outputOf({"equiv", folder.path("main.awl"), folder.path("other.awl"), "--isolated", "--dialect", "s7-400"});
    EXPECT_EQ(equality.find("EQUAL"), std::string::npos) << equality;
  }
  EXPECT_EQ(rows, s7300::gapRows().size());
}

}  // namespace
}  // namespace rungproof
