// What is read, printed and read again has the same instructions: all projects, the rows of all instructions and the
// stated cases, in both sets of mnemonics.
#include "frontend/step7/source_writer.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "ir/s7300/fbd_box.hpp"
#include "read7.hpp"

namespace rungproof {
namespace {

using step7::MnemonicSet;

/// Everything of the instructions but names of addresses and places in the text.
std::string instructionsOf7(const Program& program) {
  std::string text;
  for (const Pou& pou : program.pous) {
    text += fmt::format("\nblock {} locals {}", pou.number, pou.localBytes);
    for (const Network& network : pou.networks) {
      text += "\n  network";
      for (const Instruction& instruction : network.instructions) {
        text += fmt::format("\n    {}", instruction.desc->stl);
        const bool isCall = instruction.desc->control == Control::BlockCall;
        for (std::size_t i = 0; i < instruction.operands.size(); ++i) {
          Operand operand = instruction.operands[i];
          if (isCall && i == 0 && operand.kind == OperandKind::Constant) operand.text = "";
          text += fmt::format(" {}/{}/{}", show7(operand), static_cast<int>(operand.kind), operand.value);
        }
      }
    }
  }
  return text;
}

ReadOptions optionsOf(const Program& program, MnemonicSet set) {
  ReadOptions options;
  options.dialect = "s7-300";
  options.mnemonics = set == MnemonicSet::German ? Mnemonics::German : Mnemonics::International;
  options.target = program.target;
  return options;
}

void expectReturns(const Program& program, const std::string& what) {
  const std::string before = instructionsOf7(program);
  for (const MnemonicSet set : {MnemonicSet::International, MnemonicSet::German}) {
    const std::string text = step7::writeSource(program, set);
    const Program again = read7(text, optionsOf(program, set));
    EXPECT_EQ(instructionsOf7(again), before) << what << "\n" << findings7(again) << "\n" << text;
  }
}

TEST(SourceWriter7, ProjectsComeBackTheSame) {
  int projects = 0;
  for (const auto& entry : std::filesystem::directory_iterator(RUNGPROOF_SOURCE_DIR "/tests/data/s7300_projects")) {
    std::vector<std::string> files;
    for (const auto& file : std::filesystem::recursive_directory_iterator(entry)) files.push_back(file.path().string());
    const Program program = readProgram(files, {});
    ASSERT_GT(program.instructionCount(), 5U) << entry.path();
    expectReturns(program, entry.path().filename());
    ++projects;
  }
  EXPECT_GE(projects, 10);
}

TEST(SourceWriter7, EveryFormOfOperand) {
  const Program program = read7(R"(
FUNCTION_BLOCK FB 2
VAR_INPUT
  on : BOOL ;
  preset : S5TIME := S5T#2S ;
  clock : TIMER ;
  list : ARRAY [1 .. 3] OF INT := 1, 2, 3 ;
END_VAR
VAR_OUTPUT
  done : BOOL ;
END_VAR
VAR
  part : STRUCT
    a : INT ;
    b : BOOL ;
  END_STRUCT ;
END_VAR
VAR_TEMP
  help : WORD ;
END_VAR
BEGIN
NETWORK
  A #on; L #preset; SD #clock; L #list[2]; T #part.a; S #part.b; = #done; T #help;
END_FUNCTION_BLOCK
FUNCTION FC 4 : INT
VAR_INPUT
  block : BLOCK_DB ;
  number : INT ;
END_VAR
BEGIN
NETWORK
  OPN #block; L #number; T #RET_VAL;
END_FUNCTION
DATA_BLOCK DB 2
FB 2
BEGIN
END_DATA_BLOCK
DATA_BLOCK DB 10
STRUCT
  w : WORD ;
  b : ARRAY [0 .. 9] OF BYTE ;
END_STRUCT ;
BEGIN
END_DATA_BLOCK
ORGANIZATION_BLOCK OB 1
VAR_TEMP
  start : ARRAY [0 .. 19] OF BYTE ;
  pointer : DWORD ;
  number : WORD ;
END_VAR
BEGIN
NETWORK
  CALL FB 2, DB 2 (on := I 0.0, clock := T 3, done := Q 4.0);
  CALL FC 4 (block := DB 10, number := 5, RET_VAL := MW 2);
  UC FC [#number]; CC FC [MW 10];
  OPN DB 10; OPN DI 2; OPN DB [MW 4]; OPN DI [#number];
  A DBX 0.1; L DIW 2; L DB10.DBW 0; L PIW 256; T PQW 256;
  A I [MD 4]; L DBB [#pointer]; A T [MW 2]; L C [#number];
  L MW [AR1,P#2.0]; L W [AR2,P#0.0]; A M [AR1,P#3.7]; L DID [AR2,P#4.0];
  LAR1 P#I 0.0; LAR2 P#DBX 4.0; +AR1 P#2.0; LAR1 MD 8; TAR2 MD 12; L P#M 10.0;
NETWORK
  A(; A BR; O; AN ==0; ); = L 20.0; BLD 103; NOP 0;
  L B#(1,2,3,4); L 'ab'; L S5T#1H2M; L T#-5S; L C#123; L L#-70000; L 2#1010; L DW#16#FFFF_FFFF; L 1.5e-3; + -5; L D#1994-12-1;
  JL end; JU one; JU two;
end: JU two;
one: LOOP one;
two: BEC; S C 3; FR T 1; LC C 2; R T 1; CD C 4; SE T 2;
  L STW; T STW; LAR1 AR2; TAR1; SSI 4; INC 1;
END_ORGANIZATION_BLOCK
)");
  EXPECT_EQ(findings7(program), "");
  expectReturns(program, "forms");
  const std::string german = step7::writeSource(program, MnemonicSet::German);
  for (const char* wanted : {"on := E0.0", "SPL    end", "UN     ==0", "U      BIE", "U(", "PEW256", "PAW256",
                             "P#E 0.0", "SV     T2", "LC     Z2", "ZR     Z4", "AUF    DB 10", "U      T [MW2]"}) {
    EXPECT_NE(german.find(wanted), std::string::npos) << wanted << "\n" << german;
  }
}

TEST(SourceWriter7, StatementsOfAllCases) {
  std::ifstream in(RUNGPROOF_SOURCE_DIR "/tests/data/s7300_cases.tsv");
  int programs = 0;
  for (std::string line; std::getline(in, line);) {
    if (line.empty() || line[0] == '#') continue;
    std::stringstream cells(line);
    std::string row, number, text;
    std::getline(cells, row, '\t');
    std::getline(cells, number, '\t');
    std::getline(cells, text, '\t');
    if (text.find_first_of("{@|") != std::string::npos || text.find("DB") != std::string::npos) continue;
    const Program program = readOb1("  " + text + ";");
    if (!program.findings.empty()) continue;
    expectReturns(program, text);
    ++programs;
  }
  EXPECT_GT(programs, 1000);
}

TEST(SourceWriter7, Titles) {
  const Program program = read7("FUNCTION \"Sum\" : VOID\nTITLE = adds\nBEGIN\nNETWORK\n  NOP 0;\nEND_FUNCTION\n");
  EXPECT_EQ(step7::blockTitle(readOb1("NOP 0;").pous.at(0)), "OB1");
  EXPECT_TRUE(program.pous.empty() || step7::blockTitle(program.pous[0]).find("\"Sum\"") != std::string::npos);
}

}  // namespace
}  // namespace rungproof
