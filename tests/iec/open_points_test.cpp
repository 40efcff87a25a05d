// The open points of the family, one row each: no PROVED rests on one of them silently. A row has a program in which
// its readings make a difference. Where proofs cover all readings the verdict is that of the worst; where they take
// one, the verdict names it; the rest is not covered. Verdicts are reasoned beside the programs.
#include <map>

#include "ir/machine/choices.hpp"
#include "tests/graphical/plcopen_text.hpp"
#include "tests/iec/iec_output.hpp"

namespace rungproof {
namespace {

enum class Treated : std::uint8_t {
  Covered,     ///< the first reading proves the property, another one violates it: VIOLATED
  OtherWay,    ///< the first reading violates it and another one proves it: VIOLATED
  Named,       ///< the first reading is taken: PROVED, with its name
  Assumed,     ///< PROVED, with an assumption of other wording
  NotCovered,  ///< NOT COVERED
};

struct OpenPoint {
  std::string key;
  Treated how;
  std::string other;  ///< the reading by which the verdict is the opposite; or the words of the assumption
  std::string text, property;
  std::vector<std::string> options = {};
  std::string file = "main.st";
};

std::string openProgram(const std::string& variables, const std::string& body) {
  return "PROGRAM M\nVAR x AT %IX0.0 : BOOL; y AT %IX0.1 : BOOL; d AT %IW7 : INT;\n" + variables + "\nEND_VAR\n" +
         body + "\nEND_PROGRAM\n";
}

std::string openChart(const std::string& variables, const std::string& body) {
  return openProgram(variables + " q, r : BOOL;", body);
}

std::string openDrawing(const std::vector<std::string>& variables, const std::string& language,
                        const std::string& elements) {
  return projectText(
      pouText("Main", "program", "<localVars>" + declarations(variables) + "</localVars>", language, elements), "");
}

std::string twoSharingTasks(const std::string& first, const std::string& second, const std::string& slow) {
  return "PROGRAM A\nVAR_EXTERNAL g : INT; END_VAR\nVAR n : INT; END_VAR\n" + first + "\nEND_PROGRAM\nPROGRAM B\n" +
         "VAR_EXTERNAL g : INT; END_VAR\nVAR n : INT; END_VAR\n" + second +
         "\nEND_PROGRAM\nCONFIGURATION c\nVAR_GLOBAL g : INT; END_VAR\nRESOURCE r ON PLC\nTASK lo(INTERVAL := T#" +
         slow +
         "ms, PRIORITY := 5);\nTASK hi(INTERVAL := T#10ms, PRIORITY := 1);\nPROGRAM a1 WITH lo : A;\n"
         "PROGRAM b1 WITH hi : B;\nEND_RESOURCE\nEND_CONFIGURATION\n";
}

/// Three networks of one ladder: X -(S A)- -(R X)- -(S B)-, see VendorReadings.
std::string coilsInARow() {
  return openDrawing({"In:BOOL@%IX0.0", "X:BOOL", "A:BOOL@%QX0.0", "B:BOOL@%QX0.1"}, "LD",
                     railElement(1) + contactElement(2, {"1"}, "In", "", 10, 10) +
                         coilElement(3, {"2"}, "X", "", 90, 10) + contactElement(4, {"1"}, "X", "", 10, 90) +
                         coilElement(5, {"4"}, "A", "storage=\"set\"", 50, 90) +
                         coilElement(6, {"5"}, "X", "storage=\"reset\"", 70, 90) +
                         coilElement(7, {"6"}, "B", "storage=\"set\"", 90, 90));
}

std::string drawnFeedback() {
  return openDrawing({"a:BOOL@%IX0.0", "q:BOOL", "m:BOOL"}, "LD",
                     railElement(1) + contactElement(2, {"1"}, "a", "", 10, 10) +
                         coilElement(3, {"2"}, "q", "", 90, 10) + contactElement(4, {"2"}, "q", "", 50, 50) +
                         coilElement(5, {"4"}, "m", "", 90, 50));
}

std::string drawnNumbers() {
  return openDrawing({"a:BOOL@%IX0.0", "x:BOOL", "y:BOOL@%QX0.0"}, "FBD",
                     inElement(1, "a", "", 10, 10) + outElement(2, {"1"}, "x", "executionOrderId=\"2\"", 90, 10) +
                         inElement(3, "x", "", 10, 90) + outElement(4, {"3"}, "y", "executionOrderId=\"1\"", 90, 90));
}

/// S1 -y-> S2 -(rising edge of x, found by a block)-> S3
std::string chartWithBlock() {
  const auto place = [](const char* rest) { return std::string("<position x=\"10\" y=\"10\"/>") + rest; };
  const auto links = [](const char* from, const char* pin = "") {
    return fmt::format("<connectionPointIn><connection refLocalId=\"{}\"{}/></connectionPointIn>", from, pin);
  };
  const auto step = [&](int id, const char* name, const std::string& above, const char* isInitial) {
    return fmt::format(
        "<step localId=\"{}\" name=\"{}\" initialStep=\"{}\">{}{}<connectionPointOut "
        "formalParameter=\"sfc\"/></step>",
        id, name, isInitial, place(""), above);
  };
  const auto transition = [&](int id, const char* above, const std::string& condition) {
    return fmt::format("<transition localId=\"{}\">{}{}<connectionPointOut/><condition>{}</condition></transition>", id,
                       place(""), links(above), condition);
  };
  return openDrawing(
      {"x:BOOL@%IX0.0", "y:BOOL@%IX0.1", "edge:R_TRIG"}, "SFC",
      step(1, "S1", "", "true") + transition(2, "1", "<inline name=\"\"><ST><p>y</p></ST></inline>") +
          step(3, "S2", links("2"), "false") + transition(4, "3", links("6", " formalParameter=\"Q\"")) +
          step(5, "S3", links("4"), "false") + inElement(7, "x", "", 5, 5) +
          "<block localId=\"6\" typeName=\"R_TRIG\" instanceName=\"edge\">" + place("") +
          "<inputVariables><variable formalParameter=\"CLK\">" + links("7") +
          "</variable></inputVariables><inOutVariables/><outputVariables><variable formalParameter=\"Q\">"
          "<connectionPointOut/></variable></outputVariables></block>");
}

const std::string oneTransition = "\nSTEP S2:\nEND_STEP\nTRANSITION FROM S1 TO S2 := x; END_TRANSITION\n";

std::vector<OpenPoint> openPoints() {
  using enum Treated;
  const std::string delay = "t(IN := x, PT := T#30ms);";
  return {
      // hi writes 2, then lo writes 1; as declared lo comes first.
      {"iec-task-order", Covered, "declaration", twoSharingTasks("g := 1;", "g := 2;", "10"), "g = 1"},
      // An interruption between the two statements of lo would leave n of lo at 2.
      {"iec-preemption", Named, "", twoSharingTasks("g := 1; n := g;", "g := 2;", "10"), "a1.n <= 1"},
      {"iec-interval", Assumed, "10 ms", twoSharingTasks("n := 1;", "g := 2;", "10"), "a1.n <= 1"},
      {"iec-phase", Covered, "any", twoSharingTasks("n := 1;", "g := 2;", "20"), "a1.n = 1"},
      {"iec-timer-clock", Named, "", openProgram("t : TON;", delay), "t.ET >= 30 implies t.Q"},
      {"iec-timer-start", Covered, "same-call", openProgram("t : TON;", "t(IN := x, PT := T#0ms);"),
       "first_scan implies not t.Q"},
      {"iec-timer-expiry", Named, "after-preset", openProgram("t : TON;", delay), "t.ET >= 30 implies t.Q"},
      // The timer runs with a PT of 30 ms and keeps it, or takes 10 ms.
      {"iec-timer-preset",
       Covered,
       "latched",
       openProgram("t : TON; p : TIME;", "IF y THEN p := T#10ms; ELSE p := T#30ms; END_IF; t(IN := x, PT := p);"),
       "y and t.ET >= 10 implies t.Q",
       {"--scan-time", "10ms"}},
      // Ended with PT 10 ms, asked again with PT 1 h.
      {"iec-timer-done", Named, "re-evaluated",
       openProgram("t : TON; p : TIME;", "IF y THEN p := T#10ms; ELSE p := T#1h; END_IF; t(IN := x, PT := p);"),
       "x and not first_scan and prev(t.Q) implies t.Q"},
      {"iec-ftrig-first", Named, "none", openProgram("f : F_TRIG;", "f(CLK := x);"),
       "first_scan and not x implies f.Q"},
      {"iec-counter-limit", Covered, "type-max", openProgram("c : CTU;", "c(CU := x, R := FALSE, PV := 2);"),
       "c.CV <= 2"},
      {"iec-ctd-limit", Covered, "type-min", openProgram("c : CTD;", "c(CD := x, LD := FALSE, PV := 2);"), "c.CV >= 0"},
      // CU rises while R is TRUE and still is TRUE behind it.
      {"iec-ctud-edges", Named, "when-counting",
       openProgram("c : CTUD;", "c(CU := x, CD := FALSE, R := y, LD := FALSE, PV := 5);"),
       "not first_scan and prev(y) and not y and prev(x) implies c.CV = 0"},
      {"iec-sema", Named, "delayed", openProgram("s : SEMA;", "s(CLAIM := x, RELEASE := y);"), "x implies s.BUSY"},
      // 32767 + 1
      {"iec-intermediate", Covered, "wide", openProgram("q : BOOL;", "q := (d + 1) > 0;"), "d = 32767 implies not q"},
      // Nothing is asked of a scan that a fault cuts off.
      {"iec-div-zero", Covered, "zero", openProgram("n : INT;", "n := 10 / d;"), "d <> 0"},
      {"iec-mod-zero", OtherWay, "fault", openProgram("n : INT;", "n := 10 MOD d;"), "d <> 0"},
      {"iec-round", Covered, "half-away", openProgram("f : REAL := 2.5; n : INT;", "n := REAL_TO_INT(f);"), "n = 2"},
      {"iec-time-number", Covered, "seconds", openProgram("n : DINT;", "n := TIME_TO_DINT(T#2500ms);"), "n = 2500"},
      {"iec-mux-range", Named, "last", openProgram("n : INT;", "n := MUX(d, 7, 8);"), "d > 1 implies n = 0"},
      {"iec-limit-crossed", Named, "lower",
       openProgram("l, mn, mx : INT;", "mn := 10; mx := 5; l := LIMIT(mn, 0, mx);"), "l = 5"},
      {"iec-to-bool", Covered, "bit0", openProgram("w AT %IB9 : BYTE; q : BOOL;", "q := BYTE_TO_BOOL(w);"),
       "w = 2 implies q"},
      {"iec-hex-literal", Named, "", openProgram("n : INT;", "n := 16#FFFF;"), "n = -1"},
      {"iec-subrange", OtherWay, "fault", openProgram("v : INT (0..10);", "v := d;"), "v <= 10"},
      {"iec-subrange-start", Covered, "zero", openProgram("v : INT (-5..20);", "v := v;"), "v = -5"},
      {"iec-array-range", Covered, "clamp", openProgram("a : ARRAY [0..4] OF INT;", "a[d] := 1;"), "d <= 4"},
      // The right side faults where it is computed in spite of d = 0.
      {"iec-short-circuit",
       Covered,
       "yes",
       openProgram("q : BOOL;", "q := (d = 0) OR (10 / d > 3);"),
       "d <> 0",
       {"--choice", "iec-div-zero=fault"}},
      {"iec-for-bounds", Covered, "once",
       openProgram("i, b, n : INT;", "b := 3; n := 0; FOR i := 1 TO b DO b := 5; n := n + 1; END_FOR;"), "n = 5"},
      {"iec-en-false-result", Named, "zero", openProgram("n : INT := 4;", "n := ADD(EN := x, IN1 := 4, IN2 := 0);"),
       "n = 4"},
      {"iec-ld-flow", Covered, "per-coil", coilsInARow(), "In implies B", {}, "t.xml"},
      {"iec-network-feedback", Covered, "snapshot", drawnFeedback(), "m = q", {}, "t.xml"},
      // a := a + 1; b := b * 2 on one v = 1: 4, or b's copy of 2.
      {"iec-inout", Named, "copy",
       "FUNCTION_BLOCK F\nVAR_IN_OUT a, b : INT; END_VAR\na := a + 1;\nb := b * 2;\nEND_FUNCTION_BLOCK\n" +
           openProgram("v : INT; f1 : F;", "v := 1; f1(a := v, b := v);"),
       "v = 4"},
      {"iec-fbd-order", OtherWay, "position", drawnNumbers(), "y = a", {}, "t.xml"},
      // The condition of the initial step is TRUE in the first scan.
      {"iec-sfc-order", Covered, "actions-first",
       openChart(
           "", "INITIAL_STEP S1: q; END_STEP\nSTEP S2: r; END_STEP\nTRANSITION FROM S1 TO S2 := TRUE; END_TRANSITION"),
       "not q"},
      {"iec-sfc-selection", Named, "all-true",
       openChart("",
                 "INITIAL_STEP S0: END_STEP\nSTEP S1: END_STEP\nSTEP S2: END_STEP\n"
                 "TRANSITION FROM S0 TO S1 := x; END_TRANSITION\nTRANSITION FROM S0 TO S2 := y; END_TRANSITION"),
       "not (S1.X and S2.X)"},
      {"iec-sfc-initial-edge", Covered, "no",
       openChart("n : INT;", "INITIAL_STEP S1: run(P); END_STEP" + oneTransition + "ACTION run: n := 1; END_ACTION"),
       "first_scan and not x implies n = 1"},
      {"iec-sfc-final-scan",
       Covered,
       "yes",
       openChart("n : INT;", "INITIAL_STEP S1: run(N); END_STEP" + oneTransition +
                                 "ACTION run: IF x THEN n := 1; END_IF; END_ACTION"),
       "n = 0",
       {"--choice", "iec-sfc-order=transitions-first"}},
      // z doubles, a adds one: (0 * 2) + 1, or (0 + 1) * 2
      {"iec-sfc-action-order", Covered, "alphabetical",
       openChart("n : INT;", "INITIAL_STEP S1: a; z; END_STEP" + oneTransition +
                                 "ACTION z: n := n * 2; END_ACTION\nACTION a: n := n + 1; END_ACTION"),
       "first_scan and not x implies n = 1"},
      // Counted in words %MW1 is %MB2 and %MB3, so that w becomes 7.
      {"iec-address-unit", Covered, "size",
       "PROGRAM M\nVAR w AT %MW1 : INT; b AT %MB2 : USINT; END_VAR\nw := 5;\nb := 7;\nEND_PROGRAM\n", "w = 5"},
      {"iec-il-start", NotCovered, "", "PROGRAM M\nVAR q : BOOL; END_VAR\nST q\nEND_PROGRAM\n", "not q"},
      // Of our own: what the table of the family leaves open within its rows. 261 is 16#0105.
      {"iec-byte-order",
       Covered,
       "big",
       "PROGRAM M\nVAR w AT %MW0 : INT; b AT %MB0 : USINT; END_VAR\nw := 261;\nEND_PROGRAM\n",
       "b = 5",
       {"--choice", "iec-address-unit=byte"}},
      // A block that is called first when S2 is active finds an edge wherever x is TRUE; one that is called in every
      // scan finds none where x has been TRUE before.
      {"iec-condition-blocks",
       Covered,
       "each-scan",
       chartWithBlock(),
       "x and not first_scan and prev(S2.X) implies S3.X",
       {},
       "t.xml"},
  };
}

std::string expectedVerdict(Treated how) {
  switch (how) {
    case Treated::Covered:
    case Treated::OtherWay: return "VIOLATED  asked";
    case Treated::Named:
    case Treated::Assumed: return "PROVED  asked";
    case Treated::NotCovered: break;
  }
  return "NOT COVERED  asked";
}

IecOutput proofOfPoint(const OpenPoint& point, const std::string& reading) {
  const bool isDrawn = point.file != "main.st";
  const std::string asked = "//@ prove asked: " + point.property + "\n";
  const std::string text = isDrawn ? point.text + "<!--\n" + asked + "-->\n" : asked + point.text;
  std::vector<std::string> arguments{"prove"};
  arguments.insert(arguments.end(), point.options.begin(), point.options.end());
  if (!reading.empty()) arguments.insert(arguments.end(), {"--choice", point.key + "=" + reading});
  return runIec(arguments, text, point.file);
}

TEST(OpenPoints, NoneIsRestedOnSilently) {
  std::map<std::string, int> seen;
  for (const OpenPoint& point : openPoints()) {
    SCOPED_TRACE(point.key);
    EXPECT_EQ(++seen[point.key], 1);
    const IecOutput output = proofOfPoint(point, "");
    EXPECT_TRUE(output.has(expectedVerdict(point.how))) << output.text;
    const bool isNamed = point.how != Treated::Assumed && point.how != Treated::NotCovered;
    EXPECT_TRUE(output.has(point.how == Treated::Assumed ? point.other : isNamed ? point.key : "LD")) << output.text;
  }
  EXPECT_EQ(seen.size(), 39U + 3U);
  for (const ChoiceInfo& info : choiceTable) {
    const bool isOfFamily = info.key.starts_with("iec-") && info.manual.starts_with("IEC");
    EXPECT_EQ(seen.contains(std::string(info.key)), isOfFamily) << info.key;
  }
}

TEST(OpenPoints, EachReadingHasItsVerdict) {
  int asked = 0;
  for (const OpenPoint& point : openPoints()) {
    SCOPED_TRACE(point.key);
    if (point.how == Treated::Assumed || point.how == Treated::NotCovered || point.other.empty()) continue;
    const auto info = std::ranges::find(choiceTable, point.key, &ChoiceInfo::key);
    ASSERT_NE(info, choiceTable.end());
    const bool isProvedFirst = point.how != Treated::OtherWay;
    const IecOutput first = proofOfPoint(point, std::string(info->values[0])), other = proofOfPoint(point, point.other);
    EXPECT_TRUE(first.has(isProvedFirst ? "PROVED  asked" : "VIOLATED  asked")) << first.text;
    EXPECT_TRUE(other.has(isProvedFirst ? "VIOLATED  asked" : "PROVED  asked")) << other.text;
    ++asked;
  }
  EXPECT_EQ(asked, 37);
}

}  // namespace
}  // namespace rungproof
