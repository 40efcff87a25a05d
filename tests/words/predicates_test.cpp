// What the engine knows of a predicate: its value after the scan, initially, and in sampled states.
#include "analysis/words/predicates.hpp"

#include <gtest/gtest.h>

#include "tests/solver/families.hpp"

namespace rungproof {
namespace {

using families::Family;

/// A word that starts at 3 and counts by an input; sampled states 3, 10 and 40.
struct Counted {
  Counted() {
    Graph& g = *f.graph;
    const Node count = f.state("VW0", 16, 3);
    f.next(count, g.make(Op::Add, 16, count, f.input("step", 16)));
    f.ask("large", g.make(Op::Ult, 1, f.number(30000, 16), count));
    cone = std::make_unique<WordCone>(f.system, 0);
    word = cone->system().states[0].node;
    step = cone->system().inputs[0];
    predicates = std::make_unique<Predicates>(*cone, std::vector<WordState>{{3}, {10}, {40}});
  }
  Node below(Node n, std::uint64_t limit) {
    return cone->graph().make(Op::Ult, 1, n, cone->graph().constantNode(limit, 16));
  }
  Family f;
  std::unique_ptr<WordCone> cone;
  Node word, step;
  std::unique_ptr<Predicates> predicates;
};

TEST(Predicates, AfterTheScanBySubstitution) {
  Counted c;
  ASSERT_TRUE(c.predicates->add(c.below(c.word, 10)));
  const Predicate& p = (*c.predicates)[0];
  EXPECT_EQ(p.next, c.below(c.cone->graph().make(Op::Add, 16, c.word, c.step), 10));
  EXPECT_EQ(p.words, std::vector<std::uint32_t>{0});
  EXPECT_EQ(p.initially, true);                             // 3 < 10
  EXPECT_EQ(p.samples, std::vector<std::uint64_t>{0b001});  // 3, not 10 and 40
}

TEST(Predicates, EachOnceAndOverStatesOnly) {
  Counted c;
  const Node small = c.below(c.word, 10);
  EXPECT_TRUE(c.predicates->add(small));
  EXPECT_FALSE(c.predicates->add(small));
  EXPECT_FALSE(c.predicates->add(c.cone->graph().make(Op::Not, 1, small)));
  EXPECT_FALSE(c.predicates->add(c.below(c.step, 10)));
  EXPECT_FALSE(c.predicates->add(c.cone->graph().constantNode(1, 1)));
  EXPECT_EQ(c.predicates->size(), 1U);
}

TEST(Predicates, CubesAreSetsOfStates) {
  Counted c;
  c.predicates->add(c.below(c.word, 10));
  c.predicates->add(c.below(c.word, 40));
  const WordCube between = {positive(0) ^ 1U, positive(1)};  // 10 <= VW0 < 40
  EXPECT_FALSE(c.predicates->contains(between, {9}));
  EXPECT_TRUE(c.predicates->contains(between, {10}));
  EXPECT_TRUE(c.predicates->contains(between, {39}));
  EXPECT_FALSE(c.predicates->contains(between, {40}));
  EXPECT_EQ(c.predicates->sampleIn(between), std::size_t{1});
  EXPECT_EQ(c.predicates->samplesIn({positive(1) ^ 1U}), std::vector<std::uint64_t>{0b100});
  EXPECT_EQ(c.predicates->sampleIn({positive(0), positive(1) ^ 1U}), std::nullopt);
}

}  // namespace
}  // namespace rungproof
