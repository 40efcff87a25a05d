// Moments of the scan cycle: status bits, clocks, images, scan times (001:1205-1254, 001:14045-14056).
#include "tests/engine/rig.hpp"

namespace rungproof {
namespace {

TEST(ScanCycle, FirstScanBitsAreSeenByTheFirstScanOnly) {
  Rig rig("LD SM0.1\n= Q0.0\nLD SM0.3\n= Q0.1\nLD SM0.0\n= Q0.2\nLD SM0.2\n= Q0.3\n");
  rig.scans(1);
  EXPECT_EQ(rig.get("QB0"), 0b0111);
  rig.scans(1);
  EXPECT_EQ(rig.get("QB0"), 0b0100);
}

TEST(ScanCycle, LostDataShowsForOneScan) {
  SimulatorOptions options;
  options.dataLost = true;
  Rig rig("LD SM0.2\n= Q0.0\n", options);
  EXPECT_EQ(rig.wave("Q0.0", 3), "100");
}

TEST(ScanCycle, InputsAreReadOnceAtTheStart) {
  Rig rig("LD I0.0\n= Q0.0\nLDI I0.0\n= Q0.1\n");
  rig.set("I0.0", 1);
  EXPECT_EQ(rig.get("I0.0"), 0);  // the image follows with the next scan
  rig.scans(1);
  EXPECT_EQ(rig.get("I0.0"), 1);
  EXPECT_EQ(rig.get("QB0"), 3);
}

TEST(ScanCycle, InputWithoutHardwareReturnsToZero) {
  Rig rig("LD SM0.1\n= I5.0\nLD I5.0\n= Q0.0\n");
  EXPECT_EQ(rig.wave("Q0.0", 2), "10");  // the program may write the image; the next refresh takes it back (001:1225)
}

TEST(ScanCycle, OutputsReachTheTerminalsAtTheEnd) {
  Rig rig("LD SM0.0\n= Q0.0\n");
  EXPECT_FALSE(rig.simulator->physicalOutput(0, 0));
  rig.scans(1);
  EXPECT_TRUE(rig.simulator->physicalOutput(0, 0));
}

// Half a second off, half a second on (choice scan-clock-start); refreshed at the scan end only. With 100 ms scans the
// end of scan 5 lies at 500 ms, so scan 6 is the first that sees 1, and scan 11 the first that sees 0 again.
TEST(ScanCycle, OneSecondClock) {
  Rig rig("LD SM0.5\n= Q0.0\n");
  EXPECT_EQ(rig.wave("Q0.0", 21, 100000), "000001111100000111110");
}

TEST(ScanCycle, OneSecondClockMayStartOn) {
  SimulatorOptions options;
  ASSERT_TRUE(options.choices.set("scan-clock-start", "on"));
  Rig rig("LD SM0.5\n= Q0.0\n", options);
  EXPECT_EQ(rig.wave("Q0.0", 11, 100000), "11111000001");
}

TEST(ScanCycle, OneMinuteClock) {
  Rig rig("LD SM0.4\n= Q0.0\n");
  rig.scans(75, 400000);  // 30 s
  EXPECT_EQ(rig.get("Q0.0"), 0);
  rig.scans(1, 400000);
  EXPECT_EQ(rig.get("Q0.0"), 1);
  rig.scans(75, 400000);
  EXPECT_EQ(rig.get("Q0.0"), 0);
}

TEST(ScanCycle, ScanClockTogglesEveryScan) {
  Rig rig("LD SM0.6\n= Q0.0\n");
  EXPECT_EQ(rig.wave("Q0.0", 5), "01010");
}

TEST(ScanCycle, ScanTimesAreInMilliseconds) {
  Rig rig("LD SM0.0\nMOVW SMW22, VW0\n");
  rig.scans(1, 12000);
  rig.scans(1, 5000);
  rig.scans(1, 20000);
  EXPECT_EQ(rig.get("SMW22"), 20);
  EXPECT_EQ(rig.get("SMW24"), 5);
  EXPECT_EQ(rig.get("SMW26"), 20);
  EXPECT_EQ(rig.get("VW0"), 5);  // the last scan read what the scan before had left
}

TEST(ScanCycle, ScansMayBeShorterThanAMillisecond) {
  Rig rig("LD SM0.0\nTON T33, +1\n");
  rig.scans(20, 500);  // 10 ms: the tick is taken at the start of scan 21
  EXPECT_EQ(rig.get("T33.value"), 0);
  rig.scans(1, 500);
  EXPECT_EQ(rig.get("T33.value"), 1);
  EXPECT_EQ(rig.simulator->timeUs(), 10500U);
}

TEST(ScanCycle, MoreInstructionsThanTheAskedLengthMakeTheScanLonger) {
  // FOR 3500, NEXT 1 us, body INCW 29 us or so: 1000 rounds last more than 1 ms and less than 100 ms.
  Rig rig("LD SM0.0\nFOR VW0, +1, +1000\nLD SM0.0\nINCW VW2\nNEXT\n");
  rig.scans(1, 1000);
  EXPECT_EQ(rig.get("VW2"), 1000);
  EXPECT_GT(rig.simulator->lastScanUs(), 10000U);
  EXPECT_LT(rig.simulator->lastScanUs(), 100000U);
}

TEST(ScanCycle, AnalogValuesAreRead) {
  Rig rig("LD SM0.0\nMOVW AIW0, VW0\nMOVW VW0, AQW2\n");
  rig.set("AIW0", -1600);
  rig.scans(1);
  EXPECT_EQ(rig.get("VW0"), -1600);
  EXPECT_EQ(rig.get("AQW2"), -1600);
}

}  // namespace
}  // namespace rungproof
