// Which predicates are read from a system, and which equations from sampled states.
#include "analysis/words/terms.hpp"

#include <gtest/gtest.h>

#include "tests/solver/families.hpp"

namespace rungproof {
namespace {

using families::Family;

bool holds(const std::vector<Node>& nodes, Node n) { return std::ranges::find(nodes, n) != nodes.end(); }

/// VW0 becomes VW2 while M0.0, else it is kept; bad above 27,648, signed.
struct Moved {
  Moved() {
    Graph& g = *f.graph;
    const Node bit = f.state("M0.0"), to = f.state("VW0", 16), from = f.state("VW2", 16);
    f.next(bit, f.input("in"));
    f.next(to, f.choose(bit, from, to));
    f.next(from, f.input("value", 16));
    f.ask("large", g.make(Op::Slt, 1, f.number(27648, 16), f.choose(bit, from, to)));
    cone = std::make_unique<WordCone>(f.system, 0);
    for (const StateVariable& s : cone->system().states) nodes.push_back(s.node);
  }
  Node above(std::size_t word) {
    return cone->graph().make(Op::Slt, 1, cone->graph().constantNode(27648, 16), nodes[word]);
  }
  Family f;
  std::unique_ptr<WordCone> cone;
  std::vector<Node> nodes;  ///< M0.0, VW0, VW2
};

TEST(Terms, ComparisonsAreTakenApart) {
  Moved m;
  const std::vector<Node> found = syntacticPredicates(*m.cone);
  EXPECT_TRUE(holds(found, m.nodes[0]));
  EXPECT_TRUE(holds(found, m.above(1)));
  EXPECT_TRUE(holds(found, m.above(2)));
}

TEST(Terms, WordsThatAreMovedAreOfOneKind) {
  Moved m;
  const std::vector<Node> found = orderPredicates(*m.cone, 1000);
  Graph& g = m.cone->graph();
  EXPECT_TRUE(holds(found, g.make(Op::Slt, 1, m.nodes[1], m.nodes[2])));
  EXPECT_TRUE(holds(found, g.make(Op::Equal, 1, m.nodes[1], m.nodes[2])));
  EXPECT_TRUE(holds(found, m.above(2)));
  EXPECT_LE(orderPredicates(*m.cone, 3).size(), 3U);
}

/// A cone with three words, so that equations can be read from states given by hand.
struct ThreeWords {
  ThreeWords() {
    Graph& g = *f.graph;
    Node sum = f.number(0, 16);
    for (const char* name : {"VW0", "VW2", "VW4"}) {
      const Node word = f.state(name, 16);
      f.next(word, f.input(std::string("next of ") + name, 16));
      sum = g.make(Op::Add, 16, sum, word);
    }
    f.ask("zero", g.make(Op::Equal, 1, sum, f.number(7, 16)));
    cone = std::make_unique<WordCone>(f.system, 0);
  }
  /// Does the equation hold of these values?
  bool accepts(Node equation, std::uint64_t a, std::uint64_t b, std::uint64_t c) {
    Predicates predicates(*cone, {});
    const Node nodes[] = {equation};
    return predicates.valuesIn({a, b, c}, nodes)[0];
  }
  Family f;
  std::unique_ptr<WordCone> cone;
};

TEST(Terms, EquationWithFactorsAndConstant) {
  ThreeWords t;
  std::vector<WordState> samples;
  for (std::uint64_t h = 0; h < 9; ++h) {
    for (std::uint64_t m = 0; m < 10; ++m) samples.push_back({h, m, 3600 * h + 60 * m + 12});
  }
  const std::vector<Node> found = linearPredicates(*t.cone, samples);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_TRUE(t.accepts(found[0], 5, 59, 5 * 3600 + 59 * 60 + 12));
  EXPECT_FALSE(t.accepts(found[0], 5, 59, 5 * 3600 + 59 * 60 + 13));
}

TEST(Terms, NegativeValuesAndFractions) {
  // 2 VW0 = -3 VW2, which needs a common denominator; VW4 goes its own way.
  ThreeWords t;
  std::vector<WordState> samples;
  for (std::uint64_t i = 0; i < 40; ++i) samples.push_back({3 * i, (0x10000 - 2 * i) & 0xFFFF, i * i});
  const std::vector<Node> found = linearPredicates(*t.cone, samples);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_TRUE(t.accepts(found[0], 300, 0x10000 - 200, 5));
  EXPECT_FALSE(t.accepts(found[0], 300, 200, 5));
}

TEST(Terms, NoEquationFromFewOrFreeSamples) {
  ThreeWords t;
  EXPECT_TRUE(linearPredicates(*t.cone, {{1, 1, 1}, {2, 2, 2}}).empty());
  std::vector<WordState> samples;
  for (std::uint64_t i = 0; i < 50; ++i) samples.push_back({i, i * i, i * i * i});
  EXPECT_TRUE(linearPredicates(*t.cone, samples).empty());
}

}  // namespace
}  // namespace rungproof
