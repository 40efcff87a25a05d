// Equations in normal form: what a scan does to both sides cancels out, and nothing changes its meaning.
#include "analysis/words/linear_form.hpp"

#include <gtest/gtest.h>

#include "analysis/graph/evaluate.hpp"
#include "random_words.hpp"

namespace rungproof {
namespace {

using families::Family;

TEST(LinearForm, WhatIsAddedAndTakenAwayCancelsOut) {
  Family f;
  Graph& g = *f.graph;
  const Node x = f.state("VW0", 16), y = f.state("VW2", 16), moves = f.input("moves");
  const auto changed = [&](Node n, Op op) { return f.choose(moves, g.make(op, 16, n, f.number(1, 16)), n); };
  const Node before = linearForm(g, g.make(Op::Equal, 1, g.make(Op::Add, 16, x, y), f.number(100, 16)));
  const Node after =
      g.make(Op::Equal, 1, g.make(Op::Add, 16, changed(x, Op::Sub), changed(y, Op::Add)), f.number(100, 16));
  EXPECT_EQ(linearForm(g, after), before);
}

TEST(LinearForm, FactorsAndSides) {
  // VD4 + 25 = 25 (VD0 + 1) is VD4 = 25 VD0, however it is written.
  Family f;
  Graph& g = *f.graph;
  const Node n = f.state("VD0", 32), sum = f.state("VD4", 32);
  const auto times = [&](Node a) { return g.make(Op::Mul, 32, a, f.number(25, 32)); };
  const Node before = linearForm(g, g.make(Op::Equal, 1, sum, times(n)));
  const Node after =
      g.make(Op::Equal, 1, times(g.make(Op::Add, 32, n, f.number(1, 32))), g.make(Op::Add, 32, sum, f.number(25, 32)));
  EXPECT_EQ(linearForm(g, after), before);
  EXPECT_EQ(linearForm(g, g.make(Op::Equal, 1, g.make(Op::Sub, 32, times(n), sum), f.number(0, 32))), before);
}

// VW0 - 1 as a number of 32 bits is one less than VW0, but for -32,768: there it is 65,535 more.
TEST(LinearForm, SignExtensionsWithTheirOverflow) {
  Family f;
  Graph& g = *f.graph;
  const Node x = f.state("VW0", 16), y = f.state("VW2", 16);
  const auto wide = [&](Node n) { return g.make(Op::Sext, 32, n); };
  for (const Op op : {Op::Add, Op::Sub}) {
    const Node given = g.make(Op::Equal, 1, g.make(Op::Add, 32, wide(g.make(op, 16, x, f.number(5, 16))), wide(y)),
                              f.number(1200, 32));
    const Node form = linearForm(g, given);
    EXPECT_NE(form, given);
    const Node roots[] = {given, form};
    Evaluator evaluator(g, roots);
    for (const std::uint64_t a :
         {0U, 4U, 5U, 6U, 1195U, 32762U, 32763U, 32767U, 32768U, 32772U, 32773U, 65531U, 65535U}) {
      for (std::uint64_t b = 0; b < 65536; ++b) {
        evaluator.set(x, a);
        evaluator.set(y, b);
        evaluator.run();
        ASSERT_EQ(evaluator[given], evaluator[form]) << a << " " << b;
      }
    }
  }
}

TEST(LinearForm, SameMeaningForAllValues) {
  constexpr unsigned formSeed = 5119;
  std::mt19937 random(formSeed);
  int changed = 0;
  for (int n = 0; n < 300; ++n) {
    SCOPED_TRACE(testing::Message() << "seed " << formSeed << ", system " << n);
    const Family f = words::randomWords(random);
    Graph& g = *f.graph;
    std::vector<Node> variables = words::stateNodes(f.system);
    variables.insert(variables.end(), f.system.inputs.begin(), f.system.inputs.end());
    for (std::uint32_t i = 0, size = static_cast<std::uint32_t>(g.size()); i < size; ++i) {
      const Node given = static_cast<Node>(i);
      if (g[given].op != Op::Equal) continue;
      const Node form = linearForm(g, given);
      if (form == given) continue;
      ++changed;
      const Node roots[] = {given, form};
      Evaluator evaluator(g, roots);
      for (int trial = 0; trial < 50; ++trial) {
        for (const Node v : variables) evaluator.set(v, random() & Graph::maskOf(g[v].width));
        evaluator.run();
        ASSERT_EQ(evaluator[given], evaluator[form]);
      }
    }
  }
  EXPECT_GT(changed, 100);
}

}  // namespace
}  // namespace rungproof
