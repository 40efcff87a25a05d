// EN and ENO of functions and instances, __TRY and __CATCH, loops without an end, and what files in the field have
// beside the standard. Values from section 4 of the standard's text on calls and from what the statements say.
#include "tests/iec/iec_output.hpp"
#include "tests/iec/iec_run.hpp"

namespace rungproof {
namespace {

// ENO tells that the function was executed; of a division by 0 it tells the error.
TEST(IecEnable, FunctionsTellThatTheyHaveRun) {
  const std::string text = iecProgram(
      "VAR_INPUT a, b : DINT; END_VAR VAR m, d : BOOL; n : DINT; END_VAR VAR_OUTPUT q : BOOL; END_VAR",
      "q := GE(EN := TRUE, IN1 := a, IN2 := b, ENO => m);\nn := DIV(EN := TRUE, IN1 := a, IN2 := b, ENO => d);");
  IecRun run(text);
  EXPECT_EQ(run.follow("q", {{"a", {5, 4}}, {"b", {5, 5}}}), (Row{1, 0}));
  EXPECT_EQ(run.get("m"), 1);
  EXPECT_EQ(run.get("d"), 1);
  const IecOutput output =
      proofOfIec("//@ prove p: d implies b <> 0\n//@ prove m: m\n" + text, {"--choice", "iec-div-zero=zero"});
  EXPECT_TRUE(output.has("PROVED  p") && output.has("PROVED  m")) << output.text;
}

// While EN is FALSE the target keeps its value (the spec's usual reading), or gets 0; ENO is FALSE then, and the
// function's own statements do not run.
TEST(IecEnable, FunctionsWithoutPowerFlow) {
  const std::string text =
      "FUNCTION Next : INT\nVAR_INPUT x : INT; END_VAR\nVAR_EXTERNAL runs : INT; END_VAR\nNext := x + 1;\n"
      "runs := runs + 1;\nEND_FUNCTION\nCONFIGURATION c\nVAR_GLOBAL runs : INT; END_VAR\nRESOURCE r ON p\n"
      "TASK t(INTERVAL := T#10ms, PRIORITY := 1);\nPROGRAM m WITH t : main;\nEND_RESOURCE\nEND_CONFIGURATION\n" +
      iecProgram("VAR_INPUT e : BOOL; x : INT; END_VAR VAR y : INT; ok : BOOL; END_VAR",
                 "y := Next(EN := e, x := x, ENO => ok);");
  IecRun run(text);
  EXPECT_EQ(run.follow("y", {{"e", {1, 0, 0, 1}}, {"x", {4, 8, 9, 20}}}), (Row{5, 5, 5, 21}));
  EXPECT_EQ(run.get("runs"), 2);
  const std::string asked =
      "//@ prove ok: ok = e\n//@ prove kept: not e implies y = prev(y)\n//@ prove zero: not e implies y = 0\n";
  const IecOutput kept = proofOfIec(asked + text);
  EXPECT_TRUE(kept.has("PROVED  ok") && kept.has("PROVED  kept") && kept.has("VIOLATED  zero")) << kept.text;
  const IecOutput zero = proofOfIec(asked + text, {"--choice", "iec-en-false-result=zero"});
  EXPECT_TRUE(zero.has("PROVED  ok") && zero.has("VIOLATED  kept") && zero.has("PROVED  zero")) << zero.text;
}

// EN that may be FALSE in an expression, and outputs that a function does not have, are refused: nothing is dropped.
TEST(IecEnable, WhatIsNotModelledIsRefused) {
  const auto refused = [](const std::string& call, const std::string& message) {
    const IecOutput output = proofOfIec(
        "//@ prove p: never q\n" + iecProgram("VAR_INPUT a : BOOL; n : INT; END_VAR VAR m : INT; x : REAL; e : BOOL; "
                                              "END_VAR VAR_OUTPUT q : BOOL; END_VAR",
                                              call + "\nq := m > 3;"));
    EXPECT_TRUE(output.has(message) && !output.has("PROVED")) << output.text;
  };
  refused("m := 1 + ADD(EN := a, IN1 := n, IN2 := 1);", "EN inside an expression");
  refused("m := ADD(EN := a, IN1 := n, IN2 := 1, ENO => n);", "ENO needs a BOOL variable");
  refused("m := ADD(IN1 := n, IN2 := 1, OUT => m);", "no output OUT");
}

// What a function takes for an error is not the same everywhere: ENO may be TRUE or FALSE, and the rest is read.
// Without EN nothing runs, so that ENO is FALSE.
TEST(IecEnable, EnoOfWhatCanFailHasAnyValue) {
  for (const std::string call :
       {"n := REAL_TO_INT(EN := a, IN := x, ENO => e);", "x := SQRT(EN := a, IN := x, ENO => e);",
        "n := TRUNC(EN := a, IN := x, ENO => e);", "n := MUX(EN := a, K := n, IN0 := n, IN1 := 3, ENO => e);"}) {
    SCOPED_TRACE(call);
    const std::string local =
        iecProgram("VAR_INPUT a : BOOL; END_VAR VAR x : REAL; n : INT; e, q : BOOL; END_VAR", call + "\nq := a;");
    EXPECT_EQ(verdictOf(local, "q = a"), "PROVED");
    EXPECT_EQ(verdictOf(local, "e implies a"), "PROVED");
    EXPECT_EQ(verdictOf(local, "never a and e"), "VIOLATED");
    EXPECT_EQ(verdictOf(local, "never a and not e"), "VIOLATED");
  }
}

// The spec's micro program 22: outputs are kept while EN is FALSE. ENO is read as a part of the instance.
TEST(IecEnable, InstancesHaveTheirEno) {
  const std::string text = "FUNCTION_BLOCK Add3\nVAR_OUTPUT y : INT; END_VAR\ny := y + 3;\nEND_FUNCTION_BLOCK\n" +
                           iecProgram("VAR_INPUT e : BOOL; END_VAR VAR f : Add3; END_VAR VAR_OUTPUT q : BOOL; END_VAR",
                                      "f(EN := e);\nq := f.ENO;");
  IecRun run(text);
  EXPECT_EQ(run.follow("q", {{"e", {0, 1, 1, 0}}}), (Row{0, 1, 1, 0}));
  EXPECT_EQ(run.get("f.y"), 6);
}

std::string tries(const std::string& tried, const std::string& caught, const std::string& rest = "") {
  return iecProgram(
      "VAR_INPUT a, b : DINT; END_VAR VAR exc : __SYSTEM.ExceptionCode; n, m, z : DINT; END_VAR "
      "VAR_OUTPUT q : BOOL; END_VAR",
      "__TRY\n" + tried + "\n__CATCH(exc)\n" + caught + "\n" + rest + "__ENDTRY\nz := z + 1;");
}

// What stands behind the fault in the tried part does not run; without a fault the caught part does not.
TEST(IecTry, FaultsGoToCatch) {
  IecRun run(tries("m := 1; n := a / b; m := 2;", "q := TRUE; n := -1;"));
  EXPECT_EQ(run.follow("n", {{"a", {8, 8, 9}}, {"b", {2, 0, 3}}}), (Row{4, -1, 3}));
  EXPECT_EQ(run.follow("m", {{"a", {8}}, {"b", {0}}}), (Row{1}));
  EXPECT_EQ(run.get("q"), 1);
  EXPECT_EQ(run.get("z"), 4);
}

TEST(IecTry, FinallyRunsInAnyCase) {
  const std::string text = "//@ prove m: m > 0\n//@ prove caught: b = 0 implies n = -1\n" +
                           tries("n := a MOD b;", "n := -1;", "__FINALLY\nIF m < 9 THEN m := m + 1; END_IF;\n");
  const IecOutput faults = proofOfIec(text, {"--choice", "iec-mod-zero=fault"});
  EXPECT_TRUE(faults.has("PROVED  m") && faults.has("PROVED  caught")) << faults.text;
}

// Both readings of a division by 0: a fault that is caught, or the result 0.
TEST(IecTry, ProofsCoverBothReadings) {
  const std::string text = "//@ prove p: n <> 7\n//@ prove c: b = 0 implies n = 7\n" + tries("n := a / b;", "n := 7;");
  const IecOutput open = proofOfIec(text, {"--builtin"});
  EXPECT_TRUE(open.has("VIOLATED  p") && open.has("VIOLATED  c") && open.has("iec-div-zero = zero")) << open.text;
  EXPECT_FALSE(open.has("error[IEC001]")) << open.text;  // no division by 0 ends the scan
  const IecOutput faults = proofOfIec(text, {"--choice", "iec-div-zero=fault"});
  EXPECT_TRUE(faults.has("PROVED  c")) << faults.text;
}

TEST(IecTry, WhatMayFaultOtherwiseIsRefused) {
  for (const char* tried : {"WHILE a / b > n DO n := n + 1; END_WHILE;", "IF b > 0 AND a / b > 1 THEN n := 1; END_IF;",
                            "IF a > 0 THEN n := 1; ELSIF a / b > 2 THEN n := 2; END_IF;"}) {
    const IecOutput output = proofOfIec("//@ prove p: n < 3\n" + tries(tried, "n := 0;"));
    EXPECT_TRUE(output.has("NOT COVERED  p") && output.has("SYN059")) << output.text;
  }
}

// i stays 0: the loop comes back to the state that it had. The fault that leads there needs a product of 32 bits.
TEST(IecEndless, LoopWithoutAnEndIsShown) {
  const IecOutput output = proofOfIec(
      iecProgram("VAR_INPUT a, b : DINT; END_VAR VAR i : DINT; END_VAR VAR_OUTPUT q : BOOL; END_VAR",
                 "q := a > b;\nIF a = 4711 THEN\n  i := a - 4711;\n  WHILE i < 1 DO\n    q := FALSE;\n    i := i * i;\n"
                 "  END_WHILE;\nEND_IF;"),
      {"--builtin"});
  EXPECT_TRUE(output.has("VIOLATED") && output.has("the scan does not end")) << output.text;
}

// 20,000 rounds end, however long they take.
TEST(IecEndless, LongLoopsEnd) {
  IecRun run(iecProgram("VAR i, n : DINT; END_VAR", "i := 0;\nWHILE i < 20000 DO i := i + 1; END_WHILE;\nn := n + 1;"));
  run.scan();
  EXPECT_EQ(run.get("n"), 1);
  EXPECT_TRUE(run.simulator.isRunning());
}

// Calls of one block at several places leave memory as it was, each with a loop of its own: they end.
TEST(IecEndless, SeveralCallsOfOneBlockEnd) {
  std::string calls;
  for (int i = 0; i < 200; ++i) calls += "f();\n";
  IecRun run(
      "FUNCTION_BLOCK Twice\nVAR k : INT; END_VAR\nk := 0;\nWHILE k < 2 DO k := k + 1; END_WHILE;\n"
      "END_FUNCTION_BLOCK\n" +
      iecProgram("VAR i, n : DINT; f : Twice; END_VAR",
                 "i := 0;\nWHILE i < 20000 DO i := i + 1; END_WHILE;\n" + calls + "n := n + 1;"));
  run.scan();
  EXPECT_TRUE(run.simulator.isRunning());
  EXPECT_EQ(run.get("n"), 1);
}

// Nothing that can go wrong at run time: that is an answer, not "nothing was checked".
TEST(IecEndless, NothingToGoWrongIsProved) {
  const IecOutput output =
      proofOfIec(iecProgram("VAR_INPUT a : BOOL; END_VAR VAR_OUTPUT q : BOOL; END_VAR", "q := a;"), {"--builtin"});
  EXPECT_EQ(output.exit, 0) << output.text;
  EXPECT_TRUE(output.has("PROVED  no error at run time can happen")) << output.text;
}

// What an editor appends for its debugger is C: *) stands in it.
TEST(IecText, DebuggerLinesAreComments) {
  const IecOutput output = proofOfIec(
      "//@ prove p: q = a\n" + iecProgram("VAR_INPUT a : BOOL; END_VAR VAR_OUTPUT q : BOOL; END_VAR", "q := a;") +
      "(*DBG:  return (void *)&((t *) ptr)->value;*)\n(*DBG:}*)\n");
  EXPECT_TRUE(output.has("PROVED  p")) << output.text;
}

// ': =' is no assignment for a compiler, and its writer means one.
TEST(IecText, BlankInAnAssignmentIsAWarning) {
  const std::string text =
      "//@ prove p: q = a\n" + iecProgram("VAR_INPUT a : BOOL; END_VAR VAR_OUTPUT q : BOOL; END_VAR", "q : = a;");
  EXPECT_TRUE(proofOfIec(text).has("PROVED  p"));
  const IecOutput linted = runIec({"lint"}, text);
  EXPECT_TRUE(linted.has("warning[SYN062]")) << linted.text;
}

}  // namespace
}  // namespace rungproof
