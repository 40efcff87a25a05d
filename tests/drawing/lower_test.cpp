// Drawings as instructions: shapes that the stack can follow, shapes that need bits of L60 to L63, drawings that are
// refused. Expected instructions follow from the stack operations (001:2825-2872) and the forms that the manual shows
// for branches (000:795-810) and calls (001:10223-10238).
#include <gtest/gtest.h>

#include "ir/s7200/isa.hpp"
#include "tests/drawing/equality.hpp"
#include "tests/drawing/networks.hpp"

namespace rungproof::testing {
namespace {

Wire w(std::uint32_t from) { return {from, false}; }
Wire circle(std::uint32_t from) { return {from, true}; }

/// Rail first, then the given elements.
Drawing drawingOf(std::vector<Element> elements) {
  Drawing drawing;
  drawing.elements.emplace_back();
  for (Element& each : elements) drawing.elements.push_back(std::move(each));
  return drawing;
}
Element contact(std::string_view instruction, Wire from) { return element(Shape::Contact, instruction, {from}); }
Element coil(std::string_view instruction, Wire from) { return element(Shape::Coil, instruction, {from}); }
Element gate(Shape shape, std::vector<Wire> inputs) { return element(shape, "", std::move(inputs)); }
Element box(std::string_view instruction, std::vector<Wire> inputs) {
  return element(Shape::Box, instruction, std::move(inputs));
}

/// Lowered text, after the solver has found it equal to the drawing.
std::string proven(const Drawing& drawing) {
  const Lowered result = lower(drawing);
  if (result.fault) return "refused: " + result.fault->message;
  EXPECT_EQ(difference(drawing, result.instructions, result.instructionOf), "") << textOf(result.instructions);
  return textOf(result.instructions);
}

TEST(Lower, RailFeedsBoxesAndCoils) {
  EXPECT_EQ(proven(drawingOf({box("MOVB 1, VB0", {w(0)}), coil("= Q0.0", w(0))})),
            "LD SM0.0; MOVB 1, VB0; LD SM0.0; = Q0.0");
  EXPECT_EQ(proven(drawingOf({coil("= Q0.0", circle(0))})), "LD SM0.0; NOT; = Q0.0");
}

TEST(Lower, GroupInSeries) {
  EXPECT_EQ(proven(drawingOf({contact("LD I0.0", w(0)), contact("LD I0.1", w(1)), contact("LD I0.2", w(1)),
                              gate(Shape::Or, {w(2), w(3)}), contact("LD I0.3", w(4)), coil("= Q0.0", w(5))})),
            "LD I0.0; LD I0.1; O I0.2; ALD; A I0.3; = Q0.0");
}

TEST(Lower, GroupWithinAGroup) {  // both begin at I0.0, so the inner one needs no ALD
  EXPECT_EQ(proven(drawingOf({contact("LD I0.0", w(0)), contact("LD I0.1", w(1)), contact("LD I0.2", w(1)),
                              gate(Shape::Or, {w(2), w(3)}), contact("LD I0.3", w(4)), contact("LD I0.4", w(1)),
                              gate(Shape::Or, {w(5), w(6)}), coil("= Q0.0", w(7))})),
            "LD I0.0; LD I0.1; O I0.2; A I0.3; O I0.4; ALD; = Q0.0");
}

TEST(Lower, BranchesInTheOrderOfTheirCoils) {  // contacts first, as some editors number them
  EXPECT_EQ(proven(drawingOf({contact("LD I0.0", w(0)), contact("LD I0.1", w(1)), contact("LD I0.2", w(1)),
                              coil("= Q0.0", w(2)), coil("= Q0.1", w(3))})),
            "LD I0.0; LPS; A I0.1; = Q0.0; LPP; A I0.2; = Q0.1");
}

TEST(Lower, AContactReadBeforeACoilThatChangesItWaits) {  // M0.0 is read before the first coil writes it; I0.0 can be
                                                          // read twice
  EXPECT_EQ(proven(drawingOf({contact("LD I0.0", w(0)), contact("LD I0.1", w(1)), contact("LD M0.0", w(1)),
                              coil("= M0.0", w(2)), coil("= Q0.1", w(3))})),
            "LD I0.0; A I0.1; = L60.0; LD I0.0; A M0.0; = L60.1; LD L60.0; = M0.0; LD L60.1; = Q0.1");
}

TEST(Lower, NegatedPins) {
  EXPECT_EQ(proven(drawingOf({contact("LD I0.0", w(0)), contact("LD I0.1", w(0)),
                              gate(Shape::And, {circle(1), circle(2)}), coil("= Q0.0", circle(3))})),
            "LD I0.0; NOT; LD I0.1; NOT; ALD; NOT; = Q0.0");
}

TEST(Lower, CounterInputsFirstDeepest) {  // 001:3994
  EXPECT_EQ(proven(drawingOf({contact("LD I0.0", w(0)), contact("LD I0.1", w(0)), contact("LD I0.2", w(0)),
                              box("CTUD C1, +5", {w(1), w(2), w(3)})})),
            "LD I0.0; LD I0.1; LD I0.2; CTUD C1, +5");
}

TEST(Lower, ABranchBehindACounterDoesNotFindTheStackAsItWas) {  // the counter leaves both inputs on the stack
  EXPECT_EQ(proven(drawingOf({contact("LD I0.0", w(0)), contact("EU", w(1)), contact("LD I0.1", w(0)),
                              box("CTU C1, +5", {w(2), w(3)}), contact("LD I0.2", w(2)), coil("= Q0.0", w(5))})),
            "LD I0.0; EU; = L60.0; LD L60.0; LD I0.1; CTU C1, +5; LD L60.0; A I0.2; = Q0.0");
}

TEST(Lower, CallStoresItsFlowInputs) {  // 001:10223-10238
  Element call = box("CALL SBR0, I1.0, I1.1, Q0.0", {w(1), w(2), w(3)});
  call.operands[1].kind = call.operands[2].kind = OperandKind::Missing;
  EXPECT_EQ(proven(drawingOf(
                {contact("LD I0.0", w(0)), contact("LD I0.1", w(0)), contact("LD I0.2", w(0)), std::move(call)})),
            "LD I0.0; = L60.0; LD I0.1; = L63.7; LD I0.2; = L63.6; LD L60.0; CALL 0, L63.7, L63.6, Q0.0");
}

TEST(Lower, TakenBitsAreLeftAlone) {
  Element call = box("CALL SBR0, I1.0, I1.1, Q0.0", {w(1), w(2)});
  call.operands[1].kind = OperandKind::Missing;
  const Drawing drawing = drawingOf({contact("LD I0.0", w(0)), contact("LD I0.1", w(0)), std::move(call)});
  const Lowered result = lower(drawing, editorBit(60, 0) | editorBit(63, 7));
  EXPECT_EQ(textOf(result.instructions), "LD I0.0; = L60.1; LD I0.1; = L63.6; LD L60.1; CALL 0, L63.6, I1.1, Q0.0");
}

/// A bridge: two contacts behind each of two contacts, crossed. No series and parallel circuit.
Drawing bridge() {
  return drawingOf({contact("LD I0.0", w(0)), contact("LD I0.1", w(0)), contact("LD I0.2", w(1)),
                    contact("LD I0.3", w(2)), gate(Shape::Or, {w(3), w(4)}), coil("= Q0.0", w(5)),
                    contact("LD I0.4", w(1)), contact("LD I0.5", w(2)), gate(Shape::Or, {w(7), w(8)}),
                    coil("= Q0.1", w(9))});
}

TEST(Lower, WhatTheStackCannotFollowWaitsInBits) {
  const Lowered result = lower(bridge());
  EXPECT_TRUE(result.usesEditorBits);
  EXPECT_EQ(difference(bridge(), result.instructions, result.instructionOf), "") << textOf(result.instructions);
}

TEST(Lower, IecTimerHandsOnItsOutput) {  // Q left open: the bit is read behind the box
  Element timer = box("TON T37, +5", {w(1)});
  timer.desc = s7200Instructions().named("TON.IEC");
  const Drawing drawing =
      drawingOf({contact("LD I0.0", w(0)), std::move(timer), contact("LD I0.1", w(2)), coil("= Q0.0", w(3))});
  EXPECT_EQ(proven(drawing), "LD I0.0; TON.IEC T37, +5, L60.0; LD L60.0; A I0.1; = Q0.0");
  Network network;
  network.instructions = lower(drawing).instructions;
  const Raised again = raise(network, Form::Ladder);
  ASSERT_TRUE(again.drawing) << again.reason;
  EXPECT_EQ(lowered(*again.drawing), textOf(network.instructions));
}

TEST(Lower, BistableTakesTwoLevelsAndLeavesItsOutput) {  // S deepest, R on top; as a drawing it comes back
  Element bistable = box("= M0.0", {w(2), w(3)});
  bistable.desc = s7200Instructions().named("SR");
  const Drawing drawing =
      drawingOf({contact("LD I0.0", w(0)), contact("LD I0.1", w(1)), contact("LD I0.2", w(0)), std::move(bistable),
                 coil("= Q0.0", w(4)), contact("LD I0.3", w(4)), coil("= Q0.1", w(6))});
  const std::string text = "LD I0.0; A I0.1; LD I0.2; SR M0.0; = Q0.0; A I0.3; = Q0.1";
  EXPECT_EQ(proven(drawing), text);
  Network network;
  network.instructions = lower(drawing).instructions;
  const Raised again = raise(network, Form::Ladder);
  ASSERT_TRUE(again.drawing) << again.reason;
  EXPECT_EQ(textOf(*again.drawing), textOf(drawing));
}

TEST(Lower, MoreThanNineLevels) {  // twelve nested groups: the innermost is computed first
  std::vector<Element> elements;
  for (unsigned i = 0; i < 12; ++i)
    elements.push_back(contact("LD I" + std::to_string(i / 8) + "." + std::to_string(i % 8), w(0)));
  for (std::uint32_t i = 0; i < 11; ++i) {
    const std::uint32_t inner = i == 0 ? 12 : 12 + i;
    elements.push_back(gate(i % 2 == 0 ? Shape::And : Shape::Or, {w(11 - i), w(inner)}));
  }
  elements.push_back(coil("= Q0.0", w(23)));
  const std::string text = proven(drawingOf(std::move(elements)));
  EXPECT_EQ(text,
            "LD I1.2; A I1.3; O I1.1; A I1.0; O I0.7; A I0.6; O I0.5; A I0.4; O I0.3; A I0.2; O I0.1; A I0.0; = Q0.0");
}

TEST(Lower, ADeepDrawingDoesNotOverflow) {
  constexpr std::uint32_t depth = 100'000;
  const Element input = contact("LD I0.0", w(0)), output = coil("= Q0.0", w(0));
  const auto fedBy = [](Element sample, std::uint32_t from) {
    sample.inputs = {w(from)};
    return sample;
  };
  Drawing nested = drawingOf({input}), chain = nested, comb = nested;
  for (std::uint32_t i = 1; i <= depth; ++i) {
    // A gate around a gate, each with a contact of its own on the left.
    nested.elements.push_back(input);
    Element gate;
    gate.shape = i % 2 == 0 ? Shape::And : Shape::Or;
    gate.inputs = {w(2 * i), w(2 * i - 1)};
    nested.elements.push_back(gate);
    chain.elements.push_back(fedBy(input, i));
    // Each contact feeds a coil behind another contact, and the next contact.
    comb.elements.push_back(fedBy(input, 3 * i - 2));
    comb.elements.push_back(fedBy(output, 3 * i - 1));
    comb.elements.push_back(fedBy(input, 3 * i - 2));
  }
  nested.elements.push_back(coil("= Q0.0", w(2 * depth + 1)));
  chain.elements.push_back(coil("= Q0.0", w(depth + 1)));
  comb.elements.push_back(coil("= Q0.1", w(3 * depth + 1)));
  EXPECT_EQ(lower(nested).instructions.size(), depth + 2);
  EXPECT_EQ(lower(chain).instructions.size(), depth + 2);
  const Lowered lowered = lower(comb);
  EXPECT_FALSE(lowered.fault);
  EXPECT_GE(lowered.instructions.size(), 3 * depth);
  Network network;
  network.instructions = lower(chain).instructions;
  EXPECT_TRUE(raise(network, Form::Ladder).drawing);
  EXPECT_TRUE(raise(network, Form::Fbd).drawing);
}

TEST(Lower, RefusesWhatIsNoCircuit) {
  EXPECT_EQ(proven(drawingOf({contact("LD I0.0", w(0)), box("CTU C1, +5", {w(1)})})),
            "refused: CTU C1 has 1 of 2 power inputs");
  EXPECT_EQ(proven(drawingOf({coil("= Q0.0", w(0)), coil("= Q0.1", w(1))})),
            "refused: = Q0.0 has no output that could feed = Q0.1");
  EXPECT_EQ(proven(drawingOf({box("TON T37, +5", {w(0)}), coil("= Q0.1", w(1))})),
            "refused: TON T37 has no power output for = Q0.1");
  EXPECT_EQ(proven(drawingOf({contact("LD I0.0", w(2)), coil("= Q0.0", w(1))})),
            "refused: I0.0 is fed by an element behind it");
}

TEST(Lower, RefusesMoreWaitingValuesThanBits) {  // 40 values that all wait for the last gates
  std::vector<Element> elements;
  for (std::uint32_t i = 0; i < 40; ++i) elements.push_back(contact("LD I0.0", w(0)));
  for (std::uint32_t i = 0; i < 40; ++i) elements.push_back(contact("EU", w(i + 1)));
  for (std::uint32_t i = 0; i < 40; ++i) elements.push_back(gate(Shape::And, {w(41 + i), w(41 + (i + 1) % 40)}));
  for (std::uint32_t i = 0; i < 40; ++i) elements.push_back(coil("= Q0.0", w(81 + i)));
  const Lowered result = lower(drawingOf(std::move(elements)));
  ASSERT_TRUE(result.fault);
  EXPECT_EQ(result.fault->message, "EU: more values have to wait than L60.0 to L63.7 can hold");
  EXPECT_TRUE(result.instructions.empty());
}

TEST(Lower, FillsANetworkWithInstructionsAndDrawing) {
  Network network;
  EXPECT_FALSE(
      lowerInto(network, drawingOf({contact("LD I0.0", w(0)), contact("LD I0.1", w(1)), coil("= Q0.0", w(2))})));
  ASSERT_NE(network.drawing, nullptr);
  EXPECT_EQ(textOf(network.instructions), "LD I0.0; A I0.1; = Q0.0");
  EXPECT_EQ(network.drawing->elements[2].instruction, 1U);
  EXPECT_EQ(network.drawing->elements[0].instruction, noInstruction);
}

}  // namespace
}  // namespace rungproof::testing
