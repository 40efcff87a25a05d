// The exact meaning of temporal statements, on hand-written traces. Each row of a trace is one scan end; the
// expected verdict per scan is argued from the meanings in analysis/property.hpp.
#include "analysis/encoding/monitor.hpp"

#include <gtest/gtest.h>

#include <random>

#include "engine/concrete.hpp"
#include "frontend/property/property_reader.hpp"

namespace rungproof {
namespace {

std::optional<Operand> bitNamed(std::string_view name) {
  return direct(Area::M, Width::Bit, 0, static_cast<unsigned>(name[0] - 'a'));
}

/// Bits a..h by scan, and what dt was.
struct Row {
  const char* set;
  std::uint64_t dt = 10;
};

struct Silent final : Outside {
  std::uint64_t external(const ExternalSite&, int) override { return 0; }
  void report(Hazard, const Instruction*) override {}
};

/// One character a scan: 1 where the monitor answers true.
std::string run(const std::string& statement, const std::vector<Row>& rows) {
  PropertySet set;
  std::vector<Finding> findings;
  readPropertyText(0, statement, 0, bitNamed, set, findings);
  if (!findings.empty()) return findings[0].message;
  const Property& property = set.properties.at(0);
  Silent outside;
  Concrete domain(outside);
  std::vector<std::uint64_t> before(property.cells.size(), 0), after(property.cells.size(), 0);
  std::string result;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const std::string_view on = rows[i].set;
    const auto leaf = [&](const Operand& o, int) -> std::uint64_t {
      return on.find(static_cast<char>('a' + o.bit)) != std::string_view::npos;
    };
    result +=
        Monitor<Concrete, decltype(leaf)>(domain, property, leaf, {i == 0, rows[i].dt, 16}, before, after).evaluate()
            ? '1'
            : '0';
    before = after;
  }
  return result;
}

TEST(Monitor, NoEdgeInTheFirstScan) {
  EXPECT_EQ(run("reach r: rises(a)", {{"a"}, {"a"}, {""}, {"a"}}), "0001");
  EXPECT_EQ(run("reach r: falls(a)", {{""}, {"a"}, {""}, {""}}), "0010");
  EXPECT_EQ(run("reach r: prev(a)", {{"a"}, {""}, {""}, {"a"}}), "1100")
      << "prev is the value itself in the first scan";
}

TEST(Monitor, OnceAndSince) {
  EXPECT_EQ(run("reach r: once(a)", {{""}, {"a"}, {""}}), "011");
  EXPECT_EQ(run("reach r: since(a, b)", {{"a"}, {"b"}, {"a"}, {""}, {"a"}, {"ab"}}), "011001")
      << "b once, then a in every scan after it";
}

// Scan ends at 10, 20, ... : a from scan 2 (t=20); held 20 ms is met at t=40.
TEST(Monitor, HeldCountsBetweenScanEnds) {
  EXPECT_EQ(run("reach r: held(a, 20ms)", {{""}, {"a"}, {"a"}, {"a"}, {""}, {"a"}, {"a"}}), "0001000");
  EXPECT_EQ(run("reach r: held(a, 20ms)", {{"a"}, {"a", 19}, {"a", 1}}), "001")
      << "compared exactly: 19 ms are not enough";
  EXPECT_EQ(run("prove p: a held 20ms implies b", {{"a"}, {"a"}, {"a"}, {"ab"}}), "0010");
}

// P in scan 1: Q in scan 1, 2 or 3 is in time for "within 2 scans".
TEST(Monitor, LeadsToWithinScans) {
  EXPECT_EQ(run("prove p: a leads to b within 2 scans", {{"a"}, {""}, {"b"}, {""}}), "0000");
  EXPECT_EQ(run("prove p: a leads to b within 2 scans", {{"a"}, {""}, {""}, {"b"}}), "0010");
  EXPECT_EQ(run("prove p: a leads to b within 0 scans", {{"a"}, {"ab"}}), "10");
  EXPECT_EQ(run("prove p: a leads to b within 2 scans", {{"a"}, {"a"}, {"a"}, {"a"}}), "0011")
      << "the oldest trigger decides; it stays broken";
}

// P at the end of scan 1; the limit of 20 ms is met at the end of scan 3 and passed at the end of scan 4.
TEST(Monitor, LeadsToWithinTime) {
  EXPECT_EQ(run("prove p: a leads to b within 20ms", {{"a"}, {""}, {"b"}, {""}}), "0000");
  EXPECT_EQ(run("prove p: a leads to b within 20ms", {{"a"}, {""}, {""}, {"b"}}).substr(0, 4), "0001")
      << "an answer at the first scan end after the limit is too late";
  EXPECT_EQ(run("prove p: a leads to b within 20ms", {{"a"}, {"b", 21}}), "01");
}

TEST(Monitor, OnlyAfterAndUnless) {
  EXPECT_EQ(run("prove p: a only after b", {{""}, {"a"}, {"ab"}, {"a"}}), "0100");
  EXPECT_EQ(run("prove p: a unless b", {{"a"}, {"a"}, {"b"}, {""}, {"a"}, {""}}), "000001");
  EXPECT_EQ(run("prove p: a unless b", {{"ab"}, {""}}), "00") << "with b already true nothing is owed";
}

TEST(Monitor, PulseKeepsEdgesApart) {
  EXPECT_EQ(run("pulse a at most every 50ms", {{""}, {"a"}, {""}, {"a", 30}}), "1110")
      << "the second edge comes after 40 ms";
  EXPECT_EQ(run("pulse a at most every 50ms", {{""}, {"a"}, {""}, {"a", 40}}), "1111") << "50 ms apart is allowed";
}

/// Answers at the ends of scans of the given lengths, with clocks that count in `base` ms from time 0 on.
std::string answers(Property property, int base, const std::vector<std::pair<unsigned, std::uint64_t>>& scans) {
  property.timeBase = base;
  layoutCells(property);
  Silent outside;
  Concrete domain(outside);
  std::vector<std::uint64_t> before(property.cells.size(), 0), after(property.cells.size(), 0);
  std::string result;
  std::uint64_t now = 0;
  for (const auto& [bits, length] : scans) {
    const auto unit = static_cast<std::uint64_t>(base);
    const std::uint64_t ticks = (now + length) / unit - now / unit;
    now += length;
    const Moment<Concrete> moment{result.empty(), ticks, 32, now % unit};
    const auto leaf = [&, pattern = bits](const Operand& o, int) -> std::uint64_t { return pattern >> o.bit & 1U; };
    result += Monitor<Concrete, decltype(leaf)>(domain, property, leaf, moment, before, after).evaluate() ? '1' : '0';
    before = after;
  }
  return result;
}

// A clock in ticks of 10 or 100 ms with the digits at its start says the same as one in ms, for every statement that
// measures time: 400 random runs with bits that stay for a while.
TEST(Monitor, CoarseClocksAreExact) {
  const unsigned seed = 20261122;
  SCOPED_TRACE(testing::Message() << "seed " << seed);
  std::mt19937 random(seed);
  for (int round = 0; round < 400; ++round) {
    const int limit = static_cast<int>(random() % 3 == 0 ? random() % 12 : random() % 900);
    const std::string ms = std::to_string(limit) + "ms";
    const std::string texts[] = {"prove p: a held " + ms + " implies b", "prove p: b or held(a, " + ms + ")",
                                 "prove p: a leads to b within " + ms, "pulse M0.0 at most every " + ms};
    PropertySet set;
    std::vector<Finding> findings;
    readPropertyText(
        0, texts[round % 4], 0, [](std::string_view name) { return name == "M0.0" ? bitNamed("a") : bitNamed(name); },
        set, findings);
    ASSERT_TRUE(findings.empty()) << texts[round % 4] << ": " << findings[0].message;
    std::vector<std::pair<unsigned, std::uint64_t>> scans;
    unsigned bits = random() % 4;
    const unsigned change = 1 + random() % 6, longest = random() % 2 == 0 ? 30 : 260;
    for (int scan = 0; scan < 60; ++scan) {
      if (random() % change == 0) bits = random() % 4;
      scans.emplace_back(bits, 1 + random() % longest);
    }
    const std::string exact = answers(set.properties.at(0), 1, scans);
    EXPECT_EQ(answers(set.properties[0], 10, scans), exact) << texts[round % 4] << ", round " << round;
    EXPECT_EQ(answers(set.properties[0], 100, scans), exact) << texts[round % 4] << ", round " << round;
  }
}

}  // namespace
}  // namespace rungproof
