// Proofs through POINTER and ANY, SFC 20, functions of the library, and what stays open in them.
#include "proved_text.hpp"

namespace rungproof::test {
namespace {

/// Verdicts of the properties a, b, ... of an OB1 with these directives and statements.
std::vector<Outcome> proofsOf(const std::string& blocks, const std::string& directives, const std::string& statements,
                              const std::string& locals = {}, double timeout = 20, const Choices& choices = {}) {
  const ProgramInput input = inputOfSource(blocks + "ORGANIZATION_BLOCK OB 1\n" + directives +
                                           "VAR_TEMP\n  start : ARRAY [0 .. 19] OF BYTE;\n" + locals +
                                           "END_VAR\nBEGIN\nNETWORK\n" + statements + "\nEND_ORGANIZATION_BLOCK\n");
  ProverOptions options = usualOptions(timeout);
  options.choices = choices;
  const ProofRun run = prove(input.program, input.properties, options);
  std::vector<Outcome> outcomes;
  for (const ProofResult& result : run.results) outcomes.push_back(result.outcome);
  return outcomes;
}

Choices synchronous() {
  Choices choices;
  EXPECT_TRUE(choices.set("s5-time", "synchronous"));
  return choices;
}

using enum Outcome;
using Verdicts = std::vector<Outcome>;

/// Writes the byte that its ANY leads to.
const char* const writer =
    "FUNCTION FC 1 : VOID\nVAR_INPUT\n  p : ANY;\n  v : BYTE;\nEND_VAR\nVAR_TEMP\n  n : "
    "WORD;\nEND_VAR\nBEGIN\nNETWORK\n"
    "L P##p; LAR1; L W [AR1,P#4.0]; T #n; OPN DB [#n]; L D [AR1,P#6.0]; LAR1; L #v; T B [AR1,P#0.0];\nEND_FUNCTION\n";
const char* const data =
    "DATA_BLOCK DB 10\nSTRUCT\n  a : ARRAY [0 .. 9] OF BYTE;\nEND_STRUCT;\nBEGIN\nEND_DATA_BLOCK\n";

TEST(PointerParameter, WhatIsWrittenThroughAnAny) {
  EXPECT_EQ(
      proofsOf(std::string(writer) + data, "//@ prove a: Q0.0 = I0.0\n//@ prove b: not Q1.0\n//@ prove c: not Q0.0\n",
               "CALL FC 1 (p := P#Q 0.0 BYTE 1, v := IB 0); CALL FC 1 (p := DB10.a, v := B#16#7); L DB10.DBB 0; "
               "L 7; <>I; = Q 1.0;"),
      (Verdicts{Proved, Proved, Violated}));
}

// Local data of the caller, and data of its own instance.
TEST(PointerParameter, LocalAndStaticDataOfTheCaller) {
  const std::string blocks =
      std::string(writer) +
      "FUNCTION_BLOCK FB 2\nVAR\n  k : INT;\n  own : BYTE;\nEND_VAR\nVAR_TEMP\n  t : BYTE;\nEND_VAR\n"
      "BEGIN\nNETWORK\nCALL FC 1 (p := #own, v := IB 1); CALL FC 1 (p := #t, v := IB 0);\nL #t; T QB 0; "
      "L #own; T QB 1;\nEND_FUNCTION_BLOCK\nDATA_BLOCK DB 3\nFB 2\nBEGIN\nEND_DATA_BLOCK\n";
  EXPECT_EQ(proofsOf(blocks, "//@ prove a: Q0.3 = I0.3\n//@ prove b: Q1.5 = I1.5\n//@ prove c: Q0.3 = I1.3\n",
                     "CALL FB 2, DB 3;"),
            (Verdicts{Proved, Proved, Violated}));
}

// Data of the open block: in the reading that hands 0 over the CPU goes to STOP, where nothing is asked, so that both
// readings together prove what the other one does. A pointer to an elementary parameter of an FC leads to what its
// caller gives in one reading and to no known place in the other: only the first proves anything.
TEST(PointerParameter, DataOfTheOpenBlockAndParametersOfAnFc) {
  EXPECT_EQ(proofsOf(std::string(writer) + data, "//@ prove a: Q1.0 = I0.0\n//@ prove b: not Q1.0\n",
                     "OPN DB 10; CALL FC 1 (p := DBB 4, v := IB 0); L DB10.DBB 4; T QB 1;"),
            (Verdicts{Proved, Violated}));
  const std::string blocks = std::string(writer) +
                             "FUNCTION FC 2 : VOID\nVAR_INPUT\n  v : BYTE;\nEND_VAR\nVAR_OUTPUT\n  o : BYTE;\nEND_VAR\n"
                             "BEGIN\nNETWORK\nCALL FC 1 (p := #o, v := #v);\nEND_FUNCTION\n";
  const std::string directives = "//@ prove a: Q0.0 = I0.0\n//@ prove b: Q0.0 = I0.1\n",
                    call = "CALL FC 2 (v := IB 0, o := QB 0);";
  for (const Outcome outcome : proofsOf(blocks, directives, call, {}, 2)) EXPECT_NE(outcome, Proved);
  Choices choices;
  EXPECT_TRUE(choices.set("parameter-pointer", "actual"));
  EXPECT_EQ(proofsOf(blocks, directives, call, {}, 20, choices), (Verdicts{Proved, Violated}));
}

// P## of an elementary parameter of an FC: to what the caller gives, through a second FC and in local data of the
// caller too, in one reading; any value in the other, and of data blocks, constants and parts of a structure.
TEST(PointerParameter, AddressOfAnElementaryParameter) {
  const auto fc = [](const std::string& number, const std::string& locals, const std::string& statements) {
    return "FUNCTION FC " + number + " : VOID\n" + locals + "BEGIN\nNETWORK\n" + statements + "\nEND_FUNCTION\n";
  };
  const std::string adds =
      fc("1", "VAR_IN_OUT\n  x : INT;\nEND_VAR\n", "L P##x; LAR1; L 5; T W [AR1,P#0.0]; L W [AR1,P#0.0]; T MW 90;");
  const std::string hands = fc("2", "VAR_IN_OUT\n  y : INT;\nEND_VAR\n", "CALL FC 1 (x := #y);");
  const std::string directives = "//@ prove a: MW20 = 5\n//@ prove b: MW90 = 5\n//@ prove c: MW22 = 7\n";
  const std::string set = "L 7; T MW 22; L 0; T MW 20; T MW 90; ";
  Choices actual;
  EXPECT_TRUE(actual.set("parameter-pointer", "actual"));
  for (const char* call : {"CALL FC 1 (x := MW 20);", "CALL FC 2 (y := MW 20);"}) {
    EXPECT_EQ(proofsOf(adds + hands, directives, set + call, {}, 20, actual), (Verdicts{Proved, Proved, Proved}))
        << call;
    for (const Outcome outcome : proofsOf(adds + hands, directives, set + call, {}, 2))
      EXPECT_NE(outcome, Proved) << call;
  }
  EXPECT_EQ(proofsOf(adds, "//@ prove a: MW20 = 5\n", "L 0; T #own; CALL FC 1 (x := #own); L #own; T MW 20;",
                     "  own : INT;\n", 20, actual),
            (Verdicts{Proved}));
  // A bit, by its bit address; an input.
  EXPECT_EQ(proofsOf(fc("3", "VAR_INPUT\n  i : BOOL;\nEND_VAR\nVAR_OUTPUT\n  q : BOOL;\nEND_VAR\n",
                        "L P##i; LAR1; A [AR1,P#0.0]; L P##q; LAR1; = [AR1,P#0.0];"),
                     "//@ prove a: Q4.3 = I2.5\n//@ prove b: not Q4.3\n", "CALL FC 3 (i := I 2.5, q := Q 4.3);", {}, 20,
                     actual),
            (Verdicts{Proved, Violated}));
  for (const char* given : {"DB10.DBW 2", "DBW 2"}) {
    for (const Outcome outcome :
         proofsOf(adds + data, directives, set + "OPN DB 10; CALL FC 1 (x := " + given + ");", {}, 2, actual))
      EXPECT_NE(outcome, Proved) << given;
  }
  const std::string ofPart = fc("4", "VAR_INPUT\n  s : STRUCT\n    a : INT;\n    b : INT;\n  END_STRUCT;\nEND_VAR\n",
                                "L P##s.b; LAR1; L 5; T W [AR1,P#0.0];");
  for (const Outcome outcome : proofsOf(
           ofPart + "DATA_BLOCK DB 11\nSTRUCT\n  s : STRUCT\n    a : INT;\n    b : INT;\n  END_STRUCT;\nEND_STRUCT;\n"
                    "BEGIN\nEND_DATA_BLOCK\n",
           directives, set + "CALL FC 4 (s := DB11.s);", {}, 2, actual))
    EXPECT_NE(outcome, Proved);
}

// The number of a timer that an ANY carries in its last word: the block starts and asks that timer.
TEST(PointerParameter, TheTimerOfAnAny) {
  EXPECT_EQ(
      proofsOf("FUNCTION FC 3 : VOID\nVAR_INPUT\n  p : ANY;\nEND_VAR\nVAR_TEMP\n  n : WORD;\nEND_VAR\nBEGIN\n"
               "NETWORK\nL P##p; LAR1; L W [AR1,P#8.0]; T #n; A T [#n]; = Q 0.0;\nEND_FUNCTION\n",
               "//@ prove a: Q0.0 = Q0.1\n//@ prove b: not Q0.0\n//@ prove c: Q0.0 = Q0.2\n",
               "A I 0.0; L S5T#1S; SE T 5; A I 0.1; L S5T#1S; SE T 6; CALL FC 3 (p := T 5); A T 5; = Q 0.1; A T 6; "
               "= Q 0.2;",
               {}, 20, synchronous()),
      (Verdicts{Proved, Violated, Violated}));
}

// The place of an ANY is computed: each of the four that it can be.
TEST(PointerParameter, AnyWithAPlaceThatIsComputed) {
  EXPECT_EQ(
      proofsOf(std::string(writer) + data, "//@ prove a: not Q0.0\n//@ prove b: not Q0.1\n",
               "L P##many; LAR1; L W#16#1002; T W [AR1,P#0.0]; L 1; T W [AR1,P#2.0]; L 10; T W [AR1,P#4.0];\n"
               "L IB 0; L 3; AW; SLD 3; L DW#16#84000000; OD; T D [AR1,P#6.0]; CALL FC 1 (p := #many, v := B#16#1);\n"
               "L DB10.DBB 4; L 0; <>I; = Q 0.0; L DB10.DBB 3; L 0; <>I; = Q 0.1;",
               "  many : ANY;\n"),
      (Verdicts{Proved, Violated}));
}

// VACUOUS: nothing writes it.
TEST(PointerParameter, BlkmovCopiesAndWhatOverlapsIsOpen) {
  const std::string move = "CALL SFC 20 (SRCBLK := %, RET_VAL := MW 90, DSTBLK := $);";
  const auto moved = [&](const std::string& from, const std::string& to) {
    std::string text = move;
    text.replace(text.find('%'), 1, from);
    return text.replace(text.find('$'), 1, to);
  };
  EXPECT_EQ(
      proofsOf(data,
               "//@ prove a: Q0.0 = I0.0\n//@ prove b: Q1.7 = I1.7\n//@ prove c: not Q2.0\n//@ prove d: MW90 = 0\n",
               moved("P#I 0.0 BYTE 4", "P#Q 0.0 BYTE 2")),
      (Verdicts{Proved, Proved, Vacuous, Proved}));
  EXPECT_EQ(proofsOf(data, "//@ prove a: MB20 = 0\n//@ prove b: MB21 = 0\n//@ prove c: MB24 = 0\n",
                     moved("P#M 20.0 BYTE 3", "P#M 21.0 BYTE 3")),
            (Verdicts{Vacuous, Violated, Vacuous}));
}

// A range that leaves its block: an error, and what of the target is written is open.
TEST(PointerParameter, BlkmovBeyondABlockIsAnError) {
  EXPECT_EQ(
      proofsOf(
          data, "//@ prove a: not Q0.0\n//@ prove b: MB20 = 0\n//@ prove c: MB22 = 0\n",
          "CALL SFC 20 (SRCBLK := P#DB10.DBX 8.0 BYTE 4, RET_VAL := MW 90, DSTBLK := P#M 20.0 BYTE 2); A BR; = Q 0.0;"),
      (Verdicts{Proved, Violated, Vacuous}));
}

// How much is copied comes from outside: nothing is proved of what may be written.
TEST(PointerParameter, ALengthThatIsNotBoundedIsNoGuess) {
  const Verdicts verdicts = proofsOf(
      data, "//@ prove a: MB20 = 0\n//@ prove b: MB200 = 0\n",
      "L P##many; LAR1; L W#16#1002; T W [AR1,P#0.0]; L IW 0; T W [AR1,P#2.0]; L 0; T W [AR1,P#4.0];\n"
      "L P#M 20.0; T D [AR1,P#6.0]; CALL SFC 20 (SRCBLK := P#DB10.DBX 0.0 BYTE 10, RET_VAL := MW 90, DSTBLK := #many);",
      "  many : ANY;\n", 2);
  for (const Outcome verdict : verdicts) EXPECT_NE(verdict, Proved);
}

// An interrupt may see half a copy: the second byte is still the old one.
TEST(PointerParameter, AnInterruptMayComeWhileBlkmovWorks) {
  const std::string interrupt =
      "ORGANIZATION_BLOCK OB 40\nBEGIN\nNETWORK\nL MB 10; L MB 11; <>I; S Q 0.0;\nEND_ORGANIZATION_BLOCK\n";
  const std::string begin = "L IB 0; T MB 0; T MB 1; ",
                    copy = "(SRCBLK := P#M 0.0 BYTE %, RET_VAL := MW 90, DSTBLK := P#M 10.0 BYTE %);";
  const auto copied = [&](const char* count) {
    std::string text = "CALL SFC 20 " + copy;
    text.replace(text.find('%'), 1, count);
    return text.replace(text.find('%'), 1, count);
  };
  EXPECT_EQ(proofsOf(interrupt, "//@ prove a: not Q0.0\n", begin + copied("2")), (Verdicts{Violated}));
  EXPECT_EQ(proofsOf(interrupt, "//@ prove a: not Q0.0\n", begin + "L MW 0; T MW 10;"), (Verdicts{Proved}));
}

TEST(PointerParameter, LimitMaxAndSel) {
  const std::string numbers =
      "DATA_BLOCK DB 5\nSTRUCT\n  low : INT := -5;\n  high : INT := 20;\n  in : INT;\n  out : "
      "INT;\nEND_STRUCT;\nBEGIN\n"
      "END_DATA_BLOCK\n";
  const std::string begin = "L IW 0; T DB5.DBW 4; ", end = " L DB5.DBW 6; T MW 0;";
  EXPECT_EQ(proofsOf(numbers, "//@ prove a: MW0 <= 20\n//@ prove b: MW0 >= -5\n//@ prove c: MW0 < 20\n",
                     begin + "CALL FC 22 (MN := DB5.low, IN := DB5.in, MX := DB5.high, RET_VAL := DB5.out);" + end),
            (Verdicts{Proved, Proved, Violated}));
  EXPECT_EQ(proofsOf(numbers, "//@ prove a: MW0 >= 20\n//@ prove b: MW0 > 20\n",
                     begin + "CALL FC 25 (IN1 := DB5.low, IN2 := DB5.in, IN3 := DB5.high, RET_VAL := DB5.out);" + end),
            (Verdicts{Proved, Violated}));
  // Limits the wrong way round, and words that are no numbers: any result.
  EXPECT_EQ(proofsOf(numbers, "//@ prove a: MW0 <= 20\n",
                     begin + "CALL FC 22 (MN := DB5.high, IN := DB5.in, MX := DB5.low, RET_VAL := DB5.out);" + end),
            (Verdicts{Violated}));
  EXPECT_EQ(proofsOf(numbers, "//@ prove a: MW2 = 0\n//@ prove b: M4.0\n",
                     "SET; = M 4.0; CALL FC 27 (IN1 := MW 6, IN2 := MW 8, IN3 := MW 10, RET_VAL := MW 2);"),
            (Verdicts{Violated, Proved}));
}

// A block of the CPU that no table describes: the places that its call names become any value, and nothing else.
TEST(PointerParameter, SystemBlocksThatNoTableDescribes) {
  EXPECT_EQ(proofsOf("",
                     "//@ prove a: MW20 = 0\n//@ prove b: MB30 = 0\n//@ prove c: M24.0\n//@ prove d: M34.0\n"
                     "//@ reach e: MB33 = 77\n",
                     "SET; = M 24.0; = M 34.0; L 0; T MD 30; T MW 20; "
                     "CALL SFC 14 (LADDR := W#16#100, RET_VAL := MW 20, RECORD := P#M 30.0 BYTE 4);"),
            (Verdicts{Violated, Violated, Proved, Proved, Reachable}));
}

// A moment is any that there is: its digits are digits, its weekday is that of the date.
TEST(PointerParameter, TheClockShowsAMoment) {
  const std::string clock = "DATA_BLOCK DB 5\nSTRUCT\n  t : DATE_AND_TIME;\nEND_STRUCT;\nBEGIN\nEND_DATA_BLOCK\n";
  EXPECT_EQ(proofsOf(clock, "//@ prove a: MB3 <= 16#23\n//@ prove b: MB1 >= 1\n//@ prove c: MB3 <= 16#22\n",
                     "CALL SFC 1 (RET_VAL := MW 90, CDT := DB5.t); L DB5.DBD 0; T MD 0;"),
            (Verdicts{Proved, Proved, Violated}));
}

}  // namespace
}  // namespace rungproof::test
