// The time bases of 10 ms and 100 ms run freely, RUN and the enabling of a timer fall anywhere between two ticks: the
// first interval may be short (001:6592). What passed before a timer was enabled does not count (001:6590).
#include <gtest/gtest.h>

#include "tests/engine/rig.hpp"
#include "tests/environment/asked.hpp"

namespace rungproof {
namespace {

using test::asked;
using test::verdict;

// Scans of 10 ms. Scan 1 enables T37; its first tick comes 10 ms (scan 2) to 100 ms (scan 11) after the start of
// scan 1.
constexpr const char* hundred = "LD SM0.0;TON T37,1;AW< VW0,50;INCW VW0;LD T37;= Q0.0";

TEST(TickPhase, FirstIntervalOfAHundredMillisecondTimerMayBeShort) {
  EXPECT_EQ(verdict({hundred, "VW0 < 9 implies not Q0.0", 10}), Outcome::Violated);
  EXPECT_EQ(verdict({hundred, "VW0 < 3 implies not Q0.0", 10}), Outcome::Violated);
  EXPECT_EQ(verdict({hundred, "VW0 < 2 implies not Q0.0", 10}), Outcome::Proved);
}

TEST(TickPhase, ItIsNeverLong) {
  EXPECT_EQ(verdict({hundred, "VW0 >= 11 implies Q0.0", 10}), Outcome::Proved);
  EXPECT_EQ(verdict({hundred, "VW0 >= 10 implies Q0.0", 10}), Outcome::Violated);
}

// T33 takes its ticks at the start of a scan. Scans of 5 ms: a tick 5 or 10 ms after the start of scan 1.
TEST(TickPhase, SoOfATenMillisecondTimer) {
  const char* program = "LD SM0.0;TON T33,1;AW< VW0,50;INCW VW0;LD T33;= Q0.0";
  EXPECT_EQ(verdict({program, "VW0 < 3 implies not Q0.0", 5}), Outcome::Violated);
  EXPECT_EQ(verdict({program, "VW0 < 2 implies not Q0.0", 5}), Outcome::Proved);
  EXPECT_EQ(verdict({program, "VW0 >= 3 implies Q0.0", 5}), Outcome::Proved);
}

TEST(TickPhase, SoOfAOneMillisecondTimer) {
  const char* program = "LD SM0.0;TON T32,1;AW< VW0,50;INCW VW0;LD T32;= Q0.0";
  EXPECT_EQ(verdict({program, "VW0 < 2 implies not Q0.0", 10}), Outcome::Violated);  // within the scan (001:6607)
  // All of scan 1 may pass in front of the timer, all of scan 2 behind the contact.
  EXPECT_EQ(verdict({program, "VW0 >= 3 implies Q0.0", 10}), Outcome::Proved);
  EXPECT_EQ(verdict({program, "VW0 >= 2 implies Q0.0", 10}), Outcome::Violated);
}

TEST(TickPhase, TheWitnessSaysWhereItStarts) {
  const ProofResult result = asked({hundred, "VW0 < 3 implies not Q0.0", 10});
  ASSERT_EQ(result.outcome, Outcome::Violated);
  EXPECT_TRUE(test::hasNote(result, "RUN begins 90 ms after a tick of the 100 ms time base"));
}

// Preset n + 1 guarantees n intervals, preset n only n - 1 of them (001:6592).
TEST(TickPhase, OneMoreGuaranteesTheInterval) {
  const char* three = "LD I0.0;TON T37,3;LD T37;= Q0.0";
  const char* four = "LD I0.0;TON T37,4;LD T37;= Q0.0";
  EXPECT_EQ(verdict({four, "Q0.0 implies held(I0.0, 300ms)", 10}), Outcome::Proved);
  EXPECT_EQ(verdict({three, "Q0.0 implies held(I0.0, 300ms)", 10}), Outcome::Violated);
  EXPECT_EQ(verdict({three, "Q0.0 implies held(I0.0, 200ms)", 10}), Outcome::Proved);
}

// Scans of 500 ms: five ticks a scan, none of them in the scan that enables the timer.
TEST(Enabling, NothingIsCountedFromBefore) {
  EXPECT_EQ(verdict({"LD I0.0;TON T37,10", "rises(I0.0) implies T37.value = 0", 500}), Outcome::Proved);
  EXPECT_EQ(verdict({"LD I0.0;TON T37,10", "reach prev(rises(I0.0)) and T37.value = 5", 500}), Outcome::Reachable);
  EXPECT_EQ(verdict({"LD I0.0;TON T37,3;LD T37;= Q0.0", "Q0.0 implies held(I0.0, 150ms)", 500}), Outcome::Proved);
}

TEST(Enabling, OfEveryKindAndResolution) {
  EXPECT_EQ(verdict({"LD I0.0;TON T33,10", "rises(I0.0) implies T33.value = 0", 500}), Outcome::Proved);
  EXPECT_EQ(verdict({"LD I0.0;TONR T5,10", "rises(I0.0) implies T5.value = prev(T5.value)", 500}), Outcome::Proved);
  EXPECT_EQ(verdict({"LD I0.0;TOF T37,3;LD T37;= Q0.0", "falls(I0.0) implies Q0.0", 500}), Outcome::Proved);
  EXPECT_EQ(verdict({"LD I0.0;TOF T33,3;LD T33;= Q0.0", "falls(I0.0) implies Q0.0", 500}), Outcome::Proved);
}

// A subroutine that is called now and then: each call counts the ticks of one scan, the others are lost (001:6611).
TEST(Enabling, InASubroutineThatIsCalledNowAndThen) {
  const test::Asked called{"LD I0.1;CALL 0",
                           "T37.value <= prev(T37.value) + 5",
                           500,
                           0,
                           "",
                           "SUBROUTINE_BLOCK SBR_0:SBR0;BEGIN;Network 1;LD I0.0;TON T37,100;END_SUBROUTINE_BLOCK"};
  EXPECT_EQ(verdict(called), Outcome::Proved);
  test::Asked first = called;
  first.property = "rises(I0.1) and not once(prev(I0.1)) implies T37.value = 0";
  EXPECT_EQ(verdict(first), Outcome::Proved);
}

// R in front of the timer in a scan of 500 ms: whether the five ticks before the R count is open.
TEST(Enabling, AfterAReset) {
  const test::Asked reset{"LD I0.1;R T5,1;LD SM0.0;TONR T5,100", "I0.1 implies T5.value = 0", 500};
  const ProofResult open = asked(reset);
  EXPECT_EQ(open.outcome, Outcome::Violated);
  EXPECT_TRUE(test::hasNote(open, "under timer-after-reset = goes-on"));
  test::Asked anew = reset;
  anew.choices = "timer-after-reset=starts-anew";
  const ProofResult chosen = asked(anew);
  EXPECT_EQ(chosen.outcome, Outcome::Proved);
  EXPECT_TRUE(test::assumes(chosen, "timer-after-reset = starts-anew"));
}

// The engine: 90 ms after a tick the next one comes with scan 2 (scans of 10 ms); at a tick, with scan 11.
TEST(TickPhase, OfTheEngineIsAnOption) {
  for (const auto& [phase, scan] : {std::pair{0U, 11}, std::pair{90U, 2}, std::pair{55U, 6}, std::pair{99U, 2}}) {
    SimulatorOptions options;
    options.phaseMs = phase;
    Rig rig("LD SM0.0\nTON T37, +1\nLD T37\n= Q0.0\n", options);
    rig.scans(scan - 1);
    EXPECT_EQ(rig.get("Q0.0"), 0) << phase;
    rig.scans(1);
    EXPECT_EQ(rig.get("Q0.0"), 1) << phase;
  }
}

TEST(TickPhase, GoesOnInStop) {
  SimulatorOptions options;
  options.phaseMs = 30;
  Rig rig("LD SM0.0\nTON T37, +1\nLD T37\n= Q0.0\n", options);
  rig.simulator->stop();
  rig.scans(16);  // 160 ms: RUN begins 90 ms after a tick
  rig.simulator->run();
  rig.scans(1);
  EXPECT_EQ(rig.get("Q0.0"), 0);
  rig.scans(1);
  EXPECT_EQ(rig.get("Q0.0"), 1);
}

}  // namespace
}  // namespace rungproof
