// The images of a standard SMART have a gap: bytes 0 to 31 belong to the modules, bytes 128 to 1279 to PROFINET
// (smart-operand-ranges.tsv). A row of bytes that begins in front of the gap ends there.
#include <gtest/gtest.h>

#include "ir/address_limit.hpp"
#include "ir/s7200/cpu.hpp"
#include "tests/environment/asked.hpp"
#include "tests/rules/lint.hpp"

namespace rungproof {
namespace {

const Target st60{s7200Cpu("ST60"), Edition::Smart28}, cr40{s7200Cpu("CR40s"), Edition::Smart28};

bool finds(const char* rule, const std::string& line, const Target& target) {
  const testing::Linted linted(
      "ORGANIZATION_BLOCK MAIN:OB1\nBEGIN\nNetwork 1\nLD SM0.0\n" + line + "\nEND_ORGANIZATION_BLOCK\n", target);
  return !linted.of(rule).empty();
}

TEST(SmartImageGap, RowsEndAtTheGap) {
  EXPECT_EQ(rowEnd(st60, Area::Q, 0), 32U);
  EXPECT_EQ(rowEnd(st60, Area::I, 31), 32U);
  EXPECT_EQ(rowEnd(st60, Area::Q, 128), 1280U);
  EXPECT_EQ(rowEnd(st60, Area::M, 0), 32U) << "no gap: the area ends";
  EXPECT_EQ(rowEnd(cr40, Area::Q, 0), 32U) << "a compact CPU has no second part";
  EXPECT_EQ(rowEnd(Target{}, Area::Q, 0), 16U) << "nor has an S7-200";
}

/// QW30 and three words more would be QW32 to QW36; eight bits from Q31.4 would end at Q32.3.
TEST(SmartImageGap, WhatRunsOutOfThemIsFound) {
  for (const Target& target : {st60, cr40}) {
    EXPECT_TRUE(finds("PTR004", "FILL 0, QW30, 4", target));
    EXPECT_TRUE(finds("PTR004", "BMB IB30, VB0, 4", target));
    EXPECT_TRUE(finds("ADR001", "S Q31.4, 8", target));
  }
  // These end at byte 31.
  EXPECT_FALSE(finds("PTR004", "FILL 0, QW28, 2", st60));
  EXPECT_FALSE(finds("ADR001", "S Q31.4, 4", st60));
  EXPECT_FALSE(finds("PTR004", "FILL 0, QW128, 4", st60)) << "behind the gap";
}

/// Three words, and two are left in front of the gap: error 0091. What is moved then is open in the manual.
TEST(SmartImageGap, AProofMeetsTheError) {
  const auto under = [](const std::string& reading) {
    return test::verdict(test::Asked{.program = "LD SM0.0;MOVB 3,VB0;BMW VW10, QW28, VB0",
                                     .property = "QW28 = 0",
                                     .choices = "block-move-range=" + reading,
                                     .declarations = "external VW10",
                                     .target = st60});
  };
  EXPECT_EQ(under("nothing"), Outcome::Proved);
  EXPECT_EQ(under("up-to-the-end"), Outcome::Violated);
}

}  // namespace
}  // namespace rungproof
