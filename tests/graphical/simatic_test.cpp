// SimaticML: networks, tags, data blocks, calls, several files; and bodies that are not covered.
#include <gtest/gtest.h>

#include "frontend/cli/cli.hpp"
#include "tests/graphical/plcopen_text.hpp"
#include "tests/reader/read.hpp"
#include "tests/temporary_folder.hpp"

namespace rungproof {
namespace {

std::string tag(const std::string& name, const std::string& type, const std::string& address) {
  return fmt::format(
      "<SW.Tags.PlcTag "
      "ID=\"t{}\"><AttributeList><DataTypeName>{}</DataTypeName><LogicalAddress>{}</LogicalAddress><Name>{}</Name></"
      "AttributeList></SW.Tags.PlcTag>",
      name, type, address, name);
}
const std::string tags = "<SW.Tags.PlcTagTable ID=\"0\"><AttributeList><Name>T</Name></AttributeList><ObjectList>" +
                         tag("a", "Bool", "%I0.0") + tag("b", "Bool", "%I0.1") + tag("y", "Bool", "%Q0.0") +
                         tag("n", "Int", "%MW2") + "</ObjectList></SW.Tags.PlcTagTable>";

std::string access(int id, const std::string& name) {
  return fmt::format("<Access Scope=\"GlobalVariable\" UId=\"{}\"><Symbol><Component Name=\"{}\"/></Symbol></Access>",
                     id, name);
}
std::string constantAccess(int id, const std::string& value) {
  return fmt::format(
      "<Access Scope=\"LiteralConstant\" UId=\"{}\"><Constant><ConstantValue>{}</ConstantValue></Constant></Access>",
      id, value);
}
std::string part(int id, const std::string& name, const std::string& inner = "") {
  return fmt::format("<Part Name=\"{}\" UId=\"{}\">{}</Part>", name, id, inner);
}
std::string con(int id, const std::string& pin) { return fmt::format("<NameCon UId=\"{}\" Name=\"{}\"/>", id, pin); }
std::string ident(int id) { return fmt::format("<IdentCon UId=\"{}\"/>", id); }
std::string wire(const std::string& ends) { return "<Wire UId=\"99\">" + ends + "</Wire>"; }

std::string unit(const std::string& parts, const std::string& wires) {
  return "<SW.Blocks.CompileUnit ID=\"3\"><AttributeList><NetworkSource><FlgNet><Parts>" + parts + "</Parts><Wires>" +
         wires + "</Wires></FlgNet></NetworkSource></AttributeList></SW.Blocks.CompileUnit>";
}
std::string document(const std::string& units, const std::string& more = "", const std::string& language = "LAD") {
  return "<?xml version=\"1.0\"?>\n<Document><SW.Blocks.OB "
         "ID=\"1\"><AttributeList><Name>Main</Name><ProgrammingLanguage>" +
         language + "</ProgrammingLanguage></AttributeList><ObjectList>" + units + "</ObjectList></SW.Blocks.OB>" +
         more + "</Document>\n";
}
std::string code(const std::string& parts, const std::string& wires) {
  const Program program = readText("t.xml", document(unit(parts, wires), tags));
  return program.findings.empty() && !program.pous.empty() ? show(program.pous[0]) : findings(program);
}

TEST(Simatic, ContactsCoilsAndParallelBranches) {
  const std::string parts = access(1, "a") + access(2, "b") + access(3, "y") + part(11, "Contact") +
                            part(12, "Contact", "<Negated Name=\"operand\"/>") + part(13, "O") + part(14, "Coil");
  const std::string wires = wire("<Powerrail/>" + con(11, "in") + con(12, "in")) + wire(ident(1) + con(11, "operand")) +
                            wire(ident(2) + con(12, "operand")) + wire(con(11, "out") + con(13, "in1")) +
                            wire(con(12, "out") + con(13, "in2")) + wire(con(13, "out") + con(14, "in")) +
                            wire(ident(3) + con(14, "operand"));
  EXPECT_EQ(code(parts, wires), "LD I0.0; ON I0.1; = Q0.0");
}

TEST(Simatic, ComparisonMoveAndBistable) {
  const std::string compare =
      access(1, "n") + constantAccess(2, "5") + access(3, "y") + part(11, "Ge") + part(12, "SCoil");
  EXPECT_EQ(code(compare, wire("<Powerrail/>" + con(11, "pre")) + wire(ident(1) + con(11, "in1")) +
                              wire(ident(2) + con(11, "in2")) + wire(con(11, "out") + con(12, "in")) +
                              wire(ident(3) + con(12, "operand"))),
            "LDW>= MW2,5; S Q0.0,1");
  const std::string move =
      constantAccess(2, "7") + access(1, "n") + access(3, "a") + part(10, "Contact") + part(11, "Move");
  EXPECT_EQ(code(move, wire("<Powerrail/>" + con(10, "in")) + wire(ident(3) + con(10, "operand")) +
                           wire(con(10, "out") + con(11, "en")) + wire(ident(2) + con(11, "in")) +
                           wire(con(11, "out1") + ident(1))),
            "LD I0.0; MOVW 7,MW2");
  // Sr of TIA: reset dominant.
  const std::string bistable = access(1, "a") + access(2, "b") + access(3, "y") + part(11, "Sr");
  EXPECT_EQ(code(bistable,
                 wire(ident(1) + con(11, "s")) + wire(ident(2) + con(11, "r1")) + wire(ident(3) + con(11, "operand"))),
            "LD I0.0; O Q0.0; AN I0.1; = Q0.0");
}

TEST(Simatic, UnknownPartIsAFindingAndDamagesItsNetworkOnly) {
  const std::string good = unit(access(1, "a") + access(3, "y") + part(11, "Contact") + part(14, "Coil"),
                                wire("<Powerrail/>" + con(11, "in")) + wire(ident(1) + con(11, "operand")) +
                                    wire(con(11, "out") + con(14, "in")) + wire(ident(3) + con(14, "operand")));
  const std::string bad = unit(part(11, "RADAR"), wire("<Powerrail/>" + con(11, "en")));
  const Program program = readText("t.xml", document(bad + good, tags));
  ASSERT_EQ(program.findings.size(), 1U);
  EXPECT_EQ(program.findings[0].rule, "SYN036");
  EXPECT_EQ(show(program.pous[0]), "! | LD I0.0; = Q0.0");
}

TEST(Simatic, SeveralFilesMakeOneProject) {
  const test::TemporaryFolder folder;
  const std::string net = unit(access(1, "a") + access(3, "y") + part(11, "Contact") + part(14, "Coil"),
                               wire("<Powerrail/>" + con(11, "in")) + wire(ident(1) + con(11, "operand")) +
                                   wire(con(11, "out") + con(14, "in")) + wire(ident(3) + con(14, "operand")));
  const Program program = readProgram(
      {folder.file("main.xml", document(net)), folder.file("tags.xml", "<Document>" + tags + "</Document>")});
  EXPECT_EQ(findings(program), "");
  ASSERT_EQ(program.pous.size(), 1U);
  EXPECT_EQ(show(program.pous[0]), "LD I0.0; = Q0.0");
}

struct ProofRunText {
  int exit = 0;
  std::string out;
};
ProofRunText prove(const std::string& text) {
  const test::TemporaryFolder folder;
  std::istringstream in;
  std::ostringstream out, err;
  ProofRunText run;
  run.exit = static_cast<int>(runProgram(
      {"prove", folder.file("program.xml", text), "--isolated", "--format", "concise", "--dialect", "s7-200"},
      {in, out, err}));
  run.out = out.str() + err.str();
  return run;
}

TEST(NotCovered, WhatDependsOnStructuredTextIsNotDecided) {
  const std::string fb = pouText("F", "functionBlock",
                                 "<inputVars>" + declarations({"x:BOOL"}) + "</inputVars><outputVars>" +
                                     declarations({"q:BOOL"}) + "</outputVars>",
                                 "ST", "<xhtml:p>q := x;</xhtml:p>");
  const std::string body = inElement(1, "a") + blockElement(2, "F", "f", {{"x", {"1"}}}, {"q"}) +
                           outElement(3, {"2.q"}, "y", "", 0, 0) + inElement(4, "a", "", 0, 90) +
                           outElement(5, {"4"}, "z", "", 0, 90) +
                           "<comment localId=\"9\"><position x=\"0\" y=\"0\"/><content><xhtml:p>//@ prove one: y "
                           "implies a\n//@ prove two: z = a\n//@ reach three: y</xhtml:p></content></comment>\n";
  const ProofRunText run = prove(projectText(
      fb +
      pouText("Main", "program",
              "<localVars>" + declarations({"a:BOOL@%IX0.0", "y:BOOL@%QX0.0", "z:BOOL@%QX0.1", "f:F"}) + "</localVars>",
              "FBD", body)));
  EXPECT_NE(run.out.find("NOT COVERED one"), std::string::npos) << run.out;
  EXPECT_NE(run.out.find("PROVED two"), std::string::npos) << run.out;
  EXPECT_NE(run.out.find("NOT COVERED three"), std::string::npos) << run.out;
  EXPECT_EQ(run.exit, 3);
}

TEST(NotCovered, TwoHandsOnOneVariableLeaveNothingCertain) {
  const std::string text =
      pouText("F", "functionBlock", "<externalVars>" + declarations({"g:BOOL"}) + "</externalVars>", "ST",
              "<xhtml:p>g := FALSE;</xhtml:p>");
  const std::string body = inElement(1, "a") + outElement(2, {"1"}, "y") + blockElement(3, "F", "f", {}, {}) +
                           "<comment localId=\"9\"><position x=\"0\" y=\"0\"/><content><xhtml:p>//@ prove one: y = "
                           "a</xhtml:p></content></comment>\n";
  // The text writes y itself, by its address.
  std::string both = text;
  both.replace(both.find("g := FALSE"), 10, "%QX0.0 := FALSE");
  const ProofRunText run = prove(projectText(
      both + pouText("Main", "program",
                     "<localVars>" + declarations({"a:BOOL@%IX0.0", "y:BOOL@%QX0.0", "f:F"}) + "</localVars>", "FBD",
                     body)));
  EXPECT_NE(run.out.find("NOT COVERED one"), std::string::npos) << run.out;
}

}  // namespace
}  // namespace rungproof
