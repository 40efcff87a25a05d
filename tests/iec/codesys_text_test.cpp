// What compilers of IEC 61131-3 take beyond the standard's text: results of TRUNC, chains of assignments, words that
// end a statement, the base of an enumeration. What is left out is named once, and the rest is read.
#include "tests/iec/iec_output.hpp"
#include "tests/iec/iec_run.hpp"

namespace rungproof {
namespace {

const std::string counting =
    "FUNCTION_BLOCK PUBLIC CNT\nVAR c : INT; END_VAR VAR_OUTPUT o : INT; END_VAR\n"
    "METHOD PUBLIC Add : BOOL\nVAR_INPUT k : INT; END_VAR\nc := c + k; Add := TRUE;\nEND_METHOD\no := c;\n"
    "PROPERTY Val : INT\nGET\nVal := c;\nEND_GET\nEND_PROPERTY\nEND_FUNCTION_BLOCK\n";

int toldTimes(const std::string& told, std::string_view part) {
  int times = 0;
  for (std::size_t at = told.find(part); at != std::string::npos; at = told.find(part, at + 1)) ++times;
  return times;
}

TEST(CodesysText, TruncGivesTheTypeOfItsPlace) {
  // 2.7 is cut to 2, 200.9 to 200, -2.7 to -2, 3.5 to 3.
  const std::string results =
      iecProgram("VAR_INPUT r : REAL; END_VAR VAR a : INT; b : USINT; c : LINT; d, e : INT; f : INT := 1; END_VAR",
                 "a := TRUNC(2.7); b := TRUNC(200.9); c := TRUNC(-2.7); d := f + TRUNC(3.5) * 2; e := TRUNC(r);");
  EXPECT_EQ(verdictOf(results, "a = 2 and b = 200 and c = -2 and d = 7"), "PROVED");
  // Out of the range of INT the result is any value, as that of REAL_TO_INT is; within it the number is the same.
  EXPECT_EQ(verdictOf(results, "r >= 7.0 and r < 8.0 implies e = 7"), "PROVED");
  EXPECT_EQ(verdictOf(results, "r = 40000.0 implies e = 32767"), "VIOLATED");
  EXPECT_EQ(verdictOf(results, "r = 40000.0 implies e = -25536"), "VIOLATED");
  // Compared, it is a DINT.
  const std::string compared =
      iecProgram("VAR_INPUT r : REAL; n : INT; END_VAR VAR q : BOOL; END_VAR", "q := TRUNC(r) > n;");
  EXPECT_EQ(verdictOf(compared, "r = 40000.0 implies q"), "PROVED");
  // A quotient is not the same in fewer bits.
  EXPECT_NE(findingsIec(readIecText(iecProgram("VAR a, b : INT; END_VAR", "a := (b + TRUNC(1.5)) / 2;")))
                .find("DINT does not fit into INT"),
            std::string::npos);
  // Other results of DINT still need a conversion.
  EXPECT_NE(findingsIec(readIecText(iecProgram("VAR a : INT; b : DINT; END_VAR", "a := b + TRUNC(1.5);")))
                .find("DINT does not fit into INT"),
            std::string::npos);
}

TEST(CodesysText, NoSemicolonBehindTheLastWordOfAStatement) {
  const std::string text = iecProgram(
      "VAR_INPUT x : BOOL; n : INT; END_VAR VAR q, r : BOOL; i, k : INT; END_VAR",
      "IF x THEN q := TRUE; ELSE q := FALSE; END_IF\nr := x;\nk := 0;\nFOR i := 1 TO 3 DO k := k + 1; END_FOR\n"
      "WHILE k < 5 DO k := k + 1; END_WHILE\nREPEAT k := k + 1; UNTIL k >= 7 END_REPEAT\n"
      "CASE n OF 1: IF x THEN k := 8; END_IF 2: k := 9; END_CASE\nr := r AND x;");
  EXPECT_EQ(findingsIec(readIecText(text)), "");
  EXPECT_EQ(verdictOf(text, "q = x and r = x"), "PROVED");
  EXPECT_EQ(verdictOf(text, "k = 7 or (k = 8 and n = 1 and x) or (k = 9 and n = 2)"), "PROVED");
  EXPECT_NE(findingsIec(readIecText(iecProgram("VAR a, b : INT; END_VAR", "a := 1 b := 2;"))).find("';' is needed"),
            std::string::npos);
}

TEST(CodesysText, AChainAssignsFromRightToLeft) {
  IecRun run(iecProgram("VAR a, b, c : INT; w : DINT; END_VAR", "a := 7; b := a := 5; c := b; w := c := b := c + 1;"));
  run.scan();
  EXPECT_EQ(run.get("a"), 5);
  EXPECT_EQ(run.get("b"), 6);
  EXPECT_EQ(run.get("c"), 6);
  EXPECT_EQ(run.get("w"), 6);
  const auto told = [](const char* statements) {
    return findingsIec(readIecText(iecProgram("VAR a, i : INT; m : ARRAY [0..3] OF INT; END_VAR", statements)));
  };
  EXPECT_NE(told("a := 3 := 4;").find("only a variable stands in front of ':='"), std::string::npos);
  EXPECT_NE(told("a := m[i] := 4;").find("write one assignment for each variable"), std::string::npos);
}

TEST(CodesysText, AnEnumerationMayHaveABase) {
  const std::string types =
      "TYPE Mode : (Off := 1, Hand, Auto := 40000) UINT := Hand; Small : (Low := -3, High) SINT; END_TYPE\n";
  const std::string text =
      types + iecProgram("VAR m : Mode; s : Small; k : (One := 1, Two) USINT := Two; x, y, z : DINT; END_VAR",
                         "x := TO_DINT(m); y := TO_DINT(s); z := TO_DINT(k); IF m = Hand THEN m := Auto; END_IF;");
  EXPECT_EQ(findingsIec(readIecText(text)), "");
  IecRun run(text);
  run.scan();
  EXPECT_EQ(run.get("x"), 2);
  EXPECT_EQ(run.get("y"), -3);
  EXPECT_EQ(run.get("z"), 2);
  run.scan();
  EXPECT_EQ(run.get("x"), 40000);
  EXPECT_NE(findingsIec(readIecText("TYPE T : (A := 300) SINT; END_TYPE\n" + iecProgram("VAR t : T; END_VAR", "")))
                .find("300 does not fit into SINT, the type of the enumeration"),
            std::string::npos);
  EXPECT_NE(findingsIec(readIecText("TYPE T : (A) LINT; END_TYPE\n" + iecProgram("VAR t : T; END_VAR", "")))
                .find("an enumeration of LINT values is not modelled"),
            std::string::npos);
}

TEST(CodesysText, MethodsAreNamedOnceAndLeftOut) {
  const std::string unused =
      counting +
      iecProgram("VAR_INPUT x : BOOL; END_VAR VAR r : BOOL; v : INT; f : CNT; END_VAR", "r := x; f(o => v);");
  EXPECT_EQ(findingsIec(readIecText(unused)),
            "methods are not modelled: Add of CNT is left out\nproperties are not modelled: Val of CNT is left out\n");
  // Their code is not checked: lint does not end with 0.
  for (const Finding& finding : readIecText(unused).findings) EXPECT_EQ(finding.severity, Severity::Warning);
  EXPECT_EQ(verdictOf(unused, "r = x and v = 0"), "PROVED");  // nobody calls what was left out
  // FB_Init runs by itself.
  const std::string starts =
      "FUNCTION_BLOCK CNT\nVAR c : INT; END_VAR VAR_OUTPUT o : INT; END_VAR\no := c;\nMETHOD FB_Init : BOOL\nc := 5;\n"
      "END_METHOD\nEND_FUNCTION_BLOCK\n";
  EXPECT_EQ(verdictOf(starts + iecProgram("VAR v : INT; f : CNT; END_VAR", "f(o => v);"), "v = 0"), "NOT COVERED");
  // A call may write anything, and is told where it stands.
  const std::string used = counting + iecProgram("VAR_INPUT x : BOOL; END_VAR VAR r : BOOL; v : INT; f : CNT; END_VAR",
                                                 "f.Add(k := 1); f(o => v);");
  EXPECT_EQ(verdictOf(used, "v = 0"), "NOT COVERED");
  const std::string told = findingsIec(readIecText(used));
  EXPECT_EQ(toldTimes(told, "\n"), 3) << told;
  EXPECT_NE(told.find("Add of CNT from outside is not modelled"), std::string::npos) << told;
  for (const char* const statement : {"v := f.Val;", "r := f.Add(1);", "IF f.Add(1) AND x THEN v := 1; END_IF;"}) {
    const std::string other =
        counting + iecProgram("VAR_INPUT x : BOOL; END_VAR VAR r : BOOL; v : INT; f : CNT; END_VAR", statement);
    EXPECT_EQ(toldTimes(findingsIec(readIecText(other)), "not modelled"), 3) << statement;
    EXPECT_EQ(verdictOf(other, "v = 0 and not r"), "NOT COVERED") << statement;
  }
  // To read a property may write anything as well.
  const std::string asked = counting + iecProgram("VAR r : BOOL; v : INT; f : CNT; END_VAR", "r := TRUE; v := f.Val;");
  EXPECT_EQ(verdictOf(asked, "r"), "NOT COVERED");
  // The block itself calls its method.
  for (const char* const body : {"Add(k := 1);", "Add();", "b := Add(1);"}) {
    const std::string own = "FUNCTION_BLOCK CNT\nVAR c : INT; b : BOOL; END_VAR VAR_OUTPUT o : INT; END_VAR\n" +
                            std::string(body) + "\nMETHOD Add : BOOL\nc := c + 1;\nEND_METHOD\nEND_FUNCTION_BLOCK\n" +
                            iecProgram("VAR v : INT; f : CNT; END_VAR", "f(o => v);");
    EXPECT_EQ(verdictOf(own, "v = 0"), "NOT COVERED") << body;
  }
}

TEST(CodesysText, InterfacesAndParentsAreNamedOnce) {
  const std::string text =
      "INTERFACE I1 EXTENDS I0\nMETHOD M : BOOL\nVAR_INPUT k : INT; END_VAR\nEND_METHOD\nEND_INTERFACE\n"
      "FUNCTION_BLOCK Child EXTENDS Base IMPLEMENTS I1, I2\nVAR_OUTPUT o : INT; END_VAR\no := inherited;\n"
      "END_FUNCTION_BLOCK\n"
      "FUNCTION_BLOCK Other IMPLEMENTS I1\nVAR_OUTPUT o : INT; END_VAR\no := 1;\nEND_FUNCTION_BLOCK\n";
  const std::string calls = "r := x; a(o => v);";
  const std::string rest =
      iecProgram("VAR_INPUT x : BOOL; END_VAR VAR r : BOOL; v : INT; a : Other; c : Child; END_VAR", calls);
  EXPECT_EQ(findingsIec(readIecText(text + rest)),
            "interfaces are not modelled: I1 is left out\n"
            "inheritance is not modelled: Child has all of Base, so its body is left out\n");
  EXPECT_EQ(verdictOf(text + rest, "r = x and v = 1"), "PROVED");
  EXPECT_EQ(verdictOf(text + iecProgram("VAR v : INT; c : Child; END_VAR", "v := 0; c();"), "v = 0"), "NOT COVERED");
  // A variable of an interface stands for an instance of some block.
  EXPECT_EQ(verdictOf(text + iecProgram("VAR v : INT; i : I1; a : Other; END_VAR", "i.M(k := 1); a(o => v);"), "v = 1"),
            "NOT COVERED");
}

TEST(CodesysText, AVariableMayBeNamedMethod) {
  EXPECT_EQ(
      verdictOf(iecProgram("VAR method, property : INT; END_VAR", "method := 1; property := method;"), "property = 1"),
      "PROVED");
}

TEST(CodesysText, WhatABlockOfTheStandardKeepsForItselfHasNoName) {
  const auto told = [](const char* declarations, const char* statements) {
    return findingsIec(readIecText(iecProgram(std::string("VAR x : INT; ") + declarations + " END_VAR", statements)));
  };
  EXPECT_NE(told("t : TON;", "x := t.STATE;").find("block TON has no variable STATE"), std::string::npos);
  EXPECT_NE(told("t : TON;", "t.STATE := 1;").find("block TON has no variable STATE"), std::string::npos);
  EXPECT_NE(told("t : TON;", "t(IN := TRUE, STATE => x);").find("block TON has no output STATE"), std::string::npos);
  EXPECT_NE(told("t : TON := (STATE := 1);", "").find("block TON has no variable STATE"), std::string::npos);
  EXPECT_NE(told("c : CTU; b : BOOL;", "b := c.M;").find("block CTU has no variable M"), std::string::npos);
  const std::string timed =
      iecProgram("VAR t : TON; q : BOOL; END_VAR", "t(IN := TRUE, PT := T#1s); q := t.Q AND t.ET >= T#1s AND t.IN;");
  EXPECT_EQ(verdictOf(timed, "q = t.Q"), "PROVED");
  // A block of the project shows its variables.
  EXPECT_EQ(verdictOf("FUNCTION_BLOCK own\nVAR state : INT; END_VAR\nstate := 1;\nEND_FUNCTION_BLOCK\n" +
                          iecProgram("VAR f : own; x : INT; END_VAR", "f(); x := f.state;"),
                      "x = 1 and f.state = 1"),
            "PROVED");
}

TEST(CodesysText, ThePhaseIsANumberOfAScan) {  // a task of 30 ms beside one of 10 ms
  const std::string text =
      "PROGRAM Fast\nVAR c : INT; END_VAR\nIF c < 9 THEN c := c + 1; END_IF;\nEND_PROGRAM\n"
      "PROGRAM Slow\nVAR c : INT; END_VAR\nIF c < 9 THEN c := c + 1; END_IF;\nEND_PROGRAM\n"
      "CONFIGURATION C\nRESOURCE R ON PLC\nTASK tf(INTERVAL := T#10ms, PRIORITY := 1);\n"
      "TASK ts(INTERVAL := T#30ms, PRIORITY := 1);\nPROGRAM f WITH tf : Fast;\nPROGRAM s WITH ts : Slow;\n"
      "END_RESOURCE\nEND_CONFIGURATION\n"
      "//@ prove range: s.PHASE >= 1 and s.PHASE <= 3\n"
      "//@ prove first: first_scan and s.PHASE = 1 implies s.c = 1\n"
      "//@ prove second: f.c = 2 and prev(s.PHASE) = 2 implies prev(s.c) = 0 and s.c = 1\n"
      "//@ prove third: f.c = 3 and prev(prev(s.PHASE)) = 3 implies prev(s.c) = 0 and s.c = 1\n"
      "//@ reach last: f.c = 3 and s.c = 1 and prev(s.c) = 0\n";
  const IecOutput output = proofOfIec(text, {"--choice", "iec-phase=any"});
  for (const char* const part :
       {"PROVED  range", "PROVED  first", "PROVED  second", "PROVED  third", "REACHABLE  last"})
    EXPECT_TRUE(output.has(part)) << part << "\n" << output.text;
}

TEST(CodesysText, ALoopThatRunsAtLeastOnceWritesTheResult) {
  const auto lint = [](const std::string& head, const std::string& body) {
    return runIec({"lint"}, "FUNCTION f : INT\nVAR_INPUT a, b : INT; END_VAR\nVAR i : INT; END_VAR\n" + head + " DO " +
                                body + " END_FOR;\nEND_FUNCTION\n" +
                                iecProgram("VAR_OUTPUT y : INT; END_VAR", "y := f(1, 2);"));
  };
  EXPECT_FALSE(lint("FOR i := 1 TO 3", "f := i;").has("IEC005"));
  EXPECT_TRUE(lint("FOR i := 3 TO 1", "f := i;").has("IEC005"));
  EXPECT_TRUE(lint("FOR i := a TO b", "f := i;").has("IEC005"));
  EXPECT_TRUE(lint("FOR i := 1 TO 3", "IF i > 1 THEN f := i; END_IF;").has("IEC005"));
  EXPECT_TRUE(lint("FOR i := 1 TO 3", "IF a > b THEN EXIT; END_IF; f := i;").has("IEC005"));
}

}  // namespace
}  // namespace rungproof
