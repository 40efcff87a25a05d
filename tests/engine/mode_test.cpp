// Modes and start-up: STOP and RUN, power cycles and what is retained, the data block, watchdog and fatal errors,
// forced values (001:1603-1690, 001:2337-2364, 001:5691-5722, 001:7954-7976).
#include "ir/s7200/cpu.hpp"
#include "tests/engine/rig.hpp"

namespace rungproof {
namespace {

TEST(Mode, StopInTheMainProgramEndsItAtOnce) {
  Rig rig("LD SM0.0\n= Q0.0\nLD I0.0\nSTOP\nLD SM0.0\n= Q0.1\n");
  rig.scans(1);
  EXPECT_TRUE(rig.simulator->physicalOutput(0, 1));
  rig.set("I0.0", 1);
  rig.scans(1);
  EXPECT_FALSE(rig.simulator->isRunning());
  EXPECT_FALSE(rig.simulator->physicalOutput(0, 0));  // output table: all 0 (001:1749)
  EXPECT_EQ(rig.get("Q0.1"), 1);                      // the image keeps what the scan before had written
  EXPECT_EQ(rig.simulator->stoppedBy()->desc->stl, "STOP");
}

TEST(Mode, StopMayLetTheScanEnd) {
  SimulatorOptions options;
  ASSERT_TRUE(options.choices.set("stop-in-main", "end-of-scan"));
  Rig rig("LD SM0.0\nSTOP\nINCW VW0\n", options);
  rig.scans(2);
  EXPECT_EQ(rig.get("VW0"), 1);
  EXPECT_FALSE(rig.simulator->isRunning());
}

TEST(Mode, RunAgainStartsWithTheFirstScanBit) {
  Rig rig("LD SM0.1\nINCW VW0\nLD SM0.3\nINCW VW2\nLD I0.0\nTON T33, +1\nLD SM0.0\nENI\n");
  rig.set("I0.0", 1);
  rig.scans(5);
  EXPECT_EQ(rig.get("T33"), 1);
  rig.simulator->stop();
  rig.scans(2);
  EXPECT_EQ(rig.get("VW0"), 1);
  rig.simulator->run();
  EXPECT_EQ(rig.get("T33"), 0);
  EXPECT_EQ(rig.get("T33.value"), 0);
  EXPECT_EQ(rig.get("SM4.4"), 0);  // interrupts are disabled (001:5333)
  rig.scans(2);
  EXPECT_EQ(rig.get("VW0"), 2);
  EXPECT_EQ(rig.get("VW2"), 1);  // SM0.3 only after power-up
}

TEST(Mode, TimersStandStillInStop) {
  Rig rig("LD I0.0\nSTOP\nLD SM0.0\nTON T33, +500\nTON T32, +500\n");
  rig.scans(5);
  rig.set("I0.0", 1);
  rig.scans(1);
  ASSERT_FALSE(rig.simulator->isRunning());
  const std::int64_t ten = rig.get("T33.value"), one = rig.get("T32.value");
  rig.set("I0.1", 1);
  rig.scans(10);
  EXPECT_EQ(rig.get("T33.value"), ten);
  EXPECT_EQ(rig.get("T32.value"), one);
  EXPECT_EQ(rig.get("I0.1"), 1);  // inputs are read in STOP too
  EXPECT_EQ(rig.simulator->timeUs(), 160000U);
}

TEST(StartUp, NoEdgeInTheFirstScan) {
  Rig rig("LD I0.0\nEU\nINCW VW0\n");
  rig.set("I0.0", 1);
  rig.scans(2);
  EXPECT_EQ(rig.get("VW0"), 0);
}

TEST(StartUp, RetentiveCellsSurviveThePowerCycle) {
  SimulatorOptions options;
  options.retentive = {{Area::V, 0, 9}, {Area::M, 14, 31}, {Area::T, 0, 31}, {Area::C, 0, 9}};
  Rig rig(
      "LD SM0.1\nMOVW 5, VW0\nMOVW 6, VW10\nMOVB 7, MB0\nMOVB 8, MB20\n"
      "LD I0.0\nTONR T1, +2\nLD I0.0\nTON T33, +2\nLD I0.0\nLD SM0.2\nCTU C1, +1\nLD I0.0\nLD SM0.2\nCTU C10, +1\n",
      options);
  rig.scans(1);
  rig.set("I0.0", 1);
  rig.scans(4);
  ASSERT_EQ(rig.get("T1"), 1);
  ASSERT_EQ(rig.get("C1"), 1);
  rig.simulator->powerCycle();
  EXPECT_EQ(rig.get("VW0"), 5);
  EXPECT_EQ(rig.get("VW10"), 0);
  EXPECT_EQ(rig.get("MB0"), 0);
  EXPECT_EQ(rig.get("MB20"), 8);
  EXPECT_EQ(rig.get("T1.value"), 3);
  EXPECT_EQ(rig.get("T33.value"), 0);  // only TONR can be retentive (001:6556)
  EXPECT_EQ(rig.get("C1.value"), 1);
  EXPECT_EQ(rig.get("C10.value"), 0);
  EXPECT_EQ(rig.get("T1"), 0);  // bits never are (001:6552)
  EXPECT_EQ(rig.get("C1"), 0);
}

TEST(StartUp, DataBlockFillsWhatIsNotRetentive) {
  Rig rig("LD SM0.0\nINCW VW0\nINCW VW10\n");
  rig.program.data = {{0, {0x00, 0x64}, {}}, {10, {0x00, 0xC8}, {}}};
  SimulatorOptions options;
  options.retentive = {{Area::V, 10, 11}};
  Simulator simulator(rig.program, options);
  const auto word = [&](std::uint32_t offset) { return simulator.read(direct(Area::V, Width::Word, offset)); };
  EXPECT_EQ(word(0), 100U);
  simulator.scan();
  simulator.scan();
  EXPECT_EQ(word(10), 202U);
  simulator.powerCycle();
  EXPECT_EQ(word(0), 100U);   // reloaded (001:1624)
  EXPECT_EQ(word(10), 202U);  // retained
}

TEST(Watchdog, EndlessLoopIsFatalErrorThree) {
  Rig rig("LD SM0.0\n= Q0.0\nLBL 1\nLD SM0.0\nJMP 1\n");
  rig.scans(1);
  ASSERT_NE(rig.simulator->errors().fatal(), nullptr);
  EXPECT_EQ(rig.simulator->errors().fatal()->hazard, Hazard::FatalWatchdog);
  EXPECT_EQ(rig.simulator->errors().fatal()->scan, 1U);
  EXPECT_FALSE(rig.simulator->isRunning());
  EXPECT_FALSE(rig.simulator->physicalOutput(0, 0));  // outputs off (001:2358)
  EXPECT_GE(rig.simulator->lastScanUs(), 500000U);
  EXPECT_LE(rig.simulator->lastScanUs(), 502000U);
}

TEST(Watchdog, LimitIsAChoice) {
  SimulatorOptions options;
  ASSERT_TRUE(options.choices.set("watchdog", "300ms"));
  Rig rig("LBL 1\nLD SM0.0\nJMP 1\n", options);
  rig.scans(1);
  EXPECT_GE(rig.simulator->lastScanUs(), 300000U);
  EXPECT_LE(rig.simulator->lastScanUs(), 302000U);
}

// 30000 rounds of some 30 us are about 0.9 s; with WDR in every round the watchdog never expires (001:5699).
TEST(Watchdog, RestartKeepsALongScanAlive) {
  const std::string loop = "LD SM0.0\nFOR VW0, +1, +30000\nLD SM0.0\nINCW VW2\n";
  Rig without(loop + "NEXT\n");
  without.scans(1);
  EXPECT_NE(without.simulator->errors().fatal(), nullptr);
  Rig with(loop + "WDR\nNEXT\n");
  with.scans(1);
  EXPECT_EQ(with.simulator->errors().fatal(), nullptr);
  EXPECT_EQ(with.get("VW2"), 30000);
  EXPECT_EQ(with.get("SMW22"), static_cast<std::int64_t>(with.simulator->lastScanUs() / 1000));
}

// Restarts end: at 5 s on an S7-200 SMART whatever WDR does; no manual of the S7-200 states a limit, 25 s is ours.
TEST(Watchdog, RestartsOfAnEndlessLoopEnd) {
  const auto lengthOf = [](const std::string& text, Target target) {
    Rig rig(text, {}, target);
    rig.scans(1);
    EXPECT_NE(rig.simulator->errors().fatal(), nullptr) << text;
    EXPECT_FALSE(rig.simulator->isRunning());
    return rig.simulator->lastScanUs();
  };
  const Cpu smart = *cpuNamed("ST40");
  const std::string byJump = "LBL 1\nLD SM0.0\nWDR\nINCW VW0\nLDN M0.0\nJMP 1\n";
  const std::string byRoutine =
      "LBL 1\nLD SM0.0\nCALL SBR0\nLDN M0.0\nJMP 1\nEND_ORGANIZATION_BLOCK\n"
      "SUBROUTINE_BLOCK SBR0:SBR0\nBEGIN\nNETWORK 1\nLD SM0.0\nWDR\n"
      "END_SUBROUTINE_BLOCK\n";
  for (const auto& [target, us] :
       {std::pair{Target(smart, usualEdition(smart)), 5'000'000U}, {Target(), 25'000'000U}}) {
    EXPECT_GE(lengthOf(byJump, target), us);
    EXPECT_LE(lengthOf(byJump, target), us + 2000);
  }
  const std::string whole = "ORGANIZATION_BLOCK MAIN:OB1\nBEGIN\nNETWORK 1\n" + byRoutine;
  EXPECT_LE(lengthOf(whole, Target(smart, usualEdition(smart))), 5'002'000U);
}

TEST(RunTimeError, BadPointerIsReportedOnceWithItsPlace) {
  Rig rig("LD SM0.0\nMOVD 16#FF000000, VD0\nMOVB *VD0, VB10\n");
  rig.scans(3);
  ASSERT_EQ(rig.simulator->errors().list().size(), 1U);
  const RunTimeError& error = rig.simulator->errors().list()[0];
  EXPECT_EQ(error.hazard, Hazard::BadIndirectAddress);
  EXPECT_EQ(error.place->desc->stl, "MOVB");
  EXPECT_EQ(error.scan, 1U);
  EXPECT_EQ(error.count, 3U);
  EXPECT_EQ(rig.get("SM4.3"), 1);
  EXPECT_TRUE(rig.simulator->isRunning());
}

TEST(RunTimeError, BadPointerInACompareContactIsFatal) {
  Rig rig("LD SM0.0\nMOVD 16#FF000000, VD0\nLDB= *VD0, VB10\n= Q0.0\nLD SM0.0\n= Q0.1\n");
  rig.scans(1);
  ASSERT_NE(rig.simulator->errors().fatal(), nullptr);
  EXPECT_EQ(rig.simulator->errors().fatal()->hazard, Hazard::FatalIndirectAddress);
  EXPECT_EQ(rig.get("Q0.1"), 0);
  EXPECT_FALSE(rig.simulator->isRunning());
}

TEST(Force, InputsImmediateContactsAndOutputs) {
  Rig rig("LD I0.0\n= Q0.0\nLDI I0.0\n= Q0.1\nLD SM0.0\n= Q0.2\nLD SM4.7\n= Q0.3\n");
  EXPECT_TRUE(rig.simulator->force(operandNamed("I0.0"), 1));
  EXPECT_TRUE(rig.simulator->force(operandNamed("Q0.2"), 0));
  rig.scans(2);
  EXPECT_EQ(rig.get("QB0"), 0b1011);
  EXPECT_FALSE(rig.simulator->physicalOutput(0, 2));
  rig.simulator->unforce(operandNamed("I0.0"));
  rig.simulator->unforce(operandNamed("Q0.2"));
  rig.scans(2);
  EXPECT_EQ(rig.get("QB0"), 0b0100);
}

TEST(Force, MemoryIsForcedBehindTheProgram) {
  Rig rig("LD SM0.0\nINCW VW0\nMOVW VW0, VW2\n");
  EXPECT_TRUE(rig.simulator->force(operandNamed("VW0"), 100));
  rig.scans(3);
  EXPECT_EQ(rig.get("VW0"), 100);
  EXPECT_EQ(rig.get("VW2"), 101);
}

TEST(Force, AtMostSixteenMemoryValues) {
  Rig rig("LD SM0.0\n= Q0.0\n");
  for (int i = 0; i < 16; ++i) EXPECT_TRUE(rig.simulator->force(operandNamed("VW" + std::to_string(i * 2)), 1));
  EXPECT_FALSE(rig.simulator->force(operandNamed("VW100"), 1));
  EXPECT_TRUE(rig.simulator->force(operandNamed("I5.0"), 1));
  EXPECT_FALSE(rig.simulator->force(operandNamed("T37"), 1));
}

}  // namespace
}  // namespace rungproof
