// Time as digits, compared with counting ms one by one.
#include "analysis/encoding/time_model.hpp"

#include <gtest/gtest.h>

#include "analysis/graph/evaluate.hpp"

namespace rungproof {
namespace {

/// Runs scans of the given lengths and checks dt and the ticks against floor(time / 10) and floor(time / 100).
/// The first scan starts `phase` ms after a tick of 100 ms.
void follow(const TimeRange& range, const std::vector<std::uint32_t>& lengths, std::uint32_t phase = 0) {
  Graph graph;
  TimeModel time(graph, range);
  const Node ten = time.ticks10(), hundred = time.ticks100();
  const Node tens = time.ticksWithin(10), hundreds = time.ticksWithin(100);
  std::vector<Node> roots{time.dt(), ten, hundred, tens, hundreds, time.tensNow(), time.onesNow()};
  for (const StateVariable& s : time.states()) {
    roots.push_back(s.node);
    roots.push_back(s.next);
  }
  for (const Node input : time.inputs()) roots.push_back(input);
  if (time.constraint() != noNode) roots.push_back(time.constraint());
  Evaluator value(graph, roots);
  for (const StateVariable& s : time.states()) {
    const std::string& name = graph.variables()[graph[s.node].value].name;
    const std::uint64_t digit = name == "time.tens.start" ? phase / 10 : name == "time.ones.start" ? phase % 10 : 0;
    EXPECT_TRUE(s.init == noNode || digit == 0) << name;
    value.set(s.node, digit);
  }
  std::uint64_t before = phase, now = phase;  // start of the scan before, and of this one
  for (const std::uint32_t length : lengths) {
    const std::uint64_t after = now + length;
    if (!time.inputs().empty()) {
      value.set(time.inputs()[0], after / 100 - now / 100);
      value.set(time.inputs()[1], after / 10 % 10);
      value.set(time.inputs()[2], after % 10);
    }
    value.run();
    EXPECT_EQ(value[time.dt()], length);
    EXPECT_EQ(value[ten], std::min<std::uint64_t>(now / 10 - before / 10, 0xFFFF));
    EXPECT_EQ(value[hundred], std::min<std::uint64_t>(now / 100 - before / 100, 0xFFFF));
    EXPECT_EQ(value[tens], after / 10 - now / 10);
    EXPECT_EQ(value[hundreds], after / 100 - now / 100);
    EXPECT_EQ(value[time.tensNow()] * 10 + value[time.onesNow()], after % 100);
    if (time.constraint() != noNode) {
      EXPECT_EQ(value[time.constraint()], 1U);
    }
    std::vector<std::uint64_t> next;
    for (const StateVariable& s : time.states()) next.push_back(value[s.next]);
    for (std::size_t i = 0; i < next.size(); ++i) value.set(time.states()[i].node, next[i]);
    before = now;
    now = after;
  }
}

TEST(TimeModel, TicksFollowFromTheLengths) {
  follow({.low = 1, .high = 500, .hasBases = true}, {1, 9, 10, 99, 100, 101, 499, 500, 1, 33, 67, 250});
}
TEST(TimeModel, FixedLengthNeedsNoInputs) {
  follow({.low = 13, .high = 13, .hasBases = true}, std::vector<std::uint32_t>(40, 13));
  follow({.low = 250, .high = 250, .hasBases = true}, std::vector<std::uint32_t>(12, 250));
}
// 001:6592: the first interval may be short, so RUN begins anywhere between two ticks.
TEST(TimeModel, RunBeginsAnywhereBetweenTwoTicks) {
  for (const std::uint32_t phase : {1U, 9U, 10U, 57U, 90U, 99U}) {
    follow({.low = 1, .high = 500, .hasBases = true}, {1, 9, 10, 99, 100, 101, 499, 500, 1, 33, 67, 250}, phase);
    follow({.low = 13, .high = 13, .hasBases = true}, std::vector<std::uint32_t>(40, 13), phase);
  }
  for (const std::uint32_t phase : {10U, 50U, 90U})
    follow({.low = 10, .high = 10, .hasBases = true}, std::vector<std::uint32_t>(30, 10), phase);
}

// All 16 values of a digit's four bits are starts: 10 to 15 mean 0 to 5.
TEST(TimeModel, EveryValueOfADigitIsAStart) {
  Graph graph;
  TimeModel time(graph, {.low = 1, .high = 500, .hasBases = true});
  const Node roots[] = {time.tensBefore(), time.onesBefore()};
  Evaluator value(graph, roots);
  for (std::uint64_t raw = 0; raw < 16; ++raw) {
    for (const StateVariable& s : time.states()) value.set(s.node, graph[s.node].width == 4 ? raw : 0);
    value.run();
    EXPECT_EQ(value[time.tensBefore()], raw % 10);
    EXPECT_EQ(value[time.onesBefore()], raw % 10);
  }
}
TEST(TimeModel, RelaxedScansMayBeLong) {
  follow({.low = 1, .high = 500, .relaxed = true, .hasBases = true}, {1, 4000000, 7, 300000, 12});
}

TEST(TimeModel, ScansOutsideTheRangeBreakTheConstraint) {
  Graph graph;
  TimeModel time(graph, {.low = 5, .high = 20, .hasBases = true});
  const Node roots[] = {time.constraint(), time.dt()};
  Evaluator value(graph, roots);
  for (const StateVariable& s : time.states()) value.set(s.node, 0);
  for (const auto& [tens, ones, isLegal] :
       {std::tuple{0, 4, 0}, std::tuple{0, 5, 1}, std::tuple{2, 0, 1}, std::tuple{2, 1, 0}, std::tuple{1, 10, 0}}) {
    value.set(time.inputs()[0], 0);
    value.set(time.inputs()[1], static_cast<std::uint64_t>(tens));
    value.set(time.inputs()[2], static_cast<std::uint64_t>(ones));
    value.run();
    EXPECT_EQ(value[time.constraint()], static_cast<std::uint64_t>(isLegal)) << tens << ones;
  }
}

// On an S7-300/400 timers count in ms: the length is one input without any state.
TEST(TimeModel, WithoutBasesTheLengthIsOneInput) {
  Graph graph;
  TimeModel time(graph, {.low = 5, .high = 20});
  EXPECT_TRUE(time.states().empty());
  ASSERT_EQ(time.inputs().size(), 1U);
  const Node roots[] = {time.constraint(), time.dt()};
  Evaluator value(graph, roots);
  for (std::uint64_t length = 0; length < 32; ++length) {
    value.set(time.inputs()[0], length);
    value.run();
    EXPECT_EQ(value[time.dt()], length);
    EXPECT_EQ(value[time.constraint()], length >= 5 && length <= 20 ? 1U : 0U) << length;
  }
  TimeModel fixed(graph, {.low = 13, .high = 13});
  EXPECT_TRUE(fixed.inputs().empty() && fixed.states().empty() && fixed.constraint() == noNode);
  EXPECT_EQ(graph[fixed.dt()].value, 13U);
}

}  // namespace
}  // namespace rungproof
