// The checker of refutations accepts what follows by unit propagation and nothing else.
#include "analysis/recheck/rup_checker.hpp"

#include <gtest/gtest.h>

#include <random>

namespace rungproof::test {
namespace {

using Literals = std::vector<int>;

void give(RupChecker& checker, const std::vector<Literals>& clauses) {
  for (const Literals& clause : clauses) checker.add(clause);
}

/// All signs of two variables: no assignment meets them, and no clause is a unit.
const std::vector<Literals> square = {{1, 2}, {1, -2}, {-1, 2}, {-1, -2}};

TEST(RupChecker, UnitsThatContradictEachOtherAreRefutedAtOnce) {
  RupChecker checker(3);
  give(checker, {{1}, {-1, 2}, {-2, 3}});
  EXPECT_FALSE(checker.isRefuted());
  checker.add(Literals{-3});
  EXPECT_TRUE(checker.isRefuted());
}

TEST(RupChecker, TheEmptyClauseIsNotTakenBeforeItFollows) {
  RupChecker checker(2);
  give(checker, square);
  EXPECT_FALSE(checker.derive(Literals{}));
  EXPECT_FALSE(checker.isRefuted());
  EXPECT_TRUE(checker.derive(Literals{1}));  // not 1 gives 2 and not 2
  EXPECT_TRUE(checker.isRefuted());          // 1 gives 2 and not 2
}

TEST(RupChecker, WhatDoesNotFollowIsRefused) {
  // 1 or 2 or 3 says nothing about 1 or 2; a clause that merely keeps the formula satisfiable, as 4 does, is none.
  RupChecker checker(4);
  give(checker, {{1, 2, 3}, {-3, 4}});
  EXPECT_FALSE(checker.derive(Literals{1, 2}));
  EXPECT_FALSE(checker.derive(Literals{4}));
  EXPECT_TRUE(checker.derive(Literals{1, 2, 4}));
}

TEST(RupChecker, AForgottenClauseIsOfNoUseAnyMore) {
  RupChecker checker(6);
  give(checker, {{1, 2, 3}, {-3, 4, 5}});
  EXPECT_TRUE(checker.derive(Literals{1, 2, 4, 5}));
  checker.forget(Literals{5, 4, 2, 1});
  // Not derivable from the first two by propagation alone once 3 is open: 1, 2 false gives 3; so it still follows.
  EXPECT_TRUE(checker.derive(Literals{1, 2, 4, 5}));
  // Given clauses stay, whatever is said.
  checker.forget(Literals{1, 2, 3});
  EXPECT_TRUE(checker.derive(Literals{1, 2, 4, 5}));
}

TEST(RupChecker, TautologiesAndRepeatedLiterals) {
  RupChecker checker(2);
  checker.add(Literals{1, -1});
  checker.add(Literals{2, 2});
  EXPECT_FALSE(checker.isRefuted());
  EXPECT_TRUE(checker.derive(Literals{2}));
  EXPECT_FALSE(checker.derive(Literals{1}));
}

/// Whether some assignment meets the clauses; at most 20 variables.
bool isSatisfiable(const std::vector<Literals>& clauses, int variables) {
  for (unsigned values = 0; values < 1U << static_cast<unsigned>(variables); ++values) {
    const auto holds = [&](int l) { return ((values >> static_cast<unsigned>(std::abs(l) - 1) & 1U) != 0) == (l > 0); };
    const bool all = std::ranges::all_of(clauses, [&](const Literals& c) { return std::ranges::any_of(c, holds); });
    if (all) return true;
  }
  return false;
}

TEST(RupChecker, RandomClausesAreDerivedOnlyWhereTheyFollow) {
  const unsigned seed = 20261125;
  std::mt19937 random(seed);
  constexpr int variables = 6;
  const auto randomClause = [&] {
    Literals clause;
    for (int i = 0; i < 3; ++i) {
      const int v = 1 + static_cast<int>(random() % variables);
      clause.push_back(random() % 2 == 0 ? v : -v);
    }
    return clause;
  };
  std::size_t derived = 0, refuted = 0;
  for (int round = 0; round < 800; ++round) {
    std::vector<Literals> clauses;
    RupChecker checker(variables);
    const int count = 8 + static_cast<int>(random() % 30);
    for (int i = 0; i < count; ++i) {
      clauses.push_back(randomClause());
      checker.add(clauses.back());
    }
    for (int step = 0; step < 20; ++step) {
      const Literals clause = randomClause();
      if (!checker.derive(clause)) continue;
      ++derived;
      std::vector<Literals> opposite = clauses;
      for (const int l : clause) opposite.push_back({-l});
      EXPECT_FALSE(isSatisfiable(opposite, variables)) << "seed " << seed << ", round " << round;
    }
    if (!checker.isRefuted()) continue;
    ++refuted;
    EXPECT_FALSE(isSatisfiable(clauses, variables)) << "seed " << seed << ", round " << round;
  }
  EXPECT_GT(derived, 500U);
  EXPECT_GT(refuted, 20U);
}

}  // namespace
}  // namespace rungproof::test
