// When inputs act and when a step is compared, with inputs early and late.
#include <gtest/gtest.h>

#include "engine/testing/test_player.hpp"
#include "frontend/testing/table_reader.hpp"

namespace rungproof {
namespace {

TestCase steps(const std::vector<TestWait>& waits) {
  TestCase test;
  for (const TestWait& wait : waits) test.rows.push_back({.wait = wait});
  return test;
}
const ScanLength tenMs = [](std::uint64_t) { return std::uint32_t{10000}; };

std::vector<std::pair<std::uint64_t, std::uint64_t>> timesOf(const TestCase& test, const ScanLength& length,
                                                             const std::vector<int>& skews) {
  std::vector<std::pair<std::uint64_t, std::uint64_t>> result;
  for (const StepTimes& times : stepTimesOf(test, length, skews)) result.emplace_back(times.acts, times.compares);
  return result;
}
using Times = std::vector<std::pair<std::uint64_t, std::uint64_t>>;

TEST(StepTimes, FollowEachOther) {
  EXPECT_EQ(timesOf(steps({{1, 0}, {5, 0}, {3, 0}}), tenMs, {}), (Times{{1, 1}, {2, 6}, {7, 9}}));
}

// The least number of scans that is not shorter: 500 ms are 50 scans of 10 ms, 8 of 70 ms, 5 of 100 ms.
TEST(StepTimes, TurnTimeIntoScans) {
  const TestCase test = steps({{1, 500000}});
  for (const auto& [us, scans] : {std::pair(10000U, 50U), std::pair(70000U, 8U), std::pair(100000U, 5U)})
    EXPECT_EQ(timesOf(test, [us = us](std::uint64_t) { return us; }, {}), (Times{{1, scans}})) << us;
}

// Early: the step before is compared before the inputs act. Late: its own step is compared at its end still.
TEST(StepTimes, KeepTheOrderUnderSkews) {
  const TestCase test = steps({{6, 0}, {6, 0}, {6, 0}});
  EXPECT_EQ(timesOf(test, tenMs, {0, -2, 2}), (Times{{1, 4}, {5, 12}, {15, 18}}));
  // Steps of one scan: inputs act one scan after the other at least, and no step is compared before its own inputs.
  EXPECT_EQ(timesOf(steps({{1, 0}, {1, 0}, {1, 0}}), tenMs, {2, -2, -2}), (Times{{3, 3}, {4, 4}, {5, 5}}));
}

TEST(Waits, AreReadAndWritten) {
  for (const char* text : {"1 scan", "5 scans", "500ms"}) {
    const std::optional<TestWait> wait = waitNamed(text);
    ASSERT_TRUE(wait) << text;
    EXPECT_EQ(waitText(*wait), text);
  }
  EXPECT_EQ(waitNamed("1.5 s")->timeUs, 1500000U);
  for (const char* text : {"", "5", "0 scans", "0ms", "-5ms", "2 days", "scan"}) EXPECT_FALSE(waitNamed(text)) << text;
}

}  // namespace
}  // namespace rungproof
