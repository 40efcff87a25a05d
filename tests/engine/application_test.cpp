// Small control programs written for these tests, run through the scenario that their task describes: motor starters,
// operating hours, edges, loops, mean values, clock, staircase of interrupts. Buttons: ON normally open, OFF and
// breaker normally closed. Scans last 10 ms.
#include "tests/engine/rig.hpp"

namespace rungproof {
namespace {

/// One step of a scenario: inputs to set, scans to make, outputs of QB0 expected after them.
struct Step {
  std::vector<std::pair<std::string, int>> inputs;
  int scans;
  int outputs;
  const char* what;
};

void play(Rig& rig, const std::vector<Step>& steps) {
  for (const Step& step : steps) {
    for (const auto& [name, value] : step.inputs) rig.set(name, value);
    rig.scans(step.scans);
    EXPECT_EQ(rig.get("QB0"), step.outputs) << step.what;
  }
}

// I0.0 ON, I0.1 OFF, I0.2 breaker; Q0.0 mains, Q0.1 star, Q0.2 delta after 5 s. M1.0 locks until ON and OFF are
// released.
TEST(Application, StarDeltaStarter) {
  Rig rig(
      "LD I0.0\nAN I0.1\nS M1.0, 1\n"
      "LDN I0.0\nA I0.1\nR M1.0, 1\n"
      "LD I0.0\nO Q0.0\nA I0.1\nA I0.2\nAN M1.0\n= Q0.0\n"
      "LD Q0.0\nTON T37, +50\n"
      "LD Q0.0\nLPS\nAN T37\n= Q0.1\nLPP\nAN Q0.1\n= Q0.2\n");
  play(rig, {{{{"I0.1", 1}, {"I0.2", 1}}, 1, 0b000, "at rest"},
             {{{"I0.0", 1}}, 1, 0b011, "ON: mains and star"},
             {{{"I0.0", 0}}, 480, 0b011, "star for 4.8 s"},
             {{}, 21, 0b101, "delta after 5 s"},
             {{{"I0.1", 0}}, 1, 0b000, "OFF in the same scan"},
             {{{"I0.0", 1}}, 1, 0b000, "both pressed"},
             {{{"I0.1", 1}}, 1, 0b000, "OFF released, ON still held"},
             {{{"I0.0", 0}}, 1, 0b000, "both released"},
             {{{"I0.0", 1}}, 1, 0b011, "starts again"},
             {{{"I0.2", 0}}, 1, 0b000, "breaker"}});
}

// The two contactors are never on together, whatever the inputs do.
TEST(Application, StarAndDeltaExcludeEachOther) {
  Rig rig(
      "LD I0.0\nO Q0.0\nA I0.1\nA I0.2\n= Q0.0\nLD Q0.0\nTON T33, +5\n"
      "LD Q0.0\nLPS\nAN T33\n= Q0.1\nLPP\nAN Q0.1\n= Q0.2\n");
  std::uint32_t inputs = 12345;
  for (int scan = 0; scan < 5000; ++scan) {
    inputs = inputs * 1664525 + 1013904223;
    rig.set("IB0", inputs >> 24 | (scan % 50 != 0 ? 6 : 0));
    rig.scans(1);
    ASSERT_NE(rig.get("QB0") & 0b110, 0b110) << scan;
    ASSERT_TRUE((rig.get("QB0") & 1) != 0 || rig.get("QB0") == 0) << scan;
  }
}

// Resistance bridged after 5 s: Q0.0 motor, Q0.1 bypass.
TEST(Application, StatorResistance) {
  Rig rig(
      "LD I0.0\nAN I0.1\nO M1.0\nLD I0.0\nON I0.1\nALD\n= M1.0\n"
      "LD I0.0\nO Q0.0\nA I0.1\nA I0.2\nAN M1.0\n= Q0.0\nTON T37, +50\nLD T37\nA Q0.0\n= Q0.1\n");
  play(rig, {{{{"I0.1", 1}, {"I0.2", 1}}, 1, 0, "at rest"},
             {{{"I0.0", 1}}, 1, 1, "ON"},
             {{{"I0.0", 0}}, 490, 1, "resistance in"},
             {{}, 12, 3, "bridged after 5 s"},
             {{{"I0.1", 0}}, 1, 0, "OFF"},
             {{{"I0.0", 1}}, 1, 0, "ON while OFF is pressed"},
             {{{"I0.1", 1}}, 1, 0, "OFF released, ON held"},
             {{{"I0.0", 0}}, 1, 0, "released"},
             {{{"I0.0", 1}}, 1, 1, "ON again"}});
}

// Reversing with a forced pause of 2 s that begins when the motor stops. Q0.0 left, Q0.1 right, Q0.2 pause.
TEST(Application, ReversingStarterWaitsAfterTheStop) {
  Rig rig(
      "LD Q0.0\nO Q0.1\nED\nS M0.0, 1\n"
      "LD M0.0\nTON T33, +200\nA T33\nR M0.0, 1\n"
      "LD I0.0\nO Q0.0\nAN I0.1\nA I0.2\nAN Q0.1\nAN M0.0\n= Q0.0\n"
      "LD I0.1\nO Q0.1\nAN I0.0\nA I0.2\nAN Q0.0\nAN M0.0\n= Q0.1\n"
      "LD M0.0\n= Q0.2\n");
  play(rig, {{{{"I0.2", 1}}, 2, 0b000, "at rest"},
             {{{"I0.0", 1}}, 1, 0b001, "left"},
             {{{"I0.0", 0}}, 10, 0b001, "latched"},
             {{{"I0.2", 0}}, 1, 0b000, "stop; the edge is seen in the next scan"},
             {{{"I0.2", 1}, {"I0.1", 1}}, 1, 0b100, "pause"},
             {{}, 199, 0b100, "still"},
             {{}, 2, 0b010, "right after 2 s"},
             {{{"I0.0", 1}}, 1, 0b000, "both buttons stop the motor"}});
}

// Seconds, minutes and hours of I0.0 with a retentive timer of one second.
TEST(Application, OperatingHours) {
  Rig rig(
      "LD I0.0\nTONR T5, +10\nLD T5\nINCW VW4\nR T5, 1\n"
      "LDW>= VW4, +60\nMOVW +0, VW4\nINCW VW2\nLDW>= VW2, +60\nMOVW +0, VW2\nINCW VW0\n");
  rig.set("I0.0", 1);
  rig.scans(6110);  // 61 s and the scan of the last tick; each reset costs no time because ticks go on
  EXPECT_EQ(rig.get("VW2"), 1);
  EXPECT_EQ(rig.get("VW4"), 1);
  rig.set("I0.0", 0);
  rig.scans(1000);
  EXPECT_EQ(rig.get("VW4"), 1);
  rig.set("I0.0", 1);
  rig.scans(360001);  // I0.0 comes on at a tick, which still belongs to the pause: the hour ends at a scan's start
  EXPECT_EQ(rig.get("VW0"), 1);
  EXPECT_EQ(rig.get("VW2"), 1);
  EXPECT_EQ(rig.get("VW4"), 1);
}

TEST(Application, EdgesAreCountedAndWrap) {
  Rig rig("LD I0.0\nEU\nINCW MW1\nLD I0.1\nED\nINCW MW3\nLDW= +127, MW1\nMOVW +0, MW1\nLDW= +127, MW3\nMOVW +0, MW3\n");
  for (int i = 0; i < 126; ++i) {
    rig.set("IB0", 3);
    rig.scans(2);
    rig.set("IB0", 0);
    rig.scans(2);
  }
  // The very first scan had the inputs on: no rising edge is seen in the first scan (001:2763).
  EXPECT_EQ(rig.get("MW1"), 125);
  EXPECT_EQ(rig.get("MW3"), 126);
  for (int i = 0; i < 2; ++i) {
    rig.set("IB0", 3);
    rig.scans(1);
    rig.set("IB0", 0);
    rig.scans(1);
  }
  EXPECT_EQ(rig.get("MW1"), 0);
  EXPECT_EQ(rig.get("MW3"), 1);
}

TEST(Application, LoopFillsATableThroughAPointer) {
  Rig rig(
      "LD I0.0\nFILL 16#ABC3, VW204, 7\n"
      "LD I0.1\nMOVD &VB100, AC1\nMOVW +50, VW0\nFOR VW2, +0, +10\nLD SM0.0\nMOVW VW0, *AC1\n+I +4, VW0\n+D +2, "
      "AC1\nNEXT\n"
      "LD I0.2\nR V100.0, 176\nR V204.0, 112\n");
  rig.set("I0.0", 1);
  rig.set("I0.1", 1);
  rig.scans(1);
  for (std::uint32_t k = 0; k <= 10; ++k)
    EXPECT_EQ(rig.simulator->read(direct(Area::V, Width::Word, 100 + 2 * k)), 50 + 4 * k);
  EXPECT_EQ(rig.get("VW216"), static_cast<std::int16_t>(0xABC3));
  EXPECT_EQ(rig.get("VW218"), 0);
  EXPECT_EQ(rig.get("AC1") & 0xFFFF, 122);
  rig.set("I0.2", 1);
  rig.scans(1);
  for (std::uint32_t byte = 100; byte < 122; ++byte)
    EXPECT_EQ(rig.simulator->read(direct(Area::V, Width::Byte, byte)), 0U);
  EXPECT_EQ(rig.get("VW216"), 0);
}

// Mean of 128 samples: a 32-bit sum shifted right by 7 gives the floor in the low word, for negative sums as well.
TEST(Application, MeanOfAnalogSamples) {
  const std::string text =
      "LD SM0.1\nMOVD 0, VD10\nMOVW +0, VW14\n"
      "LD SM0.0\nMOVW AIW0, AC0\nITD AC0, AC0\n+D AC0, VD10\nINCW VW14\n"
      "LDW>= VW14, +128\nSRD VD10, 7\nMOVW VW12, VW20\nMOVW VW12, AQW0\nMOVD 0, VD10\nMOVW +0, VW14\n"
      "LDW>= VW20, +160\nS Q0.0, 1\nR Q0.1, 1\nLDW<= VW20, -160\nS Q0.1, 1\nR Q0.0, 1\n";
  Rig rig(text);
  rig.set("AIW0", 1600);
  rig.scans(128);
  EXPECT_EQ(rig.get("VW20"), 1600);
  EXPECT_EQ(rig.get("AQW0"), 1600);
  EXPECT_EQ(rig.get("QB0"), 1);
  rig.set("AIW0", -1600);
  rig.scans(128);
  EXPECT_EQ(rig.get("VW20"), -1600);
  EXPECT_EQ(rig.get("QB0"), 2);
  rig.set("AIW0", 0);
  rig.scans(128);
  EXPECT_EQ(rig.get("QB0"), 2);  // between the limits the lamps stay
}

// Angle in IB0 to steps of a motor with 1000 steps a turn: round(angle * 25 / 9).
TEST(Application, AngleToSteps) {
  Rig rig("LD SM0.0\nMOVD 0, VD0\nMOVB IB0, VB3\nMUL +25, VD0\n+D +4, VD0\nDIV +9, VD0\nMOVW +0, VW0\n");
  for (const auto& [angle, steps] :
       std::vector<std::pair<int, int>>{{0, 0}, {1, 3}, {2, 6}, {45, 125}, {90, 250}, {180, 500}, {255, 708}}) {
    rig.set("IB0", angle);
    rig.scans(1);
    EXPECT_EQ(rig.get("VD0"), steps) << angle;
  }
}

// Direction by interrupts on both edges, one step per second clock, limits 0 and 255.
TEST(Application, CounterWithDirectionInterrupts) {
  Rig rig(
      "LD SM0.1\nATCH 0, 0\nATCH 1, 1\nENI\n"
      "LD SM0.5\nEU\nLPS\nAN M0.0\nAB< VB0, 255\nINCB VB0\nLPP\nA M0.0\nAB>= VB0, 1\nDECB VB0\n"
      "LD SM0.0\nMOVB VB0, QB0\nMEND\nINT 0\nS M0.0, 1\nRETI\nINT 1\nR M0.0, 1\nRETI\n");
  rig.scans(1, 10000);
  const auto seconds = [&](int count) { rig.scans(count * 10, 100000); };
  seconds(3);
  EXPECT_EQ(rig.get("QB0"), 3);
  rig.set("I0.0", 1);
  seconds(2);
  EXPECT_EQ(rig.get("QB0"), 1);
  seconds(3);
  EXPECT_EQ(rig.get("QB0"), 0);
  rig.set("I0.0", 0);
  seconds(300);
  EXPECT_EQ(rig.get("QB0"), 255);
}

// Traffic light of two steps as SCR segments: green 2 s, red 1 s.
TEST(Application, SequenceOfSegments) {
  Rig rig(
      "LD SM0.1\nS S0.1, 1\n"
      "LSCR S0.1\nLD SM0.0\nS Q0.0, 1\nR Q0.1, 1\nTON T37, +20\nLD T37\nSCRT S0.2\nSCRE\n"
      "LSCR S0.2\nLD SM0.0\nS Q0.1, 1\nR Q0.0, 1\nTON T38, +10\nLD T38\nSCRT S0.1\nSCRE\n");
  rig.scans(1);
  EXPECT_EQ(rig.get("QB0"), 0b01);
  int greenScans = 0;
  while (rig.get("QB0") == 0b01 && greenScans < 1000) {
    rig.scans(1);
    ++greenScans;
  }
  EXPECT_NEAR(greenScans, 200, 11);  // one tick short at most, one scan more
  int redScans = 0;
  while (rig.get("QB0") == 0b10 && redScans < 1000) {
    rig.scans(1);
    ++redScans;
  }
  EXPECT_NEAR(redScans, 100, 11);
}

}  // namespace
}  // namespace rungproof
