// EU and ED: no edge in the first scan, one pulse per change, memory of skipped occurrences.
#include <gtest/gtest.h>

#include "plant.hpp"

namespace rungproof::manual {
namespace {

std::uint64_t scanWith(Bench& bench, std::string_view input, bool value, std::string_view output) {
  bench.set(input, value);
  return bench.scan().value(output);
}

TEST(Edge, RisingEdgePulsesForOneScan) {
  Bench bench({"LD I0.0", "EU", "= Q0.0"});
  EXPECT_EQ(scanWith(bench, "I0.0", false, "Q0.0"), 0U);
  EXPECT_EQ(scanWith(bench, "I0.0", true, "Q0.0"), 1U);
  EXPECT_EQ(scanWith(bench, "I0.0", true, "Q0.0"), 0U);
  EXPECT_EQ(scanWith(bench, "I0.0", false, "Q0.0"), 0U);
  EXPECT_EQ(scanWith(bench, "I0.0", true, "Q0.0"), 1U);
}

TEST(Edge, FallingEdgePulsesForOneScan) {
  Bench bench({"LD I0.0", "ED", "= Q0.0"});
  EXPECT_EQ(scanWith(bench, "I0.0", false, "Q0.0"), 0U);
  EXPECT_EQ(scanWith(bench, "I0.0", true, "Q0.0"), 0U);
  EXPECT_EQ(scanWith(bench, "I0.0", false, "Q0.0"), 1U);
  EXPECT_EQ(scanWith(bench, "I0.0", false, "Q0.0"), 0U);
}

TEST(Edge, FirstScanOnlyStores) {
  // 001:2763: an input that is already 1 gives no EU pulse; its fall in the second scan is an ED.
  Bench rising({"LD I0.0", "EU", "= Q0.0"});
  EXPECT_EQ(scanWith(rising, "I0.0", true, "Q0.0"), 0U);
  EXPECT_EQ(scanWith(rising, "I0.0", true, "Q0.0"), 0U);
  Bench falling({"LD I0.0", "ED", "= Q0.0"});
  EXPECT_EQ(scanWith(falling, "I0.0", true, "Q0.0"), 0U);
  EXPECT_EQ(scanWith(falling, "I0.0", false, "Q0.0"), 1U);
  // Even a memory of 1 from an earlier RUN gives no ED in the first scan.
  Bench old({"LD I0.0", "ED", "= Q0.0"});
  old.store.set(Reg::EdgeMemory, 0, 1, true);
  EXPECT_EQ(scanWith(old, "I0.0", false, "Q0.0"), 0U);
}

TEST(Edge, EachOccurrenceHasItsOwnMemoryAndKeepsOtherLevels) {
  Bench bench({"LD I0.1", "LD I0.0", "EU", "= Q0.0", "LD I0.2", "EU", "= Q0.1", "LPP", "LPP", "= Q0.2"});
  bench.set("IB0", 0);
  bench.scan();
  bench.set("IB0", 0b011);
  bench.scan();
  EXPECT_EQ(bench.value("QB0"), 0b101U) << "edge of I0.0 alone, I0.1 untouched below";
  bench.set("IB0", 0b111);
  bench.scan();
  EXPECT_EQ(bench.value("QB0"), 0b110U) << "edge of I0.2 alone";
}

TEST(Edge, ExampleOfContactsNetwork3) {
  // 001:2768: I0.4 with EU sets Q0.3 and pulses Q0.4, with ED resets Q0.3 and pulses Q0.5.
  Bench bench({"LD I0.4", "LPS", "EU", "S Q0.3, 1", "= Q0.4", "LPP", "ED", "R Q0.3, 1", "= Q0.5"});
  bench.scan();
  EXPECT_EQ(scanWith(bench, "I0.4", true, "QB0"), 0b011000U);
  EXPECT_EQ(scanWith(bench, "I0.4", true, "QB0"), 0b001000U);
  EXPECT_EQ(scanWith(bench, "I0.4", false, "QB0"), 0b100000U);
  EXPECT_EQ(scanWith(bench, "I0.4", false, "QB0"), 0U);
}

TEST(Edge, LaterFirstExecutionFollowsTheChoice) {
  // The occurrence stands in an interrupt routine that first runs after the first scan.
  for (const bool stores : {false, true}) {
    Bench bench({"LD SM0.0"}, {}, {"LD I0.0", "EU", "= Q0.0"});
    ASSERT_TRUE(bench.choices.set("first-edge", stores ? "first-execution" : "first-scan-only"));
    bench.set("I0.0", 1);
    bench.scan();
    EXPECT_EQ(bench.interrupt().value("Q0.0"), stores ? 0U : 1U);
    EXPECT_EQ(bench.interrupt().value("Q0.0"), 0U);
    bench.set("I0.0", 0);
    bench.scan();  // not executed: the memory stays 1
    bench.set("I0.0", 1);
    EXPECT_EQ(bench.interrupt().value("Q0.0"), 0U);
    bench.set("I0.0", 0);
    bench.interrupt();
    bench.set("I0.0", 1);
    EXPECT_EQ(bench.interrupt().value("Q0.0"), 1U);
  }
  // A memory of 1 from an earlier RUN is a fall for ED, unless the first execution only stores.
  for (const bool stores : {false, true}) {
    Bench bench({"LD SM0.0"}, {}, {"LD I0.0", "ED", "= Q0.0"});
    ASSERT_TRUE(bench.choices.set("first-edge", stores ? "first-execution" : "first-scan-only"));
    bench.scan();
    bench.store.set(Reg::EdgeMemory, 0, 1, true);
    EXPECT_EQ(bench.interrupt().value("Q0.0"), stores ? 0U : 1U);
    bench.set("I0.0", 1);
    EXPECT_EQ(bench.interrupt().value("Q0.0"), 0U);
    bench.set("I0.0", 0);
    EXPECT_EQ(bench.interrupt().value("Q0.0"), 1U);
  }
}

}  // namespace
}  // namespace rungproof::manual
