// Stimulus files: what they mean, recorded traces as stimuli, and every mistake with its place.
#include "engine/stimulus.hpp"

#include "frontend/simulation/stimulus_reader.hpp"
#include "tests/engine/rig.hpp"

namespace rungproof {
namespace {

/// Values of a signal at the ends of `count` scans under a stimulus.
std::string waveUnder(Rig& rig, const std::string& stimulusText, const std::string& signal, int count) {
  std::vector<Failure> failures;
  const Stimulus stimulus = readStimulus("s.csv", stimulusText, rig.program, failures);
  for (const Failure& failure : failures) ADD_FAILURE() << failure.place << ": " << failure.message;
  if (!failures.empty()) return "";
  StimulusPlayer player(*rig.simulator, stimulus);
  std::string wave;
  for (int i = 0; i < count; ++i) {
    rig.simulator->scan(player.next());
    wave += std::to_string(rig.get(signal));
  }
  return wave;
}

const std::string copy = "LD I0.0\n= Q0.0\n";

TEST(Stimulus, EmptyCellsAndMissingScansKeepTheLastValue) {
  Rig rig(copy);
  EXPECT_EQ(waveUnder(rig, "scan,I0.0\n2,1\n3,\n4,x\n6,0\n", "Q0.0", 7), "0111100");
}

TEST(Stimulus, RowsByTimeCountFromTheScanThatBeginsThen) {
  Rig rig(copy);  // 10 ms scans: the one that begins at 20 ms is scan 3; 25 ms waits for scan 4
  EXPECT_EQ(waveUnder(rig, "time_ms,I0.0\n0,0\n20,1\n25,0\n40.0,1\n", "Q0.0", 6), "001011");
}

TEST(Stimulus, ScanLengthsHoldUntilTheNextOne) {
  Rig rig("LD SM0.0\n= Q0.0\n");
  waveUnder(rig, "scan,scan_ms\n1,5\n3,2.5\n", "Q0.0", 4);
  EXPECT_EQ(rig.simulator->timeUs(), 15000U);
}

TEST(Stimulus, EventsRunTheirRoutines) {
  Rig rig("LD SM0.1\nATCH 0, 12\nATCH 1, 19\nENI\nMEND\nINT 0\nINCW VW0\nRETI\nINT 1\nINCW VW2\nRETI\n");
  waveUnder(rig, "scan,event\n2,12\n3,12 19\n4,\n", "VW0", 5);
  EXPECT_EQ(rig.get("VW0"), 2);
  EXPECT_EQ(rig.get("VW2"), 1);
}

// Lines: 1 LD, 2 ATCH, 3 ENI, 4 LD, 5 = Q0.0, 6 MOVW, 7 MEND, 8 INT 0, 9 LD, 10 INCW, 11 RETI.
const std::string interrupted =
    "LD SM0.1\nATCH 0, 12\nENI\nLD V1.0\n= Q0.0\nMOVW VW0, VW2\nMEND\nINT 0\nLD SM0.0\nINCW VW0\nRETI\n";

TEST(Stimulus, EventsComeInFrontOfTheInstructionInALine) {
  // VW0 has V1.0 as its lowest bit. In scan 2 the event comes behind the contact, so Q0.0 shows the old 0, and the
  // copy, made where V1.0 was 1, waits for scan 3, in which the second event comes in front of it.
  Rig behind(interrupted);
  EXPECT_EQ(waveUnder(behind, "scan,event\n2,12@5\n3,\n", "Q0.0", 3), "001");
  Rig copied(interrupted);
  EXPECT_EQ(waveUnder(copied, "scan,event\n2,12@5\n3,12@6\n4,\n", "VW2", 4), "0022");
  Rig before(interrupted);
  EXPECT_EQ(waveUnder(before, "scan,event\n2,12@4\n3,\n", "Q0.0", 3), "011");
  Rig late(interrupted);
  EXPECT_EQ(waveUnder(late, "scan,event\n2,12@end\n3,\n", "VW2", 3), "001");
}

// Three at once, and 17: one more than the queue holds (001:5488).
TEST(Stimulus, EventsAtOnce) {
  Rig rig("LD SM0.1\nATCH 0, 0\nENI\nMEND\nINT 0\nINCW VW0\nRETI\n");
  EXPECT_EQ(waveUnder(rig, "scan,event\n2,3x0@end\n3,17x0@end\n4,\n", "VW0", 3), "0319");
}

TEST(Stimulus, PlacesOfEventsMustExist) {
  Rig rig(interrupted);
  for (const char* word : {"12@99", "12@5/2", "12@5*0", "12@", "12@other.awl:5", "12@5x"}) {
    std::vector<Failure> failures;
    readStimulus("s.csv", std::string("scan,event\n1,") + word + "\n", rig.program, failures);
    ASSERT_EQ(failures.size(), 1U) << word;
    EXPECT_NE(failures[0].message.find("no instruction stands at"), std::string::npos) << failures[0].message;
  }
}

TEST(Stimulus, FormsOfNumbersAndTypes) {
  Rig rig("LD SM0.0\nMOVW AIW0, VW0\nMOVR VD10, VD20\nMOVB VB30, VB31\nMOVD VD40, VD50\n");
  waveUnder(rig, "scan,AIW0,VD10,VB30,VD40\n1,-1600,1.5,16#FF,4294967295\n", "VW0", 1);
  EXPECT_EQ(rig.get("VW0"), -1600);
  EXPECT_EQ(rig.simulator->read(operandNamed("VD20")), 0x3FC00000U);
  EXPECT_EQ(rig.get("VB31"), 255);
  EXPECT_EQ(rig.get("VD50"), -1);
}

TEST(Stimulus, SymbolsTimersAndPanels) {
  Rig rig("LD M0.0\n= Q0.0\nLD T37\n= Q0.1\nLDW>= T37, +50\n= Q0.2\nR M0.0, 1\n");
  rig.program.symbols.push_back({"Start_Button", operandNamed("M0.0"), "", {}});
  EXPECT_EQ(waveUnder(rig, "scan,start_button,T37,T37.value\n2,1,1,60\n3,,,\n", "QB0", 4), "0766");
}

TEST(Stimulus, DevicesAndLibraryBlocks) {
  Rig rig(
      "LD SM0.1\nMOVB 16#F8, SMB37\nMOVD 0, SMD38\nMOVD 1000, SMD42\nHDEF 0, 0\nHSC 0\nMOVB 16#09, SMB30\nATCH 0, "
      "8\nENI\n"
      "LD SM0.0\nCALL MBUS_SLAVE, Q0.1, VB10\nMEND\nINT 0\nINCW VW0\nMOVB SMB2, VB2\nRETI\n");
  waveUnder(rig, "scan,HSC0.pulses,PORT0.receive,MBUS_SLAVE.Done,MBUS_SLAVE.2\n2,5,'AB' 67,1,16#0B\n4,,,0,\n", "Q0.1",
            4);
  EXPECT_EQ(rig.get("HC0"), 15);
  EXPECT_EQ(rig.get("VW0"), 3);
  EXPECT_EQ(rig.get("VB2"), 67);
  EXPECT_EQ(rig.get("Q0.1"), 0);
  EXPECT_EQ(rig.get("VB10"), 11);
}

TEST(Stimulus, RecordedTraceSetsTheSurroundingsOnly) {
  const std::string text = "LD I0.0\nEU\nINCW VW0\nLDW>= VW0, VW10\n= Q0.0\nLD V20.0\n= Q0.1\n";
  Rig rig(text);
  EXPECT_EQ(
      waveUnder(rig,
                "scan,time_ms,scan_ms,I0.0,Q0.0,VW0,VW10,V20.0\n1,5,5,0,1,9,2,0\n2,9,4,1,1,9,2,1\n3,14,5,0,1,9,2,1\n",
                "QB0", 3),
      "022");
  EXPECT_EQ(rig.get("VW0"), 1);   // computed, not taken from the file
  EXPECT_EQ(rig.get("VW10"), 2);  // the program does not write it
  EXPECT_EQ(rig.simulator->timeUs(), 14000U);
}

struct Mistake {
  std::string text;
  std::string place;
  std::string message;  ///< part of it

