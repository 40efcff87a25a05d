// Which networks of a witness are drawn.
#include "frontend/simulation/witness_drawing.hpp"

#include <gtest/gtest.h>

#include "frontend/input/project.hpp"

namespace rungproof {
namespace {

/// The networks that drive the property's output, and those that drive what they read; not the others.
TEST(WitnessDrawing, NetworksThatMatter) {
  const Program program =
      readText("test.awl",
               "ORGANIZATION_BLOCK MAIN:OB1\nBEGIN\nNetwork 1\nLD I0.0\n= M0.0\nNetwork 2\nLD I0.5\n= Q1.0\nNetwork "
               "3\nLD M0.0\n= Q0.0\nNetwork 4\nLD Q0.0\nTON T37, 10\nEND_ORGANIZATION_BLOCK\n",
               {});
  ProofResult result;
  ExprNode node;
  node.op = ExprOp::Address;
  node.operand = direct(Area::Q, Width::Bit, 0, 0);
  result.property.first.nodes.push_back(node);
  std::string numbers;
  for (const auto& [pou, network] : networksThatMatter(program, result))
    numbers += std::to_string(network->number) + " ";
  EXPECT_EQ(numbers, "1 3 ");
}

/// Five scans, in the last of which I0.0 is 1: the last three are drawn, the coil is lit in the last one only.
TEST(WitnessDrawing, LastScansAreDrawn) {
  const Program program = readText(
      "test.awl", "ORGANIZATION_BLOCK MAIN:OB1\nBEGIN\nNetwork 1\nLD I0.0\n= Q0.0\nEND_ORGANIZATION_BLOCK\n", {});
  ProofResult result;
  ExprNode node;
  node.op = ExprOp::Address;
  node.operand = direct(Area::Q, Width::Bit, 0, 0);
  result.property.first.nodes.push_back(node);
  Witness witness;
  ReplayScan quiet, pressed;
  quiet.repeats = 4;
  pressed.inputs = {{direct(Area::I, Width::Bit, 0, 0), 1}};
  witness.scans = {quiet, pressed};
  witness.scanCount = 5;
  result.witness = witness;
  const std::vector<ShownScan> scans =
      shownScans(program, Choices(), result, {.form = Form::Ladder, .scans = 3, .text = true, .svg = true});
  ASSERT_EQ(scans.size(), 3U);
  EXPECT_EQ(scans[0].scan, 3U);
  EXPECT_EQ(scans[2].timeMs, 50);  // five scans of 10 ms
  const auto wholeText = [](const ShownScan& scan) {
    std::string text;
    for (const std::string& line : scan.networks.at(0).text) text += line + "\n";
    return text;
  };
  EXPECT_NE(wholeText(scans[1]).find("Q0.0=0"), std::string::npos);
  EXPECT_NE(wholeText(scans[2]).find("Q0.0=1"), std::string::npos);
  EXPECT_NE(scans[2].networks[0].svg.find("class=\"rw on\""), std::string::npos);
  EXPECT_EQ(scans[2].networks[0].heading, "MAIN, Network 1");
}

}  // namespace
}  // namespace rungproof
