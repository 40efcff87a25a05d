// Word-level exports say what the system says: for random states and inputs, the next state, constraints and bad
// states that the files give are those that the graph gives; also for every operation there is, at many widths.
#include <gtest/gtest.h>

#include <random>

#include "analysis/export/system.hpp"
#include "analysis/graph/evaluate.hpp"
#include "analysis/proof/prover.hpp"
#include "analysis/proof/question_system.hpp"
#include "tests/corpus/corpus_program.hpp"
#include "tests/export/word_reader.hpp"

namespace rungproof::test {
namespace {

constexpr std::uint64_t seed = 20;

using Step = WordStep (*)(const std::string&, const std::vector<std::uint64_t>&, const std::vector<std::uint64_t>&);

/// REAL operations are inputs of the files only; nothing can be compared below them.
bool usesReals(const TransitionSystem& system) {
  for (std::size_t i = 0; i < system.graph->size(); ++i) {
    if ((*system.graph)[static_cast<Node>(i)].op >= Op::RealAdd) return true;
  }
  return false;
}

void compare(const TransitionSystem& system, const std::string& text, Step stepOf, int rounds) {
  const Graph& graph = *system.graph;
  std::vector<Node> roots = system.constraints;
  for (const StateVariable& s : system.states) roots.push_back(s.next);
  for (const Question& q : system.questions) roots.push_back(q.bad);
  Evaluator values(graph, roots);
  std::mt19937_64 random(seed);
  const auto pick = [&](Node n) {
    // Small and extreme values are as likely as any others.
    const std::uint64_t any = random(), high = Graph::maskOf(graph[n].width);
    const std::uint64_t v = (any >> 60 < 6 ? any : any >> 60 < 11 ? any % 8 : high - any % 3) & high;
    values.set(n, v);
    return v;
  };
  for (int round = 0; round < rounds; ++round) {
    std::vector<std::uint64_t> states, inputs;
    for (const StateVariable& s : system.states) states.push_back(pick(s.node));
    for (const Node n : system.inputs) inputs.push_back(pick(n));
    values.run();
    const WordStep step = stepOf(text, states, inputs);
    ASSERT_EQ(step.next.size(), system.states.size());
    ASSERT_EQ(step.bads.size(), system.questions.size());
    ASSERT_EQ(step.constraints.size(), system.constraints.size());
    for (std::size_t i = 0; i < step.next.size(); ++i)
      ASSERT_EQ(step.next[i], values[system.states[i].next]) << "state " << i << ", seed " << seed;
    for (std::size_t i = 0; i < step.bads.size(); ++i)
      ASSERT_EQ(step.bads[i], values[system.questions[i].bad] != 0) << system.questions[i].name;
    for (std::size_t i = 0; i < step.constraints.size(); ++i)
      ASSERT_EQ(step.constraints[i], values[system.constraints[i]] != 0) << "constraint " << i;
  }
}

class CorpusExport : public testing::TestWithParam<std::filesystem::path> {};

TEST_P(CorpusExport, FilesComputeTheSameStep) {
  const ProgramInput input = corpusInput(GetParam());
  QuestionSystem side(input.program, input.properties, goalsOf(input.properties),
                      encoderOptionsOf(proverOptions(GetParam())), {.builtin = true});
  const TransitionSystem& system = side.system();
  const std::string btor2 = exportBtor2(system, {"a remark"}), smv = exportSmv(system, {"a remark"});
  EXPECT_GE(btor2Shape(btor2).states.size(), system.states.size());
  EXPECT_GE(smvShape(smv).inputs.size(), system.inputs.size());
  if (usesReals(system)) return;
  compare(system, btor2, btor2Step, 3);
  compare(system, smv, smvStep, 3);
}

INSTANTIATE_TEST_SUITE_P(Programs, CorpusExport, testing::ValuesIn(corpusFiles()),
                         [](const auto& info) { return testNameOf(info.param); });

TEST(Export, EveryOperationAtManyWidths) {
  for (const int width : {1, 2, 3, 8, 16, 31, 32, 64}) {
    Graph graph;
    TransitionSystem system;
    system.graph = &graph;
    const Node a = graph.variable("a 1;", width, true), b = graph.variable("a 1;", width, false),
               c = graph.variable("next", 1, false);
    system.inputs = {b, c};
    std::vector<Node> results;
    for (const Op op : {Op::And, Op::Or, Op::Xor, Op::Add, Op::Sub, Op::Mul, Op::Udiv, Op::Urem, Op::Sdiv, Op::Srem,
                        Op::Shl, Op::Lshr}) {
      // At width 1 only logic is an operation of its own.
      if (width > 1 || op == Op::And || op == Op::Or || op == Op::Xor) results.push_back(graph.make(op, width, a, b));
    }
    for (const Op op : {Op::Equal, Op::Ult, Op::Ule, Op::Slt, Op::Sle}) results.push_back(graph.make(op, 1, a, b));
    results.push_back(graph.make(Op::Not, width, a));
    results.push_back(graph.make(Op::Ite, width, c, a, b));
    if (width < 64) {
      results.push_back(graph.make(Op::Zext, width + 1, a));
      results.push_back(graph.make(Op::Sext, width + 1, b));
      results.push_back(graph.make(Op::Concat, width + 1, c, a));
      results.push_back(graph.make(Op::Concat, width + 1, b, c));
    }
    if (width > 2) results.push_back(graph.make(Op::Extract, width - 2, a, noNode, noNode, 1));
    // Each result is the next value of a state of its own, so that every bit of it is compared.
    system.states.push_back({a, graph.constantNode(0, width), results[0]});
    for (std::size_t i = 0; i < results.size(); ++i) {
      const Node state = graph.variable("r" + std::to_string(i), graph[results[i]].width, true);
      system.states.push_back({state, noNode, results[i]});
    }
    system.questions.push_back({"c", c});
    compare(system, exportBtor2(system), btor2Step, 200);
    compare(system, exportSmv(system), smvStep, 200);
  }
}

TEST(Export, AigerHasZeroResetsAndNoConstraints) {
  // A counter of two bits from any value, that may not be 3 in a scan: bad in its first scan if it starts with 2.
  Graph graph;
  TransitionSystem system;
  system.graph = &graph;
  const Node x = graph.variable("x", 2, true);
  system.states.push_back({x, noNode, graph.make(Op::Add, 2, x, graph.constantNode(1, 2))});
  system.constraints.push_back(graph.make(Op::Not, 1, graph.make(Op::Equal, 1, x, graph.constantNode(3, 2))));
  system.questions.push_back({"two", graph.make(Op::Equal, 1, x, graph.constantNode(2, 2))});
  const std::string plain = exportAiger(system), ascii = exportAigerText(system);
  const auto header = [](const std::string& text) { return text.substr(0, text.find('\n')); };
  std::size_t m = 0, i = 0, l = 0, o = 0, a = 0, b = 0, c = 7;
  ASSERT_EQ(std::sscanf(header(plain).c_str(), "aig %zu %zu %zu %zu %zu %zu %zu", &m, &i, &l, &o, &a, &b, &c), 6);
  // x, "started" and "constraint broken"; two inputs for the value at the start.
  EXPECT_EQ(l, 4U);
  EXPECT_EQ(i, 2U);
  EXPECT_EQ(m, i + l + a);
  EXPECT_EQ(b, 1U);
  ASSERT_EQ(std::sscanf(header(ascii).c_str(), "aag %zu %zu %zu %zu %zu %zu %zu", &m, &i, &l, &o, &a, &b, &c), 7);
  EXPECT_EQ(i, 0U);
  EXPECT_EQ(l, 2U);
  EXPECT_EQ(c, 1U);
}

}  // namespace
}  // namespace rungproof::test
