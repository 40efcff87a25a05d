// Values of words against what counting by hand gives: a ramp in tens, words that follow others, words of any value.
#include <gtest/gtest.h>

#include "analysis/bits/bit_unrolling.hpp"
#include "analysis/portfolio/invariants_values.hpp"
#include "analysis/portfolio/portfolio.hpp"
#include "tests/solver/families.hpp"

namespace rungproof::test {
namespace {

/// Up by ten below 100 while `up`, down by ten above 0 otherwise.
Node rampIn(Family& f) {
  const Node word = f.state("ramp", 16), up = f.input("up");
  const Node more = f.graph->make(Op::Add, 16, word, f.number(10, 16));
  const Node less = f.graph->make(Op::Sub, 16, word, f.number(10, 16));
  f.next(word, f.choose(up, f.choose(f.atLeast(word, 100), word, more), f.choose(f.atLeast(word, 1), less, word)));
  return word;
}

std::vector<WordValues> valuesIn(const Family& f) {
  BitBlast blast(f.system, {0});
  return mineWordValues(f.system, blast, {}, 7, Budget::seconds(20));
}

TEST(WordValues, OfARampAreTheTens) {
  Family f;
  const Node word = rampIn(f);
  f.ask("too far", f.atLeast(word, 101));
  const std::vector<WordValues> found = valuesIn(f);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].values, (std::vector<std::uint64_t>{0, 10, 20, 30, 40, 50, 60, 70, 80, 90, 100}));
  PortfolioOptions options;
  options.seconds = 20;
  EXPECT_EQ(answerQuestions(f.system, options)[0].answer, Answer::Proved);
}

// The second word takes the first one's value one scan later: eleven values as well, which follow only from the
// first's.
TEST(WordValues, OfAWordThatFollowsAnother) {
  Family f;
  const Node first = rampIn(f), second = f.state("second", 16);
  f.next(second, first);
  f.ask("too far", f.atLeast(second, 101));
  const std::vector<WordValues> found = valuesIn(f);
  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(found[0].values, found[1].values);
  EXPECT_EQ(found[1].values.size(), 11U);
}

// 300 values are more than are listed; 4 values that an input chooses are few.
TEST(WordValues, ManyAreLeftOut) {
  Family f;
  const Node any = f.state("any", 16), few = f.state("few", 16), choice = f.input("choice", 2);
  f.next(any, f.counted(any, f.input("running"), 299));
  f.next(few, f.graph->make(Op::Zext, 16, choice));
  f.ask("both", f.both(f.atLeast(any, 300), f.atLeast(few, 4)));
  const std::vector<WordValues> found = valuesIn(f);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(f.system.states[found[0].state].node, few);
  EXPECT_EQ(found[0].values, (std::vector<std::uint64_t>{0, 1, 2, 3}));
}

// A run of neighbours is one range: its truth depends on the ends alone.
TEST(WordValues, AreWrittenAsRanges) {
  Family f;
  const Node word = f.state("word", 8);
  const Node isIn = isOneOf(*f.graph, word, {1, 2, 3, 9});
  BitBlast blast(f.system, isIn, {});
  Unrolling once(blast.bits(), Unrolling::Start::Any);
  Sat sat(Sat::Use::Many);
  BitCnf cnf(once.graph(), sat);
  sat.add({cnf.literal(once.at(0, blast.bits().bads[0]))});
  for (std::uint64_t value = 0; value < 16; ++value) {
    std::vector<int> has;
    for (std::size_t bit = 0; bit < 8; ++bit) {
      const int l = cnf.literal(once.at(0, blast.of(word)[bit]));
      has.push_back((value >> bit & 1U) != 0 ? l : -l);
    }
    const bool isExpected = (value >= 1 && value <= 3) || value == 9;
    EXPECT_EQ(sat.solve(has, Budget::seconds(20)) == Sat::Outcome::Satisfiable, isExpected) << value;
  }
}

}  // namespace
}  // namespace rungproof::test
