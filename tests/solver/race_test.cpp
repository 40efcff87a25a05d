// A race that is stopped goes on: what engines have found stays, and time that they have had is not given again.
#include "analysis/portfolio/race.hpp"

#include <gtest/gtest.h>

#include "analysis/bits/bit_arithmetic.hpp"
#include "ir/check.hpp"

namespace rungproof {
namespace {

/// A word that is counted up from 0 in every scan; bad: it stands at `end`, which takes so many scans.
BitSystem counterTo(std::uint64_t end, int width) {
  BitSystem system;
  LitVector word;
  for (int bit = 0; bit < width; ++bit) word.push_back(system.addLatch("n", LatchInit::Zero));
  BitArithmetic arithmetic(system);
  const LitVector more = arithmetic.add(word, BitArithmetic::constant(1, width));
  for (std::size_t bit = 0; bit < word.size(); ++bit) system.setNext(word[bit], more[bit]);
  system.bads.push_back(arithmetic.equal(word, BitArithmetic::constant(end, width)));
  return system;
}

RaceQuestion questionOf(const BitSystem& system) {
  RaceQuestion question;
  question.system = &system;
  return question;
}

TEST(Race, GoesOnWhereItWasStopped) {
  const BitSystem near = counterTo(20, 8), far = counterTo(1ULL << 39, 40);  // nobody counts so far
  Race race({questionOf(near), questionOf(far)}, {.jobs = 1});
  RaceRun run;
  run.seconds = 0.5;
  race.run(run);
  const Verdict& found = race.questions()[0].verdict;
  ASSERT_EQ(found.answer, Answer::Violated);
  EXPECT_EQ(found.depth, 20);
  const RaceQuestion& open = race.questions()[1];
  EXPECT_EQ(open.verdict.answer, Answer::Unknown);
  const double spent = open.seconds, spentOnFound = race.questions()[0].seconds;

  race.run(run);  // half a second in all, which has been spent
  EXPECT_EQ(open.verdict.answer, Answer::Unknown);
  EXPECT_EQ(race.questions()[0].seconds, spentOnFound);
  EXPECT_EQ(race.questions()[0].verdict.answer, Answer::Violated);

  run.seconds = 1;
  race.run(run);
  EXPECT_GE(open.seconds, spent);
  EXPECT_EQ(open.verdict.answer, Answer::Unknown);
}

TEST(Race, WhatAQuestionLeavesOutIsNotTried) {
  const BitSystem near = counterTo(20, 8);
  RaceQuestion question = questionOf(near);
  question.techniques.keepOnly({Technique::LongSimulation});
  Race race({question}, {.jobs = 1});
  RaceRun run;
  run.seconds = 2;
  race.run(run);
  ASSERT_EQ(race.questions()[0].verdict.answer, Answer::Violated);
  EXPECT_EQ(race.questions()[0].verdict.method, "simulation");
}

/// Counts how often it is asked.
class CountingEngine final : public Engine {
 public:
  explicit CountingEngine(int& turns) : turns_(turns) {}
  Verdict advance(const Budget&) override {
    ++turns_;
    return {};
  }

 private:
  int& turns_;
};

/// Questions that only the counting engine answers.
std::vector<RaceQuestion> openQuestions(const BitSystem& system, Engine& engine, std::size_t count) {
  RaceQuestion question = questionOf(system);
  question.words = &engine;
  question.techniques.keepOnly({Technique::WordIc3});
  return std::vector<RaceQuestion>(count, question);
}

// Many questions are behind the one whose engine ends the time of all: none of them has a turn any more.
TEST(Race, NoQuestionHasATurnWhenTheTimeIsOver) {
  const BitSystem system = counterTo(20, 8);
  int turns = 0;
  CountingEngine engine(turns);
  Race race(openQuestions(system, engine, 1000), {.jobs = 1});
  RaceRun run;
  run.deadline = Budget::Clock::now();
  race.run(run);
  EXPECT_EQ(turns, 0);
}

// A cancelled race ends as soon.
TEST(Race, NoQuestionHasATurnWhenItIsCancelled) {
  const BitSystem system = counterTo(20, 8);
  const std::atomic<bool> cancel = true;
  int turns = 0;
  CountingEngine engine(turns);
  Race race(openQuestions(system, engine, 1000), {.jobs = 2, .cancel = &cancel});
  RaceRun run;
  race.run(run);
  EXPECT_EQ(turns, 0);
}

/// A defect of ours.
class BreakingEngine final : public Engine {
 public:
  Verdict advance(const Budget&) override { CHECK(false, "planted by a test"); }
};

// The engine that breaks leaves the race: its question has the answer of the others, or none, and so have the rest.
TEST(Race, AnEngineThatBreaksCostsNoOtherAnswer) {
  const BitSystem near = counterTo(20, 8);
  BreakingEngine first, second;
  std::vector<RaceQuestion> questions = openQuestions(near, first, 1);
  questions.push_back(questionOf(near));
  questions.back().words = &second;
  questions.push_back(questionOf(near));
  Race race(std::move(questions), {.jobs = 2});
  RaceRun run;
  run.seconds = 5;
  race.run(run);
  EXPECT_EQ(race.questions()[0].verdict.answer, Answer::Unknown);
  EXPECT_EQ(race.questions()[1].verdict.answer, Answer::Violated);
  EXPECT_EQ(race.questions()[2].verdict.answer, Answer::Violated);
}

}  // namespace
}  // namespace rungproof
