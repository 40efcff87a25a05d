// Which networks of a witness are drawn.
#include "frontend/witness_drawing.hpp"

#include <gtest/gtest.h>

#include "frontend/project.hpp"

namespace rungproof {
namespace {

/// The networks that drive the property's output, and those that drive what they read; not the others.
TEST(WitnessDrawing, NetworksThatMatter) {
  const Program program = readText("test.awl",
      "ORGANIZATION_BLOCK MAIN:OB1\nBEGIN\nNetwork 1\nLD I0.0\n= M0.0\nNetwork 2\nLD I0.5\n= Q1.0\nNetwork 3\nLD M0.0\n= Q0.0\nNetwork 4\nLD Q0.0\nTON T37, 10\nEND_ORGANIZATION_BLOCK\n", {});
  ProofResult result;
  ExprNode node;
  node.op = ExprOp::Address;
  node.operand = direct(Area::Q, Width::Bit, 0, 0);
  result.property.first.nodes.push_back(node);
  std::string numbers;
  for (const auto& [pou, network] : networksThatMatter(program, result)) numbers += std::to_string(network->number) + " ";
  EXPECT_EQ(numbers, "1 3 ");
}

}  // namespace
}  // namespace rungproof
