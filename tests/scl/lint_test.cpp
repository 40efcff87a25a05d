// Rules over bodies in SCL: they speak of the text, at its places, and rules about statement lists are silent. What
// `show` prints is the text.
#include "tests/scl/naive_scl.hpp"
#include "tests/scl/scl_run.hpp"

namespace rungproof {
namespace {

using testscl::commandOn;
using testscl::mainOf;
using testscl::Output;

constexpr const char* numbers = "VAR_TEMP\n a : INT; b : INT; r : REAL; f : BOOL; d : DINT;\nEND_VAR\n";

TEST(SclLint, DivisorThatMayBeZero) {
  const Output output = commandOn("lint", mainOf("#a := WORD_TO_INT(MW10);\n#b := 100 / #a;\nMW20 := #b;", numbers));
  EXPECT_TRUE(output.has("warning[ARI001]: '100 / #a' divides by")) << output.text;
  EXPECT_TRUE(output.has("main.scl:7:7")) << output.text;
}

TEST(SclLint, DividesByZero) {
  const Output output = commandOn("lint", mainOf("MW20 := 5 / 0;", numbers));
  EXPECT_TRUE(output.has("ARI001")) << output.text;
}

TEST(SclLint, StatementThatNoPathReaches) {
  const Output output = commandOn("lint", mainOf("MW20 := 1;\nRETURN;\nMW20 := 2;", numbers));
  EXPECT_TRUE(output.has("warning[CTL005]: no path reaches this statement")) << output.text;
  EXPECT_TRUE(output.has("main.scl:8:1")) << output.text;
}

TEST(SclLint, RealComparedForEquality) {
  const Output output = commandOn("lint", mainOf("#r := 1.5;\nM20.0 := #r = 1.5;", numbers));
  EXPECT_TRUE(output.has("warning[ARI004]: '#r = 1.5' compares real numbers for equality")) << output.text;
  EXPECT_TRUE(output.has("main.scl:7:10")) << output.text;
}

// Programs of every statement and operator: nothing is said of the lowering, of its labels and its temporary data.
TEST(SclLint, RulesOfStatementListsAreSilent) {
  for (int seed = 1; seed <= 20; ++seed) {
    testscl::NaiveScl naive(static_cast<std::uint64_t>(seed));
    naive.randomState();
    const std::string body = naive.initial() + naive.program(10) + naive.comparison() + "MW20 := #good;\n";
    const Output output = commandOn("lint", mainOf(body, testscl::NaiveScl::declarations()), {"--format", "concise"});
    for (const char* rule : {"NST", "STK", "SUB005", "SUB007", "OBL001", "CTL001", "CTL011", "ADR008", "DBA", "LOG003"})
      EXPECT_FALSE(output.has(rule)) << "seed " << seed << " " << rule << "\n" << output.text;
  }
}

// A fix of an instruction would write statements of a list into the text.
TEST(SclLint, FixesLeaveTheTextAlone) {
  const test::TemporaryFolder folder;
  const std::string text = mainOf("M20.0 := I0.0;\nM20.0 := I0.1;\nMW22 := 5 / 0;\nQ4.0 := M20.0;", numbers);
  folder.file("main.scl", text);
  test7::run({"lint", "--fix", "--unsafe-fixes", folder.path("main.scl")});
  std::ifstream file(folder.path("main.scl"));
  std::stringstream after;
  after << file.rdbuf();
  EXPECT_EQ(after.str(), text);
}

TEST(SclShow, PrintsTheText) {
  const Output output =
      commandOn("show", mainOf("IF I0.0 THEN\n  Q4.0 := TRUE;\nEND_IF;\nMW20 := 2 + 3;"), {"--no-findings"});
  EXPECT_EQ(output.exit, 0) << output.text;
  EXPECT_TRUE(output.has("Network 1\n  IF I0.0 THEN\n    Q4.0 := TRUE;\n  END_IF\n")) << output.text;
  EXPECT_TRUE(output.has("Network 2\n  MW20 := 2 + 3\n")) << output.text;
  EXPECT_FALSE(output.has("JCN")) << output.text;
}

}  // namespace
}  // namespace rungproof
