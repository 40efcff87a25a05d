// Rules on IEC 61131-3 programs. Each case has a reason, whether the rule speaks, and declarations and statements of a
// program, or a whole text. What is expected stands in the reason: the standard's words or what the statements do.
#include <gtest/gtest.h>

#include "ir/s7200/cpu.hpp"
#include "tests/rules/lint.hpp"

namespace rungproof::testing {
namespace {

struct IecCase {
  const char* reason;
  std::size_t findings;
  std::string text;
};

/// A program of those variables (VAR) and statements; inputs a, b, c : BOOL, outputs q, r : BOOL.
std::string main61131(const std::string& variables, const std::string& statements) {
  return "PROGRAM Main\nVAR_INPUT a, b, c : BOOL; END_VAR\n" +
         (variables.empty() ? "" : "VAR " + variables + " END_VAR\n") + "VAR_OUTPUT q, r : BOOL; END_VAR\n" +
         statements + "\nEND_PROGRAM\n";
}

void expectIecFindings(const char* rule, const std::vector<IecCase>& cases) {
  const Cpu cpu = *cpuNamed("IEC-4K");
  for (const IecCase& each : cases) {
    SCOPED_TRACE(std::string(rule) + ": " + each.reason);
    const Linted linted(each.text, {cpu, usualEdition(cpu)});
    for (const Finding& finding : linted.program.findings)
      EXPECT_NE(finding.severity, Severity::Error) << finding.message;
    std::string told;
    const std::vector<Finding> findings = linted.of(rule);
    for (const Finding& finding : findings) told += finding.message + "\n";
    EXPECT_EQ(findings.size(), each.findings) << told << each.text;
  }
}

TEST(IecRules, UnusedVariable) {
  expectIecFindings(
      "IEC002",
      {{"local", 1, main61131("n : INT;", "q := a;")},
       {"temporary, constant", 2,
        "PROGRAM m\nVAR_TEMP t : INT; END_VAR\nVAR CONSTANT k : INT := 3; END_VAR\nVAR_OUTPUT q : BOOL; END_VAR\n"
        "q := TRUE;\nEND_PROGRAM\n"},
       {"an input of a function", 1,
        main61131("", "q := F(a, b);") + "FUNCTION F : BOOL\nVAR_INPUT x, y : BOOL; END_VAR\nF := x;\nEND_FUNCTION\n"},
       {"an instance", 1, main61131("t : TON;", "q := a;")},
       {"a structure", 1, "TYPE S : STRUCT x : INT; END_STRUCT; END_TYPE\n" + main61131("s : S;", "q := a;")},
       {"a global", 1,
        "CONFIGURATION c\nVAR_GLOBAL g, h : BOOL; END_VAR\nRESOURCE r ON p\nTASK t(INTERVAL := T#10ms, PRIORITY := "
        "1);\n"
        "PROGRAM m WITH t : Main;\nEND_RESOURCE\nEND_CONFIGURATION\nPROGRAM Main\nVAR_EXTERNAL g : BOOL; END_VAR\n"
        "VAR_OUTPUT q : BOOL; END_VAR\nq := g;\nEND_PROGRAM\n"},
       {"read, written, called, as an index, as a bound", 0,
        main61131("n, i, k : INT; x : ARRAY[0..3] OF INT; t : TON; d : DINT;",
                  "n := 1; FOR i := 0 TO k DO x[n] := i; END_FOR; t(IN := a, PT := T#1s); d.1 := a; q := t.Q;")},
       {"pins of a program and terminals", 0,
        "PROGRAM m\nVAR_INPUT x : BOOL; END_VAR\nVAR_OUTPUT y : BOOL; END_VAR\nVAR z AT %IX0.0 : BOOL; w AT %QX0.0 : "
        "BOOL; END_VAR\n"
        "w := TRUE;\nEND_PROGRAM\n"},
       {"a property asks for it", 0, "//@ prove p: never m\n" + main61131("m : BOOL;", "q := a;")},
       {"spelt in other case", 0, main61131("Count : INT;", "COUNT := count + 1;")},
       {"only an output parameter receives it", 0, main61131("e : TIME; t : TON;", "t(IN := a, PT := T#1s, ET => e);")},
       {"a field only", 0, "TYPE S : STRUCT x : INT; END_STRUCT; END_TYPE\n" + main61131("s : S;", "s.x := 1;")}});
}

TEST(IecRules, ReadNeverWritten) {
  expectIecFindings(
      "IEC003",
      {{"in a condition", 1, main61131("m : BOOL;", "IF m THEN q := a; END_IF;")},
       {"as an argument", 1, main61131("p : TIME; t : TON;", "t(IN := a, PT := p); q := t.Q;")},
       {"as an index", 1, main61131("i : INT; x : ARRAY[0..3] OF BOOL;", "x[0] := a; q := x[i];")},
       {"with an initial value of its own: a note", 1, main61131("m : BOOL := TRUE;", "q := a AND m;")},
       {"as a bound", 1, main61131("i, n, s : INT;", "FOR i := 1 TO n DO s := s + i; END_FOR; q := s > 3;")},
       {"as a selector", 1, main61131("n : INT;", "CASE n OF 1: q := a; ELSE q := b; END_CASE;")},
       {"written in a branch", 0, main61131("m : BOOL;", "IF a THEN m := b; END_IF; q := m;")},
       {"written as an element, a field, a bit", 0,
        "TYPE S : STRUCT x : BOOL; END_STRUCT; END_TYPE\n" +
            main61131("x : ARRAY[0..1] OF BOOL; s : S; w : WORD;",
                      "x[0] := a; s.x := b; w.3 := c; q := x[1] OR s.x OR w.0;")},
       {"written by an output of a call", 0,
        main61131("m : BOOL; t : TON;", "t(IN := a, PT := T#1s, Q => m); q := m;")},
       {"written through VAR_IN_OUT", 0,
        main61131("n : INT; f : F;", "f(x := n); q := n > 2;") +
            "FUNCTION_BLOCK F\nVAR_IN_OUT x : INT; END_VAR\nx := x + 1;\nEND_FUNCTION_BLOCK\n"},
       {"constants, terminals, inputs", 0,
        "PROGRAM m\nVAR CONSTANT k : INT := 3; END_VAR\nVAR i AT %IX0.0 : BOOL; END_VAR\nVAR_OUTPUT q : BOOL; END_VAR\n"
        "q := i AND k > 2;\nEND_PROGRAM\n"},
       {"counters of loops", 0, main61131("i, s : INT;", "FOR i := 1 TO 3 DO s := s + i; END_FOR; q := s > 3;")}});
}

TEST(IecRules, WrittenNeverRead) {
  expectIecFindings(
      "IEC004",
      {{"a local", 1, main61131("n : INT;", "n := 5; q := a;")},
       {"two of three", 2, main61131("m, n, k : BOOL;", "m := a; n := b; k := c; q := k;")},
       {"elements of an array", 1, main61131("x : ARRAY[0..3] OF INT;", "x[0] := 1; q := a;")},
       {"an output of a call", 1, main61131("e : TIME; t : TON;", "t(IN := a, PT := T#1s, ET => e); q := t.Q;")},
       {"in a block", 1,
        main61131("f : F;", "f(x := a);") +
            "FUNCTION_BLOCK F\nVAR_INPUT x : BOOL; END_VAR\nVAR y : BOOL; END_VAR\ny := x;\nEND_FUNCTION_BLOCK\n"},
       {"in a branch only", 1, main61131("m : BOOL;", "IF a THEN m := TRUE; END_IF; q := b;")},
       {"it counts itself", 0, main61131("n : INT;", "n := n + 1;")},
       {"outputs are for others", 0, main61131("", "q := a; r := b;")},
       {"terminals", 0, "PROGRAM m\nVAR x AT %QX0.0 : BOOL; END_VAR\nx := TRUE;\nEND_PROGRAM\n"},
       {"a property reads it", 0, "//@ prove p: n < 6\n" + main61131("n : INT;", "n := 5;")},
       {"read in front of the write", 0, main61131("m : BOOL;", "q := m; m := a;")},
       {"the counter of a loop: the loop reads it", 0,
        main61131("i, s : INT;", "s := 0; FOR i := 1 TO 3 DO s := s + 1; END_FOR; q := s > 2;")}});
}

TEST(IecRules, ResultNotAssigned) {
  const auto function = [](const std::string& body) {
    return main61131("n : INT;", "n := F(1); q := n > 0; r := a;") +
           "FUNCTION F : INT\nVAR_INPUT x : INT; END_VAR\nVAR y : INT; END_VAR\n" + body + "\nEND_FUNCTION\n";
  };
  expectIecFindings(
      "IEC005",
      {{"never", 2,
        function("y := x;").replace(
            0, 0,
            "FUNCTION_BLOCK B\nVAR_OUTPUT o : INT; END_VAR\nVAR z : INT; END_VAR\nz := 1;\nEND_FUNCTION_BLOCK\n")},
       {"IF without ELSE", 1, function("IF x > 0 THEN F := 1; END_IF;")},
       {"one branch of three", 1, function("IF x > 0 THEN F := 1; ELSIF x < -5 THEN y := 1; ELSE F := 2; END_IF;")},
       {"RETURN in front of it", 1, function("IF x > 0 THEN RETURN; END_IF; F := 1;")},
       {"CASE without ELSE", 1, function("CASE x OF 1: F := 1; 2: F := 2; END_CASE;")},
       {"in a loop that may not run", 1, function("FOR y := 1 TO x DO F := y; END_FOR;")},
       {"in a WHILE", 1, function("WHILE y < x DO F := y; y := y + 1; END_WHILE;")},
       {"at once", 0, function("F := x;")},
       {"first, then in a branch", 0, function("F := 0; IF x > 0 THEN F := 1; END_IF;")},
       {"in both branches", 0, function("IF x > 0 THEN F := 1; ELSE F := 2; END_IF;")},
       {"in all of CASE", 0, function("CASE x OF 1: F := 1; ELSE F := 2; END_CASE;")},
       {"REPEAT runs once at least", 0, function("REPEAT F := y; y := y + 1; UNTIL y > x END_REPEAT;")},
       {"RETURN behind it", 0, function("F := 1; IF x > 0 THEN RETURN; END_IF; F := 2;")},
       {"the other branch has left", 0, function("IF x > 0 THEN F := 1; RETURN; END_IF; F := 3;")},
       {"an output in one branch", 1,
        main61131("n : INT;", "n := 1; q := n > 0; r := a;") +
            "FUNCTION F : INT\nVAR_INPUT x : INT; END_VAR\nVAR_OUTPUT o : INT; END_VAR\nF := x;\n"
            "IF x > 0 THEN o := 1; END_IF;\nEND_FUNCTION\n"},
       {"an output in both branches", 0,
        main61131("n : INT;", "n := 1; q := n > 0; r := a;") +
            "FUNCTION F : INT\nVAR_INPUT x : INT; END_VAR\nVAR_OUTPUT o : INT; END_VAR\nF := x;\n"
            "IF x > 0 THEN o := 1; ELSE o := 2; END_IF;\nEND_FUNCTION\n"},
       {"an output of a block keeps its value", 0,
        main61131("n : INT;", "n := 1; q := n > 0; r := a;") +
            "FUNCTION_BLOCK B\nVAR_INPUT x : INT; END_VAR\nVAR_OUTPUT o : INT; END_VAR\nIF x > 0 THEN o := 1; "
            "END_IF;\nEND_FUNCTION_BLOCK\n"}});
}

TEST(IecRules, ValueOverwritten) {
  expectIecFindings(
      "IEC006", {{"two coils", 1, main61131("", "q := a; q := b;")},
                 {"RETURN behind it: the last value is not written then", 0,
                  main61131("", "IF a THEN q := b; RETURN; END_IF; q := c;")},
                 {"the same in each of two, and in ELSE", 0,
                  main61131("",
                            "IF a THEN q := b; RETURN; END_IF; IF b THEN q := c; ELSE q := a; RETURN; END_IF; "
                            "q := c AND a;")},
                 {"EXIT leaves the loop", 0,
                  main61131("i : INT;", "FOR i := 0 TO 3 DO IF a THEN q := b; EXIT; END_IF; q := c; END_FOR;")},
                 {"CONTINUE leaves the round", 0,
                  main61131("i : INT;", "FOR i := 0 TO 3 DO IF a THEN q := b; CONTINUE; END_IF; q := c; END_FOR;")},
                 {"nothing leaves", 1, main61131("", "IF a THEN q := b; END_IF; q := c;")},
                 {"three", 2, main61131("", "q := a; q := b; q := c;")},
                 {"a branch in front", 1, main61131("", "IF a THEN q := TRUE; END_IF; q := b;")},
                 {"within a branch", 1, main61131("", "IF a THEN q := b; r := c; q := c; END_IF;")},
                 {"other statements between", 1, main61131("n : INT;", "q := a; n := n + 1; r := n > 3; q := b;")},
                 {"in a loop", 1, main61131("i, s : INT;", "FOR i := 0 TO 3 DO s := 1; s := i; END_FOR; q := s > 2;")},
                 {"read between", 0, main61131("", "q := a; r := q; q := b;")},
                 {"read by the second one", 0, main61131("", "q := a; q := q OR b;")},
                 {"the second one is conditional", 0, main61131("", "q := FALSE; IF a THEN q := TRUE; END_IF;")},
                 {"the scan may end between", 0, main61131("", "q := a; IF b THEN RETURN; END_IF; q := c;")},
                 {"elements", 0, main61131("x : ARRAY[0..1] OF BOOL;", "x[0] := a; x[1] := b; q := x[0]; r := x[1];")},
                 {"exclusive branches", 0, main61131("", "IF a THEN q := b; ELSE q := c; END_IF;")},
                 {"a condition between reads it", 0, main61131("", "q := a; IF q THEN r := b; END_IF; q := c;")}});
}

TEST(IecRules, InstanceNotCalled) {
  const std::string block =
      "FUNCTION_BLOCK F\nVAR_INPUT x : BOOL; END_VAR\nVAR_OUTPUT y : BOOL; END_VAR\ny := NOT x;\nEND_FUNCTION_BLOCK\n";
  expectIecFindings(
      "IEC007",
      {{"a timer", 1, main61131("t : TON;", "q := t.Q;")},
       {"a block of its own", 1, main61131("f : F;", "q := f.y;") + block},
       {"only its pin is written", 1, main61131("f : F;", "f.x := a; q := b;") + block},
       {"a counter", 1, main61131("n : CTU;", "q := n.CV > 3;")},
       {"one of two", 1, main61131("f, g : F;", "f(x := a); q := f.y OR g.y;") + block},
       {"in a block", 1,
        main61131("f : F;", "f(x := a); q := f.y;") +
            "FUNCTION_BLOCK F\nVAR_INPUT x : BOOL; END_VAR\nVAR_OUTPUT y : BOOL; END_VAR\nVAR e : R_TRIG; END_VAR\n"
            "y := x AND e.Q;\nEND_FUNCTION_BLOCK\n"},
       {"called", 0, main61131("t : TON;", "t(IN := a, PT := T#1s); q := t.Q;")},
       {"called in a branch", 0, main61131("t : TON;", "IF b THEN t(IN := a, PT := T#1s); END_IF; q := t.Q;")},
       {"called behind its use", 0, main61131("t : TON;", "q := t.Q; t(IN := a, PT := T#1s);")},
       {"not used at all: IEC002", 0, main61131("t : TON;", "q := a;")},
       {"in another case", 0, main61131("Delay : TON;", "DELAY(IN := a, PT := T#1s); q := delay.Q;")},
       {"handed on", 0,
        main61131("t : TON; g : G;", "g(z := t); q := t.Q;") +
            "FUNCTION_BLOCK G\nVAR_IN_OUT z : TON; END_VAR\nz(IN := TRUE, PT := T#1s);\nEND_FUNCTION_BLOCK\n"}});
}

TEST(IecRules, CalledTwice) {
  expectIecFindings(
      "IEC008",
      {{"an edge", 1, main61131("e : R_TRIG;", "e(CLK := a); q := e.Q; e(CLK := b); r := e.Q;")},
       {"a timer", 1, main61131("t : TON;", "t(IN := a, PT := T#1s); t(IN := b, PT := T#2s); q := t.Q;")},
       {"at the top and in a branch", 1,
        main61131("n : CTU;", "n(CU := a, PV := 3); IF b THEN n(R := TRUE); END_IF; q := n.Q;")},
       {"in two IFs", 1,
        main61131("t : TP;",
                  "IF a THEN t(IN := TRUE, PT := T#1s); END_IF; IF b THEN t(IN := FALSE); END_IF; q := t.Q;")},
       {"an edge in a branch: a note", 1, main61131("e : F_TRIG;", "IF a THEN e(CLK := b); END_IF; q := e.Q;")},
       {"a counter in CASE: a note", 1,
        main61131("s : INT; n : CTU;", "CASE s OF 1: n(CU := a, PV := 3); END_CASE; s := 1; q := n.Q;")},
       {"once", 0, main61131("e : R_TRIG;", "e(CLK := a); q := e.Q;")},
       {"in two branches of one IF", 0,
        main61131("t : TON;", "IF a THEN t(IN := b, PT := T#1s); ELSE t(IN := FALSE, PT := T#1s); END_IF; q := t.Q;")},
       {"taken back, to begin anew", 0,
        main61131("t : TON;", "t(IN := a, PT := T#1s); IF t.Q THEN q := NOT q; t(IN := FALSE); END_IF;")},
       {"taken back by a variable", 1,
        main61131("t : TON;", "t(IN := a, PT := T#1s); IF t.Q THEN q := NOT q; t(IN := b); END_IF;")},
       {"a timer in a branch goes on by itself", 0,
        main61131("t : TON;", "IF a THEN t(IN := b, PT := T#1s); END_IF; q := t.Q;")},
       {"two instances", 0, main61131("e, f : R_TRIG;", "e(CLK := a); f(CLK := b); q := e.Q; r := f.Q;")},
       {"a block of the project", 0,
        main61131("f : F;", "f(x := 1); f(x := 2); q := f.y > 2;") +
            "FUNCTION_BLOCK F\nVAR_INPUT x : INT; END_VAR\nVAR_OUTPUT y : INT; END_VAR\ny := y + "
            "x;\nEND_FUNCTION_BLOCK\n"},
       {"in two branches of CASE", 0,
        main61131("s : INT; t : TON;",
                  "s := 1; CASE s OF 1: t(IN := a, PT := T#1s); 2: t(IN := FALSE); END_CASE; q := t.Q;")}});
}

TEST(IecRules, NameHidden) {
  const auto project = [](const std::string& globals, const std::string& rest) {
    return "CONFIGURATION c\nVAR_GLOBAL " + globals +
           " END_VAR\nRESOURCE r ON p\nTASK t(INTERVAL := T#10ms, PRIORITY := 1);\nPROGRAM m WITH t : "
           "Main;\nEND_RESOURCE\n"
           "END_CONFIGURATION\n" +
           rest;
  };
  expectIecFindings(
      "IEC009",
      {{"a local", 1, project("g : BOOL;", main61131("g : BOOL;", "g := a; q := g;"))},
       {"an input", 1, project("a : BOOL;", main61131("", "q := a;"))},
       {"in another case", 1, project("Fault : BOOL;", main61131("FAULT : BOOL;", "fault := a; q := fault;"))},
       {"a function", 1,
        main61131("F : BOOL;", "F := a; q := F;") +
            "FUNCTION F : BOOL\nVAR_INPUT x : BOOL; END_VAR\nF := x;\nEND_FUNCTION\n"},
       {"in a block", 1,
        project("g : BOOL;", main61131("f : Blk;", "f(); q := f.y;") +
                                 "FUNCTION_BLOCK Blk\nVAR g : BOOL; END_VAR\nVAR_OUTPUT y : BOOL; "
                                 "END_VAR\ng := NOT g; y := g;\nEND_FUNCTION_BLOCK\n")},
       {"two of them", 2, project("g, h : BOOL;", main61131("g, h : BOOL;", "g := a; h := b; q := g AND h;"))},
       {"external", 0,
        project("g : BOOL;",
                "PROGRAM Main\nVAR_EXTERNAL g : BOOL; END_VAR\nVAR_OUTPUT q : BOOL; END_VAR\nq := g;\nEND_PROGRAM\n")},
       {"other names", 0, project("g : BOOL;", main61131("h : BOOL;", "h := a; q := h;"))},
       {"two blocks with one name each for themselves", 0,
        main61131("n : BOOL; f : Blk;", "n := a; f(); q := n;") +
            "FUNCTION_BLOCK Blk\nVAR n : BOOL; END_VAR\nn := NOT n;\nEND_FUNCTION_BLOCK\n"},
       {"the name of a standard block", 0, main61131("ton1 : TON;", "ton1(IN := a, PT := T#1s); q := ton1.Q;")},
       {"a field", 0,
        project("x : BOOL;",
                "TYPE S : STRUCT x : BOOL; END_STRUCT; END_TYPE\n" + main61131("s : S;", "s.x := a; q := s.x;"))},
       {"an enumerator is no variable", 0,
        "TYPE E : (one, two); END_TYPE\n" + main61131("e : E;", "e := two; q := e = one;")}});
}

TEST(IecRules, CaseLeavesOut) {
  const std::string type = "TYPE State : (Idle, Run, Stop); END_TYPE\n";
  expectIecFindings(
      "IEC010",
      {{"one", 1, type + main61131("s : State;", "CASE s OF Idle: s := Run; Run: s := Stop; END_CASE; q := s = Run;")},
       {"two", 1, type + main61131("s : State;", "CASE s OF Stop: s := Idle; END_CASE; q := s = Run;")},
       {"with the name of the type", 1,
        type +
            main61131("s : State;", "CASE s OF State#Idle: s := Run; State#Run: s := Stop; END_CASE; q := s = Run;")},
       {"several labels at once", 1,
        type + main61131("s : State;", "CASE s OF Idle, Run: s := Run; END_CASE; q := s = Run;")},
       {"an enumeration in the declaration", 1,
        main61131("s : (one, two);", "CASE s OF one: s := two; END_CASE; q := s = two;")},
       {"two of them", 2,
        type + main61131("s : State;",
                         "CASE s OF Idle: s := Run; END_CASE; CASE s OF Run: s := Idle; END_CASE; q := s = Run;")},
       {"all", 0,
        type + main61131("s : State;",
                         "CASE s OF Idle: s := Run; Run: s := Stop; Stop: s := Idle; END_CASE; q := s = Run;")},
       {"ELSE", 0, type + main61131("s : State;", "CASE s OF Idle: s := Run; ELSE s := Idle; END_CASE; q := s = Run;")},
       {"an empty ELSE says that it is meant", 0,
        type + main61131("s : State;", "CASE s OF Idle: s := Run; ELSE ; END_CASE; q := s = Run;")},
       {"numbers", 0, main61131("n : INT;", "CASE n OF 1: n := 2; END_CASE; q := n = 2;")},
       {"in another case", 0,
        type + main61131("s : State;",
                         "CASE s OF IDLE: s := Run; run: s := Stop; stop: s := Idle; END_CASE; q := s = Run;")},
       {"IF is no CASE", 0, type + main61131("s : State;", "IF s = Idle THEN s := Run; END_IF; q := s = Run;")}});
}

TEST(IecRules, CaseLabelTwice) {
  const auto cases = [](const std::string& labels) {
    return main61131("n : INT;", "CASE n OF " + labels + " END_CASE; n := n + 1;");
  };
  expectIecFindings("IEC011",
                    {{"a number", 1, cases("1: q := a; 1: q := b;")},
                     {"in one list", 1, cases("1, 2, 1: q := a;")},
                     {"in a range", 1, cases("1..5: q := a; 3: q := b;")},
                     {"ranges that overlap", 1, cases("1..5: q := a; 5..9: q := b;")},
                     {"in what an overlapping range has left", 2, cases("1..5: q := a; 3..9: q := b; 8: q := a;")},
                     {"a range over several", 1, cases("1: q := a; 5: q := b; 0..9: q := a;")},
                     {"a range around a number", 1, cases("-2: q := a; -5..0: q := b;")},
                     {"an enumerator", 1,
                      "TYPE E : (one, two); END_TYPE\n" +
                          main61131("e : E;", "CASE e OF one: e := two; one: e := one; END_CASE; q := e = two;")},
                     {"apart", 0, cases("1: q := a; 2: q := b;")},
                     {"ranges beside each other", 0, cases("1..4: q := a; 5..9: q := b;")},
                     {"signs", 0, cases("1: q := a; -1: q := b;")},
                     {"another CASE", 0,
                      cases("1: q := a;") + "FUNCTION G : INT\nVAR_INPUT x : INT; END_VAR\nCASE x OF 1: G := 1; ELSE G "
                                            ":= 2; END_CASE;\nEND_FUNCTION\n"},
                     {"underscores", 1, cases("1_000: q := a; 1000: q := b;")},
                     {"enumerators apart", 0,
                      "TYPE E : (one, two); END_TYPE\n" +
                          main61131("e : E;", "CASE e OF one: e := two; two: e := one; END_CASE; q := e = two;")}});
}

TEST(IecRules, RealCompared) {
  expectIecFindings(
      "IEC012",
      {{"variable and literal", 1, main61131("x : REAL;", "x := x + 1.5; q := x = 3.0;")},
       {"two variables", 1, main61131("x, y : REAL;", "x := y; q := x <> y;")},
       {"a sum", 1, main61131("x : REAL;", "x := 1.0; q := x + 1.0 = 2.5;")},
       {"a function", 1, main61131("x : REAL;", "x := 1.0; q := SQRT(x) = 2.5;")},
       {"a field", 1,
        "TYPE S : STRUCT v : REAL; END_STRUCT; END_TYPE\n" + main61131("s : S;", "s.v := 1.0; q := s.v = 3.5;")},
       {"an element, in a condition", 1,
        main61131("x : ARRAY[0..1] OF REAL;", "x[0] := 1.0; IF x[1] = x[0] THEN q := a; END_IF;")},
       {"<", 0, main61131("x : REAL;", "x := x + 1.5; q := x < 3.0;")},
       {"zero", 0, main61131("x : REAL;", "x := x + 1.5; q := x = 0.0;")},
       {"whole numbers", 0, main61131("n : INT;", "n := n + 1; q := n = 3;")},
       {"rounded before", 0, main61131("x : REAL;", "x := 1.0; q := REAL_TO_INT(x) = 3;")},
       {"an assignment is none", 0, main61131("x : REAL;", "x := 3.0;")},
       {"a BOOL from a comparison", 0, main61131("x : REAL;", "x := 1.0; q := (x > 3.0) = a;")},
       {"whether it is no number", 0, main61131("x : REAL;", "x := x + 1.5; q := x <> x;")}});
}

TEST(IecRules, SameOnBothSides) {
  expectIecFindings("IEC013",
                    {{"AND", 1, main61131("", "q := a AND a;")},
                     {"OR in another case", 1, main61131("", "q := A OR a;")},
                     {"a comparison", 1, main61131("n : INT;", "n := n + 1; q := n > n;")},
                     {"elements", 1, main61131("x : ARRAY[0..1] OF INT;", "x[0] := 1; q := x[0] = x[0];")},
                     {"a chain", 1, main61131("", "q := a AND b AND b;")},
                     {"a difference", 1, main61131("n : INT;", "n := n - n;")},
                     {"others", 0, main61131("", "q := a AND b;")},
                     {"other elements", 0, main61131("x : ARRAY[0..1] OF INT;", "x[0] := 1; q := x[0] = x[1];")},
                     {"a square", 0, main61131("n : INT;", "n := n * n;")},
                     {"doubled", 0, main61131("n : INT;", "n := n + n;")},
                     {"literals", 0, main61131("n : INT;", "n := 8 / 8;")},
                     {"negated", 0, main61131("", "q := a OR NOT a;")},
                     {"whether a REAL is no number", 0, main61131("x : REAL;", "x := x + 1.5; q := x <> x;")}});
}

TEST(IecRules, NeverRuns) {
  expectIecFindings(
      "IEC014",
      {{"behind RETURN", 1, main61131("", "IF a THEN RETURN; q := b; END_IF; q := c;")},
       {"behind EXIT", 1, main61131("i : INT;", "FOR i := 1 TO 3 DO IF a THEN EXIT; q := b; END_IF; END_FOR;")},
       {"IF FALSE", 1, main61131("", "IF FALSE THEN q := b; END_IF;")},
       {"ELSE of TRUE", 1, main61131("", "IF TRUE THEN q := b; ELSE q := c; END_IF;")},
       {"WHILE FALSE", 1, main61131("n : INT;", "WHILE FALSE DO n := n + 1; END_WHILE;")},
       {"ELSIF behind TRUE", 1, main61131("", "IF TRUE THEN q := b; ELSIF a THEN q := c; END_IF;")},
       {"RETURN at the end", 0, main61131("", "q := a; RETURN;")},
       {"in a branch", 0, main61131("", "IF a THEN RETURN; END_IF; q := b;")},
       {"a condition", 0, main61131("", "IF a THEN q := b; ELSE q := c; END_IF;")},
       {"a loop that ends by EXIT", 0,
        main61131("n : INT;", "WHILE TRUE DO n := n + 1; IF n > 3 THEN EXIT; END_IF; END_WHILE; q := n > 3;")},
       {"EXIT at the end of a branch", 0,
        main61131("i : INT;", "FOR i := 1 TO 3 DO IF a THEN q := b; EXIT; END_IF; END_FOR;")},
       {"CASE", 0, main61131("n : INT;", "n := 1; CASE n OF 1: q := a; ELSE q := b; END_CASE;")}});
}

// No input changes within a scan: a loop ends by what it writes itself.
TEST(IecRules, LoopsThatDoNotEnd) {
  expectIecFindings(
      "IEC020",
      {{"WHILE on an input", 1, main61131("n : INT;", "WHILE NOT a DO n := n + 1; END_WHILE; q := n > 3;")},
       {"REPEAT on an input", 1, main61131("n : INT;", "REPEAT n := n + 1; UNTIL a END_REPEAT; q := n > 3;")},
       {"for ever", 1, main61131("n : INT;", "WHILE TRUE DO n := n + 1; END_WHILE; q := n > 3;")},
       {"REPEAT for ever", 1, main61131("n : INT;", "REPEAT n := n + 1; UNTIL FALSE END_REPEAT; q := n > 3;")},
       {"EXIT of an inner loop", 1,
        main61131("n : INT;", "WHILE NOT a DO WHILE TRUE DO n := n + 1; EXIT; END_WHILE; END_WHILE; q := n > 3;")},
       {"a step of 0", 1, main61131("i, n : INT;", "FOR i := 1 TO 5 BY 0 DO n := n + i; END_FOR; q := n > 3;")},
       {"the greatest number", 1,
        main61131("i : USINT; n : INT;", "FOR i := 0 TO 255 DO n := n + 1; END_FOR; q := n > 3;")},
       {"down to the least number", 1,
        main61131("i, n : INT;", "FOR i := 9 TO -32768 BY -1 DO n := n + 1; END_FOR; q := n > 3;")},
       {"down to one above it", 0,
        main61131("i, n : INT;", "FOR i := 9 TO -32767 BY -1 DO n := n + 1; END_FOR; q := n > 3;")},
       {"it counts", 0, main61131("n : INT;", "WHILE n < 5 DO n := n + 1; END_WHILE; q := n > 3;")},
       {"EXIT", 0,
        main61131("n : INT;", "WHILE TRUE DO n := n + 1; IF n > 5 THEN EXIT; END_IF; END_WHILE; q := n > 3;")},
       {"RETURN", 0,
        main61131("n : INT;", "WHILE NOT a DO n := n + 1; IF n > 5 THEN RETURN; END_IF; END_WHILE; q := n > 3;")},
       {"never", 0, main61131("n : INT;", "WHILE FALSE DO n := n + 1; END_WHILE; q := n > 3;")},
       {"once", 0, main61131("n : INT;", "REPEAT n := n + 1; UNTIL TRUE END_REPEAT; q := n > 3;")},
       {"one below the greatest", 0,
        main61131("i : USINT; n : INT;", "FOR i := 0 TO 254 DO n := n + 1; END_FOR; q := n > 3;")},
       {"an instance that is called", 0,
        main61131("f : R_TRIG; n : INT;",
                  "WHILE NOT f.Q AND n < 9 DO f(CLK := TRUE); n := n + 1; END_WHILE; q := n > 3;")},
       {"an element", 0,
        main61131("x : ARRAY[1..3] OF INT;", "WHILE x[1] < 5 DO x[1] := x[1] + 1; END_WHILE; q := x[1] > 3;")}});
}

TEST(IecRules, LoopCounterWritten) {
  const auto loop = [](const std::string& body) {
    return main61131("i, j, n : INT;", "FOR i := 1 TO 9 DO " + body + " END_FOR; q := n > j;");
  };
  expectIecFindings(
      "IEC015",
      {{"assigned", 1, loop("i := i + 1; n := i;")},
       {"in a branch", 1, loop("IF a THEN i := 10; END_IF; n := i;")},
       {"in an inner loop", 1, loop("FOR j := 1 TO 3 DO i := j; END_FOR; n := i;")},
       {"the counter of an inner loop", 1, loop("FOR i := 1 TO 3 DO n := n + 1; END_FOR;")},
       {"twice", 2, loop("i := 1; n := i; i := 2;")},
       {"in another case", 1, loop("I := 3; n := i;")},
       {"read", 0, loop("n := n + i;")},
       {"another variable", 0, loop("j := j + i; n := j;")},
       {"behind the loop", 0, main61131("i, n : INT;", "FOR i := 1 TO 3 DO n := n + i; END_FOR; i := 0; q := n > i;")},
       {"an element with that index", 0,
        main61131("i : INT; x : ARRAY[1..9] OF INT;", "FOR i := 1 TO 9 DO x[i] := i; END_FOR; q := x[1] > 0;")},
       {"WHILE writes its variable", 0, main61131("i : INT;", "WHILE i < 5 DO i := i + 1; END_WHILE; q := i > 3;")},
       {"EXIT", 0, loop("n := n + 1; IF n > 5 THEN EXIT; END_IF;")}});
}

TEST(IecRules, InputWritten) {
  expectIecFindings(
      "IEC016",
      {{"of the program", 1, main61131("", "q := a; a := FALSE;")},
       {"of a block", 1,
        main61131("f : F;", "f(x := a); q := f.y;") + "FUNCTION_BLOCK F\nVAR_INPUT x : BOOL; END_VAR\nVAR_OUTPUT y : "
                                                      "BOOL; END_VAR\ny := x; x := FALSE;\nEND_FUNCTION_BLOCK\n"},
       {"of a function", 1,
        main61131("n : INT;", "n := F(5); q := n > 2;") +
            "FUNCTION F : INT\nVAR_INPUT x : INT; END_VAR\nx := x + 1; F := x;\nEND_FUNCTION\n"},
       {"a terminal", 1,
        "PROGRAM m\nVAR s AT %IX0.0 : BOOL; q AT %QX0.0 : BOOL; END_VAR\nq := s; s := FALSE;\nEND_PROGRAM\n"},
       {"an element", 1,
        "PROGRAM m\nVAR_INPUT x : ARRAY[0..1] OF INT; END_VAR\nVAR_OUTPUT q : INT; END_VAR\nx[0] := 1; q := "
        "x[0];\nEND_PROGRAM\n"},
       {"by an output of a call", 1, main61131("t : TON;", "t(IN := b, PT := T#1s, Q => a); q := a;")},
       {"read", 0, main61131("", "q := a;")},
       {"the caller writes the pin of an instance", 0,
        main61131("f : F;", "f.x := a; f(); q := f.y;") + "FUNCTION_BLOCK F\nVAR_INPUT x : BOOL; END_VAR\nVAR_OUTPUT y "
                                                          ": BOOL; END_VAR\ny := x;\nEND_FUNCTION_BLOCK\n"},
       {"IN_OUT", 0,
        main61131("n : INT; f : F;", "f(x := n); q := n > 1;") +
            "FUNCTION_BLOCK F\nVAR_IN_OUT x : INT; END_VAR\nx := x + 1;\nEND_FUNCTION_BLOCK\n"},
       {"outputs", 0, main61131("", "q := a; r := q;")},
       {"output terminals", 0, "PROGRAM m\nVAR q AT %QX0.0 : BOOL; END_VAR\nq := TRUE;\nEND_PROGRAM\n"},
       {"locals", 0, main61131("m : BOOL;", "m := a; q := m;")}});
}

TEST(IecRules, TimeAgainstComment) {
  const auto timer = [](const std::string& preset, const std::string& comment) {
    return main61131("t : TON;", "t(IN := a, PT := " + preset + ");" + comment + "\nq := t.Q;");
  };
  expectIecFindings("IEC017", {{"seconds", 1, timer("T#5s", " // 3 s")},
                               {"a block comment", 1, timer("T#5s", " (* 3 s *)")},
                               {"milliseconds", 1, timer("TIME#500ms", " // 5 s delay")},
                               {"minutes", 1, timer("T#1m30s", " // 2 min")},
                               {"at a declaration", 1,
                                "PROGRAM m\nVAR d : TIME := T#2s; // 20 s\nt : TON; END_VAR\nVAR_OUTPUT q : BOOL; "
                                "END_VAR\nt(IN := TRUE, PT := d); q := t.Q;\nEND_PROGRAM\n"},
                               {"with a fraction", 1, timer("T#2.5s", " // 2 s")},
                               {"the same", 0, timer("T#5s", " // 5 s")},
                               {"in other units", 0, timer("T#1m30s", " // 90 s")},
                               {"no duration", 0, timer("T#5s", " // start delay")},
                               {"on another line", 0, timer("T#5s", "\n// 3 s")},
                               {"one of several agrees", 0, timer("T#5s", " // 5 s, was 3 s")},
                               {"a fraction", 0, timer("T#2500ms", " // 2.5 s")}});
}

TEST(IecRules, LatchWithOneHand) {
  expectIecFindings("IEC018",
                    {{"an output", 1, main61131("", "IF a THEN q := TRUE; END_IF;")},
                     {"a local", 1, main61131("m : BOOL;", "IF a THEN m := TRUE; END_IF; q := m;")},
                     {"twice", 1, main61131("", "IF a THEN q := TRUE; END_IF; IF b THEN q := TRUE; END_IF;")},
                     {"only FALSE", 1, main61131("m : BOOL;", "IF a THEN m := FALSE; END_IF; q := m;")},
                     {"in a block", 1,
                      main61131("f : F;", "f(x := a); q := f.y;") +
                          "FUNCTION_BLOCK F\nVAR_INPUT x : BOOL; END_VAR\nVAR_OUTPUT y : BOOL; END_VAR\nIF x THEN y := "
                          "TRUE; END_IF;\nEND_FUNCTION_BLOCK\n"},
                     {"two of them", 2, main61131("", "IF a THEN q := TRUE; r := TRUE; END_IF;")},
                     {"reset", 0, main61131("", "IF a THEN q := TRUE; END_IF; IF b THEN q := FALSE; END_IF;")},
                     {"a condition", 0, main61131("", "q := a;")},
                     {"set, then from a condition", 0, main61131("", "IF a THEN q := TRUE; ELSE q := b; END_IF;")},
                     {"numbers", 0, main61131("n : INT;", "IF a THEN n := 1; END_IF; q := n > 0;")},
                     {"an output of a call resets it", 0,
                      main61131("t : TON;", "IF a THEN q := TRUE; END_IF; t(IN := b, PT := T#1s, Q => q);")},
                     {"never written at all: IEC003", 0, main61131("m : BOOL;", "q := m;")}});
}

TEST(IecRules, BlockNeverUsed) {
  const std::string function = "FUNCTION F : BOOL\nVAR_INPUT x : BOOL; END_VAR\nF := NOT x;\nEND_FUNCTION\n";
  const std::string block =
      "FUNCTION_BLOCK B\nVAR_INPUT x : BOOL; END_VAR\nVAR_OUTPUT y : BOOL; END_VAR\ny := x;\nEND_FUNCTION_BLOCK\n";
  expectIecFindings(
      "IEC019", {{"a function", 1, main61131("", "q := a;") + function},
                 {"a block", 1, main61131("", "q := a;") + block},
                 {"both", 2, main61131("", "q := a;") + block + function},
                 {"one of two", 1, main61131("", "q := F(a);") + block + function},
                 {"used by itself only", 1,
                  main61131("", "q := a;") + "FUNCTION G : INT\nVAR_INPUT x : INT; END_VAR\nG := x;\nEND_FUNCTION\n"},
                 {"in front of the program", 1, function + main61131("", "q := a;")},
                 {"called", 0, main61131("", "q := F(a);") + function},
                 {"an instance", 0, main61131("i : B;", "i(x := a); q := i.y;") + block},
                 {"an array of instances", 0, main61131("i : ARRAY[0..1] OF B;", "i[0](x := a); q := i[0].y;") + block},
                 {"by a function", 0,
                  main61131("", "q := G(a);") + function +
                      "FUNCTION G : BOOL\nVAR_INPUT x : BOOL; END_VAR\nG := F(x);\nEND_FUNCTION\n"},
                 {"through a type", 0,
                  "TYPE T : ARRAY[0..1] OF INT; END_TYPE\n" + block +
                      main61131("i : B; t : T;", "t[0] := 1; i(x := a); q := i.y AND t[1] > 0;")}});
}

// A file of the readers that holds no IEC 61131-3 is none of theirs, and a text that was not read whole is left alone.
TEST(IecRules, SpeakOfWhatWasReadOnly) {
  const Linted s7("ORGANIZATION_BLOCK MAIN:OB1\nBEGIN\nNetwork 1\nLD I0.0\n= Q0.0\nEND_ORGANIZATION_BLOCK\n");
  for (const Rule* rule : allRules()) {
    const bool isMeant = rule->group() == "IEC" && rule->check != nullptr;
    EXPECT_TRUE(!isMeant || s7.of(rule->id).empty()) << rule->id;
  }
  const Cpu cpu = *cpuNamed("IEC-4K");
  const Linted damaged("PROGRAM m\nVAR n : INT; END_VAR\nVAR_OUTPUT q : BOOL; END_VAR\nq := ;\nEND_PROGRAM\n",
                       {cpu, usualEdition(cpu)});
  EXPECT_TRUE(damaged.of("IEC002").empty());
}

}  // namespace
}  // namespace rungproof::testing
