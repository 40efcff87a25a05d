// Comparison of traces: first difference, don't care, tolerance, slack, rows by time.
#include "frontend/simulation/comparison.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "frontend/simulation/stimulus_reader.hpp"

namespace rungproof {
namespace {

Trace read(const std::string& text) {
  std::vector<Failure> failures;
  Trace trace = readTrace("t.csv", text, failures);
  for (const Failure& failure : failures) ADD_FAILURE() << failure.place << ": " << failure.message;
  return trace;
}

/// "equal", or "scan signal expected actual" of the first difference.
std::string compared(const std::string& expected, const std::string& actual, const CompareOptions& options = {}) {
  const Trace e = read(expected), a = read(actual);
  const Comparison c = comparisonOf(e, a, firstDifference(e, a, options));
  if (c.equal) return "equal";
  return fmt::format("{} {} {} {}", c.scan, c.signal, c.expected, c.actual);
}

const std::string actual =
    "scan,time_ms,scan_ms,A,B,W\n1,10,10,0,0,100\n2,20,10,1,0,100\n3,30,10,1,1,103\n4,45,15,0,1,103\n5,55,10,0,0,103\n";

TEST(Comparison, EqualTraces) { EXPECT_EQ(compared(actual, actual), "equal"); }

TEST(Comparison, FirstDifferenceByScanThenByColumn) {
  EXPECT_EQ(compared("scan,A,B\n2,1,0\n3,0,0\n4,1,1\n", actual), "3 A 0 1");
  EXPECT_EQ(compared("scan,B,A\n3,0,0\n", actual), "3 B 0 1");
}

TEST(Comparison, EmptyCellsAndXMatchAnything) { EXPECT_EQ(compared("scan,A,B\n1,,x\n3,X,1\n", actual), "equal"); }

TEST(Comparison, ToleranceBelongsToItsSignal) {
  CompareOptions options;
  options.tolerances = {{"w", 3}};
  EXPECT_EQ(compared("scan,W\n1,103\n2,97\n3,100\n", actual, options), "equal");
  EXPECT_EQ(compared("scan,W\n1,104\n", actual, options), "1 W 104 100");
  EXPECT_EQ(compared("scan,W,A\n1,103,1\n", actual, options), "1 A 1 0");
}

TEST(Comparison, SlackShiftsByScans) {
  const std::string late = "scan,B\n2,1\n5,1\n";
  EXPECT_EQ(compared(late, actual), "2 B 1 0");
  CompareOptions options;
  options.slack = 1;
  EXPECT_EQ(compared(late, actual, options), "equal");
  EXPECT_EQ(compared("scan,B\n1,1\n", actual, options), "1 B 1 0");
}

// The scans end at 10, 20, 30, 45 and 55 ms, which are the times that a trace tells of them.
TEST(Comparison, TimesFallIntoTheScanThatEndsWithThem) {
  EXPECT_EQ(
      compared("time_ms,A,B\n0,0,0\n10,0,0\n10.1,1,0\n20,1,0\n29.9,1,1\n30,1,1\n30.1,0,1\n45,0,1\n55,0,0\n", actual),
      "equal");
  EXPECT_EQ(compared("time_ms,A\n10,1\n", actual), "1 A 1 0");
}

// A logger saw at 10, 30 and 45 ms what the scans that begin there leave, and at 55 ms what the last one has left.
TEST(Comparison, TimesOfALoggerFallIntoTheScanThatBeginsWithThem) {
  const std::string logger = "Time [ms],A,B\n0,0,0\n10,1,0\n29.9,1,1\n30,0,1\n44,0,1\n45,0,0\n55,0,0\n";
  EXPECT_EQ(compared(logger, actual), "equal");
  EXPECT_EQ(compared("scan,time_ms,scan_ms,A\n1,10,10,0\n2,20,10,1\n3,30,10,1\n4,45,15,0\n", logger), "equal");
}

// The same run told by its scans, by its times, and by both.
TEST(Comparison, ATraceEqualsItsTimes) {
  const std::string both = "scan,time_ms,A\n1,10,0\n2,20,1\n3,30,1\n4,45,0\n5,55,0\n";
  const std::string times = "time_ms,A\n10,0\n20,1\n30,1\n45,0\n55,0\n";
  for (const std::string& expected : {both, times}) {
    for (const std::string& seen : {both, times}) EXPECT_EQ(compared(expected, seen), "equal") << expected << seen;
  }
}

TEST(Comparison, RowsBeyondTheEndDiffer) {
  EXPECT_EQ(compared("scan,A\n6,0\n", actual), "6 A 0 nan");
  EXPECT_EQ(compared("time_ms,A\n55.1,0\n", actual), "0 A 0 nan");
  EXPECT_EQ(compared("scan,A\n6,\n", actual), "equal");
}

TEST(Comparison, TracesByTimeHoldTheirValues) {
  const std::string steps = "time_ms,A\n0,0\n20,1\n60,0\n";
  EXPECT_EQ(compared("time_ms,A\n0,0\n19,0\n20,1\n59.9,1\n60,0\n", steps), "equal");
  EXPECT_EQ(compared("time_ms,A\n20,0\n", steps), "0 A 0 1");
}

TEST(Comparison, ShowsTheScansAround) {
  const Trace e = read("scan,A,B,W\n2,1,0,\n4,1,1,103\n"), a = read(actual);
  const Comparison c = comparisonOf(e, a, firstDifference(e, a, {}));
  EXPECT_EQ(c.scan, 4);
  EXPECT_EQ(c.timeMs, 45);
  EXPECT_EQ(c.signals, (std::vector<std::string>{"A", "B", "W"}));
  ASSERT_EQ(c.around.size(), 5U);
  EXPECT_EQ(c.around[1].expected, (std::vector<std::string>{"1", "0", ""}));
  EXPECT_EQ(c.around[3].actual, (std::vector<std::string>{"0", "1", "103"}));
  EXPECT_EQ(c.around[4].expected, (std::vector<std::string>{"", "", ""}));
}

TEST(Comparison, LargeAndBrokenNumbersAreComparedExactly) {
  EXPECT_EQ(compared("scan,A\n1,16777217\n", "scan,A\n1,16777216\n"), "1 A 16777217 16777216");
  EXPECT_EQ(compared("scan,A\n1,0.1\n", "scan,A\n1,0.1\n"), "equal");
}

TEST(Tolerance, ReadsSignalAndValue) {
  const Trace expected = read("scan,Speed\n1,1\n");
  Failure failure;
  const std::optional<Tolerance> tolerance = toleranceIn("Speed=0.5", expected, failure);
  ASSERT_TRUE(tolerance);
  EXPECT_EQ(tolerance->value, 0.5);
  for (const std::string bad : {"Speed", "Speed=", "=1", "Speed=-1", "Speed=1x", "Sped=1"})
    EXPECT_FALSE(toleranceIn(bad, expected, failure)) << bad;
  EXPECT_EQ(failure.help, "did you mean 'Speed'?");
}

}  // namespace
}  // namespace rungproof
