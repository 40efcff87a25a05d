// Events come only when something causes them: timed events with their period, T32 and T96 when they reach their
// preset, ports, counters and pulse outputs when they are at work (001:3324, 001:4308, 001:4584, 001:5460-5476).
#include "interrupt_program.hpp"

namespace rungproof::test {
namespace {

const std::vector<std::string> sets = {"LD SM0.0;S M0.0,1"};
const std::vector<std::string> counts = {"LD SM0.0;INCB MB1"};

TEST(EventCause, TimedEventsKeepTheirPeriod) {
  const std::string main = "LD SM0.1;MOVB 20,SMB34;ATCH INT_0,10;ENI";
  // Scans of 10 ms: the first is too short. The second ends 20 ms after ATCH at most, the third 20 ms after it at
  // least.
  EXPECT_EQ(verdict("prove none: first_scan implies MB1 = 0", main, counts, 10), Outcome::Proved);
  EXPECT_EQ(verdict("prove one: prev(first_scan) and not first_scan implies MB1 <= 1", main, counts, 10),
            Outcome::Proved);
  EXPECT_EQ(verdict("prove due: prev(prev(first_scan)) and not first_scan and not prev(first_scan) implies MB1 = 1",
                    main, counts, 10),
            Outcome::Proved);
  EXPECT_EQ(verdict("reach not yet: MB1 = 0 and prev(first_scan) and not first_scan", main, counts, 10),
            Outcome::Reachable);
  EXPECT_EQ(verdict("reach early: MB1 = 1 and prev(first_scan) and not first_scan", main, counts, 10),
            Outcome::Reachable);
  EXPECT_EQ(verdict("reach three: first_scan and MB1 = 3", "LD SM0.1;MOVB 100,SMB34;ATCH INT_0,10;ENI", counts, 10),
            Outcome::Unreachable);
  EXPECT_EQ(verdict("prove none: first_scan implies MB1 = 0", "LD SM0.1;MOVB 20,SMB35;ATCH INT_0,11;ENI", counts, 10),
            Outcome::Proved);
  // A scan of 40 ms has two, but the first one less if ATCH comes late in it.
  EXPECT_EQ(verdict("prove two: not first_scan implies MB1 - prev(MB1) = 2", main, counts, 40), Outcome::Violated);
  EXPECT_EQ(verdict("prove two: first_scan implies MB1 <= 2", main, counts, 40), Outcome::Proved);
  EXPECT_EQ(verdict("reach one: first_scan and MB1 = 1", main, counts, 40), Outcome::Reachable);
  // A change of SMB34 counts from the next ATCH on (001:5472).
  EXPECT_EQ(verdict("prove none: first_scan implies MB1 = 0", "LD SM0.1;MOVB 20,SMB34;ATCH INT_0,10;ENI;MOVB 1,SMB34",
                    counts, 10),
            Outcome::Proved);
  // Attached anew in every scan of 10 ms, it never comes.
  EXPECT_EQ(verdict("prove none: MB1 = 0", "LD SM0.0;MOVB 30,SMB34;ATCH INT_0,10;ENI", counts, 10), Outcome::Proved);
}

TEST(EventCause, TimedEventsThatMeetDisabledInterruptsWait) {
  // Disabled for the first two scans of 10 ms. What waited runs in the third right behind ENI (001:5474): at most one,
  // because the second scan ends 20 ms after ATCH at most.
  const std::string main = "LD SM0.1;MOVB 20,SMB34;ATCH INT_0,10;LDW>= VW0,2;ENI;MOVB MB1,MB2;LDW< VW0,9;INCW VW0";
  EXPECT_EQ(verdict("prove one: VW0 = 3 implies MB2 <= 1", main, counts, 10), Outcome::Proved);
  EXPECT_EQ(verdict("reach one: VW0 = 3 and MB2 = 1", main, counts, 10), Outcome::Reachable);
  EXPECT_EQ(verdict("prove none: VW0 < 3 implies MB1 = 0", main, counts, 10), Outcome::Proved);
}

TEST(EventCause, TimersTellOfTheirPreset) {
  EXPECT_EQ(verdict("prove never: never M0.0", "LD SM0.1;ATCH INT_0,21;ENI", sets), Outcome::Proved);
  EXPECT_EQ(verdict("prove never: never M0.0", "LD SM0.1;ATCH INT_0,21;ENI;LD M5.0;TON T32,10", sets), Outcome::Proved);
  const std::string main = "LD SM0.1;ATCH INT_0,21;ENI;LD I0.0;TON T32,10";
  EXPECT_EQ(verdict("reach preset: M0.0", main, sets), Outcome::Reachable);
  EXPECT_EQ(verdict("prove late: first_scan implies not M0.0", main, sets, 9), Outcome::Proved);
  EXPECT_EQ(verdict("prove input: M0.0 implies once(I0.0)", main, sets), Outcome::Proved);
  // It comes by itself: started in the scan before, it has 10 ms in one of 20 ms.
  EXPECT_EQ(verdict("prove due: prev(I0.0) and I0.0 and not first_scan implies M0.0", main, sets, 20), Outcome::Proved);
  EXPECT_EQ(verdict("reach late: first_scan and I0.0 and not M0.0", main, sets, 20), Outcome::Reachable);
  EXPECT_EQ(verdict("reach preset: M0.0", "LD SM0.1;ATCH INT_0,22;ENI;LD I0.0;TON T96,10", sets), Outcome::Reachable);
  EXPECT_EQ(verdict("prove never: never M0.0", "LD SM0.1;ATCH INT_0,22;ENI;LD I0.0;TON T32,10", sets), Outcome::Proved);
  EXPECT_EQ(verdict("reach off delay: M0.0", "LD SM0.1;ATCH INT_0,21;ENI;LD I0.0;TOF T32,10", sets),
            Outcome::Reachable);
}

TEST(EventCause, PortsTellOfWhatTheyDo) {
  for (const int event : {9, 26, 23, 24}) {
    const std::string attach = "LD SM0.1;MOVB 9,SMB30;MOVB 9,SMB130;ATCH INT_0," + std::to_string(event) + ";ENI";
    EXPECT_EQ(verdict("prove never: never M0.0", attach, sets), Outcome::Proved) << event;
  }
  EXPECT_EQ(
      verdict("reach sent: M0.0", "LD SM0.1;MOVB 9,SMB30;MOVB 1,VB100;ATCH INT_0,9;ENI;LD I0.0;XMT VB100,0", sets),
      Outcome::Reachable);
  EXPECT_EQ(verdict("prove never: never M0.0",
                    "LD SM0.1;MOVB 9,SMB30;MOVB 1,VB100;ATCH INT_0,26;ENI;LD I0.0;XMT VB100,0", sets),
            Outcome::Proved);
  EXPECT_EQ(verdict("reach message: M0.0",
                    "LD SM0.1;MOVB 9,SMB30;MOVB 16#B0,SMB87;MOVB 10,SMB94;ATCH INT_0,23;ENI;LD I0.0;RCV VB100,0", sets),
            Outcome::Reachable);
  // Characters come in Freeport mode only (001:3324).
  EXPECT_EQ(verdict("prove never: never M0.0", "LD SM0.1;ATCH INT_0,8;ENI", sets), Outcome::Proved);
  EXPECT_EQ(verdict("reach character: M0.0", "LD SM0.1;MOVB 9,SMB30;ATCH INT_0,8;ENI", sets), Outcome::Reachable);
  EXPECT_EQ(verdict("prove never: never M0.0", "LD SM0.1;MOVB 9,SMB30;ATCH INT_0,25;ENI", sets), Outcome::Proved);
  // One character after the other, each with its own routine run, though the routine is the same when repeated.
  EXPECT_EQ(verdict("reach both: first_scan and M0.1 and M0.2", "LD SM0.1;MOVB 9,SMB30;ATCH INT_0,8;ENI",
                    {"LDB= SMB2,1;S M0.1,1;LDB= SMB2,2;S M0.2,1"}),
            Outcome::Reachable);
  // Two characters in one scan may differ (001:3324).
  EXPECT_EQ(verdict("reach other: first_scan and VB1 = 1 and VB2 = 2", "LD SM0.1;MOVB 9,SMB30;ATCH INT_0,8;ENI",
                    {"LD SM0.0;MOVB VB2,VB1;MOVB SMB2,VB2"}),
            Outcome::Reachable);
}

TEST(EventCause, CountersTellWhatTheirModeHas) {
  const auto with = [](int event, const std::string& definition) {
    return verdict("reach event: M0.0",
                   "LD SM0.1;MOVB 16#F8,SMB37;" + definition + "ATCH INT_0," + std::to_string(event) + ";ENI", sets);
  };
  EXPECT_EQ(with(12, ""), Outcome::Unreachable);
  EXPECT_EQ(with(12, "HDEF 0,0;"), Outcome::Unreachable);  // HSC has not started it
  EXPECT_EQ(with(12, "HDEF 0,0;HSC 0;"), Outcome::Reachable);
  EXPECT_EQ(with(27, "HDEF 0,0;HSC 0;"), Outcome::Unreachable);  // no direction from outside in mode 0
  EXPECT_EQ(with(27, "HDEF 0,3;HSC 0;"), Outcome::Reachable);
  EXPECT_EQ(with(28, "HDEF 0,3;HSC 0;"), Outcome::Unreachable);  // no reset input in mode 3
  EXPECT_EQ(with(28, "HDEF 0,4;HSC 0;"), Outcome::Reachable);
  EXPECT_EQ(with(29, "HDEF 0,0;HSC 0;"), Outcome::Unreachable);  // that is HSC4
}

TEST(EventCause, CountersStayAtZeroWithoutDefinition) {
  EXPECT_EQ(verdict("prove still: VD0 = 0", "LD SM0.0;MOVD HC0,VD0", {}), Outcome::Proved);
  EXPECT_EQ(verdict("prove still: VD0 = 0", "LD SM0.1;HDEF 1,0;LD SM0.0;MOVD HC0,VD0", {}), Outcome::Proved);
  EXPECT_EQ(verdict("prove still: not once(I1.0) implies VD0 = 0", "LD I1.0;HDEF 0,0;LD SM0.0;MOVD HC0,VD0", {}),
            Outcome::Proved);
  // Defined, but not started by HSC with bit 7 of SMB37 (001:4302).
  EXPECT_EQ(verdict("reach counts: VD0 = 5", "LD I1.0;HDEF 0,0;LD SM0.0;MOVD HC0,VD0", {}), Outcome::Unreachable);
  EXPECT_EQ(
      verdict("reach counts: VD0 = 5", "LD SM0.1;MOVB 16#F8,SMB37;LD I1.0;HDEF 0,0;HSC 0;LD SM0.0;MOVD HC0,VD0", {}),
      Outcome::Reachable);
}

TEST(EventCause, PulseOutputsTellOfTheEndOfATrain) {
  const std::string attach = "LD SM0.1;ATCH INT_0,19;ENI";
  EXPECT_EQ(verdict("prove never: never M0.0", attach, sets), Outcome::Proved);
  EXPECT_EQ(verdict("reach end: M0.0", attach + ";MOVB 16#85,SMB67;MOVW 500,SMW68;MOVD 4,SMD72;PLS 0", sets),
            Outcome::Reachable);
  EXPECT_EQ(verdict("prove never: never M0.0", attach + ";MOVB 16#D3,SMB67;MOVW 500,SMW68;MOVW 4,SMW70;PLS 0", sets),
            Outcome::Proved);  // pulse width modulation has no end
  EXPECT_EQ(verdict("prove never: never M0.0", attach + ";MOVB 16#85,SMB77;MOVW 500,SMW78;MOVD 4,SMD82;PLS 1", sets),
            Outcome::Proved);
}

TEST(EventCause, RoutinesMayStartPulses) {
  // The table of a profile, which the routine does not use, is asked for at a place that is not known.
  EXPECT_EQ(verdict("reach started: M0.0", "LD SM0.1;MOVB 16#85,SMB67;MOVW 100,SMW68;MOVD 1,SMD72;ATCH INT_0,0;ENI",
                    {"LD SM0.0;PLS 0;S M0.0,1"}),
            Outcome::Reachable);
}

TEST(EventCause, EdgesOfAnInputComeInTurn) {
  // Event 0 twice with no event 1 in between is no run that is shown.
  EXPECT_NE(verdict("reach twice: M0.1", "LD SM0.1;ATCH INT_0,0;ATCH INT_1,1;ENI",
                    {"LD M0.0;S M0.1,1;LD SM0.0;S M0.0,1", "LD SM0.0;R M0.0,1"}),
            Outcome::Reachable);
  // With the falling edge unobserved it may.
  EXPECT_EQ(verdict("reach twice: M0.1", "LD SM0.1;ATCH INT_0,0;ENI", {"LD M0.0;S M0.1,1;LD SM0.0;S M0.0,1"}),
            Outcome::Reachable);
  // The last edge tells the input: both followed since the first scan, no more than one of them in a scan.
  EXPECT_EQ(verdict("prove same: M0.0 and not first_scan and prev(M0.0) implies once(I0.0) or M0.0",
                    "LD SM0.1;ATCH INT_0,0;ATCH INT_1,1;ENI", {"LD SM0.0;S M0.0,1", "LD SM0.0;R M0.0,1"}),
            Outcome::Proved);
}

TEST(EventCause, TheClockShowsDatesAndTimes) {
  EXPECT_EQ(verdict("reach no hour: VB3 = 16#4B", "LD SM0.0;TODR VB0", {}), Outcome::Unreachable);
  EXPECT_EQ(verdict("reach hour: VB3 = 16#23", "LD SM0.0;TODR VB0", {}), Outcome::Reachable);
  EXPECT_EQ(verdict("reach no hour: VB3 = 16#24", "LD SM0.0;TODR VB0", {}), Outcome::Unreachable);
  EXPECT_EQ(verdict("reach no month: VB1 = 0 and M0.0", "LD SM0.0;TODR VB0;S M0.0,1", {}), Outcome::Unreachable);
  EXPECT_EQ(verdict("reach no weekday: VB7 = 8", "LD SM0.0;TODRX VB0", {}), Outcome::Unreachable);
  // A TODW that takes any data (clock-data = any, 001:2924) may have set such an hour.
  EXPECT_EQ(verdict("reach hour: VB3 = 16#4B", "LD SM0.0;TODR VB0;LD I0.0;TODW VB20", {}), Outcome::Reachable);
}

}  // namespace
}  // namespace rungproof::test
