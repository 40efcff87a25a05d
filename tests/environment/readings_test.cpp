// Points that the manual leaves open: a proof covers all readings unless one was chosen, a run names the reading that
// it needs, and a verdict that rests on a chosen one says so.
#include <gtest/gtest.h>

#include "ir/s7200/cpu.hpp"
#include "tests/environment/asked.hpp"

namespace rungproof {
namespace {

using test::asked;
using test::assumes;
using test::hasNote;
using test::verdict;

/// A property that holds under the reading `holds` only, both named "key=value" for --choice.
struct Open {
  std::string program, property, holds, breaks;
  std::string otherBlocks{};
};

std::string spaced(std::string choice) { return choice.replace(choice.find('='), 1, " = "); }

void expectBoth(const Open& open) {
  SCOPED_TRACE(open.program + " / " + open.property);
  test::Asked question{open.program, open.property, 10, 0, "", open.otherBlocks};
  const ProofResult any = asked(question);
  EXPECT_EQ(any.outcome, Outcome::Violated);
  EXPECT_TRUE(hasNote(any, "under " + spaced(open.breaks)));
  question.choices = open.holds;
  const ProofResult good = asked(question);
  EXPECT_EQ(good.outcome, Outcome::Proved);
  EXPECT_TRUE(assumes(good, spaced(open.holds)));
  question.choices = open.breaks;
  const ProofResult bad = asked(question);
  EXPECT_EQ(bad.outcome, Outcome::Violated);
  EXPECT_TRUE(assumes(bad, spaced(open.breaks)));
}

// SM0.5 is off or on for its first half second (001:14055).
TEST(Readings, WhereTheClockBitsStart) {
  const std::string count = "LD SM0.0;AW< VW2,50;INCW VW2;";
  expectBoth({count + "LD SM0.5;= Q0.0", "VW2 < 9 implies not Q0.0", "scan-clock-start=off", "scan-clock-start=on"});
  expectBoth({count + "LD SM0.4;= Q0.0", "VW2 < 9 implies not Q0.0", "scan-clock-start=off", "scan-clock-start=on"});
  expectBoth({"LD SM0.6;= Q0.0", "first_scan implies not Q0.0", "scan-clock-start=off", "scan-clock-start=on"});
}

// Nothing ties their phase to the start of RUN: a first half period may be shorter than both readings have it.
TEST(Readings, TheClockBitsMayStartInsideAPeriod) {
  EXPECT_EQ(verdict({"LD SM0.5;= Q0.0", "reach rises(Q0.0) and prev(first_scan)", 10}), Outcome::Reachable);
  EXPECT_EQ(verdict({"LD SM0.5;= Q0.0", "reach falls(Q0.0) and prev(first_scan)", 10}), Outcome::Reachable);
}

TEST(Readings, OfInactiveScrSegments) {
  expectBoth({"LD I0.0;S S0.0,1;LD I0.1;R S0.0,1;LSCR S0.0;LD SM0.0;= Q0.0;SCRE",
              "not prev(S0.0) and not S0.0 implies not Q0.0", "inactive-scr=no-power-flow", "inactive-scr=skipped"});
}

TEST(Readings, OfIncrementsThatOverflow) {
  expectBoth({"LD SM0.0;INCB VB0", "prev(VB0) = 255 implies VB0 = 0 or first_scan", "increment-overflow=wraps",
              "increment-overflow=keeps"});
}

TEST(Readings, OfCountersInTheFirstScan) {
  expectBoth({"LD I0.0;LD I0.1;CTU C0,1", "first_scan implies not C0", "counter-first-edge=stored",
              "counter-first-edge=counts"});
}

TEST(Readings, OfDivisionFlags) {
  expectBoth(
      {"LD SM0.0;MOVW 1,VW2;DIV 2,VD0;LD SM1.0;= Q0.0", "never Q0.0", "div-flags=double-word", "div-flags=quotient"});
}

TEST(Readings, OfRoundedHalves) {
  expectBoth({"LD SM0.0;MOVR -2.5,VD0;ROUND VD0,VD4", "VD4 = -3", "round-half=away-from-zero", "round-half=up"});
}

// 16777219 lies between two REAL numbers: 16777220 is the nearest with an even last digit, 16777218 the one below.
TEST(Readings, OfLargeDoubleIntegersAsReal) {
  expectBoth({"LD SM0.0;MOVD 16777219,VD0;DTR VD0,VD4;MOVD VD4,VD8", "VD8 = 16#4B800002", "dtr-rounding=nearest",
              "dtr-rounding=truncated"});
}

TEST(Readings, OfBlockMovesOntoThemselves) {
  expectBoth({"LD SM0.0;MOVB 1,VB0;MOVB 2,VB1;BMB VB0,VB1,2", "VB2 = 1", "block-move-overlap=ascending",
              "block-move-overlap=buffered"});
}

TEST(Readings, OfStop) {
  expectBoth({"LD I0.0;STOP;LD I0.1;= Q0.0", "Q0.0 = I0.1", "stop-in-main=end-of-scan", "stop-in-main=at-once"});
}

TEST(Readings, OfInterruptRoutines) {
  expectBoth({"LD SM0.1;MOVB 10,SMB34;ATCH INT_0,10;ENI", "never M0.0", "interrupt-stack=zero", "interrupt-stack=one",
              "INTERRUPT_BLOCK INT_0:INT0;BEGIN;Network 1;= M0.0;END_INTERRUPT_BLOCK"});
}

TEST(Readings, OfTheStackAtTheStart) {
  expectBoth({"A I0.0;= Q0.0", "never Q0.0", "main-stack=zero", "main-stack=unknown"});
}

TEST(Readings, EnoOfBoxesThatDoNotRun) {
  expectBoth({"LD SM0.0;MOVB 1,VB0;LD I0.0;MOVB 2,VB1;LD SM0.0;AENO;= Q0.0", "Q0.0 implies I0.0", "skipped-eno=zero",
              "skipped-eno=kept"});
}

// What holds under all readings needs none of them.
TEST(Readings, AreNoAssumptionOfWhatTheyDoNotDecide) {
  const ProofResult all = asked({"LD SM0.0;INCB VB0", "prev(VB0) = 255 implies VB0 = 0 or VB0 = 255 or VB0 = 1", 10});
  EXPECT_EQ(all.outcome, Outcome::Proved);
  EXPECT_TRUE(all.assumptions.empty());
  const ProofResult other =
      asked({"LD SM0.0;INCB VB0;LD I0.0;= Q0.0", "Q0.0 = I0.0", 10, 0, "increment-overflow=wraps"});
  EXPECT_EQ(other.outcome, Outcome::Proved);
  EXPECT_FALSE(assumes(other, "increment-overflow = wraps"));
}

// How the plant is set up is no reading: proofs take what is usual and say so.
TEST(Readings, FactsOfThePlantAreNamed) {
  const ProofResult sampled = asked({"LD SM0.0;MOVW AIW0,VW0;MOVW AIW0,VW2", "VW0 = VW2", 10});
  EXPECT_EQ(sampled.outcome, Outcome::Proved);
  EXPECT_TRUE(assumes(sampled, "analog-sampling = each-scan"));
  test::Asked clock{"LD SM0.0;TODR VB0", "VB0 = 0", 10};
  clock.target.cpu = s7200Cpu("221");
  const ProofResult absent = asked(clock);
  EXPECT_EQ(absent.outcome, Outcome::Proved);
  EXPECT_TRUE(assumes(absent, "clock-module = absent"));
}

// A run of the engine takes one reading, of all points.
TEST(Readings, StandInTheStateOfTheEngine) {
  Choices choices;
  ASSERT_TRUE(choices.set("clock-data", "any"));
  ASSERT_TRUE(choices.set("first-edge", "first-execution"));
  const Program program = readText("test.awl",
                                   "ORGANIZATION_BLOCK MAIN:OB1\nBEGIN\nNetwork 1\nLD I0.0\n= Q0.0\n"
                                   "END_ORGANIZATION_BLOCK\n");
  const Concrete::Store store = powerUpState(Plan(program), choices);
  for (const ChoiceInfo& info : choiceTable) EXPECT_EQ(readingIn(store, info.choice), choices[info.choice]) << info.key;
}

}  // namespace
}  // namespace rungproof
