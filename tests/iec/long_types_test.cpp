// Types of 64 bits: LINT, ULINT, LWORD, LREAL, LTIME, in the engine and in properties.
#include <cmath>

#include "tests/iec/iec_output.hpp"
#include "tests/iec/iec_run.hpp"

namespace rungproof {
namespace {

/// The value of `r` behind one scan of the statements.
double resultOf(const std::string& type, const std::string& declarations, const std::string& statements) {
  IecRun run(iecProgram("VAR r : " + type + "; " + declarations + " END_VAR", statements));
  run.scan();
  return run.get("r");
}

TEST(IecLong, WholeNumbersHave64Bits) {
  EXPECT_EQ(resultOf("LINT", "a : LINT := 5000000000;", "r := a + 1;"), 5000000001.0);
  EXPECT_EQ(resultOf("LINT", "a : LINT := 3000000000;", "r := -a * 2;"), -6000000000.0);
  EXPECT_EQ(resultOf("LINT", "a : LINT := -7;", "r := a / 2;"), -3);    // cut towards zero
  EXPECT_EQ(resultOf("LINT", "a : LINT := -7;", "r := a MOD 3;"), -1);  // the sign of the dividend
  EXPECT_EQ(resultOf("ULINT", "a : ULINT := 0;", "r := (a - 1) / 4294967296;"), 4294967295.0);  // (2^64 - 1) / 2^32
  EXPECT_EQ(resultOf("DINT", "a : DINT := 2147483647;", "r := LINT_TO_DINT(DINT_TO_LINT(a) + 1);"), -2147483648.0);
  EXPECT_EQ(resultOf("LINT", "a : DINT := -5;", "r := a;"), -5);  // widened by its sign
  EXPECT_EQ(resultOf("BOOL", "a : ULINT := 18446744073709551615;", "r := a > 9223372036854775807;"), 1);
  EXPECT_EQ(resultOf("BOOL", "a : LINT := -1;", "r := a < 0;"), 1);
}

TEST(IecLong, BitStringsShiftAndRotate) {
  EXPECT_EQ(resultOf("LWORD", "a : LWORD := 1;", "r := SHL(a, 40);"), std::ldexp(1.0, 40));
  EXPECT_EQ(resultOf("LWORD", "a : LWORD := 16#8000_0000_0000_0001;", "r := ROL(a, 1);"), 3);
  EXPECT_EQ(resultOf("LWORD", "a : LWORD := 1;", "r := SHR(ROR(a, 1), 63);"), 1);
  EXPECT_EQ(resultOf("LWORD", "a : LWORD := 1;", "r := SHL(a, 64);"), 0);
  EXPECT_EQ(resultOf("BOOL", "a : LWORD := 16#1_0000_0000;", "r := a.32;"), 1);
  EXPECT_EQ(resultOf("BYTE", "a : LWORD := 16#1122_3344_5566_7788;", "r := a.%B6;"), 0x22);
  EXPECT_EQ(resultOf("DWORD", "a : DWORD := 16#11223344;", "a.%W1 := 16#AABB; r := a;"), double{0xAABB3344U});
  EXPECT_EQ(resultOf("INT", "a : INT := -8;", "r := SHR(a, 1);"), -4);  // the sign comes in from above
}

TEST(IecLong, ElementsOfArraysAreFound) {
  EXPECT_EQ(resultOf("LINT", "a : ARRAY [1..4] OF LINT; i : INT;",
                     "FOR i := 1 TO 4 DO a[i] := INT_TO_LINT(i) * 4294967296; END_FOR; i := 3; r := a[i];"),
            3 * 4294967296.0);
}

TEST(IecLong, AnIndexBeyond32BitsIsOutside) {  // 2^32 + 1 is no 1; by the usual reading that ends the scan
  IecRun run(iecProgram("VAR a : ARRAY [0..3] OF INT; i : LINT := 4294967297; n : INT; END_VAR",
                        "n := 1; n := a[i]; n := 2;"));
  run.scan();
  EXPECT_EQ(run.get("n"), 1);
}

TEST(IecLong, LongRealsAreDoubles) {
  EXPECT_EQ(resultOf("LREAL", "a : LREAL := 0.1;", "r := a + 0.2;"), 0.1 + 0.2);
  EXPECT_EQ(resultOf("LREAL", "a : LREAL := 2.0;", "r := SQRT(a);"), std::sqrt(2.0));
  EXPECT_EQ(resultOf("LREAL", "a : REAL := 0.1;", "r := a;"), static_cast<double>(0.1F));
  EXPECT_EQ(resultOf("REAL", "a : LREAL := 0.1;", "r := LREAL_TO_REAL(a);"), static_cast<double>(0.1F));
  EXPECT_EQ(resultOf("DINT", "a : LREAL := 2.5;", "r := LREAL_TO_DINT(a);"), 2);  // halves to the even number
  EXPECT_EQ(resultOf("DINT", "a : LREAL := -2.7;", "r := TRUNC(a);"), -2);
  EXPECT_EQ(resultOf("LINT", "a : LREAL := 1.0E15;", "r := LREAL_TO_LINT(a);"), 1e15);
  EXPECT_EQ(resultOf("LREAL", "a : LINT := 9007199254740993;", "r := a;"), 9007199254740992.0);  // to the even one
  EXPECT_EQ(resultOf("LREAL", "a : LREAL := -1.5;", "r := MAX(ABS(a), 1.0);"), 1.5);
  EXPECT_EQ(resultOf("LREAL", "a : LREAL := -1.5; b : INT := 2;", "r := -a * b;"), 3);
  EXPECT_EQ(resultOf("BOOL", "a : LREAL := -0.0;", "r := a = 0.0;"), 1);
  EXPECT_EQ(resultOf("BOOL", "a : LREAL; n : LREAL;", "n := a / a; r := (n = n) OR (n < 1.0) OR NOT (n <> n);"), 0);
  EXPECT_EQ(resultOf("BOOL", "a : LREAL := -2.0; b : LREAL := -1.0;", "r := a < b AND b > a AND a <= a;"), 1);
}

TEST(IecLong, FunctionsOfRealsThatAreComputedAsLong) {
  EXPECT_EQ(resultOf("REAL", "a : REAL := 2.0;", "r := a ** 3.0;"), 8);
  EXPECT_EQ(resultOf("REAL", "a : REAL := 3.0;", "r := EXPT(a, 2);"), 9);
  EXPECT_EQ(resultOf("REAL", "a : REAL := 100.0;", "r := LOG(a);"), 2);
  EXPECT_EQ(resultOf("DINT", "a : REAL := -1.5;", "r := FLOOR(a);"), -2);
  EXPECT_EQ(resultOf("DINT", "a : REAL := -1.5;", "r := CEIL(a);"), -1);
}

TEST(IecLong, LongDurationsCountNanoseconds) {
  EXPECT_EQ(resultOf("LTIME", "", "r := LTIME#1d2h3m4s5.6ms;"), 93784005.6e6);
  EXPECT_EQ(resultOf("LTIME", "t : TIME := T#5ms;", "r := t + LTIME#1ns;"), 5000001);
  EXPECT_EQ(resultOf("TIME", "a : LTIME := LT#7500us;", "r := LTIME_TO_TIME(a);"), 7);  // cut
  EXPECT_EQ(resultOf("LTIME", "a : LTIME := LT#3us;", "r := a * 3 / 2;"), 4500);
  EXPECT_EQ(resultOf("TIME", "", "r := T#5s * 1.5;"), 7500);
  EXPECT_EQ(resultOf("TIME", "", "r := MULTIME(T#1s, 3);"), 3000);
  EXPECT_EQ(resultOf("TIME", "", "r := T# 30000ms;"), 30000);
}

TEST(IecLong, PropertiesCompareThem) {
  const std::string text =
      iecProgram("VAR_INPUT up : BOOL; END_VAR VAR n : LINT := 5000000000; x : LREAL := 0.5; u : ULINT; END_VAR",
                 "IF up AND n < 5000000003 THEN n := n + 1; x := 0.1; END_IF;");
  EXPECT_EQ(verdictOf(text, "always n >= 5000000000 and n <= 5000000003"), "PROVED");
  EXPECT_EQ(verdictOf(text, "never n = 5000000003"), "VIOLATED");
  EXPECT_EQ(verdictOf(text, "always x = 0.5 or x = 0.1"), "PROVED");
  EXPECT_EQ(verdictOf(text, "always x > 0.1"), "VIOLATED");
  EXPECT_EQ(verdictOf(text, "always x <= 0.5 and u = 0 and n - 5000000000 < 4"), "PROVED");
}

/// 2^63 and 2^64 - 1 are no negative numbers.
TEST(IecLong, PropertiesCompareNumbersWithoutASign) {
  const std::string text = iecProgram(
      "VAR_INPUT u, v : ULINT; n : LINT; END_VAR VAR w : LWORD := 16#8000_0000_0000_0001; a : ULINT; END_VAR",
      "a := MAX(u, 9223372036854775808);");
  EXPECT_EQ(verdictOf(text, "always w = 16#8000_0000_0000_0001"), "PROVED");
  EXPECT_EQ(verdictOf(text, "always w = 9223372036854775809 and w > 9223372036854775808"), "PROVED");
  EXPECT_EQ(verdictOf(text, "never w = 1"), "PROVED");
  EXPECT_EQ(verdictOf(text, "always a >= 9223372036854775808 and prev(a) >= 1 and a > 9223372036854775807"), "PROVED");
  EXPECT_EQ(verdictOf(text, "always u >= 0"), "PROVED");
  EXPECT_EQ(verdictOf(text, "always u <= 18446744073709551614"), "VIOLATED");  // 2^64 - 1
  EXPECT_EQ(verdictOf(text, "always u <= v or v < u"), "PROVED");
  EXPECT_EQ(verdictOf(text, "never u = n and n < 0"), "PROVED");
  EXPECT_EQ(verdictOf(text, "always n < 0 implies n < u"), "PROVED");
  EXPECT_EQ(verdictOf(text, "never u = n and n > 0"), "VIOLATED");
  EXPECT_EQ(verdictOf(text, "always n < 18446744073709551615"), "PROVED");
  // Beside a number with a sign a pattern has one too: 16#FFFF_FFFF_FFFF_FFFF is -1.
  EXPECT_EQ(verdictOf(text, "never n = 16#FFFF_FFFF_FFFF_FFFF and n >= 0"), "PROVED");
  EXPECT_EQ(verdictOf(text, "never n = 16#FFFF_FFFF_FFFF_FFFF"), "VIOLATED");
}

TEST(IecLong, OfNumbersWithoutASignNothingIsComputed) {
  const std::string text = iecProgram("VAR_INPUT u : ULINT; r : LREAL; END_VAR VAR q : BOOL; END_VAR", "q := u > 3;");
  for (const char* const property :
       {"always u + 1 > 0", "never -u = 3", "always r < u", "always 2 * 18446744073709551615 > u"})
    EXPECT_NE(verdictOf(text, property).find("without a sign can be compared with whole numbers, nothing else"),
              std::string::npos)
        << property;
  EXPECT_NE(verdictOf(text, "never u = 18446744073709551616").find("is larger than any number of the program"),
            std::string::npos);
}

TEST(IecLong, ResultsOfLongRealsAreAnyNumberInProofs) {  // what is not modelled proves nothing
  const std::string text = iecProgram("VAR_INPUT up : BOOL; END_VAR VAR x : LREAL := 1.0; b : BOOL; END_VAR",
                                      "IF up THEN x := x * 0.5; END_IF; b := x < 2.0;");
  EXPECT_EQ(verdictOf(text, "always b"), "NOT COVERED");
  EXPECT_EQ(verdictOf(text, "always b = (x < 2.0)"), "PROVED");
}

TEST(IecLong, LiteralsThatDoNotFitAreNamed) {
  const auto said = [](const std::string& declarations, const std::string& statements) {
    return findingsIec(readIecText(iecProgram("VAR " + declarations + " END_VAR", statements)));
  };
  EXPECT_NE(said("a : LINT;", "a := 9223372036854775808;").find("9223372036854775808 does not fit into LINT"),
            std::string::npos);
  EXPECT_NE(said("a : ULINT;", "a := -1;").find("-1 does not fit into ULINT"), std::string::npos);
  EXPECT_NE(said("a : LINT;", "a := 99999999999999999999;").find("does not fit into 64 bits"), std::string::npos);
  EXPECT_NE(said("a : LTIME;", "a := LT#1.5ns;").find("no duration of whole nanoseconds"), std::string::npos);
  EXPECT_NE(said("a : REAL; b : LREAL;", "a := b;").find("LREAL does not fit into REAL"), std::string::npos);
  EXPECT_NE(said("a : ULINT; b : LINT;", "b := b + a;").find("LINT and ULINT do not go together"), std::string::npos);
}

}  // namespace
}  // namespace rungproof
