// Groups of which at most one holds: what is found on rings and chains of bits whose behaviour is known, that every
// group is inductive, and that the gates of a group say what counting says.
#include <gtest/gtest.h>

#include <bit>

#include "analysis/bits/bit_cnf.hpp"
#include "analysis/bits/bit_simulator.hpp"
#include "analysis/bits/bit_unrolling.hpp"
#include "analysis/portfolio/invariants_groups.hpp"
#include "analysis/schedule/schedule.hpp"

namespace rungproof {
namespace {

constexpr std::uint64_t groupSeed = 3;

struct Steps {
  BitSystem system;
  std::vector<Lit> steps;
};

/// n steps; each passes on to the next when its input is on. `first` are on at the start; `isRing`: the last passes on
/// to the first; `staysOn`: the last one stays on then.
Steps stepsOf(std::size_t n, const std::vector<std::size_t>& first, bool isRing, bool staysOn = false) {
  Steps s;
  std::vector<Lit> moves;
  for (std::size_t i = 0; i < n; ++i) moves.push_back(s.system.addInput("move " + std::to_string(i)));
  for (std::size_t i = 0; i < n; ++i) {
    const bool isOn = std::ranges::find(first, i) != first.end();
    s.steps.push_back(s.system.addLatch("step " + std::to_string(i), isOn ? LatchInit::One : LatchInit::Zero));
  }
  for (std::size_t i = 0; i < n; ++i) {
    const bool isLast = i + 1 == n;
    const Lit leaves = isLast && (!isRing || staysOn) ? falseLit : moves[i];
    const std::size_t before = (i + n - 1) % n;
    const Lit comes = i == 0 && !isRing ? falseLit : s.system.addAnd(s.steps[before], moves[before]);
    s.system.setNext(s.steps[i], s.system.addOr(s.system.addAnd(s.steps[i], negate(leaves)), comes));
  }
  return s;
}

/// Together they hold at the start, and no scan from a state that keeps them breaks one.
bool areInductive(BitSystem system, const std::vector<ExclusiveGroup>& groups) {
  std::vector<Lit> hold;
  for (const ExclusiveGroup& group : groups) hold.push_back(atMostOne(system, group));
  for (const Unrolling::Start start : {Unrolling::Start::Initial, Unrolling::Start::Any}) {
    const bool isStep = start == Unrolling::Start::Any;
    Unrolling steps(system, start);
    Sat sat(Sat::Use::Few);
    BitCnf cnf(steps.graph(), sat);
    std::vector<int> broken;
    for (const Lit l : hold) {
      if (isStep) sat.add({cnf.literal(steps.at(0, l))});
      broken.push_back(-cnf.literal(steps.at(isStep ? 1 : 0, l)));
    }
    sat.add(broken);
    if (sat.solve({}, Budget::seconds(60)) != Sat::Outcome::Unsatisfiable) return false;
  }
  return true;
}

std::vector<ExclusiveGroup> groupsOf(const Steps& s) {
  return mineGroups(s.system, s.steps, groupSeed, Budget::seconds(60));
}

TEST(Groups, ARingIsOneGroupHoweverLong) {
  for (const std::size_t n : {schedule::leastGroup, std::size_t{50}, std::size_t{300}}) {
    const Steps ring = stepsOf(n, {0}, true);
    const std::vector<ExclusiveGroup> groups = groupsOf(ring);
    ASSERT_EQ(groups.size(), 1U);
    EXPECT_EQ(groups[0].size(), n);
    EXPECT_TRUE(areInductive(ring.system, groups));
  }
}

/// Random runs of a few dozen scans see the first steps only; the others are one group with them all the same.
TEST(Groups, AChainIsOneGroupThoughRunsDoNotSeeItsEnd) {
  const Steps chain = stepsOf(200, {0}, false);
  const std::vector<ExclusiveGroup> groups = groupsOf(chain);
  ASSERT_EQ(groups.size(), 1U);
  EXPECT_EQ(groups[0].size(), 200U);
  EXPECT_TRUE(areInductive(chain.system, groups));
}

/// Two that are on at the start walk round at their own pace: any two steps are on together sometimes.
TEST(Groups, TwoWalkersLeaveNone) { EXPECT_TRUE(groupsOf(stepsOf(40, {0, 20}, true)).empty()); }

/// The last of 100 steps starts the first one and stays on: whoever waits for 100 scans sees any step together with the
/// last one, later any two.
TEST(Groups, AFaultAtTheEndOfALongChainLeavesNone) { EXPECT_TRUE(groupsOf(stepsOf(100, {0}, true, true)).empty()); }

/// Two rings that know nothing of each other are two groups.
TEST(Groups, TwoRingsAreTwoGroups) {
  Steps s = stepsOf(24, {0}, true);
  const Steps other = stepsOf(26, {3}, true);
  std::vector<Lit> inputs;
  for (std::size_t i = 0; i < other.steps.size(); ++i) inputs.push_back(s.system.addInput("other"));
  std::vector<Lit> latches;
  for (std::size_t i = 0; i < other.steps.size(); ++i)
    latches.push_back(s.system.addLatch("other", i == 3 ? LatchInit::One : LatchInit::Zero));
  for (std::size_t i = 0; i < latches.size(); ++i) {
    const std::size_t before = (i + latches.size() - 1) % latches.size();
    s.system.setNext(latches[i], s.system.addOr(s.system.addAnd(latches[i], negate(inputs[i])),
                                                s.system.addAnd(latches[before], inputs[before])));
  }
  s.steps.insert(s.steps.end(), latches.begin(), latches.end());
  const std::vector<ExclusiveGroup> groups = groupsOf(s);
  ASSERT_EQ(groups.size(), 2U);
  EXPECT_EQ(groups[0].size() + groups[1].size(), 50U);
  EXPECT_TRUE(areInductive(s.system, groups));
}

/// Constraints are kept: an input that puts two on at once may never be on.
TEST(Groups, ConstraintsAreKept) {
  for (const bool isConstrained : {true, false}) {
    Steps s = stepsOf(26, {0}, true);
    const Lit fault = s.system.addInput("fault");
    for (const Lit l : {s.steps[2], s.steps[9]}) {
      const Latch& latch = s.system.latches[s.system.position[variableOf(l)]];
      s.system.setNext(l, s.system.addOr(latch.next, fault));
    }
    if (isConstrained) s.system.constraints.push_back(negate(fault));
    const std::vector<ExclusiveGroup> groups = groupsOf(s);
    EXPECT_EQ(groups.size(), isConstrained ? 1U : 0U);
  }
}

TEST(Groups, FewTruthsAreLeftToPairsAndNoTimeFindsNothing) {
  EXPECT_TRUE(groupsOf(stepsOf(schedule::leastGroup - 1, {0}, true)).empty());
  const Steps ring = stepsOf(30, {0}, true);
  EXPECT_TRUE(mineGroups(ring.system, ring.steps, groupSeed, Budget::seconds(0)).empty());
}

TEST(Groups, GatesSayWhatCountingSays) {
  BitSystem system;
  ExclusiveGroup group;
  for (int i = 0; i < 5; ++i) group.push_back(system.addLatch("l", LatchInit::Zero) ^ (i == 2 ? 1U : 0U));
  const Lit gate = atMostOne(system, group);
  BitSimulator simulator(system);
  for (std::uint32_t values = 0; values < 32; ++values) {
    for (std::size_t i = 0; i < 5; ++i) simulator.setLatch(i, (values >> i & 1U) != 0 ? ~0ULL : 0);
    simulator.evaluate();
    const int on = std::popcount(values ^ 4U);  // the third is on when its latch is off
    EXPECT_EQ(simulator.value(gate), on <= 1 ? ~0ULL : 0) << values;
  }
  EXPECT_EQ(atMostOne(system, {}), trueLit);
}

}  // namespace
}  // namespace rungproof
