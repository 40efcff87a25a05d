// Interrupts in whole scans: priority and order, queues and their overflow, DISI, timed periods, T32, edges, STOP in a
// routine, saved registers (001:5327-5547).
#include "engine/interrupt_queue.hpp"
#include "ir/s7200/cpu.hpp"
#include "tests/engine/rig.hpp"

namespace rungproof {
namespace {

TEST(InterruptQueue, HighestGroupFirstThenOrderOfArrival) {
  InterruptQueue queue{Target{}};
  EXPECT_TRUE(queue.add(10, 1));  // timed
  EXPECT_TRUE(queue.add(12, 2));  // I/O
  EXPECT_TRUE(queue.add(0, 3));   // I/O, later although of better rank
  EXPECT_TRUE(queue.add(8, 4));   // communication
  EXPECT_EQ(queue.take()->event, 8);
  EXPECT_EQ(queue.take()->event, 12);
  EXPECT_EQ(queue.take()->event, 0);
  EXPECT_EQ(queue.take()->event, 10);
  EXPECT_FALSE(queue.take());
}

TEST(InterruptQueue, SimultaneousEventsStandInOrderOfRank) {
  InterruptQueue queue{Target{}};
  for (const int event : {11, 10, 22, 21}) EXPECT_TRUE(queue.add(event, 7));
  for (const int event : {10, 11, 21, 22}) EXPECT_EQ(queue.take()->event, event);
}

TEST(InterruptQueue, DepthsFollowTheCpu) {
  const auto room = [](Cpu cpu, int event) {
    InterruptQueue queue{Target{cpu, Edition::Edition2004}};
    int count = 0;
    while (queue.add(event, static_cast<std::uint64_t>(count))) ++count;
    return count;
  };
  EXPECT_EQ(room(s7200Cpu("224"), 8), 4);  // table 6-48, 001:5486-5489
  EXPECT_EQ(room(s7200Cpu("226"), 8), 8);
  EXPECT_EQ(room(s7200Cpu("224"), 0), 16);
  EXPECT_EQ(room(s7200Cpu("226"), 10), 8);
}

// Event 10 sets, event 11 of the double period resets. Both are due together at 100 ms: with 10 before 11 the output is
// a square wave, with the other order it would stay on for ever.
const std::string squareWave =
    "LD SM0.1\nMOVB 50, SMB34\nMOVB 100, SMB35\nATCH 0, 10\nATCH 1, 11\nENI\nMEND\n"
    "INT 0\nS Q0.0, 1\nRETI\nINT 1\nR Q0.0, 1\nRETI\n";

TEST(Interrupt, TimedEventTenIsServedBeforeEleven) {
  Rig rig(squareWave);
  EXPECT_EQ(rig.wave("Q0.0", 22), "0000111110000011111000");
}

TEST(Interrupt, APeriodIsTakenOverByAttachOnly) {
  Rig rig(
      "LD SM0.1\nMOVB 20, SMB34\nATCH 0, 10\nENI\nLD I0.0\nEU\nMOVB 50, SMB34\nLD I0.1\nEU\nATCH 0, 10\nMEND\nINT "
      "0\nINCW VW0\nRETI\n");
  rig.scans(10);
  EXPECT_EQ(rig.get("VW0"), 5);
  rig.set("I0.0", 1);
  rig.scans(10);
  EXPECT_EQ(rig.get("VW0"), 10);  // still every 20 ms (001:5472)
  rig.set("I0.1", 1);
  rig.scans(10);  // attached anew at 200 ms: due at 250 and 300 ms
  EXPECT_EQ(rig.get("VW0"), 12);
}

TEST(Interrupt, NothingRunsBeforeEnable) {
  Rig rig("LD SM0.1\nMOVB 10, SMB34\nATCH 0, 10\nLD I0.0\nENI\nMEND\nINT 0\nINCW VW0\nRETI\n");
  rig.scans(5);
  EXPECT_EQ(rig.get("VW0"), 0);
  EXPECT_EQ(rig.get("SM4.4"), 0);
  rig.set("I0.0", 1);
  rig.scans(1);
  EXPECT_EQ(rig.get("SM4.4"), 1);
  EXPECT_EQ(rig.get("VW0"), 6);  // the five that waited, and that of this scan
}

// 10 ms period, disabled for 12 scans: eight fit (001:5489), four are lost and SM4.2 shows it to the routine.
TEST(Interrupt, DisabledEventsQueueUpAndOverflow) {
  Rig rig(
      "LD SM0.1\nMOVB 10, SMB34\nATCH 0, 10\nLDN I0.0\nDISI\nLD I0.0\nENI\nMEND\n"
      "INT 0\nINCW VW0\nLD SM4.2\nS M0.0, 1\nRETI\n");
  rig.scans(12);
  EXPECT_EQ(rig.get("VW0"), 0);
  EXPECT_EQ(rig.get("SM4.2"), 1);
  EXPECT_TRUE(rig.simulator->errors().has(Hazard::QueueOverflow));
  rig.set("I0.0", 1);
  rig.scans(1);
  EXPECT_EQ(rig.get("VW0"), 9);  // eight from the queue, one at the end of this scan
  EXPECT_EQ(rig.get("M0.0"), 1);
  EXPECT_EQ(rig.get("SM4.2"), 0);  // the queue is empty again (001:5491)
}

TEST(Interrupt, ClearEventsEmptiesTheQueueOfOneEvent) {
  Rig rig(
      "LD SM0.1\nMOVB 10, SMB34\nMOVB 10, SMB35\nATCH 0, 10\nATCH 1, 11\nLD I0.0\nDTCH 10\nCEVNT 10\nENI\nMEND\n"
      "INT 0\nINCW VW0\nRETI\nINT 1\nINCW VW2\nRETI\n");
  rig.scans(3);
  rig.set("I0.0", 1);
  rig.scans(1);
  EXPECT_EQ(rig.get("VW0"), 0);
  EXPECT_EQ(rig.get("VW2"), 4);
}

// What waits when its event is detached still runs, or is dropped (001:5357 says that CEVNT is there to clear it).
TEST(Interrupt, DetachedEventThatWaitsIsAChoice) {
  const std::string text = "LD SM0.1\nMOVB 10, SMB34\nATCH 0, 10\nLD I0.0\nDTCH 10\nENI\nMEND\nINT 0\nINCW VW0\nRETI\n";
  for (const bool isKept : {true, false}) {
    SimulatorOptions options;
    ASSERT_TRUE(options.choices.set("detached-events", isKept ? "kept" : "dropped"));
    Rig rig(text, options);
    rig.scans(3);  // three wait
    rig.set("I0.0", 1);
    rig.scans(2);
    EXPECT_EQ(rig.get("VW0"), isKept ? 3 : 0);
  }
}

TEST(Interrupt, StimulusTellsOfEventsWithoutACause) {
  Rig rig("LD SM0.1\nATCH 0, 12\nATCH 0, 2\nENI\nMEND\nINT 0\nINCW VW0\nRETI\n");
  rig.scans(1);
  rig.simulator->scan({.events = {12, 2}});
  EXPECT_EQ(rig.get("VW0"), 2);  // as the stimulus asks
  EXPECT_EQ(rig.simulator->eventsWithoutCause(), (std::set<int>{12}));
}

TEST(Interrupt, DetachedEventIsIgnored) {
  Rig rig("LD SM0.1\nMOVB 10, SMB34\nATCH 0, 10\nENI\nLD I0.0\nDTCH 10\nMEND\nINT 0\nINCW VW0\nRETI\n");
  rig.scans(3);
  rig.set("I0.0", 1);
  rig.scans(5);
  EXPECT_EQ(rig.get("VW0"), 3);
}

TEST(Interrupt, EdgesOfInputsAreEvents) {
  Rig rig("LD SM0.1\nATCH 0, 0\nATCH 1, 7\nENI\nMEND\nINT 0\nINCW VW0\nRETI\nINT 1\nINCW VW2\nRETI\n");
  rig.scans(1);
  for (const int level : {1, 0, 1}) {
    rig.set("I0.0", level);
    rig.set("I0.3", level);
    rig.scans(2);
  }
  EXPECT_EQ(rig.get("VW0"), 2);  // rising edges of I0.0
  EXPECT_EQ(rig.get("VW2"), 1);  // falling edge of I0.3
}

TEST(Interrupt, TimerThirtyTwoRaisesEventTwentyOneWhenItReachesThePreset) {
  Rig rig("LD SM0.1\nATCH 0, 21\nENI\nLDN M0.0\nTON T32, +25\nMEND\nINT 0\nINCW VW0\nS M0.0, 1\nRETI\n");
  rig.scans(2);
  EXPECT_EQ(rig.get("VW0"), 0);
  rig.scans(1);  // 25 ms
  EXPECT_EQ(rig.get("VW0"), 1);
  EXPECT_EQ(rig.get("T32"), 1);
  rig.scans(5);
  EXPECT_EQ(rig.get("VW0"), 1);
}

TEST(Interrupt, StimulusEventsRunInFrontOfTheProgram) {
  Rig rig("LD SM0.1\nATCH 0, 12\nENI\nLD M0.0\n= Q0.0\nMEND\nINT 0\nS M0.0, 1\nRETI\n");
  rig.scans(1);
  rig.simulator->scan({.events = {12}});
  EXPECT_EQ(rig.get("Q0.0"), 1);
}

TEST(Interrupt, StackAccumulatorsAndStatusAreRestored) {
  // The loop is long enough for the 1 ms interrupt to come in between (001:5430).
  Rig rig(
      "LD SM0.1\nMOVB 1, SMB34\nATCH 0, 10\nENI\n"
      "LD SM0.0\nMOVD 7, AC0\nFOR VW0, +1, +200\nLD SM0.0\nINCW VW2\nNEXT\nLD SM0.0\nMOVD AC0, VD10\nMEND\n"
      "INT 0\nMOVD 99, AC0\nINCW VW4\nLDN SM0.0\nRETI\n");
  rig.scans(2);
  EXPECT_GT(rig.get("VW4"), 2);
  EXPECT_EQ(rig.get("VD10"), 7);
  EXPECT_EQ(rig.get("VW2"), 400);
}

// A routine that lasts longer than the period of another event is not interrupted by it (001:5480).
TEST(Interrupt, RoutinesDoNotNest) {
  Rig rig(
      "LD SM0.1\nMOVB 20, SMB34\nMOVB 21, SMB35\nATCH 0, 10\nATCH 1, 11\nENI\nMEND\n"
      "INT 0\nS M0.0, 1\nFOR VW0, +1, +100\nLD SM0.0\nINCW VW2\nNEXT\nR M0.0, 1\nRETI\n"
      "INT 1\nINCW VW6\nLD M0.0\nS M1.0, 1\nRETI\n");
  rig.scans(4);
  EXPECT_GE(rig.get("VW2"), 100);
  EXPECT_GE(rig.get("VW6"), 1);
  EXPECT_EQ(rig.get("M1.0"), 0);
}

TEST(Interrupt, StopInARoutineCompletesTheScanAndDropsTheQueue) {
  Rig rig(
      "LD SM0.1\nATCH 0, 0\nATCH 1, 2\nENI\nLD SM0.0\nINCW VW0\nMEND\n"
      "INT 0\nLD SM0.0\nSTOP\nINCW VW2\nRETI\nINT 1\nINCW VW4\nRETI\n");
  rig.scans(1);
  rig.set("I0.0", 1);
  rig.set("I0.1", 1);
  rig.scans(1);
  EXPECT_EQ(rig.get("VW0"), 2);  // the rest of the scan ran (001:5695)
  EXPECT_EQ(rig.get("VW2"), 0);  // the routine ended at once
  EXPECT_EQ(rig.get("VW4"), 0);  // the waiting interrupt was dropped
  EXPECT_FALSE(rig.simulator->isRunning());
  ASSERT_NE(rig.simulator->stoppedBy(), nullptr);
  EXPECT_EQ(rig.simulator->stoppedBy()->desc->stl, "STOP");
}

TEST(Interrupt, EnableInARoutineIsRunTimeErrorFour) {
  Rig rig("LD SM0.1\nATCH 0, 0\nENI\nMEND\nINT 0\nDISI\nRETI\n");
  rig.scans(1);
  rig.set("I0.0", 1);
  rig.scans(1);
  EXPECT_TRUE(rig.simulator->errors().has(Hazard::NotInInterrupt));
  EXPECT_EQ(rig.get("SM4.3"), 1);
  EXPECT_EQ(rig.get("SM4.4"), 1);
}

}  // namespace
}  // namespace rungproof
