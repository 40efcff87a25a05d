// Addresses of every area, width and spelling.
#include <gtest/gtest.h>

#include "frontend/stl/operand_reader.hpp"

namespace rungproof {
namespace {

std::string read(std::string_view text, Spelling spelling = Spelling::International) {
  const OperandResult result = readOperand(text, {spelling});
  return result.fault == OperandFault::None ? toString(result.operand) : "?";
}

TEST(OperandReader, EveryAreaAndWidth) {
  for (const char* text :
       {"I0.0",  "IB0",   "IW2",   "ID4",  "Q1.7", "QB1",    "QW0",  "QD0",  "V10.3", "VB0",   "VW10239",
        "VD4",   "M31.7", "MB1",   "MW2",  "MD28", "S0.0",   "SB1",  "SW2",  "SD4",   "SM0.0", "SMB34",
        "SMW22", "SMD38", "L63.7", "LB0",  "LW2",  "LD60",   "T0",   "T255", "C255",  "AC3",   "HC5",
        "AIW62", "AQW0",  "*VD10", "*LD4", "*AC1", "&VB100", "&IB0", "&T5",  "&C5",   "&AIW2", "&SMB30"}) {
    EXPECT_EQ(read(text), text);
  }
}

TEST(OperandReader, WidthsOfNumberedAreas) {
  Operand operand;
  ASSERT_TRUE(readAddress("T37", Spelling::International, operand));
  EXPECT_EQ(operand.width, Width::Bit);
  ASSERT_TRUE(readAddress("AC1", Spelling::International, operand));
  EXPECT_EQ(operand.width, Width::DWord);
  ASSERT_TRUE(readAddress("HC0", Spelling::International, operand));
  EXPECT_EQ(operand.width, Width::DWord);
  ASSERT_TRUE(readAddress("AIW4", Spelling::International, operand));
  EXPECT_EQ(operand.width, Width::Word);
}

TEST(OperandReader, German) {
  EXPECT_EQ(read("E0.0", Spelling::German), "I0.0");
  EXPECT_EQ(read("EW2", Spelling::German), "IW2");
  EXPECT_EQ(read("A1.0", Spelling::German), "Q1.0");
  EXPECT_EQ(read("AB0", Spelling::German), "QB0");
  EXPECT_EQ(read("AEW4", Spelling::German), "AIW4");
  EXPECT_EQ(read("AAW4", Spelling::German), "AQW4");
  EXPECT_EQ(read("Z5", Spelling::German), "C5");
  EXPECT_EQ(read("AC0", Spelling::German), "AC0");
  EXPECT_EQ(read("HC1", Spelling::German), "HC1");
  EXPECT_EQ(read("HZ1", Spelling::German), "HC1");
  EXPECT_EQ(read("SMB34", Spelling::German), "SMB34");
  EXPECT_EQ(read("&EB0", Spelling::German), "&IB0");
  EXPECT_EQ(read("I0.0", Spelling::German), "?");
}

TEST(OperandReader, ImpossibleBitsAreKeptForTheRules) {
  Operand operand;
  ASSERT_TRUE(readAddress("I0.9", Spelling::International, operand));
  EXPECT_EQ(operand.bit, 9);
  ASSERT_TRUE(readAddress("VW999999", Spelling::International, operand));
  EXPECT_EQ(operand.offset, 999999U);
}

TEST(OperandReader, Unreadable) {
  for (const char* text : {"", "I0.", "I.0", "I0.0.0", "VW1.0", "T1.0", "*VB0", "&V0.0", "&", "*", "%", "%x", "#", "#1",
                           "1x", "VB9999999999", "?x", "a-b", "a.b"}) {
    EXPECT_EQ(read(text), "?") << text;
  }
}

TEST(OperandReader, Names) {
  for (const char* text : {"Pump1", "_x", "Start_Button", "\xE5\x90\xAF\xE5\x8A\xA8", "#local", "*ptr", "&buffer",
                           "*#p", "K9", "M37", "SBR_0", "VB", "AI0", "*AC"}) {
    const OperandResult result = readOperand(text, {});
    EXPECT_EQ(result.fault, OperandFault::None) << text;
    EXPECT_EQ(result.operand.kind, OperandKind::Symbol) << text;
    EXPECT_EQ(result.operand.text, text);
    EXPECT_EQ(result.operand.value, -1) << text;  // never mistaken for routine 0
  }
}

TEST(OperandReader, MendedOperands) {
  const auto mend = [](std::string_view text, bool bitOnly = false) {
    return mendedOperand(text, Spelling::International, bitOnly);
  };
  EXPECT_EQ(mend("10.0", true), "I0.0");
  EXPECT_EQ(mend("10.0"), "I0.0");
  EXPECT_EQ(mend("QO.1", true), "Q0.1");
  EXPECT_EQ(mend("*VDlO"), "*VD10");
  EXPECT_EQ(mend("&VBlO"), "&VB10");
  EXPECT_EQ(mend("16#lO"), "16#10");
  EXPECT_EQ(mend("xyz"), "");
  EXPECT_EQ(mend("0.0", true), "");
  EXPECT_EQ(mend("20.0", true), "");
  EXPECT_EQ(mendedOperand("EO.0", Spelling::German, true), "E0.0");
}

}  // namespace
}  // namespace rungproof
