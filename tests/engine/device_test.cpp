// Devices: high-speed counters, pulse trains, ports, network requests (001:4121-4782, 001:3022-3342).
#include "tests/engine/rig.hpp"

namespace rungproof {
namespace {

// Counter 0 in mode 0: control byte F8 = enable, load current value and preset, direction up; event 12 on equality.
const std::string upCounter =
    "LD SM0.1\nMOVB 16#F8, SMB37\nMOVD 0, SMD38\nMOVD 1000, SMD42\nHDEF 0, 0\nATCH 0, 12\nENI\nHSC 0\nMEND\n";

TEST(HighSpeedCounter, CountsThePulsesOfTheScan) {
  Rig rig(upCounter + "INT 0\nRETI\n");
  rig.scans(1);
  rig.simulator->devices().counters.setPulses(0, 37, 0);
  rig.scans(10);
  EXPECT_EQ(rig.get("HC0"), 370);
}

// Presets 1000, 1500, then back to 0 with the routine changed each time: the outputs follow the number of pulses, and
// no pulse is lost between a match and the loading of the next preset.
TEST(HighSpeedCounter, RoutineLoadsTheNextPresetBetweenTwoPulses) {
  Rig rig(upCounter +
          "INT 0\nS Q0.1, 1\nMOVD 1500, SMD42\nMOVB 16#A0, SMB37\nHSC 0\nATCH 1, 12\nRETI\n"
          "INT 1\nS Q0.2, 1\nMOVD 2000, SMD42\nMOVB 16#A0, SMB37\nHSC 0\nATCH 2, 12\nRETI\n"
          "INT 2\nR Q0.1, 2\nMOVD 0, SMD38\nMOVD 1000, SMD42\nMOVB 16#E0, SMB37\nHSC 0\nATCH 0, 12\nRETI\n");
  rig.scans(1);
  rig.simulator->devices().counters.setPulses(0, 300, 0);
  const auto outputs = [&] { return rig.get("QB0"); };
  rig.scans(3);
  EXPECT_EQ(outputs(), 0);  // 900
  rig.scans(1);
  EXPECT_EQ(outputs(), 0b010);  // 1200
  rig.scans(1);
  EXPECT_EQ(outputs(), 0b110);  // 1500 exactly
  rig.scans(2);
  EXPECT_EQ(outputs(), 0);  // 2100: started again at 2000
  EXPECT_EQ(rig.get("HC0"), 100);
  rig.scans(3);
  EXPECT_EQ(outputs(), 0b010);  // 1000
}

TEST(HighSpeedCounter, EdgesOfItsInputCountToo) {
  Rig rig(upCounter + "INT 0\nRETI\n");
  rig.scans(1);
  for (const int level : {1, 1, 0, 1, 0}) {
    rig.set("I0.0", level);
    rig.scans(1);
  }
  EXPECT_EQ(rig.get("HC0"), 2);
}

TEST(HighSpeedCounter, DirectionInputAndItsEvent) {
  Rig rig(
      "LD SM0.1\nMOVB 16#F8, SMB37\nMOVD 0, SMD38\nMOVD 5, SMD42\nHDEF 0, 3\nATCH 0, 27\nENI\nHSC 0\nMEND\nINT 0\nINCW "
      "VW0\nRETI\n");
  rig.set("I0.1", 1);
  rig.scans(1);
  rig.simulator->devices().counters.setPulses(0, 4, 0);
  rig.scans(2);
  EXPECT_EQ(rig.get("HC0"), 8);
  rig.set("I0.1", 0);
  rig.scans(3);
  EXPECT_EQ(rig.get("HC0"), -4);
  EXPECT_EQ(rig.get("VW0"), 1);
}

TEST(HighSpeedCounter, ResetInputHoldsAtZeroAndRaisesItsEvent) {
  Rig rig(
      "LD SM0.1\nMOVB 16#F8, SMB37\nMOVD 50, SMD38\nMOVD 5, SMD42\nHDEF 0, 1\nATCH 0, 28\nENI\nHSC 0\nMEND\nINT "
      "0\nINCW VW0\nRETI\n");
  rig.scans(1);
  rig.simulator->devices().counters.setPulses(0, 10, 0);
  rig.scans(1);
  EXPECT_EQ(rig.get("HC0"), 60);
  rig.set("I0.2", 1);
  rig.scans(3);
  EXPECT_EQ(rig.get("HC0"), 0);
  EXPECT_EQ(rig.get("VW0"), 1);
  rig.set("I0.2", 0);
  rig.scans(1);
  EXPECT_EQ(rig.get("HC0"), 10);
}

TEST(HighSpeedCounter, TwoClocksAndQuadrature) {
  Rig clocks("LD SM0.1\nMOVB 16#F8, SMB47\nMOVD 0, SMD48\nMOVD 500, SMD52\nHDEF 1, 6\nHSC 1\n");
  clocks.scans(1);
  clocks.simulator->devices().counters.setPulses(1, 7, 3);
  clocks.scans(5);
  EXPECT_EQ(clocks.get("HC1"), 20);
  for (const auto& [control, counts] : {std::pair{"16#F8", 40}, std::pair{"16#FC", 10}}) {  // 4x and 1x (001:14229)
    Rig quadrature(std::string("LD SM0.1\nMOVB ") + control +
                   ", SMB57\nMOVD 0, SMD58\nMOVD 500, SMD62\nHDEF 2, 9\nHSC 2\n");
    quadrature.scans(1);
    quadrature.simulator->devices().counters.setPulses(2, 10, 0);
    quadrature.scans(1);
    EXPECT_EQ(quadrature.get("HC2"), counts) << control;
  }
}

// 200 pulses of 500 us are 100 ms; SM66.7 shows the idle output, event 19 the end (001:4645).
TEST(PulseTrain, EndsAfterCountTimesCycle) {
  Rig rig(
      "LD SM0.1\nMOVB 16#85, SMB67\nMOVW 500, SMW68\nMOVD 200, SMD72\nATCH 0, 19\nENI\nPLS 0\nMEND\nINT 0\nINCW "
      "VW0\nRETI\n");
  rig.scans(1);
  EXPECT_EQ(rig.get("SM66.7"), 0);
  rig.scans(8);
  EXPECT_EQ(rig.get("VW0"), 0);
  rig.scans(2);
  EXPECT_EQ(rig.get("VW0"), 1);
  EXPECT_EQ(rig.get("SM66.7"), 1);
}

TEST(PulseTrain, TheNextTrainWaitsInThePipeline) {
  Rig rig(
      "LD SM0.1\nMOVB 16#8D, SMB67\nMOVW 5, SMW68\nMOVD 4, SMD72\nATCH 0, 19\nENI\nPLS 0\nMOVD 8, SMD72\nPLS 0\nPLS "
      "0\nMEND\nINT 0\nINCW VW0\nRETI\n");
  rig.scans(1);
  EXPECT_EQ(rig.get("SM66.6"), 1);  // a third one finds the pipeline full
  rig.scans(2);
  EXPECT_EQ(rig.get("VW0"), 1);  // 20 ms
  EXPECT_EQ(rig.get("SM66.7"), 0);
  rig.scans(4);
  EXPECT_EQ(rig.get("VW0"), 2);  // and 40 ms more
  EXPECT_EQ(rig.get("SM66.7"), 1);
}

// Profile of two segments, 1 ms base: 4 pulses 10, 8, 6, 4 ms (28 ms), then 5 of 4 ms (20 ms).
TEST(PulseTrain, ProfileOfSegments) {
  Rig rig(
      "LD SM0.1\nMOVB 2, VB100\nMOVW 10, VW101\nMOVW -2, VW103\nMOVD 4, VD105\nMOVW 4, VW109\nMOVW 0, VW111\nMOVD 5, "
      "VD113\n"
      "MOVW 100, SMW168\nMOVB 16#A8, SMB67\nATCH 0, 19\nENI\nPLS 0\nMEND\nINT 0\nINCW VW0\nRETI\n");
  rig.scans(2);
  EXPECT_EQ(rig.get("SMB166"), 1);
  rig.scans(2);
  EXPECT_EQ(rig.get("SMB166"), 2);
  EXPECT_EQ(rig.get("VW0"), 0);
  rig.scans(2);
  EXPECT_EQ(rig.get("VW0"), 1);
}

TEST(PulseTrain, CounterInModeTwelveCountsItsPulses) {
  Rig rig(
      "LD SM0.1\nMOVB 16#F8, SMB37\nMOVD 0, SMD38\nMOVD 90000, SMD42\nHDEF 0, 12\nHSC 0\nMOVB 16#85, SMB67\nMOVW 500, "
      "SMW68\nMOVD 50, SMD72\nPLS 0\n");
  rig.scans(2);
  EXPECT_GT(rig.get("HC0"), 30);
  rig.scans(3);
  EXPECT_EQ(rig.get("HC0"), 50);
}

// 9600 baud, 8 data bits, no parity: ten bits, 1.04 ms a character (001:14177).
TEST(SerialPort, ReceivedCharactersRaiseEventEight) {
  Rig rig(
      "LD SM0.1\nMOVB 16#09, SMB30\nATCH 0, 8\nENI\nMEND\nINT 0\nLDB= SMB2, 16#41\nS Q0.1, 1\nLD SM0.0\nINCW VW0\nMOVB "
      "SMB2, VB10\nRETI\n");
  rig.scans(1);
  rig.simulator->devices().ports.send(0, 0x40);
  rig.scans(1);
  EXPECT_EQ(rig.get("Q0.1"), 0);
  EXPECT_EQ(rig.get("VB10"), 0x40);
  rig.simulator->devices().ports.send(0, 0x41);
  rig.simulator->devices().ports.send(0, 0x42);
  rig.scans(1);
  EXPECT_EQ(rig.get("Q0.1"), 1);
  EXPECT_EQ(rig.get("VB10"), 0x42);
  EXPECT_EQ(rig.get("VW0"), 3);
}

TEST(SerialPort, TransmissionTakesItsTime) {
  Rig rig(
      "LD SM0.1\nMOVB 16#09, SMB30\nMOVB 3, VB100\nMOVB 65, VB101\nMOVB 66, VB102\nMOVB 67, VB103\nATCH 0, 9\nENI\nLD "
      "I0.0\nEU\nXMT VB100, 0\nMEND\nINT 0\nINCW VW0\nRETI\n");
  rig.scans(1);
  EXPECT_EQ(rig.get("SM4.5"), 1);
  rig.set("I0.0", 1);
  rig.scans(1, 2000);
  EXPECT_EQ(rig.get("SM4.5"), 0);
  EXPECT_EQ(rig.get("VW0"), 0);
  rig.scans(1, 2000);  // three characters last 3.1 ms
  EXPECT_EQ(rig.get("SM4.5"), 1);
  EXPECT_EQ(rig.get("VW0"), 1);
  EXPECT_EQ(rig.simulator->devices().ports.transmitted(0), (std::vector<std::uint8_t>{65, 66, 67}));
}

// Start character 2, end character 3, at most 20 characters: B0 hex (en, sc, ec... 001:3217) is E0.
TEST(SerialPort, MessageFromStartToEndCharacter) {
  Rig rig(
      "LD SM0.1\nMOVB 16#09, SMB30\nMOVB 16#E0, SMB87\nMOVB 2, SMB88\nMOVB 3, SMB89\nMOVB 20, SMB94\nATCH 0, "
      "23\nENI\nRCV VB100, 0\nMEND\n"
      "INT 0\nINCW VW0\nRETI\n");
  rig.scans(1);
  for (const int character : {9, 9, 2, 65, 66, 3, 67}) rig.simulator->devices().ports.send(0, character);
  rig.scans(1);
  EXPECT_EQ(rig.get("VW0"), 1);
  EXPECT_EQ(rig.get("VB100"), 4);
  EXPECT_EQ(rig.get("VB101"), 2);
  EXPECT_EQ(rig.get("VB104"), 3);
  EXPECT_EQ(rig.get("SMB86"), 0x20);
}

TEST(SerialPort, MessageEndsByCountOrByTime) {
  const auto text = [](const std::string& control) {
    return "LD SM0.1\nMOVB 16#09, SMB30\nMOVB " + control +
           ", SMB87\nMOVW 0, SMW90\nMOVW 15, SMW92\nMOVB 3, SMB94\nRCV VB100, 0\n";
  };
  Rig byCount(text("16#90"));  // enable, idle line of 0 ms: any character
  byCount.scans(1);
  for (const int character : {1, 2, 3, 4}) byCount.simulator->devices().ports.send(0, character);
  byCount.scans(1);
  EXPECT_EQ(byCount.get("SMB86"), 0x02);
  EXPECT_EQ(byCount.get("VB100"), 3);
  Rig byTime(text("16#94"));  // and the inter-character timer
  byTime.scans(1);
  byTime.simulator->devices().ports.send(0, 1);
  byTime.scans(1);
  EXPECT_EQ(byTime.get("SMB86"), 0);
  byTime.scans(2);
  EXPECT_EQ(byTime.get("SMB86"), 0x04);
  EXPECT_EQ(byTime.get("VB100"), 1);
}

TEST(Network, RequestEndsInTheNextScan) {
  const std::string text =
      "LD SM0.1\nMOVB 2, SMB30\nMOVB 3, VB201\nMOVD &VB0, VD202\nMOVB 4, VB206\nLD I0.0\nEU\nNETR VB200, 0\n";
  Rig rig(text);
  rig.scans(1);
  rig.set("I0.0", 1);
  rig.scans(1);
  EXPECT_EQ(rig.get("VB200"), 0x40);  // active
  rig.scans(1);
  EXPECT_EQ(rig.get("VB200"), 0x80);  // done
  Rig failing(text);
  failing.simulator->devices().network.setError(1);
  failing.scans(1);
  failing.set("I0.0", 1);
  failing.scans(2);
  EXPECT_EQ(failing.get("VB200"), 0xA1);  // done, error, time-out (001:3052)
}

TEST(Clock, RunsWithTheSimulationAndCanBeSet) {
  SimulatorOptions options;
  options.clock = {4, 2, 28, 23, 59, 59, 7};
  Rig rig("LD SM0.0\nTODR VB0\nLD I0.0\nEU\nTODW VB100\nLD SM0.1\nMOVD 16#95021412, VD100\nMOVD 16#00000003, VD104\n",
          options);
  rig.scans(1);
  EXPECT_EQ(rig.get("VB2"), 0x28);
  rig.scans(1, 400000);
  rig.scans(2, 400000);
  EXPECT_EQ(rig.get("VB0"), 0x04);
  EXPECT_EQ(rig.get("VB2"), 0x28);  // still the 28th at the start of this scan, 810 ms
  rig.scans(1, 400000);
  EXPECT_EQ(rig.get("VB1"), 0x02);
  EXPECT_EQ(rig.get("VB2"), 0x29);  // 2004 is a leap year
  EXPECT_EQ(rig.get("VB7"), 1);     // Sunday
  rig.set("I0.0", 1);
  rig.scans(2);
  EXPECT_EQ(rig.get("VD0"), static_cast<std::int32_t>(0x95021412));
  EXPECT_EQ(rig.get("VD4"), 3);
}

TEST(Clock, StandsAtNinetyAfterLongPowerLoss) {
  Rig rig("LD SM0.0\nTODR VB0\n");
  rig.scans(1);
  EXPECT_EQ(rig.get("VD0"), static_cast<std::int32_t>(0x90010100));
  EXPECT_EQ(rig.get("VD4"), 1);
}

}  // namespace
}  // namespace rungproof
