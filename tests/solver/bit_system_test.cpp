// And-inverter graphs: whatever simplification makes of a gate, its value is that of the operation; equal gates are
// one.
#include "analysis/bits/bit_system.hpp"

#include <gtest/gtest.h>

#include <random>

#include "analysis/bits/bit_simulator.hpp"

namespace rungproof {
namespace {

/// A literal with its value for 64 assignments of the inputs.
struct Known {
  Lit literal;
  std::uint64_t lanes;
};

// 40 graphs of 300 operations over six inputs, their operands taken from what has been made before, negated or not.
TEST(BitSystem, SimplifiedGatesKeepTheirValues) {
  constexpr std::uint64_t seed = 4711;
  SCOPED_TRACE(testing::Message() << "seed " << seed);
  std::mt19937_64 random(seed);
  for (int round = 0; round < 40; ++round) {
    BitSystem graph;
    std::vector<Known> known{{falseLit, 0}, {trueLit, ~0ULL}};
    std::vector<std::uint64_t> inputs;
    for (int i = 0; i < 6; ++i) {
      inputs.push_back(random());
      known.push_back({graph.addInput(), inputs.back()});
    }
    for (int step = 0; step < 300; ++step) {
      const auto any = [&] {
        Known k = known[random() % known.size()];
        if ((random() & 1U) != 0) k = {negate(k.literal), ~k.lanes};
        return k;
      };
      const Known a = any(), b = any(), c = any();
      switch (random() % 4) {
        case 0: known.push_back({graph.addAnd(a.literal, b.literal), a.lanes & b.lanes}); break;
        case 1: known.push_back({graph.addOr(a.literal, b.literal), a.lanes | b.lanes}); break;
        case 2: known.push_back({graph.addXor(a.literal, b.literal), a.lanes ^ b.lanes}); break;
        default:
          known.push_back({graph.addIte(c.literal, a.literal, b.literal), (c.lanes & a.lanes) | (~c.lanes & b.lanes)});
          break;
      }
    }
    BitSimulator simulator(graph);
    for (std::size_t i = 0; i < inputs.size(); ++i) simulator.setInput(i, inputs[i]);
    simulator.evaluate();
    for (const Known& k : known)
      ASSERT_EQ(simulator.value(k.literal), k.lanes) << "round " << round << ", literal " << k.literal;
    // A gate's children are smaller than itself: variables are in topological order.
    for (std::size_t i = 0; i < graph.gates.size(); ++i) {
      EXPECT_LT(graph.gates[i].left, graph.gates[i].right);
      EXPECT_LT(variableOf(graph.gates[i].right), graph.gateVariables[i]);
    }
  }
}

TEST(BitSystem, EqualGatesAreOne) {
  BitSystem graph;
  const Lit a = graph.addInput(), b = graph.addInput();
  EXPECT_EQ(graph.addAnd(a, b), graph.addAnd(b, a));
  EXPECT_EQ(graph.addXor(a, b), negate(graph.addXor(negate(a), b)));
  EXPECT_EQ(graph.addAnd(a, negate(a)), falseLit);
  EXPECT_EQ(graph.addAnd(graph.addAnd(a, b), a), graph.addAnd(a, b));
}

TEST(BitSystem, ChoicesAreRecognised) {
  BitSystem graph;
  const Lit c = graph.addInput(), a = graph.addInput(), b = graph.addInput();
  const Lit choice = graph.addIte(c, a, b);
  BitChoice found;
  // The gate below `choice` has the opposite value if the literal is negative.
  ASSERT_TRUE(recogniseChoice(graph, choice, found));
  const Lit sign = choice & 1U;
  const bool isPlain = found.condition == c && found.then == (a ^ sign) && found.otherwise == (b ^ sign);
  const bool isSwapped = found.condition == negate(c) && found.then == (b ^ sign) && found.otherwise == (a ^ sign);
  EXPECT_TRUE(isPlain || isSwapped);
  EXPECT_FALSE(recogniseChoice(graph, graph.addAnd(a, b), found));
}

TEST(BitSystem, LatchesMoveTogether) {
  BitSystem system;  // two latches that swap
  const Lit x = system.addLatch("x", LatchInit::Zero), y = system.addLatch("y", LatchInit::One);
  system.setNext(x, y);
  system.setNext(y, x);
  BitSimulator simulator(system);
  simulator.setLatch(0, 0);
  simulator.setLatch(1, ~0ULL);
  simulator.evaluate();
  simulator.step();
  EXPECT_EQ(simulator.latch(0), ~0ULL);
  EXPECT_EQ(simulator.latch(1), 0U);
}

}  // namespace
}  // namespace rungproof
