// The checker's own circuits against the evaluator of nodes and against Z3, operation by operation; refutations of what
// holds, values for what does not.
#include "analysis/recheck/scan_clauses.hpp"

#include <gtest/gtest.h>

#include <random>

#include "analysis/graph/evaluate.hpp"
#include "analysis/graph/z3_terms.hpp"
#include "analysis/recheck/kept_difference.hpp"
#include "analysis/recheck/refutation.hpp"

namespace rungproof::test {
namespace {

constexpr RefutationLimits enough{60, nullptr};

struct Operation {
  Op op;
  bool isComparison = false;
};
constexpr Operation operations[] = {
    {Op::And},         {Op::Or},        {Op::Xor},       {Op::Add},       {Op::Sub},      {Op::Mul},
    {Op::Udiv},        {Op::Urem},      {Op::Sdiv},      {Op::Srem},      {Op::Shl},      {Op::Lshr},
    {Op::Equal, true}, {Op::Ult, true}, {Op::Ule, true}, {Op::Slt, true}, {Op::Sle, true}};

CheckResult checkOf(const TransitionSystem& system, const Formula& formula) {
  ScanClauses clauses(system);
  const int literal = clauses.literalOf(formula);
  return refute(clauses.gates().clausesOf(literal), enough);
}

/// Whether a value other than that of the evaluator is refuted and the value itself is not.
void expectValue(Graph& graph, Node result, const std::vector<std::pair<Node, std::uint64_t>>& values,
                 const std::string& what) {
  const Node roots[] = {result};
  Evaluator evaluator(graph, roots);
  TransitionSystem system;
  system.graph = &graph;
  std::vector<Formula> parts;
  for (const auto& [variable, value] : values) {
    evaluator.set(variable, value);
    parts.push_back(equals({variable, 0}, {graph.constantNode(value, graph[variable].width), 0}));
  }
  evaluator.run();
  const Formula same = equals({result, 0}, {graph.constantNode(evaluator[result], graph[result].width), 0});
  std::vector<Formula> other = parts;
  parts.push_back(same);
  other.push_back(notOf(same));
  EXPECT_EQ(checkOf(system, allOf(parts)), CheckResult::Invalid) << what;
  EXPECT_EQ(checkOf(system, allOf(other)), CheckResult::Valid) << what;
}

TEST(ScanClauses, EachOperationHasTheValueOfTheEvaluator) {
  const unsigned seed = 17;
  std::mt19937_64 random(seed);
  for (const auto& [op, isComparison] : operations) {
    for (const int width : {1, 2, 7, 16, 32}) {
      for (int round = 0; round < 6; ++round) {
        Graph graph(Rewriting::None);
        const Node a = graph.variable("a", width, false), b = graph.variable("b", width, false);
        const Node result = graph.make(op, isComparison ? 1 : width, a, b);
        const std::uint64_t mask = Graph::maskOf(width);
        const std::uint64_t x = round == 0 ? mask : random() & mask;
        // Zero, one, few and any: what divisions and shifts differ by.
        const std::uint64_t y = (round == 1 ? 0 : round == 2 ? 1 : round == 3 ? random() % 9 : random()) & mask;
        expectValue(
            graph, result, {{a, x}, {b, y}},
            fmt::format("seed {}: operation {} of {} bits on {} and {}", seed, static_cast<int>(op), width, x, y));
      }
    }
  }
}

TEST(ScanClauses, WordsAreCutJoinedAndChosenAsTheEvaluatorSays) {
  std::mt19937_64 random(5);
  for (int round = 0; round < 20; ++round) {
    Graph graph(Rewriting::None);
    const Node a = graph.variable("a", 12, false), b = graph.variable("b", 5, false), c = graph.variable("c", 1, false);
    const std::vector<std::pair<Node, std::uint64_t>> values = {
        {a, random() & 0xFFF}, {b, random() & 0x1F}, {c, random() & 1}};
    const Node joined = graph.make(Op::Concat, 17, a, b);
    const Node cut = graph.make(Op::Extract, 5, a, noNode, noNode, 3);
    for (const Node n : {joined, cut, graph.make(Op::Zext, 20, b), graph.make(Op::Sext, 20, b),
                         graph.make(Op::Not, 12, a), graph.make(Op::Ite, 5, c, b, cut)})
      expectValue(graph, n, values, fmt::format("round {}, node {}", round, indexOf(n)));
  }
}

/// Laws that relate operations, each decided by Z3 for all values too.
TEST(ScanClauses, LawsOfArithmeticAsZ3HasThem) {
  Graph graph(Rewriting::None);
  const Node a = graph.variable("a", 6, false), b = graph.variable("b", 6, false);
  const auto make = [&](Op op, Node x, Node y) { return graph.make(op, 6, x, y); };
  const auto same = [&](Node x, Node y) { return graph.make(Op::Equal, 1, x, y); };
  const Node two = graph.constantNode(2, 6), one = graph.constantNode(1, 6), zero = graph.constantNode(0, 6);
  const std::vector<Node> laws = {
      same(make(Op::Add, make(Op::Mul, make(Op::Udiv, a, b), b), make(Op::Urem, a, b)), a),
      same(make(Op::Add, make(Op::Mul, make(Op::Sdiv, a, b), b), make(Op::Srem, a, b)), a),
      same(make(Op::Mul, a, two), make(Op::Shl, a, one)),
      same(make(Op::Udiv, a, two), make(Op::Lshr, a, one)),
      same(make(Op::Sdiv, a, two), make(Op::Lshr, a, one)),  // not of negative numbers
      same(make(Op::Sub, zero, a), make(Op::Sub, make(Op::Sub, b, a), b)),
      graph.make(Op::Or, 1, graph.make(Op::Slt, 1, a, b), graph.make(Op::Sle, 1, b, a)),
      graph.make(Op::Or, 1, graph.make(Op::Ult, 1, a, b), graph.make(Op::Ult, 1, b, a)),  // not of equal ones
  };
  TransitionSystem system;
  system.graph = &graph;
  std::size_t holding = 0;
  for (std::size_t i = 0; i < laws.size(); ++i) {
    const Node broken[] = {graph.make(Op::Not, 1, laws[i])};
    const std::optional<bool> satisfiable = rungproof::satisfiable(graph, broken, 60'000);
    ASSERT_TRUE(satisfiable.has_value());
    holding += *satisfiable ? 0 : 1;
    EXPECT_EQ(checkOf(system, notOf(truthOf(laws[i], 0))), *satisfiable ? CheckResult::Invalid : CheckResult::Valid)
        << "law " << i;
  }
  EXPECT_EQ(holding, 6U);
}

/// A word that counts one on in each scan while an input is on.
struct CountingWord {
  CountingWord() {
    count = graph.variable("count", 8, true);
    input = graph.variable("input", 1, false);
    const Node one = graph.constantNode(1, 8);
    next = graph.make(Op::Ite, 8, input, graph.make(Op::Add, 8, count, one), count);
    system.graph = &graph;
    system.states = {{count, graph.constantNode(0, 8), next}};
    system.inputs = {input};
  }
  Formula is(std::uint64_t value, int scan) { return equals({count, scan}, {graph.constantNode(value, 8), 0}); }
  Graph graph{Rewriting::None};
  Node count{}, input{}, next{};
  TransitionSystem system;
};

TEST(ScanClauses, AStateIsWhatTheScanBeforeHasMadeOfIt) {
  CountingWord word;
  EXPECT_EQ(checkOf(word.system, allOf({word.is(0, 0), word.is(3, 3)})), CheckResult::Invalid);
  EXPECT_EQ(checkOf(word.system, allOf({word.is(0, 0), word.is(4, 3)})), CheckResult::Valid);
  EXPECT_EQ(checkOf(word.system, allOf({word.is(0, 0), word.is(3, 3), notOf(truthOf(word.input, 1))})),
            CheckResult::Valid);
}

TEST(ScanClauses, OpenNodesHaveAnyValue) {
  CountingWord word;
  const Node later = word.graph.make(Op::Equal, 1, word.next, word.graph.constantNode(9, 8));
  const Formula jump = allOf({word.is(0, 0), truthOf(later, 0)});
  EXPECT_EQ(checkOf(word.system, jump), CheckResult::Valid);
  ScanClauses open(word.system, {indexOf(word.next)});
  EXPECT_EQ(refute(open.gates().clausesOf(open.literalOf(jump)), enough), CheckResult::Invalid);
}

TEST(ScanClauses, AnEndedCheckSaysNothing) {
  CountingWord word;
  ScanClauses clauses(word.system);
  const int literal = clauses.literalOf(allOf({word.is(0, 0), word.is(3, 3)}));
  EXPECT_EQ(refute(clauses.gates().clausesOf(literal), {0, nullptr}), CheckResult::Unknown);
  const std::atomic<bool> cancel{true};
  EXPECT_EQ(refute(clauses.gates().clausesOf(literal), {60, &cancel}), CheckResult::Unknown);
}

/// Holes and one pigeon more: a refutation of many steps.
TEST(ScanClauses, ARefutationOfManyStepsIsFollowed) {
  constexpr int holes = 6;
  Graph graph(Rewriting::None);
  std::vector<std::vector<Node>> sits;
  for (int pigeon = 0; pigeon <= holes; ++pigeon) {
    std::vector<Node>& row = sits.emplace_back();
    for (int hole = 0; hole < holes; ++hole)
      row.push_back(graph.variable(fmt::format("p{}.{}", pigeon, hole), 1, false));
  }
  TransitionSystem system;
  system.graph = &graph;
  std::vector<Formula> parts;
  for (const std::vector<Node>& row : sits) {
    std::vector<Formula> somewhere;
    for (const Node n : row) somewhere.push_back(truthOf(n, 0));
    parts.push_back(anyOf(std::move(somewhere)));
  }
  for (int hole = 0; hole < holes; ++hole) {
    for (std::size_t a = 0; a < sits.size(); ++a) {
      for (std::size_t b = 0; b < a; ++b)
        parts.push_back(notOf(allOf({truthOf(sits[a][static_cast<std::size_t>(hole)], 0),
                                     truthOf(sits[b][static_cast<std::size_t>(hole)], 0)})));
    }
  }
  EXPECT_EQ(checkOf(system, allOf(parts)), CheckResult::Valid);
  parts.erase(parts.begin());
  EXPECT_EQ(checkOf(system, allOf(parts)), CheckResult::Invalid);
}

TEST(KeptDifference, OnlySumsKeepTheirDifference) {
  Graph graph;
  const Node x = graph.variable("x", 16, true), y = graph.variable("y", 16, true),
             step = graph.variable("step", 16, false);
  const Node nextX = graph.make(Op::Add, 16, x, step), nextY = graph.make(Op::Add, 16, step, y);
  const Node apart = graph.make(Op::Sub, 16, x, y);
  const KeptDifference kept{{x, step, nextX}, {y, step, nextY}, apart};
  EXPECT_TRUE(consistsOfSums(graph, kept));
  KeptDifference wrong = kept;
  wrong.left.next = graph.make(Op::Add, 16, nextX, graph.constantNode(1, 16));
  EXPECT_FALSE(consistsOfSums(graph, wrong));
  wrong = kept;
  wrong.difference = graph.make(Op::Sub, 16, y, x);
  EXPECT_FALSE(consistsOfSums(graph, wrong));
  wrong = kept;
  wrong.left.isPending = true;  // then the difference is that of x + step and y
  EXPECT_FALSE(consistsOfSums(graph, wrong));
  wrong.difference = graph.make(Op::Sub, 16, nextX, y);
  EXPECT_TRUE(consistsOfSums(graph, wrong));
}

/// a + b = a - (0 - b) bit by bit from below, and a guide that does not follow: neither makes anything true or false.
TEST(ScanClauses, AGuideIsFollowedWhereItHolds) {
  Graph graph;
  TransitionSystem system;
  system.graph = &graph;
  const Node a = graph.variable("a", 16, false), b = graph.variable("b", 16, false);
  const Node negative = graph.make(Op::Sub, 16, graph.constantNode(0, 16), b);
  const ScanNode sum{graph.make(Op::Add, 16, a, b), 0}, other{graph.make(Op::Sub, 16, a, negative), 0};
  const auto bitOf = [&](ScanNode word, std::uint64_t bit) {
    return ScanNode{graph.make(Op::Extract, 1, word.node, noNode, noNode, bit), 0};
  };
  const auto checkGuided = [&](const Formula& formula, const std::vector<Formula>& guide) {
    ScanClauses clauses(system);
    const int root = clauses.literalOf(formula);
    std::vector<int> literals;
    for (const Formula& f : guide) literals.push_back(clauses.literalOf(f));
    return refute(clauses.gates().clausesOf(root, literals), enough);
  };
  std::vector<Formula> parts, wrong{truthOf(bitOf(sum, 3).node, 0)};
  for (std::uint64_t bit = 0; bit < 16; ++bit) parts.push_back(equals(bitOf(sum, bit), bitOf(other, bit)));
  const Formula differ = notOf(allOf(parts));
  EXPECT_EQ(checkGuided(differ, parts), CheckResult::Valid);
  EXPECT_EQ(checkGuided(differ, wrong), CheckResult::Valid);
  EXPECT_EQ(checkGuided(allOf(parts), parts), CheckResult::Invalid);
  EXPECT_EQ(checkGuided(allOf(parts), wrong), CheckResult::Invalid);
}

/// Bits beyond the 64 of the number are 0.
TEST(GateClauses, ConstantsMayBeWiderThanTheirNumber) {
  const GateClauses::Word word = GateClauses::constant(~0ULL, 66);
  ASSERT_EQ(word.size(), 66U);
  EXPECT_EQ(word[63], GateClauses::yes);
  EXPECT_EQ(word[64], -GateClauses::yes);
  EXPECT_EQ(word[65], -GateClauses::yes);
}

}  // namespace
}  // namespace rungproof::test
