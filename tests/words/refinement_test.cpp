// A spurious step is told from a real one: by what the samples suggest, or by what the goal says of the state before.
#include "analysis/words/refinement.hpp"

#include <gtest/gtest.h>

#include "analysis/bits/bit_blast.hpp"
#include "tests/solver/families.hpp"

namespace rungproof {
namespace {

using families::Family;

/// Two words that count together with an input.
struct Pair {
  Pair() {
    Graph& g = *f.graph;
    const Node in = f.input("in"), a = f.state("VW0", 16), b = f.state("VW2", 16);
    for (const Node n : {a, b}) f.next(n, f.choose(in, g.make(Op::Add, 16, n, f.number(1, 16)), n));
    f.ask("apart",
          f.both(g.make(Op::Equal, 1, a, f.number(100, 16)), f.no(g.make(Op::Equal, 1, b, f.number(100, 16)))));
    cone = std::make_unique<WordCone>(f.system, 0);
    left = cone->system().states[0].node;
    right = cone->system().states[1].node;
  }
  Node after(Node goal, Predicates& predicates) { return predicates.afterScan(goal); }
  Family f;
  std::unique_ptr<WordCone> cone;
  Node left, right;
};

// Sampled states have VW0 = VW2, and 99 and 5 are not equal: that is what tells them from 7 and 7.
TEST(Refinement, TakesWhatHoldsInAllSamples) {
  Pair p;
  std::vector<WordState> samples;
  for (std::uint64_t i = 0; i < 40; ++i) samples.push_back({i, i});
  Predicates predicates(*p.cone, samples);
  Refinement refinement(*p.cone, predicates);
  const WordStep step{{99, 5}, {1}, {}};
  ASSERT_TRUE(refinement.refine({7, 7}, step, predicates.afterScan(p.cone->bad())));
  EXPECT_TRUE(predicates.contains(p.cone->graph().make(Op::Equal, 1, p.left, p.right)));
}

// After the scan with `in` VW0 is to be 100: before it VW0 + 1 = 100, which is VW0 = 99.
TEST(Refinement, CarriesTheGoalBackThroughTheScan) {
  Pair p;
  Predicates predicates(*p.cone, {});
  Refinement refinement(*p.cone, predicates);
  Graph& g = p.cone->graph();
  const Node goal = predicates.afterScan(g.make(Op::Equal, 1, p.left, g.constantNode(100, 16)));
  const std::vector<Node> carried = refinement.carriedBack({99, 5}, {1}, goal);
  ASSERT_EQ(carried.size(), 1U);
  EXPECT_EQ(predicates.valuesIn({99, 0}, carried), std::vector<bool>{true});
  EXPECT_EQ(predicates.valuesIn({100, 0}, carried), std::vector<bool>{false});
  // Without `in` the words stay: it is 100 already.
  const std::vector<Node> kept = refinement.carriedBack({100, 5}, {0}, goal);
  ASSERT_EQ(kept.size(), 1U);
  EXPECT_EQ(predicates.valuesIn({100, 0}, kept), std::vector<bool>{true});
  EXPECT_EQ(predicates.valuesIn({99, 0}, kept), std::vector<bool>{false});
}

// What is known already is no refinement.
TEST(Refinement, SaysWhenThereIsNothingNew) {
  Pair p;
  Predicates predicates(*p.cone, {});
  Refinement refinement(*p.cone, predicates);
  const Node goal = predicates.afterScan(p.cone->bad());
  const WordStep step{{99, 5}, {1}, {}};
  int rounds = 0;
  while (refinement.refine({7, 7}, step, goal)) ASSERT_LT(++rounds, 100);
  EXPECT_GT(rounds, 0);
}

}  // namespace
}  // namespace rungproof
