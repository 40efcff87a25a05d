// Calls out of their frames: shapes of the compiler become CALL, all else stays as it is.
#include <gtest/gtest.h>

#include "frontend/mc7/block_source.hpp"
#include "tests/mc7/code_round.hpp"

namespace rungproof {
namespace {

using mc7::StoredBlock;
using step7::BlockKind;

/// Statements, one a line, as one network.
StoredBlock blockOf(step7::BlockKey key, const std::string& declaration, const std::vector<std::string>& statements) {
  StoredBlock block;
  block.key = key;
  block.declarationText = declaration;
  std::vector<step7::Statement> read;
  std::vector<std::unique_ptr<std::string>> kept;
  for (const std::string& text : statements) {
    const std::string& one = *kept.emplace_back(std::make_unique<std::string>(text + " ;"));
    step7::Cursor cursor(one, 0);
    std::vector<Span> remarks;
    read.push_back(step7::readStatement(cursor, {step7::MnemonicSet::International, TextEncoding::Utf8}, remarks));
  }
  const mc7::AssembledCode code = mc7::assemble(read, {});
  EXPECT_EQ(code.fault, "");
  block.code = code.bytes + std::string("\x65\0", 2);
  return block;
}

const char* const pumpInterface =
    "VAR_INPUT\n On : BOOL ;\n Speed : INT ;\nEND_VAR\nVAR_OUTPUT\n Runs : BOOL ;\nEND_VAR\nVAR\n N : INT ;\nEND_VAR\n";

/// The text of the last block.
std::string textBeside(StoredBlock caller) {
  const std::vector<StoredBlock> blocks = {
      blockOf({BlockKind::Fb, 5}, pumpInterface, {}),
      blockOf({BlockKind::Fc, 7}, "VAR_INPUT\n A : BOOL ;\n B : INT ;\nEND_VAR\nVAR_OUTPUT\n C : INT ;\nEND_VAR\n", {}),
      blockOf({BlockKind::Fc, 8}, "VAR_INPUT\n P : ANY ;\n T : TIMER ;\nEND_VAR\n", {}),
      blockOf({BlockKind::Fc, 9},
              "VAR_INPUT\n TV : S5TIME ;\nEND_VAR\nVAR_IN_OUT\n D : STRUCT\n  a : BOOL ;\n END_STRUCT ;\nEND_VAR\n",
              {}),
      blockOf({BlockKind::Fc, 10}, "VAR_INPUT\n D : DATE_AND_TIME ;\nEND_VAR\n", {}),
      std::move(caller)};
  return mc7::sourcesOf(blocks, false).back().text;
}

void expectHas(const std::string& text, std::string_view part) {
  EXPECT_NE(text.find(part), std::string::npos) << part << "\n" << text;
}
void expectLacks(const std::string& text, std::string_view part) {
  EXPECT_EQ(text.find(part), std::string::npos) << part << "\n" << text;
}

const step7::BlockKey main{BlockKind::Ob, 1};

TEST(Mc7Calls, FunctionWithCopies) {
  const std::string text =
      textBeside(blockOf(main, "",
                         {"BLD 1", "= L 20.0", "OPN DB 3", "A DBX 1.2", "= L 20.1", "L 5", "T LW 22",
                          "UC FC 7 {P#V 20.1, P#V 22.0, P#V 24.0}", "L LW 24", "OPN DB 4", "T DBW 6", "BLD 2"}));
  expectHas(text, "CALL  FC 7 (A := DB3.DBX 1.2, B := 5, C := DB4.DBW 6) ;");
  expectLacks(text, "BLD");
  expectLacks(text, "L 20.0");
}

// The bit saved behind the first BLD is read later: the statement stays.
TEST(Mc7Calls, SavedBitThatIsReadStays) {
  const std::string text = textBeside(
      blockOf(main, "", {"BLD 1", "= L 20.0", "UC FC 7 {P#I 0.0, P#M 2.0, P#M 4.0}", "BLD 2", "A L 20.0", "= Q 0.0"}));
  expectHas(text, "=     L 20.0 ;");
  expectHas(text, "CALL  FC 7 (A := I 0.0, B := MW 2, C := MW 4) ;");
}

TEST(Mc7Calls, AnyAndTimer) {
  const std::string text =
      textBeside(blockOf(main, "",
                         {"BLD 1", "= L 20.0", "L W#16#1002", "T LW 22", "L 10", "T LW 24", "L 9", "T LW 26",
                          "L P#DBX 4.0", "T LD 28", "UC FC 8 {P#V 22.0, DW#16#50000}", "BLD 2"}));
  expectHas(text, "CALL  FC 8 (P := P#DB9.DBX 4.0 BYTE 10, T := T 5) ;");
}

// Area V in a pointer is the caller's local data: by its name where the type fits, else as P#L.
TEST(Mc7Calls, LocalDataByPointer) {
  const std::string declaration =
      "VAR_TEMP\n i : INT ;\n at : DATE_AND_TIME ;\n s : STRUCT\n  x : DWORD ;\n END_STRUCT ;\n"
      "END_VAR\n";
  const std::string date = textBeside(
      blockOf({BlockKind::Fc, 6}, declaration,
              {"BLD 1", "= L 20.0", "L 0", "T LW 22", "L P#V 2.0", "T LD 24", "UC FC 10 {P#V 22.0}", "BLD 2"}));
  expectHas(date, "CALL  FC 10 (D := #at) ;");
  for (const auto& [bytes, actual] : {std::pair{"L 4", "P := #s,"}, {"L 3", "P := P#L 10.0 BYTE 3,"}}) {
    const std::string any =
        textBeside(blockOf({BlockKind::Fc, 6}, declaration,
                           {"BLD 1", "= L 20.0", "L W#16#1002", "T LW 22", bytes, "T LW 24", "L 0", "T LW 26",
                            "L P#V 10.0", "T LD 28", "UC FC 8 {P#V 22.0, DW#16#50000}", "BLD 2"}));
    expectHas(any, actual);
  }
}

// Data of the block's own instance: its number is DINO, its place AR2 and an offset.
TEST(Mc7Calls, OwnInstanceByPointer) {
  const std::vector<std::string> statements = {
      "BLD 1",      "= L 20.0", "TAR2 LD 30", "L W#16#1002", "T LW 22",    "L 6",     "T LW 24",
      "L DINO",     "T LW 26",  "+AR2 P#2.0", "TAR2",        "LAR2 LD 30", "T LD 28", "UC FC 8 {P#V 22.0, DW#16#50000}",
      "LAR2 LD 30", "BLD 2"};
  const std::string declaration = "VAR\n n : INT ;\n list : ARRAY [1 .. 6] OF BYTE ;\nEND_VAR\n";
  expectHas(textBeside(blockOf({BlockKind::Fb, 6}, declaration, statements)), "CALL  FC 8 (P := #list, T := T 5) ;");
  // Of another block's data the same statements stay what they are.
  std::vector<std::string> foreign = statements;
  foreign.insert(foreign.begin() + 7, "OPN DI 4");
  expectHas(textBeside(blockOf({BlockKind::Fb, 6}, declaration, foreign)), "UC    FC 8 {P#V 22.0, ");
}

// An ANY that the block has filled itself is handed on by its name.
TEST(Mc7Calls, OwnAnyIsHandedOn) {
  const std::string text = textBeside(blockOf({BlockKind::Fc, 6}, "VAR_TEMP\n n : INT ;\n any : ANY ;\nEND_VAR\n",
                                              {"BLD 1", "= L 20.0", "UC FC 8 {P#V 2.0, DW#16#50000}", "BLD 2"}));
  expectHas(text, "CALL  FC 8 (P := #any, T := T 5) ;");
}

// In a function block AR2 is kept around a call that hands a structure over by its pointer. 16#1100 is 100 x 100 ms.
TEST(Mc7Calls, StructureInAFunctionBlock) {
  const std::string text =
      textBeside(blockOf({BlockKind::Fb, 6}, "VAR\n N : INT ;\nEND_VAR\n",
                         {"BLD 1", "= L 18.0", "TAR2 LD 19", "L 4352", "T LW 24", "L 11", "T LW 26", "L P#DBX 6.0",
                          "T LD 28", "UC FC 9 {P#V 24.0, P#V 26.0}", "LAR2 LD 19", "BLD 2"}));
  expectHas(text, "CALL  FC 9 (TV := S5T#10S, D := P#DB11.DBX 6.0) ;");
  expectLacks(text, "AR2");
}

// 10 s in the base of 1 s, 16#2010, has no S5T of its own: S5T#10S means 16#1100. A word that is no S5TIME stays.
TEST(Mc7Calls, TimesInAnotherBaseStayWords) {
  for (const auto& [load, word] : {std::pair{"L W#16#2010", "W#16#2010"}, {"L W#16#00AB", "W#16#AB"}}) {
    const std::string text = textBeside(blockOf(main, "",
                                                {"BLD 1", "= L 18.0", load, "T LW 24", "L 11", "T LW 26", "L P#DBX 6.0",
                                                 "T LD 28", "UC FC 9 {P#V 24.0, P#V 26.0}", "BLD 2"}));
    expectHas(text, std::string("CALL  FC 9 (TV := ") + word);
  }
}

TEST(Mc7Calls, InstanceBlock) {
  const std::string text = textBeside(blockOf(
      main, "",
      {"BLD 3", "= L 20.0", "CDB", "OPN DI 30", "TAR2 LD 22", "A I 0.1", "= DIX 0.0", "OPN DI 12", "L DIW 8",
       "OPN DI 30", "T DIW 2", "LAR2 P#DBX 0.0", "UC FB 5", "LAR2 LD 22", "A DIX 4.0", "= Q 0.1", "CDB", "BLD 4"}));
  expectHas(text, "CALL  FB 5, DB30 (On := I 0.1, Speed := DB12.DBW 8, Runs := Q 0.1) ;");
}

// A parameter that the call leaves out is left out.
TEST(Mc7Calls, MultiInstance) {
  const std::string text = textBeside(
      blockOf({BlockKind::Fb, 6}, "VAR_INPUT\n Go : BOOL ;\nEND_VAR\nVAR\n Pump : FB 5 ;\nEND_VAR\n",
              {"BLD 14", "= L 0.0", "L DINO", "T LW 2", "CDB", "OPN DI [LW 2]", "TAR2 LD 4", "A DBX [AR2,P#0.0]",
               "= DIX [AR2,P#2.0]", "+AR2 P#2.0", "UC FB 5", "LAR2 LD 4", "CDB", "BLD 15"}));
  expectHas(text, "CALL  #Pump (On := #Go) ;");
}

// One statement more than the compiler writes: nothing is taken for a call, and the list alone is read.
TEST(Mc7Calls, OtherStatementsStay) {
  const std::string text = textBeside(blockOf(
      main, "", {"BLD 1", "= L 20.0", "L 5", "INC 1", "T LW 22", "UC FC 7 {P#I 0.0, P#V 22.0, P#M 4.0}", "BLD 2"}));
  for (const char* part :
       {"BLD   1", "=     L 20.0", "INC   1", "CALL  FC 7 (A := I 0.0, B := LW 22, C := MW 4)", "BLD   2"})
    expectHas(text, part);
}

// Comments stand behind the statements of their lines: a call has a line more for each of its three parameters.
TEST(Mc7Calls, CommentsOfLines) {
  StoredBlock block = blockOf(main, "",
                              {"BLD 1", "= L 20.0", "UC FC 7 {P#I 0.0, P#M 2.0, P#M 4.0}", "BLD 2", "A I 0.1",
                               "OPN DB 3", "A DBX 1.2", "= Q 0.0"});
  block.networkTexts = {
      {"",
       "",
       {{2, true, false, "of A"}, {5, true, false, "beside"}, {6, true, true, "opened"}, {8, false, false, "alone"}}}};
  const std::string text = textBeside(block);
  expectHas(text, "CALL  FC 7 (A := I 0.0, B := MW 2, C := MW 4) ; //of A\n");
  expectHas(text, "A     I 0.1 ; //beside\n");
  expectHas(text, "OPN   DB 3 ; //opened\n      A     DBX 1.2 ;\n      =     Q 0.0 ;\n//alone\n");
}

// Behind a call whose lines nobody can count, no comment is put beside a statement; none is lost.
TEST(Mc7Calls, CommentsBehindAnUnknownCall) {
  StoredBlock block = blockOf(main, "", {"A I 0.1", "BLD 1", "= L 20.0", "UC FC 99 {P#I 0.0}", "BLD 2", "A I 0.2"});
  block.networkTexts = {{"", "", {{1, true, false, "first"}, {4, true, false, "second"}}}};
  const std::string text = textBeside(block);
  expectHas(text, "A     I 0.1 ; //first\n");
  expectHas(text, "A     I 0.2 ;\n//second\n");
}

// A callee that nobody knows keeps its list.
TEST(Mc7Calls, UnknownCalleeKeepsItsList) {
  const std::string text = textBeside(blockOf(main, "", {"BLD 1", "= L 20.0", "UC FC 99 {P#I 0.0}", "BLD 2"}));
  expectHas(text, "UC    FC 99 {P#I 0.0}");
}

}  // namespace
}  // namespace rungproof
