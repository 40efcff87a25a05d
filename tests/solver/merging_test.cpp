// Merged states, on systems whose equal words can be told by hand: what is merged, that it holds, and that a proof
// about the smaller system is one about the given system.
#include "analysis/portfolio/merging.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "analysis/portfolio/certificate.hpp"
#include "analysis/portfolio/portfolio.hpp"
#include "families.hpp"

namespace rungproof {
namespace {

using families::Family;

MergedSystem merged(const Family& f) { return mergeStates(f.system, allQuestions(f.system), 5, Budget::seconds(10)); }

std::vector<Node> statesOf(const TransitionSystem& system) {
  std::vector<Node> nodes;
  for (const StateVariable& s : system.states) nodes.push_back(s.node);
  return nodes;
}

/// Two words that count the same scans in different ways, a bit and its complement, a word that never changes.
struct Doubles : Family {
  Node in, a, b, on, off, still;
  Doubles() {
    in = input("in");
    a = state("a", 8);
    b = state("b", 8);
    on = state("on");
    off = state("off", 1, 1);
    still = state("still", 8, 7);
    next(a, choose(in, graph->make(Op::Add, 8, a, number(1, 8)), number(0, 8)));
    next(b, choose(in, graph->make(Op::Sub, 8, b, number(255, 8)), number(0, 8)));
    next(on, in);
    next(off, no(in));
    next(still, choose(in, still, graph->make(Op::And, 8, still, number(15, 8))));
    ask("differ",
        no(graph->make(Op::Equal, 1, graph->make(Op::Add, 8, a, still), graph->make(Op::Add, 8, b, number(7, 8)))));
    ask("same", no(differ(on, off)));
  }
};

TEST(Merging, EqualWordsComplementsAndConstants) {
  Doubles f;
  const MergedSystem m = merged(f);
  // One of a and b stays, one of the two bits; 7 and 15 have no other common bits than 7.
  EXPECT_EQ(m.system.states.size(), 2U);
  EXPECT_EQ(m.facts.size(), 3U);
  EXPECT_EQ(m.system.questions[0].bad, f.number(0, 1));
  EXPECT_EQ(m.system.questions[1].bad, f.number(0, 1));
  for (std::size_t i = 0; i < m.kept.size(); ++i) EXPECT_EQ(m.system.states[i].node, f.system.states[m.kept[i]].node);
}

TEST(Merging, FactsAreInductiveTogether) {
  Doubles f;
  const MergedSystem m = merged(f);
  for (const Question& question : f.system.questions) {
    WordCertificate certificate;
    certificate.invariant = factsBehind(f.system, m.facts, {question.bad});
    CertificateWriter writer(f.system);
    writer.add(question, certificate);
    EXPECT_EQ(writer.check({}), std::vector<CheckResult>{CheckResult::Valid}) << question.name;
  }
  // The question about the bits needs nothing of the words.
  EXPECT_EQ(factsBehind(f.system, m.facts, {f.on, f.off}).size(), 1U);
}

TEST(Merging, WordsThatPartLateStay) {
  // Both count alike until 200 scans have passed, long after the samples end.
  Family f;
  const Node a = f.state("a", 16), b = f.state("b", 16), never = f.state("never");
  f.next(a, f.counted(a, f.number(1, 1), 500));
  f.next(b, f.counted(b, f.number(1, 1), 200));
  f.next(never, f.atLeast(a, 300));
  f.ask("part", f.both(never, f.no(f.graph->make(Op::Equal, 1, a, b))));
  const MergedSystem m = merged(f);
  EXPECT_EQ(statesOf(m.system), statesOf(f.system));
  EXPECT_TRUE(m.facts.empty());
}

TEST(Merging, InitialValuesThatAreFreeAreNotMerged) {
  Family f;
  const Node a = f.state("a"), b = f.state("b");
  for (StateVariable& s : f.system.states) s.init = noNode;
  f.ask("differ", f.differ(a, b));
  const MergedSystem m = merged(f);
  EXPECT_EQ(m.system.states.size(), 2U);
  const std::vector<QuestionAnswer> answers = answerQuestions(f.system, {});
  ASSERT_EQ(answers[0].answer, Answer::Violated);
  ASSERT_TRUE(answers[0].trace.has_value());
  EXPECT_NE(answers[0].trace->initial[0], answers[0].trace->initial[1]);
}

TEST(Merging, RunsOfTheSmallerSystemAreRunsOfTheGivenOne) {
  Doubles f;
  f.ask("three", f.graph->make(Op::Equal, 1, f.b, f.number(3, 8)));
  const std::vector<QuestionAnswer> answers = answerQuestions(f.system, {});
  ASSERT_EQ(answers[2].answer, Answer::Violated);
  // `in` three times, then the scan that starts with b = 3; initial values are the given system's.
  EXPECT_EQ(answers[2].trace->inputs.size(), 4U);
  EXPECT_EQ(answers[2].trace->initial, (std::vector<std::uint64_t>{0, 0, 0, 1, 7}));
}

}  // namespace
}  // namespace rungproof
