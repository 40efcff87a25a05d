// Every instance of Domain computes what Concrete computes: constants folded by Graph, simplified graphs evaluated on
// numbers (one at a time and in 64 lanes), and models of Z3. Random terms; the seed is printed with a failure.
#include <gtest/gtest.h>

#include "analysis/graph/evaluate.hpp"
#include "analysis/graph/z3_terms.hpp"
#include "engine/concrete.hpp"
#include "tests/differential/random_source.hpp"

namespace rungproof {
namespace {

/// How a term came about: its operation over earlier terms, or none for variables and constants.
struct Recipe {
  Op op;
  std::array<std::size_t, 3> operand;
  std::uint64_t parameter;
};
struct Term {
  Node node;
  int width;
  Recipe recipe;
};

/// Grows random terms over a few variables and remembers how, so that Concrete can compute them without the graph.
class Terms {
 public:
  Terms(Graph& graph, RandomSource& random, bool withReal) : g_(graph), random_(random), withReal_(withReal) {
    for (const int width : {1, 1, 1, 8, 8, 16, 16, 32}) {
      const Node node = g_.variable("v" + std::to_string(pool.size()), width, false);
      variables.push_back(node);
      pool.push_back({node, width, {Op::Variable, {}, 0}});
    }
  }

  void grow() {
    const Op last = withReal_ ? Op::RealToInt : Op::Sext;
    const Op op =
        static_cast<Op>(static_cast<std::uint32_t>(Op::Not) +
                        random_.below(static_cast<std::uint32_t>(last) - static_cast<std::uint32_t>(Op::Not) + 1));
    const std::size_t a = any();
    const int width = pool[a].width;
    switch (op) {
      case Op::Not: return add(op, width, {a}, 1);
      case Op::Extract: {
        const int part = 1 + static_cast<int>(random_.below(static_cast<std::uint32_t>(width)));
        return add(op, part, {a}, 1, random_.below(static_cast<std::uint32_t>(width - part + 1)));
      }
      case Op::Zext:
      case Op::Sext:
        return add(op, width + static_cast<int>(random_.below(static_cast<std::uint32_t>(65 - width))), {a}, 1);
      case Op::Concat: {
        const std::size_t b = any();
        if (width + pool[b].width <= 64) add(op, width + pool[b].width, {a, b}, 2);
        return;
      }
      case Op::Ite: return add(op, width, {ofWidth(1), a, ofWidth(width)}, 3);
      case Op::Equal:
      case Op::Ult:
      case Op::Ule:
      case Op::Slt:
      case Op::Sle: return add(op, 1, {a, ofWidth(width)}, 2);
      case Op::RealAdd:
      case Op::RealSub:
      case Op::RealMul:
      case Op::RealDiv: return add(op, 32, {ofWidth(32), ofWidth(32)}, 2);
      case Op::RealEqual:
      case Op::RealLess: return add(op, 1, {ofWidth(32), ofWidth(32)}, 2);
      case Op::RealLegal: return add(op, 1, {ofWidth(32)}, 1);
      case Op::RealFunction: return add(op, 32, {ofWidth(32)}, 1, static_cast<std::uint64_t>(RealFunction::Sqrt));
      case Op::RealFromInt: return add(op, 32, {ofWidth(32)}, 1);
      case Op::RealToInt: return add(op, 64, {ofWidth(32)}, 1, random_.below(2));
      default: return add(op, width, {a, ofWidth(width)}, 2);
    }
  }

  /// What Concrete computes for all terms, given the variables.
  std::vector<std::uint64_t> compute(const std::vector<std::uint64_t>& inputs) const {
    std::vector<std::uint64_t> value(pool.size());
    for (std::size_t i = 0; i < pool.size(); ++i) {
      const Recipe& r = pool[i].recipe;
      if (r.op == Op::Variable)
        value[i] = inputs[i];
      else if (r.op == Op::Constant)
        value[i] = r.parameter;
      else
        value[i] = evaluateOperation(r.op, pool[i].width, {pool[r.operand[0]].width, pool[r.operand[1]].width},
                                     {value[r.operand[0]], value[r.operand[1]], value[r.operand[2]]}, r.parameter);
    }
    return value;
  }
  std::vector<std::uint64_t> randomInputs(RandomSource& random) const {
    std::vector<std::uint64_t> inputs;
    for (const Node v : variables) inputs.push_back(random.value(g_[v].width));
    return inputs;
  }

  std::vector<Term> pool;
  std::vector<Node> variables;

