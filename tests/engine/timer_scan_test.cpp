// Timers through whole scans: when ticks reach them, short first intervals, the self-resetting timer (001:6605-6638).
#include "tests/engine/rig.hpp"

namespace rungproof {
namespace {

// 100 ms timer, preset 3, 10 ms scans. Ticks are 100, 200, 300 ms after the start; the one at 300 ms is taken by the
// scan that begins then, which is scan 31.
TEST(TimerScan, HundredMillisecondTimerCountsWhenExecuted) {
  Rig rig("LD I0.0\nTON T37, +3\nLD T37\n= Q0.0\n");
  rig.set("I0.0", 1);
  rig.scans(30);
  EXPECT_EQ(rig.get("T37.value"), 2);
  EXPECT_EQ(rig.get("Q0.0"), 0);
  rig.scans(1);
  EXPECT_EQ(rig.get("T37.value"), 3);
  EXPECT_EQ(rig.get("Q0.0"), 1);
}

TEST(TimerScan, TenMillisecondTimerCountsAtTheStartOfTheScan) {
  Rig rig("LD T33\n= Q0.0\nLD I0.0\nTON T33, +2\nLD T33\n= Q0.1\n");
  rig.set("I0.0", 1);
  rig.scans(2);
  EXPECT_EQ(rig.get("QB0"), 0);
  rig.scans(1);  // 20 ms have passed: both contacts see the bit, before and behind the timer
  EXPECT_EQ(rig.get("QB0"), 3);
}

// The program takes far less than 1 ms, so all ticks of a scan come after it.
TEST(TimerScan, OneMillisecondTimerCountsInTheRestOfTheScan) {
  Rig rig("LD I0.0\nTON T32, +25\nLD T32\n= Q0.0\n");
  rig.set("I0.0", 1);
  rig.scans(3);
  EXPECT_EQ(rig.get("T32.value"), 30);
  EXPECT_EQ(rig.get("T32"), 1);
  EXPECT_EQ(rig.get("Q0.0"), 0);  // was executed before
  rig.scans(1);
  EXPECT_EQ(rig.get("Q0.0"), 1);
}

// A loop of some 35 ms between two contacts: the bit changes in the middle of the scan (001:6607).
TEST(TimerScan, OneMillisecondTimerChangesInsideALongScan) {
  const std::string loop = "LD SM0.0\nFOR VW0, +1, +1000\nLD SM0.0\nINCW VW2\nNEXT\n";
  Rig rig("LD SM0.0\nTON T32, +5\nLD T32\n= Q0.0\n" + loop + "LD T32\n= Q0.1\n");
  rig.scans(1);
  EXPECT_EQ(rig.get("QB0"), 2);
}

TEST(TimerScan, TenMillisecondTimerStandsStillInsideALongScan) {
  const std::string loop = "LD SM0.0\nFOR VW0, +1, +1000\nLD SM0.0\nINCW VW2\nNEXT\n";
  Rig rig("LD SM0.0\nTON T33, +1\n" + loop + "LD T33\n= Q0.1\n");
  rig.scans(1);
  EXPECT_GT(rig.simulator->lastScanUs(), 10000U);
  EXPECT_EQ(rig.get("Q0.1"), 0);
  rig.scans(1);
  EXPECT_EQ(rig.get("Q0.1"), 1);
}

// 300 ms by its own bit: columns of the public table "automatically retriggered one-shot" for the three resolutions.
struct SelfReset {
  std::string timer;
  std::string preset;
  bool byOutput;       ///< enabled by the inverted output instead of the inverted timer bit
  int pulsesExpected;  ///< one-scan pulses of Q0.0 in 100 scans of 10 ms

