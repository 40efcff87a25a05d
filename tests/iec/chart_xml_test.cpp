// Charts of PLCopen TC6 XML: which steps stand in front of and behind a transition, conditions and actions in all
// languages, what is not modelled.
#include "tests/iec/iec_output.hpp"

namespace rungproof {
namespace {

std::string links(std::initializer_list<int> ids) {
  std::string text = "<connectionPointIn>";
  for (const int id : ids) text += fmt::format("<connection refLocalId=\"{}\"/>", id);
  return text + "</connectionPointIn>";
}
std::string stepNamed(int id, const std::string& name, std::initializer_list<int> above, bool isInitial = false) {
  return fmt::format(
      "<step localId=\"{}\" name=\"{}\" initialStep=\"{}\"><position x=\"{}\" y=\"10\"/>{}<connectionPointOut "
      "formalParameter=\"sfc\"/></step>\n",
      id, name, isInitial ? "true" : "false", id, above.size() == 0 ? "" : links(above));
}
std::string inlineText(const std::string& text) { return "<inline name=\"\"><ST><p>" + text + "</p></ST></inline>"; }
std::string transition(int id, int above, const std::string& condition, const std::string& more = "", int x = -1) {
  return fmt::format(
      "<transition localId=\"{}\" {}><position x=\"{}\" y=\"20\"/>{}<connectionPointOut/><condition>{}</condition></"
      "transition>\n",
      id, more, x < 0 ? id : x, links({above}), condition);
}
std::string element(const std::string& kind, int id, std::initializer_list<int> above) {
  return fmt::format("<{0} localId=\"{1}\"><position x=\"0\" y=\"0\"/>{2}<connectionPointOut/></{0}>\n", kind, id,
                     links(above));
}
std::string jump(int id, const std::string& target, int above) {
  return fmt::format("<jumpStep localId=\"{}\" targetName=\"{}\"><position x=\"0\" y=\"0\"/>{}</jumpStep>\n", id,
                     target, links({above}));
}
std::string actions(int id, int step, const std::string& content) {
  return fmt::format("<actionBlock localId=\"{}\"><position x=\"0\" y=\"0\"/>{}{}</actionBlock>\n", id, links({step}),
                     content);
}
std::string action(const std::string& attributes, const std::string& content) {
  return "<action localId=\"0\" " + attributes + "><relPosition x=\"0\" y=\"0\"/>" + content + "</action>";
}
std::string reference(const std::string& name) { return "<reference name=\"" + name + "\"/>"; }

/// A program with inputs x, y, z, outputs q, r, a number n; `parts`: its named actions and transitions.
std::string project(const std::string& chart, const std::string& parts = "") {
  std::string text =
      "<?xml version=\"1.0\"?>\n<project xmlns=\"http://www.plcopen.org/xml/tc6_0201\"><types><dataTypes/><pous><pou "
      "name=\"main\" pouType=\"program\"><interface><inputVars>";
  for (const char* const name : {"x", "y", "z"})
    text += fmt::format("<variable name=\"{}\"><type><BOOL/></type></variable>", name);
  text += "</inputVars><outputVars>";
  for (const char* const name : {"q", "r"})
    text += fmt::format("<variable name=\"{}\"><type><BOOL/></type></variable>", name);
  return text + "</outputVars><localVars><variable name=\"n\"><type><INT/></type></variable></localVars></interface>" +
         parts + "<body><SFC>\n" + chart + "</SFC></body></pou></pous></types></project>";
}

/// Verdicts with transitions tested first, which most of these properties take for granted.
IecOutput proofOfChart(const std::string& xml, const std::string& properties) {
  const test::TemporaryFolder folder;
  folder.file("p.xml", xml);
  folder.file("p.prop", properties);
  std::istringstream in;
  std::ostringstream out, err;
  const int exit = runProgram({"prove", folder.path("p.xml"), "--props", folder.path("p.prop"), "--choice",
                               "iec-sfc-order=transitions-first", "--scan-time", "10ms", "--isolated"},
                              {in, out, err});
  return {exit, out.str() + err.str()};
}

TEST(IecChartXml, ASequenceWithAJump) {  // A -x-> B -y-> A; such a file is read as this family's without being told
  const std::string xml = project(stepNamed(1, "A", {}, true) + transition(2, 1, inlineText("x")) +
                                  stepNamed(3, "B", {2}) + actions(4, 3, action("qualifier=\"N\"", reference("q"))) +
                                  transition(5, 3, inlineText("y")) + jump(6, "A", 5));
  const IecOutput output = proofOfChart(
      xml,
      "prove q: q = B.X\nprove one: A.X = not B.X\nprove entered: rises(B.X) and not first_scan implies x\n"
      "prove left: falls(B.X) implies y\nreach again: once(falls(B.X)) and B.X\n");
  for (const char* const part : {"PROVED  q", "PROVED  one", "PROVED  entered", "PROVED  left", "REACHABLE  again"})
    EXPECT_TRUE(output.has(part)) << part << "\n" << output.text;
}

TEST(IecChartXml,
     ASelectionIsTakenFromLeftToRight) {  // the transition with the smaller x, which stands last in the file
  const std::string chart = stepNamed(1, "A", {}, true) + element("selectionDivergence", 2, {1}) +
                            transition(3, 2, inlineText("x"), "", 50) + transition(4, 2, inlineText("y"), "", 10) +
                            stepNamed(5, "B", {3}) + stepNamed(6, "C", {4}) + transition(7, 5, inlineText("TRUE")) +
                            transition(8, 6, inlineText("TRUE")) + element("selectionConvergence", 9, {7, 8}) +
                            stepNamed(10, "D", {9});
  const std::string properties =
      "prove left: rises(B.X) and not first_scan implies not y\nprove single: not (B.X and C.X)\nreach end: D.X and "
      "once(B.X)\nreach other end: D.X and once(C.X)\n";
  const IecOutput output = proofOfChart(project(chart), properties);
  for (const char* const part : {"PROVED  left", "PROVED  single", "REACHABLE  end", "REACHABLE  other end"})
    EXPECT_TRUE(output.has(part)) << part << "\n" << output.text;
  // Numbers come before the place.
  const std::string numbered = stepNamed(1, "A", {}, true) + transition(3, 1, inlineText("x"), "priority=\"1\"", 50) +
                               transition(4, 1, inlineText("y"), "priority=\"2\"", 10) + stepNamed(5, "B", {3}) +
                               stepNamed(6, "C", {4});
  EXPECT_TRUE(proofOfChart(project(numbered), "prove right: rises(C.X) and not first_scan implies not x\n")
                  .has("PROVED  right"));
}

TEST(IecChartXml, BranchesAtTheSameTime) {
  const std::string chart =
      stepNamed(1, "A", {}, true) + transition(2, 1, inlineText("x")) + element("simultaneousDivergence", 3, {2}) +
      stepNamed(4, "B", {3}) + stepNamed(5, "C", {3}) + transition(6, 4, inlineText("y")) + stepNamed(7, "B2", {6}) +
      element("simultaneousConvergence", 8, {7, 5}) + transition(9, 8, inlineText("z")) + stepNamed(10, "E", {9});
  const IecOutput output =
      proofOfChart(project(chart),
                   "prove both: B.X or B2.X implies C.X\nprove waits: rises(E.X) implies prev(B2.X) and prev(C.X)\n"
                   "prove all gone: E.X implies not B.X and not B2.X and not C.X\nreach end: E.X\n");
  for (const char* const part : {"PROVED  both", "PROVED  waits", "PROVED  all gone", "REACHABLE  end"})
    EXPECT_TRUE(output.has(part)) << part << "\n" << output.text;
}

std::string twoSteps(const std::string& condition) {
  return stepNamed(1, "A", {}, true) + transition(2, 1, condition) + stepNamed(3, "B", {2});
}
const std::string contacts =
    R"(<leftPowerRail localId="20"><position x="0" y="0"/><connectionPointOut formalParameter=""/></leftPowerRail>
<contact localId="21"><position x="10" y="0"/><connectionPointIn><connection refLocalId="20"/></connectionPointIn><connectionPointOut/><variable>x</variable></contact>
<contact localId="22" negated="true"><position x="20" y="0"/><connectionPointIn><connection refLocalId="21"/></connectionPointIn><connectionPointOut/><variable>y</variable></contact>
)";

/// Conditions that all say x AND NOT y.
TEST(IecChartXml, ConditionsInAllLanguages) {
  const auto named = [](const std::string& body) {
    return "<transitions><transition name=\"Go\"><body>" + body + "</body></transition></transitions>";
  };
  const std::string drawn =
      "<LD>" + contacts +
      R"(<coil localId="23"><position x="30" y="0"/><connectionPointIn><connection refLocalId="22"/></connectionPointIn><connectionPointOut/><variable>Go</variable></coil></LD>)";
  const std::vector<std::pair<std::string, std::string>> rows = {
      {inlineText("x AND NOT y"), ""},
      {inlineText("x AND NOT y;"), ""},
      {"<inline name=\"\"><IL><p>LD x\nANDN y</p></IL></inline>", ""},
      {reference("Go"), named("<ST><p>x AND NOT y</p></ST>")},
      {reference("Go"), named("<ST><p>\n:= x AND NOT y;</p></ST>")},  // as Beremiz and OpenPLC write it
      {inlineText(":= x AND NOT y;"), ""},
      {reference("Go"), named("<ST><p>IF x THEN Go := NOT y; ELSE Go := FALSE; END_IF;</p></ST>")},
      {reference("Go"), named("<IL><p>LD x\nANDN y\nST Go</p></IL>")},
      {reference("Go"), named(drawn)},
      {"<connectionPointIn><connection refLocalId=\"22\"/></connectionPointIn>", ""},
  };
  for (const auto& [condition, parts] : rows) {
    SCOPED_TRACE(condition + parts);
    const std::string beside = condition.starts_with("<connectionPointIn") ? contacts : "";
    const IecOutput output = proofOfChart(
        project(beside + twoSteps(condition), parts),
        "prove entered: rises(B.X) implies x and not y\nprove at once: prev(A.X) and x and not y implies B.X\n");
    EXPECT_TRUE(output.has("PROVED  entered") && output.has("PROVED  at once")) << output.text;
  }
  const IecOutput inverted =
      proofOfChart(project(stepNamed(1, "A", {}, true) + "<transition localId=\"2\"><position x=\"0\" y=\"0\"/>" +
                           links({1}) + "<connectionPointOut/><condition negated=\"true\">" + inlineText("x") +
                           "</condition></transition>" + stepNamed(3, "B", {2})),
                   "prove entered: rises(B.X) implies not x\n");
  EXPECT_TRUE(inverted.has("PROVED  entered")) << inverted.text;
  const IecOutput variable = proofOfChart(project(twoSteps(reference("z"))), "prove entered: rises(B.X) implies z\n");
  EXPECT_TRUE(variable.has("PROVED  entered")) << variable.text;
}

TEST(IecChartXml, ActionsInAllLanguages) {
  const std::string own = "<inline name=\"\"><IL><p>LD x\nST q</p></IL></inline>";
  const std::string coil =
      R"(<LD><leftPowerRail localId="20"><position x="0" y="0"/><connectionPointOut formalParameter=""/></leftPowerRail>
<contact localId="21"><position x="10" y="0"/><connectionPointIn><connection refLocalId="20"/></connectionPointIn><connectionPointOut/><variable>y</variable></contact>
<coil localId="22"><position x="20" y="0"/><connectionPointIn><connection refLocalId="21"/></connectionPointIn><connectionPointOut/><variable>r</variable></coil></LD>)";
  const std::string chart = stepNamed(1, "A", {}, true) +
                            actions(2, 1,
                                    action("qualifier=\"N\"", own) + action("", reference("Copy")) +
                                        action("qualifier=\"D\" duration=\"T#20ms\"", reference("Late"))) +
                            transition(3, 1, inlineText("FALSE"));
  const std::string parts =
      "<actions><action name=\"Copy\"><body>" + coil +
      "</body></action><action name=\"Late\"><body><ST><p>n := 1;</p></ST></body></action></actions>";
  const IecOutput output =
      proofOfChart(project(chart + stepNamed(4, "B", {3}), parts),
                   "prove q: q = x\nprove r: r = y\nprove late: n = 1 implies A.T >= 20\nreach n: n = 1\n");
  for (const char* const part : {"PROVED  q", "PROVED  r", "PROVED  late", "REACHABLE  n"})
    EXPECT_TRUE(output.has(part)) << part << "\n" << output.text;
}