 private:
  std::size_t any() {
    return random_.chance(15) ? constant(1 << random_.below(6))
                              : random_.below(static_cast<std::uint32_t>(pool.size()));
  }
  std::size_t constant(int width) {
    const std::uint64_t value = random_.value(width);
    pool.push_back({g_.constantNode(value, width), width, {Op::Constant, {}, value}});
    return pool.size() - 1;
  }
  std::size_t ofWidth(int width) {
    if (!random_.chance(25)) {
      for (int tries = 0; tries < 12; ++tries) {
        const std::size_t i = random_.below(static_cast<std::uint32_t>(pool.size()));
        if (pool[i].width == width) return i;
      }
    }
    return constant(width);
  }
  void add(Op op, int width, std::array<std::size_t, 3> operand, int count, std::uint64_t parameter = 0) {
    const auto node = [&](int i) { return i < count ? pool[operand[static_cast<std::size_t>(i)]].node : noNode; };
    pool.push_back({g_.make(op, width, node(0), node(1), node(2), parameter), width, {op, operand, parameter}});
  }

  Graph& g_;
  RandomSource& random_;
  bool withReal_;
};

std::vector<Node> nodesOf(const std::vector<Term>& terms) {
  std::vector<Node> nodes;
  for (const Term& t : terms) nodes.push_back(t.node);
  return nodes;
}

TEST(DomainLaws, SimplifiedGraphsComputeWhatConcreteComputes) {
  for (std::uint64_t round = 0; round < 1500; ++round) {
    const std::uint64_t seed = testSeed() + round;
    RandomSource random(seed);
    Graph graph;
    Terms terms(graph, random, round % 4 == 0);
    for (int i = 0; i < 120; ++i) terms.grow();
    Evaluator evaluator(graph, nodesOf(terms.pool));
    for (int assignment = 0; assignment < 6; ++assignment) {
      const std::vector<std::uint64_t> inputs = terms.randomInputs(random), expected = terms.compute(inputs);
      for (std::size_t i = 0; i < terms.variables.size(); ++i) evaluator.set(terms.variables[i], inputs[i]);
      evaluator.run();
      for (std::size_t i = 0; i < terms.pool.size(); ++i) {
        const Node node = terms.pool[i].node;
        ASSERT_EQ(evaluator[node], expected[i]) << "seed " << seed << ", term " << i;
        ASSERT_EQ(graph[node].width, terms.pool[i].width) << "seed " << seed << ", term " << i;
        ASSERT_LE(graph.lowest(node), expected[i]) << "seed " << seed << ", term " << i;
        ASSERT_GE(graph.highest(node), expected[i]) << "seed " << seed << ", term " << i;
      }
    }
  }
}

TEST(DomainLaws, LanesComputeWhatSingleNumbersCompute) {
  for (std::uint64_t round = 0; round < 200; ++round) {
    const std::uint64_t seed = testSeed() + 100000 + round;
    RandomSource random(seed);
    Graph graph;
    Terms terms(graph, random, round % 4 == 0);
    for (int i = 0; i < 60; ++i) terms.grow();
    LaneEvaluator lanes(graph, nodesOf(terms.pool));
    std::vector<std::vector<std::uint64_t>> inputs;
    for (int lane = 0; lane < LaneEvaluator::lanes; ++lane) {
      inputs.push_back(terms.randomInputs(random));
      for (std::size_t i = 0; i < terms.variables.size(); ++i) lanes.set(terms.variables[i], lane, inputs.back()[i]);
    }
    lanes.run();
    for (const int lane : {0, 17, 63}) {
      const std::vector<std::uint64_t> expected = terms.compute(inputs[static_cast<std::size_t>(lane)]);
      for (std::size_t i = 0; i < terms.pool.size(); ++i)
        ASSERT_EQ(lanes.at(terms.pool[i].node, lane), expected[i]) << "seed " << seed << ", term " << i;
    }
  }
}

TEST(DomainLaws, Z3ComputesWhatConcreteComputes) {
  for (std::uint64_t round = 0; round < 60; ++round) {
    const std::uint64_t seed = testSeed() + 200000 + round;
    RandomSource random(seed);
    Graph graph;
    Terms terms(graph, random, round % 3 == 0);
    for (int i = 0; i < 30; ++i) terms.grow();
    const std::vector<std::uint64_t> inputs = terms.randomInputs(random), expected = terms.compute(inputs);
    std::vector<Node> conditions;
    for (std::size_t i = 0; i < terms.variables.size(); ++i) {
      const Node value = graph.constantNode(inputs[i], graph[terms.variables[i]].width);
      conditions.push_back(graph.make(Op::Equal, 1, terms.variables[i], value));
    }
    std::vector<std::uint64_t> found;
    const std::optional<bool> answer = satisfiable(graph, conditions, 20000, nodesOf(terms.pool), &found);
    ASSERT_EQ(answer, true) << "seed " << seed;
    for (std::size_t i = 0; i < terms.pool.size(); ++i)
      ASSERT_EQ(found[i], expected[i]) << "seed " << seed << ", term " << i;
  }
}

}  // namespace
}  // namespace rungproof
