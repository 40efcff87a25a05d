// The one constructor of the graph: what it simplifies keeps its value, and its normal form is one node.
#include "analysis/graph/graph.hpp"

#include <gtest/gtest.h>

#include <random>

#include "analysis/graph/evaluate.hpp"

namespace rungproof {
namespace {

struct Term {
  Node node;
  std::uint64_t value;
};

// 60 graphs of 120 operations over two words, two bytes and two bits; operands are what has been made before, constants
// among them. The value of every node, evaluated from the variables, is that of the operation on its operands' values.
TEST(Graph, SimplifiedNodesKeepTheirValues) {
  constexpr std::uint64_t seed = 815;
  SCOPED_TRACE(testing::Message() << "seed " << seed);
  std::mt19937_64 random(seed);
  for (int round = 0; round < 60; ++round) {
    Graph g;
    std::vector<Term> terms;
    std::vector<std::pair<Node, std::uint64_t>> variables;
    for (const int width : {16, 16, 8, 8, 1, 1}) {
      variables.emplace_back(g.variable("x" + std::to_string(variables.size()), width, false),
                             random() & Graph::maskOf(width));
      terms.push_back({variables.back().first, variables.back().second});
      const std::uint64_t constant = random() & (random() % 2 == 0 ? 3 : Graph::maskOf(width)) & Graph::maskOf(width);
      terms.push_back({g.constantNode(constant, width), constant});
    }
    const auto any = [&](int width) {
      for (;;) {
        const Term& t = terms[random() % terms.size()];
        if (g[t.node].width == width) return t;
      }
    };
    for (int step = 0; step < 120; ++step) {
      static constexpr int widths[] = {1, 8, 16};
      const int w = widths[random() % 3];
      const Term a = any(w), b = any(w), c = any(1);
      static constexpr Op words[] = {Op::And, Op::Or,   Op::Xor,  Op::Add, Op::Sub,
                                     Op::Mul, Op::Udiv, Op::Urem, Op::Shl, Op::Lshr};
      static constexpr Op relations[] = {Op::Equal, Op::Ult, Op::Ule, Op::Slt, Op::Sle};
      const auto add = [&](Op op, int width, const Term& x, const Term& y) {
        terms.push_back(
            {g.make(op, width, x.node, y.node), evaluateOperation(op, width, {w, w}, {x.value, y.value, 0}, 0)});
      };
      switch (random() % 4) {
        case 0: add(w == 1 ? words[random() % 3] : words[random() % 10], w, a, b); break;
        case 1: add(w == 1 ? Op::Equal : relations[random() % 5], 1, a, b); break;
        case 2: terms.push_back({g.make(Op::Ite, w, c.node, a.node, b.node), c.value != 0 ? a.value : b.value}); break;
        default: terms.push_back({g.make(Op::Not, w, a.node), ~a.value & Graph::maskOf(w)}); break;
      }
    }
    std::vector<Node> roots;
    for (const Term& t : terms) roots.push_back(t.node);
    Evaluator evaluator(g, roots);
    for (const auto& [node, value] : variables) evaluator.set(node, value);
    evaluator.run();
    for (const Term& t : terms) {
      ASSERT_EQ(evaluator[t.node], t.value) << "round " << round << ", node " << indexOf(t.node);
      EXPECT_LE(g.lowest(t.node), t.value);
      EXPECT_GE(g.highest(t.node), t.value);
    }
  }
}

TEST(Graph, NormalFormIsOneNode) {
  Graph g;
  const Node x = g.variable("x", 16, false), y = g.variable("y", 16, false), p = g.variable("p", 1, false),
             q = g.variable("q", 1, false);
  EXPECT_EQ(g.make(Op::Add, 16, x, y), g.make(Op::Add, 16, x, y));
  EXPECT_EQ(g.make(Op::And, 1, p, g.make(Op::Not, 1, p)), g.constantNode(0, 1));
  EXPECT_EQ(g.make(Op::Ite, 16, p, x, x), x);
  EXPECT_EQ(g.make(Op::Not, 1, g.make(Op::Not, 1, q)), q);
  EXPECT_EQ(g.make(Op::Extract, 16, g.make(Op::Concat, 32, y, x)), x) << "the low word";
  EXPECT_EQ(g.make(Op::Ule, 1, x, y), g.make(Op::Not, 1, g.make(Op::Ult, 1, y, x)));
}

}  // namespace
}  // namespace rungproof
