// Which instructions are taken for one another.
#include "ir/instruction_slip.hpp"

#include <gtest/gtest.h>

#include "ir/target.hpp"

namespace rungproof {
namespace {

std::string slipsIn(std::string_view dialect, std::string_view mnemonic) {
  std::string text;
  for (const Dialect* each : dialects()) {
    if (each->name != dialect) continue;
    const Desc* desc = each->instructions().named(mnemonic);
    EXPECT_NE(desc, nullptr) << mnemonic;
    for (const Desc* slip : slipsOf(*desc, *each)) text += (text.empty() ? "" : " ") + std::string(slip->stl);
  }
  return text;
}

TEST(InstructionSlip, NeighboursOfEachFamily) {
  EXPECT_EQ(slipsIn("s7-200", "LDW>="), "LDW>");
  EXPECT_EQ(slipsIn("s7-200", "AB="), "AB<>");
  EXPECT_EQ(slipsIn("s7-200", "LD"), "");
  EXPECT_EQ(slipsIn("s7-300", "A"), "AN");
  EXPECT_EQ(slipsIn("s7-300", ">=I"), ">I");
  EXPECT_EQ(slipsIn("s7-300", "L"), "");
  EXPECT_EQ(slipsIn("iec", "AND"), "OR");
  EXPECT_EQ(slipsIn("iec", "LOAD"), "");
}

}  // namespace
}  // namespace rungproof
