// What older firmware of the S7-200 SMART refuses: numbers that it lacks.
#include <gtest/gtest.h>

#include "ir/s7200/cpu.hpp"
#include "tests/rules/lint.hpp"

namespace rungproof::testing {
namespace {

std::size_t found(const char* rule, const char* cpu, Edition edition, const std::string& statements) {
  return Linted("Network 1\n" + statements, {*cpuNamed(cpu), edition}).of(rule).size();
}

TEST(SmartRefused, PulseOutputsAndPidLoopsThatOlderFirmwareLacks) {
  const std::string pulse = "LD SM0.1\nPLS 3\n", loop = "LD SM0.0\nPID VB100, 15\n";
  // The fourth pulse output of an ST60 and the loops 8 to 15 came with V2.8.
  EXPECT_EQ(found("ADR009", "ST60", Edition::Smart27, pulse), 1U);
  EXPECT_EQ(found("ADR009", "ST60", Edition::Smart28, pulse), 0U);
  EXPECT_EQ(found("ADR009", "ST60", Edition::Smart27, "LD SM0.1\nPLS 2\n"), 0U);
  EXPECT_EQ(found("ADR009", "ST40", Edition::Smart27, loop), 1U);
  EXPECT_EQ(found("ADR009", "ST40", Edition::Smart28, loop), 0U);
  EXPECT_EQ(found("ADR009", "ST40", Edition::Smart27, "LD SM0.0\nPID VB100, 7\n"), 0U);
  // A number that no firmware has is one finding: it is outside of the range of the operand.
  EXPECT_EQ(found("ADR009", "ST60", Edition::Smart27, "LD SM0.1\nPLS 4\n"), 0U);
}

}  // namespace
}  // namespace rungproof::testing
