// What compilers of IEC 61131-3 take beyond the standard's text: results of TRUNC, chains of assignments, words that
// end a statement, the base of an enumeration. What is left out is named once, and the rest is read.
#include "tests/iec/iec_output.hpp"
#include "tests/iec/iec_run.hpp"

namespace rungproof {
namespace {

const std::string counting =
    "FUNCTION_BLOCK PUBLIC CNT\nVAR c : INT; END_VAR VAR_OUTPUT o : INT; END_VAR\n"
    "METHOD PUBLIC Add : BOOL\nVAR_INPUT k : INT; END_VAR\nc := c + k; Add := TRUE;\nEND_METHOD\no := c;\n"
    "PROPERTY Val : INT\nGET\nVal := c;\nEND_GET\nEND_PROPERTY\nEND_FUNCTION_BLOCK\n";

int toldTimes(const std::string& told, std::string_view part) {
  int times = 0;
  for (std::size_t at = told.find(part); at != std::string::npos; at = told.find(part, at + 1)) ++times;
  return times;
}

TEST(CodesysText, TruncGivesTheTypeOfItsPlace) {
  // 2.7 is cut to 2, -2.7 to -2, 300.9 to 300, of which nothing fits into a SINT.
  const std::string results =
      iecProgram("VAR_INPUT r : REAL; END_VAR VAR a : INT; b : USINT; c : LINT; d, e : INT; f : INT := 1; END_VAR",
                 "a := TRUNC(2.7); b := TRUNC(200.9); c := TRUNC(-2.7); d := f + TRUNC(3.5) * 2; e := TRUNC(r);");
  EXPECT_EQ(verdictOf(results, "a = 2 and b = 200 and c = -2 and d = 7"), "PROVED");
  // Out of the range of INT the result is any value, as that of REAL_TO_INT is; within it the number is the same.
  EXPECT_EQ(verdictOf(results, "r >= 7.0 and r < 8.0 implies e = 7"), "PROVED");
  EXPECT_EQ(verdictOf(results, "r = 40000.0 implies e = 32767"), "VIOLATED");
  EXPECT_EQ(verdictOf(results, "r = 40000.0 implies e = -25536"), "VIOLATED");
  // Compared, it is a DINT.
  const std::string compared =
      iecProgram("VAR_INPUT r : REAL; n : INT; END_VAR VAR q : BOOL; END_VAR", "q := TRUNC(r) > n;");
  EXPECT_EQ(verdictOf(compared, "r = 40000.0 implies q"), "PROVED");
  // A quotient is not the same in fewer bits.
  EXPECT_NE(findingsIec(readIecText(iecProgram("VAR a, b : INT; END_VAR", "a := (b + TRUNC(1.5)) / 2;")))
                .find("DINT does not fit into INT"),
            std::string::npos);
  // Other results of DINT still need a conversion.
  EXPECT_NE(findingsIec(readIecText(iecProgram("VAR a : INT; b : DINT; END_VAR", "a := b + TRUNC(1.5);")))
                .find("DINT does not fit into INT"),
            std::string::npos);
}

}  // namespace
}  // namespace rungproof
