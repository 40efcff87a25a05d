// Mined invariants: what is found on systems whose relations can be stated by hand, and that everything found holds
// on random runs.
#include <gtest/gtest.h>

#include <random>

#include "analysis/graph/evaluate.hpp"
#include "analysis/portfolio/invariants_bounds.hpp"
#include "analysis/portfolio/invariants_covers.hpp"
#include "analysis/portfolio/invariants_timers.hpp"
#include "analysis/portfolio/invariants_words.hpp"
#include "analysis/portfolio/portfolio.hpp"
#include "analysis/portfolio/state_truths.hpp"
#include "families.hpp"

namespace rungproof {
namespace {

using families::Family;

constexpr std::uint64_t miningSeed = 7;

/// Follows random runs; inputs that break a constraint are drawn again. Counts the scans that start in a state that
/// violates a clause.
std::size_t violations(const Family& f, const std::vector<Node>& clauses, int runs, int scans) {
  std::vector<Node> roots = clauses;
  for (const StateVariable& s : f.system.states) roots.push_back(s.next);
  roots.insert(roots.end(), f.system.constraints.begin(), f.system.constraints.end());
  Evaluator value(*f.graph, roots);
  std::mt19937_64 random(miningSeed);
  std::size_t count = 0;
  for (int run = 0; run < runs; ++run) {
    for (const StateVariable& s : f.system.states) value.set(s.node, (*f.graph)[s.init].value);
    for (int scan = 0; scan < scans; ++scan) {
      bool isLegal = false;
      while (!isLegal) {
        for (const Node input : f.system.inputs) {
          const int width = (*f.graph)[input].width;
          value.set(input, width == 1 ? (random() % 16 != 0 ? 1 : 0) : random() & Graph::maskOf(width));
        }
        value.run();
        isLegal = std::all_of(f.system.constraints.begin(), f.system.constraints.end(),
                              [&](Node n) { return value[n] == 1; });
      }
      count += std::any_of(clauses.begin(), clauses.end(), [&](Node n) { return value[n] != 1; }) ? 1 : 0;
      std::vector<std::uint64_t> next;
      for (const StateVariable& s : f.system.states) next.push_back(value[s.next]);
      for (std::size_t i = 0; i < next.size(); ++i) value.set(f.system.states[i].node, next[i]);
    }
  }
  return count;
}

/// A timer that gets 0 to 5 ticks of the scan before, and a clock that counts those of this scan, stopping at 60. Both
/// run while `on`, the clock from the second scan on. Per scan they differ by what is on its way: at most 5 ticks when
/// the timer starts and 5 more that it gets first, so timer + pending - clock is at most 10 until the clock stops.
struct TimerAndClock : Family {
  Node on, ticks, pending, timer, running, clock;
  TimerAndClock() {
    on = input("on");
    ticks = input("ticks", 3);
    system.constraints.push_back(graph->make(Op::Ule, 1, ticks, number(5, 3)));
    pending = state("pending", 3);
    next(pending, ticks);
    timer = state("T37.value", 16);
    const Node sum = graph->make(Op::Add, 16, timer, graph->make(Op::Zext, 16, pending));
    next(timer, choose(on, choose(atLeast(sum, 32000), number(32000, 16), sum), number(0, 16)));
    running = state("running");
    next(running, on);
    clock = state("clock", 6);
    const Node later = graph->make(Op::Add, 7, graph->make(Op::Zext, 7, clock), graph->make(Op::Zext, 7, ticks));
    const Node capped = graph->make(Op::Extract, 6, choose(atLeast(later, 60), number(60, 7), later));
    next(clock, choose(both(on, running), capped, number(0, 6)));
  }
};

TEST(Bounds, TimerIsAtMostTenTicksAheadOfTheClock) {
  TimerAndClock f;
  f.ask("far ahead", f.both(f.atLeast(f.timer, 50), f.no(f.atLeast(f.clock, 40))));
  f.ask("ten ahead", f.both(f.atLeast(f.timer, 50), f.no(f.atLeast(f.clock, 41))));
  PortfolioOptions options;
  options.seconds = 20;
  const std::vector<QuestionAnswer> answers = answerQuestions(f.system, options);
  EXPECT_EQ(answers[0].answer, Answer::Proved) << answers[0].method;
  // 5 + 5 ticks come in the two scans before the clock's first tick: timer 10, clock 0; then both go on alike.
  EXPECT_EQ(answers[1].answer, Answer::Violated) << answers[1].method;
}

TEST(Bounds, HoldOnRandomRuns) {
  TimerAndClock f;
  f.ask("far ahead", f.both(f.atLeast(f.timer, 50), f.no(f.atLeast(f.clock, 40))));
  BitBlast blast(f.system, {0});
  const Invariants known = mineInvariants(blast.bits(), {}, {}, {}, Budget::seconds(10));
  const std::vector<Node> bounds =
      mineBounds(f.system, blast, known, miningSeed, BoundScope::All, Budget::seconds(10)).clauses;
  ASSERT_FALSE(bounds.empty());
  EXPECT_EQ(violations(f, bounds, 20, 200), 0U);
}

/// What is asked first: every bound of it is one that random runs keep, and there are fewer of them than later.
TEST(Bounds, FewHoldOnRandomRunsAsWell) {
  TimerAndClock f;
  f.ask("far ahead", f.both(f.atLeast(f.timer, 50), f.no(f.atLeast(f.clock, 40))));
  BitBlast blast(f.system, {0});
  const Invariants known = mineInvariants(blast.bits(), {}, {}, {}, Budget::seconds(10));
  const std::size_t all =
      boundTemplates(f.system, blast, known, miningSeed, BoundScope::All, Budget::seconds(10)).templates.size();
  std::size_t fewer = 0;
  for (const BoundScope scope : {BoundScope::Few, BoundScope::Stops}) {
    const BoundTemplates found = boundTemplates(f.system, blast, known, miningSeed, scope, Budget::seconds(10));
    EXPECT_LT(fewer, found.templates.size());
    EXPECT_LT(found.templates.size(), all);
    fewer = found.templates.size();
    const bool hasStops =
        std::ranges::any_of(found.templates, [](const BoundTemplate& t) { return t.stopped != noNode; });
    EXPECT_EQ(hasStops, scope == BoundScope::Stops);
    const std::vector<Node> bounds = mineBounds(f.system, blast, known, miningSeed, scope, Budget::seconds(10)).clauses;
    ASSERT_FALSE(bounds.empty());
    EXPECT_EQ(violations(f, bounds, 20, 200), 0U);
  }
}

// A program may add in more bits than word and increment need: 4 and 3 bits in an adder of 12.
TEST(Bounds, AddersWiderThanTheirWords) {
  Family f;
  const Node ticks = f.input("ticks", 3);
  std::vector<Node> words;
  for (const char* name : {"x", "y"}) {
    const Node word = f.state(name, 4);
    const Node later =
        f.graph->make(Op::Add, 12, f.graph->make(Op::Zext, 12, word), f.graph->make(Op::Zext, 12, ticks));
    f.next(word, f.graph->make(Op::Extract, 4, f.choose(f.atLeast(later, 9), f.number(9, 12), later)));
    words.push_back(word);
  }
  f.ask("apart", f.graph->make(Op::Ult, 1, words[0], words[1]));
  BitBlast blast(f.system, {0});
  const BoundTemplates found = boundTemplates(f.system, blast, {}, miningSeed, BoundScope::All, Budget::seconds(10));
  EXPECT_FALSE(found.templates.empty());
  for (const CountingWord& word : found.words) {
    EXPECT_EQ((*f.graph)[word.sum.next].width, (*f.graph)[word.sum.word].width);
  }
}

// Words that do not count the same give no templates.
TEST(Bounds, NothingWithoutCommonTicks) {
  Family f;
  const Node a = f.input("a", 3), b = f.input("b", 3);
  const Node x = f.state("x", 8), y = f.state("y", 8);
  f.next(x, f.graph->make(Op::Add, 8, x, f.graph->make(Op::Zext, 8, a)));
  f.next(y, f.graph->make(Op::Add, 8, y, f.graph->make(Op::Zext, 8, b)));
  f.ask("apart", f.graph->make(Op::Ult, 1, x, y));
  BitBlast blast(f.system, {0});
  const Invariants none = mineInvariants(blast.bits(), {}, {}, {}, Budget::seconds(10));
  for (const Node n : mineBounds(f.system, blast, none, miningSeed, BoundScope::All, Budget::seconds(10)).clauses)
    ADD_FAILURE() << "node " << indexOf(n);
}

// A ring of four steps with a token that any of four inputs moves on: it is always somewhere, unless a fifth step can
// swallow it.
TEST(Invariants, OneOfTheStepsIsAlwaysActive) {
  for (const bool isClosed : {true, false}) {
    Family f;
    std::vector<Node> steps, moves;
    for (int i = 0; i < 4; ++i) {
      steps.push_back(f.state("step" + std::to_string(i), 1, i == 0 ? 1 : 0));
      moves.push_back(f.input("move" + std::to_string(i)));
    }
    const Node lost = f.input("lost");
    for (std::size_t i = 0; i < 4; ++i) {
      const std::size_t before = (i + 3) % 4;
      const Node comes = f.both(steps[before], moves[before]), stays = f.both(steps[i], f.no(moves[i]));
      f.next(steps[i], isClosed ? f.either(comes, stays) : f.both(f.either(comes, stays), f.no(lost)));
    }
    f.ask("none", f.both(f.both(f.no(steps[0]), f.no(steps[1])), f.both(f.no(steps[2]), f.no(steps[3]))));
    BitBlast blast(f.system, {0});
    std::vector<Lit> truths;
    for (const Node step : steps) truths.push_back(blast.of(step)[0]);
    const Invariants known = mineInvariants(blast.bits(), truths, {}, {}, Budget::seconds(10));
    const std::vector<std::vector<Lit>> covers = mineCovers(blast.bits(), known, {}, miningSeed, Budget::seconds(10));
    ASSERT_EQ(covers.size(), isClosed ? 1U : 0U);
    for (const std::vector<Lit>& cover : covers) EXPECT_EQ(cover.size(), 4U);
  }
}

TEST(Invariants, EqualAndComplementaryLatchesAreOne) {
  Family f;
  const Node in = f.input("in");
  const Node a = f.state("a"), b = f.state("b"), c = f.state("c", 1, 1), zero = f.state("zero");
  f.next(a, in);
  f.next(b, f.both(in, f.no(zero)));
  f.next(c, f.no(in));
  f.next(zero, f.both(zero, in));
  f.ask("differ", f.either(f.differ(a, b), f.no(f.differ(a, c))));
  BitBlast blast(f.system, {0});
  const Invariants found = mineInvariants(blast.bits(), {}, {}, {}, Budget::seconds(10));
  const auto equalTo = [&](Node n) { return found.equal.at(variableOf(blast.of(n)[0])); };
  EXPECT_EQ(equalTo(zero), falseLit);
  EXPECT_EQ(equalTo(b), equalTo(a));
  EXPECT_EQ(equalTo(c), negate(equalTo(a)));
}

// Three steps, of which one is left for the next: that no two are on is found as implications, and "the timer has
// reached its preset" is the same as its bit.
TEST(Invariants, OneHotStepsAndTimerBits) {
  Family f = families::phase(3);
  const std::vector<Node> truths = stateTruths(f.system, {0}, 600);
  BitBlast blast(f.system, {0}, truths);
  std::vector<Lit> literals;
  for (const Node n : truths) literals.push_back(blast.of(n)[0]);
  const Invariants found = mineInvariants(blast.bits(), literals, {}, {}, Budget::seconds(10));
  std::vector<Node> clauses;
  for (const std::vector<Lit>& clause : found.clauses) {
    Node n = f.number(0, 1);
    for (const Lit l : clause) n = f.either(n, blast.nodeOf(l));
    clauses.push_back(n);
  }
  EXPECT_EQ(violations(f, clauses, 4, 1500), 0U);
  // Two steps at once, or a bit that differs from its comparison, contradicts the clauses.
  const auto excluded = [&](Node state) {
    f.system.questions = {{"excluded", state}};
    TransitionSystem free = f.system;
    free.constraints = clauses;
    for (StateVariable& s : free.states) s.init = noNode;
    PortfolioOptions options;
    options.seconds = 5;
    return answerQuestions(free, options)[0].answer == Answer::Proved;
  };
  const Node s0 = f.system.states[0].node, s1 = f.system.states[1].node;
  EXPECT_TRUE(excluded(f.both(s0, s1)));
}

// The question names the phases; the timers decide about them, but are not named. After the next scan is named as well
// as before it.
TEST(Invariants, StatesAskedForAreThoseNamed) {
  Family f = families::phase(3);
  f.ask("after", f.system.states[0].next);
  for (const std::size_t question : {0, 1}) {
    const std::vector<bool> isAsked = statesAskedFor(f.system, {question});
    for (std::size_t s = 0; s < isAsked.size(); ++s) {
      const std::string& name = f.graph->variables()[(*f.graph)[f.system.states[s].node].value].name;
      EXPECT_EQ(isAsked[s], question == 0 ? name[0] == 'S' : name == "S0") << name;
    }
  }
}

TEST(Invariants, OffDelayBitNeedsInputOrRunningTime) {
  Family f;
  const Node bit = f.state("T97"), in = f.state("T97.in"), running = f.state("T97.running"),
             other = f.state("T98.running");
  f.system.timers = {{bit, in, running}, {.running = other}};
  const std::vector<NodeClause> guesses = guessTimerStates(f.system);
  ASSERT_EQ(guesses.size(), 1U) << "T98 has no bit and no input here";
  EXPECT_EQ(guesses[0], (NodeClause{f.no(bit), in, running}));
  EXPECT_NE(other, running);
}

// The box runs unless the jump is taken, and then sees what its driver becomes.
TEST(Invariants, TimersHaveSeenTheirInputUntilAJumpLeavesThemOut) {
  Family f;
  const Node in = f.input("in"), jump = f.input("jump");
  const Node seen = f.state("T37.in"), driver = f.state("Q0.0"), jumped = f.state("jumped");
  f.next(driver, in);
  f.next(seen, f.graph->make(Op::Ite, 1, jump, seen, in));
  f.next(jumped, f.graph->make(Op::Or, 1, jumped, jump));
  f.system.timers = {{.input = seen}};
  const std::vector<NodeClause> guesses = guessTimerStates(f.system);
  ASSERT_EQ(guesses.size(), 2U);
  EXPECT_EQ(guesses[0], (NodeClause{jumped, f.no(seen), driver}));
  EXPECT_EQ(guesses[1], (NodeClause{jumped, seen, f.no(driver)}));
}

// Two words that grow by the same input bit from 0 on: equal for ever, so both differences are at most 0.
TEST(Invariants, DifferencesOfWordsThatGrowAlike) {
  Family f;
  const Node in = f.input("in");
  const Node x = f.state("x", 12), y = f.state("y", 12);
  f.next(x, f.counted(x, in, 1000));
  f.next(y, f.counted(y, in, 1000));
  f.ask("differ", f.graph->make(Op::Ult, 1, x, y));
  BitBlast blast(f.system, {0});
  const std::vector<NodeClause> guesses = guessDifferences(f.system, blast, miningSeed, Budget::seconds(10));
  const NodeClause atMost{f.graph->make(Op::Ule, 1, x, y)}, atLeast{f.graph->make(Op::Ule, 1, y, x)};
  EXPECT_NE(std::find(guesses.begin(), guesses.end(), atMost), guesses.end());
  EXPECT_NE(std::find(guesses.begin(), guesses.end(), atLeast), guesses.end());
}

// Of many invariants a proof keeps those that it needs: x is never 1 because y is never 1; z plays no part.
TEST(Invariants, OnlyThoseNeededAreKept) {
  BitSystem g;
  const Lit x = g.addLatch("x", LatchInit::Zero), y = g.addLatch("y", LatchInit::Zero),
            z = g.addLatch("z", LatchInit::Zero);
  const Lit in = g.addInput();
  g.setNext(x, g.addAnd(in, y));
  g.setNext(y, y);
  g.setNext(z, g.addAnd(z, in));
  g.bads = {x};
  const std::vector<std::vector<Lit>> all{{negate(x)}, {negate(y)}, {negate(z)}};
  InvariantCores cores(g, all);
  const InvariantCores::Needed needed = cores.of(x, Certificate{}, Budget::seconds(10));
  EXPECT_EQ(needed.clauses, (std::vector<std::vector<Lit>>{{negate(x)}, {negate(y)}}));
  EXPECT_EQ(needed.immediate, (std::vector<std::vector<Lit>>{{negate(x)}}));
}

}  // namespace
}  // namespace rungproof
