// The engine on words against exhaustive search on random systems, with bits and with Z3 below it, and on hand-made
// systems whose constants are too large for searching.
#include "analysis/words/word_engine.hpp"

#include <gtest/gtest.h>

#include "random_words.hpp"

namespace rungproof {
namespace {

using families::Family;

constexpr unsigned engineSeed = 40813;

/// The verdict must be that of exhaustive search, with a run that is really bad or clauses that are really inductive.
void agreesWithSearch(const Family& f, WordSolverKind solver, int& proved, int& violated) {
  const std::optional<int> expected = words::shortestViolation(f.system);
  const std::unique_ptr<WordEngine> engine = makeWordEngine(f.system, 0, {}, solver);
  const Verdict verdict = engine->advance(Budget::seconds(20));
  ASSERT_EQ(verdict.answer, expected ? Answer::Violated : Answer::Proved);
  if (expected) {
    ++violated;
    ASSERT_GE(verdict.depth, *expected);
    ASSERT_TRUE(words::isViolation(f.system, engine->trace()));
  } else {
    ++proved;
    ASSERT_TRUE(words::isInductive(f.system, engine->clauses()));
  }
}

void agreesOnRandomSystems(WordSolverKind solver, int systems) {
  std::mt19937 random(engineSeed);
  int proved = 0, violated = 0;
  for (int n = 0; n < systems; ++n) {
    SCOPED_TRACE(testing::Message() << "seed " << engineSeed << ", system " << n);
    agreesWithSearch(words::randomWords(random), solver, proved, violated);
    if (testing::Test::HasFatalFailure()) return;
  }
  // The generator must not be one-sided.
  EXPECT_GT(proved, systems / 10);
  EXPECT_GT(violated, systems / 10);
}

TEST(WordEngine, AgreesWithSearchOnBits) { agreesOnRandomSystems(WordSolverKind::Bits, 1500); }
TEST(WordEngine, AgreesWithSearchOnTerms) { agreesOnRandomSystems(WordSolverKind::Terms, 60); }

/// Resuming after tiny budgets must not change the verdict.
TEST(WordEngine, GoesOnAfterAnInterruption) {
  std::mt19937 random(engineSeed + 1);
  for (int n = 0; n < 200; ++n) {
    SCOPED_TRACE(testing::Message() << "seed " << engineSeed + 1 << ", system " << n);
    const Family f = words::randomWords(random);
    const bool isReachable = words::shortestViolation(f.system).has_value();
    const std::unique_ptr<WordEngine> engine = makeWordEngine(f.system, 0, {});
    Verdict verdict;
    for (int round = 0; round < 10000 && verdict.answer == Answer::Unknown; ++round)
      verdict = engine->advance(Budget::seconds(0.00001 * (1 + round)));
    ASSERT_EQ(verdict.answer, isReachable ? Answer::Violated : Answer::Proved);
    if (!isReachable) {
      ASSERT_TRUE(words::isInductive(f.system, engine->clauses()));
    }
  }
}

Answer answerOf(const Family& f, double seconds = 10) {
  const std::unique_ptr<WordEngine> engine = makeWordEngine(f.system, 0, {});
  const Verdict verdict = engine->advance(Budget::seconds(seconds));
  if (verdict.answer == Answer::Violated) {
    EXPECT_TRUE(words::isViolation(f.system, engine->trace()));
  }
  return verdict.answer;
}

// A timer against a count of scans: equal up to the preset, both at least the preset after it.
TEST(WordEngine, TimerAgainstCountWhateverThePreset) {
  for (const std::uint64_t preset : {100U, 1000U, 30000U})
    EXPECT_EQ(answerOf(families::timed(1, preset, false)), Answer::Proved) << preset;
}

// Two words that count together, one of them in sevens: y = 7 x as long as x stops at 4,000.
TEST(WordEngine, LinearEquationBetweenWords) {
  Family f;
  Graph& g = *f.graph;
  const Node in = f.input("in"), x = f.state("x", 16), y = f.state("y", 16);
  const Node counts = f.both(in, g.make(Op::Ult, 1, x, f.number(4000, 16)));
  f.next(x, f.choose(counts, g.make(Op::Add, 16, x, f.number(1, 16)), x));
  f.next(y, f.choose(counts, g.make(Op::Add, 16, y, f.number(7, 16)), y));
  f.ask("more than 28,000", g.make(Op::Ult, 1, f.number(28000, 16), y));
  EXPECT_EQ(answerOf(f), Answer::Proved);
}

// From 20,000 on the word is set back, so 30,000 in steps of 7 is out of reach; 20,005 = 20,006 - 1 is no multiple of 7
// either, but 20,006 = 7 * 2,858 is reached in scan 2,858 - too far for this test, so a step of 5,002 serves: 4 * 5,002
// = 20,008.
TEST(WordEngine, StepsThatPassALimit) {
  for (const bool isReachable : {false, true}) {
    Family f;
    Graph& g = *f.graph;
    const Node x = f.state("x", 16);
    f.next(x, f.choose(f.atLeast(x, 20000), f.number(0, 16), g.make(Op::Add, 16, x, f.number(5002, 16))));
    f.ask("value", g.make(Op::Equal, 1, x, f.number(isReachable ? 20008 : 30000, 16)));
    EXPECT_EQ(answerOf(f), isReachable ? Answer::Violated : Answer::Proved);
  }
}

// A value is handed on through four words; all that ever enters is at most 1,000.
TEST(WordEngine, MovesBetweenWords) {
  Family f;
  Graph& g = *f.graph;
  const Node in = f.input("in", 16), moves = f.input("moves");
  Node value = f.choose(g.make(Op::Ult, 1, f.number(1000, 16), in), f.number(1000, 16), in);
  for (int i = 0; i < 4; ++i) {
    const Node word = f.state("VW" + std::to_string(2 * i), 16);
    f.next(word, f.choose(moves, value, word));
    value = word;
  }
  f.ask("too large", g.make(Op::Ult, 1, f.number(1000, 16), value));
  EXPECT_EQ(answerOf(f), Answer::Proved);
}

// VW0 runs after the target VW2, which changes at any time, but only while the drive stands.
TEST(WordEngine, OneWordRunsAfterAnother) {
  Family f;
  Graph& g = *f.graph;
  const Node target = f.state("VW2", 16), position = f.state("VW0", 16), runs = f.state("Q0.0");
  const Node wanted = f.input("wanted", 16), start = f.input("start");
  const Node isAllowed = g.make(Op::Ult, 1, wanted, f.number(25000, 16));
  const Node accepted = f.both(f.both(start, f.no(runs)), isAllowed);
  const Node goal = f.choose(accepted, wanted, target);
  const Node isBelow = g.make(Op::Ult, 1, position, goal);
  f.next(target, goal);
  f.next(runs, isBelow);
  f.next(position, f.choose(f.both(runs, isBelow), g.make(Op::Add, 16, position, f.number(1, 16)), position));
  f.ask("beyond", g.make(Op::Ult, 1, f.number(25000, 16), position));
  EXPECT_EQ(answerOf(f), Answer::Proved);
}

// sin is no operation that a solver knows; the engine does not pretend.
TEST(WordEngine, LeavesOpaqueOperationsAlone) {
  Family f;
  Graph& g = *f.graph;
  const Node x = f.state("VD0", 32);
  f.next(x, g.rfunction(static_cast<std::uint64_t>(RealFunction::Sin), {x}).node);
  f.ask("one", g.requal({x}, {f.number(0x3F800000, 32)}).node);
  const std::unique_ptr<WordEngine> engine = makeWordEngine(f.system, 0, {});
  EXPECT_EQ(engine->advance(Budget::seconds(1)).answer, Answer::Unknown);
  EXPECT_TRUE(engine->isExhausted());
}

// A REAL that grows by 0.5 below 49.5 stays at most 50: 49.5 + 0.5 is exact, and sums below it are smaller.
TEST(WordEngine, RealNumbersWithZ3) {
  Family f;
  Graph& g = *f.graph;
  const Node in = f.input("in"), x = f.state("VD0", 32);
  const Node isBelow{g.rless({x}, {f.number(0x42460000, 32)}).node};  // 49.5
  f.next(x, f.choose(f.both(in, isBelow), g.radd({x}, {f.number(0x3F000000, 32)}).node, x));
  f.ask("above", g.rless({f.number(0x42480000, 32)}, {x}).node);  // 50.0
  EXPECT_EQ(answerOf(f, 20), Answer::Proved);
}

}  // namespace
}  // namespace rungproof
