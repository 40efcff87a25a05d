// The SAT solver's interface: answers against trying all assignments, failed assumptions, temporary clauses, and the
// clauses that a graph literal brings.
#include "analysis/bits/sat.hpp"

#include <gtest/gtest.h>

#include <random>

#include "analysis/bits/bit_cnf.hpp"

namespace rungproof {
namespace {

using Outcome = Sat::Outcome;
using Clauses = std::vector<std::vector<int>>;

bool satisfies(const Clauses& clauses, unsigned assignment) {
  for (const std::vector<int>& clause : clauses) {
    bool holds = false;
    for (const int l : clause) holds = holds || ((assignment >> (std::abs(l) - 1) & 1U) != 0) == (l > 0);
    if (!holds) return false;
  }
  return true;
}

// 200 random sets of 3-literal clauses over eight variables, hard enough that both answers are frequent.
TEST(Sat, AgreesWithTryingAllAssignments) {
  constexpr unsigned seed = 99;
  SCOPED_TRACE(testing::Message() << "seed " << seed);
  std::mt19937 random(seed);
  int satisfiable = 0;
  for (int round = 0; round < 200; ++round) {
    Sat sat(round % 2 == 0 ? Sat::Use::Few : Sat::Use::Many);
    for (int v = 0; v < 8; ++v) sat.newVariable();
    Clauses clauses;
    for (int c = 0; c < 36; ++c) {
      std::vector<int>& clause = clauses.emplace_back();
      for (int l = 0; l < 3; ++l)
        clause.push_back(static_cast<int>(1 + random() % 8) * ((random() & 1U) != 0 ? 1 : -1));
      sat.add(clause);
    }
    bool expected = false;
    for (unsigned assignment = 0; assignment < 256; ++assignment) expected = expected || satisfies(clauses, assignment);
    ASSERT_EQ(sat.solve({}, Budget::seconds(10)) == Outcome::Satisfiable, expected) << "round " << round;
    satisfiable += expected ? 1 : 0;
    if (!expected) continue;
    unsigned model = 0;
    for (int v = 1; v <= 8; ++v) model |= (sat.value(v) ? 1U : 0U) << (v - 1);
    EXPECT_TRUE(satisfies(clauses, model)) << "round " << round;
  }
  EXPECT_GT(satisfiable, 20);
  EXPECT_LT(satisfiable, 180);
}

TEST(Sat, AssumptionsFailByName) {
  Sat sat(Sat::Use::Many);
  const int a = sat.newVariable(), b = sat.newVariable(), c = sat.newVariable();
  sat.add({-a, -b});
  EXPECT_EQ(sat.solve({a, b, c}, Budget::seconds(10)), Outcome::Unsatisfiable);
  EXPECT_TRUE(sat.failed(a));
  EXPECT_TRUE(sat.failed(b));
  EXPECT_FALSE(sat.failed(c)) << "c plays no part";
  EXPECT_EQ(sat.solve({a, c}, Budget::seconds(10)), Outcome::Satisfiable) << "assumptions are of one call";
}

TEST(Sat, TemporaryClausesAreForgotten) {
  Sat sat(Sat::Use::Many);
  const int a = sat.newVariable();
  sat.add({a});
  const std::vector<int> never{-a};
  EXPECT_EQ(sat.solve(std::span<const int>{}, Budget::seconds(10), never), Outcome::Unsatisfiable);
  EXPECT_EQ(sat.solve({}, Budget::seconds(10)), Outcome::Satisfiable);
}

TEST(BitCnf, LiteralsMeanTheirGates) {
  BitSystem graph;
  const Lit a = graph.addInput(), b = graph.addInput(), c = graph.addInput();
  const Lit choice = graph.addIte(c, graph.addAnd(a, b), graph.addXor(a, b));
  Sat sat(Sat::Use::Many);
  BitCnf cnf(graph, sat);
  const int l = cnf.literal(choice), inputs[] = {cnf.literal(a), cnf.literal(b), cnf.literal(c)};
  for (unsigned assignment = 0; assignment < 8; ++assignment) {
    const bool x = (assignment & 1U) != 0, y = (assignment & 2U) != 0, z = (assignment & 4U) != 0;
    const bool expected = z ? x && y : x != y;
    const std::vector<int> wrong{x ? inputs[0] : -inputs[0], y ? inputs[1] : -inputs[1], z ? inputs[2] : -inputs[2],
                                 expected ? -l : l};
    EXPECT_EQ(sat.solve(wrong, Budget::seconds(10)), Outcome::Unsatisfiable) << assignment;
  }
}

TEST(Sat, ATemporaryClauseIsGoneAfterAnInterruptedCall) {
  // Twelve pigeons in eleven holes, asked for under `gate`: out of reach for a twentieth of a second. The clause "not
  // x" of that call must not speak in the next one, which asks for x.
  Sat sat(Sat::Use::Many);
  const int gate = sat.newVariable(), x = sat.newVariable();
  constexpr int pigeons = 12, holes = pigeons - 1;
  int in[pigeons][holes];
  for (auto& row : in) {
    for (int& variable : row) variable = sat.newVariable();
  }
  for (const auto& row : in) {
    std::vector<int> somewhere{-gate};
    somewhere.insert(somewhere.end(), std::begin(row), std::end(row));
    sat.add(somewhere);
  }
  for (int hole = 0; hole < holes; ++hole) {
    for (int a = 0; a < pigeons; ++a) {
      for (int b = 0; b < a; ++b) sat.add({-gate, -in[a][hole], -in[b][hole]});
    }
  }
  const int assumed[] = {gate}, temporary[] = {-x};
  ASSERT_EQ(sat.solve(assumed, Budget::seconds(0.05), temporary), Sat::Outcome::Unknown);
  EXPECT_EQ(sat.solve({-gate, x}, Budget::seconds(20)), Sat::Outcome::Satisfiable);
}

}  // namespace
}  // namespace rungproof
