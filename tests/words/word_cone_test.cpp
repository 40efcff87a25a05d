// The cone of one question: what it needs, nothing else, and the way back.
#include "analysis/words/word_cone.hpp"

#include <gtest/gtest.h>

#include "tests/solver/families.hpp"

namespace rungproof {
namespace {

using families::Family;

/// Two words that have nothing to do with each other; one question about each.
struct TwoWords {
  TwoWords() {
    Graph& g = *f.graph;
    a = f.state("VW0", 16, 3);
    b = f.state("VW2", 16, 5);
    stepA = f.input("stepA", 16);
    stepB = f.input("stepB", 16);
    f.next(a, g.make(Op::Add, 16, a, stepA));
    f.next(b, g.make(Op::Add, 16, b, stepB));
    f.ask("a", g.make(Op::Equal, 1, a, f.number(100, 16)));
    f.ask("b", g.make(Op::Equal, 1, b, f.number(100, 16)));
  }
  Family f;
  Node a, b, stepA, stepB;
};

TEST(WordCone, HoldsWhatTheQuestionDependsOn) {
  TwoWords two;
  const WordCone cone(two.f.system, 1);
  EXPECT_EQ(cone.states(), std::vector<std::size_t>{1});
  EXPECT_EQ(cone.inputs(), std::vector<std::size_t>{1});
  ASSERT_EQ(cone.system().states.size(), 1U);
  EXPECT_EQ((*cone.system().graph)[cone.system().states[0].init].value, 5U);
  EXPECT_FALSE(cone.hasReals());
}

TEST(WordCone, TakesConstraintsThatTouchIt) {
  TwoWords two;
  Graph& g = *two.f.graph;
  const Node aboutB = g.make(Op::Ult, 1, two.stepB, two.f.number(9, 16));
  const Node aboutA = g.make(Op::Ult, 1, two.stepA, two.f.number(9, 16));
  two.f.system.constraints = two.f.system.totalConstraints = {aboutA, aboutB};
  EXPECT_EQ(WordCone(two.f.system, 1).system().constraints.size(), 1U);
  // A constraint that may end runs belongs to every cone, with what it depends on.
  two.f.system.totalConstraints = {aboutB};
  const WordCone cone(two.f.system, 1);
  EXPECT_EQ(cone.system().constraints.size(), 2U);
  EXPECT_EQ(cone.inputs(), (std::vector<std::size_t>{0, 1}));
}

TEST(WordCone, NodesFindTheirWayBack) {
  TwoWords two;
  WordCone cone(two.f.system, 0);
  Graph& g = *two.f.graph;
  // The same node is met again, because nodes are shared.
  EXPECT_EQ(cone.onGivenSystem(two.f.system, cone.bad()), two.f.system.questions[0].bad);
  const Node copy = cone.system().states[0].node;
  const Node above = cone.graph().make(Op::Ult, 1, cone.graph().constantNode(7, 16), copy);
  EXPECT_EQ(cone.onGivenSystem(two.f.system, above), g.make(Op::Ult, 1, two.f.number(7, 16), two.a));
}

TEST(WordCone, KnowsRealOperations) {
  Family f;
  Graph& g = *f.graph;
  const Node x = f.state("VD0", 32);
  f.ask("sum", g.rless({x}, g.radd({x}, {x})).node);
  f.ask("sine", g.rless({x}, g.rfunction(static_cast<std::uint64_t>(RealFunction::Sin), {x})).node);
  EXPECT_TRUE(WordCone(f.system, 0).hasReals());
  EXPECT_FALSE(WordCone(f.system, 0).hasOpaque());
  EXPECT_TRUE(WordCone(f.system, 1).hasOpaque());
}

}  // namespace
}  // namespace rungproof
