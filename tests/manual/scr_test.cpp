// Sequence control relays (001:5803-5884, 000:7974-8079).
#include "plant.hpp"

namespace rungproof::manual {
namespace {

/// A segment that assigns Q0.0, sets Q0.1, counts in VB0, and goes on with I0.0.
const std::string segment =
    "LSCR S0.1; LD SM0.0; = Q0.0; LD SM0.0; S Q0.1, 1; INCB VB0; LD I0.0; SCRT S0.2; SCRE; LD SM0.0; = Q0.7";

}  // namespace

TEST(Scr, LoadsTheSegmentBitOverTheTop) {
  // 000:7974-8004: the top is replaced, nothing is pushed.
  for (const bool active : {false, true}) {
    Plant plant("LD I0.0; LDN I0.0; LSCR S3.1; LPP; = Q0.0; SCRE");
    plant.set(active ? "S3.1=1 I0.0=1" : "I0.0=1 Q0.0=1").scan();
    EXPECT_EQ(plant.value("Q0.0"), active ? 1U : 0U);
    Plant top("LD SM0.0; LSCR S3.1; SCRE; = Q0.1");
    top.set(active ? "S3.1=1" : "Q0.1=1").scan();
    EXPECT_EQ(top.value("Q0.1"), active ? 1U : 0U);
  }
}

TEST(Scr, AnInactiveSegmentHasNoPowerFlow) {
  Plant plant(segment);
  plant.set("Q0.0=1 I0.0=1").scan();
  EXPECT_EQ(plant.value("QB0"), 0x80U) << "the coil drops, S does nothing, behind SCRE all is as usual";
  EXPECT_EQ(plant.value("VB0"), 0U);
  EXPECT_EQ(plant.value("SB0"), 0U);
}

TEST(Scr, AnInactiveSegmentIsSkippedByChoice) {
  Plant plant(segment);
  ASSERT_TRUE(plant.choices.set("inactive-scr", "skipped"));
  plant.set("Q0.0=1 I0.0=1").scan();
  EXPECT_EQ(plant.value("QB0"), 0x81U) << "the coil keeps its bit";
  EXPECT_EQ(plant.value("VB0"), 0U);
  plant.set("S0.1=1 I0.0=0").scan();
  EXPECT_EQ(plant.value("QB0"), 0x83U);
}

TEST(Scr, TransitionTakesEffectAtTheNextLscr) {
  // 001:5834: the bits change at once, the running segment keeps its power until it is left.
  Plant plant(
      "LSCR S0.1; LD I0.0; SCRT S0.2; LD SM0.0; INCB VB0; SCRE; LSCR S0.2; LD SM0.0; INCB VB1; LD I0.1; SCRT S0.1; "
      "SCRE");
  plant.set("S0.1=1").scan();
  EXPECT_EQ(plant.value("VW0"), 0x0100U);
  plant.set("I0.0=1").scan();
  EXPECT_EQ(plant.value("VW0"), 0x0201U) << "both run in the scan of a transition downwards";
  EXPECT_EQ(plant.value("SB0"), 0b100U);
  plant.set("I0.0=0 I0.1=1").scan();
  EXPECT_EQ(plant.value("VW0"), 0x0202U) << "upwards the target runs in the next scan";
  EXPECT_EQ(plant.value("SB0"), 0b010U);
  plant.set("I0.1=0").scan();
  EXPECT_EQ(plant.value("VW0"), 0x0302U);
}

TEST(Scr, ATransitionToItselfKeepsTheSegment) {
  Plant plant("LSCR S0.1; LD SM0.0; SCRT S0.1; SCRE");
  plant.set("S0.1=1").scan();
  EXPECT_EQ(plant.value("SB0"), 0b010U);
}

TEST(Scr, Divergence) {
  // 001:5854-5858: two SCRT under one condition activate both branches.
  Plant plant("LSCR S0.0; LD I0.0; SCRT S0.1; SCRT S1.1; SCRE");
  plant.set("S0.0=1").scan();
  EXPECT_EQ(plant.value("SW0"), 0x0100U);
  plant.set("I0.0=1").scan();
  EXPECT_EQ(plant.value("SW0"), 0x0202U);
}

TEST(Scr, Convergence) {
  // 001:5865-5872: waiting states S3.5 and S6.5; a network outside segments goes on when both are there.
  Plant plant(
      "LSCR S3.4; LD I0.0; SCRT S3.5; SCRE; LSCR S6.4; LD I0.1; SCRT S6.5; SCRE; "
      "LD S3.5; A S6.5; S S5.0, 1; R S3.5, 1; R S6.5, 1");
  plant.set("S3.4=1 S6.4=1 I0.0=1").scan();
  EXPECT_EQ(plant.value("S3.5"), 1U);
  EXPECT_EQ(plant.value("S5.0"), 0U);
  plant.set("I0.1=1").scan();
  EXPECT_EQ(plant.value("S5.0"), 1U);
  EXPECT_EQ(plant.value("S3.5"), 0U);
  EXPECT_EQ(plant.value("S6.5"), 0U);
}

TEST(Scr, ConditionalBranchMayTakeBoth) {
  // 001:5875-5884: two conditions true in one scan activate two states, because the S stack stays.
  Plant plant("LSCR S0.0; LD I0.0; SCRT S0.1; LD I0.1; SCRT S0.2; SCRE");
  plant.set("S0.0=1 I0.0=1 I0.1=1").scan();
  EXPECT_EQ(plant.value("SB0"), 0b110U);
}

TEST(Scr, CscreLeavesTheSegmentEarly) {
  // 001:5841: the rest of the segment is not executed; S bit and S stack stay.
  Plant plant("LSCR S0.0; LD I0.0; CSCRE; LD SM0.0; INCB VB0; SCRE; LD SM0.0; INCB VB1");
  plant.set("S0.0=1").scan();
  EXPECT_EQ(plant.value("VW0"), 0x0101U);
  plant.set("I0.0=1").scan();
  EXPECT_EQ(plant.value("VW0"), 0x0102U);
  EXPECT_EQ(plant.value("S0.0"), 1U);
  Plant inactive("LSCR S0.0; LD SM0.0; CSCRE; LD SM0.0; = Q0.0; SCRE");
  inactive.set("Q0.0=1").scan();
  EXPECT_EQ(inactive.value("Q0.0"), 0U) << "no power flow, so CSCRE does not leave";
}

TEST(Scr, JumpsAndLoopsInsideNeedPowerFlow) {
  Plant plant("LSCR S0.0; LD SM0.0; JMP 1; LD SM0.0; = Q0.0; LBL 1; LD SM0.0; FOR VW0, 1, 2; INCB VB2; NEXT; SCRE");
  plant.set("Q0.0=1").scan();
  EXPECT_EQ(plant.value("Q0.0"), 0U) << "inactive: no jump, the coil drops";
  EXPECT_EQ(plant.value("VB2"), 0U);
  plant.set("S0.0=1 Q0.0=1").scan();
  EXPECT_EQ(plant.value("Q0.0"), 1U) << "active: jumped over";
  EXPECT_EQ(plant.value("VB2"), 2U);
}

TEST(Scr, TimersInAnInactiveSegment) {
  // A TON sees no power flow; a TOF has value 0, bit 0 and does not time (001:6575).
  Plant plant("LSCR S0.0; LD I0.0; TON T37, +3; LD I0.0; TOF T38, +3; SCRE");
  plant.set("S0.0=1 I0.0=1").scan(0, 1);
  EXPECT_EQ(plant.scan(0, 1).current(37), 1) << "enabled in the scan before";
  EXPECT_TRUE(plant.timerBit(38));
  plant.set("S0.0=0").scan(0, 1);
  EXPECT_EQ(plant.current(37), 0);
  EXPECT_FALSE(plant.timerBit(38));
  EXPECT_EQ(plant.current(38), 0);
  plant.set("S0.0=1 I0.0=0").scan(0, 1);
  EXPECT_FALSE(plant.timerBit(38)) << "no edge of its own";
  EXPECT_EQ(plant.current(38), 0) << "and it does not time";
}

TEST(Scr, TheTrafficLightStartsInItsFirstState) {
  // 000:8037-8079, shortened: SM0.1 sets S0.1 above LSCR S0.1, so state 1 is active in the first scan. T37 waits 2 s.
  Plant plant(
      "LD SM0.1; S S0.1, 1; LSCR S0.1; LD SM0.0; S Q0.4, 1; R Q0.5, 2; TON T37, +20; LD T37; SCRT S0.2; SCRE; "
      "LSCR S0.2; LD SM0.0; S Q0.2, 1; TON T38, +250; LD T38; SCRT S0.3; SCRE");
  plant.set("SM0.1=1 Q0.5=1 Q0.6=1").scan();
  EXPECT_EQ(plant.value("QB0"), 0b00010000U);
  plant.set("SM0.1=0").scans(19);
  EXPECT_EQ(plant.value("SB0"), 0b010U);
  plant.scans(1);
  EXPECT_EQ(plant.value("SB0"), 0b100U) << "20 ticks of 100 ms";
  EXPECT_EQ(plant.value("Q0.2"), 1U) << "state 2 stands below and runs in the same scan";
  plant.scans(1);
  EXPECT_EQ(plant.current(37), 0) << "the timer of the inactive state is reset";
}

}  // namespace rungproof::manual
