// Properties of programs in SCL with the verdicts that reasoning gives, their certificates and repeated runs; SCL
// against statement lists.
#include "tests/scl/scl_run.hpp"

namespace rungproof {
namespace {

using testscl::mainOf;
using testscl::Output;
using testscl::proofOf;

const std::string motor =
    "FUNCTION_BLOCK FB 1\nVAR_INPUT\n start : BOOL; stop : BOOL; fault : BOOL;\nEND_VAR\nVAR_OUTPUT\n run : BOOL;\n"
    "END_VAR\nVAR\n starts : INT;\n last : BOOL;\nEND_VAR\nBEGIN\n IF #stop OR #fault THEN\n  #run := FALSE;\n"
    " ELSIF #start THEN\n  #run := TRUE;\n END_IF;\n IF #run AND NOT #last AND #starts < 100 THEN\n"
    "  #starts := #starts + 1;\n END_IF;\n #last := #run;\nEND_FUNCTION_BLOCK\n"
    "DATA_BLOCK DB 3\nFB 1\nBEGIN\nEND_DATA_BLOCK\n";

TEST(SclProof, StopWins) {
  const std::string program = motor + mainOf("FB1.DB3(start := I0.0, stop := I0.1, fault := I0.2, run => Q4.0);");
  const test::TemporaryFolder folder;
  const Output proof =
      proofOf("prove stop: I0.1 implies not Q4.0\nprove bound: DB3.starts <= 100\nprove on: not Q4.0\n", program,
              {"--certificate", folder.folder().string()});
  EXPECT_EQ(proof.exit, 1) << proof.text;
  EXPECT_TRUE(proof.has("PROVED  stop")) << proof.text;
  EXPECT_TRUE(proof.has("PROVED  bound")) << proof.text;
  EXPECT_TRUE(proof.has("VIOLATED  on")) << proof.text;  // I0.0 alone switches it on
}

// A loop with a constant limit, an IF in it, and what it adds up.
TEST(SclProof, LoopCountsBits) {
  const std::string program = mainOf(
      "#n := 0;\nFOR #i := 0 TO 3 DO\n #b := SHR(IN := IB0, N := #i) AND B#16#01;\n IF #b = B#16#01 THEN #n := #n + 1; "
      "END_IF;\nEND_FOR;\nMW20 := #n;",
      "VAR_TEMP\n i : INT; n : INT; b : BYTE;\nEND_VAR\n");
  const Output proof = proofOf(
      "prove all: (I0.0 and I0.1 and I0.2 and I0.3) implies MW20 == 4\nprove one: MW20 <= 4\nprove not3: MW20 <= 3\n",
      program);
  EXPECT_TRUE(proof.has("PROVED  all")) << proof.text;
  EXPECT_TRUE(proof.has("PROVED  one")) << proof.text;
  EXPECT_TRUE(proof.has("VIOLATED  not3")) << proof.text;
}

// All ways through CASE and IF meet again in front of the loop: it runs whatever they were, four rounds and no more.
TEST(SclProof, LoopBehindManyWays) {
  const std::string program =
      "FUNCTION_BLOCK FB 1\nVAR_INPUT\n go : BOOL; lim : INT := 3;\nEND_VAR\nVAR_OUTPUT\n cnt : INT;\nEND_VAR\n"
      "VAR\n st : INT; mem : BOOL; sum : INT; arr : ARRAY[1..4] OF INT;\nEND_VAR\nVAR_TEMP\n i : INT;\nEND_VAR\nBEGIN\n"
      "CASE st OF\n0: IF go AND NOT mem THEN st := 1; END_IF;\n"
      "1: cnt := cnt + 1; IF cnt >= lim THEN st := 2; ELSE st := 0; END_IF;\nEND_CASE;\nmem := go;\nsum := 0;\n"
      "FOR i := 1 TO 4 DO arr[i] := i; sum := sum + i; END_FOR;\nEND_FUNCTION_BLOCK\n"
      "DATA_BLOCK DB 1\nFB 1\nBEGIN\nEND_DATA_BLOCK\n" +
      mainOf("FB1.DB1(go := I4.0);");
  const Output proof = proofOf(
      "prove sum: DB1.sum == 10\nprove last: DB1.arr[4] == 4\nprove count: DB1.cnt <= 3\n"
      "prove no: DB1.cnt <= 2\n",
      program);
  EXPECT_TRUE(proof.has("PROVED  sum")) << proof.text;
  EXPECT_TRUE(proof.has("PROVED  last")) << proof.text;
  EXPECT_TRUE(proof.has("PROVED  count")) << proof.text;
  EXPECT_TRUE(proof.has("VIOLATED  no")) << proof.text;
  EXPECT_FALSE(proof.has("later rounds")) << proof.text;
}

TEST(SclProof, IndexThatStaysInside) {
  const std::string table =
      "DATA_BLOCK DB 10\nSTRUCT\n speed : ARRAY[1..4] OF INT := 10, 20, 30, 40;\nEND_STRUCT;\nBEGIN\nEND_DATA_BLOCK\n";
  const std::string declarations = "VAR_TEMP\n i : INT;\nEND_VAR\n";
  const Output inside = proofOf(
      "prove table: MW20 <= 40 and MW20 >= 10\n",
      table + mainOf("#i := LIMIT(MN := 1, IN := WORD_TO_INT(IW0), MX := 4);\nMW20 := DB10.speed[#i];", declarations),
      {"--builtin"});
  EXPECT_EQ(inside.exit, 0) << inside.text;
  const Output outside = proofOf("prove table: MW20 <= 40\n",
                                 table + mainOf("#i := WORD_TO_INT(IW0);\nIF #i >= 0 AND #i <= 4 THEN\n MW20 := "
                                                "DB10.speed[#i];\nEND_IF;",
                                                declarations),
                                 {"--builtin"});
  EXPECT_EQ(outside.exit, 1) << outside.text;
  EXPECT_TRUE(outside.has("index outside the bounds of its array")) << outside.text;
}

TEST(SclProof, EqualToAStatementList) {
  const test::TemporaryFolder folder;
  folder.file("a/main.scl",
              mainOf("IF I0.0 AND NOT I0.1 THEN\n MW20 := WORD_TO_INT(IW2) + 5;\nELSE\n MW20 := 0;\nEND_IF;\n"
                     "Q4.0 := WORD_TO_INT(IW2) > 7 OR I0.1;"));
  const auto list = [](const std::string& number) {
    return test7::block(1, "A I 0.0;AN I 0.1;JCN none;L IW 2;L " + number +
                               ";+I;T MW 20;JU done;none: L 0;T MW 20;done: L IW 2;L 7;>I;O I 0.1;= Q 4.0");
  };
  folder.file("b/main.awl", list("5"));
  folder.file("c/main.awl", list("6"));
  const Output same =
      test7::run({"equiv", folder.path("a/main.scl"), folder.path("b/main.awl"), "--observe", "Q4.0,MW20"});
  EXPECT_EQ(same.exit, 0) << same.text;
  EXPECT_TRUE(same.has("EQUAL")) << same.text;
  const Output other =
      test7::run({"equiv", folder.path("a/main.scl"), folder.path("c/main.awl"), "--observe", "Q4.0,MW20"});
  EXPECT_EQ(other.exit, 1) << other.text;
  EXPECT_TRUE(other.has("DIFFERENT")) << other.text;
}

// Whether the compiler was told to set OK is not known: an overflow may clear ENO, and nothing else does.
TEST(SclProof, AnOverflowMayClearEno) {
  const std::string function =
      "FUNCTION FC 8 : INT\nVAR_INPUT\n x : INT;\nEND_VAR\nBEGIN\n FC8 := #x + 1;\nEND_FUNCTION\n"
      "FUNCTION FC 9 : INT\nVAR_INPUT\n x : INT;\nEND_VAR\nBEGIN\n FC9 := #x;\nEND_FUNCTION\n";
  const std::string program = function + mainOf(
                                             "FC8(x := WORD_TO_INT(IW0), RET_VAL := MW20, ENO => M30.0);\n"
                                             "FC9(x := WORD_TO_INT(IW0), RET_VAL := MW22, ENO => M30.1);");
  const Output proof = proofOf(
      "prove always: M30.0\nprove inside: IW0 < 32767 implies M30.0\nprove plain: M30.1\nreach kept: IW0 = 32767 and "
      "M30.0\n",
      program);
  EXPECT_TRUE(proof.has("VIOLATED  always")) << proof.text;
  EXPECT_TRUE(proof.has("PROVED  inside")) << proof.text;
  EXPECT_TRUE(proof.has("PROVED  plain")) << proof.text;
  EXPECT_TRUE(proof.has("REACHABLE  kept")) << proof.text;
}

// What no text tells is any value in proofs: the variable behind FOR, MUX beyond its values, LIMIT with crossed limits.
TEST(SclProof, WhatIsNotStatedIsAnyValue) {
  const std::string program = mainOf(
      "#n := 0;\nFOR #i := 1 TO 3 DO #n := #n + 1; END_FOR;\nMW20 := #n;\nMW22 := #i;\n"
      "#k := WORD_TO_INT(IW2) ;\nMW24 := MUX(K := #k, IN0 := 7, IN1 := 8);\n"
      "MW26 := LIMIT(MN := #k, IN := 5, MX := 10);\nMW28 := LIMIT(MN := 1, IN := #k, MX := 10);",
      "VAR_TEMP\n i : INT; n : INT; k : INT;\nEND_VAR\n");
  const Output proof = proofOf(
      "prove rounds: MW20 = 3\nprove behind: MW22 = 4\nreach usual: MW22 = 4\nprove first: IW2 = 0 implies MW24 = 7\n"
      "prove second: IW2 = 1 implies MW24 = 8\nprove beyond: IW2 = 2 implies MW24 = 8\n"
      "prove limits: IW2 <= 5 implies MW26 = 5\nprove crossed: IW2 = 11 implies MW26 = 10\n"
      "prove plain: MW28 >= 1 and MW28 <= 10\n",
      program);
  for (const char* name : {"rounds", "first", "second", "limits", "plain"})
    EXPECT_TRUE(proof.has(std::string("PROVED  ") + name)) << proof.text;
  for (const char* name : {"behind", "beyond", "crossed"})
    EXPECT_TRUE(proof.has(std::string("VIOLATED  ") + name)) << proof.text;
  EXPECT_TRUE(proof.has("REACHABLE  usual")) << proof.text;
}

// Whether it is made where the first side decides is not stated.
TEST(SclProof, ACallOnTheSecondSideIsNotCovered) {
  const std::string program =
      "FUNCTION FC 8 : BOOL\nVAR_INPUT\n x : BOOL;\nEND_VAR\nBEGIN\n M40.0 := TRUE;\n FC8 := #x;\nEND_FUNCTION\n" +
      mainOf("IF I0.0 AND FC8(x := I0.1) THEN Q4.0 := TRUE; END_IF;\nQ4.1 := FC8(x := I0.1) OR I0.0;");
  const Output proof = proofOf("prove off: not Q4.0\n", program);
  EXPECT_TRUE(proof.has("NOT COVERED  off")) << proof.text;
  EXPECT_TRUE(proof.has("whether AND computes its second side where the first decides is not stated")) << proof.text;
  EXPECT_FALSE(proof.has("whether OR computes")) << proof.text;
}

// Built-in checks are named by the text, not by the instructions that it becomes.
TEST(SclProof, BuiltinChecksSpeakOfTheText) {
  const Output proof = testscl::commandOn("prove",
                                          mainOf("#i := WORD_TO_INT(IW0);\n#x[#i] := 1;\nMW20 := #x[1];",
                                                 "VAR_TEMP\n i : INT;\n x : ARRAY[1..4] OF INT;\nEND_VAR\n"),
                                          {"--builtin"});
  EXPECT_TRUE(proof.has("VIOLATED  #i: never 'index outside the bounds of its array'")) << proof.text;
  EXPECT_FALSE(proof.has("INDEX")) << proof.text;
}

}  // namespace
}  // namespace rungproof
