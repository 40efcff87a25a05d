// Timers (001:6517-6727): table 6-73 for TON, TONR, TOF at each resolution, the moments of table 6-74, self-resetting
// timers, the IEC boxes of table 6-76, R, writing the current value, BITIM and CITIM.
// T37 100 ms, T33 10 ms, T32 1 ms for TON and TOF; T5, T1, T0 for TONR.
#include "example.hpp"
#include "ir/s7200/cpu.hpp"

namespace rungproof::manual {
namespace {

struct State {
  int current;
  bool bit;
  friend bool operator==(const State&, const State&) = default;
  friend std::ostream& operator<<(std::ostream& out, const State& s) {
    return out << s.current << (s.bit ? " on" : " off");
  }
};
State of(const Plant& plant, std::uint32_t timer) { return {plant.current(timer), plant.timerBit(timer)}; }
/// One scan with I0.0 = in after one tick of the timer's resolution.
State tick(Plant& plant, std::uint32_t timer, bool in) {
  plant.set("I0.0", in ? 1 : 0);
  const int resolution = timerResolution(static_cast<int>(timer));
  if (resolution == 1) plant.ms[0] = 1;
  plant.scan(resolution == 10 ? 1 : 0, resolution == 100 ? 1 : 0);
  return of(plant, timer);
}
constexpr bool on = true, off = false;

}  // namespace

// ---- 100 ms: everything happens at the instruction ------------------------------------------------------------
// An execution counts the intervals of the scan before it if the timer was already enabled there: intervals count after
// the activation (001:6590).

TEST(Ton, CountsWhileOnAndGoesOnPastThePreset) {
  Plant plant("LD I0.0; TON T37, +3");
  EXPECT_EQ(tick(plant, 37, off), (State{0, off}));
  EXPECT_EQ(tick(plant, 37, on), (State{0, off})) << "the tick before the activation does not count";
  EXPECT_EQ(tick(plant, 37, on), (State{1, off}));
  EXPECT_EQ(tick(plant, 37, on), (State{2, off}));
  EXPECT_EQ(tick(plant, 37, on), (State{3, on}));
  EXPECT_EQ(tick(plant, 37, on), (State{4, on}));
  EXPECT_EQ(tick(plant, 37, off), (State{0, off}));
  EXPECT_EQ(tick(plant, 37, on), (State{0, off}));
  EXPECT_EQ(tick(plant, 37, on), (State{1, off}));
}

TEST(Ton, StopsAt32767) {
  Plant plant("LD SM0.0; TON T37, +3");
  plant.set("T.value[37]=32765").scan(0, 1);
  EXPECT_EQ(of(plant, 37), (State{32765, on})) << "enabled only now; the value is beyond the preset";
  EXPECT_EQ(of(plant.scan(0, 1), 37), (State{32766, on}));
  EXPECT_EQ(of(plant.scan(0, 1), 37), (State{32767, on}));
  EXPECT_EQ(of(plant.scan(0, 1), 37), (State{32767, on}));
  plant.set("T.value[37]=32000").scan(0, 60000);
  EXPECT_EQ(plant.current(37), 32767);
}

TEST(Ton, NoTickNoCount) {
  Plant plant("LD SM0.0; TON T37, +1");
  EXPECT_EQ(of(plant.scan(0, 0), 37), (State{0, off}));
  EXPECT_EQ(of(plant.scan(50, 0), 37), (State{0, off})) << "10 ms ticks are not its own";
  EXPECT_EQ(of(plant.scan(0, 2), 37), (State{2, on}));
}

TEST(Ton, PresetIsReadAtEachExecution) {
  // "current >= preset" (001:6565): lowering PT below the current value sets the bit.
  Plant plant("LD SM0.0; TON T37, VW0");
  plant.set("VW0=100").scan(0, 5);
  EXPECT_EQ(of(plant, 37), (State{0, off}));
  plant.scan(0, 5);
  EXPECT_EQ(of(plant, 37), (State{5, off}));
  plant.set("VW0=5").scan(0, 0);
  EXPECT_EQ(of(plant, 37), (State{5, on}));
  Plant negative("LD SM0.0; TON T37, -1");
  EXPECT_EQ(of(negative.scan(0, 0), 37), (State{0, on})) << "0 >= -1 in the execution that enables it";
}

TEST(Tonr, HoldsWhileOff) {
  Plant plant("LD I0.0; TONR T5, +3");
  EXPECT_EQ(tick(plant, 5, on), (State{0, off}));
  EXPECT_EQ(tick(plant, 5, on), (State{1, off}));
  EXPECT_EQ(tick(plant, 5, off), (State{1, off})) << "switched off before the tick of its last scan is counted";
  EXPECT_EQ(tick(plant, 5, on), (State{1, off}));
  EXPECT_EQ(tick(plant, 5, on), (State{2, off}));
  EXPECT_EQ(tick(plant, 5, on), (State{3, on}));
  EXPECT_EQ(tick(plant, 5, off), (State{3, on}));
  EXPECT_EQ(tick(plant, 5, on), (State{3, on}));
  EXPECT_EQ(tick(plant, 5, on), (State{4, on}));
  plant.set("T.value[5]=32767");
  EXPECT_EQ(tick(plant, 5, on), (State{32767, on}));
}

TEST(Tonr, OnlyRResets) {
  Plant plant("LD I0.0; TONR T5, +2; LD I0.1; R T5, 1");
  tick(plant, 5, on);
  tick(plant, 5, on);
  EXPECT_EQ(tick(plant, 5, on), (State{2, on}));
  plant.set("I0.1=1");
  EXPECT_EQ(tick(plant, 5, on), (State{0, off}));
  plant.set("I0.1=0");
  EXPECT_EQ(tick(plant, 5, on), (State{1, off})) << "it stayed enabled";
}

TEST(Tonr, RetainedValueReturnsTheBitWhenItIsEnabled) {
  Plant plant("LD I0.0; TONR T5, +3");
  plant.set("T.value[5]=9");
  EXPECT_EQ(tick(plant, 5, off), (State{9, off}));
  EXPECT_EQ(tick(plant, 5, on), (State{9, on}));
  EXPECT_EQ(tick(plant, 5, on), (State{10, on}));
}

TEST(Tof, CountsAfterAFallOfTheInputOnly) {
  Plant plant("LD I0.0; TOF T37, +3");
  EXPECT_EQ(tick(plant, 37, off), (State{0, off})) << "does not time from the start";
  EXPECT_EQ(tick(plant, 37, off), (State{0, off}));
  EXPECT_EQ(tick(plant, 37, on), (State{0, on}));
  EXPECT_EQ(tick(plant, 37, on), (State{0, on}));
  EXPECT_EQ(tick(plant, 37, off), (State{0, on})) << "the fall: it times from here on";
  EXPECT_EQ(tick(plant, 37, off), (State{1, on}));
  EXPECT_EQ(tick(plant, 37, off), (State{2, on}));
  EXPECT_EQ(tick(plant, 37, off), (State{3, off}));
  EXPECT_EQ(tick(plant, 37, off), (State{3, off})) << "stops at the preset";
  EXPECT_EQ(tick(plant, 37, on), (State{0, on}));
}

TEST(Tof, AnInputThatComesBackEarlyKeepsTheBit) {
  Plant plant("LD I0.0; TOF T37, +3");
  tick(plant, 37, on);
  tick(plant, 37, off);
  EXPECT_EQ(tick(plant, 37, off), (State{1, on}));
  EXPECT_EQ(tick(plant, 37, on), (State{0, on}));
  tick(plant, 37, off);
  EXPECT_EQ(tick(plant, 37, off), (State{1, on}));
  plant.scan(0, 50);
  EXPECT_EQ(of(plant, 37), (State{3, off})) << "many ticks at once end at the preset";
}

TEST(Tof, AfterRItNeedsANewEdge) {
  // 001:6586.
  Plant plant("LD I0.0; TOF T37, +3; LD I0.1; R T37, 1");
  tick(plant, 37, on);
  tick(plant, 37, off);
  EXPECT_EQ(tick(plant, 37, off), (State{1, on}));
  plant.set("I0.1=1");
  EXPECT_EQ(tick(plant, 37, off), (State{0, off}));
  plant.set("I0.1=0");
  EXPECT_EQ(tick(plant, 37, off), (State{0, off}));
  EXPECT_EQ(tick(plant, 37, on), (State{0, on}));
  EXPECT_EQ(tick(plant, 37, off), (State{0, on}));
  EXPECT_EQ(tick(plant, 37, off), (State{1, on}));
}

TEST(Timer100, ExecutedTwiceRunsFastAndNotExecutedLosesTime) {
  Plant twice("LD SM0.0; TON T37, +100; TON T37, +100");
  EXPECT_EQ(twice.scan(0, 3).current(37), 3) << "enabled by the first, counted by the second";
  EXPECT_EQ(twice.scan(0, 3).current(37), 9);
  Plant skipped("LD I0.0; JMP 1; LD SM0.0; TON T37, +100; LBL 1");
  EXPECT_EQ(skipped.scan(0, 3).current(37), 0);
  EXPECT_EQ(skipped.scan(0, 3).current(37), 3);
  EXPECT_EQ(skipped.set("I0.0=1").scan(0, 3).current(37), 3);
  EXPECT_EQ(skipped.set("I0.0=0").scan(0, 3).current(37), 6);
}

// ---- 10 ms: at the start of the scan --------------------------------------------------------------------------

TEST(Timer10, CountsAtTheStartOfTheScan) {
  Plant plant("LD I0.0; TON T33, +3; LD T33; = Q0.0");
  EXPECT_EQ(tick(plant, 33, on), (State{0, off})) << "enabled only now";
  EXPECT_EQ(tick(plant, 33, on), (State{1, off}));
  EXPECT_EQ(tick(plant, 33, on), (State{2, off}));
  EXPECT_EQ(tick(plant, 33, on), (State{3, on}));
  EXPECT_EQ(plant.value("Q0.0"), 1U);
  EXPECT_EQ(plant.scan(0, 9).current(33), 3) << "100 ms ticks are not its own";
  EXPECT_EQ(tick(plant, 33, off), (State{0, off})) << "cleared by the instruction, in the middle of the scan";
  EXPECT_EQ(tick(plant, 33, off), (State{0, off}));
}

TEST(Timer10, BitIsConstantDuringTheScanBeforeTheInstruction) {
  Plant plant("LD T33; = Q0.0; LD I0.0; TON T33, +1; LD T33; = Q0.1");
  tick(plant, 33, on);
  tick(plant, 33, on);
  EXPECT_EQ(plant.value("QB0"), 0b11U);
  tick(plant, 33, off);
  EXPECT_EQ(plant.value("QB0"), 0b01U);
}

TEST(Timer10, RunsOnWhenNotExecuted) {
  Plant plant("LD I0.1; JMP 1; LD I0.0; TON T33, +3; LBL 1");
  tick(plant, 33, on);
  plant.set("I0.1=1");
  EXPECT_EQ(tick(plant, 33, off), (State{1, off}));
  EXPECT_EQ(tick(plant, 33, off), (State{2, off}));
  EXPECT_EQ(tick(plant, 33, off), (State{3, on}));
  Plant twice("LD SM0.0; TON T33, +9; TON T33, +9");
  twice.scan(1, 0);
  EXPECT_EQ(twice.scan(2, 0).current(33), 2) << "executed twice it does not run fast";
}

TEST(Timer10, RetentiveAndOffDelay) {
  Plant retentive("LD I0.0; TONR T1, +2");
  tick(retentive, 1, on);
  EXPECT_EQ(tick(retentive, 1, off), (State{1, off})) << "enabled until this scan's instruction";
  EXPECT_EQ(tick(retentive, 1, off), (State{1, off}));
  tick(retentive, 1, on);
  EXPECT_EQ(tick(retentive, 1, on), (State{2, on}));
  Plant offDelay("LD I0.0; TOF T33, +2");
  EXPECT_EQ(tick(offDelay, 33, on), (State{0, on}));
  EXPECT_EQ(tick(offDelay, 33, off), (State{0, on}));
  EXPECT_EQ(tick(offDelay, 33, off), (State{1, on}));
  EXPECT_EQ(tick(offDelay, 33, off), (State{2, off}));
  EXPECT_EQ(tick(offDelay, 33, off), (State{2, off}));
}

// ---- 1 ms: at any moment --------------------------------------------------------------------------------------

TEST(Timer1, BitMayChangeBetweenTwoInstructions) {
  Plant plant("LD SM0.0; TON T32, +2; LD T32; = Q0.0; LD T32; = Q0.1");
  plant.scan();
  EXPECT_EQ(of(plant, 32), (State{0, off}));
  plant.ms = {{0, 1}, {4, 1}};
  plant.scan();
  EXPECT_EQ(of(plant, 32), (State{2, on}));
  EXPECT_EQ(plant.value("QB0"), 0b10U) << "the second contact sees it";
}

TEST(Timer1, SeveralTicksInAScanAndKindsOfTimer) {
  Plant plant("LD I0.0; TON T32, +300; TONR T0, +300; TOF T96, +3");
  plant.set("I0.0=1").scan();
  plant.ms = {{0, 7}, {3, 2}};
  plant.scan();
  EXPECT_EQ(of(plant, 32), (State{9, off}));
  EXPECT_EQ(of(plant, 0), (State{9, off}));
  EXPECT_EQ(of(plant, 96), (State{0, on}));
  plant.ms = {};
  plant.set("I0.0=0").scan();
  EXPECT_EQ(of(plant, 32), (State{0, off}));
  EXPECT_EQ(of(plant, 0), (State{9, off}));
  plant.ms = {{0, 2}};
  plant.scan();
  EXPECT_EQ(of(plant, 96), (State{2, on}));
  EXPECT_EQ(of(plant, 0), (State{9, off}));
  plant.scan();
  EXPECT_EQ(of(plant, 96), (State{3, off}));
}

TEST(Timer1, TellsWhenThePresetIsReached) {
  // Events 21 and 22 (001:5476): once, in the update that reaches the preset.
  Plant plant("LD SM0.0; TON T32, +2");
  using Reached = std::vector<std::pair<std::uint32_t, bool>>;
  plant.scan();
  plant.ms = {{0, 1}};
  EXPECT_EQ(plant.scan().reached, (Reached{{32, false}}));
  EXPECT_EQ(plant.scan().reached, (Reached{{32, true}}));
  EXPECT_EQ(plant.scan().reached, (Reached{{32, false}}));
}

// ---- Self-resetting timers (001:6623; the table of three variants) ----------------------------------------------

TEST(SelfReset, WithTheTimersOwnBit) {
  // 100 ms: one scan, every time. 10 ms: never, because the instruction clears the bit that the scan start set.
  Plant hundred("LDN T37; TON T37, +3; LD T37; = Q0.0");
  std::string trace;
  for (int i = 0; i < 10; ++i) trace += hundred.scan(10, 1).value("Q0.0") != 0 ? '1' : '0';
  // Enabled in scan 0, ticks counted in scans 1, 2, 3; reset in scan 4, enabled again in scan 5.
  EXPECT_EQ(trace, "0001000010");
  Plant ten("LDN T33; TON T33, +3; LD T33; = Q0.0");
  for (int i = 0; i < 20; ++i) EXPECT_EQ(ten.scan(1, 0).value("Q0.0"), 0U) << i;
  // 1 ms: on only if the update falls between the two contacts.
  Plant one("LDN T32; TON T32, +3; LD T32; = Q0.0");
  one.scan();
  one.ms = {{0, 3}};
  EXPECT_EQ(one.scan().value("Q0.0"), 0U);
  Plant between("LDN T32; TON T32, +3; LD T32; = Q0.0");
  between.scan();
  between.ms = {{2, 3}};
  EXPECT_EQ(between.scan().value("Q0.0"), 1U);
}

TEST(SelfReset, WithTheOutputIsOneScanForEachResolution) {
  Plant hundred("LDN Q0.0; TON T37, +3; LD T37; = Q0.0");
  std::string trace;
  for (int i = 0; i < 10; ++i) trace += hundred.scan(10, 1).value("Q0.0") != 0 ? '1' : '0';
  EXPECT_EQ(trace, "0001000010");
  // 10 ms: enabled in scan 0, ticks at the starts of scans 1, 2, 3; reset in scan 4, enabled again in scan 5.
  Plant ten("LDN Q0.0; TON T33, +3; LD T33; = Q0.0");
  trace.clear();
  for (int i = 0; i < 10; ++i) trace += ten.scan(1, 0).value("Q0.0") != 0 ? '1' : '0';
  EXPECT_EQ(trace, "0001000010");
  Plant one("LDN Q0.0; TON T32, +3; LD T32; = Q0.0");
  one.ms = {{0, 1}};
  trace.clear();
  for (int i = 0; i < 10; ++i) trace += one.scan().value("Q0.0") != 0 ? '1' : '0';
  EXPECT_EQ(trace, "0001000010");
}

TEST(SelfReset, ProgramOfTheManual) {
  // 001:6625-6638: T33 with PT 100 and M0.0; Q0.0 from 40 ticks on. One tick per scan: enabled in scan 0, tick 40 at
  // the start of scan 40, tick 100 in scan 100 with M0.0; scan 101 clears, 102 enables, its tick 40 falls into scan
  // 142.
  Plant plant("LDN M0.0; TON T33, +100; LDW>= T33, +40; = Q0.0; LD T33; = M0.0");
  for (int scan = 0; scan <= 142; ++scan) {
    plant.scan(1, 0);
    const bool output = (scan >= 40 && scan <= 100) || scan >= 142;
    EXPECT_EQ(plant.value("Q0.0"), output ? 1U : 0U) << scan;
    EXPECT_EQ(plant.value("M0.0"), scan == 100 ? 1U : 0U) << scan;
  }
}

// ---- R and writing the current value ------------------------------------------------------------------------------

TEST(TimerReset, ClearsBitAndValueAndTheTimerStartsAnew) {
  Plant plant("LD SM0.0; TON T37, +2; TON T33, +2; LD I0.1; R T33, 5");
  plant.scan(2, 2);
  plant.scan(2, 2);
  EXPECT_EQ(of(plant, 37), (State{2, on}));
  EXPECT_EQ(of(plant, 33), (State{2, on}));
  plant.set("I0.1=1").scan(0, 0);
  EXPECT_EQ(of(plant, 37), (State{0, off}));
  EXPECT_EQ(of(plant, 33), (State{0, off}));
  plant.set("I0.1=0").scan(1, 1);
  EXPECT_EQ(of(plant, 37), (State{1, off}));
  EXPECT_EQ(of(plant, 33), (State{1, off})) << "it stayed enabled";
}

TEST(TimerValue, MayBeWritten) {
  Plant plant("LD SM0.0; TON T37, +10; LD I0.0; MOVW VW0, T37");
  plant.set("I0.0=1 VW0=9").scan(0, 1);
  EXPECT_EQ(of(plant, 37), (State{9, off}));
  plant.set("I0.0=0").scan(0, 1);
  EXPECT_EQ(of(plant, 37), (State{10, on}));
  plant.set("I0.0=1 VW0=-5").scan(0, 1);
  EXPECT_EQ(of(plant, 37), (State{-5, on})) << "the bit stays until the timer is reset";
  plant.set("I0.0=0").scan(0, 1);
  EXPECT_EQ(plant.current(37), -4);
}

TEST(TimerNumber, TheFirstBoxDecidesHowAMisusedNumberCounts) {
  // TON and TOF on one number is an error (001:6541); the refresh must not count twice.
  Plant plant("LD SM0.0; TON T33, +9; LDN SM0.0; TOF T34, +9; LD I0.0; TOF T33, +9");
  plant.set("I0.0=0 T.running[33]=1");
  plant.refresh(10, 2);
  EXPECT_EQ(plant.current(33), 2);
}

// ---- IEC boxes
// --------------------------------------------------------------------------------------------------------

TEST(IecTimer, OnDelayStopsAtThePreset) {
  Plant plant("LD I0.0; TON.IEC T37, +2, Q0.0, VW0");
  EXPECT_EQ(tick(plant, 37, on), (State{0, off}));
  EXPECT_EQ(tick(plant, 37, on), (State{1, off}));
  EXPECT_EQ(plant.value("VW0"), 1U);
  EXPECT_EQ(tick(plant, 37, on), (State{2, on}));
  EXPECT_EQ(tick(plant, 37, on), (State{2, on}));
  EXPECT_EQ(plant.value("Q0.0"), 1U);
  EXPECT_EQ(plant.value("VW0"), 2U);
  EXPECT_EQ(tick(plant, 37, off), (State{0, off}));
  EXPECT_EQ(plant.value("Q0.0"), 0U);
  EXPECT_EQ(plant.value("VW0"), 0U);
}

TEST(IecTimer, OffDelayKeepsTheTimeUntilTheInputRises) {
  Plant plant("LD I0.0; TOF.IEC T37, +2, Q0.0, VW0");
  EXPECT_EQ(tick(plant, 37, off), (State{0, off}));
  EXPECT_EQ(tick(plant, 37, on), (State{0, on}));
  EXPECT_EQ(tick(plant, 37, off), (State{0, on}));
  EXPECT_EQ(tick(plant, 37, off), (State{1, on}));
  EXPECT_EQ(plant.value("Q0.0"), 1U);
  EXPECT_EQ(tick(plant, 37, off), (State{2, off}));
  EXPECT_EQ(tick(plant, 37, off), (State{2, off}));
  EXPECT_EQ(plant.value("VW0"), 2U);
  EXPECT_EQ(plant.value("Q0.0"), 0U);
  EXPECT_EQ(tick(plant, 37, on), (State{0, on}));
}

TEST(IecTimer, PulseLastsThePresetWhateverTheInputDoes) {
  Plant plant("LD I0.0; TP.IEC T37, +3, Q0.0, VW0");
  EXPECT_EQ(tick(plant, 37, off), (State{0, off}));
  EXPECT_EQ(tick(plant, 37, on), (State{0, on}));
  EXPECT_EQ(tick(plant, 37, on), (State{1, on}));
  EXPECT_EQ(plant.value("Q0.0"), 1U);
  EXPECT_EQ(tick(plant, 37, off), (State{2, on}));
  EXPECT_EQ(tick(plant, 37, on), (State{3, off})) << "a second edge does not lengthen it";
  EXPECT_EQ(plant.value("Q0.0"), 0U);
  EXPECT_EQ(tick(plant, 37, on), (State{3, off})) << "the time stays while the input is on";
  EXPECT_EQ(plant.value("VW0"), 3U);
  EXPECT_EQ(tick(plant, 37, off), (State{0, off}));
  EXPECT_EQ(plant.value("VW0"), 0U);
  EXPECT_EQ(tick(plant, 37, on), (State{0, on}));
}

TEST(IecTimer, OtherResolutionsAndOpenPins) {
  Plant plant("LD I0.0; TP.IEC T33, +2; TON.IEC T32, +2");
  EXPECT_EQ(tick(plant, 33, on), (State{0, on}));
  EXPECT_EQ(tick(plant, 33, on), (State{1, on}));
  EXPECT_EQ(tick(plant, 33, on), (State{2, off}));
  EXPECT_EQ(tick(plant, 33, on), (State{2, off}));
  plant.ms = {{0, 5}};
  plant.scan();
  EXPECT_EQ(of(plant, 32), (State{2, on}));
}

// ---- Interval time
// ---------------------------------------------------------------------------------------------------

TEST(Interval, DifferenceOfTheFreeRunningCounter) {
  Plant plant("LD I0.0; BITIM VD0; LD I0.1; CITIM VD0, VD4");
  plant.outside.values[{External::IntervalClock, 0}] = 0xFFFFFF00;
  plant.set("I0.0=1").scan();
  EXPECT_EQ(plant.value("VD0"), 0xFFFFFF00U);
  EXPECT_EQ(plant.value("VD4"), 0U);
  plant.outside.values[{External::IntervalClock, 0}] = 0x100;
  plant.set("I0.0=0 I0.1=1").scan();
  EXPECT_EQ(plant.value("VD0"), 0xFFFFFF00U);
  EXPECT_EQ(plant.value("VD4"), 0x200U) << "one wrap of the counter is taken into account";
  check({
      {"BITIM AC0", "AC0=5", "AC0=0"},
      {"CITIM 16#10, VD4", "", "VD4=16#FFFFFFF0"},
      {"LDN SM0.0; CITIM VD0, VD4", "VD0=7 VD4=7", ""},
  });
}

}  // namespace rungproof::manual
