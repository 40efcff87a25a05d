// From words to bits and back: a counter whose runs are known, REAL operations as free inputs, certificates' literals
// as nodes.
#include "analysis/bits/bit_blast.hpp"

#include <gtest/gtest.h>

#include "analysis/bits/bit_simulator.hpp"
#include "analysis/graph/evaluate.hpp"

namespace rungproof {
namespace {

/// A word that grows by an input of four bits in each scan; bad when it is 100.
struct Counting {
  Counting() {
    count = graph.variable("count", 8, true);
    step = graph.variable("step", 4, false);
    const Node next = graph.make(Op::Add, 8, count, graph.make(Op::Zext, 8, step));
    system.graph = &graph;
    system.states = {{count, graph.constantNode(7, 8), next}};
    system.inputs = {step};
    system.questions = {{"hundred", graph.make(Op::Equal, 1, count, graph.constantNode(100, 8))}};
  }
  Graph graph;
  Node count, step;
  TransitionSystem system;
};

TEST(BitBlast, LatchesAreTheBitsOfTheWord) {
  Counting counting;
  const BitBlast blast(counting.system, {0});
  ASSERT_EQ(blast.bits().latches.size(), 8U);
  ASSERT_EQ(blast.bits().inputs.size(), 4U);
  ASSERT_EQ(blast.of(counting.count).size(), 8U);
  for (std::uint32_t i = 0; i < 8; ++i) {
    const bool isOne = (7U >> blast.stateBit(i).bit & 1U) != 0;
    EXPECT_EQ(blast.bits().latches[i].init, isOne ? LatchInit::One : LatchInit::Zero);
  }
  EXPECT_TRUE(blast.unmodelled().empty());
}

TEST(BitBlast, BitRunsAreWordRuns) {
  // Inputs 15, 3 and 9 as bits; the word run must have the same numbers at the same places.
  Counting counting;
  const BitBlast blast(counting.system, {0});
  BitTrace trace;
  trace.initial.assign(8, false);
  for (const unsigned value : {15U, 3U, 9U}) {
    std::vector<bool> inputs(4);
    const LitVector& literals = blast.of(counting.step);
    for (std::uint32_t bit = 0; bit < 4; ++bit)
      inputs[blast.bits().position[variableOf(literals[bit])]] = (value >> bit & 1U) != 0;
    trace.inputs.push_back(inputs);
  }
  const WordTrace words = blast.wordTrace(trace);
  ASSERT_EQ(words.inputs.size(), 3U);
  EXPECT_EQ(words.inputs[0], (std::vector<std::uint64_t>{15}));
  EXPECT_EQ(words.inputs[1], (std::vector<std::uint64_t>{3}));
  EXPECT_EQ(words.inputs[2], (std::vector<std::uint64_t>{9}));
}

TEST(BitBlast, OperationsOnRealNumbersAreFreeInputs) {
  Graph graph;
  const Node real = graph.variable("VD0", 32, true);
  const Node sine = graph.rfunction(0, {real}).node;
  TransitionSystem system;
  system.graph = &graph;
  system.states = {{real, graph.constantNode(0x3F800000, 32), sine}};
  system.questions = {{"negative", graph.make(Op::Extract, 1, sine, noNode, noNode, 31)}};
  const BitBlast blast(system, {0});
  ASSERT_EQ(blast.unmodelled().size(), 1U);
  EXPECT_EQ(blast.unmodelled()[0], sine);
  EXPECT_EQ(blast.unmodelledInputs().size(), blast.bits().inputs.size());
}

TEST(BitBlast, LiteralsOfStateAreNodes) {
  Counting counting;
  BitBlast blast(counting.system, {0});
  const Lit lowest = blast.of(counting.count)[0];
  const Node node = blast.nodeOf(negate(lowest));
  Evaluator evaluator(counting.graph, std::vector<Node>{node});
  for (const std::uint64_t value : {6ULL, 7ULL}) {
    evaluator.set(counting.count, value);
    evaluator.run();
    EXPECT_EQ(evaluator[node], 1 - value % 2);
  }
}

}  // namespace
}  // namespace rungproof
