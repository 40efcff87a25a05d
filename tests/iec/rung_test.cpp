// Ladder in the short XML form with rungs, and what drawings have beside contacts and coils: jumps, labels, instances
// that nobody declares, several worksheets.
#include "tests/iec/iec_output.hpp"

namespace rungproof {
namespace {

std::string declared(const char* list, const std::string& names, const char* type = "BOOL") {
  std::string text = fmt::format("<{}>", list);
  std::istringstream in(names);
  for (std::string name; in >> name;)
    text += fmt::format("<variable name=\"{}\"><type><{}/></type></variable>", name, type);
  return text + fmt::format("</{}>\n", list);
}
/// A program with inputs a, b, c, outputs q, r, s and numbers n, t; `bodies`: all of its bodies.
std::string drawnProgram(const std::string& bodies) {
  return "<?xml version=\"1.0\"?>\n<project "
         "xmlns=\"http://www.plcopen.org/xml/tc6_0200\"><types/><instances/><pous><pou "
         "name=\"main\" pouType=\"program\"><interface>" +
         declared("inputVars", "a b c") + declared("outputVars", "q r s") + declared("localVars", "n t", "INT") +
         "</interface>" + bodies + "</pou></pous></project>\n";
}
std::string rungs(const std::string& list) { return drawnProgram("<body><LD>\n" + list + "</LD></body>"); }
std::string contactOf(const std::string& name, const std::string& more = "") {
  return fmt::format("<contact variable=\"{}\" {}/>", name, more);
}
std::string coilOf(const std::string& name, const std::string& more = "") {
  return fmt::format("<coil variable=\"{}\" {}/>", name, more);
}
std::string rungOf(const std::string& parts) { return "<rung localId=\"1\">" + parts + "</rung>\n"; }

IecOutput askedOf(const std::string& xml, const std::string& property) {
  const test::TemporaryFolder folder;
  folder.file("main.xml", xml);
  folder.file("main.prop", "prove asked: " + property + "\n");
  std::istringstream in;
  std::ostringstream out, err;
  const int exit = runProgram({"prove", folder.path("main.xml"), "--props", folder.path("main.prop"), "--dialect",
                               "iec", "--isolated", "--scan-time", "10ms"},
                              {in, out, err});
  return {exit, out.str() + err.str()};
}
void expectVerdict(const std::string& xml, const std::string& property, const std::string& verdict) {
  const IecOutput output = askedOf(xml, property);
  EXPECT_TRUE(output.has(verdict + "  asked")) << property << "\n" << output.text;
}

TEST(IecRungs, ContactsInSeriesGoToTheCoils) {
  const std::string xml = rungs(
      rungOf(contactOf("a") + contactOf("b", "negated=\"negated\"") + coilOf("q") + coilOf("r")) +
      rungOf(contactOf("q") + coilOf("s", "kind=\"set\"")) + rungOf(contactOf("c") + coilOf("s", "kind=\"reset\"")));
  expectVerdict(xml, "q = (a and not b) and r = q", "PROVED");
  expectVerdict(xml, "c implies not s", "PROVED");  // the reset stands behind
  expectVerdict(xml, "s = q", "VIOLATED");          // it stays set
}

// The attributes of PLCopen mean in a rung what they mean elsewhere; "none" is what editors write where there is
// nothing.
TEST(IecRungs, AttributesOfPlcopen) {
  const std::string xml = rungs(rungOf(contactOf("a", "negated=\"false\" storage=\"none\" edge=\"none\"") +
                                       coilOf("s", "storage=\"set\"") + coilOf("q", "storage=\"none\"")) +
                                rungOf(contactOf("c", "negated=\"1\"") + coilOf("s", "storage=\"reset\"")));
  expectVerdict(xml, "(not c) implies not s", "PROVED");
  expectVerdict(xml, "prev(s) and c implies s", "PROVED");  // it stays set
  expectVerdict(xml, "q = a", "PROVED");
  const IecOutput shown = runIec({"show", "--dialect", "iec"}, xml, "main.xml");
  EXPECT_TRUE(shown.has("(S)") && shown.has("(R)")) << shown.text;
}

/// A rung is a network and is drawn as it stands: q by a and not b, and the same flow sets s.
TEST(IecRungs, RungsAreDrawn) {
  const std::string pins =
      "<variable formalParameter=\"IN\">a</variable><variable formalParameter=\"PT\">t</variable>"
      "<variable formalParameter=\"Q\">r</variable>";
  const std::string xml =
      rungs(rungOf(contactOf("a") + contactOf("b", "negated=\"negated\"") + coilOf("q") + coilOf("s", "kind=\"set\"")) +
            rungOf("<block typeName=\"TON\" instanceName=\"d\">" + pins + "</block>"));
  const IecOutput shown = runIec({"show", "--dialect", "iec"}, xml, "main.xml");
  EXPECT_FALSE(shown.has("<contact")) << shown.text;
  for (const char* const part : {"TON", "PT", "Network 2"}) EXPECT_TRUE(shown.has(part)) << part << "\n" << shown.text;
  EXPECT_FALSE(shown.has("Network 3")) << shown.text;
}

TEST(IecRungs, TheFlowOfARungIsComputedOnce) {  // a coil that clears its contact does not part its rung
  const std::string xml = rungs(rungOf(contactOf("a") + coilOf("s", "kind=\"set\"")) +
                                rungOf(contactOf("s") + coilOf("q") + coilOf("s", "kind=\"reset\"") + coilOf("r")));
  expectVerdict(xml, "q = a and r = a and not s", "PROVED");
}

TEST(IecRungs, TheLastCoilOfAVariableWins) {
  expectVerdict(rungs(rungOf(contactOf("a") + coilOf("q")) + rungOf(contactOf("b") + coilOf("q"))), "q = b", "PROVED");
}

TEST(IecRungs, BlocksTakeTheirVariables) {
  const auto pin = [](const char* name, const char* variable) {
    return fmt::format("<variable formalParameter=\"{}\">{}</variable>", name, variable);
  };
  const std::string timer =
      rungs(rungOf("<block typeName=\"MOVE\" instanceName=\"m\">" + pin("IN", "30") + pin("OUT", "t") + "</block>") +
            rungOf("<block typeName=\"TON\" instanceName=\"d\">" + pin("IN", "a") + pin("PT", "t") + pin("Q", "q") +
                   pin("ET", "n") + "</block>"));
  // A number of milliseconds or of seconds, by the reading in force.
  expectVerdict(timer, "q implies held(a, 30ms)", "PROVED");
  expectVerdict(timer, "n >= 0 and n <= 30", "PROVED");
  expectVerdict(timer, "not q", "VIOLATED");
  const IecOutput linted = runIec({"lint", "--dialect", "iec", "--level", "note"}, timer, "main.xml");
  EXPECT_TRUE(linted.has("d is not declared: it is taken as an instance of TON")) << linted.text;
  const std::string sum = rungs(rungOf("<block typeName=\"ADD\" instanceName=\"x\">" + pin("IN1", "3") +
                                       pin("IN2", "4") + pin("OUT", "n") + "</block>"));
  expectVerdict(sum, "n = 7", "PROVED");
}

TEST(IecRungs, WhatIsNotModelledIsNamed) {
  const auto saysOf = [](const std::string& list, const char* message) {
    const IecOutput output = askedOf(rungs(list), "not q");
    EXPECT_TRUE(output.has(message)) << output.text;
    EXPECT_EQ(output.exit, 2);
  };
  saysOf(rungOf("<jump label=\"x\"/>"), "<jump> in a rung is not modelled");
  saysOf(rungOf(contactOf("a", "kind=\"rising\"") + coilOf("q")), "a contact of kind rising is not modelled");
  saysOf(rungOf(contactOf("a", "edge=\"falling\"") + coilOf("q")), "a contact of kind falling is not modelled");
  saysOf(rungOf(contactOf("a") + coilOf("q", "edge=\"rising\"")), "a coil of kind rising is not modelled");
  saysOf(rungOf(contactOf("a") + coilOf("q", "storage=\"set\" negated=\"true\"")),
         "a negated coil of kind set is not modelled");
  saysOf(rungOf("<block typeName=\"TON\" instanceName=\"d\"><variable formalParameter=\"IN\" negated=\"true\">a"
                "</variable></block>") +
             rungOf(contactOf("a") + coilOf("q")),
         "a pin that negates or finds edges, as IN, is not modelled in such a rung");
  saysOf(rungOf(contactOf("a") + "<coil/>"), "<coil> names no variable");
  saysOf(rungOf(contactOf("a") + "<block typeName=\"TON\" instanceName=\"d\"/>"), "contacts in front of a block");
  saysOf(rungOf(contactOf("a") + coilOf("q")) + "<comment/>", "<comment> stands between rungs");
  saysOf(rungOf(contactOf("nothing") + coilOf("q")), "there is no variable nothing");
}

std::string at(int id) { return fmt::format("<position x=\"{}\" y=\"{}\"/>", 10, id * 10); }
std::string from(int id) {
  return fmt::format("<connectionPointIn><connection refLocalId=\"{}\"/></connectionPointIn>", id);
}
std::string drawn(const char* kind, int id, int source, const std::string& attribute,
                  const std::string& variable = "") {
  return fmt::format("<{0} localId=\"{1}\" {4}>{2}{3}{5}</{0}>", kind, id, at(id), source == 0 ? "" : from(source),
                     attribute, variable.empty() ? "" : "<connectionPointOut/><variable>" + variable + "</variable>");
}
std::string ladderOf(const std::string& parts) {
  return "<body><LD><leftPowerRail localId=\"1\"><position x=\"0\" y=\"0\"/><connectionPointOut formalParameter=\"\"/>"
         "</leftPowerRail>" +
         parts + "</LD></body>";
}

TEST(IecDrawn, AJumpLeavesOutTheNetworksInBetween) {
  const std::string xml = drawnProgram(ladderOf(
      drawn("contact", 2, 1, "", "a") + drawn("jump", 3, 2, "label=\"behind\"") + drawn("contact", 4, 1, "", "b") +
      drawn("coil", 5, 4, "", "q") + drawn("label", 6, 0, "label=\"behind\"") + drawn("contact", 7, 1, "", "c") +
      drawn("coil", 8, 7, "", "r")));
  expectVerdict(xml, "not a implies q = b", "PROVED");
  expectVerdict(xml, "q = b", "VIOLATED");  // where a is TRUE, q stays as it was
  expectVerdict(xml, "a and not first_scan implies q = prev(q)", "PROVED");
  expectVerdict(xml, "r = c", "PROVED");
}

TEST(IecDrawn, AJumpWithoutALabelIsAnError) {
  const IecOutput output = askedOf(
      drawnProgram(ladderOf(drawn("contact", 2, 1, "", "a") + drawn("jump", 3, 2, "label=\"nowhere\""))), "not q");
  EXPECT_TRUE(output.has("there is no label nowhere")) << output.text;
  EXPECT_EQ(output.exit, 2);
}

TEST(IecDrawn, WorksheetsRunOneBehindTheOther) {
  const std::string first = ladderOf(drawn("contact", 2, 1, "", "a") + drawn("coil", 3, 2, "", "q"));
  const std::string second = ladderOf(drawn("contact", 2, 1, "", "q") + drawn("coil", 3, 2, "", "r"));
  expectVerdict(drawnProgram(first + second), "r = a", "PROVED");
  expectVerdict(drawnProgram(second + first), "r = a", "VIOLATED");
}

}  // namespace
}  // namespace rungproof