  friend std::ostream& operator<<(std::ostream& out, const Mistake& mistake) {
    return out << mistake.place << ' ' << mistake.message;
  }
};

class StimulusMistake : public testing::TestWithParam<Mistake> {};

TEST_P(StimulusMistake, NamesFileLineAndColumn) {
  Rig rig("LD I0.0\n= Q0.0\nMOVW VW0, VW2\n");
  rig.program.symbols.push_back({"Start", operandNamed("I0.0"), "", {}});
  std::vector<Failure> failures;
  readStimulus("s.csv", GetParam().text, rig.program, failures);
  ASSERT_EQ(failures.size(), 1U);
  EXPECT_EQ(failures[0].place, GetParam().place);
  EXPECT_NE(failures[0].message.find(GetParam().message), std::string::npos) << failures[0].message;
}

INSTANTIATE_TEST_SUITE_P(
    Files, StimulusMistake,
    testing::Values(Mistake{"scan,Strat\n1,1\n", "s.csv:1:6", "'Strat' is no address and no symbol"},
                    Mistake{"step,I0.0\n1,1\n", "s.csv:1:1", "first column is 'step'"},
                    Mistake{"scan,I0.0,i0.0\n1,1,1\n", "s.csv:1:11", "stands here twice"},
                    Mistake{"scan,I0.0,\n1,1,\n", "s.csv:1:11", "has no heading"},
                    Mistake{"scan,I0.0\n3,1\n2,0\n", "s.csv:3:1", "scan 2 comes after scan 3"},
                    Mistake{"time_ms,I0.0\n10,1\n10,0\n", "s.csv:3:1", "time 10 comes after 10 ms"},
                    Mistake{"scan,I0.0\n0,1\n", "s.csv:2:1", "'0' is no scan number"},
                    Mistake{"scan,I0.0\n1.5,1\n", "s.csv:2:1", "'1.5' is no scan number"},
                    Mistake{"time_ms,I0.0\n-1,1\n", "s.csv:2:1", "'-1' is no time"},
                    Mistake{"scan,I0.0\n1,2\n", "s.csv:2:3", "I0.0 is a bit: 0 or 1, not 2"},
                    Mistake{"scan,I0.0\n1,up\n", "s.csv:2:3", "'up' is no value for I0.0"},
                    Mistake{"scan,I0.0,VW0\n1,1,65536\n", "s.csv:2:5", "VW0 does not hold 65536"},
                    Mistake{"scan,VW0\n1,1.5\n", "s.csv:2:3", "VW0 takes whole numbers"},
                    Mistake{"scan,I0.0\n1,1\n2\n", "s.csv:3:1", "this row has 1 cells, the heading has 2"},
                    Mistake{"scan,scan_ms\n1,0\n", "s.csv:2:3", "'0' is no length of a scan"},
                    Mistake{"scan,event\n1,34\n", "s.csv:2:3", "'34' is no interrupt event"},
                    Mistake{"scan,I0.0,time_ms\n1,1,1\n", "s.csv:1:11", "stands in the wrong place"},
                    Mistake{"scan,VW20000\n1,1\n", "s.csv:1:6", "the CPU 226 has no VW20000"},
                    Mistake{"scan,L0.0\n1,1\n", "s.csv:1:6", "no value between scans"},
                    Mistake{"scan,VW0.value\n1,1\n", "s.csv:1:6", "belongs to timers and counters"},
                    Mistake{"scan,PORT0.receive\n1,300\n", "s.csv:2:3", "'300' is no character"}));

TEST(StimulusMistakes, AreAllReported) {
  Rig rig(copy);
  std::vector<Failure> failures;
  readStimulus("s.csv", "scan,I0.0\n1,5\n2,y\n2,1\n", rig.program, failures);
  EXPECT_EQ(failures.size(), 3U);
}

TEST(StimulusMistakes, ACloseSymbolIsSuggested) {
  Rig rig(copy);
  rig.program.symbols.push_back({"Start", operandNamed("I0.0"), "", {}});
  std::vector<Failure> failures;
  readStimulus("s.csv", "scan,Strat\n1,1\n", rig.program, failures);
  ASSERT_EQ(failures.size(), 1U);
  EXPECT_EQ(failures[0].help, "did you mean 'Start'?");
}

TEST(TouchedSignals, InputsOutputsTimersCountersMemory) {
  const Rig rig(
      "LD V1.0\nTON T37, VW10\nLD T37\nLD C1\nCTU C1, +5\nLDW>= C1, +3\nA I0.1\n= Q0.1\nS Q1.6, 3\nMOVR VD20, "
      "VD24\nMOVW AIW2, AQW0\nMOVB *VD30, LB0\nMOVW +1, AC0\nA SM0.5\nA I0.0\n= M0.0\n");
  std::string names;
  for (const TraceSignal& signal : touchedSignals(rig.program)) names += signal.name + " ";
  EXPECT_EQ(names, "I0.0 I0.1 AIW2 Q0.1 Q1.6 Q1.7 Q2.0 AQW0 T37 T37.value C1 C1.value V1.0 VW10 VD20 VD24 M0.0 SM0.5 ");
}

TEST(TouchedSignals, DoubleWordsThatAreUsedAsRealAreReal) {
  const Rig rig("LD SM0.0\nMOVR VD20, VD24\nMOVD VD28, VD32\n");
  EXPECT_EQ(signalOf(rig.program, operandNamed("VD24")).type, SignalType::Real);
  EXPECT_EQ(signalOf(rig.program, operandNamed("VD32")).type, SignalType::Signed);
  EXPECT_EQ(signalOf(rig.program, operandNamed("VB5")).type, SignalType::Unsigned);
}

}  // namespace
}  // namespace rungproof
