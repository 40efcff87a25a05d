// Boxes of functions in drawings: each is called once in a scan, in the order of the drawing, whatever is wired to its
// pins. Expected values are reasoned beside the drawings.
#include "tests/graphical/plcopen_text.hpp"
#include "tests/iec/iec_output.hpp"

namespace rungproof {
namespace {

const std::vector<std::string> usual = {"a:BOOL@%IX0.0", "b:BOOL@%IX0.1", "n:INT", "z:INT",
                                        "zz:INT",        "q:BOOL",        "r:BOOL"};

/// FUNCTION Bump : BOOL, IN_OUT v; adds 1 to v.
const std::string bump =
    "<pou name=\"Bump\" pouType=\"function\"><interface><returnType><INT/></returnType><inOutVars>" +
    declarations({"v:INT"}) + "</inOutVars></interface><body><ST><p>v := v + 1; Bump := v;</p></ST></body></pou>\n";

/// `after`: further elements of the POU, its actions.
std::string drawingText(const std::string& language, const std::string& elements, const std::string& pous = "",
                        const std::vector<std::string>& variables = usual) {
  return projectText(
      pous + pouText("Main", "program", "<localVars>" + declarations(variables) + "</localVars>", language, elements),
      "");
}

IecOutput proofOfDrawing(const std::string& drawing, const std::string& asked, std::vector<std::string> options = {}) {
  std::string text = drawing;
  text.insert(text.find("<project"), "<!--\n" + asked + "-->\n");
  options.insert(options.begin(), "prove");
  return runIec(options, text, "main.xml");
}

std::string verdictIn(const std::string& drawing, const std::string& property,
                      const std::vector<std::string>& options = {}) {
  const IecOutput output = proofOfDrawing(drawing, "//@ prove asked: " + property + "\n", options);
  for (const std::string verdict : {"PROVED", "VIOLATED", "VACUOUS", "UNKNOWN", "NOT COVERED"}) {
    if (output.has(verdict + "  asked")) return verdict;
  }
  return output.text;
}

/// Rail, contact `a`, and a box with EN behind it.
std::string enabledBox(const std::string& type, std::vector<TestPin> inputs, const std::vector<std::string>& outputs) {
  inputs.insert(inputs.begin(), {"EN", {"2"}});
  return railElement(1) + contactElement(2, {"1"}, "a", "", 10, 10) +
         blockElement(3, type, "", inputs, outputs, 50, 10);
}

// --- A box whose result nobody takes

TEST(DrawnBox, AFunctionThatNobodyReadsIsCalled) {  // n counts the scans with a
  const std::string box = enabledBox("Bump", {{"v", {"9"}}}, {"ENO", "Bump"}) + inElement(9, "n");
  EXPECT_EQ(verdictIn(drawingText("LD", box, bump), "n = 0"), "VIOLATED");
  EXPECT_EQ(verdictIn(drawingText("LD", box, bump), "a and not first_scan implies n = prev(n) + 1 or prev(n) = 32767"),
            "PROVED");
  EXPECT_EQ(verdictIn(drawingText("LD", box, bump), "not a and not first_scan implies n = prev(n)"), "PROVED");
  // Without EN it is called in every scan; the first one leaves 1.
  const std::string always = blockElement(3, "Bump", "", {{"v", {"9"}}}, {"Bump"}) + inElement(9, "n");
  EXPECT_EQ(verdictIn(drawingText("FBD", always, bump), "first_scan implies n = 1"), "PROVED");
}

TEST(DrawnBox, AFunctionOfWhichOnlyEnoIsReadIsCalled) {
  const std::string box = enabledBox("Bump", {{"v", {"9"}}}, {"ENO", "Bump"}) + inElement(9, "n") +
                          coilElement(4, {"3.ENO"}, "q", "", 90, 10);
  EXPECT_EQ(verdictIn(drawingText("LD", box, bump), "first_scan and a implies n = 1 and q"), "PROVED");
  EXPECT_EQ(verdictIn(drawingText("LD", box, bump), "not a implies not q"), "PROVED");
}

// Bump stands in a row with Bump: each is called once, n grows by 2.
TEST(DrawnBox, ARowOfBoxesIsCalledOnce) {
  const std::string row = enabledBox("Bump", {{"v", {"9"}}}, {"ENO", "Bump"}) + inElement(9, "n") +
                          blockElement(4, "Bump", "", {{"EN", {"3.ENO"}}, {"v", {"10"}}}, {"ENO", "Bump"}, 80, 10) +
                          inElement(10, "n");
  EXPECT_EQ(verdictIn(drawingText("LD", row, bump), "first_scan and a implies n = 2"), "PROVED");
}

TEST(DrawnBox, ADivisionThatNobodyReadsMayFault) {  // z starts with 0
  const std::string box =
      enabledBox("DIV", {{"IN1", {"9"}}, {"IN2", {"10"}}}, {"ENO", "OUT"}) + inElement(9, "n") + inElement(10, "z");
  const IecOutput output = proofOfDrawing(drawingText("LD", box), "", {"--builtin"});
  EXPECT_TRUE(output.has("VIOLATED") && output.has("division by zero")) << output.text;
}

// Whether a root of a negative number is an error nobody says: ENO may be FALSE although EN is TRUE, never the reverse.
TEST(DrawnBox, EnoOfWhatCanFailHasAnyValue) {
  const std::string text = drawingText("LD",
                                       enabledBox("SQRT", {{"IN", {"9"}}}, {"ENO", "OUT"}) + inElement(9, "x") +
                                           coilElement(4, {"3.ENO"}, "q", "", 90, 10),
                                       "", {"a:BOOL@%IX0.0", "q:BOOL", "x:REAL"});
  EXPECT_EQ(verdictIn(text, "q implies a"), "PROVED");
  EXPECT_EQ(verdictIn(text, "a implies q"), "VIOLATED");
}

TEST(DrawnBox, AnActionOfTheBlockIsCalled) {
  std::string text = drawingText("LD", enabledBox("Count", {}, {"ENO"}));
  text.insert(text.find("<body>"),
              "<actions><action name=\"Count\"><body><ST><p>n := n + 1;</p></ST></body></action></actions>");
  EXPECT_EQ(verdictIn(text, "first_scan implies n = 1 or not a and n = 0"), "PROVED");
  EXPECT_EQ(verdictIn(text, "n = 0"), "VIOLATED");
}

TEST(DrawnBox, ExecuteRunsItsText) {
  std::string text = drawingText("LD", enabledBox("EXECUTE", {}, {"ENO"}) + coilElement(4, {"3.ENO"}, "q", "", 90, 10));
  text.insert(text.find("</block>"),
              "<addData><data name=\"http://www.3s-software.com/plcopenxml/stcode\" handleUnknown=\"implementation\">"
              "<STCode xmlns=\"\">IF n &lt; 3 THEN n := n + 1; END_IF;</STCode></data></addData>");
  EXPECT_EQ(verdictIn(text, "first_scan and a implies n = 1 and q"), "PROVED");
  EXPECT_EQ(verdictIn(text, "n <= 3"), "PROVED");
  EXPECT_EQ(verdictIn(text, "n < 3"), "VIOLATED");
}

/// `text` with statements in its first box, as CODESYS writes them.
std::string withStatements(std::string text, const std::string& statements) {
  return text.insert(
      text.find("</block>"),
      "<addData><data name=\"http://www.3s-software.com/plcopenxml/stcode\" handleUnknown=\"implementation\">"
      "<STCode xmlns=\"\">" +
          statements + "</STCode></data></addData>");
}

// The flow leaves a box of statements, whatever its pin is called: q is a, and n counts the scans with a.
TEST(DrawnBox, TheFlowLeavesABoxOfStatementsByAnyPin) {
  for (const std::string pin : {"Out1", "OUT", "EXECUTE", "eno"}) {
    SCOPED_TRACE(pin);
    const std::string text = withStatements(
        drawingText("LD", enabledBox("EXECUTE", {}, {pin}) + coilElement(4, {"3." + pin}, "q", "", 90, 10)), "n := 1;");
    EXPECT_EQ(verdictIn(text, "q = a"), "PROVED");
    EXPECT_EQ(verdictIn(text, "first_scan implies (n = 1) = a"), "PROVED");
  }
}

// RETURN has no result either: what stands behind it has run only where a is FALSE, and then the flow is FALSE too.
TEST(DrawnBox, TheFlowLeavesReturnByAnyPin) {
  for (const std::string pin : {"Out1", "OUT", "RETURN"}) {
    SCOPED_TRACE(pin);
    const std::string text =
        drawingText("LD", enabledBox("RETURN", {}, {pin}) + coilElement(4, {"3." + pin}, "q", "", 90, 10));
    EXPECT_EQ(verdictIn(text, "never q"), "PROVED");
  }
}

TEST(DrawnBox, ReturnLeavesTheBlock) {  // what stands below keeps its value while a is TRUE
  const std::string text =
      drawingText("LD", enabledBox("RETURN", {}, {"ENO"}) + railElement(5) + contactElement(6, {"5"}, "b", "", 10, 90) +
                            coilElement(7, {"6"}, "q", "", 90, 90));
  EXPECT_EQ(verdictIn(text, "q = b"), "VIOLATED");
  EXPECT_EQ(verdictIn(text, "not a implies q = b"), "PROVED");
  EXPECT_EQ(verdictIn(text, "a and not first_scan implies q = prev(q)"), "PROVED");
}

// A function that no file has, a block of the standard without an instance, operands of types that do not fit.
TEST(DrawnBox, WhatIsNotKnownIsNotCovered) {
  const std::string operands = inElement(9, "n") + inElement(10, "z");
  const std::string boxes[] = {enabledBox("Nowhere", {{"x", {"9"}}}, {"ENO"}) + operands,
                               enabledBox("Nowhere", {{"x", {"9"}}}, {}) + operands,
                               enabledBox("TON", {{"IN", {"2"}}}, {"Q"}) + operands,
                               enabledBox("AND", {{"IN1", {"2"}}, {"IN2", {"9"}}}, {"ENO"}) + operands};
  for (const std::string& box : boxes) {
    const IecOutput output = proofOfDrawing(drawingText("LD", box), "//@ prove asked: z = 0\n");
    EXPECT_TRUE(output.has("NOT COVERED  asked")) << output.text;
    EXPECT_TRUE(output.has("error")) << output.text;
  }
}

TEST(DrawnBox, ElementsOfAMakerAreNotPassedOver) {
  std::string text = drawingText("LD", railElement(1) + contactElement(2, {"1"}, "a") + coilElement(3, {"2"}, "q"));
  text.insert(text.find("</LD>"),
              "<vendorElement localId=\"50\"><position x=\"0\" y=\"90\"/><alternativeText><p>box</p></alternativeText>"
              "<addData><data name=\"http://www.3s-software.com/plcopenxml/fbdelementtype\">"
              "<ElementType xmlns=\"\">execute</ElementType></data></addData></vendorElement>");
  EXPECT_EQ(verdictIn(text, "z = 0"), "NOT COVERED");
}

TEST(DrawnBox, OfAnS7200IsNotPassedOverEither) {
  for (const std::string type : {"RETURN", "Nowhere"}) {
    std::string text = plcopen({"a:BOOL@%IX0.0", "b:BOOL@%IX0.1", "q:BOOL@%QX0.0"}, "LD",
                               enabledBox(type, {}, {"ENO"}) + railElement(5) +
                                   contactElement(6, {"5"}, "b", "", 10, 90) + coilElement(7, {"6"}, "q", "", 90, 90));
    const IecOutput output = proofOfDrawing(text, "//@ prove asked: q = b\n");
    EXPECT_TRUE(output.has("NOT COVERED  asked") && output.has("GRF001")) << output.text;
  }
}

// --- A box with several readers

TEST(DrawnBox, AResultIsComputedOnceForAllItsReaders) {  // z + 1 goes to z and to zz
  const std::string sum = inElement(1, "z") + inElement(2, "1") +
                          blockElement(3, "ADD", "", {{"IN1", {"1"}}, {"IN2", {"2"}}}, {"OUT"}, 50, 10);
  const std::string both = sum + outElement(4, {"3.OUT"}, "z", "", 90, 10) + outElement(5, {"3.OUT"}, "zz", "", 90, 30);
  EXPECT_EQ(verdictIn(drawingText("FBD", both), "zz = z"), "PROVED");
  EXPECT_EQ(verdictIn(drawingText("FBD", both), "first_scan implies z = 1"), "PROVED");
  for (const std::string maker : {"codesys", "beremiz", "openplc"})
    EXPECT_EQ(verdictIn(drawingText("FBD", both), "zz = z", {"--choice", "iec=" + maker}), "PROVED");
  // The comparison sees the sum that was written.
  const std::string compared = sum + outElement(4, {"3.OUT"}, "z", "", 90, 10) + inElement(5, "3") +
                               blockElement(6, "EQ", "", {{"IN1", {"3.OUT"}}, {"IN2", {"5"}}}, {"OUT"}, 90, 30) +
                               outElement(7, {"6.OUT"}, "q", "", 120, 30);
  EXPECT_EQ(verdictIn(drawingText("FBD", compared), "q = (z = 3)"), "PROVED");
}

TEST(DrawnBox, AFunctionWithTwoReadersRunsOnce) {
  const std::string box = inElement(9, "n") + blockElement(3, "Bump", "", {{"v", {"9"}}}, {"Bump"}, 50, 10) +
                          outElement(4, {"3.Bump"}, "z", "", 90, 10) + outElement(5, {"3.Bump"}, "zz", "", 90, 30);
  EXPECT_EQ(verdictIn(drawingText("FBD", box, bump), "z = n and zz = n"), "PROVED");
  EXPECT_EQ(verdictIn(drawingText("FBD", box, bump), "first_scan implies n = 1"), "PROVED");
}

// LT(z, 3) lets z grow and tells q: q is TRUE in the scan in which z becomes 3.
TEST(DrawnBox, PowerFlowIsAskedOnce) {
  const std::string text = drawingText(
      "LD",
      railElement(1) + inElement(2, "z") + inElement(3, "3") +
          blockElement(4, "LT", "", {{"EN", {"1"}}, {"IN1", {"2"}}, {"IN2", {"3"}}}, {"ENO", "OUT"}, 30, 10) +
          inElement(5, "z") + inElement(6, "1") +
          blockElement(7, "ADD", "", {{"EN", {"4.OUT"}}, {"IN1", {"5"}}, {"IN2", {"6"}}}, {"ENO", "OUT"}, 60, 10) +
          outElement(8, {"7.OUT"}, "z", "", 90, 5) + coilElement(9, {"7.ENO"}, "q", "", 90, 30));
  EXPECT_EQ(verdictIn(text, "q = (first_scan or prev(z) < 3)"), "PROVED");
  EXPECT_EQ(verdictIn(text, "z <= 3"), "PROVED");
}

// ADD stands first, the write of z second, its reader third: zz is the z of before plus 1. By position it is asked for
// by its reader.
TEST(DrawnBox, TheStatedOrderHoldsForBoxesToo) {
  const std::string text = drawingText(
      "FBD",
      inElement(1, "z", "", 10, 100) + inElement(2, "1", "", 10, 110) +
          blockElement(3, "ADD", "", {{"IN1", {"1"}}, {"IN2", {"2"}}}, {"OUT"}, 50, 100, "executionOrderId=\"1\"") +
          inElement(4, "5", "", 10, 10) + outElement(5, {"4"}, "z", "executionOrderId=\"2\"", 90, 10) +
          outElement(6, {"3.OUT"}, "zz", "executionOrderId=\"3\"", 90, 100));
  EXPECT_EQ(verdictIn(text, "first_scan implies zz = 1", {"--choice", "iec-fbd-order=execution-id"}), "PROVED");
  EXPECT_EQ(verdictIn(text, "zz = 6", {"--choice", "iec-fbd-order=position"}), "PROVED");
}

// Each box takes the result before it twice: 40 of them would be 2^40 elements.
TEST(DrawnBox, BoxesThatTakeAResultTwiceDoNotGrow) {
  std::string elements = inElement(1, "n");
  for (int i = 2; i <= 41; ++i) {
    const std::string before = i == 2 ? "1" : std::to_string(i - 1) + ".OUT";
    elements += blockElement(i, "MAX", "", {{"IN1", {before}}, {"IN2", {before}}}, {"OUT"}, 10 * i, 10);
  }
  EXPECT_EQ(verdictIn(drawingText("FBD", elements + outElement(90, {"41.OUT"}, "z", "", 900, 10)), "z = n"), "PROVED");
}

// SEL of two numbers has no type of its own: it takes that of its readers.
TEST(DrawnBox, AChoiceOfNumbersTakesTheTypeOfItsReaders) {
  const std::string text = drawingText(
      "FBD", inElement(1, "a") + inElement(2, "3") + inElement(3, "7") +
                 blockElement(4, "SEL", "", {{"G", {"1"}}, {"IN0", {"2"}}, {"IN1", {"3"}}}, {"OUT"}, 50, 10) +
                 outElement(5, {"4.OUT"}, "z", "", 90, 10) + outElement(6, {"4.OUT"}, "zz", "", 90, 30));
  EXPECT_EQ(verdictIn(text, "z = zz and (a implies z = 7) and (not a implies z = 3)"), "PROVED");
}

// --- ENO, results under EN, second outputs

TEST(DrawnBox, EnoOfADivisionTellsOfAZero) {  // by the reading that goes on: n is the divisor
  const std::vector<std::string> variables = {"a:BOOL@%IX0.0", "n:INT@%IW1", "z:INT", "q:BOOL", "s:INT"};
  for (const std::string type : {"DIV", "MOD"}) {
    const std::string box = enabledBox(type, {{"IN1", {"9"}}, {"IN2", {"10"}}}, {"ENO", "OUT"}) + inElement(9, "100") +
                            inElement(10, "n") + outElement(5, {"3.OUT"}, "z", "", 90, 5) +
                            coilElement(4, {"3.ENO"}, "q", "", 90, 30);
    const std::vector<std::string> goesOn = {"--choice", "iec-div-zero=zero", "--choice", "iec-mod-zero=zero"};
    EXPECT_EQ(verdictIn(drawingText("LD", box, "", variables), "q = (a and n <> 0)", goesOn), "PROVED") << type;
  }
  // ENO leads to EN of the next box: it does not run.
  const std::string row =
      enabledBox("DIV", {{"IN1", {"9"}}, {"IN2", {"10"}}}, {"ENO", "OUT"}) + inElement(9, "100") + inElement(10, "n") +
      inElement(11, "1") + inElement(12, "1") +
      blockElement(4, "ADD", "", {{"EN", {"3.ENO"}}, {"IN1", {"11"}}, {"IN2", {"12"}}}, {"ENO", "OUT"}, 80, 10) +
      outElement(5, {"4.OUT"}, "s", "", 120, 10);
  EXPECT_EQ(verdictIn(drawingText("LD", row, "", variables), "first_scan and n = 0 implies s = 0",
                      {"--choice", "iec-div-zero=zero"}),
            "PROVED");
  EXPECT_EQ(
      verdictIn(drawingText("LD", row, "", variables), "a and n <> 0 implies s = 2", {"--choice", "iec-div-zero=zero"}),
      "PROVED");
}

TEST(DrawnBox, EnoMayBeNegated) {
  std::string text = drawingText("LD", enabledBox("MOVE", {{"IN", {"9"}}}, {"ENO", "OUT"}) + inElement(9, "n") +
                                           coilElement(4, {"3.ENO"}, "q", "", 90, 10));
  const std::string pin = "formalParameter=\"ENO\"";
  text.insert(text.find("<variable " + pin) + 10, "negated=\"true\" ");
  EXPECT_EQ(verdictIn(text, "q = not a"), "PROVED");
  text.insert(text.find("<types>"), headingOfS7200);
  EXPECT_EQ(verdictIn(text, "q = not a"), "PROVED");
}

// z is n + 1 where a is TRUE, and keeps its value or is 0 without.
TEST(DrawnBox, AResultUnderEnIsKept) {
  const std::string function =
      "<pou name=\"Above\" pouType=\"function\"><interface><returnType><BOOL/></returnType><inputVars>" +
      declarations({"x:INT"}) + "</inputVars><outputVars>" + declarations({"by:INT"}) +
      "</outputVars></interface><body><ST><p>by := x - 5; Above := x > 5;</p></ST></body></pou>\n";
  const std::vector<std::string> variables = {"a:BOOL@%IX0.0", "n:INT@%IW1", "z:INT", "q:BOOL"};
  const std::string text =
      drawingText("LD",
                  enabledBox("Above", {{"x", {"9"}}}, {"ENO", "Above", "by"}) + inElement(9, "n") +
                      coilElement(4, {"3.Above"}, "q", "", 90, 10) + outElement(5, {"3.by"}, "z", "", 90, 30),
                  function, variables);
  EXPECT_EQ(verdictIn(text, "a implies q = (n > 5)"), "PROVED");
  EXPECT_EQ(verdictIn(text, "a and n = 7 implies z = 2"), "PROVED");
  EXPECT_EQ(verdictIn(text, "not a and not first_scan implies q = prev(q) and z = prev(z)"), "PROVED");
  EXPECT_EQ(verdictIn(text, "not a implies not q", {"--choice", "iec-en-false-result=zero"}), "PROVED");
}

// --- IN_OUT

TEST(DrawnBox, TheRightPinOfAnInOutPassesTheVariableOn) {
  const std::string counter =
      "<pou name=\"Counter\" pouType=\"functionBlock\"><interface><inputVars>" + declarations({"up:BOOL"}) +
      "</inputVars><inOutVars>" + declarations({"v:INT"}) +
      "</inOutVars></interface><body><ST><p>IF up THEN v := v + 1; END_IF;</p></ST></body></pou>\n";
  std::vector<std::string> variables = usual;
  variables.insert(variables.end(), {"f1:Counter", "f2:Counter"});
  const std::string row = inElement(1, "a") + inElement(2, "n") + inElement(3, "b") +
                          blockElement(4, "Counter", "f1", {{"up", {"1"}}, {"v", {"2"}}}, {"v"}, 50, 10) +
                          blockElement(5, "Counter", "f2", {{"up", {"3"}}, {"v", {"4.v"}}}, {"v"}, 80, 10) +
                          outElement(6, {"5.v"}, "z", "", 120, 10);
  const std::string text = drawingText("FBD", row, counter, variables);
  EXPECT_EQ(verdictIn(text, "z = n"), "PROVED");
  EXPECT_EQ(verdictIn(text, "first_scan and a and b implies n = 2"), "PROVED");
  // The same pin of a function.
  const std::string function = inElement(9, "n") + blockElement(3, "Bump", "", {{"v", {"9"}}}, {"Bump", "v"}, 50, 10) +
                               outElement(4, {"3.v"}, "z", "", 90, 10);
  EXPECT_EQ(verdictIn(drawingText("FBD", function, bump), "z = n"), "PROVED");
}

TEST(DrawnBox, AnInOutHasNoValueFromOutside) {
  const IecOutput output = proofOfIec(
      "//@ prove asked: z = n\nFUNCTION_BLOCK F VAR_INPUT up : BOOL; END_VAR VAR_IN_OUT v : INT; END_VAR\n"
      "IF up THEN v := v + 1; END_IF;\nEND_FUNCTION_BLOCK\n"
      "PROGRAM M VAR a AT %IX0.0 : BOOL; n, z : INT; f1 : F; END_VAR\nf1(up := a, v := n);\nz := f1.v;\nEND_PROGRAM\n");
  EXPECT_TRUE(output.has("NOT COVERED  asked") && output.has("v is an IN_OUT of F")) << output.text;
}

// --- Variables that are set and reset

TEST(DrawnBox, AVariableMayBeSetOrReset) {
  const std::string elements = inElement(1, "a", "", 10, 10) + outElement(2, {"1"}, "q", "storage=\"set\"", 90, 10) +
                               inElement(3, "b", "", 10, 50) + outElement(4, {"3"}, "q", "storage=\"reset\"", 90, 50);
  const std::string asked = "q = (not b and (a or not first_scan and prev(q)))";
  EXPECT_EQ(verdictIn(drawingText("FBD", elements), asked), "PROVED");
  EXPECT_EQ(verdictIn(plcopen({"a:BOOL@%IX0.0", "b:BOOL@%IX0.1", "q:BOOL"}, "FBD", elements), asked), "PROVED");
}

}  // namespace
}  // namespace rungproof
