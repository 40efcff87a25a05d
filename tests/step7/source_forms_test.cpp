// Forms in which sources, tables and calls of an S7-300/400 come besides those of the editor's own export: heads on one
// line, data blocks and tables alone, parameters in braces, pointers for variables of complex type, and which double
// words hold a REAL. Each expectation is reasoned beside it.
#include "tests/step7/run7.hpp"

namespace rungproof {
namespace {

using test7::block, test7::lastRow, test7::Output, test7::run;

/// What a command says of files in a folder, whose family nobody names.
Output of(const std::string& command, const std::vector<std::pair<std::string, std::string>>& files,
          const std::vector<std::string>& more = {}) {
  const test::TemporaryFolder folder;
  std::vector<std::string> arguments = {command};
  for (const auto& [name, text] : files) {
    folder.file(name, text);
    arguments.push_back(folder.path(name));
  }
  arguments.insert(arguments.end(), more.begin(), more.end());
  arguments.insert(arguments.end(), {"--dialect", "auto"});
  return run(arguments);
}

// The words of a head may stand on one line; what begins with a colon there is a version and no second name.
TEST(SourceForms, HeadsOnOneLine) {
  for (const std::string head : {"ORGANIZATION_BLOCK OB 1 VERSION : 0.1\n", "ORGANIZATION_BLOCK OB1 VERSION : 0.1\n",
                                 "ORGANIZATION_BLOCK \"Main\" VERSION : 0.1\n",
                                 "ORGANIZATION_BLOCK OB 1 AUTHOR : me VERSION : 0.1 VAR_TEMP x : INT ; END_VAR\n"}) {
    const Output output =
        of("sim", {{"a.awl", head + "BEGIN\nNETWORK\n      L 7;\n      T MW 10;\nEND_ORGANIZATION_BLOCK\n"}},
           {"--scans", "1", "--signals", "MW10"});
    EXPECT_EQ(output.exit, 0) << head << output.text;
    EXPECT_TRUE(output.has("1,10,10,7")) << head << output.text;
  }
  // The main program of an S7-200 has its number behind its name.
  const Output other = of("lint", {{"a.awl",
                                    "ORGANIZATION_BLOCK MAIN:OB1\nBEGIN\nNetwork 1\nLD I0.0\n= Q0.0\n"
                                    "END_ORGANIZATION_BLOCK\n"}});
  EXPECT_EQ(other.exit, 0) << other.text;
}

// Data blocks have sources of their own: nothing is wrong with them.
TEST(SourceForms, DataBlocksAlone) {
  const Output output = of("lint", {{"d.awl",
                                     "DATA_BLOCK DB 5\nSTRUCT\n a : INT ;\nEND_STRUCT ;\nBEGIN\n"
                                     "END_DATA_BLOCK\n"}});
  EXPECT_FALSE(output.has("error")) << output.text;
}

// A row without name and address ends some exported tables; a table alone belongs to sources that are not there.
TEST(SourceForms, SymbolTables) {
  const std::string table =
      "126,Motor                   Q       4.0 BOOL      \r\n126," + std::string(46, ' ') + "\r\n";
  const Output both = of("lint", {{"a.awl", block(1, "A I 0.0;= \"Motor\"")}, {"s.asc", table}});
  EXPECT_FALSE(both.has("error")) << both.text;
  const Output alone = of("lint", {{"s.asc", table}});
  EXPECT_EQ(alone.exit, 2);
  EXPECT_TRUE(alone.has("is a symbol table of an S7-300 or S7-400, and no source of its program is there"))
      << alone.text;
}

// An upload shows so what the editor calls by itself: the block is missing, as any other.
TEST(SourceForms, ParametersInBraces) {
  const std::string calls = "UC SFC65097 { P#L 210.1 };UC SFC65097 { P#L 212.0 };A I 0.0;= Q 0.0";
  const Output output = of("lint", {{"a.awl", block(1, calls)}});
  EXPECT_TRUE(output.has("error[SYN049]: SFC65097 is in none of the files (2 uses, this is the first)")) << output.text;
  EXPECT_FALSE(output.has("SYN044")) << output.text;
  // As an upload breaks the lines.
  const Output broken = of("lint", {{"a.awl", block(1,
                                                    "UC     SFC65097 {\n            P#L 210.1,\n            P#L 211.0,"
                                                    "\n            P#L 156.0};A I 0.0;= Q 0.0")}});
  EXPECT_TRUE(broken.has("error[SYN049]: SFC65097 is in none of the files")) << broken.text;
  EXPECT_FALSE(broken.has("SYN044")) << broken.text;
  // A brace that nothing closes ends with its statement.
  const Output open = of("lint", {{"a.awl", block(1, "UC SFC65097 {\n P#L 210.1;A I 0.0;= Q 0.0") + "// }\n"}});
  EXPECT_TRUE(open.has("error[SYN044]: text behind the end of the statement")) << open.text;
  // What they give a block that is there, nobody knows either.
  const Output known = of("lint", {{"a.awl", "FUNCTION FC 3 : VOID\nBEGIN\nNETWORK\nNOP 0;\nEND_FUNCTION\n" +
                                                 block(1, "UC FC 3 { P#L 210.1 }")}});
  EXPECT_TRUE(known.has("error[SYN047]: what UC gives in braces is not known")) << known.text;
}

// The block is missing once, not once for each start value of its instance.
TEST(SourceForms, StartValuesOfAMissingBlock) {
  const std::string values = "BEGIN\n A := 1;\n B := FALSE;\n C := T 3;\nEND_DATA_BLOCK\n";
  const Output output = of(
      "lint", {{"a.awl", "DATA_BLOCK DB 5\n FB 7\n" + values + block(1, "A I 0.0;= Q 0.0;CALL FB 7, DB 5 (A := 1)")}});
  EXPECT_TRUE(output.has("error[SYN042]: nothing defines the type FB 7")) << output.text;
  EXPECT_FALSE(output.has("declares no")) << output.text;
  const Output known = of(
      "lint", {{"a.awl", "DATA_BLOCK DB 5\nSTRUCT\n A : INT;\nEND_STRUCT;\n" + values + block(1, "A I 0.0;= Q 0.0")}});
  EXPECT_TRUE(known.has("error[SYN046]: DB5 declares no B")) << known.text;
}

const std::string recipe =
    "DATA_BLOCK DB 10\nSTRUCT\n fill : ARRAY [1..4] OF INT ;\n s : STRUCT\n  a : INT := 3 ;\n"
    "  b : INT := 4 ;\n END_STRUCT ;\nEND_STRUCT ;\nBEGIN\nEND_DATA_BLOCK\n";
const std::string adder =
    "FUNCTION FC 3 : VOID\nVAR_INPUT\n s : STRUCT\n  a : INT ;\n  b : INT ;\n END_STRUCT ;\n"
    "END_VAR\nBEGIN\nNETWORK\nL #s.a;\nL #s.b;\n+I ;\nT MW 10;\nEND_FUNCTION\n";

// The variable begins at byte 8 of DB10: 3 and 4 stand there.
TEST(SourceForms, PointersForVariablesOfComplexType) {
  const std::string text = recipe + adder;
  EXPECT_TRUE(lastRow(text + block(1, "CALL FC 3 (s := P#DB10.DBX 8.0)"), "MW10", {"--scans", "1"}).ends_with(",7"));
  EXPECT_TRUE(lastRow(text + block(1, "L 2;T MW 30;L 6;T MW 32;CALL FC 3 (s := P#M 30.0)"), "MW10", {"--scans", "1"})
                  .ends_with(",8"));
  // No whole byte, behind the end of the block, a block that is missing.
  for (const std::string wrong : {"P#DB10.DBX 8.1", "P#DB10.DBX 10.0", "P#DB11.DBX 0.0"}) {
    const Output output = of("lint", {{"a.awl", text + block(1, "CALL FC 3 (s := " + wrong + ")")}});
    EXPECT_TRUE(output.has("error[SYN047]") || output.has("error[SYN049]")) << wrong << output.text;
  }
}

// 16#3F000000 are the bits of 0.5 where a call gives the double word for a REAL, or the data block declares one.
TEST(RealAddresses, ActualParametersAndDeclarations) {
  const std::string half =
      "FUNCTION FC 4 : VOID\nVAR_INPUT\n r : REAL ;\nEND_VAR\nBEGIN\nNETWORK\nL #r;\nT MD 40;\n"
      "END_FUNCTION\nDATA_BLOCK DB 1\nSTRUCT\n w : INT ;\n x : ARRAY [1..2] OF REAL ;\n d : DINT ;\n"
      "END_STRUCT ;\nBEGIN\nEND_DATA_BLOCK\n" +
      block(1, "CALL FC 4 (r := MD 20);L DB1.DBD 6;T MD 50;L DB1.DBD 10;T MD 54");
  const auto value = [&](const std::string& address, const std::string& given) {
    return lastRow(half, address, {"--scans", "1", "--set", address + "=" + given});
  };
  EXPECT_TRUE(value("MD20", "16#3F000000").ends_with(",0.5")) << value("MD20", "16#3F000000");
  EXPECT_TRUE(value("MD20", "0.5").ends_with(",0.5"));
  EXPECT_TRUE(value("DB1.DBD6", "16#3F000000").ends_with(",0.5"));
  // A DINT has a number.
  EXPECT_TRUE(value("DB1.DBD10", "16#3F000000").ends_with(",1056964608"));
}

}  // namespace
}  // namespace rungproof
