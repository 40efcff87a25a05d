// What the S7-200 SMART refuses and the S7-200 does not: numbers that older firmware lacks, and a logic stack that is
// empty.
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

TEST(SmartRefused, LevelsOfTheStackThatNothingHasLoaded) {
  for (const char* statements :
       {"LD I0.0\nALD\n= Q0.0\n", "LD I0.0\nOLD\n= Q0.0\n", "LPP\n= Q0.0\n", "= Q0.0\n", "A I0.0\n= Q0.0\n"}) {
    EXPECT_EQ(found("STK007", "ST40", Edition::Smart28, statements), 1U) << statements;
    EXPECT_EQ(found("STK002", "ST40", Edition::Smart28, statements), 0U) << statements;
    EXPECT_EQ(found("STK007", "226", Edition::Edition2004, statements), 0U) << statements;
    EXPECT_EQ(found("STK002", "226", Edition::Edition2004, statements), 1U) << statements;
  }
  // What an earlier network has left is there, however odd that is.
  const std::string left = "LD I0.0\n= Q0.0\nNetwork 2\nA I0.1\n= Q0.1\n";
  EXPECT_EQ(found("STK007", "ST40", Edition::Smart28, left), 0U);
  EXPECT_EQ(found("STK002", "ST40", Edition::Smart28, left), 1U);
}

}  // namespace
}  // namespace rungproof::testing
