// Functions of STRING on the engine: two bytes of length before the characters (002:2049-2058), positions from 1.
#include "tests/step7/step7_run.hpp"

namespace rungproof {
namespace {

constexpr const char* texts =
    "DATA_BLOCK DB 5\nSTRUCT\n  a : STRING [10] := 'Motor';\n  b : STRING [4] := 'ab';\n  c : STRING [12];\n"
    "  e : STRING [4] := '';\nEND_STRUCT;\nBEGIN\nEND_DATA_BLOCK\n";

/// DB5.c behind the call, and ENO.
std::string resultOf(const std::string& call) {
  const Step7Run run(texts, "CALL " + call + ", RET_VAL := DB5.c); A BR; = M 92.0;");
  EXPECT_TRUE(run.bit(92, 0)) << call;
  const auto byte = [&](std::uint32_t at) {
    return static_cast<char>(run.simulator.read(direct(Area::DB, Width::Byte, dataByte(5, 18 + at))));
  };
  EXPECT_EQ(byte(0), 12) << call;
  std::string text;
  for (char i = 0; i < byte(1); ++i) text += byte(2 + static_cast<std::uint32_t>(i));
  return text;
}

TEST(StringFunctions, PartsOfATextAndTextsOfParts) {
  EXPECT_EQ(resultOf("FC 2 (IN1 := DB5.a, IN2 := DB5.b"), "Motorab");
  EXPECT_EQ(resultOf("FC 2 (IN1 := DB5.b, IN2 := DB5.e"), "ab");
  EXPECT_EQ(resultOf("FC 4 (IN := DB5.a, L := 2, P := 2"), "Mor");
  EXPECT_EQ(resultOf("FC 17 (IN1 := DB5.a, IN2 := DB5.b, P := 3"), "Motabor");
  EXPECT_EQ(resultOf("FC 20 (IN := DB5.a, L := 3"), "Mot");
  EXPECT_EQ(resultOf("FC 26 (IN := DB5.a, L := 2, P := 3"), "to");
  EXPECT_EQ(resultOf("FC 31 (IN1 := DB5.a, IN2 := DB5.b, L := 3, P := 2"), "Mabr");
  EXPECT_EQ(resultOf("FC 32 (IN := DB5.a, L := 3"), "tor");
}

TEST(StringFunctions, LengthAndPlace) {
  const Step7Run run(
      texts,
      "CALL FC 21 (S := DB5.a, RET_VAL := MW 0); CALL FC 21 (S := DB5.e, RET_VAL := MW 2);\n"
      "CALL FC 26 (IN := DB5.a, L := 2, P := 4, RET_VAL := DB5.b);\n"  // 'or'
      "CALL FC 11 (IN1 := DB5.a, IN2 := DB5.b, RET_VAL := MW 4);\n"
      "CALL FC 20 (IN := DB5.b, L := 1, RET_VAL := DB5.c); CALL FC 11 (IN1 := DB5.a, IN2 := DB5.c, RET_VAL := MW 6);\n"
      "CALL FC 11 (IN1 := DB5.b, IN2 := DB5.a, RET_VAL := MW 8);");
  EXPECT_EQ(run.word(0), 5U);
  EXPECT_EQ(run.word(2), 0U);
  EXPECT_EQ(run.word(4), 4U);
  EXPECT_EQ(run.word(6), 2U);  // the first o of Motor
  EXPECT_EQ(run.word(8), 0U);
}

TEST(StringFunctions, ComparisonsByTheFirstDifference) {
  const std::string data =
      "DATA_BLOCK DB 5\nSTRUCT\n  a : STRING [4] := '{}';\n  b : STRING [6] := "
      "'{}';\nEND_STRUCT;\nBEGIN\nEND_DATA_BLOCK\n";
  struct Case {
    const char *x, *y;
    int order;
  };
  for (const Case& c :
       {Case{"abc", "abd", -1}, Case{"abc", "abc", 0}, Case{"b", "abc", 1}, Case{"ab", "abc", -1}, Case{"", "a", -1}}) {
    std::string calls;
    const int numbers[] = {10, 13, 15, 19, 24, 29};
    for (int i = 0; i < 6; ++i)
      calls += fmt::format("CALL FC {} (S1 := DB5.a, S2 := DB5.b, RET_VAL := M 0.{});\n", numbers[i], i);
    const Step7Run run(fmt::format(fmt::runtime(data), c.x, c.y), calls);
    const bool expected[] = {c.order == 0, c.order >= 0, c.order > 0, c.order <= 0, c.order < 0, c.order != 0};
    for (unsigned i = 0; i < 6; ++i) EXPECT_EQ(run.bit(0, i), expected[i]) << c.x << " " << c.y << " FC " << numbers[i];
  }
}

}  // namespace
}  // namespace rungproof
