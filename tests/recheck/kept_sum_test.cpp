// Sums of words that change by parts which go from one to another: what the form is said to keep, numbers keep.
#include <gtest/gtest.h>

#include <random>

#include "analysis/graph/evaluate.hpp"
#include "analysis/recheck/kept_difference.hpp"

namespace rungproof::test {
namespace {

constexpr int narrow = 8, wide = 16;

/// Words of 8 bits that become other ones by parts, as terms of 16 bits, and the sum of those.
class RandomSum {
 public:
  explicit RandomSum(std::mt19937& random) : random_(random) {
    std::vector<Node> parts, amounts;
    for (int i = 0; i < 4; ++i) {
      parts.push_back(graph.variable("part" + std::to_string(i), narrow, false));
      amounts.push_back(graph.make(any(2) != 0 ? Op::Sext : Op::Zext, wide, parts.back()));
    }
    variables = parts;
    std::vector<std::pair<Node, bool>> changes;
    const std::uint32_t count = 2 + any(3);
    kept.sum = graph.constantNode(any(1000), wide);
    for (std::uint32_t i = 0; i < count; ++i) {
      const Node word = graph.variable("word" + std::to_string(i), narrow, true);
      words.push_back(word);
      variables.push_back(word);
      const Node term = graph.make(any(2) != 0 ? Op::Sext : Op::Zext, wide, word);
      SumTerm t{term, term, any(3) == 0, noNode};
      for (std::uint32_t k = any(4); k > 0; --k) {
        const Node amount = amounts[any(4)];
        const bool isTaken = any(2) != 0;
        t.next = graph.make(isTaken ? Op::Sub : Op::Add, wide, t.next, amount);
        changes.emplace_back(amount, isTaken != t.isSubtracted);
      }
      kept.sum = graph.make(t.isSubtracted ? Op::Sub : Op::Add, wide, kept.sum, term);
      kept.terms.push_back(t);
    }
    kept.next = kept.sum;
    std::shuffle(changes.begin(), changes.end(), random_);
    for (const auto& [amount, isTaken] : changes)
      kept.next = graph.make(isTaken ? Op::Sub : Op::Add, wide, kept.next, amount);
  }

  std::uint32_t any(std::uint32_t below) { return std::uniform_int_distribution<std::uint32_t>(0, below - 1)(random_); }

  /// For one random scan: nothing where some word does not become what its term is said to, else whether the sum does.
  std::optional<bool> keepsOnce() {
    std::vector<Node> roots{kept.sum, kept.next};
    for (const SumTerm& t : kept.terms) roots.insert(roots.end(), {t.term, t.next});
    Evaluator before(graph, roots), after(graph, roots);
    for (const Node v : variables) before.set(v, (any(60) - 20) & 0xFFU);
    before.run();
    for (std::size_t i = 0; i < words.size(); ++i) after.set(words[i], before[kept.terms[i].next] & 0xFFU);
    after.run();
    for (const SumTerm& t : kept.terms) {
      if (after[t.term] != before[t.next]) return std::nullopt;
    }
    return after[kept.sum] == before[kept.next];
  }

  Graph graph{Rewriting::None};
  KeptSum kept;
  std::vector<Node> words, variables;

 private:
  std::mt19937& random_;
};

TEST(KeptSum, IsWhatItsFormSays) {
  constexpr unsigned seed = 27;
  RecordProperty("seed", seed);
  std::mt19937 random(seed);
  int judged = 0;
  for (int round = 0; round < 400; ++round) {
    RandomSum sum(random);
    ASSERT_TRUE(consistsOfSums(sum.graph, sum.kept)) << "seed " << seed << ", round " << round;
    for (int sample = 0; sample < 20; ++sample) {
      const std::optional<bool> keeps = sum.keepsOnce();
      if (!keeps) continue;
      ++judged;
      ASSERT_TRUE(*keeps) << "seed " << seed << ", round " << round;
    }
  }
  EXPECT_GT(judged, 2000);
}

/// One change too many, at the sum or at a word: wherever the form still holds, so do the numbers.
TEST(KeptSum, AnotherChangeIsNoticed) {
  constexpr unsigned seed = 28;
  RecordProperty("seed", seed);
  std::mt19937 random(seed);
  int refused = 0, broken = 0;
  for (int round = 0; round < 400; ++round) {
    RandomSum sum(random);
    Node& changed = sum.any(2) != 0 ? sum.kept.next : sum.kept.terms[sum.any(2)].next;
    const Node part = sum.graph.make(Op::Sext, wide, sum.variables[sum.any(4)]);
    changed = sum.graph.make(sum.any(2) != 0 ? Op::Add : Op::Sub, wide, changed, part);
    ASSERT_FALSE(consistsOfSums(sum.graph, sum.kept)) << "seed " << seed << ", round " << round;
    ++refused;
    for (int sample = 0; sample < 20; ++sample) {
      if (sum.keepsOnce() == false) {
        ++broken;
        break;
      }
    }
  }
  EXPECT_EQ(refused, 400);
  EXPECT_GT(broken, 200);
}

/// Sext(x + y) is Sext(x) + Sext(y) where x and y are words extended by a bit, but not where the sum may overflow.
TEST(KeptSum, LooksIntoExactSumsOnly) {
  for (const int room : {0, 1}) {
    Graph graph(Rewriting::None);
    const Node x = graph.variable("x", narrow, true), y = graph.variable("y", narrow, true);
    const auto extended = [&](Node n, int width) {
      return graph[n].width == width ? n : graph.make(Op::Sext, width, n);
    };
    const int width = narrow + room;
    const Node inner = graph.make(Op::Add, width, extended(x, width), extended(y, width));
    KeptSum kept;
    for (const Node word : {x, y}) kept.terms.push_back({extended(word, wide), extended(word, wide), false, noNode});
    kept.sum = kept.next = extended(inner, wide);
    EXPECT_EQ(consistsOfSums(graph, kept), room == 1);
  }
}

/// An amount that was doubled forty times is not written out as 2^40 amounts.
TEST(KeptSum, LeavesDoubledAmountsAlone) {
  Graph graph(Rewriting::None);
  const Node word = graph.variable("word", wide, true);
  Node amount = graph.variable("amount", wide, false);
  for (int i = 0; i < 40; ++i) amount = graph.make(Op::Add, wide, amount, amount);
  const Node next = graph.make(Op::Add, wide, word, amount);
  EXPECT_FALSE(consistsOfSums(graph, KeptSum{{{word, next, false, noNode}}, word, next, {}, {}}));
}

}  // namespace
}  // namespace rungproof::test
