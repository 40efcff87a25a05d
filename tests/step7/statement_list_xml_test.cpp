// Statement lists in SimaticML: each token and operand is the statement that a source has for it, what is not known
// is named and nothing rests on it. The forms are those of spec and public exports of TIA Openness.
#include <gtest/gtest.h>

#include "tests/step7/flgnet_text.hpp"
#include "tests/step7/read7.hpp"
#include "tests/step7/run7.hpp"
#include "tests/temporary_folder.hpp"

namespace rungproof {
namespace {

using test7::drawnBlock, test7::drawnDocument, test7::member, test7::section, test7::unit;

std::string token(const std::string& text, const std::string& access = "", const std::string& before = "") {
  return "<StlStatement UId=\"21\">" + before + "<StlToken Text=\"" + text + "\"/>" + access + "</StlStatement>";
}
std::string scoped(const std::string& scope, const std::string& inner) {
  return "<Access Scope=\"" + scope + "\">" + inner + "</Access>";
}
std::string address(const std::string& area, const std::string& type, int bit, const std::string& more = "") {
  return scoped("Address", "<Address Area=\"" + area + "\" Type=\"" + type + "\" BitOffset=\"" + std::to_string(bit) +
                               "\"" + more + "/>");
}
std::string indirect(const std::string& attributes, const std::string& inner = "") {
  return scoped("Address", "<Indirect " + attributes + ">" + inner + "</Indirect>");
}
std::string constant(const std::string& value, const std::string& type = "") {
  return scoped("LiteralConstant", "<Constant>" + (type.empty() ? "" : "<ConstantType>" + type + "</ConstantType>") +
                                       "<ConstantValue>" + value + "</ConstantValue></Constant>");
}
std::string symbol(const std::string& scope, const std::string& name) {
  return scoped(scope, "<Symbol><Component Name=\"" + name + "\"/></Symbol>");
}
std::string labelOf(const std::string& name) {
  return "<LabelDeclaration UId=\"9\"><Label Name=\"" + name + "\"/></LabelDeclaration>";
}
std::string toLabel(const std::string& name) { return scoped("Label", "<Label Name=\"" + name + "\"/>"); }
std::string status(const std::string& which) {
  return scoped("Statusword", "<Statusword Combination=\"" + which + "\"/>");
}

std::string listOf(const std::string& statements) {
  return "<StatementList xmlns=\"http://www.siemens.com/automation/Openness/SW/NetworkSource/StatementList/v4\">" +
         statements + "</StatementList>";
}
std::string listUnit(const std::string& statements) { return unit(listOf(statements), "STL"); }
std::string ob1(const std::string& statements, const std::string& sections = "") {
  return drawnBlock("OB", "Main", 1, sections, listUnit(statements));
}
Program readXml(const std::string& blocks) { return readText("list.xml", drawnDocument(blocks)); }
std::string statementsOf(const Program& program) {
  return program.findings.empty() && !program.pous.empty() ? show7(program.pous[0]) : findings7(program);
}
/// Beside data blocks DB 1 and DB 2 of four words.
void expectSame(const std::string& xml, const std::string& source) {
  std::string data, drawnData;
  for (const int number : {1, 2}) {
    data += "DATA_BLOCK DB " + std::to_string(number) +
            "\nSTRUCT\n  w : ARRAY [0 .. 3] OF WORD;\nEND_STRUCT;\nBEGIN\nEND_DATA_BLOCK\n";
    drawnData += drawnBlock("GlobalDB", "Data" + std::to_string(number), number,
                            section("Static", member("w", "Array[0..3] of Word")), "");
  }
  const Program written = read7(data + test7::block(1, source));
  ASSERT_EQ(findings7(written), "") << source;
  EXPECT_EQ(statementsOf(readXml(ob1(xml) + drawnData)), show7(written.pous[0]));
}

TEST(StatementListXml, TokensThatAreNoMnemonics) {
  const std::string input = address("Input", "Bool", 3);
  expectSame(token("A_BRACK") + token("A", input) + token("BRACKET") + token("AN_BRACK") + token("O", input) +
                 token("BRACKET") + token("O_BRACK") + token("AN", input) + token("BRACKET") + token("ON_BRACK") +
                 token("ON", input) + token("BRACKET") + token("X_BRACK") + token("X", input) + token("BRACKET") +
                 token("XN_BRACK") + token("XN", input) + token("BRACKET") + token("NEG") +
                 token("Rise", address("Memory", "Bool", 8)) + token("Fall", address("Memory", "Bool", 9)) +
                 token("Assign", address("Output", "Bool", 12)) + token("S", address("Output", "Bool", 13)) +
                 token("R", address("Output", "Bool", 14)),
             "A(;A I 0.3;);AN(;O I 0.3;);O(;AN I 0.3;);ON(;ON I 0.3;);X(;X I 0.3;);XN(;XN I 0.3;);NOT;FP M 1.0;FN M "
             "1.1;= Q 1.4;S Q 1.5;R Q 1.6");
  std::string timers = token("A", input) + token("L", constant("S5T#2S", "S5Time"));
  for (const char* each : {"OnDelay", "OffDelay", "Pulse", "Extend", "Retentive", "Free"})
    timers += token(each, address("Timer", "Timer", 5));
  expectSame(timers + token("CU", address("Counter", "Counter", 3)),
             "A I 0.3;L S5T#2S;SD T 5;SF T 5;SP T 5;SE T 5;SS T 5;FR T 5;CU C 3");
}

TEST(StatementListXml, ArithmeticAndComparisons) {
  std::string xml, source;
  for (const auto& [letters, sign] : std::vector<std::pair<std::string, std::string>>{{"LT", "<"},
                                                                                      {"LE", "<="},
                                                                                      {"EQ", "=="},
                                                                                      {"GE", ">="},
                                                                                      {"GT", ">"},
                                                                                      {"NE", "<>"},
                                                                                      {"ADD", "+"},
                                                                                      {"SUB", "-"},
                                                                                      {"MUL", "*"},
                                                                                      {"DIV", "/"}}) {
    for (const std::string type : {"I", "D", "R"}) {
      xml += token(letters + "_" + type);
      source += sign + type + ";";
    }
  }
  for (const auto& [text, mnemonic] : std::vector<std::pair<std::string, std::string>>{
           {"MOD_D", "MOD"},         {"NEG_I", "NEGI"},        {"NEG_D", "NEGD"},      {"NEG_R", "NEGR"},
           {"INV_I", "INVI"},        {"INV_D", "INVD"},        {"ABS_R", "ABS"},       {"RND_M", "RND-"},
           {"RND_P", "RND+"},        {"CAC", "TAK"},           {"XW", "XOW"},          {"XD", "XOD"},
           {"NOP_0", "NOP 0"},       {"NOP_1", "NOP 1"},       {"L_DBLG", "L DBLG"},   {"L_DBNO", "L DBNO"},
           {"L_DILG", "L DILG"},     {"L_DINO", "L DINO"},     {"LAR1_ACCU1", "LAR1"}, {"TAR1_ACCU1", "TAR1"},
           {"LAR1_AR2", "LAR1 AR2"}, {"TAR1_AR2", "TAR1 AR2"}, {"ADDAR1", "+AR1"},     {"PUSH", "PUSH"},
           {"ITD", "ITD"},           {"SAVE", "SAVE"},         {"SET", "SET"},         {"CLR", "CLR"}}) {
    xml += token(text);
    source += mnemonic + ";";
  }
  xml += token("ADD", constant("5", "Int")) + token("SLW", constant("3")) + token("SRSW", constant("2"));
  expectSame(xml, source + "+ 5;SLW 3;SSI 2");
}

TEST(StatementListXml, Operands) {
  expectSame(
      token("L", address("Memory", "Int", 80)) + token("T", address("DB", "Word", 16, " BlockNumber=\"1\"")) +
          token("L", address("DI", "DInt", 32)) + token("T", address("Local", "Byte", 160)) +
          token("L", address("PeripheryInput", "Word", 2048)) + token("L", constant("7", "DInt")) +
          token("L", constant("16#FF", "Word")) + token("L", status("STW")) + token("A", status("OV")) +
          token("AN", status("EQ")) + token("O", status("BR")) +
          token("L", indirect("Width=\"Word\" Area=\"DB\" Register=\"AR1\" BitOffset=\"16\"")) +
          token("A", indirect("Width=\"Bit\" Area=\"Memory\" Register=\"AR2\" BitOffset=\"9\"")) +
          token("T", indirect("Width=\"Double\" Register=\"AR1\" BitOffset=\"0\"")) +
          token("L", indirect("Width=\"Byte\" Area=\"Input\"", address("Memory", "DWord", 800))) +
          token("OPEN_DB", scoped("Address", "<Address Area=\"DB\" BlockNumber=\"1\"/>")) +
          token("OPEN_DI", scoped("Address", "<Address Area=\"DI\" BitOffset=\"2\"/>")) +
          token("OPEN_DB", indirect("Area=\"DB\"", address("Memory", "Word", 160))) +
          token("LC", indirect("Area=\"Timer\"", address("Memory", "Word", 176))),
      "L MW 10;T DB1.DBW 2;L DID 4;T LB 20;L PIW 256;L L#7;L W#16#FF;L STW;A OV;AN ==0;O BR;L DBW [AR1,P#2.0];A M "
      "[AR2,P#1.1];T D [AR1,P#0.0];L IB [MD 100];OPN DB 1;OPN DI 2;OPN DB [MW 20];LC T [MW 22]");
}

// The digest's third example: no jump when the operation overflowed.
TEST(StatementListXml, LabelsAndJumps) {
  expectSame(token("AN", status("OV")) + token("JC", toLabel("ok")) + token("CLR") + token("SET", "", labelOf("ok")) +
                 token("Assign", address("Output", "Bool", 0)) + token("COMMENT") + token("EMPTY_LINE") +
                 token("JUN", toLabel("ok")),
             "AN OV;JC ok;CLR;ok: SET;= Q 0.0;JU ok");
}

// `A #go; = Q 1.4` of the digest, and an FB with data of its own name, an FC, and an instance in static data.
TEST(StatementListXml, Calls) {
  const std::string mix =
      drawnBlock("FB", "Mix", 3, section("Input", member("lvl", "Int")) + section("Static", member("seen", "Int")),
                 listUnit(token("L", symbol("LocalVariable", "lvl")) + token("T", symbol("LocalVariable", "seen"))));
  const std::string outer =
      drawnBlock("FB", "Line", 4, section("Static", member("part", "&quot;Mix&quot;")),
                 listUnit(token("CALL", scoped("Call",
                                               "<CallInfo BlockType=\"FB\"><Instance Scope=\"LocalVariable\">"
                                               "<Component Name=\"part\"/></Instance><Parameter Name=\"lvl\" "
                                               "Section=\"Input\" Type=\"Int\">" +
                                                   constant("9", "Int") + "</Parameter></CallInfo>"))));
  const std::string twice =
      drawnBlock("FC", "Twice", 5, section("Input", member("a", "Int")) + section("Output", member("b", "Int")),
                 listUnit(token("L", symbol("LocalVariable", "a")) + token("L", symbol("LocalVariable", "a")) +
                          token("ADD_I") + token("T", symbol("LocalVariable", "b"))));
  const auto call = [](const std::string& info) { return token("CALL", scoped("Call", info)); };
  const auto data = [](const std::string& name) {
    return "<Instance Scope=\"GlobalVariable\"><Component Name=\"" + name + "\"/></Instance>";
  };
  const std::string main = ob1(
      call("<CallInfo Name=\"Mix\" BlockType=\"FB\">" + data("Mix_DB") +
           "<Parameter Name=\"lvl\" Section=\"Input\" Type=\"Int\">" + constant("7", "Int") +
           "</Parameter></CallInfo>") +
      call("<CallInfo Name=\"Line\" BlockType=\"FB\">" + data("Line_DB") + "</CallInfo>") +
      call("<CallInfo Name=\"Twice\" BlockType=\"FC\"><Parameter Name=\"b\" Section=\"Output\" Type=\"Int\">" +
           address("Memory", "Int", 80) + "</Parameter><Parameter Name=\"a\" Section=\"Input\" Type=\"Int\">" +
           constant("21", "Int") + "</Parameter></CallInfo>") +
      token("L", scoped("GlobalVariable", "<Symbol><Component Name=\"Mix_DB\"/><Component Name=\"seen\"/></Symbol>")) +
      token("T", address("Memory", "Int", 96)) +
      token("L", scoped("GlobalVariable",
                        "<Symbol><Component Name=\"Line_DB\"/><Component Name=\"part\"/><Component "
                        "Name=\"seen\"/></Symbol>")) +
      token("T", address("Memory", "Int", 112)));
  const test::TemporaryFolder folder;
  const std::string file = folder.file("calls.xml", drawnDocument(main + mix + outer + twice));
  const test7::Output run = test7::run({"sim", file, "--scans", "1", "--signals", "MW10,MW12,MW14", "--trace", "-"});
  EXPECT_TRUE(run.has("1,10,10,42,7,9")) << run.text;
}

// OPN DI of a name leaves DB open as it was: MW0 comes from "A", MW2 from "B".
TEST(StatementListXml, OpensInstanceDataByName) {
  const auto data = [](const std::string& name, const std::string& value) {
    return drawnBlock("GlobalDB", name, name == "A" ? 1 : 2,
                      section("Static", member("v", "Int", "<StartValue>" + value + "</StartValue>")), "");
  };
  const std::string main =
      ob1(token("OPEN_DB", symbol("GlobalVariable", "A")) + token("OPEN_DI", symbol("GlobalVariable", "B")) +
          token("L", address("DB", "Int", 0)) + token("T", address("Memory", "Int", 0)) +
          token("L", address("DI", "Int", 0)) + token("T", address("Memory", "Int", 16)));
  const test::TemporaryFolder folder;
  const std::string file = folder.file("open.xml", drawnDocument(main + data("A", "11") + data("B", "22")));
  const test7::Output run = test7::run({"sim", file, "--scans", "1", "--signals", "MW0,MW2", "--trace", "-"});
  EXPECT_TRUE(run.has("1,10,10,11,22")) << run.text;
}

// Drawn networks and lists stand in one block; a comment speaks to the tool.
TEST(StatementListXml, LanguagesInOneBlock) {
  test7::DrawnNet net;
  const int coil = net.part("Coil");
  const int contact = net.part("Contact");
  net.rail({{contact, "in"}});
  net.in("I0.0", contact, "operand");
  net.flow({contact, "out"}, {{coil, "in"}});
  net.in("M0.0", coil, "operand");
  const std::string comment = "<LineComment><Text>//@ prove p: Q0.0 = I0.0</Text></LineComment>";
  const std::string main = drawnBlock(
      "OB", "Main", 1, "",
      unit(net.text(), "LAD") +
          listUnit(token("A", address("Memory", "Bool", 0), comment) + token("Assign", address("Output", "Bool", 0))));
  const test::TemporaryFolder folder;
  const test7::Output proof = test7::run({"prove", folder.file("both.xml", drawnDocument(main))});
  EXPECT_TRUE(proof.has("PROVED  p")) << proof.text;
}

// Whatever cannot be read leaves open what depends on its network, and nothing else.
TEST(StatementListXml, WhatIsNotKnownIsNamed) {
  const std::string good =
      listUnit(token("A", address("Input", "Bool", 1)) + token("Assign", address("Output", "Bool", 1)));
  const std::string assign = token("Assign", address("Output", "Bool", 0));
  const std::vector<std::pair<std::string, std::string>> cases = {
      {token("FLY", address("Input", "Bool", 0)), "FLY"},
      {token("A", address("Cupboard", "Bool", 0)), "the operand of A cannot be read"},
      {token("A", status("NU")), "the operand of A cannot be read"},
      {token("A", scoped("LocalVariable", "<Symbol><Component Name=\"x\" SliceAccessModifier=\"x3\"/></Symbol>")),
       "SliceAccessModifier"},
      {token("NOP_0", address("Input", "Bool", 0)), "NOP_0 takes no operand"},
      {token("EMPTY_LINE", address("Input", "Bool", 0)), "an operand stands without an instruction"},
      {"<StlStatement><Macro/><StlToken Text=\"SET\"/></StlStatement>", "Macro"},
      {token("L", indirect("Width=\"Word\" Area=\"DB\" Register=\"AR3\" BitOffset=\"0\"")), "AR3"},
      {token("CALL", scoped("Call", "<CallInfo BlockType=\"FC\"/>")), "the operand of CALL cannot be read"},
  };
  const test::TemporaryFolder folder;
  for (const auto& [statement, message] : cases) {
    const std::string file =
        folder.file("bad.xml", drawnDocument(drawnBlock("OB", "Main", 1, "", listUnit(statement + assign) + good)));
    const std::string properties = folder.file("p.prop", "prove open: not Q0.0\nprove known: Q0.1 = I0.1\n");
    const test7::Output proof = test7::run({"prove", file, "--props", properties});
    EXPECT_TRUE(proof.has(message)) << message << '\n' << proof.text;
    EXPECT_FALSE(proof.has("PROVED  open") || proof.has("VIOLATED  open")) << message << '\n' << proof.text;
    EXPECT_TRUE(test7::run({"lint", file}).has(message)) << message;
  }
}

}  // namespace
}  // namespace rungproof
