// What the reader of IEC 61131-3 says against texts that are wrong, and that it reads on behind them.
#include "tests/iec/iec_output.hpp"
#include "tests/iec/iec_run.hpp"

namespace rungproof {
namespace {

struct Wrong {
  const char* declarations;
  const char* statements;
  const char* message;
};

constexpr Wrong wrongTexts[] = {
    {"a : INT; b : REAL;", "a := b;", "REAL does not fit into INT"},
    {"a : INT;", "a = 3;", "':=' is needed here, not '='"},
    {"a : INT;", "c := 1;", "there is no variable c"},
    {"t : TON;", "t(IN := TRUE, PX := T#1s);", "block TON has no input PX"},
    {"a : INT;", "IF a THEN a := 1; END_IF;", "INT does not fit into BOOL"},
    {"a : INT;", "a := 100000;", "100000 does not fit into INT"},
    {"b : REAL; a : INT;", "FOR b := 1 TO 3 DO a := 1; END_FOR;", "FOR counts in a variable of whole numbers"},
    {"a : INT;", "a := foo(3);", "there is no function foo"},
    {"a : INT;", "a := T#5s;", "TIME does not fit into INT"},
    {"u : UNKNOWN;", "", "there is no type UNKNOWN"},
    {"a : ARRAY [3..1] OF INT;", "", "the bounds of the array are no constants in ascending order"},
    {"a : ARRAY [0..3] OF INT;", "a[4] := 1;", "index 4 is outside of 0..3"},
    {"a : ARRAY [0..3] OF INT;", "a[1, 2] := 1;", "the array has 1 dimension"},
    {"a : INT;", "a[1] := 1;", "INT is no array"},
    {"a : INT;", "a.x := 1;", "INT has no parts"},
    {"w : WORD;", "w.16 := TRUE;", "WORD has no bit 16"},
    {"a : INT;", "EXIT;", "EXIT and CONTINUE belong into a loop"},
    {"a : INT; b : BOOL;", "a := a + b;", "INT and BOOL do not go together"},
    {"a : BOOL;", "a := a + a;", "+ of BOOL"},
    {"t : TIME;", "t := 5;", "a duration is written T#5s"},
    {"t : TIME := T#5x;", "", "an initial value is a constant"},
    {"a : INT;", "CASE a OF b: a := 1; END_CASE;", "a label of CASE is a constant"},
    {"a : INT;", "a := (1 + ;", "a value is needed here, not ';'"},
    {"a : INT;", "IF TRUE THEN a := 1;", "'END_IF' is needed here"},
    {"a : INT;", "a := 1 END_IF;", "'END_IF' does not belong here"},
    {"a : INT", "a := 1;", "';' is needed here"},
    {"a : INT; a : BOOL;", "", "two variables are named a"},
    {"t : TON;", "t := 1;", "an instance cannot be assigned"},
    {"s : STRING; r : STRING;", "s := r;", "values of type STRING are not modelled"},
    {"a : INT;", "a := SEL(TRUE, 1);", "the arguments of SEL do not fit"},
    {"a : INT;", "(* open", "the comment has no end"},
    {"a : INT;", "a := 'open;", "the text has no closing mark"},
    {"a : UDINT; b : DINT;", "b := b + a;", "DINT and UDINT do not go together"},
    {"p AT %ZX0.0 : BOOL;", "", "%ZX0.0 is no address"},
};

TEST(IecReading, WrongTextsAreNamed) {
  for (const Wrong& wrong : wrongTexts) {
    const Program program =
        readIecText(iecProgram(std::string("VAR ") + wrong.declarations + " END_VAR", wrong.statements));
    EXPECT_NE(findingsIec(program).find(wrong.message), std::string::npos)
        << wrong.declarations << " / " << wrong.statements << "\n"
        << findingsIec(program);
    for (const Finding& finding : program.findings) EXPECT_EQ(finding.severity, Severity::Error);
  }
}

TEST(IecReading, AllErrorsAreToldInOneRun) {
  const Program program =
      readIecText(iecProgram("VAR a : INT; b : REAL; END_VAR", "a := b;\nc := 1;\na := 1;\nd := 2;"));
  ASSERT_EQ(program.findings.size(), 3U);
  EXPECT_EQ(program.sources->position(program.findings[0].span).line, 3U);
  EXPECT_EQ(program.sources->position(program.findings[1].span).line, 4U);
  EXPECT_EQ(program.sources->position(program.findings[2].span).line, 6U);
}

TEST(IecReading, NestingIsLimited) {  // and no stack is exhausted
  const std::string deep = std::string(100'000, '(') + "1" + std::string(100'000, ')');
  EXPECT_NE(
      findingsIec(readIecText(iecProgram("VAR a : INT; END_VAR", "a := " + deep + ";"))).find("nested too deeply"),
      std::string::npos);
  std::string loops;
  for (int i = 0; i < 100'000; ++i) loops += "IF TRUE THEN ";
  EXPECT_NE(findingsIec(readIecText(iecProgram("VAR a : INT; END_VAR", loops))).find("nested too deeply"),
            std::string::npos);
  std::string minus(100'000, '-');
  EXPECT_NE(
      findingsIec(readIecText(iecProgram("VAR a : INT; END_VAR", "a := " + minus + "1;"))).find("nested too deeply"),
      std::string::npos);
}

TEST(IecReading, DamagedTextsEndInMessages) {  // each prefix of a text, and each text without one character
  const std::string whole =
      iecProgram("VAR a : ARRAY [0..3] OF INT; t : TON; x : BOOL; END_VAR",
                 "IF x AND a[1] > 3 THEN t(IN := x, PT := T#5s); CASE a[0] OF 1, 2..3: a[0] := 5; END_CASE; END_IF;");
  for (std::size_t i = 0; i < whole.size(); ++i) {
    static_cast<void>(readIecText(whole.substr(0, i)));
    const Program program = readIecText(whole.substr(0, i) + whole.substr(i + 1));
    EXPECT_GT(program.sources->size(), 0U);
  }
}

TEST(IecReading, KeywordsAndNamesInAnyCase) {
  IecRun run("program Main var Counter : int; end_var COUNTER := counter + 1; end_program\n");
  run.scan();
  EXPECT_EQ(run.get("counter"), 1);
}

TEST(IecReading, PlcopenWithStatements) {
  const std::string body = "<![CDATA[IF x AND n < 3 THEN n := n + 1; END_IF;\nq := n >= 3;]]>";
  const auto project = [](const std::string& text) {
    return R"(<?xml version="1.0" encoding="utf-8"?>
<project xmlns="http://www.plcopen.org/xml/tc6_0201" xmlns:xhtml="http://www.w3.org/1999/xhtml"><types><dataTypes/><pous>
<pou name="light" pouType="program"><interface><inputVars><variable name="x"><type><BOOL/></type></variable></inputVars>
<localVars><variable name="n"><type><INT/></type></variable><variable name="q" address="%QX0.0"><type><BOOL/></type></variable></localVars></interface>
<body><ST><xhtml:p>)" +
           text + "</xhtml:p></ST></body></pou></pous></types></project>";
  };
  const IecOutput output =
      runIec({"sim", "--scans", "4", "--trace", "-", "--signals", "n,q"}, project(body), "light.xml");
  EXPECT_EQ(output.exit, 0) << output.text;
  // Entities keep the places of what follows them: the error is told in the line in which it stands.
  const IecOutput wrong = runIec({"lint"}, project("IF x &amp; (n &lt; 3) THEN\nn := y; END_IF;"), "light.xml");
  EXPECT_TRUE(wrong.has("there is no variable y") && wrong.has("light.xml:6:6")) << wrong.text;
}

}  // namespace
}  // namespace rungproof
