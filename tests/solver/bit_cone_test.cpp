// Cones: what a question does not depend on is left out, and a run of the cone is a run of the whole system.
#include "analysis/bits/bit_cone.hpp"

#include <gtest/gtest.h>

#include "tests/solver/reference.hpp"

namespace rungproof {
namespace {

/// Two latches that follow inputs of their own, a third one that follows the first; a constraint on the second input
/// alone, which its own input can always meet.
struct TwoParts {
  TwoParts() {
    a = system.addInput("a");
    b = system.addInput("b");
    first = system.addLatch("first", LatchInit::Zero);
    second = system.addLatch("second", LatchInit::Zero);
    third = system.addLatch("third", LatchInit::Zero);
    system.setNext(first, a);
    system.setNext(second, b);
    system.setNext(third, first);
    system.constraints = {b};
    system.bads = {third};
  }
  BitSystem system;
  Lit a, b, first, second, third;
};

TEST(BitCone, LeavesOutWhatTheQuestionDoesNotDependOn) {
  TwoParts parts;
  const BitCone cone = makeCone(parts.system, parts.system.bads, {true});
  EXPECT_EQ(cone.latches, (std::vector<std::uint32_t>{0, 2}));
  EXPECT_EQ(cone.inputs, (std::vector<std::uint32_t>{0}));
  EXPECT_TRUE(cone.system.constraints.empty());
  EXPECT_EQ(cone.translated(parts.second), BitCone::outside);
  EXPECT_NE(cone.translated(negate(parts.first)), BitCone::outside);
}

TEST(BitCone, KeepsConstraintsThatAreNotTotal) {
  TwoParts parts;
  const BitCone cone = makeCone(parts.system, parts.system.bads, {false});
  EXPECT_EQ(cone.system.constraints.size(), 1U);
  EXPECT_EQ(cone.inputs.size(), 2U);
}

TEST(BitCone, ItsRunIsCompletedToARunOfTheWhole) {
  TwoParts parts;
  const BitCone cone = makeCone(parts.system, parts.system.bads, {true});
  // a in the first scan: `first` in the second, `third` in the third.
  BitTrace trace;
  trace.initial.assign(cone.latches.size(), false);
  trace.inputs = {{true}, {false}, {false}};
  const auto whole = completeTrace(parts.system, cone, trace);
  ASSERT_TRUE(whole.has_value());
  ASSERT_EQ(whole->inputs.size(), 3U);
  std::uint32_t state = 0;
  for (std::size_t scan = 0; scan < whole->inputs.size(); ++scan) {
    std::uint32_t inputs = 0;
    for (std::uint32_t i = 0; i < 2; ++i) inputs |= static_cast<std::uint32_t>(whole->inputs[scan][i]) << i;
    EXPECT_TRUE(reference::isLegal(parts.system, state, inputs)) << "scan " << scan;
    EXPECT_EQ(reference::isBad(parts.system, state, inputs), scan == 2);
    state = reference::nextState(parts.system, state, inputs);
  }
}

TEST(BitCone, EqualLatchesAreOne) {
  TwoParts parts;
  EqualLiterals equal(parts.system.variableCount());
  for (std::uint32_t v = 0; v < equal.size(); ++v) equal[v] = positive(v);
  equal[variableOf(parts.third)] = parts.first;  // taken as proved: what counts is that it is put in
  const BitCone cone = makeCone(parts.system, parts.system.bads, {true}, equal);
  EXPECT_EQ(cone.latches, (std::vector<std::uint32_t>{0}));
}

}  // namespace
}  // namespace rungproof
