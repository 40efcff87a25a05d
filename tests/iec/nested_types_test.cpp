// Types and instances that stand in each other: what is too deep, too large or too many is refused with a message, and
// takes no longer than what is read.
#include <fmt/format.h>

#include "tests/iec/iec_run.hpp"

namespace rungproof {
namespace {

/// Types one in the other, the last one an INT.
std::string structuresOf(int levels, std::string_view fields) {
  std::string text = "TYPE\n";
  for (int i = 1; i < levels; ++i)
    text += fmt::format("S{} : STRUCT {} END_STRUCT;\n", i, fmt::format(fmt::runtime(fields), i + 1));
  return text + fmt::format("S{} : STRUCT a : INT; END_STRUCT;\nEND_TYPE\n", levels);
}

std::string blocksOf(int levels, std::string_view variables) {
  std::string text;
  for (int i = 1; i < levels; ++i)
    text += fmt::format("FUNCTION_BLOCK F{} VAR {} END_VAR END_FUNCTION_BLOCK\n", i,
                        fmt::format(fmt::runtime(variables), i + 1));
  return text + fmt::format("FUNCTION_BLOCK F{} VAR a : INT; END_VAR a := 1; END_FUNCTION_BLOCK\n", levels);
}

const std::string withStructure = "PROGRAM m VAR x : S1; q : BOOL; END_VAR q := TRUE; END_PROGRAM\n";
const std::string withInstance = "PROGRAM m VAR x : F1; q : BOOL; END_VAR x(); END_PROGRAM\n";

bool isTold(const std::string& text, std::string_view part) {
  const std::string findings = findingsIec(readIecText(text));
  return findings.find(part) != std::string::npos;
}

TEST(IecNestedTypes, ALongChainIsRefused) {
  EXPECT_TRUE(isTold(structuresOf(5000, "a : S{};") + withStructure, "stands in 200 types that contain each other"));
  EXPECT_EQ(findingsIec(readIecText(structuresOf(100, "a : S{};") + withStructure)), "");
}

TEST(IecNestedTypes, DoublingTypesEndAtTheMemory) {  // 2 bytes doubled 59 times
  EXPECT_TRUE(isTold(structuresOf(60, "a, b : S{};") + withStructure, "the type has more than 1048576 bytes"));
}

TEST(IecNestedTypes, ArraysOfArraysEndAtTheMemory) {  // 65536 * 65536 * 2 bytes are 0 modulo 2^32
  EXPECT_TRUE(
      isTold("PROGRAM m VAR x : ARRAY[0..65535] OF ARRAY[0..65535] OF INT; q : BOOL; END_VAR q := TRUE; "
             "END_PROGRAM\n",
             "the type has more than 1048576 bytes"));
}

TEST(IecNestedTypes, VariablesBeyondTheMemoryAreTold) {
  EXPECT_TRUE(isTold("PROGRAM m VAR x, y, z : ARRAY[0..199999] OF INT; q : BOOL; END_VAR q := TRUE; END_PROGRAM\n",
                     "all variables together have more than 1048576 bytes"));
}

TEST(IecNestedTypes, DoublingInstancesAreRefused) {
  EXPECT_TRUE(isTold(blocksOf(20, "a, b : F{};") + withInstance, "the program has more than 50000 instances"));
  EXPECT_TRUE(isTold(blocksOf(60, "a, b : F{};") + withInstance, "stand in more than 32 others"));
}

TEST(IecNestedTypes, MoreInitialValuesThanElementsAreTold) {
  EXPECT_TRUE(isTold("PROGRAM m VAR x : ARRAY[0..9] OF INT := [20(1)]; q : BOOL; END_VAR q := x[0] = 1; END_PROGRAM\n",
                     "20 initial values are given for 10 elements"));
  EXPECT_TRUE(
      isTold("PROGRAM m VAR x : ARRAY[0..9] OF INT := [9(1), 2, 3]; q : BOOL; END_VAR q := x[0] = 1; "
             "END_PROGRAM\n",
             "11 initial values are given for 10 elements"));
  EXPECT_EQ(findingsIec(readIecText(
                "PROGRAM m VAR x : ARRAY[0..9] OF INT := [9(1), 2]; q : BOOL; END_VAR q := x[0] = 1; END_PROGRAM\n")),
            "");
}

TEST(IecNestedTypes, NumbersBeyondTheirTypeAreTold) {  // the largest REAL is 3.4E38, the largest LREAL 1.8E308
  const auto assigning = [](const std::string& number) {
    return "PROGRAM m VAR r : REAL; l : LREAL; END_VAR " + number + "; END_PROGRAM\n";
  };
  EXPECT_TRUE(isTold(assigning("r := 1.0E39"), "too large for REAL"));
  EXPECT_TRUE(isTold(assigning("r := REAL#1.0E39"), "1.0E39 is too large for REAL"));
  EXPECT_TRUE(isTold(assigning("l := 1.0E309"), "1.0E309 is too large for LREAL"));
  EXPECT_TRUE(isTold("PROGRAM m VAR r : REAL := 1.0E39; END_VAR r := r; END_PROGRAM\n", "too large for REAL"));
  EXPECT_EQ(findingsIec(readIecText(assigning("l := 1.0E39; r := 3.4E38"))), "");
}

TEST(IecNestedTypes, ALongChainOfCallsIsRefused) {
  std::string text;
  for (int i = 1; i < 20'000; ++i)
    text += fmt::format("FUNCTION G{0} : INT VAR_INPUT x : INT; END_VAR G{0} := G{1}(x); END_FUNCTION\n", i, i + 1);
  text += "FUNCTION G20000 : INT VAR_INPUT x : INT; END_VAR G20000 := x; END_FUNCTION\n";
  EXPECT_TRUE(isTold(text + "PROGRAM m VAR q : INT; END_VAR q := G1(1); END_PROGRAM\n", "calls are nested too deeply"));
}

TEST(IecNestedTypes, ABlockInItselfIsNamed) {
  EXPECT_TRUE(
      isTold("FUNCTION_BLOCK A VAR b : B; END_VAR END_FUNCTION_BLOCK\n"
             "FUNCTION_BLOCK B VAR a : ARRAY[0..1] OF A; END_VAR END_FUNCTION_BLOCK\n"
             "PROGRAM m VAR x : A; END_VAR x(); END_PROGRAM\n",
             "contain each other"));
}

// The copy is of one element: its own parts, which an index may read, do not move it half way.
TEST(IecNested, TheIndexOfACopiedStructureIsComputedOnce) {
  const auto seen = [](const std::string& statement, const std::string& name) {
    IecRun run("TYPE row : STRUCT a, b, c : INT; END_STRUCT; END_TYPE\n" +
               iecProgram("VAR s, t : row; rows : ARRAY [0..1] OF row; END_VAR",
                          "s.a := 1; s.b := 1; s.c := 5; t.b := 0; rows[0].b := 0; rows[0].c := 7; rows[1].c := 8;\n" +
                              statement));
    run.scan();
    return run.get(name);
  };
  EXPECT_EQ(seen("rows[rows[0].b] := s;", "rows[0].c"), 5);
  EXPECT_EQ(seen("rows[rows[0].b] := s;", "rows[1].c"), 8);
  EXPECT_EQ(seen("rows[0].b := 1; t := rows[t.b];", "t.c"), 7);
}

}  // namespace
}  // namespace rungproof
