// Exploration: runs that are too deep to be searched from power-up, step by step from states that are new.
#include "analysis/witness/exploration.hpp"

#include "analysis/encoding/asked_properties.hpp"
#include "ir/machine/reading.hpp"
#include "proved_text.hpp"

namespace rungproof::test {
namespace {

struct ExploredProgram {
  ExploredProgram(const std::string& properties, const std::string& networks)
      : ExploredProgram(inputOf(properties, networks)) {}
  explicit ExploredProgram(ProgramInput given) : input(std::move(given)), options(usualOptions()) {
    for (const Property& property : input.properties.properties)
      (property.isGoal() ? goals : assumptions).push_back(property);
    for (std::size_t g = 0; g < goals.size(); ++g) all.push_back(g);
    AskedProperties askedProperties(input.program, input.properties, goals, encoderOptionsOf(options));
    exploration = std::make_unique<Exploration>(input.program, runSpaceOf(askedProperties.encoding()), assumptions,
                                                goals, all, 1);
  }
  void search(double seconds) {
    const std::atomic<bool> cancel{false};
    isOpenEnded =
        exploration->search(Exploration::Clock::now() + std::chrono::milliseconds(int(seconds * 1000)), cancel);
  }
  bool isRepeated(std::size_t goal) const {
    const Witness& witness = *exploration->found(goal);
    return Judge(input.program, options.choices, assumptions, goals[goal])
        .witness(witness.scans, witness.initial)
        .has_value();
  }
  ProgramInput input;
  ProverOptions options;
  std::vector<Property> goals, assumptions;
  std::vector<std::size_t> all;
  std::unique_ptr<Exploration> exploration;
  bool isOpenEnded = true;
};

/// Eight steps, each entered by its own input while all others are off and left after a minute.
std::string longSequence() {
  std::string text = "Network 1\nLD SM0.1\nS M0.0, 1\n";
  for (int i = 0; i < 8; ++i) {
    text += "Network " + std::to_string(i + 2) + "\nLD M0." + std::to_string(i) + "\nTON T" + std::to_string(37 + i) +
            ", 600\nLD T" + std::to_string(37 + i) + "\nA I0." + std::to_string(i) + "\nLDB= IB0, " +
            std::to_string(1 << i) + "\nALD\nR M0." + std::to_string(i) + ", 1\nS M" +
            (i == 7 ? "1.0" : "0." + std::to_string(i + 1)) + ", 1\n";
  }
  return text;
}

TEST(Exploration, SequenceOfEightMinutesWithAnInputForEachStep) {
  ExploredProgram s("//@ reach end: M1.0\n//@ reach two: M0.3 and M0.4\n", longSequence());
  s.search(20);
  ASSERT_TRUE(s.exploration->found(0).has_value());
  EXPECT_TRUE(s.isRepeated(0));
  // Eight timers of a minute each, less what a tick and the scan before can be counted in advance (001:6605).
  EXPECT_GE(s.exploration->found(0)->milliseconds, 8U * 59000U);
  EXPECT_FALSE(s.exploration->found(1).has_value());
}

TEST(Exploration, WhatHappensInTheVeryScanInWhichATimerEnds) {
  // Both only if I0.1 comes in the scan in which T37 ends: from the next one on M0.0 keeps M0.1 off.
  ExploredProgram s("//@ reach both: M0.0 and M0.1\n",
                    "Network 1\nLD I0.0\nAN I0.1\nAN M0.0\nO M0.2\nTON T37, 3000\nLD I0.0\nAN I0.1\nAN T37\n= M0.2\n"
                    "Network 2\nLD T37\nAN M0.0\nA I0.1\nS M0.1, 1\nLD T37\nS M0.0, 1\n");
  s.search(20);
  ASSERT_TRUE(s.exploration->found(0).has_value());
  EXPECT_TRUE(s.isRepeated(0));
}

TEST(Exploration, CountersThatNeedHours) {
  // Seconds to minutes to hours; the second input takes everything back. 2 h in scans of at most 0.5 s.
  ExploredProgram s("//@ reach two hours: C2\n",
                    "Network 1\nLD I0.0\nAN T37\nTON T37, 10\nNetwork 2\nLD T37\nLD C1\nCTU C1, 60\n"
                    "Network 3\nLD C1\nLD I0.7\nCTU C2, 120\n");
  s.search(20);
  ASSERT_TRUE(s.exploration->found(0).has_value());
  EXPECT_TRUE(s.isRepeated(0));
  EXPECT_GE(s.exploration->found(0)->scanCount, 2U * 7200U);
}

/// Statements of OB1 of an S7-300.
ProgramInput step7Of(const std::string& properties, const std::string& statements) {
  return inputOfSource("ORGANIZATION_BLOCK OB 1\n" + properties + "BEGIN\nNETWORK\n" + statements +
                       "END_ORGANIZATION_BLOCK\n");
}

TEST(Exploration, AnS5TimerRunsToItsEndThoughNothingElseChanges) {
  ExploredProgram s(step7Of("//@ reach end: Q0.0\n", "A I 0.0;\nL S5T#5M;\nSD T 1;\nA T 1;\n= Q 0.0;\n"));
  s.search(20);
  ASSERT_TRUE(s.exploration->found(0).has_value());
  EXPECT_TRUE(s.isRepeated(0));
  EXPECT_GE(s.exploration->found(0)->milliseconds, 300'000U);
}

TEST(Exploration, TriesOtherReadingsOfOpenPoints) {
  // Q0.0 is what T1 was at the instruction. Where its end is seen at the start of a scan only (s5-time = synchronous,
  // the engine's reading), it is the same at the end; where it may come at any time, T1 may end behind the instruction.
  ExploredProgram s(step7Of("//@ reach later: T1 and not Q0.0\n", "A I 0.0;\nL S5T#2S;\nSD T 1;\nA T 1;\n= Q 0.0;\n"));
  ASSERT_TRUE(s.options.choices.is(Choice::S5Time, "synchronous"));
  s.search(20);
  ASSERT_TRUE(s.exploration->found(0).has_value());
  ASSERT_TRUE(s.exploration->found(0)->initial.has_value());
  EXPECT_EQ(readingIn(*s.exploration->found(0)->initial, Choice::S5Time), 1);
  EXPECT_TRUE(s.isRepeated(0));
}

TEST(Exploration, WaitsForTheClockOfAMinute) {
  // SM0.4 is on for half a minute, off for the other half (001:14054); nothing else happens.
  ExploredProgram s("//@ reach minute: M0.0\n", "Network 1\nLD SM0.4\nED\nS M0.0, 1\n");
  s.search(20);
  ASSERT_TRUE(s.exploration->found(0).has_value());
  EXPECT_TRUE(s.isRepeated(0));
  EXPECT_GE(s.exploration->found(0)->milliseconds, 30'000U);
}

TEST(Exploration, AssumptionsHoldAndNothingNewEndsIt) {
  ExploredProgram s("//@ assume never both: not (I0.0 and I0.1)\n//@ reach both: Q0.0\n",
                    "Network 1\nLD I0.0\nA I0.1\n= Q0.0\n");
  s.search(60);
  EXPECT_FALSE(s.exploration->found(0).has_value());
  EXPECT_FALSE(s.isOpenEnded);
}

}  // namespace
}  // namespace rungproof::test
