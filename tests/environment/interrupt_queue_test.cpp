// Interrupts as proofs see them: any number of events at any place, in any order of arrival; what comes while
// interrupts are disabled waits; a detached event may still wait; a queue overflows (001:5333-5374, 001:5480-5500).
#include "interrupt_program.hpp"

namespace rungproof::test {
namespace {

TEST(InterruptQueueProof, EventsComeMoreThanOnceInAScan) {
  // Four edges of I0.0 behind the ENI of one scan count to four.
  EXPECT_EQ(verdict("prove once: prev(once(I0.0)) and not first_scan or MB1 <= 1", "LD SM0.1;ATCH INT_0,0;LD I0.0;ENI",
                    {"LD SM0.0;INCB MB1"}),
            Outcome::Violated);
  // A falling edge, a counter and a character do so too.
  EXPECT_EQ(verdict("reach two: first_scan and MB1 = 2", "LD SM0.1;ATCH INT_0,1;ENI", {"LD SM0.0;INCB MB1"}),
            Outcome::Reachable);
  EXPECT_EQ(verdict("reach two: first_scan and MB1 = 2", "LD SM0.1;MOVB 16#F8,SMB37;HDEF 0,0;ATCH INT_0,12;ENI;HSC 0",
                    {"LD SM0.0;INCB MB1"}),
            Outcome::Reachable);
  EXPECT_EQ(
      verdict("reach two: first_scan and MB1 = 2", "LD SM0.1;MOVB 9,SMB30;ATCH INT_0,8;ENI", {"LD SM0.0;INCB MB1"}),
      Outcome::Reachable);
}

// The second of two events at one place finds M1.0 on and clears M0.1, which nothing in the routine looks at before.
TEST(InterruptQueueProof, WhatIsWrittenUnreadMayChangeAgain) {
  const std::string main = "LD SM0.1;ATCH INT_0,0;ENI;LD I0.5;= M0.0";
  const std::vector<std::string> edge = {"LD M0.0;AN M1.0;= M0.1;LD M0.0;= M1.0;LD M0.1;S M0.3,1"};
  EXPECT_EQ(verdict("prove kept: not (first_scan and M1.0 and not M0.1 and M0.3)", main, edge), Outcome::Violated);
  const std::vector<std::string> word = {"LD M0.0;MOVW VW10,VW12;MOVW 5,VW10;LDW= VW12,0;S M0.3,1"};
  EXPECT_EQ(verdict("prove kept: not (first_scan and VW12 = 5 and M0.3)", main, word), Outcome::Violated);
}

TEST(InterruptQueueProof, EventsWaitWhileInterruptsAreDisabled) {
  // Both that waited run between ENI and the move (001:5372).
  EXPECT_EQ(verdict("reach two: MB2 = 2", "LD SM0.1;ATCH INT_0,0;ENI;LD SM0.0;DISI;MOVB 0,MB1;ENI;MOVB MB1,MB2",
                    {"LD SM0.0;INCB MB1"}),
            Outcome::Reachable);
  // Between DISI and ENI none runs (001:5333).
  EXPECT_EQ(verdict("prove still: MB2 = 0", "LD SM0.1;ATCH INT_0,0;ENI;LD SM0.0;DISI;MOVB 0,MB1;MOVB MB1,MB2;ENI",
                    {"LD SM0.0;INCB MB1"}),
            Outcome::Proved);
  EXPECT_EQ(verdict("prove still: M0.0 implies once(I0.0)", "LD SM0.1;ATCH INT_0,2;LD I0.0;ENI;LDN I0.0;DISI",
                    {"LD SM0.0;S M0.0,1"}),
            Outcome::Proved);
  // DISI in a subroutine counts for all (it is one global enable).
  EXPECT_EQ(verdict("reach late: M0.0 and not I0.0", "LD SM0.1;ATCH INT_0,2;LD I0.0;ENI;LDN I0.0;DISI",
                    {"LD SM0.0;S M0.0,1"}),
            Outcome::Reachable);
}

TEST(InterruptQueueProof, WithoutEnableNoRoutineRuns) {
  EXPECT_EQ(verdict("prove safe: never M0.0", "LD SM0.1;ATCH INT_0,0", {"LD SM0.0;S M0.0,1"}), Outcome::Proved);
  EXPECT_EQ(verdict("prove safe: never M0.0", "LD SM0.1;MOVB 10,SMB34;ATCH INT_0,10", {"LD SM0.0;S M0.0,1"}),
            Outcome::Proved);
  EXPECT_EQ(verdict("prove safe: never M0.0", "LD SM0.1;ATCH INT_0,0;ENI;DISI;LD I0.0;= Q0.0", {"LD Q0.0;S M0.0,1"}),
            Outcome::Proved);
  EXPECT_EQ(verdict("reach run: M0.0", "LD SM0.1;ATCH INT_0,0;LD I0.5;ENI", {"LD SM0.0;S M0.0,1"}), Outcome::Reachable);
}

TEST(InterruptQueueProof, ArrivalDecidesTheOrder) {
  const std::vector<std::string> routines = {"LD M0.1;S M0.0,1", "LD SM0.0;S M0.1,1"};
  const std::string main = "LD SM0.1;ATCH INT_0,0;ATCH INT_1,2;ENI;LD SM0.0;R M0.0,2";
  EXPECT_EQ(verdict("reach second: M0.0", main, routines), Outcome::Reachable);  // event 2, then event 0
  // An event of a lower group that came before one of a higher group.
  EXPECT_EQ(
      verdict("reach second: M0.0", "LD SM0.1;MOVB 9,SMB30;ATCH INT_0,8;ATCH INT_1,2;ENI;LD SM0.0;R M0.0,2", routines),
      Outcome::Reachable);
  EXPECT_EQ(
      verdict("reach second: M0.0", "LD SM0.1;MOVB 5,SMB34;ATCH INT_0,0;ATCH INT_1,10;ENI;LD SM0.0;R M0.0,2", routines),
      Outcome::Reachable);
  // Without the other event it is not reached.
  EXPECT_EQ(verdict("reach second: M0.0", "LD SM0.1;ATCH INT_0,0;ENI;LD SM0.0;R M0.0,2", routines),
            Outcome::Unreachable);
}

TEST(InterruptQueueProof, ManyRunsKeepWhatEachRunKeeps) {
  // However often it comes: a counter that stops at 20 stays at most 20.
  EXPECT_EQ(verdict("prove most: MB1 <= 20", "LD SM0.1;ATCH INT_0,0;ENI", {"LDB< MB1,20;INCB MB1"}), Outcome::Proved);
  EXPECT_EQ(verdict("prove most: VW0 <= 1000", "LD SM0.1;MOVB 5,SMB34;ATCH INT_0,10;ENI", {"LDW< VW0,1000;INCW VW0"}),
            Outcome::Proved);
  // 25 edges in one scan are possible, so that 21 are, without a stop.
  EXPECT_NE(verdict("prove most: MB1 <= 20", "LD SM0.1;ATCH INT_0,0;ENI", {"LD SM0.0;INCB MB1"}), Outcome::Proved);
  EXPECT_NE(verdict("prove most: first_scan implies MB1 <= 5", "LD SM0.1;ATCH INT_0,0;ENI", {"LD SM0.0;INCB MB1"}),
            Outcome::Proved);
  // Only set, never reset.
  EXPECT_EQ(verdict("prove latched: M0.0 unless I0.1", "LD SM0.1;ATCH INT_0,0;ATCH INT_1,2;ENI;LD I0.1;R M0.0,1",
                    {"LD M0.1;S M0.0,1", "LD SM0.0;INCB MB5;S M0.1,1"}),
            Outcome::Proved);
}

// Two edges count, the second never beyond the first; what one takes from a stock the other brings back.
TEST(InterruptQueueProof, ManyRunsKeepWhatTheyKeepOfTwoCells) {
  const std::string both = "LD SM0.1;ATCH INT_0,0;ATCH INT_1,2;ENI";
  const std::vector<std::string> follows = {"LDB< MB1,8;INCB MB1", "LDB< MB2,MB1;INCB MB2"};
  EXPECT_EQ(verdict("prove behind: MB2 <= MB1", both, follows), Outcome::Proved);
  EXPECT_EQ(verdict("reach level: MB1 = 5 and MB2 = 5", both, follows), Outcome::Reachable);
  EXPECT_EQ(verdict("prove before: MB1 <= MB2", both, follows), Outcome::Violated);
  const std::vector<std::string> stock = {"LDB> MB3,0;DECB MB3;INCB MB4"};
  const std::string ten = "LD SM0.1;MOVB 10,MB3;ATCH INT_0,0;ENI";
  EXPECT_EQ(verdict("prove sum: MB3 + MB4 = 10", ten, stock), Outcome::Proved);
  EXPECT_EQ(verdict("reach some: MB4 = 5", ten, stock), Outcome::Reachable);
  EXPECT_NE(verdict("prove sum: MB3 + MB4 = 10", ten, {"LD SM0.0;DECB MB3;LDB> MB3,0;INCB MB4"}), Outcome::Proved);
  // One routine takes, another brings back: the sum stays, and stays without a carry. The proof takes from 3 s on,
  // which a busy machine does not have: here nothing else may come out.
  const std::string shared = "LD SM0.1;MOVB 10,MB3;ATCH INT_0,0;ATCH INT_1,2;ENI";
  const std::vector<std::string> exchange = {"LDB> MB3,0;DECB MB3;INCB MB4", "LDB> MB4,0;DECB MB4;INCB MB3"};
  EXPECT_NE(verdict("prove sum: MB3 + MB4 = 10", shared, exchange), Outcome::Violated);
  EXPECT_NE(verdict("prove sum: MB3 + MB4 = 10", shared, {exchange[0], "LDB> MB4,0;INCB MB3;LDB> MB4,1;DECB MB4"}),
            Outcome::Proved);
  // Both counts rise together; a bit and its opposite; never two steps.
  EXPECT_EQ(verdict("prove even: MB1 = MB2", "LD SM0.1;ATCH INT_0,0;ENI", {"LDB< MB1,200;INCB MB1;INCB MB2"}),
            Outcome::Proved);
  EXPECT_EQ(verdict("prove one: not (M0.1 and M0.2)", both, {"LDN M0.2;S M0.1,1", "LDN M0.1;S M0.2,1"}),
            Outcome::Proved);
  // The limit is another cell, which the program writes and no routine does.
  const std::string limit = "LD SM0.1;MOVB 7,MB3;ATCH INT_0,0;ENI;LDB> MB1,3;MOVB 0,MB1";
  EXPECT_EQ(verdict("prove below: MB1 < MB3", limit, {"LD SM0.0;INCB MB1;LDB>= MB1,MB3;MOVB 0,MB1"}), Outcome::Proved);
  EXPECT_EQ(verdict("prove below: MB1 < MB3", limit, {"LD SM0.0;INCB MB1;LDB> MB1,MB3;MOVB 0,MB1"}), Outcome::Violated);
}

TEST(InterruptQueueProof, DetachedEventsThatWaitMayRunOrNot) {
  const std::vector<std::string> routine = {"LD SM0.0;S M0.0,1"};
  const std::string main = "LD SM0.1;ATCH INT_0,0;DTCH 0;ENI";
  EXPECT_EQ(verdict("reach run: M0.0", main, routine), Outcome::Reachable);  // 001:5357: CEVNT would clear it
  ProverOptions dropped = usualOptions();
  ASSERT_TRUE(dropped.choices.set("detached-events", "dropped"));
  EXPECT_EQ(verdict("reach run: M0.0", main, routine, 0, dropped), Outcome::Unreachable);
  EXPECT_EQ(verdict("reach run: M0.0", "LD SM0.1;ATCH INT_0,0;DTCH 0;CEVNT 0;ENI", routine), Outcome::Unreachable);
  EXPECT_EQ(verdict("reach run: M0.0", "LD SM0.1;DTCH 0;ENI", routine), Outcome::Unreachable);
  // Once it is detached and nothing waits, it does not come (001:5353).
  EXPECT_EQ(verdict("prove off: rises(M0.0) implies not prev(once(I0.0))",
                    "LD SM0.1;ATCH INT_0,2;ENI;LD I0.0;DTCH 2;LD I0.1;R M0.0,1", routine),
            Outcome::Proved);
  // A routine that detaches itself, with one more that came meanwhile.
  EXPECT_NE(verdict("prove single: MB1 <= 1", "LD SM0.1;ATCH INT_0,0;ENI", {"LD SM0.0;DTCH 0;INCB MB1"}),
            Outcome::Proved);
}

TEST(InterruptQueueProof, FullQueuesShowInTheRoutine) {
  // 17 events at once are one more than the queue of inputs and outputs holds (001:5488); the routine sees SM4.1.
  EXPECT_EQ(verdict("reach lost: M0.0", "LD SM0.1;ATCH INT_0,0;ENI", {"LD SM4.1;S M0.0,1"}), Outcome::Reachable);
  EXPECT_EQ(verdict("reach lost: M0.0", "LD SM0.1;MOVB 9,SMB30;ATCH INT_0,8;ENI", {"LD SM4.0;S M0.0,1"}),
            Outcome::Reachable);
  // Eight of event 10 wait (001:5489): the ninth is lost while interrupts are disabled.
  EXPECT_EQ(verdict("reach lost: M0.0", "LD SM0.1;MOVB 1,SMB34;ATCH INT_0,10;LD I0.0;ENI;LDN I0.0;DISI",
                    {"LD SM4.2;S M0.0,1"}),
            Outcome::Reachable);
  // Back in the main program they are cleared (001:5491): it never sees them while interrupts are enabled.
  EXPECT_EQ(verdict("prove cleared: never M0.0", "LD SM0.1;ATCH INT_0,0;ENI;LD SM4.1;S M0.0,1", {"LD SM0.0;INCB MB1"}),
            Outcome::Proved);
  // An event of another group does not fill the queue.
  EXPECT_NE(verdict("reach lost: M0.0", "LD SM0.1;ATCH INT_0,0;ENI", {"LD SM4.0;S M0.0,1"}), Outcome::Reachable);
}

TEST(InterruptQueueProof, RoutinesOfAllKinds) {
  // CRETI leaves the routine: what stands behind it needs the other branch.
  EXPECT_EQ(verdict("prove left: never Q0.0 and Q0.1", "LD SM0.1;ATCH INT_0,0;ENI;LD SM0.0;R Q0.0,2",
                    {"LD I0.0;S Q0.0,1;CRETI;LD SM0.0;S Q0.1,1"}),
            Outcome::Proved);
  EXPECT_EQ(verdict("prove frozen: prev(MB1 = 0) and M0.1 and prev(M0.1) implies MB1 = 0",
                    "LD SM0.1;ATCH INT_0,2;ENI;LD I0.0;S M0.1,1", {"LD M0.1;CRETI;LD SM0.0;INCB MB1"}),
            Outcome::Proved);
  // A routine that attaches another one to its own event.
  EXPECT_EQ(verdict("reach second: M0.1", "LD SM0.1;ATCH INT_0,0;ENI", {"LD SM0.0;ATCH INT_1,0", "LD SM0.0;S M0.1,1"}),
            Outcome::Reachable);
  // One routine for two events.
  EXPECT_EQ(
      verdict("reach two: first_scan and MB1 = 2", "LD SM0.1;ATCH INT_0,0;ATCH INT_0,2;ENI", {"LD SM0.0;INCB MB1"}),
      Outcome::Reachable);
}

}  // namespace
}  // namespace rungproof::test
