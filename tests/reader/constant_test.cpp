// Constants of table 4-2 (001:1425-1431) and beyond.
#include <gtest/gtest.h>

#include <bit>

#include "frontend/stl/constant_reader.hpp"

namespace rungproof {
namespace {

std::int64_t value(std::string_view text) {
  const ConstantResult result = readConstant(text);
  EXPECT_EQ(result.fault, ConstantFault::None) << text;
  return result.operand.value;
}
float real(std::string_view text) {
  const ConstantResult result = readConstant(text);
  EXPECT_EQ(result.operand.form, ConstantForm::Real) << text;
  return std::bit_cast<float>(static_cast<std::uint32_t>(result.operand.value));
}
ConstantFault fault(std::string_view text) { return readConstant(text).fault; }

TEST(Constant, ManualExamples) {
  EXPECT_EQ(value("20047"), 20047);
  EXPECT_EQ(value("16#4E4F"), 0x4E4F);
  EXPECT_EQ(value("2#1010_0101_1010_0101"), 0xA5A5);
  EXPECT_EQ(value("'ABCD'"), 0x41424344);
  EXPECT_FLOAT_EQ(real("+1.175495E-38"), 1.175495E-38F);
  EXPECT_FLOAT_EQ(real("64000.0"), 64000.0F);
  EXPECT_FLOAT_EQ(real("1.012E-006"), 1.012E-6F);  // 000:2197
  EXPECT_EQ(readConstant("\"ABCDE\"").operand.text, "ABCDE");
  EXPECT_EQ(readConstant("\xC2\xAB"
                         "ABCDE\xC2\xBB")
                .operand.text,
            "ABCDE");  // 001:1431
}

TEST(Constant, Integers) {
  EXPECT_EQ(value("+100"), 100);
  EXPECT_EQ(readConstant("+100").operand.form, ConstantForm::SignedDecimal);
  EXPECT_EQ(readConstant("100").operand.form, ConstantForm::Decimal);
  EXPECT_EQ(value("-32768"), -32768);
  EXPECT_EQ(value("007"), 7);
  EXPECT_EQ(value("4294967295"), 4294967295LL);
  EXPECT_EQ(value("-2147483648"), -2147483648LL);
  EXPECT_EQ(value("16#ffffffff"), 0xFFFFFFFFLL);
  EXPECT_EQ(value("16#063D0043E"), 0x63D0043ELL);  // nine digits with a leading zero (dialect notes 9.3)
  EXPECT_EQ(fault("4294967296"), ConstantFault::TooLarge);
  EXPECT_EQ(fault("-2147483649"), ConstantFault::TooLarge);
  EXPECT_EQ(fault("16#10000000000000000"), ConstantFault::TooLarge);
  EXPECT_EQ(fault("12a"), ConstantFault::BadDigits);
  EXPECT_EQ(fault("16#G"), ConstantFault::BadDigits);
  EXPECT_EQ(fault("2#2"), ConstantFault::BadDigits);
  EXPECT_EQ(fault("2#_"), ConstantFault::Empty);
  EXPECT_EQ(fault("8#7"), ConstantFault::BadBase);
}

TEST(Constant, Reals) {
  EXPECT_FLOAT_EQ(real("-1.5"), -1.5F);
  EXPECT_FLOAT_EQ(real(".5"), 0.5F);
  EXPECT_FLOAT_EQ(real("5."), 5.0F);
  EXPECT_FLOAT_EQ(real("1e3"), 1000.0F);
  EXPECT_FLOAT_EQ(real("1E-60"), 0.0F);
  EXPECT_EQ(fault("1E60"), ConstantFault::TooLarge);
  EXPECT_EQ(fault("1.5.2"), ConstantFault::BadDigits);
  EXPECT_EQ(fault("1.5x"), ConstantFault::BadDigits);
}

TEST(Constant, TypedAndBoolean) {
  EXPECT_EQ(value("B#16#1F"), 0x1F);
  EXPECT_EQ(value("DW#12345"), 12345);  // 001:6811
  EXPECT_EQ(value("WORD#16#FFFF"), 0xFFFF);
  EXPECT_EQ(value("byte#200"), 200);
  EXPECT_EQ(value("INT#-5"), -5);
  EXPECT_EQ(readConstant("DW#5").operand.width, Width::DWord);
  EXPECT_EQ(readConstant("W#5").operand.form, ConstantForm::Typed);
  EXPECT_EQ(toString(readConstant("W#5").operand), "W#5");
  EXPECT_EQ(fault("B#256"), ConstantFault::DoesNotFit);
  EXPECT_EQ(fault("B#"), ConstantFault::Empty);
  EXPECT_EQ(fault("B#x"), ConstantFault::BadDigits);
  EXPECT_EQ(value("TRUE"), 1);
  EXPECT_EQ(value("off"), 0);
  EXPECT_EQ(readConstant("ON").operand.form, ConstantForm::Boolean);
}

TEST(Constant, Texts) {
  EXPECT_EQ(*unquoted("\"a$\"b$$c$'\""), "a\"b$c'");
  EXPECT_EQ(*unquoted("'$L$P$R$T$N'"), "\n\f\r\t\n");
  EXPECT_EQ(*unquoted("'$41$0D'"), "A\r");
  EXPECT_EQ(*unquoted("\"\""), "");
  EXPECT_FALSE(unquoted("\"abc").has_value());
  EXPECT_FALSE(unquoted("\"abc\"d").has_value());
  EXPECT_EQ(value("'A'"), 0x41);
  EXPECT_EQ(value("'$00A'"), 0x41);
  EXPECT_EQ(fault("'ABCDE'"), ConstantFault::TooLong);
  EXPECT_EQ(fault("''"), ConstantFault::Empty);
}

TEST(Constant, OtherThings) {
  for (const char* text : {"VB10", "", "+", "abc", "#local", "K9", "&VB1"})
    EXPECT_EQ(fault(text), ConstantFault::NotAConstant) << text;
}

TEST(Constant, PrintsAsItIsRead) {
  for (const char* text : {"12", "+12", "-12", "16#FF", "2#1010", "1.5", "1e+10", "'AB'", "'$$$'a'", "\"a$\"b\"",
                           "\"$E9\"", "DW#7", "B#1", "TRUE", "FALSE", "'A$00'"}) {
    const ConstantResult first = readConstant(text);
    ASSERT_EQ(first.fault, ConstantFault::None) << text;
    const ConstantResult second = readConstant(toString(first.operand));
    EXPECT_EQ(second.operand.value, first.operand.value) << text;
    EXPECT_EQ(second.operand.form, first.operand.form) << text;
    EXPECT_EQ(second.operand.text, first.operand.text) << text;
  }
}

}  // namespace
}  // namespace rungproof
