// FC 22 LIMIT, FC 25 MAX, FC 27 MIN, FC 36 SEL on the engine. Values by what the names say, with signs.
#include "tests/step7/step7_run.hpp"

namespace rungproof {
namespace {

constexpr const char* values =
    "DATA_BLOCK DB 5\nSTRUCT\n  i : ARRAY [1 .. 4] OF INT := -5, 7, 3, 0;\n"
    "  d : ARRAY [1 .. 4] OF DINT := L#-70000, L#70000, L#2, L#0;\n"
    "  r : ARRAY [1 .. 4] OF REAL := -1.5, 2.5, 0.25, 0.0;\n  b : ARRAY [0 .. 1] OF BYTE := B#16#11, B#16#22;\n"
    "  c : BYTE;\nEND_STRUCT;\nBEGIN\nEND_DATA_BLOCK\n";

std::string limited(const std::string& low, const std::string& in, const std::string& high, const std::string& out) {
  return "CALL FC 22 (MN := " + low + ", IN := " + in + ", MX := " + high + ", RET_VAL := " + out +
         "); A BR; = M 92.0;";
}
std::string extreme(int number, const std::string& of, int a, int b, int c) {
  return fmt::format(
      "CALL FC {0} (IN1 := DB5.{1}[{2}], IN2 := DB5.{1}[{3}], IN3 := DB5.{1}[{4}], RET_VAL := DB5.{1}[4]);", number, of,
      a, b, c);
}

TEST(Selection7, LimitKeepsAValueBetweenTwo) {
  for (const auto& [in, out] : {std::pair("DB5.i[1]", -5), {"DB5.i[2]", 3}, {"DB5.i[4]", 0}}) {  // -5 to 3
    const Step7Run run(values, limited("DB5.i[1]", in, "DB5.i[3]", "DB5.i[4]") + "L DB5.i[4]; T MW 0;");
    EXPECT_EQ(run.word(0), static_cast<std::uint16_t>(out)) << in;
    EXPECT_TRUE(run.bit(92, 0));
  }
}

TEST(Selection7, MaxAndMinOfThree) {
  const Step7Run run(values, extreme(25, "i", 1, 2, 3) + "L DB5.i[4]; T MW 0;" + extreme(27, "i", 3, 1, 2) +
                                 "L DB5.i[4]; T MW 2;" + extreme(25, "d", 1, 3, 2) + "L DB5.d[4]; T MD 4;" +
                                 extreme(27, "d", 2, 3, 1) + "L DB5.d[4]; T MD 8;" + extreme(25, "r", 3, 1, 2) +
                                 "L DB5.r[4]; T MD 12;" + extreme(27, "r", 1, 2, 3) + "L DB5.r[4]; T MD 16;");
  EXPECT_EQ(run.word(0), 7U);
  EXPECT_EQ(run.word(2), static_cast<std::uint16_t>(-5));
  EXPECT_EQ(run.at(Area::M, Width::DWord, 4), 70000U);
  EXPECT_EQ(run.at(Area::M, Width::DWord, 8), static_cast<std::uint32_t>(-70000));
  EXPECT_EQ(run.at(Area::M, Width::DWord, 12), Concrete::pattern(2.5F));
  EXPECT_EQ(run.at(Area::M, Width::DWord, 16), Concrete::pattern(-1.5F));
}

TEST(Selection7, SelTakesOneOfTwo) {
  for (const bool second : {false, true}) {
    const Step7Run run(values, std::string(second ? "SET" : "CLR") +
                                   "; = M 20.0; CALL FC 36 (G := M 20.0, IN0 := DB5.b[0], IN1 := DB5.b[1], "
                                   "RET_VAL := DB5.c); L DB5.c; T MB 0;");
    EXPECT_EQ(run.at(Area::M, Width::Byte, 0), second ? 0x22U : 0x11U);
  }
}

}  // namespace
}  // namespace rungproof
