// STL networks as drawings: every shape of ladder and FBD, and the reasons of networks that have none. Expected
// drawings follow from what each stack instruction does (001:2825-2872).
#include <gtest/gtest.h>

#include "analysis/flow/facts.hpp"
#include "analysis/rule.hpp"
#include "frontend/input/project.hpp"
#include "tests/drawing/networks.hpp"

namespace rungproof::testing {
namespace {

std::string ladder(std::string_view statements) { return raised(statements, Form::Ladder); }
std::string fbd(std::string_view statements) { return raised(statements, Form::Fbd); }

TEST(RaiseLadder, ContactsInSeriesFeedEachOther) {
  EXPECT_EQ(ladder("LD I0.0; AN I0.1; = Q0.0"), "1 LD I0.0(0); 2 LDN I0.1(1); 3 = Q0.0(2)");
}

TEST(RaiseLadder, ParallelContactsMeetInOneOr) {
  EXPECT_EQ(ladder("LD I0.0; O I0.1; ON I0.2; A I0.3; = Q0.0"),
            "1 LD I0.0(0); 2 LD I0.1(0); 3 LDN I0.2(0); 4 OR(1,2,3); 5 LD I0.3(4); 6 = Q0.0(5)");
}

TEST(RaiseLadder, BranchOfSeveralContacts) {
  EXPECT_EQ(ladder("LD I0.0; LD I0.1; A I0.2; OLD; = Q0.0"),
            "1 LD I0.0(0); 2 LD I0.1(0); 3 LD I0.2(2); 4 OR(1,3); 5 = Q0.0(4)");
}

TEST(RaiseLadder, AGroupInSeriesBeginsBehindWhatIsOnItsLeft) {
  EXPECT_EQ(ladder("LD I0.0; LD I0.1; O I0.2; ALD; = Q0.0"),
            "1 LD I0.0(0); 2 LD I0.1(1); 3 LD I0.2(1); 4 OR(2,3); 5 = Q0.0(4)");
}

TEST(RaiseLadder, NestedGroups) {  // I0.0 and (I0.1 or (I0.2 and (I0.3 or I0.4)))
  EXPECT_EQ(ladder("LD I0.0; LD I0.1; LD I0.2; LD I0.3; O I0.4; ALD; OLD; ALD; = Q0.0"),
            "1 LD I0.0(0); 2 LD I0.1(1); 3 LD I0.2(1); 4 LD I0.3(3); 5 LD I0.4(3); 6 OR(4,5); 7 OR(2,6); 8 = Q0.0(7)");
}

TEST(RaiseLadder, SideBranchesOfTheManualsExample) {  // 000:795-810
  EXPECT_EQ(
      ladder("LD I0.0; LPS; LD I0.5; O I0.6; ALD; = Q7.0; LRD; LD I2.1; O I1.3; ALD; = Q6.0; LPP; A I1.0; = Q3.0"),
      "1 LD I0.0(0); 2 LD I0.5(1); 3 LD I0.6(1); 4 OR(2,3); 5 = Q7.0(4); 6 LD I2.1(1); 7 LD I1.3(1); 8 OR(6,7); "
      "9 = Q6.0(8); 10 LD I1.0(1); 11 = Q3.0(10)");
}

TEST(RaiseLadder, CoilsAboveOneAnotherAndNot) {  // 001:2768
  EXPECT_EQ(ladder("LD I0.0; A I0.1; = Q0.0; NOT; = Q0.1"),
            "1 LD I0.0(0); 2 LD I0.1(1); 3 = Q0.0(2); 4 NOT(2); 5 = Q0.1(4)");
}

TEST(RaiseLadder, BoxesChainThroughEno) {
  EXPECT_EQ(ladder("LD I0.0; MOVW 1, VW0; AENO; MOVW 2, VW2"), "1 LD I0.0(0); 2 MOVW 1, VW0(1); 3 MOVW 2, VW2(2)");
  EXPECT_EQ(ladder("LD I0.0; MOVW 1, VW0; MOVW 2, VW2"), "1 LD I0.0(0); 2 MOVW 1, VW0(1); 3 MOVW 2, VW2(1)");
}

TEST(RaiseLadder, CounterTakesItsFirstInputFromBelow) {  // count input on the second level, reset on top (001:3994)
  EXPECT_EQ(ladder("LD I0.0; LD I0.1; A I0.2; CTU C1, +5"),
            "1 LD I0.0(0); 2 LD I0.1(0); 3 LD I0.2(2); 4 CTU C1, +5(1,3)");
}

TEST(RaiseLadder, TimerAndWhatFollowsBesideIt) {  // 001:8911
  EXPECT_EQ(ladder("LD Q0.2; A Q0.4; TON T33, +200; AN T33; = Q0.3"),
            "1 LD Q0.2(0); 2 LD Q0.4(1); 3 TON T33, +200(2); 4 LDN T33(2); 5 = Q0.3(4)");
}

TEST(RaiseLadder, CallWithFlowInputs) {  // 001:6809
  EXPECT_EQ(ladder("LD I0.0; = L60.0; LD I0.1; = L63.7; LD I0.2; EU; = L63.6; LD L60.0; CALL SBR0, L63.7, L63.6, Q0.0"),
            "1 LD I0.0(0); 2 LD I0.1(0); 3 LD I0.2(0); 4 EU(3); 5 CALL 0, ????, ????, Q0.0(1,2,4)");
}

TEST(RaiseLadder, HeadingsStandAlone) {
  EXPECT_EQ(ladder("LSCR S0.1"), "1 LSCR S0.1()");
  EXPECT_EQ(ladder("LD I0.0; SCRT S0.2"), "1 LD I0.0(0); 2 SCRT S0.2(1)");
}

TEST(RaiseFbd, GatesOnOperands) {
  EXPECT_EQ(fbd("LD I0.0; AN I0.1; A I0.2; LD I0.3; A I0.4; OLD; = Q0.0"),
            "1 LD I0.0(0); 2 LDN I0.1(0); 3 LD I0.2(0); 4 AND(1,2,3); 5 LD I0.3(0); 6 LD I0.4(0); 7 AND(5,6); 8 "
            "OR(4,7); 9 = Q0.0(8)");
}

TEST(RaiseFbd, NotIsACircleAtThePin) {
  EXPECT_EQ(fbd("LD I0.0; A I0.1; = Q0.0; NOT; = Q0.1"),
            "1 LD I0.0(0); 2 LD I0.1(0); 3 AND(1,2); 4 = Q0.0(3); 5 = Q0.1(~3)");
}

TEST(RaiseFbd, EdgesInsideAGroup) {  // a ladder cannot show it: the edge would see I0.0 too
  EXPECT_EQ(fbd("LD I0.0; LD I0.1; EU; ALD; = Q0.0"), "1 LD I0.0(0); 2 LD I0.1(0); 3 EU(2); 4 AND(1,3); 5 = Q0.0(4)");
  EXPECT_TRUE(ladder("LD I0.0; LD I0.1; EU; ALD; = Q0.0").starts_with("refused: ALD puts into series"));
}

TEST(RaiseFbd, GatesHaveAtMost32Inputs) {  // 001:2268
  std::string statements = "LD M0.0";
  for (int i = 1; i < 40; ++i) statements += "; A M" + std::to_string(i / 8) + "." + std::to_string(i % 8);
  const Program program = programOf(statements + "; = Q0.0");
  const Raised result = raise(onlyNetwork(program), Form::Fbd);
  ASSERT_TRUE(result.drawing);
  std::size_t gates = 0, pins = 0;
  for (const Element& element : result.drawing->elements) {
    if (element.shape != Shape::And) continue;
    ++gates;
    pins += element.inputs.size();
    EXPECT_LE(element.inputs.size(), 32U);
  }
  EXPECT_EQ(gates, 2U);
  EXPECT_EQ(pins, 41U);  // 40 operands and the wire between the two gates
}

TEST(RaiseReason, SaysWhatHasNoPicture) {
  const auto both = [](std::string_view statements) {
    EXPECT_TRUE(ladder(statements).starts_with("refused: ")) << statements;
    return fbd(statements);
  };
  EXPECT_EQ(both("LD I0.0; = Q0.0; LD I0.1; = Q0.1"), "refused: LD I0.1 begins a second rung in the network");
  EXPECT_EQ(both("A I0.0; = Q0.0"), "refused: A I0.0 takes a value that this network has not loaded");
  EXPECT_EQ(both("LD I0.0; LD I0.1; LD I0.2; LD I0.3; LD I0.4; LD I0.5; LD I0.6; LD I0.7; LD I1.0; LD I1.1; "
                 "OLD; OLD; OLD; OLD; OLD; OLD; OLD; OLD; OLD; = Q0.0"),
            "refused: OLD takes a value that was pushed out of the logic stack");
  EXPECT_EQ(both("LD I0.0; LDS 0; = Q0.0"), "refused: LDS 0 has no picture in LAD or FBD");
  EXPECT_EQ(both("LD I0.0; LD I0.1; = Q0.0"), "refused: the branch of I0.0 ends without a coil or box");
  EXPECT_EQ(both("LD I0.0; AENO; = Q0.0"), "refused: AENO stands behind no box with ENO");
  EXPECT_EQ(both("LD I0.0; MOVB 1, VB0; A I0.1; AENO; = Q0.0"),
            "refused: AENO joins ENO to the power flow of another circuit");
  EXPECT_EQ(both("LBL 1; LD I0.0; = Q0.0"), "refused: LD I0.0 begins a second rung in the network");
}

TEST(RaiseReason, ABranchCannotJoinBehindAnOutput) {
  const auto both = [](std::string_view statements) {
    EXPECT_TRUE(ladder(statements).starts_with("refused: ")) << statements;
    return fbd(statements);
  };
  const std::string reason = "refused: OLD joins a branch behind a point that also feeds something else";
  EXPECT_EQ(both("LD I2.0; LPS; A I2.1; = Q1.0; LRD; A I2.2; = Q1.1; LPP; A I2.3; = Q1.2; LD I2.4; OLD; = Q1.3"),
            reason);
  EXPECT_EQ(both("LD I0.0; = Q0.0; LD I0.1; OLD; = Q0.1"), reason);
  EXPECT_EQ(both("LD I0.0; MOVB 1, VB0; LD I0.1; A I0.2; OLD; = Q0.1"), reason);
  // A load behind an output begins a second rung; a contact that only joins begins none, and FBD shows it.
  EXPECT_TRUE(fbd("LD I0.0; = Q0.0; O I0.1; = Q0.1").starts_with("1 LD I0.0(0); 2 = Q0.0(1); "));
}

TEST(RaiseLoop, BoxesBehindForHaveItsPower) {
  // The top is 1 in front of the loop and in each of its rounds (001:5770): a second box beside FOR has that power.
  EXPECT_EQ(ladder("LD SM0.0; FOR VW0, 1, 3; INCB VB4"), "1 LD SM0.0(0); 2 FOR VW0, 1, 3(1); 3 INCB VB4(1)");
  EXPECT_EQ(ladder("LD I0.0; FOR VW0, 1, 3; A I0.1; INCB VB4"),
            "1 LD I0.0(0); 2 FOR VW0, 1, 3(1); 3 LD I0.1(1); 4 INCB VB4(3)");
  EXPECT_EQ(fbd("LD SM0.0; FOR VW0, 1, 3; INCB VB4; DECB VB5"),
            "1 LD SM0.0(0); 2 FOR VW0, 1, 3(1); 3 INCB VB4(1); 4 DECB VB5(1)");
  for (const Form form : {Form::Ladder, Form::Fbd}) {
    EXPECT_EQ(roundTrip("LD SM0.0; FOR VW0, 1, 3; INCB VB4", form), "LD SM0.0; FOR VW0, 1, 3; INCB VB4");
    EXPECT_EQ(roundTrip("LD I0.0; FOR VW0, 1, 3; A I0.1; INCB VB4", form), "LD I0.0; FOR VW0, 1, 3; A I0.1; INCB VB4");
  }
}

TEST(RaiseLoop, WhatEachRoundWouldTakeAgainHasNoPicture) {
  EXPECT_EQ(ladder("LD I0.0; LPS; FOR VW0, 1, 3; LPP; INCB VB4"),
            "refused: LPP takes a value from in front of FOR in every round");
  EXPECT_EQ(ladder("LD I0.0; LD I0.1; FOR VW0, 1, 3; OLD; INCB VB4"),
            "refused: OLD takes a value from in front of FOR in every round");
  EXPECT_EQ(ladder("LD SM0.0; FOR VW0, 1, 3; INCB VB4; NEXT"), "refused: NEXT begins a second rung in the network");
  EXPECT_EQ(ladder("LD SM0.0; FOR VW0, 1, 3; LD I0.1; INCB VB4"),
            "refused: LD I0.1 begins a second rung in the network");
}

TEST(RaiseReason, CallWithFlowInputsNeedsTheEditorsForm) {  // 001:6808: plain bits are STL only, but then no flow input
  EXPECT_TRUE(
      ladder("LD I0.0; = L60.0; LD I0.1; = L63.6; LD L60.0; CALL SBR0, L63.6, I0.2, Q0.0").starts_with("refused: "));
}

TEST(RaiseRule, SpeaksOncePerNetworkAndOnlyWithoutAnyPicture) {
  const Program program = readText(
      "test.awl",
      "Network 1\nLD I0.0\n= Q0.0\nLD I0.1\n= Q0.1\nLD I0.2\n= Q0.2\nNetwork 2\nLD I0.0\nLD I0.1\nEU\nALD\n= Q0.3\n",
      ReadOptions{});
  const Facts facts(program, {});
  const Rule* rule = ruleNamed("STK006");
  const RuleSettings settings;
  FindingSink sink(program, settings);
  sink.begin(*rule);
  rule->check(facts, sink);
  const std::vector<Finding> findings = sink.take();
  ASSERT_EQ(findings.size(), 1U);
  EXPECT_EQ(program.sources->position(findings[0].span).line, 4U);
}

}  // namespace
}  // namespace rungproof::testing
