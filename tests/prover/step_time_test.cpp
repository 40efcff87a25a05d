// Steps that end themselves by their own timers, alone and in a chain: how long they have lasted at least and at most
// is proved from the timers' presets, whatever these are.
#include <gtest/gtest.h>

#include "tests/prover/proved_text.hpp"

namespace rungproof::test {
namespace {

constexpr double limit = 30;  ///< seconds for each question on a busy machine; alone the slowest takes two

Outcome outcomeOfOne(const std::string& property, const std::string& networks) {
  const ProgramInput input = inputOf("//@ " + property + "\n", networks);
  const ProofRun run = prove(input.program, input.properties, usualOptions(limit));
  EXPECT_TRUE(run.disagreements.empty());
  EXPECT_EQ(run.results.size(), 1U);
  return run.results.empty() ? Outcome::Unknown : run.results.front().outcome;
}

/// M0.0 is set by I0.0, starts the timer and is reset by it; in the order of these networks.
std::string ownStep(int preset, const std::vector<int>& order = {0, 1, 2}) {
  const std::string parts[] = {"LD I0.0\nS M0.0, 1\n", "LD M0.0\nTON T37, " + std::to_string(preset) + "\n",
                               "LD T37\nR M0.0, 1\n= M0.1\n"};
  std::string text;
  for (std::size_t i = 0; i < order.size(); ++i) text += "NETWORK " + std::to_string(i + 1) + "\n" + parts[order[i]];
  return text;
}

TEST(StepTime, StepThatItsOwnTimerResets) {
  // The bit rises when the value has come to the preset, n ticks of 100 ms (001:6590). Of these at most one interval
  // was cut short, and the scans in which the step began and ended take at most 500 ms each: with n >= 150 more than
  // 0.08 n seconds lie between scan ends.
  for (const int preset : {150, 300, 30000}) {
    const std::string property =
        "prove long: rises(M0.1) implies prev(held(M0.0, " + std::to_string(preset * 8 / 100) + "s))";
    EXPECT_EQ(outcomeOfOne(property, ownStep(preset)), Outcome::Proved) << preset;
  }
  for (const std::vector<int>& order : {std::vector<int>{1, 2, 0}, {2, 0, 1}, {1, 0, 2}})
    EXPECT_EQ(outcomeOfOne("prove long: rises(M0.1) implies prev(held(M0.0, 12s))", ownStep(150, order)),
              Outcome::Proved);
}

TEST(StepTime, LongerThanThePresetIsViolated) {
  // 150 ticks of 100 ms are 15 s: with short scans the step has not lasted 16 s when its timer comes on.
  EXPECT_EQ(outcomeOfOne("prove long: rises(M0.1) implies prev(held(M0.0, 16s))", ownStep(150)), Outcome::Violated);
}

/// Q0.0 to the last step, each of which its own timer ends; behind the last one M0.0 is on for a scan. I0.0 starts the
/// chain when no step is active.
std::string chainOf(int steps, int preset) {
  const auto step = [](int i) { return "Q" + std::to_string(i / 8) + "." + std::to_string(i % 8); };
  std::string text = "NETWORK 1\nLD I0.0\n";
  for (int i = 0; i < steps; ++i) text += "AN " + step(i) + "\n";
  text += "S Q0.0, 1\n";
  for (int i = 0; i < steps; ++i) {
    const std::string timer = "T" + std::to_string(37 + i);
    text += "NETWORK " + std::to_string(i + 2) + "\nLD " + step(i) + "\nTON " + timer + ", " + std::to_string(preset) +
            "\nLD " + timer + "\n";
    text += i + 1 < steps ? "S " + step(i + 1) + ", 1\n" : "= M0.0\n";
    text += "R " + step(i) + ", 1\n";
  }
  return text;
}

/// Each step takes its preset and, at most, the scan in which it ends (500 ms) and a tick of 100 ms.
int mostSeconds(int steps, int preset) { return (steps * (preset + 6) + 9) / 10; }

TEST(StepTime, ChainOfStepsEndsInTime) {
  struct Row {
    int steps, preset;
  };
  for (const auto& [steps, preset] : {Row{1, 20}, {2, 20}, {4, 20}, {4, 600}, {4, 6000}, {6, 20}, {8, 20}}) {
    const std::string within = std::to_string(mostSeconds(steps, preset));
    EXPECT_EQ(outcomeOfOne("prove chain: Q0.0 leads to M0.0 within " + within + "s", chainOf(steps, preset)),
              Outcome::Proved)
        << steps << " " << preset;
  }
}

TEST(StepTime, ChainTakesTheSumOfItsPresets) {
  // Four steps of 20 ticks: the first scan end with Q0.0 is at least 4 x 1.9 s before the last timer's bit.
  EXPECT_EQ(outcomeOfOne("prove chain: Q0.0 leads to M0.0 within 7s", chainOf(4, 20)), Outcome::Violated);
  EXPECT_EQ(outcomeOfOne("prove chain: Q0.0 leads to M0.0 within 14s", chainOf(4, 20)), Outcome::Proved);
}

TEST(StepTime, ChainThatCanStopOnTheWay) {
  // I0.1 resets the third step: then the end never comes.
  EXPECT_EQ(
      outcomeOfOne("prove chain: Q0.0 leads to M0.0 within 14s", chainOf(4, 20) + "NETWORK 6\nLD I0.1\nR Q0.2, 1\n"),
      Outcome::Violated);
}

}  // namespace
}  // namespace rungproof::test