/// The first step, A, with what CODESYS says of it.
std::string codesysStep(const std::string& guid, const std::string& value) {
  std::string text = stepNamed(1, "A", {}, true);
  return text.insert(text.find("</step>"),
                     "<addData><data name=\"http://www.3s-software.com/plcopenxml/sfc/element\" "
                     "handleUnknown=\"implementation\"><attributes xmlns=\"\"><attribute guid=\"" +
                         guid + "\">" + value + "</attribute></attributes></data></addData>");
}

// Its name, values that say nothing, and actions that are not there change nothing: A is left with x.
TEST(IecChartXml, WhatCodesysSaysOfAStepWithoutActionsIsRead) {
  const std::pair<std::string, std::string> said[] = {{"38391c6d-6d4a-42f8-8ee7-9f45e5adafa8", "A"},
                                                      {"01580b27-6378-448b-8ecb-0e4b795b58d6", "FALSE"},
                                                      {"bc882c11-1e91-4dd8-a6b8-2075724ed18b", "0"},
                                                      {"6844a48e-46c2-4cc8-a185-a478f3b99cc0", "TRUE"},
                                                      {"700a583f-b4d4-43e4-8c14-629c7cd3bec8", ""}};
  for (const auto& [guid, value] : said) {
    const IecOutput output =
        proofOfChart(project(codesysStep(guid, value) + transition(2, 1, inlineText("x")) + stepNamed(3, "B", {2})),
                     "prove p: first_scan and not x implies not B.X\nreach n: B.X\n");
    EXPECT_TRUE(output.has("PROVED  p") && output.has("REACHABLE  n")) << guid << "\n" << output.text;
  }
}

