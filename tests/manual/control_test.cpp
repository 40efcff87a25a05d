// Program control: jumps, loops, END, STOP, WDR, DLED (001:5687-5801, 001:5886-5915).
#include "example.hpp"

namespace rungproof::manual {

TEST(Jump, SkipsWithPowerFlowOnly) {
  check({
      {"JMP 4; MOVB 1, VB0; LBL 4; MOVB 1, VB1", "", "VB1=1"},
      {"LDN SM0.0; JMP 4; LD SM0.0; MOVB 1, VB0; LBL 4; MOVB 1, VB1", "", "VB0=1 VB1=1"},
      {"JMP 4; MOVB 1, VB0; LBL 3; MOVB 1, VB1; LBL 4; MOVB 1, VB2", "", "VB2=1 ENO[0]=1"},
  });
}

TEST(Jump, BackwardsRepeats) {
  // Counts VW0 to 5, then leaves: no bound but the watchdog (001:5792).
  check({"LBL 1; LD SM0.0; INCW VW0; LDW< VW0, +5; JMP 1; LD SM0.0; MOVB 1, VB2", "",
         "VW0=5 VB2=1 SM1.0=0 SM1.1=0 SM1.2=0"});
}

TEST(Jump, KeepsTheStack) {
  Plant plant("LD I0.0; LD SM0.0; JMP 1; LBL 1; LPP; = Q0.0");
  EXPECT_EQ(plant.set("I0.0=1").scan().value("Q0.0"), 1U);
  EXPECT_EQ(plant.set("I0.0=0").scan().value("Q0.0"), 0U);
}

TEST(Loop, TenPasses) {
  // 001:5766: INIT 1, FINAL 10: the body runs ten times with INDX 1 to 10; afterwards it is 11.
  check({
      {"FOR VW0, 1, 10; +I VW0, VW2; INCB VB4; NEXT", "", "VW0=11 VW2=55 VB4=10 SM1.0=0 SM1.1=0 SM1.2=0"},
      {"FOR VW0, VW6, VW8; INCB VB4; NEXT", "VW6=-1 VW8=1", "VW0=2 VB4=3 SM1.0=0 SM1.1=0"},
      {"FOR AC0, 3, 3; INCB VB4; NEXT", "AC0=16#55550000", "AC0=16#55550004 VB4=1 SM1.0=0 SM1.1=0"},
  });
}

TEST(Loop, NoPassIfInitExceedsFinalOrWithoutPowerFlow) {
  check({
      {"FOR VW0, 5, 4; MOVB 1, VB4; NEXT; = Q0.0", "", "VW0=5 Q0.0=1"},
      {"FOR VW0, 5, -6; MOVB 1, VB4; NEXT; = Q0.0", "", "VW0=5 Q0.0=1"},
      {"LDN SM0.0; FOR VW0, 1, 3; LD SM0.0; MOVB 1, VB4; NEXT; = Q0.0", "VW0=77 Q0.0=1", "Q0.0=0 ENO[0]=0"},
  });
}

TEST(Loop, FinalAndIndexMayChangeInside) {
  check({
      {"FOR VW0, 1, VW2; INCB VB4; MOVW 2, VW2; NEXT", "VW2=9", "VW0=3 VW2=2 VB4=2 SM1.0=0 SM1.1=0"},
      // INDX set to 9 in the first pass: NEXT makes it 10, above FINAL.
      {"FOR VW0, 1, 9; INCB VB4; MOVW 9, VW0; NEXT", "", "VW0=10 VB4=1 SM1.0=0 SM1.1=0"},
  });
}

TEST(Loop, NestsAndLeavesTheTopAt1) {
  check({
      {"FOR VW0, 1, 3; FOR VW2, 1, 4; INCB VB4; NEXT; NEXT; = Q0.0", "", "VW0=4 VW2=5 VB4=12 Q0.0=1 SM1.0=0 SM1.1=0"},
      {"FOR VW0, 1, 2; LDN SM0.0; NEXT; = Q0.0; INCB VB4", "", "VW0=3 VB4=1 Q0.0=1 SM1.0=0 SM1.1=0"},
  });
}

TEST(Loop, AtTheLargestFinal) {
  // FINAL 32767 cannot be exceeded by a word: the loop ends, or INDX wraps; the label leaves it after the fifth pass.
  const std::string loop = "FOR VW0, 32766, 32767; INCW VW4; LDW= VW4, +5; JMP 9; NEXT; LBL 9";
  check({
      {loop, "", "VW0=-32768 VW4=2 SM1.0=0 SM1.1=0 SM1.2=0"},
      {loop, "", "VW0=-32766 VW4=5 SM1.0=0 SM1.1=0 SM1.2=0", "", "for-at-maximum=wraps"},
  });
}

TEST(Loop, BadPointerSkipsTheBody) {
  check({"FOR VW0, 1, *VD8; MOVB 1, VB4; NEXT; MOVB 1, VB5", "VD8=16#FF000000", "VB5=1 ENO[0]=1", "0006"});
}

TEST(End, EndsTheScanWithPowerFlow) {
  check({
      {"END; = Q0.0", "", ""},
      {"LDN SM0.0; END; LD SM0.0; = Q0.0", "", "Q0.0=1"},
      {"MEND; = Q0.0", "", ""},
      {"LDN SM0.0; MEND; LD SM0.0; = Q0.0", "", ""},
  });
}

TEST(Stop, LeavesRunAtOnceOrAtTheEndOfTheScan) {
  Plant atOnce("LD SM0.0; MOVB 1, VB0; STOP; MOVB 1, VB1");
  atOnce.scan();
  EXPECT_EQ(atOnce.value("RUN[0]"), 0U);
  EXPECT_TRUE(atOnce.halted);
  EXPECT_EQ(atOnce.value("VB0"), 1U);
  EXPECT_EQ(atOnce.value("VB1"), 0U);
  Plant later("LD SM0.0; STOP; MOVB 1, VB1");
  ASSERT_TRUE(later.choices.set("stop-in-main", "end-of-scan"));
  later.scan();
  EXPECT_EQ(later.value("RUN[0]"), 0U);
  EXPECT_EQ(later.value("VB1"), 1U);
  Plant idle("LDN SM0.0; STOP; LD SM0.0; MOVB 1, VB1");
  idle.scan();
  EXPECT_EQ(idle.value("RUN[0]"), 1U);
  EXPECT_EQ(idle.value("VB1"), 1U);
  EXPECT_FALSE(idle.halted);
}

TEST(Stop, InASubroutineEndsTheProgram) {
  Plant plant(
      {{PouKind::Main, 0, "LD SM0.0; CALL 1; MOVB 1, VB0"}, {PouKind::Subroutine, 1, "LD SM0.0; STOP; MOVB 1, VB1"}});
  plant.scan();
  EXPECT_EQ(plant.value("RUN[0]"), 0U);
  EXPECT_EQ(plant.value("VW0"), 0U);
}

TEST(Stop, InAnInterruptRoutineLetsTheScanFinish) {
  // 001:5695; the subroutine that the routine called ends with it.
  for (const bool inSubroutine : {false, true}) {
    Plant plant(
        {{PouKind::Main, 0, "LD SM0.0; MOVB 1, VB0"},
         {PouKind::Interrupt, 0, inSubroutine ? "LD SM0.0; CALL 1; MOVB 1, VB1" : "LD SM0.0; STOP; MOVB 1, VB1"},
         {PouKind::Subroutine, 1, "LD SM0.0; STOP; MOVB 1, VB2"}});
    plant.interruptBefore[1] = 0;
    plant.scan();
    EXPECT_EQ(plant.value("RUN[0]"), 0U);
    EXPECT_EQ(plant.value("VB0"), 1U) << "the main program goes on";
    EXPECT_EQ(plant.value("VB1"), 0U) << "the routine does not";
    EXPECT_EQ(plant.value("VB2"), 0U);
    EXPECT_FALSE(plant.halted);
  }
}

TEST(Watchdog, WdrTellsTheOutside) {
  Plant plant("LD I0.0; WDR");
  plant.scan();
  EXPECT_TRUE(plant.outside.signals.empty());
  plant.set("I0.0=1").scan();
  ASSERT_EQ(plant.outside.signals.size(), 1U);
  EXPECT_EQ(plant.outside.signals[0].first, Signal::WatchdogRestarted);
}

TEST(DiagnosticLed, IsOnAboveZero) {
  check({
      {"DLED VB0", "VB0=1", "DIAG[0]=1"},
      {"DLED 128", "", "DIAG[0]=1"},
      {"DLED VB0", "DIAG[0]=1", "DIAG[0]=0"},
      {"LDN SM0.0; DLED 1", "", ""},
  });
}

}  // namespace rungproof::manual
