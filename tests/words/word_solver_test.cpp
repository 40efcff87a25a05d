// Both solvers answer the same questions about words: literals, clauses for good and for one call, cores, values.
#include "analysis/words/word_solver.hpp"

#include <gtest/gtest.h>

#include "analysis/bits/bit_blast.hpp"
#include "tests/solver/families.hpp"

namespace rungproof {
namespace {

using families::Family;

class WordSolvers : public testing::TestWithParam<bool> {
 protected:
  WordSolvers() {
    Graph& g = *f.graph;
    x = f.state("VW0", 16);
    y = f.state("VW2", 16);
    f.ask("both", g.make(Op::Ult, 1, x, y));
    below = g.make(Op::Ult, 1, x, y);
    above = g.make(Op::Ult, 1, y, x);
    large = g.make(Op::Ult, 1, f.number(30000, 16), x);
    blast = std::make_unique<BitBlast>(f.system, std::vector<std::size_t>{0});
    solver = GetParam() ? makeBitSolver(*blast) : makeTermSolver(*f.graph);
  }
  Sat::Outcome ask(const std::vector<int>& assumptions, const std::vector<int>& temporary = {}) {
    return solver->solve(assumptions, Budget::seconds(10), temporary);
  }
  Family f;
  Node x, y, below, above, large;
  std::unique_ptr<BitBlast> blast;
  std::unique_ptr<WordSolver> solver;
};

TEST_P(WordSolvers, ValuesMeetTheAssumptions) {
  ASSERT_EQ(ask({solver->literal(below), solver->literal(large)}), Sat::Outcome::Satisfiable);
  EXPECT_GT(solver->value(x), 30000U);
  EXPECT_LT(solver->value(x), solver->value(y));
}

TEST_P(WordSolvers, CoresLeaveOutWhatDoesNotMatter) {
  const int a = solver->literal(below), b = solver->literal(above), c = solver->literal(large);
  ASSERT_EQ(ask({c, a, b}), Sat::Outcome::Unsatisfiable);  // x < y and y < x
  EXPECT_TRUE(solver->failed(a));
  EXPECT_TRUE(solver->failed(b));
  EXPECT_FALSE(solver->failed(c));
}

TEST_P(WordSolvers, ClausesStayAndTemporaryOnesGo) {
  const int a = solver->literal(below), b = solver->literal(above);
  const int either[] = {a, b};
  solver->add(either);
  EXPECT_EQ(ask({-a}, {-b}), Sat::Outcome::Unsatisfiable);
  EXPECT_EQ(ask({-a}), Sat::Outcome::Satisfiable);
  EXPECT_EQ(ask({-a, -b}), Sat::Outcome::Unsatisfiable);
}

TEST_P(WordSolvers, FixedValues) {
  std::vector<int> values;
  solver->literal(below);
  solver->fix(x, 100, values);
  solver->fix(y, 101, values);
  EXPECT_EQ(ask(values), Sat::Outcome::Satisfiable);
  values.push_back(-solver->literal(below));
  EXPECT_EQ(ask(values), Sat::Outcome::Unsatisfiable);
}

INSTANTIATE_TEST_SUITE_P(Kinds, WordSolvers, testing::Bool(),
                         [](const auto& info) { return info.param ? "bits" : "terms"; });

}  // namespace
}  // namespace rungproof
