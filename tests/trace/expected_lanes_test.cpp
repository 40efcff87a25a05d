// The expected curve beside the actual one: pairs of lanes, open where nothing is expected, marked where they differ.
#include "frontend/simulation/expected_lanes.hpp"

#include <gtest/gtest.h>

#include <sstream>

#include "tests/trace/traces.hpp"

namespace rungproof {
namespace {

Trace expectedTrace() {
  Trace expected;
  expected.signals = {sampleTrace().signals[1], sampleTrace().signals[2]};  // Q0.0 and VW10
  expected.rows = {{1, 0, 0, {0, std::nullopt}}, {2, 0, 0, {1, -5}}, {3, 0, 0, {1, 13}}};
  return expected;
}

TEST(ExpectedLanes, StandBehindTheLaneTheyBelongTo) {
  const TraceBeside beside = besideExpected(expectedTrace(), sampleTrace(), {});
  ASSERT_EQ(beside.trace.signals.size(), 7U);
  EXPECT_EQ(beside.lanes.of, (std::vector<int>{-1, -1, 1, -1, 3, -1, -1}));
  EXPECT_EQ(beside.trace.signals[2].name, "Q0.0");
  EXPECT_EQ(beside.trace.signals[2].symbol, "expected");
  ASSERT_EQ(beside.trace.rows.size(), 3U);
  EXPECT_EQ(beside.trace.rows[0].values[4], std::nullopt);
  EXPECT_EQ(beside.trace.rows[1].values[4], -5);
  // In scan 2 the output is 0 although 1 is expected, in scan 3 the word is 12 and not 13.
  EXPECT_EQ(beside.lanes.wrong[2], (std::vector<std::size_t>{1}));
  EXPECT_EQ(beside.lanes.wrong[4], (std::vector<std::size_t>{2}));
  EXPECT_TRUE(beside.lanes.wrong[1].empty());
}

TEST(ExpectedLanes, ToleranceIsNoDifference) {
  CompareOptions options;
  options.tolerances = {{"VW10", 1}};
  EXPECT_TRUE(besideExpected(expectedTrace(), sampleTrace(), options).lanes.wrong[4].empty());
}

TEST(ExpectedLanes, ThePageHoldsThem) {
  const TraceBeside beside = besideExpected(expectedTrace(), sampleTrace(), {});
  std::ostringstream page;
  writeTracePage(beside.trace, "run.csv", {}, page, beside.lanes);
  EXPECT_NE(page.str().find(R"({"name":"Q0.0 expected","bits":1,"of":1,"wrong":[1]})"), std::string::npos);
  EXPECT_NE(page.str().find(">Q0.0 expected</text>"), std::string::npos) << "without scripts too";
}

TEST(SignalNames, BySymbolOrByBoth) {
  EXPECT_EQ(named(sampleTrace(), SignalNames::Symbol).signals[1].name, "Motor");
  EXPECT_EQ(named(sampleTrace(), SignalNames::Both).signals[1].name, "Q0.0 Motor");
  EXPECT_EQ(named(sampleTrace(), SignalNames::Both).signals[0].name, "I0.0");
}

}  // namespace
}  // namespace rungproof