  friend std::ostream& operator<<(std::ostream& out, const SelfReset& row) {
    return out << row.timer << (row.byOutput ? " by output" : " by bit");
  }
};

class SelfResettingTimer : public testing::TestWithParam<SelfReset> {};

TEST_P(SelfResettingTimer, GivesOneScanPulsesOrNone) {
  const SelfReset& p = GetParam();
  const std::string enable = p.byOutput ? "LDN Q0.0\n" : "LDN " + p.timer + "\n";
  Rig rig(enable + "TON " + p.timer + ", " + p.preset + "\nLD " + p.timer + "\n= Q0.0\n");
  const std::string wave = rig.wave("Q0.0", 100);
  int pulses = 0;
  for (std::size_t i = 0; i < wave.size(); ++i) {
    if (wave[i] != '1') continue;
    ++pulses;
    EXPECT_FALSE(i > 0 && wave[i - 1] == '1') << "on for more than one scan: " << wave;
  }
  EXPECT_EQ(pulses, p.pulsesExpected) << wave;
}

// 10 ms by its own bit: the TON sees the bit that the scan start set, and clears it: never on. 1 ms by its own bit: on
// only if the tick falls between the two contacts, which it does not in a short program. 100 ms: on for one scan at
// each time-out; by the table 30 scans for the first 300 ms (ticks at the starts of scans 11, 21, 31). By the output
// all three pulse. 1 ms: the bit comes at 300 ms, after the program of scan 30; scan 31 shows it, scan 32 resets,
// timing starts in scan 33 (at 320 ms): again in scans 64 (pulse at scan 31 + 33) and 97. 10 ms: running from scan 1,
// bit at the start of scan 31; reset in 32, started in 33, bit at the start of scan 63, then 95. 100 ms by its bit:
// scan 31; reset by the TON of scan 32, started in 33 (320 ms), ticks at 400, 500, 600: scan 61; then started in 63,
// ticks at 700, 800, 900: scan 91. By the output likewise: the output is 1 in scan 31, so the TON of 32 resets, the TON
// of 33 starts.
INSTANTIATE_TEST_SUITE_P(Table, SelfResettingTimer,
                         testing::Values(SelfReset{"T32", "+300", false, 0}, SelfReset{"T33", "+30", false, 0},
                                         SelfReset{"T37", "+3", false, 3}, SelfReset{"T32", "+300", true, 3},
                                         SelfReset{"T33", "+30", true, 3}, SelfReset{"T37", "+3", true, 3}));

// The seed's example with T33 and M0.0 (001:6623-6638), written anew: M0.0 is a one-scan pulse, VW0 counts them.
TEST(TimerScan, PeriodOfTheExampleIsOneSecondAndTwoScans) {
  Rig rig("LDN M0.0\nTON T33, +100\nLDW>= T33, +40\n= Q0.0\nLD T33\n= M0.0\n");
  rig.scans(100);
  EXPECT_EQ(rig.get("M0.0"), 0);
  rig.scans(1);  // current value 100 at 1000 ms, start of scan 101
  EXPECT_EQ(rig.get("M0.0"), 1);
  rig.scans(1);
  EXPECT_EQ(rig.get("M0.0"), 0);
  EXPECT_EQ(rig.get("T33.value"), 0);
  rig.scans(100);  // started in scan 103 (1020 ms), 100 ticks until the start of scan 203 (2020 ms)
  EXPECT_EQ(rig.get("M0.0"), 0);
  rig.scans(1);
  EXPECT_EQ(rig.get("M0.0"), 1);
}

TEST(TimerScan, OffDelayRunsFromTheFallingEdge) {
  Rig rig("LD I0.0\nTOF T33, +3\nLD T33\n= Q0.0\n");
  EXPECT_EQ(rig.wave("Q0.0", 3), "000");  // does not time at power-up
  rig.set("I0.0", 1);
  EXPECT_EQ(rig.wave("Q0.0", 3), "111");
  rig.set("I0.0", 0);
  EXPECT_EQ(rig.wave("Q0.0", 5), "11100");  // runs from scan 7 on; ticks at the starts of scans 8, 9, 10
  EXPECT_EQ(rig.get("T33.value"), 3);
}

TEST(TimerScan, RetentiveTimerKeepsItsValueWithoutInput) {
  Rig rig("LD I0.0\nTONR T1, +5\nLD I0.1\nR T1, 1\nLD T1\n= Q0.0\n");
  rig.set("I0.0", 1);
  rig.scans(4);
  rig.set("I0.0", 0);
  rig.scans(10);
  EXPECT_EQ(rig.get("T1.value"), 4);  // three ticks in scans 2 to 4, one at the start of scan 5
  rig.set("I0.0", 1);
  rig.scans(2);  // enabled in the first, counts at the start of the second
  EXPECT_EQ(rig.get("Q0.0"), 1);
  rig.set("I0.1", 1);
  rig.scans(1);
  EXPECT_EQ(rig.get("T1.value"), 0);
}

TEST(TimerScan, JumpedOverHundredMillisecondTimerLosesTime) {
  Rig rig("LD I0.0\nJMP 1\nLD SM0.0\nTON T37, +100\nLBL 1\n");
  rig.scans(11, 100000);  // ten ticks
  EXPECT_EQ(rig.get("T37.value"), 10);
  rig.set("I0.0", 1);
  rig.scans(5, 100000);
  rig.set("I0.0", 0);
  rig.scans(1, 100000);
  EXPECT_EQ(rig.get("T37.value"), 11);  // only the tick of the scan before
}

TEST(TimerScan, IntervalTimeCountsMilliseconds) {
  Rig rig("LD I0.0\nEU\nBITIM VD0\nLD SM0.0\nCITIM VD0, VD4\n");
  rig.scans(1);
  rig.set("I0.0", 1);
  rig.scans(6, 7000);
  EXPECT_EQ(rig.get("VD4"), 35);  // five scans of 7 ms after the one that took the start
}

}  // namespace
}  // namespace rungproof
