// Caps at the largest constant that a value is compared with: when it is exact, when it is refused, and that a
// cap at a timer's own preset would be wrong where a property compares with more.
#include "analysis/portfolio/word_caps.hpp"

#include <gtest/gtest.h>

#include <random>

#include "analysis/graph/evaluate.hpp"
#include "analysis/portfolio/certificate.hpp"
#include "analysis/portfolio/portfolio.hpp"
#include "families.hpp"

namespace rungproof {
namespace {

using families::Family;

CappedSystem cappedOf(const Family& f) { return capWords(f.system, allQuestions(f.system), Budget::seconds(10)); }

std::uint64_t capOf(const CappedSystem& s, Node word) {
  for (const CappedWord& w : s.words) {
    if (w.given == word) return w.cap;
  }
  return 0;
}

int widthOf(const Family& f, Node n) { return (*f.graph)[n].width; }

TEST(WordCaps, AtThePresetWhereNothingElseIsCompared) {
  Family f;
  const Family::Timer t = f.timer("T37", f.input("in"), 100, 32767);
  f.ask("on", t.bitNow);
  const CappedSystem s = cappedOf(f);
  ASSERT_EQ(s.words.size(), 1U);
  EXPECT_EQ(s.words[0].cap, 100U);
  EXPECT_EQ(widthOf(f, s.words[0].narrow), 7);  // 100 < 128
}

// The timer's own preset is 10, a property asks for 25: a timer that stops at 10 never reaches that.
TEST(WordCaps, OwnPresetAloneWouldBeWrong) {
  Family f, wrong;
  const Family::Timer t = f.timer("T37", f.input("in"), 10, 32767), w = wrong.timer("T37", wrong.input("in"), 10, 10);
  f.ask("late", f.atLeast(t.value, 25));
  wrong.ask("late", wrong.atLeast(w.value, 25));
  EXPECT_EQ(answerQuestions(f.system, {})[0].answer, Answer::Violated);
  EXPECT_EQ(answerQuestions(wrong.system, {})[0].answer, Answer::Proved);
  EXPECT_EQ(capOf(cappedOf(f), t.value), 25U);
  // The capped system has the same answer as the given one.
  EXPECT_EQ(answerQuestions(cappedOf(f).system, {})[0].answer, Answer::Violated);
}

TEST(WordCaps, RefusedWhereTheValueItselfIsUsed) {
  // Moved to a word that a question reads: the word may saturate at 5,000, the timer may not.
  Family moved;
  const Family::Timer a = moved.timer("T37", moved.input("in"), 100, 32767);
  const Node copy = moved.state("VW0", 16);
  moved.next(copy, a.valueNow);
  moved.ask("large", moved.both(a.bit, moved.atLeast(copy, 5000)));
  EXPECT_EQ(capOf(cappedOf(moved), a.value), 0U);
  EXPECT_EQ(capOf(cappedOf(moved), copy), 5000U);
  // Its lowest bit matters at any height.
  Family odd;
  const Family::Timer b = odd.timer("T37", odd.input("in"), 100, 32767);
  odd.ask("odd", odd.both(b.bit, odd.graph->make(Op::Extract, 1, b.value)));
  EXPECT_EQ(capOf(cappedOf(odd), b.value), 0U);
  // Compared with a number that changes.
  Family other;
  const Family::Timer c = other.timer("T37", other.input("in"), 100, 32767);
  const Node limit = other.input("limit", 16);
  other.ask("above", other.both(c.bit, other.graph->make(Op::Ult, 1, limit, c.value)));
  EXPECT_EQ(capOf(cappedOf(other), c.value), 0U);
}

TEST(WordCaps, RunsAreTheSame) {
  Family f = families::timed(3, 40, false);
  const CappedSystem s = cappedOf(f);
  EXPECT_GE(s.words.size(), 3U);
  std::vector<Node> roots;
  for (const TransitionSystem* system : {static_cast<const TransitionSystem*>(&f.system), &s.system}) {
    for (const StateVariable& state : system->states) roots.insert(roots.end(), {state.node, state.next});
    for (const Question& question : system->questions) roots.push_back(question.bad);
  }
  for (const CappedWord& word : s.words) roots.push_back(word.capped);
  Evaluator value(*f.graph, roots);
  std::mt19937_64 random(3);
  std::vector<std::uint64_t> given(f.system.states.size(), 0), narrow = given;
  for (int scan = 0; scan < 3000; ++scan) {
    for (const Node input : f.system.inputs) value.set(input, random() % 64 != 0 ? 1 : 0);
    for (std::size_t i = 0; i < given.size(); ++i) {
      value.set(f.system.states[i].node, given[i]);
      value.set(s.system.states[i].node, narrow[i]);
    }
    value.run();
    for (std::size_t q = 0; q < f.system.questions.size(); ++q)
      ASSERT_EQ(value[f.system.questions[q].bad], value[s.system.questions[q].bad]) << scan;
    for (const CappedWord& word : s.words) ASSERT_EQ(value[word.capped], value[word.narrow]) << scan;
    for (std::size_t i = 0; i < given.size(); ++i) {
      given[i] = value[f.system.states[i].next];
      narrow[i] = value[s.system.states[i].next];
    }
  }
}

TEST(WordCaps, ProofsAreProofsAboutTheGivenSystem) {
  Family f;
  const Family::Timer t = f.timer("T37", f.input("in"), 100, 32767);
  f.ask("bit and value differ", f.differ(t.bit, f.atLeast(t.value, 100)));
  const CappedSystem s = cappedOf(f);
  ASSERT_EQ(s.words.size(), 1U);
  WordCertificate certificate;
  certificate.invariant = {s.onGivenSystem(*f.graph, f.no(f.differ(t.bit, f.atLeast(s.words[0].narrow, 100)))),
                           s.words[0].range};
  CertificateWriter writer(f.system);
  writer.add(f.system.questions[0], certificate);
  EXPECT_EQ(writer.check({}), std::vector<CheckResult>{CheckResult::Valid});
}

}  // namespace
}  // namespace rungproof
