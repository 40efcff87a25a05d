// Words that give to each other: what a scan adds to each, and the theorem about their sum that solvers are told.
#include <gtest/gtest.h>

#include <random>

#include "analysis/graph/evaluate.hpp"
#include "analysis/portfolio/invariants_sums.hpp"
#include "analysis/portfolio/sum_facts.hpp"
#include "analysis/portfolio/word_change.hpp"

namespace rungproof::test {
namespace {

TEST(WordChange, FollowsChoices) {
  Graph graph;
  const Node word = graph.variable("word", 16, true), amount = graph.variable("amount", 16, false);
  const Node gives = graph.variable("gives", 1, false), gets = graph.variable("gets", 1, false);
  const Node one = graph.constantNode(1, 16), less = graph.make(Op::Sub, 16, word, one);
  const Node given = graph.make(Op::Ite, 16, gives, less, word);
  const Node got = graph.make(Op::Ite, 16, gets, graph.make(Op::Add, 16, given, amount), given);
  const auto partsOf = [&](Node next) { return changeOf(graph, word, next).value().parts; };
  EXPECT_EQ(partsOf(got), (AddedParts{{{gives, one}, -1}, {{gets, amount}, 1}}));
  EXPECT_EQ(changeOf(graph, word, got)->counts, noNode);
  EXPECT_EQ(partsOf(word), AddedParts{});
  // 5 is no sum of the word: it counts where 5 is not stored.
  const Node set = graph.make(Op::Ite, 16, gets, graph.constantNode(5, 16), less);
  EXPECT_EQ(partsOf(set), (AddedParts{{{noNode, one}, -1}}));
  EXPECT_EQ(changeOf(graph, word, set)->counts, graph.make(Op::Not, 1, gets));
  EXPECT_FALSE(changeOf(graph, word, amount).has_value());
  EXPECT_FALSE(changeOf(graph, word, graph.make(Op::Add, 16, word, word)).has_value());
}

/// A word that ten thousand networks count up one after the other is none of an account; the search ends soon.
TEST(WordChange, LongProgramsAreLeftAlone) {
  Graph graph;
  const Node word = graph.variable("word", 16, true), one = graph.constantNode(1, 16);
  Node next = word;
  for (int i = 0; i < 10'000; ++i) {
    const Node counts = graph.variable("counts" + std::to_string(i), 1, false);
    next = graph.make(Op::Ite, 16, counts, graph.make(Op::Add, 16, next, one), next);
  }
  EXPECT_FALSE(changeOf(graph, word, next).has_value());
}

/// Accounts in a ring, of which each gives one to the next where its input is on and something is left. Bad: the sum
/// is not 9, or one is negative.
class Ring {
 public:
  explicit Ring(int n) {
    system.graph = &graph;
    std::vector<Node> next;
    for (int i = 0; i < n; ++i) {
      system.states.push_back(
          {graph.variable("account" + std::to_string(i), 16, true), graph.constantNode(i == 0 ? 9 : 0, 16), noNode});
      system.inputs.push_back(graph.variable("give" + std::to_string(i), 1, false));
      next.push_back(system.states.back().node);
    }
    const Node zero = graph.constantNode(0, 16), one = graph.constantNode(1, 16);
    for (int i = 0; i < n; ++i) {
      Node& from = next[static_cast<std::size_t>(i)];
      Node& to = next[static_cast<std::size_t>((i + 1) % n)];
      const Node gives =
          graph.make(Op::And, 1, system.inputs[static_cast<std::size_t>(i)], graph.make(Op::Slt, 1, zero, from));
      from = graph.make(Op::Ite, 16, gives, graph.make(Op::Sub, 16, from, one), from);
      to = graph.make(Op::Ite, 16, gives, graph.make(Op::Add, 16, to, one), to);
    }
    Node sum = noNode;
    for (int i = 0; i < n; ++i) {
      const Node end = next[static_cast<std::size_t>(i)], term = graph.make(Op::Sext, 32, end);
      system.states[static_cast<std::size_t>(i)].next = end;
      sum = i == 0 ? term : graph.make(Op::Add, 32, sum, term);
    }
    const Node same = graph.make(Op::Equal, 1, sum, graph.constantNode(9, 32));
    system.questions.push_back({"sum", graph.make(Op::Not, 1, same), 0});
  }

  Graph graph;
  TransitionSystem system;
};

TEST(Sums, TheirTheoremHoldsWhateverTheWordsAre) {
  constexpr unsigned seed = 29;
  RecordProperty("seed", seed);
  std::mt19937_64 random(seed);
  for (const int n : {2, 3, 8}) {
    Ring ring(n);
    const AskedSums asked = sumsAskedFor(ring.system, {0});
    ASSERT_EQ(asked.sums.size(), 1U);
    ASSERT_EQ(asked.theorems.size(), 1U);
    EXPECT_TRUE(consistsOfSums(ring.graph, asked.sums[0]));
    Evaluator evaluator(ring.graph, asked.theorems);
    for (int sample = 0; sample < 2000; ++sample) {
      for (const StateVariable& state : ring.system.states) {
        const std::uint64_t value = random() & 0xFFFFU;
        const std::uint64_t ends[] = {value, 0x7FFF, 0x8000, 0, 1, 0xFFFF};
        evaluator.set(state.node, ends[random() % 6]);
      }
      for (const Node input : ring.system.inputs) evaluator.set(input, random() & 1U);
      evaluator.run();
      ASSERT_EQ(evaluator[asked.theorems[0]], 1U) << n << " accounts, seed " << seed << ", sample " << sample;
    }
  }
}

/// (x + y) + z of words with sign, extended by a bit for each addition: no sum overflows, so that every fact is true.
TEST(Sums, FactsAreTrueOfAnyWords) {
  constexpr unsigned seed = 30;
  RecordProperty("seed", seed);
  std::mt19937_64 random(seed);
  Graph graph;
  std::vector<Node> words;
  for (const char* name : {"x", "y", "z"}) words.push_back(graph.variable(name, 16, true));
  const auto extended = [&](Node n, int width) { return graph.make(Op::Sext, width, n); };
  const Node two = graph.make(Op::Add, 17, extended(words[0], 17), extended(words[1], 17));
  const Node sum = graph.make(Op::Add, 18, extended(two, 18), extended(words[2], 18));
  const std::vector<Node> facts = factsOfSum(graph, sum, {0, 100, 30000});
  // Two additions: not below zero, two parts and two limits each; then four parts against the whole.
  EXPECT_EQ(facts.size(), 14U);
  Evaluator evaluator(graph, facts);
  for (int sample = 0; sample < 5000; ++sample) {
    for (const Node word : words) {
      const std::uint64_t value = random() & 0xFFFFU;
      const std::uint64_t ends[] = {value, value % 101, value % 30001, 0x7FFF, 0x8000, 0};
      evaluator.set(word, ends[random() % 6]);
    }
    evaluator.run();
    for (const Node fact : facts) ASSERT_EQ(evaluator[fact], 1U) << "seed " << seed << ", sample " << sample;
  }
}

}  // namespace
}  // namespace rungproof::test
