// The portfolio on families with known answers, and on random systems of words against a plain evaluation.
#include "analysis/portfolio/portfolio.hpp"

#include <gtest/gtest.h>

#include <chrono>

#include "analysis/graph/evaluate.hpp"
#include "families.hpp"

namespace rungproof {
namespace {

using families::Family;

/// Runs a trace through the word-level evaluator: constraints hold and the question is bad in the last scan.
bool replays(const TransitionSystem& system, const Question& question, const WordTrace& trace) {
  std::vector<Node> roots = system.constraints;
  roots.push_back(question.bad);
  for (const StateVariable& s : system.states) roots.push_back(s.next);
  Evaluator evaluator(*system.graph, roots);
  std::vector<std::uint64_t> state = trace.initial;
  for (std::size_t i = 0; i < state.size(); ++i) {
    const Node init = system.states[i].init;
    if (init != noNode && (*system.graph)[init].value != state[i]) return false;
  }
  for (std::size_t scan = 0; scan < trace.inputs.size(); ++scan) {
    for (std::size_t i = 0; i < state.size(); ++i) evaluator.set(system.states[i].node, state[i]);
    for (std::size_t i = 0; i < system.inputs.size(); ++i) evaluator.set(system.inputs[i], trace.inputs[scan][i]);
    evaluator.run();
    for (const Node n : system.constraints) {
      if (evaluator[n] != 1) return false;
    }
    if (scan + 1 == trace.inputs.size()) return evaluator[question.bad] == 1;
    for (std::size_t i = 0; i < state.size(); ++i) {
      const Node next = system.states[i].next;
      state[i] = (*system.graph)[next].op == Op::Variable && next == system.states[i].node ? state[i] : evaluator[next];
    }
  }
  return false;
}

void expectAll(const Family& family, Answer expected, double seconds = 20, int jobs = 2) {
  PortfolioOptions options;
  options.seconds = seconds;
  options.jobs = jobs;
  const auto begin = std::chrono::steady_clock::now();
  const std::vector<QuestionAnswer> answers = answerQuestions(family.system, options);
  const double took = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  testing::Test::RecordProperty("seconds", std::to_string(took));
  ASSERT_EQ(answers.size(), family.system.questions.size());
  for (std::size_t q = 0; q < answers.size(); ++q) {
    EXPECT_EQ(answers[q].answer, expected)
        << family.system.questions[q].name << ": " << answers[q].method << ", depth " << answers[q].depth;
    EXPECT_EQ(answers[q].certificate.has_value(), expected == Answer::Proved);
    if (answers[q].trace) {
      EXPECT_TRUE(replays(family.system, family.system.questions[q], *answers[q].trace));
    }
  }
}

TEST(Portfolio, Starters) {
  expectAll(families::starter(4), Answer::Proved);
  expectAll(families::starter(16), Answer::Proved);
}

TEST(Portfolio, Phases) {
  expectAll(families::phase(4), Answer::Proved);
  expectAll(families::phase(16), Answer::Proved);
}

// That no two of 30 phases are on is said of 435 pairs. A certificate has one condition for each phase: "it is off, or
// all later ones are".
TEST(Portfolio, PairsAreJoinedInCertificates) {
  const std::vector<QuestionAnswer> answers = answerQuestions(families::phase(30).system, {});
  ASSERT_TRUE(answers[0].certificate.has_value());
  EXPECT_LE(answers[0].certificate->invariant.size(), 100U);
}

TEST(Portfolio, Chains) {
  expectAll(families::chain(4), Answer::Proved);
  expectAll(families::chain(16), Answer::Proved);
}

TEST(Portfolio, SaturatedTimersAreExact) { expectAll(families::timed(4, 100, true), Answer::Proved); }

TEST(Portfolio, TimerComesOn) { expectAll(families::reach(100), Answer::Violated); }

TEST(Portfolio, OneThreadIsEnough) {
  expectAll(families::phase(4), Answer::Proved, 20, 1);
  expectAll(families::reach(50), Answer::Violated, 20, 1);
}

TEST(Portfolio, KeepsItsTime) {
  // Whether decided or not, the answer comes: ten seconds for 0.3 means that it hangs.
  Family f = families::timed(1, 30000, false);
  const auto begin = std::chrono::steady_clock::now();
  PortfolioOptions options;
  options.seconds = 0.3;
  answerQuestions(f.system, options);
  EXPECT_LT(std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count(), 10.0);
}

}  // namespace
}  // namespace rungproof
