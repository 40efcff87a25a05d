// Symbol tables: each form, both sets of mnemonics, rows that are none.
#include "frontend/step7/symbol_list.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace rungproof::step7 {
namespace {

std::string rowsOf(const std::string& text, MnemonicSet set = MnemonicSet::International) {
  Program program;
  const std::uint32_t file = program.sources->add("symbols", text);
  SyntaxSink sink(program, file);
  std::string result;
  for (const SymbolRow& row : readSymbolList(program.sources->file(file).text(), set, sink)) {
    const std::string address =
        row.address.form == OperandForm::Block
            ? toString(*row.address.block)
            : fmt::format("{}/{}/{}.{}", static_cast<int>(row.address.place), static_cast<int>(row.address.size),
                          row.address.number, row.address.bit);
    result += fmt::format("{}[{}={}:{}:{}]", result.empty() ? "" : " ", row.name.text, address, row.type, row.comment);
    EXPECT_EQ(program.sources->text(row.name.span), row.name.text);
  }
  for (const Finding& finding : program.findings)
    result += fmt::format(" {}@{}", finding.rule, program.sources->position(finding.span).line);
  return result;
}

/// Each finding with its place: "line:column of `text`: message".
std::string findingsOf(const std::string& text) {
  Program program;
  const std::uint32_t file = program.sources->add("symbols.asc", text);
  SyntaxSink sink(program, file);
  readSymbolList(program.sources->file(file).text(), MnemonicSet::International, sink);
  std::string result;
  for (const Finding& finding : program.findings) {
    const Position position = program.sources->position(finding.span);
    result += fmt::format("{} {}:{} of `{}`: {}\n", finding.rule, position.line, position.column,
                          program.sources->text(finding.span), finding.message);
  }
  return result;
}

// Places: 0 I, 1 Q, 2 M, 8 T, 9 C. Sizes: 0 bit, 2 word.

TEST(SymbolLists, SdfOfStep7) {
  EXPECT_EQ(rowsOf("\"BLKMOV                  \",\"SFC    20   \",\"SFC    20 \",\"Copy Variables      \"\r\n"
                   "\"Motor on                \",\"Q       4.0 \",\"BOOL      \",\"                    \"\r\n"
                   "\"a.b[c], d               \",\"MW     10   \",\"INT       \",\"x, y                \"\r\n"),
            "[BLKMOV=SFC 20:SFC 20:Copy Variables] [Motor on=1/0/4.0:BOOL:] [a.b[c], d=2/2/10.0:INT:x, y]");
}

// A separator of another form in a comment separates nothing.
TEST(SymbolLists, SdfWithSeparatorsInItsComment) {
  EXPECT_EQ(rowsOf("\"Auto                    \",\"M     120.0 \",\"BOOL      \",\"1 auto;0 manual     \"\r\n"
                   "\"Hand                    \",\"M     120.1 \",\"BOOL      \",\"1\thand, 0 auto      \"\r\n"),
            "[Auto=2/0/120.0:BOOL:1 auto;0 manual] [Hand=2/0/120.1:BOOL:1\thand, 0 auto]");
}

TEST(SymbolLists, AscHasFixedColumns) {
  EXPECT_EQ(rowsOf("126,Pumpe ein               E       0.0 BOOL      Taster S1\r\n"
                   "126,Zeit                    T       4   TIMER     \r\n"
                   "126,\xC3\x9C"
                   "berlauf                A       4.7 BOOL      voll\r\n",
                   MnemonicSet::German),
            "[Pumpe ein=0/0/0.0:BOOL:Taster S1] [Zeit=8/0/4.0:TIMER:] [\xC3\x9C"
            "berlauf=1/0/4.7:BOOL:voll]");
}

// The address has to stand in columns 29 to 40 (126, and 24 columns of the name in front). One blank too few: it begins
// in column 28; two too many: its last digit is in column 41; none: the row ends behind the name.
TEST(SymbolLists, AscOutOfLine) {
  const std::string good = "126,Start                   I       0.0 BOOL      \r\n";
  EXPECT_EQ(
      findingsOf(good + "126,Stop                   I       0.1 BOOL      \r\n" + good),
      "SYN053 2:28 of `I       0.1`: the address \"I       0.1\" stands in columns 28 to 38, not between 29 and 40\n");
  EXPECT_EQ(findingsOf("126,Delay                     T       14  TIMER     \r\n"), "");
  EXPECT_EQ(
      findingsOf("126,Delay                      T       14 TIMER     \r\n"),
      "SYN053 1:32 of `T       14`: the address \"T       14\" stands in columns 32 to 41, not between 29 and 40\n");
  EXPECT_EQ(
      findingsOf("126,\xC3\x9C"
                 "ber A 1                  I       0.1 BOOL      \r\n"),
      "SYN053 1:31 of `I       0.1`: the address \"I       0.1\" stands in columns 31 to 41, not between 29 and 40\n");
  EXPECT_EQ(findingsOf("126,Start                   BOOL      start button\r\n"),
            "SYN053 1:29 of `BOOL      st`: no address stands in columns 29 to 40\n");
}

TEST(SymbolLists, DifTuples) {
  const std::string head =
      "TABLE\r\n0,1\r\n\"EXCEL\"\r\nTUPLES\r\n0,4\r\n\"\"\r\nVECTORS\r\n0,2\r\n\"\"\r\nDATA\r\n0,0\r\n\"\"\r\n";
  EXPECT_EQ(
      rowsOf(head + "-1,0\r\nBOT\r\n1,0\r\n\"Fan\"\r\n1,0\r\n\"Q       5.0\"\r\n1,0\r\n\"BOOL\"\r\n1,0\r\n\"air\"\r\n"
                    "-1,0\r\nBOT\r\n1,0\r\n\"Valve\"\r\n1,0\r\n\"FB      1\"\r\n1,0\r\n\"FB      1\"\r\n1,0\r\n\"\"\r\n"
                    "-1,0\r\nEOD\r\n"),
      "[Fan=1/0/5.0:BOOL:air] [Valve=FB 1:FB 1:]");
}

TEST(SymbolLists, SeqHasTheAddressFirst) {
  EXPECT_EQ(rowsOf("\tI 0.0\tStart\tbutton\r\n\tDB 10\tRecipe\t\r\n"), "[Start=0/0/0.0::button] [Recipe=DB 10::]");
}

TEST(SymbolLists, CsvWithHeading) {
  EXPECT_EQ(rowsOf("Symbol;Operand;Datentyp;Kommentar\nStart;E 0.0;BOOL;Taster\nZ\xC3\xA4hler;Z 1;COUNTER;\n",
                   MnemonicSet::German),
            "[Start=0/0/0.0:BOOL:Taster] [Z\xC3\xA4hler=9/0/1.0:COUNTER:]");
  EXPECT_EQ(rowsOf("Start,I 0.0,BOOL,\n"), "[Start=0/0/0.0:BOOL:]");
}

TEST(SymbolLists, TagsOfTia) {
  EXPECT_EQ(rowsOf("\"Start button\",\"%I0.0\",\"Bool\",\"True\",\"True\",\"False\",\"go\",\"True\"\n"),
            "[Start button=0/0/0.0:Bool:go]");
}

TEST(SymbolLists, RowsThatAreNone) {
  EXPECT_EQ(rowsOf("Start;I 0.0;BOOL;\nStop;somewhere;BOOL;\nNext;I 0.9;BOOL;\nLast;I 0.2;BOOL;\n;;;\n"),
            "[Start=0/0/0.0:BOOL:] [Last=0/0/0.2:BOOL:] SYN029@2 SYN029@3");
}

TEST(SymbolLists, TagTablesAsXml) {
  Program program;
  const std::uint32_t file = program.sources->add(
      "tags.xml",
      "<Document><SW.Tags.PlcTagTable><ObjectList><SW.Tags.PlcTag><AttributeList><DataTypeName>Bool</DataTypeName>"
      "<LogicalAddress>%I0.1</LogicalAddress><Name>Stop</Name></AttributeList></SW.Tags.PlcTag><SW.Tags.PlcTag>"
      "<AttributeList><DataTypeName>Int</DataTypeName><LogicalAddress>%VW3</LogicalAddress><Name>Odd</Name>"
      "</AttributeList></SW.Tags.PlcTag></ObjectList></SW.Tags.PlcTagTable></Document>");
  SyntaxSink sink(program, file);
  const std::vector<SymbolRow> rows = readTagTable(program.sources->file(file), sink);
  ASSERT_EQ(rows.size(), 1u);
  EXPECT_EQ(rows[0].name.text, "Stop");
  EXPECT_EQ(rows[0].address.bit, 1);
  ASSERT_EQ(program.findings.size(), 1u);
  EXPECT_EQ(program.findings[0].message, "tag Odd has the address %VW3, which no S7-300/400 has");
}

TEST(SymbolLists, StatementsAreNoRows) {
  EXPECT_FALSE(isSymbolList("A\tI 0.0\nAN\tI 0.1\n=\tQ 4.0\n"));
  EXPECT_TRUE(isSymbolList("Start\tI 0.0\nStop\tI 0.1\n"));
}

}  // namespace
}  // namespace rungproof::step7
