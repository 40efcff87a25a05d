// The table of reader messages is complete, and every message can be provoked by some text.
#include "frontend/stl/syntax_message.hpp"

#include <gtest/gtest.h>

#include <set>

#include "frontend/input/stored_reader.hpp"
#include "frontend/input/text_sources.hpp"
#include "frontend/step7/symbol_list.hpp"
#include "tests/reader/read.hpp"

namespace rungproof {
namespace {

TEST(SyntaxMessages, RowsAreComplete) {
  std::set<std::string_view> titles;
  for (const SyntaxMessage& row : syntaxMessages) {
    EXPECT_EQ(row.id.substr(0, 3), "SYN");
    EXPECT_EQ(row.id.size(), 6U);
    EXPECT_FALSE(row.help.empty()) << row.id;
    EXPECT_TRUE(titles.insert(row.title).second) << row.title;
  }
}

TEST(SyntaxMessages, EveryMessageOccurs) {
  std::set<std::string> seen;
  const auto collect = [&](const Program& program) {
    for (const Finding& finding : program.findings) seen.insert(finding.rule);
  };
  const std::string frame = "ORGANIZATION_BLOCK M:OB1\nBEGIN\nNetwork 1\n";
  collect(readProgram({"/nonexistent/program.awl"}));
  collect(readText("x", "neither fish nor flesh\n"));
  ReadOptions utf8;
  utf8.encoding = TextEncoding::Utf8;
  collect(readText("x", "NOT // \xFF\n", utf8));
  collect(readText("x", std::string("NOT\0", 4)));
  collect(readText("x", std::string("\xFF\xFEN\0O\0T\0", 8)));
  collect(readText("x", frame + "END_ORGANIZATION_BLOCK\n"));
  collect(readText("x", ""));
  std::string many;
  for (int i = 0; i < 10001; ++i) many += "FOO\n";
  collect(readText("x", frame + many));
  collect(readText(
      "x",
      frame +
          "RTUM VB0\nLD\nLD I0..0\nMOVW 3#1, VW0\n***\nMOV_B 1, VB0\nLDS= \"a, VB0\nCALL1\nA I0.0\nA E0.0\nA I0.1\n"));
  collect(readText(
      "x",
      frame + "SUBROUTINE_BLOCK A\nBEGIN\nNetwork 99999999\nNOT\nEND_SUBROUTINE_BLOCK\nEND_SUBROUTINE_BLOCK\nNOT\n"));
  collect(readText("x", frame + "NOT\nEND_ORGANIZATION_BLOCK\n" + frame + "END_ORGANIZATION_BLOCK\n"));
  collect(readText("x", frame + "NOT\nEND_ORGANIZATION_BLOCK\nSUBROUTINE_BLOCK S:SBR0\nBEGIN\nNetwork 1 // This POU is "
                                "password-protected against editing and viewing.\nEND_SUBROUTINE_BLOCK\n"));
  std::string locals;
  for (int i = 0; i < 17; ++i) locals += fmt::format("v{}:REAL;\n", i);
  collect(readText("x", "ORGANIZATION_BLOCK M:OB1\nVAR\nx:FOO;\n" + locals +
                            "END_VAR\nBEGIN\nNOT\nEND_ORGANIZATION_BLOCK\nSYMBOL_TABLE\n1 "
                            "2\nEND_SYMBOL_TABLE\nDATA_BLOCK\n5\nVB0 x\nVB1 300\nEND_DATA_BLOCK\n"));
  const std::string project =
      "<project xmlns=\"http://www.plcopen.org/xml/tc6_0201\"><pou name=\"M\" pouType=\"program\">";
  collect(readText("x", project + "<body"));
  collect(readText("x", "<!DOCTYPE p [<!ENTITY e \"e\">]>" + project + "</pou></project>"));
  std::string deep;
  for (int i = 0; i < 300; ++i) deep += "<a>";
  collect(readText("x", project + deep));
  ReadOptions asS7200;
  asS7200.dialect = "s7-200";
  collect(readText("x", project + "<body><SFC/></body></pou></project>", asS7200));
  collect(readText("x",
                   "<project xmlns=\"http://www.plcopen.org/xml/tc6_0201\"><fileHeader productName=\"S7-200\"/>"
                   "<pou name=\"M\" pouType=\"program\"><body><SFC/></body></pou></project>",
                   asS7200));
  collect(readText(
      "x", project +
               "<interface><localVars><variable name=\"T\"><type><derived name=\"TON\"/></type></variable><variable "
               "name=\"v\"><type><TIME/></type></variable></localVars></interface><body><FBD>"
               "<inVariable localId=\"1\"><expression>v</expression></inVariable><block localId=\"2\" typeName=\"TON\" "
               "instanceName=\"T\"><inputVariables><variable formalParameter=\"IN\"><connectionPointIn>"
               "<expression>TRUE</expression></connectionPointIn></variable><variable "
               "formalParameter=\"PT\"><connectionPointIn><connection "
               "refLocalId=\"1\"/></connectionPointIn></variable></inputVariables>"
               "</block></FBD></body></pou></project>"));
  collect(readText("x", "LD I0.0\nL MW 10\n"));
  collect(
      readText("x",
               "FUNCTION FC 1 : VOID\nODD line\nVAR_INPUT\n a BOOL ;\n b : NONE ;\n c : INT := 'x' ;\nEND_VAR\nBEGIN\n"
               "FOO;\nL M 0.0;\nA \"name\";\nCALL FC 1;\nCALL FC 2;\nJC m;\nCALL SFC 43;\nCALL SFC 61 (BLOCK_ID := "
               "B#16#0);\nEND_FUNCTION\n"
               "DATA_BLOCK DB 9000\nSTRUCT\n a : INT ;\nEND_STRUCT ;\nBEGIN\n a 1 ;\nEND_DATA_BLOCK\n"));
  collect(readText("x.st",
                   "PROGRAM m VAR a : INT; r : REAL; s, t : STRING; END_VAR\na = 1;\na := r;\na : = 2;\nb := 1;\ns := "
                   "t;\nEND_PROGRAM\n"));
  collect(readText("x.st",
                   "PROGRAM m VAR a : INT; p : POINTER TO INT; u : Unheard; END_VAR\np := ADR(a);\nu(x := a);\n"
                   "END_PROGRAM\n"));
  collect(readText("x.st", "TYPE t : INT; END_TYPE\nFUNCTION f : INT\nf := 1;\nEND_FUNCTION\n"));
  collect(readText("x.scl", "FUNCTION FC 1 : INT\nBEGIN\nFC1 := 1.5;\nFC1 := ;\nEND_FUNCTION\n"));
  Program symbols;
  SyntaxSink sink(symbols, symbols.sources->add("x.asc", "126,Stop                   I       0.1 BOOL      \n"));
  step7::readSymbolList(symbols.sources->file(sink.file()).text(), step7::MnemonicSet::International, sink);
  collect(symbols);
  // A block of a project whose code is none, and a caller that knows another interface of it.
  s7project::S7Project stored;
  stored.faults.push_back({"", "a table is damaged", true});
  mc7::StoredBlock damaged, caller;
  damaged.key = {step7::BlockKind::Fc, 1};
  damaged.code = "\x6B\xFF";
  damaged.interfaceTime = 2;
  caller.key = {step7::BlockKind::Ob, 1};
  caller.used = {{damaged.key, 1}};
  stored.programs.emplace_back().blocks = {damaged, caller};
  Program program;
  step7::Step7Project sources;
  StoredReader(program, sources).addProgram(stored, "", "Plant.s7p", false);
  collect(program);
  // A text source with another statement than the block that runs.
  s7project::S7Project beside;
  mc7::StoredBlock block;
  block.key = {step7::BlockKind::Fc, 1};
  block.code = std::string("\x65\0", 2);
  s7project::ProjectProgram& own = beside.programs.emplace_back();
  own.path = "P";
  own.blocks = {block};
  own.sources = {{"S", false, "FUNCTION FC 1 : VOID\nBEGIN\nNETWORK\nNOT;\nEND_FUNCTION\n"}};
  Program running;
  step7::Step7Project running7;
  StoredReader(running, running7).addProgram(beside, "P", "P", false);
  step7::buildStep7Project(running, running7, {});
  for (const Finding& finding : findUnlikeSources(running, beside, "P", Settings())) seen.insert(finding.rule);
  for (const SyntaxMessage& row : syntaxMessages)
    EXPECT_TRUE(seen.count(std::string(row.id)) > 0) << row.id << ' ' << row.title;
}

}  // namespace
}  // namespace rungproof
