// Networks of the S7-300/400 as drawings: expected shapes are written out from what the statements mean (003:1213).
#include "analysis/drawing/raise_step7.hpp"

#include <gtest/gtest.h>

#include <set>

#include "frontend/input/project.hpp"

namespace rungproof {
namespace {

std::string shapeOf7(const Drawing& drawing, std::uint32_t i) {
  const Element& element = drawing.elements[i];
  std::string inside;
  for (const Wire& wire : element.inputs) {
    if (wire.from != 0) inside += (inside.empty() ? "" : ", ") + shapeOf7(drawing, wire.from);
  }
  std::string operands;
  for (const Operand& operand : element.operands)
    operands += (operands.empty() ? "" : " ") + (operand.kind == OperandKind::Missing ? "-" : toString(operand));
  switch (element.shape) {
    case Shape::And: return "and(" + inside + ")";
    case Shape::Or: return "or(" + inside + ")";
    case Shape::Coil: return std::string(element.desc->stl) + " " + operands + " <- " + inside;
    default: break;
  }
  if (element.desc->role == Role::Not) return "not(" + inside + ")";
  if (!inside.empty()) return std::string(element.desc->stl) + " " + operands + "(" + inside + ")";
  if (element.operands.size() == 2) return std::string(element.desc->stl) + " " + operands;
  return (element.desc->negated ? "!" : "") + operands;
}

/// Coils with what feeds them, or the reason why there is no drawing.
std::string drawn7(const std::string& statements, Form form = Form::Ladder) {
  const Program program =
      readText("x.awl", "ORGANIZATION_BLOCK OB 1\nBEGIN\nNETWORK\n" + statements + "\nEND_ORGANIZATION_BLOCK\n");
  const Raised raised = raise(program.pous.at(0).networks.at(0), form, program.target);
  if (!raised.drawing) return "- " + raised.reason;
  std::string text;
  const std::vector<Element>& elements = raised.drawing->elements;
  for (std::uint32_t i = 0; i < elements.size(); ++i) {
    const bool isLastBox = elements[i].shape == Shape::Box && i + 1 == elements.size();
    if (elements[i].shape == Shape::Coil || isLastBox)
      text += (text.empty() ? "" : "; ") + shapeOf7(*raised.drawing, i);
  }
  return text;
}

// DB 9 is in no file: the statement is there all the same, and so is its contact. A line that is no statement is lost.
TEST(RaiseStep7, OperandsThatNoFileExplains) {
  EXPECT_EQ(drawn7("A DB9.DBX 0.1;A I 0.0;= Q 0.0;"), "= Q0.0 <- and(DB9.DBX 0.1, I0.0)");
  EXPECT_EQ(drawn7("A \"Nowhere\";= Q 0.0;"), "= Q0.0 <- \"Nowhere\"");
  EXPECT_EQ(drawn7("A I 0.0;FLY 5;= Q 0.0;"), "- a line of the network could not be read");
}

TEST(RaiseStep7, SeriesAndBranches) {
  EXPECT_EQ(drawn7("A I 0.0; AN I 0.1; = Q 4.0;"), "= Q4.0 <- and(I0.0, !I0.1)");
  EXPECT_EQ(drawn7("O I 0.0; O I 0.1; AN I 0.2; S M 0.0;"), "S M0.0 <- and(or(I0.0, I0.1), !I0.2)");
  EXPECT_EQ(drawn7("A I 0.0; A I 0.1; O; A I 0.2; A I 0.3; = Q 4.0;"),
            "= Q4.0 <- or(and(I0.0, I0.1), and(I0.2, I0.3))");
  EXPECT_EQ(drawn7("A I 0.0; O; A I 0.1; O I 0.2; = Q 4.0;"), "= Q4.0 <- or(or(I0.0, I0.1), I0.2)");
}

TEST(RaiseStep7, Parentheses) {
  EXPECT_EQ(drawn7("A(; O I 0.0; O Q 4.0; ); AN I 0.1; = Q 4.0;"), "= Q4.0 <- and(or(I0.0, Q4.0), !I0.1)");
  EXPECT_EQ(drawn7("A I 0.0; A(; O I 0.1; O I 0.2; ); = Q 4.0;"), "= Q4.0 <- and(I0.0, or(I0.1, I0.2))");
  EXPECT_EQ(drawn7("O(; A I 0.0; A I 0.1; ); O I 0.2; NOT; = Q 4.0;"), "= Q4.0 <- not(or(and(I0.0, I0.1), I0.2))");
  EXPECT_EQ(drawn7("A I 0.0; AN(; O I 0.1; O I 0.2; ); = Q 4.0;"), "= Q4.0 <- and(I0.0, not(or(I0.1, I0.2)))");
}

TEST(RaiseStep7, ComparisonsEdgesTimersCounters) {
  EXPECT_EQ(drawn7("A I 0.0; A(; L MW 2; L 5; >=I; ); = Q 4.0;"), "= Q4.0 <- and(I0.0, >=I MW2 5)");
  EXPECT_EQ(drawn7("A I 0.0; FP M 1.0; A I 0.1; S Q 4.0;"), "S Q4.0 <- and(FP M1.0(I0.0), I0.1)");
  EXPECT_EQ(drawn7("A I 0.0; L S5T#2S; SD T 1; NOP 0;"), "SD T1 S5T#2S <- I0.0");
  EXPECT_EQ(drawn7("A I 0.0; CU C 1; "), "CU C1 <- I0.0");
}

TEST(RaiseStep7, BranchesOfTheCompiler) {
  EXPECT_EQ(drawn7("A I 0.0; = L 20.0; A L 20.0; A I 0.1; = Q 4.0; A L 20.0; AN I 0.2; = Q 4.1;"),
            "= Q4.0 <- and(I0.0, I0.1); = Q4.1 <- and(I0.0, !I0.2)");
  EXPECT_EQ(drawn7("A I 0.0; = Q 4.0; = Q 4.1;"), "= Q4.0 <- I0.0; = Q4.1 <- I0.0");
}

TEST(RaiseStep7, BoxesWithEnAndEno) {
  const std::string add = "A I 0.0; JNB _001; L MW 2; L MW 4; +I; T MW 6; AN OV; SAVE; CLR; _001: A BR; ";
  EXPECT_EQ(drawn7(add + "= Q 4.0;"), "= Q4.0 <- ADD_I MW2 MW4 MW6(I0.0)");
  EXPECT_EQ(drawn7(add + "JNB _002; L MW 6; T MW 8; SET; SAVE; CLR; _002: A BR; A I 0.1; = Q 4.0;"),
            "= Q4.0 <- and(MOVE MW6 MW8(ADD_I MW2 MW4 MW6(I0.0)), I0.1)");
  // ENO is open: no bit is saved, and nothing goes on.
  EXPECT_EQ(drawn7("A I 0.0; JNB _001; L 5; T MW 8; _001: NOP 0;"), "MOVE 5 MW8(I0.0)");
  // An addition whose ENO does not look at the overflow is none of the compiler's boxes.
  EXPECT_EQ(drawn7("A I 0.0; JNB _001; L MW 2; L MW 4; +I; T MW 6; SET; SAVE; CLR; _001: A BR; = Q 4.0;"),
            "- JNB _001 has no picture in LAD or FBD");
  EXPECT_EQ(drawn7("A I 0.0; JCB _001; L 5; T MW 8; _001: NOP 0;"), "- JCB _001 has no picture in LAD or FBD");
}

TEST(RaiseStep7, BoxesOfTimersWithoutReset) {
  const std::string timer = "A I 0.0; L S5T#2S; SD T 1; NOP 0; ";
  EXPECT_EQ(drawn7(timer + "NOP 0; NOP 0; A T 1; = Q 4.0;"), "= Q4.0 <- S_ODT T1 S5T#2S - -(I0.0)");
  EXPECT_EQ(drawn7(timer + "L T 1; T MW 2; NOP 0; A T 1; AN I 0.1; = Q 4.0;"),
            "= Q4.0 <- and(S_ODT T1 S5T#2S MW2 -(I0.0), !I0.1)");
  EXPECT_EQ(drawn7(timer + "NOP 0; NOP 0; NOP 0;"), "S_ODT T1 S5T#2S - -(I0.0)");
  EXPECT_EQ(drawn7(timer + "NOP 0; NOP 0; A T 2; = Q 4.0;"), "- A T2 begins a second rung in the network");
}

TEST(RaiseStep7, WhatHasNoPicture) {
  EXPECT_EQ(drawn7("A I 0.0; = Q 4.0; A I 0.1; = Q 4.1;"), "- A I0.1 begins a second rung in the network");
  EXPECT_EQ(drawn7("X I 0.0; X I 0.1; = Q 4.0;"), "- X I0.0 has no picture in LAD or FBD");
  EXPECT_EQ(drawn7("A I 0.0;"), "- A I0.0 ends without a coil");
  EXPECT_EQ(drawn7("= Q 4.0;"), "- = Q4.0 has no logic in this network");
  EXPECT_EQ(drawn7("A I 0.0; FP M 1.0; = Q 4.0;", Form::Fbd), "- FP M1.0 has no picture here");
  EXPECT_EQ(drawn7("L MW 2; T MW 4;"), "- T MW4 stands where a comparison or a timer takes what was loaded");
  EXPECT_EQ(drawn7("A I 0.0; L MW 2; L 5; >=I; = Q 4.0;"), "- >=I has no picture here");
  EXPECT_EQ(drawn7("A I 0.0; = L 20.0; A I 0.1; = Q 4.1;"), "- A I0.1 begins a second rung in the network");
  EXPECT_EQ(drawn7("A I 0.0; = Q 4.0; = L 20.0; BLD 103;"),
            "- BLD 103 leaves an intermediate result to other networks");
  EXPECT_EQ(drawn7("A I 0.0; = L 20.0; A L 20.0; A I 0.1; A L 20.0; = Q 4.1;"),
            "- A L20.0 is an intermediate result in the middle of logic");
  EXPECT_EQ(drawn7("A OV; = Q 4.0;"), "- A OV has no picture in LAD or FBD");
}

/// The same beside FC 1 with two inputs and an output of type BOOL.
std::string drawnBeside(const std::string& statements) {
  const Program program = readText(
      "x.awl",
      "FUNCTION FC 1 : VOID\nVAR_INPUT\n  a : BOOL;\n  b : BOOL;\nEND_VAR\nVAR_OUTPUT\n  c : BOOL;\nEND_VAR\nBEGIN\n"
      "NETWORK\nA #a;\nA #b;\n= #c;\nEND_FUNCTION\nORGANIZATION_BLOCK OB 1\nVAR_TEMP\n  start : ARRAY [0 .. 19] OF "
      "BYTE;\nEND_VAR\nBEGIN\nNETWORK\n" +
          statements + "\nEND_ORGANIZATION_BLOCK\n");
  const Raised raised = raise(program.main()->networks.at(0), Form::Ladder, program.target);
  if (!raised.drawing) return "- " + raised.reason;
  std::string text;
  std::set<std::uint32_t> read;
  const std::vector<Element>& elements = raised.drawing->elements;
  for (const Element& element : elements) {
    for (const Wire& wire : element.inputs) read.insert(wire.from);
  }
  for (std::uint32_t i = 1; i < elements.size(); ++i) {
    if (read.contains(i)) continue;
    text += (text.empty() ? "" : "; ") + shapeOf7(*raised.drawing, i);
  }
  return text;
}

// A call stands at the rail, or has the logic in front of its JNB at EN. Bits that the compiler made for its pins are
// wires: I0.0 flows into a, and c flows on to Q0.0.
TEST(RaiseStep7, CallsAreBoxes) {
  EXPECT_EQ(drawnBeside("CALL FC 1 (a := I 0.0, b := I 0.1, c := Q 0.0);"), "FC1 I0.0 I0.1 Q0.0");
  EXPECT_EQ(drawnBeside("A I 0.0;A I 0.1;= L 20.0;BLD 103;CALL FC 1 (a := L 20.0, b := I 0.1, c := L 20.1);A L "
                        "20.1;= Q 0.0;"),
            "= Q0.0 <- CALL FC1 - I0.1 -(and(I0.0, I0.1))");
  EXPECT_EQ(drawnBeside("A I 0.0;= L 20.0;BLD 103;A I 0.1;= L 20.1;BLD 103;CALL FC 1 (a := L 20.0, b := L 20.1, c := Q "
                        "0.0);"),
            "CALL FC1 - - Q0.0(I0.0, I0.1)");
  EXPECT_EQ(drawnBeside("A I 0.2;JNB _001;CALL FC 1 (a := I 0.0, b := I 0.1, c := Q 0.0);_001: NOP 0;"),
            "CALL FC1 I0.0 I0.1 Q0.0(I0.2)");
  EXPECT_EQ(drawnBeside("A I 0.2;JNB _001;CALL FC 1 (a := I 0.0, b := I 0.1, c := Q 0.0);_001: A BR;= Q 0.1;"),
            "= Q0.1 <- CALL FC1 I0.0 I0.1 Q0.0(I0.2)");
  EXPECT_EQ(drawnBeside("A I 0.2;CALL FC 1 (a := I 0.0, b := I 0.1, c := Q 0.0);").substr(0, 2), "- ");
}

}  // namespace
}  // namespace rungproof
