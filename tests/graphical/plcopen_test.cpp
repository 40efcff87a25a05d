// PLCopen bodies as stack instructions: contacts, coils, branches, variables, instances, order, loops, comments.
// Expected texts follow from the elements: LD, A, O for contacts, = S R for coils, in the order top to bottom.
#include <gtest/gtest.h>

#include "engine/simulator.hpp"
#include "tests/graphical/plcopen_text.hpp"
#include "tests/reader/read.hpp"

namespace rungproof {
namespace {

const std::vector<std::string> fiveBits = {"a:BOOL@%IX0.0", "b:BOOL@%IX0.1", "c:BOOL@%IX0.2", "y:BOOL@%QX0.0",
                                           "z:BOOL@%QX0.1"};

std::string ladder(const std::string& elements) {
  const Program program = readText("t.xml", plcopen(fiveBits, "LD", railElement(1) + elements));
  return program.findings.empty() && !program.pous.empty() ? show(program.pous[0]) : findings(program);
}

TEST(Plcopen, ContactsInSeriesAndParallel) {
  EXPECT_EQ(ladder(contactElement(2, {"1"}, "a") + contactElement(3, {"2"}, "b", "negated=\"true\"") +
                   coilElement(4, {"3"}, "y")),
            "LD I0.0; AN I0.1; = Q0.0");
  EXPECT_EQ(ladder(contactElement(2, {"1"}, "a") + contactElement(3, {"1"}, "y") + contactElement(4, {"2", "3"}, "b") +
                   coilElement(5, {"4"}, "y")),
            "LD I0.0; O Q0.0; A I0.1; = Q0.0");
}

TEST(Plcopen, CoilsOfAllKinds) {
  const auto coil = [](const std::string& attributes) {
    return ladder(contactElement(2, {"1"}, "a") + coilElement(3, {"2"}, "y", attributes));
  };
  EXPECT_EQ(coil("storage=\"set\""), "LD I0.0; S Q0.0,1");
  EXPECT_EQ(coil("storage=\"reset\""), "LD I0.0; R Q0.0,1");
  EXPECT_EQ(coil("negated=\"true\""), "LD I0.0; NOT; = Q0.0");
}

/// Q0.0 at the ends of scans in which a (I0.0) and b (I0.1) have these values.
std::string outputOf(const std::string& elements, const std::vector<std::pair<int, int>>& inputs) {
  const Program program = readText("t.xml", plcopen(fiveBits, "LD", railElement(1) + elements));
  if (!program.findings.empty()) return findings(program);
  Simulator simulator(program);
  std::string result;
  for (const auto& [a, b] : inputs) {
    simulator.write(direct(Area::I, Width::Byte, 0), static_cast<std::uint64_t>(a + 2 * b));
    simulator.scan();
    result += simulator.read(direct(Area::Q, Width::Bit, 0, 0)) != 0 ? '1' : '0';
  }
  return result;
}

// IEC 61131-3: an edge compares with a memory that starts with 0. So a rising edge comes in the first scan with 1, a
// falling one in the first scan with 0, where EU and ED of an S7-200 see none (001:2763).
TEST(Plcopen, EdgesComeInTheFirstScan) {
  const auto contact = [](const std::string& edge) {
    return contactElement(2, {"1"}, "a", "edge=\"" + edge + "\"") + coilElement(3, {"2"}, "y");
  };
  const auto coil = [](const std::string& edge) {
    return contactElement(2, {"1"}, "a") + coilElement(3, {"2"}, "y", "edge=\"" + edge + "\"");
  };
  const std::vector<std::pair<int, int>> onFirst = {{1, 0}, {1, 0}, {0, 0}, {1, 0}},
                                         offFirst = {{0, 0}, {0, 0}, {1, 0}, {0, 0}};
  EXPECT_EQ(outputOf(contact("rising"), onFirst), "1001");
  EXPECT_EQ(outputOf(coil("rising"), onFirst), "1001");
  EXPECT_EQ(outputOf(contact("falling"), offFirst), "1001");
  EXPECT_EQ(outputOf(coil("falling"), offFirst), "1001");
  EXPECT_EQ(outputOf(contact("rising"), offFirst), "0010");
  EXPECT_EQ(outputOf(contact("falling"), onFirst), "0010");
}

TEST(Plcopen, EdgeContactIsTheEdgeOfItsVariable) {
  // Behind another contact the edge is still that of b alone, not of a and b: in scan 3 b falls while a is 0, and the
  // later 1 of a makes no edge.
  EXPECT_EQ(outputOf(contactElement(2, {"1"}, "a") + contactElement(3, {"2"}, "b", "edge=\"falling\"") +
                         coilElement(4, {"3"}, "y"),
                     {{1, 1}, {1, 0}, {0, 1}, {0, 0}, {1, 0}}),
            "01000");
}

// A program input without an address is written by whoever runs the program: any value in any scan. With inputs at an
// address nothing needs to be said.
// "written" is written by the program, "set" begins with a value: only the first global is left to others.
TEST(Plcopen, GlobalsThatNobodyWritesAreFree) {
  const std::vector<std::string> globals = {"free:BOOL", "written:BOOL", "set:INT=5", "at:BOOL@%QX0.0"};
  std::string text =
      plcopen({}, "LD", railElement(1) + contactElement(2, {"1"}, "free") + coilElement(3, {"2"}, "written"));
  text.insert(text.find("</project>"),
              "<instances><configurations><configuration name=\"c\"><resource name=\"r\"><globalVars>" +
                  declarations(globals) + "</globalVars></resource></configuration></configurations></instances>");
  const Program program = readText("t.xml", text);
  EXPECT_EQ(findings(program), "");
  ASSERT_EQ(program.directives.size(), 1U);
  EXPECT_EQ(program.directives[0].text, "external " + toString(program.symbolNamed("free")->address));
}

TEST(Plcopen, InputsWithoutAnAddressAreFree) {
  const auto statements = [](const std::string& variables) {
    const Program program = readText(
        "t.xml", projectText(pouText("Main", "program", variables, "LD",
                                     railElement(1) + contactElement(2, {"1"}, "a") + coilElement(3, {"2"}, "y"))));
    EXPECT_EQ(findings(program), "");
    std::string all;
    for (const Directive& directive : program.directives) all += directive.text + "; ";
    return all;
  };
  const std::string output = "<localVars>" + declarations({"y:BOOL@%QX0.0"}) + "</localVars>";
  const std::string free = statements("<inputVars>" + declarations({"a:BOOL", "n:INT"}) + "</inputVars>" + output);
  EXPECT_EQ(free, "external V0.0; external VW2; ");
  EXPECT_EQ(statements("<inOutVars>" + declarations({"a:BOOL"}) + "</inOutVars>" + output), "external V0.0; ");
  EXPECT_EQ(statements("<inputVars>" + declarations({"a:BOOL@%IX0.0"}) + "</inputVars>" + output), "");
}

TEST(Plcopen, OrderIsByPositionUnlessItIsStated) {
  const std::string low = contactElement(2, {"1"}, "a", "", 10, 200) + coilElement(3, {"2"}, "y", "", 50, 200);
  const std::string high = contactElement(4, {"1"}, "b", "", 10, 100) + coilElement(5, {"4"}, "z", "", 50, 100);
  EXPECT_EQ(ladder(low + high), "LD I0.1; = Q0.1 | LD I0.0; = Q0.0");
  const std::string first =
      contactElement(2, {"1"}, "a", "", 10, 200) + coilElement(3, {"2"}, "y", "executionOrderId=\"1\"", 50, 200);
  const std::string second =
      contactElement(4, {"1"}, "b", "", 10, 100) + coilElement(5, {"4"}, "z", "executionOrderId=\"2\"", 50, 100);
  EXPECT_EQ(ladder(first + second), "LD I0.0; = Q0.0 | LD I0.1; = Q0.1");
}

TEST(Plcopen, GatesWithNegatedPins) {
  const std::string body = inElement(1, "a") + inElement(2, "b", "negated=\"true\"") +
                           blockElement(3, "AND", "", {{"IN1", {"1"}}, {"IN2", {"2"}}}, {"OUT"}) +
                           outElement(4, {"3.OUT"}, "y");
  const Program program = readText("t.xml", plcopen(fiveBits, "FBD", body));
  EXPECT_EQ(findings(program), "");
  ASSERT_EQ(program.pous.size(), 1U);
  EXPECT_EQ(show(program.pous[0]), "LD I0.0; AN I0.1; = Q0.0");
  EXPECT_EQ(program.pous[0].networks[0].form, Form::Fbd);
}

TEST(Plcopen, VariablesGetPlacesAndInitialValues) {
  const Program program =
      readText("t.xml", plcopen({"a:BOOL@%IX0.0", "n:INT=7", "b:BOOL=TRUE", "m:INT=3@%MW4", "y:BOOL@%QX0.0"}, "LD",
                                railElement(1) + contactElement(2, {"1"}, "b") + coilElement(3, {"2"}, "y")));
  EXPECT_EQ(findings(program), "");
  const Symbol* n = program.symbolNamed("n");
  const Symbol* b = program.symbolNamed("b");
  ASSERT_TRUE(n != nullptr && b != nullptr);
  EXPECT_EQ(n->address.area, Area::V);
  EXPECT_EQ(b->address.area, Area::V);
  ASSERT_EQ(program.data.size(), 2U);
  EXPECT_EQ(program.data[0].bytes, (std::vector<std::uint8_t>{0, 7}));
  EXPECT_EQ(program.data[1].bytes, (std::vector<std::uint8_t>{1}));
  // A located variable is set in the first scan.
  EXPECT_EQ(show(program.pous[0].networks[0]), "LD SM0.1; MOVW 3,MW4");
}

TEST(Plcopen, InstancesOfABlockHaveMemoryOfTheirOwn) {
  const std::string fb = pouText("Latch", "functionBlock",
                                 "<inputVars>" + declarations({"set:BOOL"}) + "</inputVars><outputVars>" +
                                     declarations({"q:BOOL"}) + "</outputVars>",
                                 "LD",
                                 railElement(1) + contactElement(2, {"1"}, "set") + contactElement(3, {"1"}, "q") +
                                     coilElement(4, {"2", "3"}, "q"));
  const std::string body = railElement(1) + contactElement(2, {"1"}, "a", "", 10, 10) +
                           blockElement(3, "Latch", "L1", {{"set", {"2"}}}, {"q"}, 20, 10) +
                           coilElement(4, {"3.q"}, "y", "", 30, 10) + contactElement(5, {"1"}, "b", "", 10, 90) +
                           blockElement(6, "Latch", "L2", {{"set", {"5"}}}, {"q"}, 20, 90) +
                           coilElement(7, {"6.q"}, "z", "", 30, 90);
  std::vector<std::string> variables = fiveBits;
  variables.insert(variables.end(), {"L1:Latch", "L2:Latch"});
  const Program program = readText(
      "t.xml", projectText(fb + pouText("Main", "program", "<localVars>" + declarations(variables) + "</localVars>",
                                        "LD", body)));
  EXPECT_EQ(findings(program), "");
  ASSERT_EQ(program.pous.size(), 3U);
  EXPECT_EQ(program.pous[0].kind, PouKind::Main);
  EXPECT_EQ(program.pous[1].name, "L1");
  EXPECT_NE(show(program.pous[1]), show(program.pous[2]));
  const Symbol* one = program.symbolNamed("L1.q");
  const Symbol* two = program.symbolNamed("L2.q");
  ASSERT_TRUE(one != nullptr && two != nullptr);
  EXPECT_NE(toString(one->address), toString(two->address));
}

TEST(Plcopen, BlocksAndGlobalListsInsideVendorData) {
  // As CODESYS writes it: no positions, blocks and lists of global variables inside addData, outputs with a name.
  const std::string body =
      "<leftPowerRail localId=\"0\"><position x=\"0\" y=\"0\"/><connectionPointOut "
      "formalParameter=\"none\"/></leftPowerRail>" +
      contactElement(1, {"0.none"}, "GVL.start", "negated=\"false\" storage=\"none\" edge=\"none\"") +
      coilElement(2, {"1.none"}, "run");
  const std::string text =
      "<?xml version=\"1.0\"?>\n<project "
      "xmlns=\"http://www.plcopen.org/xml/tc6_0200\"><fileHeader "
      "productName=\"S7-200\"/><types><dataTypes/><pous/></types><addData><data "
      "name=\"http://www.3s-software.com/plcopenxml/application\" handleUnknown=\"implementation\">"
      "<resource name=\"Application\"><task name=\"MainTask\"><pouInstance name=\"PLC_PRG\" "
      "typeName=\"\"/></task><addData><data><globalVars name=\"GVL\">" +
      declarations({"start:BOOL@%IX0.0"}) + "</globalVars></data><data>" +
      pouText("PLC_PRG", "program", "<localVars>" + declarations({"run:BOOL@%QX0.0"}) + "</localVars>", "LD", body) +
      "</data></addData></resource></data></addData></project>\n";
  const Program program = readText("t.xml", text);
  EXPECT_EQ(findings(program), "");
  ASSERT_EQ(program.pous.size(), 1U);
  EXPECT_EQ(show(program.pous[0]), "LD I0.0; = Q0.0");
}

TEST(Plcopen, LoopThroughABlockReadsThePreviousScan) {
  // The inverted output of a timer feeds its own input: a pulse every second, the usual blinker.
  const std::string body = blockElement(1, "NOT", "", {{"IN", {"2.Q"}}}, {"OUT"}, 10, 10) +
                           inElement(3, "T#1s", "", 10, 40) +
                           blockElement(2, "TON", "T1", {{"IN", {"1.OUT"}}, {"PT", {"3"}}}, {"Q"}, 50, 10) +
                           outElement(4, {"2.Q"}, "y", "", 90, 10);
  std::vector<std::string> variables = fiveBits;
  variables.push_back("T1:TON");
  const Program program = readText("t.xml", plcopen(variables, "FBD", body));
  EXPECT_EQ(findings(program), "");
  ASSERT_EQ(program.pous.size(), 1U);
  EXPECT_EQ(show(program.pous[0]), "LDN T37; TON T37,10 | LD T37; = Q0.0");
}

TEST(Plcopen, LoopOfFunctionsIsAnError) {
  const std::string body = inElement(1, "a") +
                           blockElement(2, "OR", "", {{"IN1", {"1"}}, {"IN2", {"3.OUT"}}}, {"OUT"}) +
                           blockElement(3, "NOT", "", {{"IN", {"2.OUT"}}}, {"OUT"}) + outElement(4, {"2.OUT"}, "y");
  const Program program = readText("t.xml", plcopen(fiveBits, "FBD", body));
  ASSERT_FALSE(program.findings.empty());
  EXPECT_EQ(program.findings[0].rule, "GRF001");
  EXPECT_TRUE(hasReadErrors(program));
  EXPECT_FALSE(program.pous[0].networks[0].complete);
}

TEST(Plcopen, ConnectorCarriesTheLineAndCutsLoops) {
  const std::string straight = inElement(1, "a") + "<connector localId=\"2\" name=\"X\"><position x=\"50\" y=\"0\"/>" +
                               pointIn({"1"}) +
                               "</connector>\n<continuation localId=\"3\" name=\"X\"><position x=\"0\" "
                               "y=\"90\"/><connectionPointOut/></continuation>\n" +
                               outElement(4, {"3"}, "y", "", 50, 90);
  EXPECT_EQ(show(readText("t.xml", plcopen(fiveBits, "FBD", straight)).pous[0]), "LD I0.0; = Q0.0");
  const std::string loop =
      inElement(1, "a") +
      "<continuation localId=\"3\" name=\"X\"><position x=\"0\" y=\"20\"/><connectionPointOut/></continuation>\n" +
      blockElement(2, "OR", "", {{"IN1", {"1"}}, {"IN2", {"3"}}}, {"OUT"}, 20, 0) +
      "<connector localId=\"5\" name=\"X\"><position x=\"50\" y=\"50\"/>" + pointIn({"2.OUT"}) + "</connector>\n" +
      outElement(4, {"2.OUT"}, "y", "", 50, 0);
  const Program program = readText("t.xml", plcopen(fiveBits, "FBD", loop));
  EXPECT_EQ(findings(program), "");
  EXPECT_EQ(show(program.pous[0]), "LD I0.0; O V0.0; = Q0.0; = V0.0");
}

TEST(Plcopen, JumpsLabelsReturnsAndComments) {
  const std::string body = railElement(1) + contactElement(2, {"1"}, "a", "", 10, 10) +
                           "<jump localId=\"3\" label=\"End\"><position x=\"50\" y=\"10\"/>" + pointIn({"2"}) +
                           "</jump>\n" + contactElement(4, {"1"}, "b", "", 10, 50) +
                           coilElement(5, {"4"}, "y", "", 50, 50) +
                           "<label localId=\"6\" label=\"End\"><position x=\"10\" y=\"90\"/></label>\n" +
                           contactElement(7, {"1"}, "c", "", 10, 120) +
                           "<return localId=\"8\"><position x=\"50\" y=\"120\"/>" + pointIn({"7"}) + "</return>\n" +
                           "<comment localId=\"9\"><position x=\"10\" y=\"40\"/><content><xhtml:p>second "
                           "circuit</xhtml:p></content></comment>\n";
  const Program program = readText("t.xml", plcopen(fiveBits, "LD", body));
  EXPECT_EQ(findings(program), "");
  EXPECT_EQ(show(program.pous[0]), "LD I0.0; JMP 0 | LD I0.1; = Q0.0 | LBL 0 | LD I0.2; END");
  ASSERT_EQ(program.pous[0].networks[1].comments.size(), 1U);
  EXPECT_EQ(program.sources->text(program.pous[0].networks[1].comments[0].span), "second circuit");
}

TEST(Plcopen, FaultsNameElementAndPlace) {
  const Program program =
      readText("t.xml", plcopen(fiveBits, "LD",
                                railElement(1) + contactElement(2, {"1"}, "nobody") +
                                    coilElement(3, {"2"}, "y", "", 0, 0) + coilElement(4, {"77"}, "z", "", 0, 90)));
  ASSERT_EQ(program.findings.size(), 2U);
  EXPECT_EQ(program.findings[0].rule, "GRF001");
  EXPECT_EQ(program.findings[0].message, "coil z (element 4): a line comes from element 77, which does not exist");
  EXPECT_EQ(program.findings[0].network, 2);
  EXPECT_EQ(program.sources->text(program.findings[0].span), "<coil localId=\"4\" >");
  EXPECT_EQ(program.findings[1].rule, "GRF002");
  EXPECT_EQ(program.findings[1].message, "contact nobody (element 2): nobody is not declared");
  EXPECT_EQ(program.findings[1].network, 1);
}

TEST(Plcopen, FaultsOfAllKindsAreReported) {
  const auto rule = [](const std::string& body) {
    std::vector<std::string> variables = fiveBits;
    variables.insert(variables.end(), {"n:INT", "t:TON", "r:REAL"});
    ReadOptions asS7200;
    asS7200.dialect = "s7-200";
    const Program program = readText("t.xml", plcopen(variables, "FBD", body), asS7200);
    return program.findings.empty() ? "" : std::string(program.findings[0].rule);
  };
  EXPECT_EQ(rule(inElement(1, "a") + inElement(1, "b") + outElement(2, {"1"}, "y")), "GRF001");  // one id twice
  EXPECT_EQ(rule(inElement(1, "a") + blockElement(2, "FROBNICATE", "", {{"IN", {"1"}}}, {"OUT"}) +
                 outElement(3, {"2.OUT"}, "y")),
            "GRF001");  // unknown block
  EXPECT_EQ(rule(inElement(1, "a") + blockElement(2, "AND", "", {{"IN1", {"1"}}, {"IN2", {}}}, {"OUT"}) +
                 outElement(3, {"2.OUT"}, "y")),
            "GRF002");
  EXPECT_EQ(rule(inElement(1, "a") + blockElement(2, "TON", "t", {{"IN", {"1"}}, {"PT", {}}}, {"Q"}) +
                 outElement(3, {"2.Q"}, "y")),
            "GRF002");
  EXPECT_EQ(rule(inElement(1, "n") + outElement(2, {"1"}, "y")), "GRF002");  // INT to BOOL
  EXPECT_EQ(rule(inElement(1, "r") + outElement(2, {"1"}, "n")), "GRF002");  // REAL to INT
  EXPECT_EQ(rule(inElement(1, "n", "negated=\"true\"") + outElement(2, {"1"}, "n")), "GRF003");
  EXPECT_EQ(rule(inElement(1, "a") + blockElement(2, "TON", "nobody", {{"IN", {"1"}}, {"PT", {"1"}}}, {"Q"}) +
                 outElement(3, {"2.Q"}, "y")),
            "GRF002");
}

}  // namespace
}  // namespace rungproof
