// Attributes, values and elements that a format does not have: a finding with its place, and the network is not read.
// A word that the reader passed over in silence would change what the drawing means.
#include <gtest/gtest.h>

#include "frontend/cli/cli.hpp"
#include "tests/graphical/plcopen_text.hpp"
#include "tests/reader/read.hpp"
#include "tests/temporary_folder.hpp"

namespace rungproof {
namespace {

const std::vector<std::string> variables = {"a:BOOL@%IX0.0", "b:BOOL@%IX0.1", "y:BOOL@%QX0.0"};

/// A ladder of one contact and one coil with these attributes.
std::string rung(const std::string& contact, const std::string& coil) {
  return railElement(1) + contactElement(2, {"1"}, "a", contact) + coilElement(3, {"2"}, "y", coil);
}

/// In networks that were read to their end.
std::size_t readInstructions(const Program& program) {
  std::size_t count = 0;
  for (const Pou& pou : program.pous) {
    for (const Network& network : pou.networks) count += network.complete ? network.instructions.size() : 0;
  }
  return count;
}

void expectRefused(const std::string& text, const std::string& name) {
  const Program program = readText("t.xml", text);
  EXPECT_TRUE(hasReadErrors(program)) << name;
  EXPECT_EQ(readInstructions(program), 0U) << name;
  EXPECT_NE(findings(program), "") << name;
}

void expectRead(const std::string& text, const std::string& name) {
  const Program program = readText("t.xml", text);
  EXPECT_EQ(findings(program), "") << name;
  EXPECT_GT(program.instructionCount(), 0U) << name;
}

TEST(StrictPlcopen, ValuesOfAttributes) {
  expectRead(plcopen(variables, "LD", rung("", "")), "plain");
  expectRead(plcopen(variables, "LD", rung("negated=\"0\" edge=\"none\" storage=\"none\"", "storage=\"none\"")),
             "none");
  for (const char* attribute :
       {"edge=\"sideways\"", "edge=\"\"", "negated=\"maybe\"", "negated=\"yes\"", "storage=\"sometimes\"",
        "storage=\"set\"", "executionOrderId=\"first\"", "nagated=\"true\"", "Edge=\"rising\""})
    expectRefused(plcopen(variables, "LD", rung(attribute, "")), attribute);
  for (const char* attribute :
       {"storage=\"sometimes\"", "storage=\"Set\"", "edge=\"up\"", "negated=\"tomorrow\"", "latch=\"true\""})
    expectRefused(plcopen(variables, "LD", rung("", attribute)), attribute);
}

TEST(StrictPlcopen, PinsAndVariables) {
  const std::string gate = blockElement(3, "AND", "", {{"IN1", {"1"}}, {"IN2", {"2"}}}, {"OUT"});
  const std::string body = inElement(1, "a") + inElement(2, "b") + gate + outElement(4, {"3.OUT"}, "y");
  expectRead(plcopen(variables, "FBD", body), "gate");
  const auto with = [&](const std::string& from, const std::string& to) {
    std::string changed = body;
    changed.replace(changed.find(from), from.size(), to);
    return plcopen(variables, "FBD", changed);
  };
  expectRefused(with("formalParameter=\"IN1\"", "formalParameter=\"IN1\" negated=\"banana\""), "pin negated");
  expectRefused(with("formalParameter=\"IN1\"", "formalParameter=\"IN1\" edge=\"sideways\""), "pin edge");
  expectRefused(with("formalParameter=\"OUT\"", "formalParameter=\"OUT\" storage=\"set\""), "pin storage");
  expectRefused(with("<expression>a</expression>", "<expression>a</expression><inverter/>"), "element in a variable");
  expectRefused(with("<connection ", "<connection reversed=\"true\" "), "attribute of a connection");
  expectRefused(with("<position x=\"0\"", "<position x=\"left\""), "position");
}

TEST(StrictPlcopen, Elements) {
  expectRefused(plcopen(variables, "LD", rung("", "") + "<inverter localId=\"7\"/>"), "element");
  expectRefused(plcopen(variables, "LD", rung("", "") + "<actionBlock localId=\"7\"/>"), "action block");
  expectRefused(plcopen(variables, "LD",
                        rung("", "") + "<vendorElement localId=\"7\"><inputVariables><variable/></inputVariables>"
                                       "</vendorElement>"),
                "vendor element with pins");
}

// IEC 61131-3 has worksheets, several bodies of a POU one behind the other; a block of an S7-200 has one body.
TEST(StrictPlcopen, OneBodyInOneLanguage) {
  const std::string one = plcopen(variables, "LD", rung("", ""));
  std::string twice = one;
  twice.insert(twice.find("</body>") + 7, "<body><LD>" + rung("", "storage=\"set\"") + "</LD></body>");
  ReadOptions asS7200;
  asS7200.dialect = "s7-200";
  EXPECT_TRUE(hasReadErrors(readText("t.xml", twice, asS7200)));
  ReadOptions asIec;
  asIec.dialect = "iec";
  const Program worksheets = readText("t.xml", twice, asIec);
  EXPECT_FALSE(hasReadErrors(worksheets));
  const auto main = std::ranges::find(worksheets.pous, "Main", &Pou::name);
  ASSERT_NE(main, worksheets.pous.end());
  EXPECT_EQ(main->networks.size(), 2U) << "none is lost";
  std::string languages = one;
  languages.insert(languages.find("</body>"), "<FBD>" + inElement(8, "b") + outElement(9, {"8"}, "y") + "</FBD>");
  EXPECT_TRUE(hasReadErrors(readText("t.xml", languages)));
}

TEST(StrictPlcopen, DeclarationsAndStartValues) {
  for (const auto& [from, to] :
       {std::pair{"<localVars>", "<localVars constant=\"perhaps\">"}, std::pair{"<localVars>", "<configVars>"},
        std::pair{"</type>", "</type><initialValue><arrayValue/></initialValue>"}}) {
    std::string text = plcopen(variables, "LD", rung("", ""));
    text.replace(text.find(from), std::string(from).size(), to);
    if (std::string(to) == "<configVars>") text.replace(text.find("</localVars>"), 12, "</configVars>");
    EXPECT_TRUE(hasReadErrors(readText("t.xml", text))) << to;
  }
}

// ---- SimaticML ---------------------------------------------------------------------------------------

const std::string tagTable =
    "<SW.Tags.PlcTagTable ID=\"0\"><AttributeList><Name>T</Name></AttributeList><ObjectList>"
    "<SW.Tags.PlcTag ID=\"1\"><AttributeList><DataTypeName>Bool</DataTypeName><LogicalAddress>%I0.0</LogicalAddress>"
    "<Name>a</Name></AttributeList></SW.Tags.PlcTag>"
    "<SW.Tags.PlcTag ID=\"2\"><AttributeList><DataTypeName>Bool</DataTypeName><LogicalAddress>%Q0.0</LogicalAddress>"
    "<Name>y</Name></AttributeList></SW.Tags.PlcTag></ObjectList></SW.Tags.PlcTagTable>";

const std::string net =
    "<Parts><Access Scope=\"GlobalVariable\" UId=\"1\"><Symbol><Component Name=\"a\"/></Symbol></Access>"
    "<Access Scope=\"GlobalVariable\" UId=\"2\"><Symbol><Component Name=\"y\"/></Symbol></Access>"
    "<Part Name=\"Contact\" UId=\"11\"><Negated Name=\"operand\"/></Part><Part Name=\"Coil\" UId=\"12\"/></Parts>"
    "<Wires><Wire UId=\"21\"><Powerrail/><NameCon UId=\"11\" Name=\"in\"/></Wire>"
    "<Wire UId=\"22\"><IdentCon UId=\"1\"/><NameCon UId=\"11\" Name=\"operand\"/></Wire>"
    "<Wire UId=\"23\"><NameCon UId=\"11\" Name=\"out\"/><NameCon UId=\"12\" Name=\"in\"/></Wire>"
    "<Wire UId=\"24\"><IdentCon UId=\"2\"/><NameCon UId=\"12\" Name=\"operand\"/></Wire></Wires>";

std::string blockText(const std::string& kind, const std::string& name, const std::string& content,
                      const std::string& interface = "") {
  return "<" + kind + " ID=\"9\"><AttributeList><Name>" + name + "</Name><Interface><Sections>" + interface +
         "</Sections></Interface></AttributeList><ObjectList><SW.Blocks.CompileUnit ID=\"8\"><AttributeList>"
         "<NetworkSource><FlgNet>" +
         content + "</FlgNet></NetworkSource></AttributeList></SW.Blocks.CompileUnit></ObjectList></" + kind + ">";
}
std::string simatic(const std::string& content) {
  return "<Document>" + blockText("SW.Blocks.OB", "Main", content) + tagTable + "</Document>";
}

TEST(StrictSimatic, PartsAndWires) {
  expectRead(simatic(net), "plain");
  const auto with = [&](const std::string& from, const std::string& to) {
    std::string changed = net;
    changed.replace(changed.find(from), from.size(), to);
    return simatic(changed);
  };
  expectRefused(with("<Negated Name=\"operand\"/>", "<Negated Name=\"banana\"/>"), "negation of no pin");
  expectRefused(with("<Negated Name=\"operand\"/>", "<Negated/>"), "negation without a pin");
  expectRefused(with("<Negated Name=\"operand\"/>", "<Inverted Name=\"operand\"/>"), "element in a part");
  expectRefused(with("<Component Name=\"a\"/>", "<Component Name=\"a\" SliceAccessModifier=\"x3\"/>"), "slice");
  expectRefused(with("<Component Name=\"a\"/>", "<Component Name=\"a\" AccessModifier=\"Array\"/>"), "array");
  expectRefused(with("Scope=\"GlobalVariable\"", "Scope=\"Somewhere\""), "scope");
  expectRefused(with("<Powerrail/>", "<Battery/>"), "source of a wire");
  expectRefused(with("<Wires>", "<Bridges/><Wires>"), "element in a network");
  expectRefused(with("UId=\"12\"", "UId=\"12\" Storage=\"set\""), "attribute of a part");
}

TEST(StrictSimatic, AddressesAreReadToTheLetter) {
  const auto at = [&](const std::string& address) {
    std::string changed = net;
    const std::string from =
        "<Access Scope=\"GlobalVariable\" UId=\"1\"><Symbol><Component Name=\"a\"/></Symbol></Access>";
    changed.replace(changed.find(from), from.size(),
                    "<Access Scope=\"Address\" UId=\"1\"><Address " + address + "/></Access>");
    return simatic(changed);
  };
  expectRead(at("Area=\"Input\" Type=\"Bool\" BitOffset=\"3\""), "input");
  expectRefused(at("Area=\"Input\" Type=\"Bool\" BitOffset=\"3x\""), "offset");
  expectRefused(at("Area=\"Input\" Type=\"Boolean\" BitOffset=\"3\""), "type");
  expectRefused(at("Area=\"Cupboard\" Type=\"Bool\" BitOffset=\"3\""), "area");
}

/// Blocks that nobody calls are read and checked as well; a type of another file is named.
TEST(StrictSimatic, ABlockBesideAnEmptyMainIsNotLost) {
  const test::TemporaryFolder folder;
  const std::string empty =
      "<Document><SW.Blocks.OB ID=\"1\"><AttributeList><Name>Main</Name></AttributeList><ObjectList/></SW.Blocks.OB>"
      "</Document>";
  const std::string function = "<Document>" + blockText("SW.Blocks.FC", "Valve", net) + "</Document>";
  const Program program = readProgram({folder.file("Main.xml", empty), folder.file("Valve.xml", function),
                                       folder.file("tags.xml", "<Document>" + tagTable + "</Document>")});
  EXPECT_FALSE(hasReadErrors(program)) << findings(program);
  EXPECT_EQ(program.instructionCount(), 2U);
  const Program without = readProgram({folder.file("Main.xml", empty), folder.file("Valve.xml", function)});
  EXPECT_TRUE(hasReadErrors(without));
  EXPECT_NE(findings(without).find("a"), std::string::npos);
}

TEST(StrictSimatic, TypesThatNoFileHasAreNamed) {
  const auto interfaceOf = [](const std::string& type) {
    return "<Section Name=\"Temp\"><Member Name=\"x\" Datatype=\"" + type + "\"/></Section>";
  };
  const auto textOf = [&](const std::string& type, const std::string& more) {
    return "<Document>" + blockText("SW.Blocks.OB", "Main", net, interfaceOf(type)) + tagTable + more + "</Document>";
  };
  expectRead(textOf("Array[0..3] of Bool", ""), "array");
  const std::string motor =
      "<SW.Types.PlcStruct ID=\"5\"><AttributeList><Name>Motor_Type</Name><Interface><Sections><Section Name=\"None\">"
      "<Member Name=\"on\" Datatype=\"Bool\"/></Section></Sections></Interface></AttributeList></SW.Types.PlcStruct>";
  expectRead(textOf("&quot;Motor_Type&quot;", motor), "type");
  const Program without = readText("t.xml", textOf("&quot;Motor_Type&quot;", ""));
  EXPECT_TRUE(hasReadErrors(without));
  ASSERT_FALSE(without.findings.empty());
  EXPECT_NE(without.findings.front().message.find("Motor_Type"), std::string::npos) << without.findings.front().message;
}

/// A damaged drawing ends every command alike: 2, with its finding.
TEST(StrictSimatic, EveryCommandEndsWithTwo) {
  const test::TemporaryFolder folder;
  std::string bad = net;
  bad.replace(bad.find("operand"), 7, "banana");
  for (const std::string& file : {folder.file("bad.xml", simatic(bad)),
                                  folder.file("open.xml", plcopen(variables, "LD",
                                                                  railElement(1) + contactElement(2, {"1"}, "a") +
                                                                      coilElement(3, {"7"}, "y")))}) {
    for (const std::vector<std::string>& command : {std::vector<std::string>{"lint"},
                                                    {"lint", "--prove"},
                                                    {"prove", "--builtin"},
                                                    {"sim"},
                                                    {"export", "--format", "btor2"},
                                                    {"show"},
                                                    {"xref"}}) {
      std::vector<std::string> arguments = command;
      arguments.insert(arguments.end(), {file, "--isolated"});
      std::istringstream in;
      std::ostringstream out, err;
      EXPECT_EQ(static_cast<int>(runProgram(arguments, {in, out, err})), 2) << command[0] << " " << file;
      EXPECT_NE((out.str() + err.str()).find("error["), std::string::npos) << command[0] << " " << file;
    }
  }
}

}  // namespace
}  // namespace rungproof
