// How long a scan of an S7-300/400 takes by its statements: long programs are no time error, endless loops are one.
#include <gtest/gtest.h>

#include "engine/simulator.hpp"
#include "frontend/input/project.hpp"

namespace rungproof::test {
namespace {

/// The error that ends the first scan of an OB1, if one does.
std::optional<Hazard> endOf(const std::string& statements) {
  const Program program =
      readText("ob1.awl", "ORGANIZATION_BLOCK OB 1\nBEGIN\nNETWORK\n" + statements + "END_ORGANIZATION_BLOCK\n");
  for (const Finding& finding : program.findings) EXPECT_NE(finding.severity, Severity::Error) << finding.message;
  Simulator simulator(program);
  simulator.scan();
  const RunTimeError* fatal = simulator.errors().fatal();
  return fatal == nullptr ? std::nullopt : std::optional(fatal->hazard);
}

// 60,000 statements take less than 150 ms on every CPU of the families: 2.5 us for each would be an S7-200's.
TEST(CycleTime, ALongProgramIsNoTimeError) {
  std::string text;
  for (int i = 0; i < 30000; ++i) text += "L MW 10;\nT MW 12;\n";
  EXPECT_EQ(endOf(text), std::nullopt);
}

TEST(CycleTime, ALoopWithoutEndOutlastsTheCycleMonitoring) {
  EXPECT_EQ(endOf("again: L MW 10;\nT MW 12;\nJU again;\n"), Hazard::S7CycleTime);  // 002:1296
}

// LOOP with 0 makes 65,536 rounds (002:2809), which is long, but no error by itself.
TEST(CycleTime, TheLongestLoopIsNoTimeError) { EXPECT_EQ(endOf("L 0;\nagain: LOOP again;\n"), std::nullopt); }

}  // namespace
}  // namespace rungproof::test
