// Texts: what the functions of the standard give, character by character.
#include "tests/iec/iec_output.hpp"
#include "tests/iec/iec_run.hpp"

namespace rungproof {
namespace {

/// Whether the text that the expression gives is the expected one, and is as long.
void expectText(const std::string& expression, const std::string& expected, std::size_t length) {
  IecRun run(iecProgram("VAR s : STRING; same : BOOL; n : INT; abc : STRING := 'ABCDEF'; empty : STRING; END_VAR",
                        "s := " + expression + "; same := s = '" + expected + "'; n := LEN(s);"));
  run.scan();
  EXPECT_EQ(run.get("same"), 1) << expression;
  EXPECT_EQ(run.get("n"), static_cast<double>(length)) << expression;
}
double resultOfText(const std::string& expression) {
  IecRun run(iecProgram("VAR r : INT; b : BOOL; abc : STRING := 'ABCDEF'; short : STRING[3]; END_VAR", expression));
  run.scan();
  return run.get("r") + run.get("b");
}

TEST(IecText, FunctionsCutAndJoin) {  // positions count from 1
  expectText("abc", "ABCDEF", 6);
  expectText("LEFT(abc, 2)", "AB", 2);
  expectText("LEFT(abc, 9)", "ABCDEF", 6);
  expectText("LEFT(abc, 0)", "", 0);
  expectText("LEFT(abc, -1)", "", 0);
  expectText("RIGHT(abc, 2)", "EF", 2);
  expectText("RIGHT(abc, 6)", "ABCDEF", 6);
  expectText("RIGHT(abc, 7)", "ABCDEF", 6);
  expectText("MID(abc, 2, 3)", "CD", 2);  // the length comes first
  expectText("MID(IN := abc, L := 2, P := 3)", "CD", 2);
  expectText("MID(abc, 9, 6)", "F", 1);
  expectText("MID(abc, 1, 7)", "", 0);
  expectText("CONCAT(abc, '-', empty, 'x')", "ABCDEF-x", 8);
  expectText("INSERT(abc, 'xy', 2)", "ABxyCDEF", 8);  // behind position 2
  expectText("INSERT(abc, 'xy', 0)", "xyABCDEF", 8);
  expectText("INSERT(abc, 'xy', 6)", "ABCDEFxy", 8);
  expectText("DELETE(abc, 2, 3)", "ABEF", 4);
  expectText("DELETE(abc, 9, 3)", "AB", 2);
  expectText("REPLACE(abc, 'xyz', 2, 3)", "ABxyzEF", 7);
  expectText("REPLACE(abc, '', 1, 1)", "BCDEF", 5);
  expectText("SEL(LEN(abc) > 5, 'no', 'yes')", "yes", 3);
  expectText("CONCAT(SEL(FALSE, 'no', abc), SEL(G := TRUE, IN0 := 'a', IN1 := 'b'))", "nob", 3);
  expectText("LEFT(CONCAT(RIGHT(abc, 3), abc), 5)", "DEFAB", 5);
  expectText("'a$'b$$c$41'", "a$'b$$cA", 6);
}

TEST(IecText, FindLengthAndOrder) {
  EXPECT_EQ(resultOfText("r := FIND(abc, 'CD');"), 3);
  EXPECT_EQ(resultOfText("r := FIND(abc, 'CE');"), 0);
  EXPECT_EQ(resultOfText("r := FIND('AABAAC', 'AAC');"), 4);  // a part that fits does not hide the whole
  EXPECT_EQ(resultOfText("r := FIND(abc, 'EFG');"), 0);
  EXPECT_EQ(resultOfText("r := LEN(short);"), 0);
  EXPECT_EQ(resultOfText("b := 'AB' < 'ABC';"), 1);
  EXPECT_EQ(resultOfText("b := 'AB' = 'ABC';"), 0);
  EXPECT_EQ(resultOfText("b := 'B' > 'ABC' AND 'ABC' >= 'ABC' AND 'ABC' <= 'ABD' AND 'A' <> 'a';"), 1);
  EXPECT_EQ(resultOfText("b := GT('C', 'B', 'A');"), 1);
}

TEST(IecText, WhatDoesNotFitIsCutOff) {
  EXPECT_EQ(resultOfText("short := abc; r := LEN(short); b := short = 'ABC';"), 4);
  EXPECT_EQ(resultOfText("short := abc; short := 'Z'; b := short = 'Z'; r := LEN(CONCAT(short, short));"), 3);
}

TEST(IecText, FunctionsAndBlocksTakeAndGiveTexts) {
  IecRun run(
      "FUNCTION twice : STRING VAR_INPUT s : STRING; END_VAR twice := CONCAT(s, s); END_FUNCTION\n"
      "FUNCTION_BLOCK keep VAR_INPUT in : STRING; END_VAR VAR_OUTPUT out : STRING; n : INT; END_VAR\n"
      "out := CONCAT(out, in); n := LEN(out); END_FUNCTION_BLOCK\n" +
      iecProgram("VAR k : keep; s : STRING; b : BOOL; END_VAR",
                 "s := twice(twice('ab')); k(in := 'x', out => s); b := CONCAT(twice('a'), twice('b')) = 'aabb';"));
  run.scan();
  run.scan();
  EXPECT_EQ(run.get("k.n"), 2);
  EXPECT_EQ(run.get("b"), 1);
}

TEST(IecText, ProofsKnowTexts) {  // each scan one character more, up to four
  const std::string text = iecProgram("VAR_INPUT up : BOOL; END_VAR VAR s : STRING[4]; n : INT; full : BOOL; END_VAR",
                                      "IF up THEN s := CONCAT(s, 'a'); END_IF; n := LEN(s); full := s = 'aaaa';");
  EXPECT_EQ(verdictOf(text, "always n >= 0 and n <= 4"), "PROVED");
  EXPECT_EQ(verdictOf(text, "always full = (n = 4)"), "PROVED");
  EXPECT_EQ(verdictOf(text, "never full"), "VIOLATED");
}

TEST(IecText, AFreeTextIsAnyText) {
  const std::string text = iecProgram("VAR_INPUT s : STRING[2]; END_VAR VAR n : INT; b : BOOL; END_VAR",
                                      "n := LEN(s); b := LEFT(s, 1) = 'x';");
  EXPECT_EQ(verdictOf(text, "always n <= 2"), "PROVED");
  EXPECT_EQ(verdictOf(text, "never n = 2"), "VIOLATED");
  EXPECT_EQ(verdictOf(text, "always b implies n > 0"), "PROVED");
}

// Digits without leading zeros, a minus sign in front: so do MatIEC and CODESYS. What else becomes a text differs.
TEST(IecText, WholeNumbersAndTruthValuesBecomeTexts) {
  expectText("INT_TO_STRING(0)", "0", 1);
  expectText("INT_TO_STRING(-7)", "-7", 2);
  expectText("INT_TO_STRING(32767)", "32767", 5);
  expectText("INT_TO_STRING(-32768)", "-32768", 6);
  expectText("SINT_TO_STRING(-128)", "-128", 4);
  expectText("USINT_TO_STRING(255)", "255", 3);
  expectText("UINT_TO_STRING(65535)", "65535", 5);
  expectText("DINT_TO_STRING(-2147483648)", "-2147483648", 11);
  expectText("DINT_TO_STRING(1000000000)", "1000000000", 10);
  expectText("UDINT_TO_STRING(4294967295)", "4294967295", 10);
  expectText("BOOL_TO_STRING(n = 0)", "TRUE", 4);
  expectText("BOOL_TO_STRING(n = 1)", "FALSE", 5);
  expectText("TO_STRING(n)", "0", 1);
  expectText("CONCAT('n = ', INT_TO_STRING(IN := 40 + 2), '!')", "n = 42!", 7);
}

// Of two calls in one expression each has its own text.
TEST(IecText, MadeTextsDoNotMeet) {
  expectText("CONCAT(INT_TO_STRING(12), INT_TO_STRING(345))", "12345", 5);
  EXPECT_EQ(resultOfText("b := INT_TO_STRING(9) < INT_TO_STRING(10);"), 0) << "'9' stands behind '10'";
}

TEST(IecText, TextsOfNumbersAreProved) {
  const std::string text = iecProgram("VAR_INPUT low : BOOL; END_VAR VAR n, l : INT; s : STRING; b : BOOL; END_VAR",
                                      "n := SEL(low, 7, -12); s := INT_TO_STRING(n); l := LEN(s); b := s = '-12';");
  EXPECT_EQ(verdictOf(text, "always b = low and (b = (l = 3))"), "PROVED");
}

TEST(IecText, WhatIsNotModelledIsNamed) {
  const auto said = [](const std::string& statements) {
    return findingsIec(readIecText(iecProgram("VAR s : STRING; w : WSTRING; i : INT; b : BOOL; END_VAR", statements)));
  };
  for (const std::string conversion : {"REAL_TO_STRING(1.5)", "WORD_TO_STRING(16#FF)", "LINT_TO_STRING(5)",
                                       "TIME_TO_STRING(T#5s)", "DATE_TO_STRING(D#2026-01-01)", "TO_STRING(1.5)"}) {
    const std::string name = conversion.substr(0, conversion.find('('));
    EXPECT_NE(said("s := " + conversion + ";").find(name + ": texts that it makes are not modelled"), std::string::npos)
        << said("s := " + conversion + ";");
  }
  for (const std::string conversion : {"STRING_TO_INT", "STRING_TO_REAL", "STRING_TO_BOOL", "STRING_TO_TIME"})
    EXPECT_NE(said("b := " + conversion + "(s) = " + conversion + "(s);").find(": conversions of STRING"),
              std::string::npos)
        << conversion;
  EXPECT_NE(said("w := w;").find("values of type WSTRING are not modelled"), std::string::npos);
  EXPECT_NE(said("s := i;").find("INT is no text"), std::string::npos);
  EXPECT_NE(said("i := s;").find("STRING is no value here"), std::string::npos);
  EXPECT_NE(said("s := 'a$q';").find("is no text of a STRING"), std::string::npos);
  EXPECT_NE(said("i := LEN(i);").find("INT is no text"), std::string::npos);
}

}  // namespace
}  // namespace rungproof
