// Words that count scans against clocks: how long a scan may last says how long they take.
#include <gtest/gtest.h>

#include "analysis/portfolio/invariants_bounds.hpp"
#include "analysis/portfolio/portfolio.hpp"
#include "analysis/schedule/schedule.hpp"
#include "families.hpp"

namespace rungproof {
namespace {

using families::Family;

/// While `on`, a word counts scans to 20 and a clock adds what each of them lasts, 2 to 50; off clears both.
struct CountedScans : Family {
  Node on, length, word, clock;
  CountedScans() {
    on = input("on");
    length = input("length", 6);
    system.constraints.push_back(graph->make(Op::Ule, 1, length, number(50, 6)));
    system.constraints.push_back(graph->make(Op::Ule, 1, number(2, 6), length));
    word = state("VW0", 16);
    const Node counted = graph->make(Op::Add, 16, word, number(1, 16));
    next(word, choose(on, choose(graph->make(Op::Slt, 1, word, number(20, 16)), counted, word), number(0, 16)));
    clock = state("clock", 13);
    const Node later = graph->make(Op::Add, 14, graph->make(Op::Zext, 14, clock), graph->make(Op::Zext, 14, length));
    const Node capped = graph->make(Op::Extract, 13, choose(atLeast(later, 8000), number(8000, 14), later));
    next(clock, choose(on, capped, number(0, 13)));
  }
};

std::vector<Answer> answersOf(const Family& f) {
  PortfolioOptions options;
  options.seconds = 20;
  options.techniques.leaveOut(Technique::Ic3);
  options.techniques.leaveOut(Technique::WordIc3);
  std::vector<Answer> answers;
  for (const QuestionAnswer& a : answerQuestions(f.system, options)) answers.push_back(a.answer);
  return answers;
}

TEST(Rates, TheLongestScansSayWhenTheCountIsFull) {
  CountedScans f;
  // 19 scans of 50 make 950 with 19 counted; the scan behind them makes it 20 and 1000.
  f.ask("late", f.both(f.atLeast(f.clock, 951), f.no(f.atLeast(f.word, 20))));
  f.ask("in time", f.both(f.atLeast(f.clock, 950), f.no(f.atLeast(f.word, 20))));
  EXPECT_EQ(answersOf(f), (std::vector{Answer::Proved, Answer::Violated}));
}

TEST(Rates, TheShortestScansSayWhenItIsNot) {
  CountedScans f;
  // 20 scans of 2 make 40.
  f.ask("early", f.both(f.atLeast(f.word, 20), f.no(f.atLeast(f.clock, 40))));
  f.ask("as fast as can be", f.both(f.atLeast(f.word, 20), f.no(f.atLeast(f.clock, 41))));
  EXPECT_EQ(answersOf(f), (std::vector{Answer::Proved, Answer::Violated}));
}

TEST(Rates, AMultipleOfTheWordBoundsTheClock) {
  CountedScans f;
  f.ask("late", f.both(f.atLeast(f.clock, 951), f.no(f.atLeast(f.word, 20))));
  BitBlast blast(f.system, {0});
  const MinedBounds mined = mineBounds(f.system, blast, {}, 7, BoundScope::Few, Budget::seconds(10));
  EXPECT_FALSE(mined.isUnfinished);
  // clock - 50 * word in two bits more than 16 + 6.
  const auto isBounded = [&](Node left, Node right) {
    return std::ranges::any_of(mined.clauses, [&](Node clause) {
      for (const Node n : coneOf(*f.graph, std::vector{clause})) {
        const NodeData& node = (*f.graph)[n];
        if (node.op != Op::Sub || node.width != 24) continue;
        const auto isOf = [&](Node side, Node state) {
          const std::vector<Node> below = coneOf(*f.graph, std::vector{side});
          return std::ranges::find(below, state) != below.end();
        };
        if (isOf(node.child[0], left) && isOf(node.child[1], right)) return true;
      }
      return false;
    });
  };
  EXPECT_TRUE(isBounded(f.clock, f.word));
}

TEST(Rates, WordsThatCountDown) {
  CountedScans f;
  // Set to 40 while on, 3 less in every scan that is off, until 0 or below: 13 scans leave 1, the next one -2.
  const Node ramp = f.state("VW2", 16);
  const Node isDown = f.graph->make(Op::Slt, 1, f.number(0, 16), ramp);
  const Node less = f.graph->make(Op::Add, 16, ramp, f.number(0x10000 - 3, 16));
  f.next(ramp, f.choose(f.on, f.number(40, 16), f.choose(isDown, less, ramp)));
  const Node rest = f.state("rest", 13);
  const Node later =
      f.graph->make(Op::Add, 14, f.graph->make(Op::Zext, 14, rest), f.graph->make(Op::Zext, 14, f.length));
  const Node capped = f.graph->make(Op::Extract, 13, f.choose(f.atLeast(later, 8000), f.number(8000, 14), later));
  f.next(rest, f.choose(f.on, f.number(0, 13), capped));
  f.ask("still up", f.both(f.atLeast(rest, 700), isDown));
  f.ask("still up at first", f.both(f.atLeast(rest, 650), isDown));
  EXPECT_EQ(answersOf(f), (std::vector{Answer::Proved, Answer::Violated}));
}

/// Many clocks against one word: more templates than are looked for.
TEST(Rates, NoneIsLeftWithoutATemplate) {
  CountedScans f;
  Node anyLate = f.no(f.on);
  for (int i = 0; i < 60; ++i) {
    const std::uint64_t cap = 100 + static_cast<std::uint64_t>(i);
    const Node clock = f.state("clock" + std::to_string(i), 13);
    const Node later =
        f.graph->make(Op::Add, 14, f.graph->make(Op::Zext, 14, clock), f.graph->make(Op::Zext, 14, f.length));
    const Node capped = f.graph->make(Op::Extract, 13, f.choose(f.atLeast(later, cap), f.number(cap, 14), later));
    f.next(clock, f.choose(f.on, capped, f.number(0, 13)));
    const Node flag = f.state("M" + std::to_string(i));
    f.next(flag, f.both(f.on, f.atLeast(clock, cap)));
    anyLate = f.both(anyLate, f.both(flag, f.no(f.atLeast(f.word, 2))));
  }
  f.ask("late", anyLate);
  BitBlast blast(f.system, {0});
  const BoundTemplates found = boundTemplates(f.system, blast, {}, 7, BoundScope::Few, Budget::seconds(60));
  ASSERT_EQ(found.templates.size(), schedule::templateLimit);
  EXPECT_FALSE(found.rates.empty());
  EXPECT_LT(found.rates.size(), 2U * 61);  // ahead and behind of each clock, of which the last have no template left
  for (const Rate& rate : found.rates) {
    EXPECT_TRUE(std::ranges::any_of(found.templates,
                                    [&](const BoundTemplate& t) { return t.difference == rate.difference; }));
  }
}

TEST(Rates, NothingWhereAScanMayLastAnyTime) {
  Family f;
  const Node length = f.input("length", 13);
  const Node word = f.state("VW0", 16), clock = f.state("clock", 13);
  f.next(word, f.graph->make(Op::Add, 16, word, f.number(1, 16)));
  f.next(clock, f.graph->make(Op::Add, 13, clock, length));
  f.ask("apart", f.both(f.atLeast(clock, 951), f.no(f.atLeast(word, 20))));
  BitBlast blast(f.system, {0});
  const BoundTemplates found = boundTemplates(f.system, blast, {}, 7, BoundScope::Few, Budget::seconds(10));
  EXPECT_TRUE(found.rates.empty());
}

}  // namespace
}  // namespace rungproof
