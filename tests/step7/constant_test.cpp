// Constants of STEP 7: the forms and ranges of 002:1951-1959 and 003:885-897, each with its bits.
#include <gtest/gtest.h>

#include <bit>

#include "frontend/step7/constant_parser.hpp"

namespace rungproof::step7 {
namespace {

using s7300::ConstantKind;

ConstantOutcome outcomeOf(const std::string& text, MnemonicSet set = MnemonicSet::International) {
  Cursor cursor(text, 0);
  return readConstant(cursor, set, TextEncoding::Utf8);
}

std::int64_t valueOf(const std::string& text) {
  const ConstantOutcome outcome = outcomeOf(text);
  EXPECT_TRUE(outcome.constant.has_value()) << text << ": " << outcome.fault;
  return outcome.constant ? outcome.constant->value : -1;
}

TEST(Constants, NumbersOfEachForm) {
  EXPECT_EQ(valueOf("5"), 5);
  EXPECT_EQ(valueOf("-33"), -33);
  EXPECT_EQ(valueOf("L#-5"), -5);
  EXPECT_EQ(valueOf("L#2147483647"), 2147483647);
  EXPECT_EQ(valueOf("2#1010_0000"), 0xA0);
  EXPECT_EQ(valueOf("B#16#10"), 0x10);
  EXPECT_EQ(valueOf("W#16#ffff"), 0xFFFF);
  EXPECT_EQ(valueOf("word#16#1000"), 0x1000);
  EXPECT_EQ(valueOf("DW#16#00A2_1234"), 0xA21234);
  EXPECT_EQ(valueOf("B#(10,20)"), 0x0A14);
  EXPECT_EQ(valueOf("B#(1, 14, 100, 120)"), 0x010E6478);
  EXPECT_EQ(valueOf("C#998"), 0x998);
  EXPECT_EQ(valueOf("TRUE"), 1);
  EXPECT_EQ(valueOf("false"), 0);
  EXPECT_EQ(valueOf("INT#7"), 7);
}

TEST(Constants, RealNumbers) {
  EXPECT_EQ(valueOf("1.0"), 0x3F800000);
  EXPECT_EQ(valueOf("1.000000e+000"), 0x3F800000);
  EXPECT_EQ(valueOf("-0.5"), 0xBF000000);
  EXPECT_EQ(valueOf("1.234567e+13"), std::bit_cast<std::uint32_t>(1.234567e+13F));
  EXPECT_EQ(outcomeOf("1e3").constant->kind, ConstantKind::Real);
  EXPECT_NE(outcomeOf("1.0e+39").fault, "");
}

TEST(Constants, TimesOfTimers) {
  // 003:1016-1043: the smallest base that holds the value, rounded down.
  EXPECT_EQ(valueOf("S5T#2S"), 0x0200);
  EXPECT_EQ(valueOf("S5TIME#1H_1M_0S_0MS"), 0x3366);  // 3660 s in steps of 10 s
  EXPECT_EQ(valueOf("S5T#250MS"), 0x0025);
  EXPECT_EQ(valueOf("s5t#1s500ms"), 0x0150);
  EXPECT_EQ(valueOf("S5T#2M7S"), 0x2127);  // the 127 s of the lost drawing
  EXPECT_EQ(valueOf("S5T#9S_995MS"), 0x0999);
  EXPECT_EQ(valueOf("S5T#10S"), 0x1100);
  EXPECT_EQ(valueOf("S5T#2H_46M_30S"), 0x3999);
  EXPECT_NE(outcomeOf("S5T#2H46M31S").fault, "");
  EXPECT_NE(outcomeOf("S5T#5").fault, "");
  EXPECT_NE(outcomeOf("S5T#5MS1S").fault, "");
}

TEST(Constants, DurationsAndDates) {
  EXPECT_EQ(valueOf("T#1D"), 86400000);
  EXPECT_EQ(valueOf("TIME#0D_1H_1M_0S_0MS"), 3660000);
  EXPECT_EQ(valueOf("T#-1ms"), 0xFFFFFFFF);
  EXPECT_EQ(valueOf("T#24D_20H_31M_23S_647MS"), 2147483647);
  EXPECT_NE(outcomeOf("T#25D").fault, "");
  EXPECT_EQ(valueOf("D#1990-1-1"), 0);
  EXPECT_EQ(valueOf("D#2009-4-1"), 7030);  // 002:2599
  EXPECT_EQ(valueOf("D#2008-4-1"), 6665);
  EXPECT_NE(outcomeOf("D#2009-2-30").fault, "");
  EXPECT_EQ(valueOf("TOD#1:10:3.3"), 4203300);
  EXPECT_NE(outcomeOf("TOD#24:0:0").fault, "");
  // 002:1998-2029: Saturday 31 May 2008, 20:59:59.999.
  EXPECT_EQ(valueOf("DT#2008-5-31-20:59:59.999"), 0x0805312059599997);
  EXPECT_EQ(valueOf("DT#08-5-31-20:59:59.999"), 0x0805312059599997);
  // 25 December 1993 was a Saturday too.
  EXPECT_EQ(static_cast<std::uint64_t>(valueOf("DATE_AND_TIME#1993-12-25-8:01:1.23")), 0x9312250801012307);
}

TEST(Constants, TextWithEscapes) {
  const auto text = [](const std::string& written) { return outcomeOf(written).constant->text; };
  EXPECT_EQ(text("'E'"), "E");
  EXPECT_EQ(text("'it$'s'"), "it's");
  EXPECT_EQ(text("'a$$b$0D$N'"), "a$b\r\n");
  EXPECT_NE(outcomeOf("'open").fault, "");
}

TEST(Constants, Pointers) {
  EXPECT_EQ(valueOf("P#30.0"), 240);
  EXPECT_EQ(valueOf("P#M 40.0"), 0x83000140);
  EXPECT_EQ(valueOf("P#DBX 0.0"), 0x84000000);
  EXPECT_EQ(valueOf("P#8191.7"), 0xFFFF);
  const ConstantOutcome any = outcomeOf("P#DB10.DBX 30.0 INT 22");  // 002:2239
  ASSERT_TRUE(any.constant.has_value());
  EXPECT_EQ(any.constant->kind, ConstantKind::Any);
  EXPECT_EQ(any.constant->block, 10);
  EXPECT_EQ(any.constant->anyType, 5);
  EXPECT_EQ(any.constant->anyCount, 22);
  EXPECT_EQ(any.constant->value, 0x840000F0);
  EXPECT_EQ(outcomeOf("P#I20.0 WORD 1").constant->value, 0x810000A0);
  EXPECT_EQ(outcomeOf("P#P 0.0 VOID 0").constant->value, 0x80000000);
  // The letters follow the mnemonics of the source.
  EXPECT_EQ(outcomeOf("P#A 4.0", MnemonicSet::German).constant->value, 0x82000020);
  EXPECT_NE(outcomeOf("P#A 4.0").fault, "");
  EXPECT_NE(outcomeOf("P#4").fault, "");
  EXPECT_NE(outcomeOf("P#4.8").fault, "");
}

TEST(Constants, RangesAreKept) {
  for (const std::string text : {"B#16#100", "W#16#1_0000", "DW#16#1_0000_0000", "C#1000", "L#2147483648", "B#(1,2,3)",
                                 "B#(1,256)", "W#16#", "2#", "INT#32768", "5x", "FOO#1"})
    EXPECT_NE(outcomeOf(text).fault, "") << text;
}

TEST(Constants, OtherThingsAreNone) {
  for (const std::string text : {"MW 10", "\"name\"", "#name", "P##name", "label", ""}) {
    const ConstantOutcome outcome = outcomeOf(text);
    EXPECT_FALSE(outcome.constant.has_value()) << text;
    EXPECT_EQ(outcome.fault, "") << text;
  }
}

TEST(Constants, BitsInTheAccumulator) {
  const auto bits = [](const std::string& text) { return s7300::accumulatorBits(*outcomeOf(text).constant); };
  EXPECT_EQ(bits("-1"), 0x0000FFFFu);  // an INT fills the right half
  EXPECT_EQ(bits("L#-1"), 0xFFFFFFFFu);
  EXPECT_EQ(bits("'?'"), 0x3Fu);
  EXPECT_EQ(bits("'abcd'"), 0x61626364u);
  EXPECT_EQ(bits("1.0"), 0x3F800000u);
  EXPECT_EQ(bits("S5T#2S"), 0x0200u);
}

}  // namespace
}  // namespace rungproof::step7
