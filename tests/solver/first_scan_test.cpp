// Questions of the first scan: which are such, and that answers are those of the given system, on random systems whose
// states are all visited.
#include "analysis/portfolio/first_scan.hpp"

#include <gtest/gtest.h>

#include <random>

#include "analysis/portfolio/portfolio.hpp"
#include "visited_states.hpp"

namespace rungproof {
namespace {

using families::Family;

/// A state that is 1 before the first scan alone.
Node firstOf(Family& f) {
  const Node first = f.state("first", 1, 1);
  f.next(first, f.number(0, 1));
  return first;
}

TEST(FirstScan, StatesAreWhatTheyAreInitially) {
  Family f;
  const Node in = f.input("in"), first = firstOf(f), zero = f.state("zero"), kept = f.state("kept");
  f.system.states[2].init = noNode;
  f.next(zero, in);
  f.next(kept, f.either(kept, in));
  f.ask("p", f.both(first, f.both(in, f.differ(zero, kept))));
  const auto only = inFirstScan(f.system, 0);
  ASSERT_TRUE(only);
  EXPECT_EQ(only->system.questions[0].bad, f.both(in, kept));
  EXPECT_EQ(only->isLater, f.no(first));
  EXPECT_EQ(only->starts, (std::vector<Node>{first, f.no(zero)}));
}

TEST(FirstScan, OtherQuestionsStayAsTheyAre) {
  Family f;
  const Node in = f.input("in"), first = firstOf(f), again = f.state("again", 1, 1), off = f.state("off");
  f.next(again, in);
  f.next(off, f.number(0, 1));
  f.ask("later too", f.either(first, in));
  f.ask("comes back", f.both(again, in));
  f.ask("never was", f.both(off, in));
  f.ask("not the first", f.both(f.no(first), in));
  for (std::size_t q = 0; q < f.system.questions.size(); ++q)
    EXPECT_FALSE(inFirstScan(f.system, q)) << f.system.questions[q].name;
}

TEST(FirstScan, AnswersAreThoseOfTheGivenSystem) {
  constexpr unsigned seed = 5;
  SCOPED_TRACE(testing::Message() << "seed " << seed);
  std::mt19937 random(seed);
  int proofs = 0, runs = 0;
  for (int round = 0; round < 300; ++round) {
    Family f;
    std::vector<Node> leaves;
    for (const char* name : {"i", "j", "k"}) leaves.push_back(f.input(name));
    for (const char* name : {"a", "b", "c", "d"}) leaves.push_back(f.state(name, 1, random() % 2));
    const Node first = firstOf(f);
    for (std::size_t s = 3; s < leaves.size(); ++s) f.next(leaves[s], families::randomTerm(f, leaves, 2, random));
    f.system.states[random() % 4].init = noNode;
    if (random() % 3 == 0)
      f.system.constraints.push_back(f.either(leaves[0], families::randomTerm(f, leaves, 1, random)));
    Node bad = first;
    for (int part = 0; part < 3; ++part) bad = f.both(bad, families::randomTerm(f, leaves, 2, random));
    f.ask("p", bad);
    const std::optional<QuestionAnswer> answer = families::checkedAnswer(f, Technique::FirstScan);
    ASSERT_FALSE(HasFailure()) << round;
    if (!answer) continue;
    EXPECT_TRUE(!answer->trace || answer->trace->inputs.size() == 1);
    ++(answer->answer == Answer::Proved ? proofs : runs);
  }
  EXPECT_GE(proofs, 60);
  EXPECT_GE(runs, 20);
}

}  // namespace
}  // namespace rungproof
