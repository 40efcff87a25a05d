// Small programs with the values that the standard gives at the ends of their scans. Scans last 10 ms; the reason
// stands beside each.
#include "tests/iec/iec_run.hpp"

namespace rungproof {
namespace {

TEST(IecMicro, RisingEdgeIsSeenInTheFirstScan) {  // Q := CLK AND NOT M, M is FALSE at the start
  IecRun run(iecProgram("VAR_INPUT x : BOOL; END_VAR VAR_OUTPUT q : BOOL; END_VAR VAR r : R_TRIG; END_VAR",
                        "r(CLK := x); q := r.Q;"));
  EXPECT_EQ(run.follow("q", {{"x", {1, 1, 0, 1}}}), (Row{1, 0, 0, 1}));
}

TEST(IecMicro, FallingEdgeIsSeenInTheFirstScan) {  // Q := NOT CLK AND NOT M
  IecRun run(iecProgram("VAR_INPUT x : BOOL; END_VAR VAR_OUTPUT q : BOOL; END_VAR VAR f : F_TRIG; END_VAR",
                        "f(CLK := x); q := f.Q;"));
  EXPECT_EQ(run.follow("q", {{"x", {0, 0, 1, 0}}}), (Row{1, 0, 0, 1}));
}

TEST(IecMicro, OnDelay) {  // starts in scan 1, ends where 30 ms have passed
  const std::string text = iecProgram("VAR_INPUT i : BOOL; END_VAR VAR t : TON; END_VAR", "t(IN := i, PT := T#30ms);");
  EXPECT_EQ(IecRun(text).follow("t.Q", {{"i", {1, 1, 1, 1, 0, 1}}}), (Row{0, 0, 0, 1, 0, 0}));
  EXPECT_EQ(IecRun(text).follow("t.ET", {{"i", {1, 1, 1, 1, 0, 1}}}), (Row{0, 10, 20, 30, 0, 0}));
}

TEST(IecMicro, PresetIsReadInEachCall) {  // 30 ms have passed when PT becomes 15 ms
  const std::string text =
      iecProgram("VAR_INPUT i : BOOL; p : TIME; END_VAR VAR t : TON; END_VAR", "t(IN := i, PT := p);");
  const std::vector<std::pair<std::string, Row>> inputs = {{"i", {1, 1, 1, 1, 1}}, {"p", {50, 50, 50, 15, 15}}};
  EXPECT_EQ(IecRun(text).follow("t.Q", inputs), (Row{0, 0, 0, 1, 1}));
  EXPECT_EQ(IecRun(text).follow("t.ET", inputs), (Row{0, 10, 20, 15, 15}));
}

TEST(IecMicro, PulseIsNotStartedAnew) {
  const std::string text = iecProgram("VAR_INPUT i : BOOL; END_VAR VAR t : TP; END_VAR", "t(IN := i, PT := T#30ms);");
  const std::vector<std::pair<std::string, Row>> inputs = {{"i", {1, 0, 1, 1, 1, 0, 1}}};
  EXPECT_EQ(IecRun(text).follow("t.Q", inputs), (Row{1, 1, 1, 0, 0, 0, 1}));
  EXPECT_EQ(IecRun(text).follow("t.ET", inputs), (Row{0, 10, 20, 30, 30, 0, 0}));
}

TEST(IecMicro, OffDelay) {  // off in the first scan in which 25 ms have passed
  const std::string text = iecProgram("VAR_INPUT i : BOOL; END_VAR VAR t : TOF; END_VAR", "t(IN := i, PT := T#25ms);");
  const std::vector<std::pair<std::string, Row>> inputs = {{"i", {1, 0, 0, 0, 0, 0}}};
  EXPECT_EQ(IecRun(text).follow("t.Q", inputs), (Row{1, 1, 1, 1, 0, 0}));
  EXPECT_EQ(IecRun(text).follow("t.ET", inputs), (Row{0, 0, 10, 20, 25, 25}));
}

TEST(IecMicro, TimersGoOnWhileTheyAreNotCalled) {  // started in scan 1, not called in 2 to 4: 40 ms at the next call
  IecRun run(
      iecProgram("VAR_INPUT c : BOOL; END_VAR VAR t : TON; END_VAR", "IF c THEN t(IN := TRUE, PT := T#1s); END_IF;"));
  EXPECT_EQ(run.follow("t.ET", {{"c", {1, 0, 0, 0, 1}}}), (Row{0, 0, 0, 0, 40}));
}

TEST(IecMicro, PresetZero) {  // Q in the second call, by the reading that a timer ends in the call after its start
  IecRun run(iecProgram("VAR_INPUT i : BOOL; END_VAR VAR t : TON; END_VAR", "t(IN := i, PT := T#0s);"));
  EXPECT_EQ(run.follow("t.Q", {{"i", {1, 1, 0}}}), (Row{0, 1, 0}));
}

TEST(IecMicro, CountDown) {  // CV is 0 at the start, so Q is TRUE before the first LD
  const std::string text =
      iecProgram("VAR_INPUT cd, ld : BOOL; END_VAR VAR c : CTD; END_VAR", "c(CD := cd, LD := ld, PV := 2);");
  const std::vector<std::pair<std::string, Row>> inputs = {{"cd", {0, 0, 0, 1, 0, 1}}, {"ld", {0, 1, 0, 0, 0, 0}}};
  EXPECT_EQ(IecRun(text).follow("c.Q", inputs), (Row{1, 0, 0, 0, 0, 1}));
  EXPECT_EQ(IecRun(text).follow("c.CV", inputs), (Row{0, 2, 2, 1, 1, 0}));
}

TEST(IecMicro, CountUp) {  // counts in the first scan, stops at PV
  const std::string text =
      iecProgram("VAR_INPUT cu, r : BOOL; END_VAR VAR c : CTU; END_VAR", "c(CU := cu, R := r, PV := 2);");
  const std::vector<std::pair<std::string, Row>> inputs = {{"cu", {1, 0, 1, 0, 1}}, {"r", {0, 0, 0, 0, 0}}};
  EXPECT_EQ(IecRun(text).follow("c.Q", inputs), (Row{0, 0, 1, 1, 1}));
  EXPECT_EQ(IecRun(text).follow("c.CV", inputs), (Row{1, 1, 2, 2, 2}));
  // An edge while R is TRUE is used up.
  EXPECT_EQ(IecRun(text).follow("c.CV", {{"cu", {0, 1, 1, 0, 1}}, {"r", {0, 1, 0, 0, 0}}}), (Row{0, 0, 0, 0, 1}));
}

TEST(IecMicro, BothEdgesCancel) {
  IecRun run(iecProgram("VAR_INPUT cu, cd : BOOL; END_VAR VAR c : CTUD; END_VAR",
                        "c(CU := cu, CD := cd, R := FALSE, LD := FALSE, PV := 3);"));
  EXPECT_EQ(run.follow("c.CV", {{"cu", {0, 1, 0, 1}}, {"cd", {0, 1, 0, 0}}}), (Row{0, 0, 0, 1}));
}

TEST(IecMicro, WhichSideOfABistableWins) {
  const std::string text = iecProgram("VAR_INPUT a, b : BOOL; END_VAR VAR s : SR; r : RS; END_VAR",
                                      "s(S1 := a, R := b); r(S := a, R1 := b);");
  const std::vector<std::pair<std::string, Row>> inputs = {{"a", {1, 1, 0, 0}}, {"b", {0, 1, 0, 1}}};
  EXPECT_EQ(IecRun(text).follow("s.Q1", inputs), (Row{1, 1, 1, 0}));
  EXPECT_EQ(IecRun(text).follow("r.Q1", inputs), (Row{1, 0, 0, 0}));
}

/// The value of `name` at the end of the first scan.
double once(const std::string& declarations, const std::string& statements, const std::string& name) {
  IecRun run(iecProgram(declarations, statements));
  run.scan();
  EXPECT_TRUE(run.simulator.isRunning());
  return run.get(name);
}

TEST(IecMicro, SumsWrap) {  // 32767 + 1
  EXPECT_EQ(once("VAR i : INT := 32767; j : INT; END_VAR", "j := i + 1;", "j"), -32768);
}

TEST(IecMicro, HalvesAreRoundedToTheEvenNumber) {
  EXPECT_EQ(once("VAR r : REAL := 2.5; i : INT; END_VAR", "i := REAL_TO_INT(r);", "i"), 2);
  EXPECT_EQ(once("VAR r : REAL := 3.5; i : INT; END_VAR", "i := REAL_TO_INT(r);", "i"), 4);
  EXPECT_EQ(once("VAR r : REAL := -2.5; i : INT; END_VAR", "i := REAL_TO_INT(r);", "i"), -2);
  EXPECT_EQ(once("VAR r : REAL := -2.7; i : DINT; END_VAR", "i := TRUNC(r);", "i"), -2);
  EXPECT_EQ(once("VAR r : REAL := 0.6; i : INT; END_VAR", "i := REAL_TO_INT(r);", "i"), 1);
}

TEST(IecMicro, QuotientsAreCutTowardsZero) {
  EXPECT_EQ(once("VAR a : INT := -7; b : INT := 2; j : INT; END_VAR", "j := a / b;", "j"), -3);
  EXPECT_EQ(once("VAR a : INT := -7; b : INT := 3; j : INT; END_VAR", "j := a MOD b;", "j"), -1);
  EXPECT_EQ(once("VAR a : INT := 7; b : INT := -3; j : INT; END_VAR", "j := a MOD b;", "j"), 1);
}

TEST(IecMicro, ForDownwards) {  // 10 7 4 1, then -2
  const std::string statements = "FOR i := 10 TO 1 BY -3 DO n := n + 1; END_FOR;";
  EXPECT_EQ(once("VAR i, n : INT; END_VAR", statements, "n"), 4);
  EXPECT_EQ(once("VAR i, n : INT; END_VAR", statements, "i"), -2);
}

TEST(IecMicro, ForThatIsNotEntered) {
  const std::string statements = "FOR i := 5 TO 1 DO n := n + 1; END_FOR;";
  EXPECT_EQ(once("VAR i, n : INT; END_VAR", statements, "n"), 0);
  EXPECT_EQ(once("VAR i, n : INT; END_VAR", statements, "i"), 5);
}

TEST(IecMicro, TheFirstLabelWins) {
  IecRun run(iecProgram("VAR_INPUT x : INT; END_VAR VAR y : INT; END_VAR",
                        "CASE x OF 1: y := 1; 2, 3: y := 2; 4..6: y := 3; 5: y := 9; ELSE y := 100; END_CASE;"));
  EXPECT_EQ(run.follow("y", {{"x", {1, 3, 5, 7}}}), (Row{1, 2, 3, 100}));
}

TEST(IecMicro, InOutIsTheVariableItself) {
  IecRun run("FUNCTION_BLOCK inc VAR_IN_OUT z : INT; END_VAR z := z + 1; END_FUNCTION_BLOCK\n" +
             iecProgram("VAR a : inc; v : INT; go : BOOL; END_VAR", "a(z := v); a(z := v);"));
  EXPECT_EQ(run.follow("v", {{"go", {0, 0}}}), (Row{2, 4}));
}

TEST(IecMicro, EachInstanceHasItsOwnState) {
  const std::string text =
      "FUNCTION_BLOCK calls VAR_OUTPUT n : INT; END_VAR n := n + 1; END_FUNCTION_BLOCK\n" +
      iecProgram("VAR_INPUT e : BOOL; END_VAR VAR a, b : calls; END_VAR", "a(); IF e THEN b(); END_IF;");
  EXPECT_EQ(IecRun(text).follow("a.n", {{"e", {0, 1, 0}}}), (Row{1, 2, 3}));
  EXPECT_EQ(IecRun(text).follow("b.n", {{"e", {0, 1, 0}}}), (Row{0, 1, 1}));
}

TEST(IecMicro, AnInputKeepsItsLastValue) {  // x is 4 by its initial value, then 3 for good
  IecRun run(
      "FUNCTION_BLOCK sum VAR_INPUT x : INT := 4; END_VAR VAR_OUTPUT y : INT; END_VAR y := y + x; "
      "END_FUNCTION_BLOCK\n" +
      iecProgram("VAR_INPUT g : BOOL; END_VAR VAR s : sum; END_VAR", "IF g THEN s(x := 3); ELSE s(); END_IF;"));
  EXPECT_EQ(run.follow("s.y", {{"g", {0, 1, 0}}}), (Row{4, 7, 10}));
}

TEST(IecMicro, EnableKeepsTheOutputs) {
  const std::string text =
      "FUNCTION_BLOCK add3 VAR_OUTPUT y : INT; END_VAR y := y + 3; END_FUNCTION_BLOCK\n" +
      iecProgram("VAR_INPUT e : BOOL; END_VAR VAR a : add3; ok : BOOL; END_VAR", "a(EN := e, ENO => ok);");
  EXPECT_EQ(IecRun(text).follow("a.y", {{"e", {0, 1, 1, 0}}}), (Row{0, 3, 6, 6}));
  EXPECT_EQ(IecRun(text).follow("ok", {{"e", {0, 1, 1, 0}}}), (Row{0, 1, 1, 0}));
}

TEST(IecMicro, FunctionsOfTheirOwn) {
  IecRun run(
      "FUNCTION twice : INT VAR_INPUT x : INT := 5; END_VAR VAR n : INT; END_VAR n := n + 1; twice := x * 2 + n - 1; "
      "END_FUNCTION\n" +
      iecProgram("VAR y, z : INT; END_VAR", "y := twice(twice(3)) + twice(x := 1); z := twice();"));
  run.scan();
  EXPECT_EQ(run.get("y"), 14);
  EXPECT_EQ(run.get("z"), 10);
}

TEST(IecMicro, ArraysAndStructures) {
  IecRun run("TYPE point : STRUCT x, y : INT; END_STRUCT; END_TYPE\n" +
             iecProgram("VAR_INPUT i : INT; END_VAR VAR a : ARRAY [2..5] OF INT := [1, 2(7), 4]; p : ARRAY [0..2] OF "
                        "point; s : INT; b : ARRAY [0..3] OF BOOL; q : BOOL; END_VAR",
                        "a[i] := a[i] + 10; p[i - 2].y := i; s := a[i] + p[1].y; b[i - 2] := TRUE; q := b[1];"));
  EXPECT_EQ(run.follow("s", {{"i", {2, 3, 4}}}), (Row{11, 20, 20}));
  EXPECT_EQ(run.get("q"), 1);
  EXPECT_EQ(run.get("a[5]"), 4);
}

TEST(IecMicro, AnIndexOutsideEndsTheScan) {
  IecRun run(iecProgram("VAR_INPUT i : INT; END_VAR VAR a : ARRAY [0..3] OF INT; END_VAR", "a[i] := 1;"));
  run.set("i", 4);
  run.scan();
  EXPECT_FALSE(run.simulator.isRunning());
}

TEST(IecMicro, EnumerationsAndBits) {
  IecRun run("TYPE color : (red, green := 5, blue); END_TYPE\n" +
             iecProgram("VAR c : color; w : WORD; n : INT; END_VAR",
                        "IF c = red THEN c := blue; END_IF; w.3 := c = color#blue; n := WORD_TO_INT(w);"));
  run.scan();
  EXPECT_EQ(run.get("c"), 6);
  EXPECT_EQ(run.get("n"), 8);
}

TEST(IecMicro, LoopsAndTheirWaysOut) {
  EXPECT_EQ(once("VAR i, n : INT; END_VAR",
                 "WHILE i < 10 DO i := i + 1; IF i = 3 THEN CONTINUE; END_IF; IF i = 6 THEN EXIT; END_IF; n := n + i; "
                 "END_WHILE;",
                 "n"),
            1 + 2 + 4 + 5);
  EXPECT_EQ(once("VAR n : INT; END_VAR", "REPEAT n := n + 1; UNTIL n >= 4 END_REPEAT;", "n"), 4);
}

TEST(IecMicro, BitStringsShiftAndRotate) {
  EXPECT_EQ(once("VAR w : WORD := 16#8001; r : WORD; END_VAR", "r := ROL(w, 1);", "r"), 3);
  EXPECT_EQ(once("VAR w : WORD := 16#8001; r : WORD; END_VAR", "r := SHR(w, 15);", "r"), 1);
  EXPECT_EQ(once("VAR w : BYTE := 16#81; r : BYTE; END_VAR", "r := SHL(w, 8);", "r"), 0);
}

TEST(IecMicro, SelectionFunctions) {
  EXPECT_EQ(once("VAR y : INT; END_VAR", "y := SEL(TRUE, 1, 2) * 100 + MUX(1, 7, 8, 9) * 10 + LIMIT(0, 15, 5);", "y"),
            285);
  EXPECT_EQ(once("VAR y : INT; END_VAR", "y := MAX(1, 9, 3) * 10 + MIN(4, 2, 8) + ABS(-300);", "y"), 392);
}

}  // namespace
}  // namespace rungproof
