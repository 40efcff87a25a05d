// Replay: scripted ticks, interrupts and external values at given instructions; the state after every scan.
#include "engine/replay.hpp"

#include "tests/engine/rig.hpp"

namespace rungproof {
namespace {

std::uint32_t idOf(const Program& program, std::string_view mnemonic, int nth = 0) {
  for (const Pou& pou : program.pous) {
    for (const Network& network : pou.networks) {
      for (const Instruction& instruction : network.instructions) {
        if (instruction.desc->stl == mnemonic && nth-- == 0) return instruction.id;
      }
    }
  }
  ADD_FAILURE() << mnemonic;
  return 0;
}

std::uint64_t bit(const Concrete::Store& state, Area area, std::uint32_t byte, std::uint32_t number) {
  return state.load(area, byte * 8 + number, 1);
}
std::uint64_t word(const Concrete::Store& state, Area area, std::uint32_t byte) {
  return state.load(area, byte * 8, 16);
}

TEST(Replay, InputsAndScanLengthsGiveTheStateOfTheEngine) {
  Rig rig("LD I0.0\nTON T37, +3\nLD T37\n= Q0.0\nLD SM0.5\n= Q0.1\n");
  std::vector<ReplayScan> scans(40);
  scans[0].inputs = {{operandNamed("I0.0"), 1}};
  const ReplayResult result = replay(rig.program, Choices{}, scans);
  ASSERT_EQ(result.states.size(), 40U);
  rig.set("I0.0", 1);
  for (const Concrete::Store& state : result.states) {
    rig.scans(1);
    ASSERT_EQ(state, rig.simulator->store()) << rig.simulator->scanCount();
  }
}

TEST(Replay, GivenTicksReplaceThoseOfTheClock) {
  Rig rig("LD SM0.0\nTON T37, +30000\nTON T33, +30000\nTON T32, +30000\n");
  std::vector<ReplayScan> scans(2);
  scans[1].script.ticks10 = 700;
  scans[1].script.ticks100 = 12000;
  scans[1].lengthMs = 4;
  const ReplayResult result = replay(rig.program, Choices{}, scans);
  EXPECT_EQ(result.states[1].get(Reg::TimerCurrent, 37), 12000U);
  EXPECT_EQ(result.states[1].get(Reg::TimerCurrent, 33), 700U);
  EXPECT_EQ(result.states[1].get(Reg::TimerCurrent, 32), 14U);  // 10 ms and 4 ms
}

TEST(Replay, OneMillisecondTicksComeInFrontOfTheirInstruction) {
  Rig rig("LD SM0.0\nTON T32, +3\nLD T32\n= Q0.0\nLD T32\n= Q0.1\n");
  std::vector<ReplayScan> scans(1);
  scans[0].script.ticks1 = {{{idOf(rig.program, "LD", 2), 0}, 3}};
  const ReplayResult result = replay(rig.program, Choices{}, scans);
  EXPECT_EQ(bit(result.states[0], Area::Q, 0, 0), 0U);
  EXPECT_EQ(bit(result.states[0], Area::Q, 0, 1), 1U);
  EXPECT_EQ(result.states[0].get(Reg::TimerCurrent, 32), 10U);  // the other seven after the program
}

TEST(Replay, AScanHasNoMoreTicksThanMilliseconds) {
  Rig rig("LD SM0.0\nTON T32, +30000\nLD SM0.0\nMOVW T32, VW0\n");
  std::vector<ReplayScan> scans(1);
  scans[0].script.ticks1 = {{{idOf(rig.program, "LD", 1), 0}, 7}, {{idOf(rig.program, "MOVW"), 0}, 300}};
  const ReplayResult result = replay(rig.program, Choices{}, scans);  // of 10 ms
  EXPECT_EQ(word(result.states[0], Area::V, 0), 10U);
  EXPECT_EQ(result.states[0].get(Reg::TimerCurrent, 32), 10U);
}

TEST(Replay, InterruptsComeInFrontOfTheirInstructionAndVisit) {
  Rig rig(
      "LD SM0.1\nATCH 0, 2\nENI\nLD SM0.0\nFOR VW0, +1, +5\nLD SM0.0\nMOVW VW4, VW6\nNEXT\nLD M0.0\n= Q0.0\nMEND\n"
      "INT 0\nINCW VW4\nS M0.0, 1\nRETI\n");
  const std::uint32_t move = idOf(rig.program, "MOVW");
  std::vector<ReplayScan> scans(1);
  scans[0].script.events = {{{move, 1}, 2}, {{move, 3}, 2}};
  const ReplayResult result = replay(rig.program, Choices{}, scans);
  EXPECT_EQ(word(result.states[0], Area::V, 4), 2U);
  EXPECT_EQ(word(result.states[0], Area::V, 6), 2U);
  EXPECT_EQ(bit(result.states[0], Area::Q, 0, 0), 1U);
  scans[0].script.events = {{{ScanPlace::afterProgram, 0}, 2}};
  const ReplayResult after = replay(rig.program, Choices{}, scans);
  EXPECT_EQ(word(after.states[0], Area::V, 4), 1U);
  EXPECT_EQ(bit(after.states[0], Area::Q, 0, 0), 0U);
}

TEST(Replay, EventsThatAreNotEnabledArePassedOver) {
  Rig rig("LD SM0.1\nATCH 0, 2\nMEND\nINT 0\nINCW VW4\nRETI\n");
  std::vector<ReplayScan> scans(1);
  scans[0].script.events = {{{ScanPlace::afterProgram, 0}, 2}};
  EXPECT_EQ(word(replay(rig.program, Choices{}, scans).states[0], Area::V, 4), 0U);
}

// What came while interrupts were disabled runs as soon as they are enabled, in front of the next instruction
// (001:5372).
TEST(Replay, EventsWaitUntilInterruptsAreEnabled) {
  Rig rig(
      "LD SM0.1\nATCH 0, 2\nLD SM0.0\nDISI\nMOVW VW4, VW6\nENI\nMOVW VW4, VW8\nMEND\n"
      "INT 0\nINCW VW4\nRETI\n");
  std::vector<ReplayScan> scans(1);
  scans[0].script.events = {{{idOf(rig.program, "MOVW", 0), 0}, 2}, {{idOf(rig.program, "MOVW", 0), 0}, 2}};
  const ReplayResult result = replay(rig.program, Choices{}, scans);
  EXPECT_EQ(word(result.states[0], Area::V, 6), 0U);
  EXPECT_EQ(word(result.states[0], Area::V, 8), 2U);
}

TEST(Replay, EventsWithoutACauseDoNotCome) {
  for (const char* attach : {"ATCH 0, 12", "ATCH 0, 9", "ATCH 0, 21", "MOVB 100, SMB34\nATCH 0, 10"}) {
    Rig rig(std::string("LD SM0.1\n") + attach + "\nENI\nMEND\nINT 0\nINCW VW4\nRETI\n");
    std::vector<ReplayScan> scans(1);
    for (const int event : {12, 9, 21, 10}) scans[0].script.events.push_back({{ScanPlace::afterProgram, 0}, event});
    EXPECT_EQ(word(replay(rig.program, Choices{}, scans).states[0], Area::V, 4), 0U) << attach;
  }
}

// With both edges of an input attached, a second rising edge needs a falling one in between (001:5460).
TEST(Replay, EdgesOfAnInputComeInTurn) {
  Rig rig("LD SM0.1\nATCH 0, 0\nATCH 1, 1\nENI\nMEND\nINT 0\nINCW VW4\nRETI\nINT 1\nINCW VW6\nRETI\n");
  std::vector<ReplayScan> scans(1);
  for (const int event : {0, 0, 1, 1, 0}) scans[0].script.events.push_back({{ScanPlace::afterProgram, 0}, event});
  const ReplayResult result = replay(rig.program, Choices{}, scans);
  EXPECT_EQ(word(result.states[0], Area::V, 4), 2U);
  EXPECT_EQ(word(result.states[0], Area::V, 6), 1U);
}

// Event 10 follows from the time: 25 ms of scans hold two periods of 10 ms, wherever they are placed.
TEST(Replay, TimedEventsComeByThemselves) {
  Rig rig("LD SM0.1\nMOVB 10, SMB34\nATCH 0, 10\nENI\nMEND\nINT 0\nINCW VW4\nRETI\n");
  std::vector<ReplayScan> scans(5);
  for (ReplayScan& scan : scans) scan.lengthMs = 5;
  std::vector<std::uint64_t> counted;
  for (const Concrete::Store& state : replay(rig.program, Choices{}, scans).states)
    counted.push_back(word(state, Area::V, 4));
  EXPECT_EQ(counted, (std::vector<std::uint64_t>{0, 1, 1, 2, 2}));
}

// Eight of event 10 wait while interrupts are disabled (001:5489), the others are lost; the routine sees SM4.2.
TEST(Replay, TimedEventsOverflowTheirQueue) {
  Rig rig(
      "LD SM0.1\nMOVB 1, SMB34\nATCH 0, 10\nLD I0.0\nENI\nLDN I0.0\nDISI\nMEND\n"
      "INT 0\nINCW VW4\nLD SM4.2\nINCW VW6\nRETI\n");
  std::vector<ReplayScan> scans(2);
  for (ReplayScan& scan : scans) scan.lengthMs = 20;
  scans[0].inputs = {{operandNamed("I0.0"), 0}};
  scans[1].inputs = {{operandNamed("I0.0"), 1}};
  const ReplayResult result = replay(rig.program, Choices{}, scans);
  EXPECT_EQ(word(result.states[0], Area::V, 4), 0U);
  EXPECT_EQ(result.states[0].load(Area::SM, 4 * 8 + 2, 1), 1U);
  EXPECT_EQ(word(result.states[1], Area::V, 4), 28U);
  EXPECT_EQ(word(result.states[1], Area::V, 6), 8U);
  EXPECT_EQ(result.states[1].load(Area::SM, 4 * 8 + 2, 1), 0U);
}

// 17 at once are one more than the queue holds (001:5488): one is lost, and the routine sees SM4.1.
TEST(Replay, EventsThatComeTogetherOverflowTheirQueue) {
  Rig rig("LD SM0.1\nATCH 0, 2\nENI\nMEND\nINT 0\nLD SM4.1\nINCW VW4\nRETI\n");
  std::vector<ReplayScan> scans(2);
  scans[0].script.events.assign(17, {{ScanPlace::afterProgram, 0}, 2, true});
  scans[0].script.events.back().isWithNext = false;
  scans[1].script.events.assign(16, {{ScanPlace::afterProgram, 0}, 2, true});
  scans[1].script.events.back().isWithNext = false;
  const ReplayResult result = replay(rig.program, Choices{}, scans);
  EXPECT_EQ(word(result.states[0], Area::V, 4), 16U);
  EXPECT_EQ(word(result.states[1], Area::V, 4), 16U);  // 16 fit
  EXPECT_EQ(result.states[0].load(Area::SM, 4 * 8 + 1, 1), 0U);
}

TEST(Replay, ExternalValuesAreHandedOutInOrder) {
  Rig rig("LD SM0.0\nMOVW AIW0, VW0\nMOVW AIW0, VW2\nLDI I0.3\n= Q0.0\n");
  const std::uint32_t first = idOf(rig.program, "MOVW", 0), second = idOf(rig.program, "MOVW", 1);
  std::vector<ReplayScan> scans(2);
  scans[0].externals = {{{External::AnalogInput, 0, first}, 111},
                        {{External::AnalogInput, 0, second}, 222},
                        {{External::ImmediateInput, 3, idOf(rig.program, "LDI")}, 1}};
  scans[1].externals = {{{External::AnalogInput, 0, first}, 333}, {{External::AnalogInput, 9, first}, 1}};
  Choices choices;
  ASSERT_TRUE(choices.set("analog-sampling", "each-read"));
  const ReplayResult result = replay(rig.program, choices, scans);
  EXPECT_EQ(word(result.states[0], Area::V, 0), 111U);
  EXPECT_EQ(word(result.states[0], Area::V, 2), 222U);
  EXPECT_EQ(bit(result.states[0], Area::Q, 0, 0), 1U);
  EXPECT_EQ(word(result.states[1], Area::V, 0), 333U);
  EXPECT_EQ(word(result.states[1], Area::V, 2), 333U);  // nothing is said of it: the input is as it was
  EXPECT_EQ(result.unusedExternals, 1U);                // AIW9 was never read
}

// With the input filter the CPU samples an analog input once a scan (001:1812): both reads see the same value.
TEST(Replay, AnalogInputsAreSampledOnceAScan) {
  Rig rig("LD SM0.0\nMOVW AIW0, VW0\nMOVW AIW0, VW2\n");
  std::vector<ReplayScan> scans(1);
  scans[0].inputs = {{direct(Area::AI, Width::Word, 0), 111}};
  const ReplayResult result = replay(rig.program, Choices{}, scans);
  EXPECT_EQ(word(result.states[0], Area::V, 0), 111U);
  EXPECT_EQ(word(result.states[0], Area::V, 2), 111U);
}

TEST(Replay, StartsFromAGivenStateAndEndsWithAFatalError) {
  Rig rig("LDB= *VD0, VB10\n= Q0.0\n");
  Concrete::Store start = rig.simulator->store();
  start.save(Area::V, 0, 32, pointer::encode(Area::V, 10), true);
  std::vector<ReplayScan> scans(3);
  scans[1].inputs = {{operandNamed("VD0"), 0xFF000000}};
  const ReplayResult result = replay(rig.program, Choices{}, scans, &start);
  ASSERT_EQ(result.states.size(), 2U);
  EXPECT_EQ(bit(result.states[0], Area::Q, 0, 0), 1U);
  ASSERT_EQ(result.errors.size(), 1U);
  EXPECT_EQ(result.errors[0].hazard, Hazard::FatalIndirectAddress);
}

TEST(Replay, RunsScanByScanWithScriptsMadeOnTheWay) {
  // The same scans as a list and one by one: 3 scans with the input, 5 without, of other lengths.
  Rig rig("LD I0.0\nTON T33, +5\nLD T33\n= Q0.0\nLD SM0.0\nINCW VW0\n");
  std::vector<ReplayScan> scans(2);
  scans[0].inputs = {{operandNamed("I0.0"), 1}};
  scans[0].lengthMs = 25;
  scans[0].repeats = 3;
  scans[1].inputs = {{operandNamed("I0.0"), 0}};
  scans[1].lengthMs = 40;
  scans[1].repeats = 5;
  const ReplayResult result = replay(rig.program, Choices{}, scans);
  ASSERT_EQ(result.states.size(), 8U);
  EXPECT_EQ(bit(result.states[2], Area::Q, 0, 0), 1U);  // 50 ms have passed when the third scan begins
  ReplayRun run(rig.program, Choices{});
  std::size_t at = 0;
  for (const ReplayScan& scan : scans) {
    run.load(scan);
    for (std::uint32_t i = 0; i < scan.repeats; ++i) EXPECT_EQ(run.scan(), result.states[at++]) << at;
  }
  EXPECT_TRUE(run.isRunning());
  EXPECT_TRUE(run.errors().empty());
  EXPECT_EQ(run.unusedExternals(), 0U);
}

TEST(Replay, RepeatsAndObserver) {
  Rig rig("LD SM0.0\nINCW VW0\n");
  std::vector<ReplayScan> scans(2);
  scans[0].repeats = 10;
  std::vector<std::uint64_t> seen;
  const ReplayResult result =
      replay(rig.program, Choices{}, scans, nullptr, [&](const Concrete::Store& state, std::size_t) {
        seen.push_back(word(state, Area::V, 0));
        return seen.size() < 8;
      });
  EXPECT_TRUE(result.states.empty());
  EXPECT_EQ(seen, (std::vector<std::uint64_t>{1, 2, 3, 4, 5, 6, 7, 8}));
}

}  // namespace
}  // namespace rungproof
