// Limits of lint --prove for all questions together: the time is kept, what is worst not to know is asked first, and
// what stays open is counted.
#include <gtest/gtest.h>

#include <chrono>

#include "frontend/linting/solver_rules.hpp"
#include "frontend/report.hpp"
#include "tests/prover/proved_text.hpp"

namespace rungproof::test {
namespace {

/// Stations with a latch, a timer, a count that starts anew and a quotient: 17 instructions each.
std::string stations(int count) {
  std::string text;
  for (int i = 0; i < count; ++i) {
    const auto network = [&](int part) { return "NETWORK " + std::to_string(4 * i + part) + "\n"; };
    const std::string bit = "M" + std::to_string(i % 32) + "." + std::to_string(i / 32 % 8);
    const std::string timer = "T" + std::to_string(101 + i % 100), input = "I" + std::to_string(i % 12) + ".";
    const std::string word = "VW" + std::to_string(200 + 6 * i), quotient = "VW" + std::to_string(204 + 6 * i);
    text += network(1) + "LD " + input + "0\nO " + bit + "\nAN " + input + "1\n= " + bit + "\n";
    text += network(2) + "LD " + bit + "\nTON " + timer + ", " + std::to_string(10 + i) + "\n";
    text += network(3) + "LD " + timer + "\nEU\nINCW " + word + "\nLDW>= " + word + ", +100\nMOVW 0, " + word + "\n";
    text += network(4) + "LD " + input + "2\nMOVW " + word + ", " + quotient + "\n+I IW" + std::to_string(2 * (i % 4)) +
            ", " + quotient + "\n/I " + word + ", " + quotient + "\nLDW> " + quotient + ", +50\n= Q" +
            std::to_string(i % 16) + ".0\n";
  }
  return text;
}

OpenQuestions openWithin(double seconds, const std::string& networks, std::vector<Finding>& findings) {
  const ProgramInput input = inputOf("", networks);
  ProverOptions options = usualOptions(30);
  options.total = seconds;
  options.memory = 2ULL << 30;
  options.explains = false;
  return settleBySolver(
      input, options, [](std::string_view) { return true; }, findings);
}

TEST(Budget, IsKeptAndWhatItLeavesOpenIsCounted) {
  // 41 stations are 697 instructions with hundreds of questions: a second is not enough for them.
  std::vector<Finding> findings;
  const auto start = std::chrono::steady_clock::now();
  const OpenQuestions open = openWithin(1, stations(41), findings);
  const std::chrono::duration<double> used = std::chrono::steady_clock::now() - start;
  EXPECT_LT(used.count(), 25);  // a busy machine; without a limit it takes minutes
  EXPECT_GT(open.count, 0U);
  EXPECT_FALSE(open.lines.empty());
  EXPECT_TRUE(open.defects.empty());
}

TEST(Budget, LeavesNothingOpenWhereThereIsEnough) {
  // VW0 starts at 0 and is divided by at once (ARI001).
  std::vector<Finding> findings;
  const OpenQuestions open = openWithin(120, "NETWORK 1\nLD I0.0\n/I VW0, VW2\nNETWORK 2\nLD I0.1\n= Q0.0\n", findings);
  EXPECT_EQ(open.count, 0U);
  EXPECT_TRUE(std::ranges::any_of(findings, [](const Finding& finding) { return finding.rule == "ARI001"; }));
}

TEST(Budget, WhatStopsTheMachineIsAskedBeforeWhatIsOdd) {
  const auto cost = [](std::string_view rule) { return ruleNamed(rule)->ask.cost; };
  EXPECT_LT(cost("ARI003"), cost("OUT001"));  // a comparison that stops the CPU, a double coil
  EXPECT_LT(cost("OUT003"), cost("TIM008"));  // set against reset, a timer that never fires
  EXPECT_LT(cost("LOG006"), cost("LOG002"));  // a latch that cannot drop out, a contact without effect
}

TEST(Budget, OpenQuestionsAndDefectsDecideTheExitCode) {
  Report report;
  EXPECT_EQ(exitOf(report), Exit::Clean);
  report.coverage.open = 3;
  EXPECT_EQ(exitOf(report), Exit::Undecided);
  report.findings.emplace_back();
  EXPECT_EQ(exitOf(report), Exit::Found);
  report.defects.push_back("internal disagreement on 'x'");
  EXPECT_EQ(exitOf(report), Exit::Failed);
}

}  // namespace
}  // namespace rungproof::test
