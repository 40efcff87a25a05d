// What controllers of IEC 61131-3 do differently: readings that proofs cover, and readings of one implementation that
// are taken where they are asked for. Expected values are counted by hand.
#include "tests/graphical/plcopen_text.hpp"
#include "tests/iec/iec_output.hpp"
#include "tests/iec/iec_run.hpp"

namespace rungproof {
namespace {

struct Readings {
  std::string choice, first, second;
};

IecOutput proofOf(const std::string& text, const std::string& name, const std::vector<std::string>& options) {
  std::vector<std::string> arguments{"prove"};
  arguments.insert(arguments.end(), options.begin(), options.end());
  return runIec(arguments, text, name);
}

/// Verdicts on `p` without a choice, and with each of the readings.
void expectEach(const std::string& text, const Readings& readings, const std::string& none, const std::string& first,
                const std::string& second, const std::string& name = "main.st") {
  const auto with = [&](const std::string& value) {
    return proofOf(text, name, {"--choice", readings.choice + "=" + value});
  };
  const IecOutput all = proofOf(text, name, {});
  EXPECT_TRUE(all.has(none + "  p")) << all.text;
  EXPECT_TRUE(with(readings.first).has(first + "  p")) << readings.first << ": " << with(readings.first).text;
  EXPECT_TRUE(with(readings.second).has(second + "  p")) << readings.second << ": " << with(readings.second).text;
}

std::string drawn(const std::vector<std::string>& variables, const std::string& language, const std::string& elements,
                  const std::string& property) {
  const std::string text = projectText(
      pouText("Main", "program", "<localVars>" + declarations(variables) + "</localVars>", language, elements), "");
  return text + "<!--\n//@ prove p: " + property + "\n-->\n";
}

// y := x is numbered first and stands below x := a: by the numbers y has the value of the scan before.
TEST(VendorReadings, ResultsByNumberOrByPlace) {
  const std::string body = inElement(1, "a", "", 10, 10) + outElement(2, {"1"}, "x", "executionOrderId=\"2\"", 90, 10) +
                           inElement(3, "x", "", 10, 90) + outElement(4, {"3"}, "y", "executionOrderId=\"1\"", 90, 90);
  const std::vector<std::string> variables = {"a:BOOL@%IX0.0", "x:BOOL", "y:BOOL@%QX0.0"};
  const Readings readings{"iec-fbd-order", "execution-id", "position"};
  expectEach(drawn(variables, "FBD", body, "y = a"), readings, "VIOLATED", "VIOLATED", "PROVED", "t.xml");
  expectEach(drawn(variables, "FBD", body, "not first_scan implies y = prev(a)"), readings, "VIOLATED", "PROVED",
             "VIOLATED", "t.xml");
  // Numbers that change nothing are no reading.
  const std::string apart = inElement(1, "a", "", 10, 10) +
                            outElement(2, {"1"}, "x", "executionOrderId=\"2\"", 90, 10) +
                            inElement(3, "a", "", 10, 90) + outElement(4, {"3"}, "y", "executionOrderId=\"1\"", 90, 90);
  const IecOutput one = proofOf(drawn(variables, "FBD", apart, "y = a"), "t.xml", {});
  EXPECT_TRUE(one.has("PROVED  p") && !one.has("iec-fbd-order")) << one.text;
}

/// OR feeds AND, and AND feeds OR: q is what leaves OR, or AND.
std::string latch(const std::string& q, const std::string& orOrder = "", const std::string& andOrder = "") {
  const auto gate = [](int id, const std::string& type, const std::string& order, int x, int first, int second) {
    const auto pin = [](const char* name, int from) {
      return fmt::format(
          "<variable formalParameter=\"{}\"><connectionPointIn><connection refLocalId=\"{}\"/></connectionPointIn>"
          "</variable>",
          name, from);
    };
    return fmt::format(
        "<block localId=\"{}\" typeName=\"{}\" {}><position x=\"{}\" y=\"10\"/><inputVariables>{}{}"
        "</inputVariables><inOutVariables/><outputVariables><variable formalParameter=\"OUT\"><connectionPointOut/>"
        "</variable></outputVariables></block>\n",
        id, type, order, x, pin("IN1", first), pin("IN2", second));
  };
  return inElement(1, "a", "", 10, 10) + inElement(2, "b", "", 10, 50) + gate(3, "OR", orOrder, 50, 1, 4) +
         gate(4, "AND", andOrder, 90, 3, 2) + outElement(5, {q}, "q", "", 200, 10);
}
const std::vector<std::string> latchVariables = {"a:BOOL@%IX0.0", "b:BOOL@%IX0.1", "q:BOOL@%QX0.0"};

// From left to right OR comes first: it takes AND of the scan before, q = a or (q and b of then). As q needs them, AND
// comes first: it takes OR of the scan before, q = a or (q of then and b).
TEST(VendorReadings, AWireThatClosesALoopKeepsTheValueOfBefore) {
  const Readings readings{"iec-fbd-order", "execution-id", "position"};
  const auto drawnLatch = [&](const std::string& property) {
    return drawn(latchVariables, "FBD", latch("3"), property);
  };
  expectEach(drawnLatch("first_scan implies q = a"), readings, "PROVED", "PROVED", "PROVED", "t.xml");
  expectEach(drawnLatch("not first_scan implies q = (a or (prev(q) and prev(b)))"), readings, "VIOLATED", "VIOLATED",
             "PROVED", "t.xml");
  expectEach(drawnLatch("not first_scan implies q = (a or (prev(q) and b))"), readings, "VIOLATED", "PROVED",
             "VIOLATED", "t.xml");
  // Where q is what leaves AND, both orders begin with OR: q = (a or q of then) and b.
  const IecOutput one =
      proofOf(drawn(latchVariables, "FBD", latch("4"), "q = (b and (a or (not first_scan and prev(q))))"), "t.xml", {});
  EXPECT_TRUE(one.has("PROVED  p") && !one.has("iec-fbd-order")) << one.text;
  // Numbers say it, too: AND is number 1.
  expectEach(drawn(latchVariables, "FBD", latch("3", "executionOrderId=\"2\"", "executionOrderId=\"1\""),
                   "not first_scan implies q = (a or (prev(q) and b))"),
             readings, "VIOLATED", "PROVED", "VIOLATED", "t.xml");
}

// What would change the loop between the result and the kept value, and what is no gate, stays an error.
TEST(VendorReadings, OtherLoopsAreErrors) {
  const std::string named = latch("3") + inElement(7, "q", "", 10, 90) + outElement(8, {"7"}, "b", "", 90, 90);
  const IecOutput output = proofOf(drawn(latchVariables, "FBD", named, "q = a"), "t.xml", {});
  EXPECT_TRUE(output.has("NOT COVERED  p") && output.has("feed each other in a circle")) << output.text;
  std::string sums = latch("3");
  sums.replace(sums.find("\"OR\""), 4, "\"ADD\"");
  const IecOutput added = proofOf(drawn(latchVariables, "FBD", sums, "q = a"), "t.xml", {});
  EXPECT_TRUE(added.has("NOT COVERED  p") && added.has("feed each other in a circle")) << added.text;
}

// X -(S A)- -(R X)- -(S B)-: the third coil asks X again, or takes the flow that was.
TEST(VendorReadings, ACoilMayAskTheContactsAgain) {
  const std::string body =
      railElement(1) + contactElement(2, {"1"}, "In", "", 10, 10) + coilElement(3, {"2"}, "X", "", 90, 10) +
      contactElement(4, {"1"}, "X", "", 10, 90) + coilElement(5, {"4"}, "A", "storage=\"set\"", 50, 90) +
      coilElement(6, {"5"}, "X", "storage=\"reset\"", 70, 90) + coilElement(7, {"6"}, "B", "storage=\"set\"", 90, 90);
  const std::vector<std::string> variables = {"In:BOOL@%IX0.0", "X:BOOL", "A:BOOL@%QX0.0", "B:BOOL@%QX0.1"};
  const Readings readings{"iec-ld-flow", "once", "per-coil"};
  expectEach(drawn(variables, "LD", body, "In implies B"), readings, "VIOLATED", "PROVED", "VIOLATED", "t.xml");
  expectEach(drawn(variables, "LD", body, "In implies A"), readings, "PROVED", "PROVED", "PROVED", "t.xml");
  const IecOutput editor = proofOf(drawn(variables, "LD", body, "not B"), "t.xml", {"--choice", "iec=openplc"});
  EXPECT_TRUE(editor.has("PROVED  p")) << editor.text;
}

constexpr const char* twoTasks =
    "PROGRAM Fast\nVAR n : UINT; END_VAR\nIF n < 3 THEN n := n + 1; END_IF;\nEND_PROGRAM\n"
    "PROGRAM Slow\nVAR n : UINT; END_VAR\nIF n < 3 THEN n := n + 1; END_IF;\nEND_PROGRAM\n"
    "CONFIGURATION c\nRESOURCE r ON PLC\nTASK t1(INTERVAL := T#10ms, PRIORITY := 0);\n"
    "TASK t2(INTERVAL := T#20ms, PRIORITY := 1);\nPROGRAM One WITH t1 : Fast;\nPROGRAM Two WITH t2 : Slow;\n"
    "END_RESOURCE\nEND_CONFIGURATION\n";

// The task of 20 ms runs in every second scan of 10 ms: from the first on, or from the second.
TEST(VendorReadings, ATaskMayBeginInAnyScanOfItsInterval) {
  const Readings readings{"iec-phase", "zero", "any"};
  const auto text = [&](const std::string& property) { return "//@ prove p: " + property + "\n" + twoTasks; };
  expectEach(text("first_scan implies Two.n = 1"), readings, "VIOLATED", "PROVED", "VIOLATED");
  expectEach(text("One.n = 2 implies Two.n = 1"), readings, "PROVED", "PROVED", "PROVED");
  expectEach(text("first_scan implies One.n = 1"), readings, "PROVED", "PROVED", "PROVED");
}

std::string meeting(const std::string& variables, const std::string& body, const std::string& property) {
  return "//@ prove p: " + property + "\nPROGRAM M\nVAR " + variables + " END_VAR\n" + body + "\nEND_PROGRAM\n";
}

// %MW1 is %MB2 and %MB3 where words are counted, %MB1 and %MB2 where bytes are: its low or its high byte becomes 7.
TEST(VendorReadings, AddressesMayMeet) {
  const std::string variables = "w AT %MW1 : INT; b AT %MB2 : USINT;", body = "w := 5;\nb := 7;";
  const auto verdict = [&](const std::string& property, const std::vector<std::string>& choices) {
    std::vector<std::string> options;
    for (const std::string& choice : choices) options.insert(options.end(), {"--choice", choice});
    return proofOfIec(meeting(variables, body, property), options);
  };
  EXPECT_TRUE(verdict("w = 5", {}).has("VIOLATED  p"));
  EXPECT_TRUE(verdict("w = 5 or w = 7 or w = 7 * 256 + 5", {}).has("PROVED  p"));
  EXPECT_TRUE(verdict("w = 5", {"iec-address-unit=distinct"}).has("PROVED  p"));
  EXPECT_TRUE(verdict("w = 7", {"iec-address-unit=size", "iec-byte-order=little"}).has("PROVED  p"));
  EXPECT_TRUE(verdict("w = 7 * 256 + 5", {"iec-address-unit=size", "iec-byte-order=big"}).has("PROVED  p"));
  EXPECT_TRUE(verdict("w = 7 * 256 + 5", {"iec-address-unit=byte", "iec-byte-order=little"}).has("PROVED  p"));
  EXPECT_TRUE(verdict("w = 7", {"iec-address-unit=byte", "iec-byte-order=big"}).has("PROVED  p"));
  const IecOutput apart = proofOfIec(meeting("w AT %MW1 : INT; b AT %MB9 : USINT;", "w := 5;\nb := 7;", "w = 5"));
  EXPECT_TRUE(apart.has("PROVED  p") && !apart.has("iec-address-unit")) << apart.text;
}

// Bits of a word, written as bits and as a word; inputs of both sizes are one input; a global variable counts too.
TEST(VendorReadings, BitsAndInputsMayMeetWords) {
  const std::vector<std::string> size = {"--choice", "iec-address-unit=size", "--choice", "iec-byte-order=little"};
  // %MX2.1 is bit 1 of the low byte of %MW1.
  EXPECT_TRUE(proofOfIec(meeting("w AT %MW1 : WORD; x AT %MX2.1 : BOOL;", "w := 0; x := TRUE;", "w = 2"), size)
                  .has("PROVED  p"));
  EXPECT_TRUE(proofOfIec(meeting("w AT %MW1 : WORD; x AT %MX2.1 : BOOL;", "x := FALSE; w := 16#0202;", "x"), size)
                  .has("PROVED  p"));
  EXPECT_TRUE(
      proofOfIec(meeting("w AT %IW1 : INT; b AT %IB2 : USINT; q : BOOL;", "q := w = 5;", "q implies b = 5"), size)
          .has("PROVED  p"));
  EXPECT_TRUE(proofOfIec(meeting("w AT %IW1 : INT; b AT %IB2 : USINT; q : BOOL;", "q := w = 5;", "q implies b = 5"))
                  .has("VIOLATED  p"));
  const std::string global =
      "//@ prove p: w = 5\nPROGRAM M\nVAR_EXTERNAL w : INT; END_VAR\nw := 5;\n%MB2 := 7;\nEND_PROGRAM\n"
      "CONFIGURATION c\nVAR_GLOBAL w AT %MW1 : INT; END_VAR\nPROGRAM m1 : M;\nEND_CONFIGURATION\n";
  EXPECT_TRUE(proofOfIec(global).has("VIOLATED  p"));
  EXPECT_TRUE(proofOfIec(global, {"--choice", "iec=openplc"}).has("PROVED  p"));
}

// An array lies over the words behind its address for everybody: what happens to one that meets it is not modelled.
TEST(VendorReadings, AnAddressWithinAnArrayIsNotCovered) {
  for (const char* other : {"%MW3", "%MB7"}) {
    const IecOutput output = proofOfIec(meeting(
        "a AT %MW1 : ARRAY [0..9] OF INT; b AT " + std::string(other) + " : INT;", "a[2] := 5; b := 7;", "a[2] = 5"));
    EXPECT_TRUE(output.has("NOT COVERED  p") && output.has("meets an array")) << output.text;
  }
}

// 30 ms are reached in the fourth scan of 10 ms and exceeded in the fifth.
TEST(VendorReadings, ATimerMayEndWhenItsTimeIsExceeded) {
  const std::string text =
      "PROGRAM M\nVAR i : BOOL; END_VAR VAR t : TON; f : TOF; p : TP; q, r, s : BOOL; END_VAR\n"
      "t(IN := i, PT := T#30ms); f(IN := NOT i, PT := T#30ms); p(IN := i, PT := T#30ms);\n"
      "q := t.Q; r := f.Q; s := p.Q;\nEND_PROGRAM\n";
  const IecChoices later = {{"iec-timer-expiry", "after-preset"}};
  const std::vector<double> on(6, 1);
  EXPECT_EQ(IecRun(text).follow("q", {{"i", on}}), (Row{0, 0, 0, 1, 1, 1}));
  EXPECT_EQ(IecRun(text, 10, later).follow("q", {{"i", on}}), (Row{0, 0, 0, 0, 1, 1}));
  EXPECT_EQ(IecRun(text, 10, later).follow("t.ET", {{"i", on}}), (Row{0, 10, 20, 30, 30, 30}));
  EXPECT_EQ(IecRun(text, 10, later).follow("s", {{"i", on}}), (Row{1, 1, 1, 1, 0, 0}));
  // IN of the TOF falls in the second scan.
  EXPECT_EQ(IecRun(text, 10, later).follow("r", {{"i", {0, 1, 1, 1, 1, 1}}}), (Row{1, 1, 1, 1, 1, 0}));
}

// PT is 20 ms in three scans and 50 ms behind that: the timer goes on from 30 ms to 50 ms, or stays as it has ended.
TEST(VendorReadings, ATimerMayGoOnWithALongerPreset) {
  const std::string text =
      "PROGRAM M\nVAR i, l : BOOL; END_VAR VAR t : TON; f : TOF; p : TP; pt : TIME; q, r, s : BOOL; END_VAR\n"
      "IF l THEN pt := T#50ms; ELSE pt := T#20ms; END_IF;\n"
      "t(IN := i, PT := pt); f(IN := NOT i, PT := pt); p(IN := i, PT := pt);\nq := t.Q; r := f.Q; s := p.Q;\n"
      "END_PROGRAM\n";
  const IecChoices again = {{"iec-timer-done", "re-evaluated"}};
  const std::vector<std::pair<std::string, Row>> inputs = {{"i", {1, 1, 1, 1, 1, 1, 1}}, {"l", {0, 0, 0, 1, 1, 1, 1}}};
  EXPECT_EQ(IecRun(text).follow("q", inputs), (Row{0, 0, 1, 1, 1, 1, 1}));
  EXPECT_EQ(IecRun(text, 10, again).follow("q", inputs), (Row{0, 0, 1, 0, 0, 1, 1}));
  EXPECT_EQ(IecRun(text, 10, again).follow("t.ET", inputs), (Row{0, 10, 20, 30, 40, 50, 50}));
  EXPECT_EQ(IecRun(text).follow("s", inputs), (Row{1, 1, 0, 0, 0, 0, 0}));
  EXPECT_EQ(IecRun(text, 10, again).follow("s", inputs), (Row{1, 1, 0, 1, 1, 0, 0}));
  const std::vector<std::pair<std::string, Row>> falling = {{"i", {0, 1, 1, 1, 1, 1, 1, 1}},
                                                            {"l", {0, 0, 0, 0, 1, 1, 1, 1}}};
  EXPECT_EQ(IecRun(text).follow("r", falling), (Row{1, 1, 1, 0, 0, 0, 0, 0}));
  EXPECT_EQ(IecRun(text, 10, again).follow("r", falling), (Row{1, 1, 1, 0, 1, 1, 0, 0}));
}

// A timer whose PT is a constant everywhere rests on no reading of what becomes of a longer one.
TEST(VendorReadings, AConstantPresetIsNoReading) {
  const std::string text =
      "//@ prove p: t.ET >= 1000 implies t.Q\nPROGRAM M\nVAR CONSTANT wait : TIME := T#1s; END_VAR\n"
      "VAR x AT %IX0.0 : BOOL; t : TON; END_VAR\nt(IN := x, PT := wait);\nEND_PROGRAM\n";
  const IecOutput output = proofOfIec(text);
  EXPECT_TRUE(output.has("PROVED  p") && !output.has("iec-timer-done")) << output.text;
  EXPECT_TRUE(output.has("iec-timer-expiry") && output.has("iec-timer-clock")) << output.text;
}

TEST(VendorReadings, AFallingEdgeInTheFirstCall) {
  const std::string text =
      "//@ prove p: first_scan and not x implies q\nPROGRAM M\nVAR x AT %IX0.0 : BOOL; q : BOOL; f : F_TRIG; END_VAR\n"
      "f(CLK := x);\nq := f.Q;\nEND_PROGRAM\n";
  expectEach(text, {"iec-ftrig-first", "edge", "none"}, "PROVED", "PROVED", "VIOLATED");
}

// CU rises in the scan of R. Where edges are kept meanwhile, it counts in the next scan, with CU still TRUE.
TEST(VendorReadings, EdgesWhileACounterIsReset) {
  const std::string text =
      "//@ prove p: not first_scan and prev(r) and not r and prev(u) implies c.CV = 0\nPROGRAM M\n"
      "VAR u AT %IX0.0 : BOOL; r AT %IX0.1 : BOOL; c : CTUD; END_VAR\n"
      "c(CU := u, CD := FALSE, R := r, LD := FALSE, PV := 5);\nEND_PROGRAM\n";
  expectEach(text, {"iec-ctud-edges", "always", "when-counting"}, "PROVED", "PROVED", "VIOLATED");
}

TEST(VendorReadings, ASemaphoreTellsAtOnceOrInTheNextCall) {
  const std::string text =
      "//@ prove p: x implies s.BUSY\nPROGRAM M\nVAR x AT %IX0.0 : BOOL; y AT %IX0.1 : BOOL; s : SEMA; END_VAR\n"
      "s(CLAIM := x, RELEASE := y);\nEND_PROGRAM\n";
  expectEach(text, {"iec-sema", "direct", "delayed"}, "PROVED", "PROVED", "VIOLATED");
}

// MIN(MAX(0, 10), 5) is 5; 0 is not above MN, which gives MN.
TEST(VendorReadings, CrossedLimits) {
  const std::string text =
      "//@ prove p: l = 5\nPROGRAM M\nVAR l, mn, mx : INT; END_VAR\nmn := 10;\nmx := 5;\nl := LIMIT(mn, 0, "
      "mx);\nEND_PROGRAM\n";
  expectEach(text, {"iec-limit-crossed", "min-of-max", "lower"}, "PROVED", "PROVED", "VIOLATED");
  const std::string ten = "//@ prove p: l = 10\n" + text.substr(text.find('\n') + 1);
  const IecOutput editor = proofOfIec(ten, {"--choice", "iec=openplc"});
  EXPECT_TRUE(editor.has("PROVED  p")) << editor.text;
  // With MN <= MX both readings agree for every IN.
  const std::string ordered =
      "//@ prove p: (i < -7 implies l = -7) and (i > 9 implies l = 9) and (i >= -7 and i <= 9 implies l = i)\n"
      "PROGRAM M\nVAR i AT %IW1 : INT; l, mn, mx : INT; END_VAR\nmn := -7;\nmx := 9;\nl := LIMIT(mn, i, "
      "mx);\nEND_PROGRAM\n";
  expectEach(ordered, {"iec-limit-crossed", "min-of-max", "lower"}, "PROVED", "PROVED", "PROVED");
}

// Two transitions behind S0, both TRUE: one fires, or both.
TEST(VendorReadings, SelectionsThatAreTrueTogether) {
  const std::string chart =
      "PROGRAM M\nVAR x AT %IX0.0 : BOOL; y AT %IX0.1 : BOOL; END_VAR\nINITIAL_STEP S0:\nEND_STEP\nSTEP A:\nEND_STEP\n"
      "STEP B:\nEND_STEP\nTRANSITION FROM S0 TO A := x; END_TRANSITION\nTRANSITION FROM S0 TO B := y; "
      "END_TRANSITION\nTRANSITION FROM A TO S0 := FALSE; END_TRANSITION\nTRANSITION FROM B TO S0 := FALSE; "
      "END_TRANSITION\nEND_PROGRAM\n";
  expectEach("//@ prove p: never A.X and B.X\n" + chart, {"iec-sfc-selection", "one", "all-true"}, "PROVED", "PROVED",
             "VIOLATED");
  // With priorities one fires in either reading.
  std::string ranked = chart;
  for (const std::string name : {"A := x", "B := y"}) {
    const std::size_t at = ranked.find("TRANSITION FROM S0 TO " + name);
    ranked.insert(at + 10, name[0] == 'A' ? " (PRIORITY := 1)" : " (PRIORITY := 2)");
  }
  expectEach("//@ prove p: never A.X and B.X\n" + ranked, {"iec-sfc-selection", "one", "all-true"}, "PROVED", "PROVED",
             "PROVED");
}

// a and b are both v = 1: 1 + 1 = 2, then 2 * 2 = 4 on the variable itself; by copies a = 2, b = 2, and b comes last.
TEST(VendorReadings, TwoInOutOfOneVariable) {
  const std::string text =
      "FUNCTION_BLOCK F\nVAR_IN_OUT a, b : INT; END_VAR\na := a + 1;\nb := b * 2;\nEND_FUNCTION_BLOCK\n"
      "PROGRAM M\nVAR v : INT; f1 : F; END_VAR\nv := 1;\nf1(a := v, b := v);\nEND_PROGRAM\n";
  const Readings readings{"iec-inout", "reference", "copy"};
  expectEach("//@ prove p: v = 4\n" + text, readings, "PROVED", "PROVED", "VIOLATED");
  expectEach("//@ prove p: v = 2\n" + text, readings, "VIOLATED", "VIOLATED", "PROVED");
  // One that the body knows as a global variable too: the copy is written back behind what the body wrote.
  const std::string global =
      "//@ prove p: g = 7\nFUNCTION_BLOCK F\nVAR_EXTERNAL g : INT; END_VAR\nVAR_IN_OUT a : INT; END_VAR\ng := 7;\n"
      "END_FUNCTION_BLOCK\nPROGRAM M\nVAR_EXTERNAL g : INT; END_VAR\nVAR f1 : F; END_VAR\ng := 1;\nf1(a := "
      "g);\nEND_PROGRAM\nCONFIGURATION c\nVAR_GLOBAL g : INT; END_VAR\nPROGRAM m1 : M;\nEND_CONFIGURATION\n";
  expectEach(global, readings, "PROVED", "PROVED", "VIOLATED");
}

}  // namespace
}  // namespace rungproof
