// Runs on numbers: found where comparisons tell the inputs and arithmetic makes circuits long; nothing is looked at
// without such arithmetic.
#include "analysis/portfolio/word_runs.hpp"

#include <gtest/gtest.h>

#include "analysis/graph/evaluate.hpp"
#include "families.hpp"

namespace rungproof {
namespace {

using families::Family;

/// bad: in = 4711 and (in - 4711) * (in - 4711) = x, a state that starts with 0.
struct Product : Family {
  Node in;
  explicit Product(Op product) {
    in = input("in", 32);
    const Node x = state("x", 32);
    const Node rest = graph->make(Op::Sub, 32, in, number(4711, 32));
    const Node made = graph->make(product, 32, rest, in);
    ask("hit", both(graph->make(Op::Equal, 1, in, number(4711, 32)), graph->make(Op::Equal, 1, made, x)));
  }
};

TEST(WordRuns, FollowComparisons) {
  Product f(Op::Mul);
  const auto runs = wordRuns(f.system, {0}, 1, Budget::seconds(10));
  ASSERT_TRUE(runs[0].has_value());
  // The run is one: its last scan is bad on numbers.
  ASSERT_FALSE(runs[0]->inputs.empty());
  EXPECT_EQ(runs[0]->inputs.back()[0], 4711U);
}

TEST(WordRuns, LeaveShortCircuitsAlone) {
  Product f(Op::Add);
  EXPECT_FALSE(wordRuns(f.system, {0}, 1, Budget::seconds(10))[0].has_value());
}

TEST(WordRuns, FindNothingThatIsNot) {
  Family f;
  const Node in = f.input("in", 32);
  const Node square = f.graph->make(Op::Mul, 32, in, in);
  // A square is 0 or 1 modulo 4.
  f.ask("never", f.graph->make(Op::Equal, 1, f.graph->make(Op::And, 32, square, f.number(3, 32)), f.number(3, 32)));
  EXPECT_FALSE(wordRuns(f.system, {0}, 1, Budget::seconds(10))[0].has_value());
}

}  // namespace
}  // namespace rungproof
