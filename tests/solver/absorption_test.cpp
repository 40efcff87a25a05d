// Questions that can be bad only as long as a latch is 0: which latches count, what becomes constant, and that answers
// are those of the given system, on random systems whose states are all visited.
#include "analysis/portfolio/absorption.hpp"

#include <gtest/gtest.h>

#include <random>

#include "analysis/portfolio/portfolio.hpp"
#include "visited_states.hpp"

namespace rungproof {
namespace {

using families::Family;

/// Bad where `a` is 1 and `cause` was 0 in this scan and all before it; the state that remembers the cause.
Node askOnlyAfter(Family& f, Node a, Node cause) {
  const Node once = f.state("once");
  const Node now = f.either(once, cause);
  f.next(once, now);
  f.ask("a only after the cause", f.both(a, f.no(now)));
  return once;
}

TEST(Absorption, AnInputThatSetsTheLatchIsConstant) {
  Family f;
  const Node a = f.input("a"), b = f.input("b");
  const Node seen = f.state("seen");
  f.next(seen, f.either(seen, f.both(a, b)));
  const Node once = askOnlyAfter(f, seen, b);
  const auto u = beforeAbsorption(f.system, 0);
  ASSERT_TRUE(u);
  EXPECT_EQ(u->latched, once);
  EXPECT_EQ(u->fixedInputs, (std::vector<std::pair<std::size_t, std::uint64_t>>{{1, 0}}));
  EXPECT_EQ(u->system.states[0].next, seen);  // a and b is 0
  EXPECT_TRUE(u->system.constraints.empty());
}

TEST(Absorption, AComplementAndAConditionSetItToo) {
  Family f;
  const Node a = f.input("a"), b = f.input("b"), c = f.input("c");
  askOnlyAfter(f, a, f.either(f.no(b), f.both(a, c)));
  const auto u = beforeAbsorption(f.system, 0);
  ASSERT_TRUE(u);
  EXPECT_EQ(u->fixedInputs, (std::vector<std::pair<std::size_t, std::uint64_t>>{{1, 1}}));
  EXPECT_EQ(u->system.constraints, std::vector<Node>{f.no(f.both(a, c))});
}

/// One latch wants b to be 0, the other 1: no scan is bad.
TEST(Absorption, LatchesThatContradictEachOtherLeaveNoRun) {
  Family f;
  const Node a = f.input("a"), b = f.input("b"), once = f.state("once b"), never = f.state("once not b");
  const Node onceNow = f.either(once, b), neverNow = f.either(never, f.no(b));
  f.next(once, onceNow);
  f.next(never, neverNow);
  f.ask("p", f.both(a, f.no(f.choose(f.input("c"), onceNow, f.either(onceNow, neverNow)))));
  f.ask("q", f.both(f.both(a, f.no(onceNow)), f.no(neverNow)));
  EXPECT_EQ(answerQuestions(f.system, {})[1].answer, Answer::Proved);
}

/// What a scan has made of a state is seen in the next one: bad in between is bad.
TEST(Absorption, AStateThatSetsTheLatchEndsTheRunInTheScanBehind) {
  Family f;
  const Node a = f.input("a"), b = f.input("b");
  const Node before = f.state("before"), count = f.state("count", 4);
  f.next(before, b);
  f.next(count, f.counted(count, a, 15));
  askOnlyAfter(f, f.both(b, f.atLeast(count, 3)), before);
  const std::vector<QuestionAnswer> answers = answerQuestions(f.system, {});
  EXPECT_EQ(answers[0].answer, Answer::Violated);
}

TEST(Absorption, OtherStatesAreNoLatches) {
  const auto hasLatch = [](auto&& make) {
    Family f;
    make(f);
    return beforeAbsorption(f.system, 0).has_value();
  };
  EXPECT_TRUE(hasLatch([](Family& f) { askOnlyAfter(f, f.input("a"), f.input("b")); }));
  // It starts with 1, or with any value.
  EXPECT_FALSE(hasLatch([](Family& f) {
    const Node once = askOnlyAfter(f, f.input("a"), f.input("b"));
    for (StateVariable& s : f.system.states) s.init = s.node == once ? f.number(1, 1) : s.init;
  }));
  EXPECT_FALSE(hasLatch([](Family& f) {
    askOnlyAfter(f, f.input("a"), f.input("b"));
    f.system.states[0].init = noNode;
  }));
  // It is reset.
  EXPECT_FALSE(hasLatch([](Family& f) {
    const Node a = f.input("a"), b = f.input("b"), once = f.state("once"), now = f.either(once, b);
    f.next(once, f.both(now, f.no(f.input("c"))));
    f.ask("p", f.both(a, f.no(now)));
  }));
  // Bad in the scan that sets it.
  EXPECT_FALSE(hasLatch([](Family& f) {
    const Node a = f.input("a"), b = f.input("b"), once = f.state("once");
    f.next(once, f.either(once, b));
    f.ask("p", f.both(a, f.no(once)));
  }));
}

TEST(Absorption, AnswersAreThoseOfTheGivenSystem) {
  constexpr unsigned seed = 11;
  SCOPED_TRACE(testing::Message() << "seed " << seed);
  std::mt19937 random(seed);
  int proofs = 0, runs = 0;
  for (int round = 0; round < 400; ++round) {
    Family f;
    std::vector<Node> leaves;
    for (const char* name : {"i", "j", "k"}) leaves.push_back(f.input(name));
    for (const char* name : {"a", "b", "c", "d"}) leaves.push_back(f.state(name));
    for (std::size_t s = 3; s < leaves.size(); ++s)
      f.next(leaves[s], f.both(families::randomTerm(f, leaves, 2, random), f.either(leaves[s - 1], leaves[s])));
    if (random() % 3 == 0)
      f.system.constraints.push_back(f.either(leaves[0], families::randomTerm(f, leaves, 1, random)));
    const Node cause = families::randomTerm(f, leaves, static_cast<int>(random() % 3), random);
    askOnlyAfter(f, f.both(leaves[5], leaves[6]), cause);
    const std::optional<QuestionAnswer> answer = families::checkedAnswer(f, Technique::Absorption);
    ASSERT_FALSE(HasFailure()) << round;
    if (!answer) continue;
    ++(answer->answer == Answer::Proved ? proofs : runs);
  }
  EXPECT_GE(proofs, 60);
  EXPECT_GE(runs, 20);
}

}  // namespace
}  // namespace rungproof
