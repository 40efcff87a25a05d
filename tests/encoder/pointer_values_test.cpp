// Pointers whose targets follow from the transition relation, and one whose targets do not.
#include "analysis/encoding/pointer_values.hpp"

#include <gtest/gtest.h>

#include "analysis/encoding/assumed.hpp"
#include "analysis/encoding/encoder.hpp"
#include "tests/encoder/statements.hpp"

namespace rungproof {
namespace {

/// Cell x of 32 bits with that initial value and next function; the values it can take.
ValueSet closed(Graph& graph, Node x, std::uint64_t init, Node next) {
  TransitionSystem system;
  system.graph = &graph;
  system.states = {{x, graph.constantNode(init, 32), next}};
  VariableValues values;
  VariableValues later;
  closeValues(system, {x}, values, later);
  return values.at(x);
}

TEST(PointerValues, WalkThatStartsAgainHasItsExactSteps) {
  // x + 2 until 10, then 4 again, from 4: the values 4, 6, 8, 10.
  Graph g;
  const Node x = g.variable("x", 32, true);
  const Node atEnd = g.make(Op::Equal, 1, x, g.constantNode(10, 32));
  const Node next = g.make(Op::Ite, 32, atEnd, g.constantNode(4, 32), g.make(Op::Add, 32, x, g.constantNode(2, 32)));
  EXPECT_EQ(closed(g, x, 4, next).values(), (std::vector<std::uint64_t>{4, 6, 8, 10}));
}

TEST(PointerValues, CounterThatLimitsTheWalkIsFollowedWithIt) {
  // Sometimes x + 2 and n + 1; when n would be 8, x is 40 and n is 0 again: 40, 42 .. 54.
  Graph g;
  const Node x = g.variable("VD0", 32, true), n = g.variable("VW16", 16, true), steps = g.variable("I0.0", 1, false);
  const Node more = g.make(Op::Add, 16, n, g.constantNode(1, 16));
  const Node ends = g.make(Op::Sle, 1, g.constantNode(8, 16), more);
  const Node further = g.make(Op::Ite, 32, ends, g.constantNode(40, 32), g.make(Op::Add, 32, x, g.constantNode(2, 32)));
  TransitionSystem system;
  system.graph = &g;
  system.states = {{x, g.constantNode(40, 32), g.make(Op::Ite, 32, steps, further, x)},
                   {n, g.constantNode(0, 16),
                    g.make(Op::Ite, 16, steps, g.make(Op::Ite, 16, ends, g.constantNode(0, 16), more), n)}};
  system.inputs = {steps};
  VariableValues values;
  VariableValues later;
  closeValues(system, {x}, values, later);
  EXPECT_EQ(values.at(x).values(), (std::vector<std::uint64_t>{40, 42, 44, 46, 48, 50, 52, 54}));
}

TEST(PointerValues, WalkWithoutEndHasNoList) {
  Graph g;
  const Node x = g.variable("x", 32, true);
  EXPECT_FALSE(closed(g, x, 0, g.make(Op::Add, 32, x, g.constantNode(1, 32))).isListed());
}

TEST(PointerValues, GuardNarrowsWhatItCompares) {
  // Signed 0 <= i and i < 3 leave 0, 1, 2, so 100 + 2 i is 100, 102 or 104.
  Graph g;
  const Node i = g.variable("i", 32, false);
  const Node low = g.make(Op::Sle, 1, g.constantNode(0, 32), i), high = g.make(Op::Slt, 1, i, g.constantNode(3, 32));
  const Node address = g.make(Op::Add, 32, g.make(Op::Mul, 32, i, g.constantNode(2, 32)), g.constantNode(100, 32));
  const VariableValues none;
  ValueEvaluator evaluator(g, none);
  const Node guard = g.make(Op::And, 1, low, high);
  EXPECT_EQ(evaluator.valuesOf(address, guard, pointerValueLimit).values(),
            (std::vector<std::uint64_t>{100, 102, 104}));
}

TEST(PointerValues, ScaledIndexIsResolvedWhereComparisonsBoundIt) {
  // The index comes from outside: 0 to 9 by two comparisons, 0 to 15 by a mask, 0 to 255 by its width.
  for (const char* body :
       {"MOVW VW20, VW42\n+D VD40, VD40\n+D VD40, VD0\nLD I0.0\nAW>= VW20, 0\nAW<= VW20, 9\nMOVW *VD0, VW30",
        "MOVW VW20, VW42\nSLD VD40, 1\n+D VD40, VD0\nLD I0.0\nAW> VW20, -1\nAW< VW20, 10\nMOVW *VD0, VW30",
        "MOVW VW20, VW42\nMUL 2, VD40\n+D VD40, VD0\nLDW>= VW20, 0\nAW<= VW20, 9\nMOVW *VD0, VW30",
        "MOVW VW20, VW42\nANDW 15, VW42\n+D VD40, VD0\n+D VD40, VD0\nMOVW *VD0, VW30",
        "MOVW 0, VW42\nMOVB VB20, VB43\n+D VD40, VD0\n+D VD40, VD0\nMOVW *VD0, VW30"}) {
    const Program program = programOf(std::string("LD SM0.0\nMOVD &VB100, VD0\nMOVD 0, VD40\n") + body);
    EncoderOptions options;
    options.externals = {{Area::V, 20, 21}};
    EXPECT_TRUE(EncodedScan(program, options).approximations().empty()) << body;
  }
}

// Rows of 48 bits from bit 16 on, and a byte of such a row: the products have gaps that bounds do not tell.
TEST(PointerValues, IndexTimesTheSizeOfARowHasOneValueForEachRow) {
  Graph g;
  const Node i = g.variable("i", 32, false), j = g.variable("j", 32, false), c = g.variable("c", 1, false);
  const auto number = [&](std::uint64_t value) { return g.constantNode(value, 32); };
  const auto below = [&](Node n, std::uint64_t mask) { return g.make(Op::And, 32, n, number(mask)); };
  const Node index = g.make(Op::Ite, 32, c, below(i, 3), j);
  const Node row = g.make(Op::Add, 32, g.make(Op::Mul, 32, index, number(48)), number(16));
  const Node inRow = g.make(Op::Add, 32, row, g.make(Op::Shl, 32, below(j, 1), number(3)));
  const VariableValues none;
  const ValueSet rows = ValueEvaluator(g, none).valuesOf(row, c, pointerValueLimit);
  ASSERT_TRUE(rows.isListed());
  EXPECT_EQ(rows.values(), (std::vector<std::uint64_t>{16, 64, 112, 160}));
  const ValueSet bytes = ValueEvaluator(g, none).valuesOf(inRow, c, pointerValueLimit);
  ASSERT_TRUE(bytes.isListed());
  EXPECT_EQ(bytes.values(), (std::vector<std::uint64_t>{16, 24, 64, 72, 112, 120, 160, 168}));
}

TEST(PointerValues, BoundsOfANumberBoundTheBytesThatItIsJoinedFrom) {
  // Signed 0 <= ab and ab <= 9 leave a = 0 and b = 0 to 9.
  Graph g;
  const Node a = g.variable("a", 8, false), b = g.variable("b", 8, false);
  const Node ab = g.make(Op::Concat, 16, a, b);
  const Node guard = g.make(Op::And, 1, g.make(Op::Not, 1, g.make(Op::Slt, 1, ab, g.constantNode(0, 16))),
                            g.make(Op::Sle, 1, ab, g.constantNode(9, 16)));
  const VariableValues none;
  const Node scaled =
      g.make(Op::Concat, 20, g.make(Op::Concat, 15, g.make(Op::Extract, 7, a), b), g.constantNode(0, 5));
  const ValueSet values = ValueEvaluator(g, none).valuesOf(scaled, guard, pointerValueLimit);
  ASSERT_TRUE(values.isListed());
  EXPECT_EQ(values.values(), (std::vector<std::uint64_t>{0, 32, 64, 96, 128, 160, 192, 224, 256, 288}));
}

TEST(PointerValues, WhatTheGuardDecidesIsChosenInItsOtherParts) {
  // The second comparison is of a copy that the first one lets in: c and (c ? i : j) < 4, then the copy again.
  Graph g;
  const Node c = g.variable("c", 1, false), i = g.variable("i", 16, false), j = g.variable("j", 16, false);
  const Node copy = g.make(Op::Ite, 16, c, i, j);
  const Node guard = g.make(Op::And, 1, c, g.make(Op::Ult, 1, copy, g.constantNode(4, 16)));
  const VariableValues none;
  const Assumed here = assuming(g, g.make(Op::Add, 16, copy, g.constantNode(100, 16)), guard);
  const ValueSet values = ValueEvaluator(g, none).valuesOf(here.node, here.guard, pointerValueLimit);
  ASSERT_TRUE(values.isListed());
  EXPECT_EQ(values.values(), (std::vector<std::uint64_t>{100, 101, 102, 103}));
}

TEST(PointerValues, WaysThatMeetAgainKeepWhatHeldBeforeTheyParted) {
  // A jump parts (c and a) from (c and b); behind its target c still holds: c ? 7 : x is 7.
  Graph g;
  const Node c = g.variable("c", 1, false), a = g.variable("a", 1, false), b = g.variable("b", 1, false);
  const Node x = g.variable("x", 16, false);
  const Node ways = g.make(
      Op::Not, 1,
      g.make(Op::And, 1, g.make(Op::Not, 1, g.make(Op::And, 1, c, a)), g.make(Op::Not, 1, g.make(Op::And, 1, c, b))));
  const Node chosen = g.make(Op::Ite, 16, c, g.constantNode(7, 16), x);
  EXPECT_EQ(assuming(g, chosen, ways).node, g.constantNode(7, 16));
  // Either way alone may hold: nothing is known of a.
  EXPECT_NE(assuming(g, g.make(Op::Ite, 16, a, g.constantNode(7, 16), x), ways).node, g.constantNode(7, 16));
}

TEST(PointerValues, RingThatTheFirstScanStartsIsResolved) {
  // Without the first scan the pointer would go on from 0: 2, 4, 6 ... and never come to the end of the ring.
  const Program program = programOf(
      "LD SM0.1\nMOVD &VB100, VD0\nLD SM0.0\nMOVW AIW0, *VD0\n+D 2, VD0\nLDD> VD0, 134217834\nMOVD &VB100, VD0");
  EncodedScan scan(program, {});
  EXPECT_TRUE(scan.approximations().empty());
}

TEST(PointerValues, PointerSetInTheFirstScanIsResolved) {
  const Program program = programOf("LD SM0.1\nMOVD &VB100, VD10\nLD I0.0\nMOVB *VD10, VB0");
  EncodedScan scan(program, {});
  EXPECT_TRUE(scan.approximations().empty());
}

TEST(PointerValues, RetentiveMemoryCountsInTheFirstScanOnly) {
  // V starts with any value; the first scan sets the pointer before it is followed.
  const Program program = programOf(
      "LD SM0.1\nMOVD &VB100, VD0\nLD I0.0\nMOVW AIW0, *VD0\n+D 2, VD0\nLDD> VD0, 134217834\nMOVD &VB100, VD0");
  EncoderOptions options;
  options.initialRetentive = true;
  EXPECT_TRUE(EncodedScan(program, options).approximations().empty());
}

TEST(PointerValues, RingThatOneConditionAdvancesAndStartsAgain) {
  // Advance and start again hang on I0.0 both: the pointer never goes on from the end.
  const Program program = programOf(
      "LD SM0.1\nMOVD &VB100, VD0\nLD I0.0\nCALL 0\nSBR 0\nLD SM0.0\nMOVB IB1, *VD0\nINCD VD0\n"
      "LDD> VD0, 134217834\nMOVD &VB100, VD0\nCRET");
  EXPECT_TRUE(EncodedScan(program, {}).approximations().empty());
}

TEST(PointerValues, PointerFormedUnderAConditionIsResolvedThere) {
  // AC1 keeps what it had before where I0.0 is off; the pointer is followed only where it is on.
  const Program program =
      programOf("LD I0.0\nMOVD &VB100, AC1\nMOVD 0, AC0\nMOVB IB1, AC0\n+D AC0, AC1\nMOVB *AC1, VB20");
  EXPECT_TRUE(EncodedScan(program, {}).approximations().empty());
}

TEST(PointerValues, PointerFromOutsideIsReportedAsUnresolved) {
  const Program program = programOf("LD I0.0\nMOVB *VD10, VB0");
  EncoderOptions options;
  options.externals = {{Area::V, 10, 13}};
  EncodedScan scan(program, options);
  ASSERT_EQ(scan.approximations().size(), 1U);
  EXPECT_EQ(scan.approximations()[0].place->desc->stl, "MOVB");
  EXPECT_FALSE(scan.approximations()[0].carriers.empty());
}

}  // namespace
}  // namespace rungproof
