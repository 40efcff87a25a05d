// Faults of drawings as circuits: GRF001 and GRF003 (001:2230, 001:2304, 001:2268).
#include <gtest/gtest.h>

#include "analysis/drawing/check.hpp"
#include "tests/drawing/networks.hpp"

namespace rungproof::testing {
namespace {

Drawing with(std::vector<Element> elements) {
  Drawing drawing;
  drawing.elements.emplace_back();
  for (Element& each : elements) drawing.elements.push_back(std::move(each));
  return drawing;
}

std::vector<std::string> messages(const Drawing& drawing, Form form = Form::Ladder) {
  std::vector<std::string> result;
  for (const DrawingFault& fault : drawingFaults(drawing, form))
    result.push_back(std::string(fault.rule) + " " + fault.message);
  return result;
}
using Messages = std::vector<std::string>;

TEST(DrawingCheck, ClosedCircuitIsSilent) {
  EXPECT_EQ(
      messages(with({element(Shape::Contact, "LD I0.0", {{0, false}}), element(Shape::Coil, "= Q0.0", {{1, false}})})),
      Messages{});
  EXPECT_EQ(messages(with({element(Shape::Coil, "LBL 1", {})})), Messages{});
}

TEST(DrawingCheck, OpenEndsAndInputs) {
  EXPECT_EQ(messages(with({element(Shape::Contact, "LD I0.0", {{0, false}})})),
            Messages{"GRF001 the output of LD I0.0 leads nowhere"});
  EXPECT_EQ(messages(with({element(Shape::Coil, "= Q0.0", {})})),
            Messages{"GRF001 = Q0.0 has 0 of 1 connected power inputs"});
  EXPECT_EQ(messages(with({element(Shape::Box, "CTU C1, +5", {{0, false}})})),
            Messages{"GRF001 CTU C1 has 1 of 2 connected power inputs"});
}

TEST(DrawingCheck, HeadingsStandAtTheLeftRail) {
  EXPECT_EQ(
      messages(with({element(Shape::Contact, "LD I0.0", {{0, false}}), element(Shape::Coil, "LBL 1", {{1, false}})})),
      Messages{"GRF001 LBL 1 must stand at the left rail"});
}

TEST(DrawingCheck, ShortCircuitInLadderOnly) {
  const Drawing bridged =
      with({element(Shape::Contact, "LD I0.0", {{0, false}}), element(Shape::Contact, "LD I0.1", {{1, false}}),
            element(Shape::Or, "", {{2, false}, {1, false}}), element(Shape::Coil, "= Q0.0", {{3, false}})});
  EXPECT_EQ(messages(bridged), Messages{"GRF001 a branch without contacts short-circuits the one beside it"});
  EXPECT_EQ(messages(bridged, Form::Fbd), Messages{});
  const Drawing atTheRail =
      with({element(Shape::Contact, "LD I0.0", {{0, false}}), element(Shape::Or, "", {{1, false}, {0, false}}),
            element(Shape::Coil, "= Q0.0", {{2, false}})});
  EXPECT_EQ(messages(atTheRail), Messages{"GRF001 a branch without contacts short-circuits the one beside it"});
}

TEST(DrawingCheck, GatesOfAtMost32Inputs) {
  for (const std::uint32_t count : {32U, 33U}) {
    std::vector<Element> elements;
    Element gate = element(Shape::And, "", {});
    for (std::uint32_t i = 0; i < count; ++i) {
      elements.push_back(element(Shape::Contact, "LD I0.0", {{0, false}}));
      gate.inputs.push_back({i + 1, false});
    }
    elements.push_back(gate);
    elements.push_back(element(Shape::Coil, "= Q0.0", {{count + 1, false}}));
    const Messages expected = count == 32 ? Messages{} : Messages{"GRF003 the AND box has 33 inputs, 32 are allowed"};
    EXPECT_EQ(messages(with(std::move(elements)), Form::Fbd), expected);
  }
}

}  // namespace
}  // namespace rungproof::testing