struct WrongXml {
  std::string chart, message;
};

TEST(IecChartXml, WrongChartsAreNamedAndNotProved) {
  const std::string ends = transition(2, 1, inlineText("x")) + stepNamed(3, "B", {2});
  const std::string start = stepNamed(1, "A", {}, true);
  const WrongXml rows[] = {
      {start + ends + "<macroStep localId=\"9\" name=\"M\"><position x=\"0\" y=\"0\"/></macroStep>",
       "macro steps are not modelled"},
      {start + transition(2, 1, inlineText("x")), "the transition leads to no step"},
      {start + transition(2, 7, inlineText("x")) + stepNamed(3, "B", {2}), "there is no element 7"},
      {start + ends + "<transition localId=\"7\"><position x=\"0\" y=\"0\"/><connectionPointOut/><condition>" +
           inlineText("10 / n > 2") + "</condition></transition>" + stepNamed(8, "C", {7}),
       "no step leads to the transition"},
      {start + ends + transition(5, 2, inlineText("x")) + stepNamed(6, "C", {5}),
       "<transition> does not lead to <transition>"},
      {start + ends + stepNamed(7, "D", {3}), "<step> does not lead to <step>"},
      {start + ends + transition(5, 3, inlineText("x")) + jump(6, "Nowhere", 5), "there is no step Nowhere"},
      {start + transition(2, 1, "") + stepNamed(3, "B", {2}), "the transition has no condition"},
      {start + transition(2, 1, inlineText("x AND")) + stepNamed(3, "B", {2}), "a value is needed here, the text ends"},
      {start + transition(2, 1, inlineText(":= x := y")) + stepNamed(3, "B", {2}), "':=' does not belong here"},
      {start + ends + actions(8, 3, action("qualifier=\"X\"", reference("q"))), "X is no qualifier of an action"},
      {start + ends + actions(8, 3, action("qualifier=\"L\"", reference("q"))), "L needs a duration"},
      {start + ends + actions(8, 2, action("", reference("q"))), "which step has these actions is not said"},
      {start + ends + actions(8, 3, action("", "")), "an action has neither a name nor a body"},
      {stepNamed(1, "A", {}) + ends, "the chart has no initial step"},
      {start + ends +
           "<coil localId=\"9\"><position x=\"0\" y=\"0\"/><connectionPointIn/><connectionPointOut/><variable>q"
           "</variable></coil>",
       "<coil> in a chart belongs to no condition"},
      {start + ends + "<gadget localId=\"9\"/>", "element <gadget> is not known in <SFC>"},
      {codesysStep("a6b08bd8-b696-47e3-9cbf-7408b61c9ff8", "A_entry") + ends,
       "actions of CODESYS at entry and exit of a step are not modelled"},
      {codesysStep("01580b27-6378-448b-8ecb-0e4b795b58d6", "TRUE") + ends, "of CODESYS says of a step is not known"},
      {codesysStep("00000000-0000-0000-0000-000000000000", "1") + ends, "of CODESYS says of a step is not known"},
  };
  for (const WrongXml& row : rows) {
    SCOPED_TRACE(row.chart);
    const bool hasB = row.chart.find("name=\"B\"") != std::string::npos;
    const IecOutput output = proofOfChart(project(row.chart), hasB ? "prove p: not B.X\n" : "prove p: not q\n");
    EXPECT_TRUE(output.has("NOT COVERED  p")) << output.text;
    const IecOutput findings = runIec({"lint"}, project(row.chart), "p.xml");
    EXPECT_TRUE(findings.has(row.message)) << findings.text;
  }
}

}  // namespace
}  // namespace rungproof
