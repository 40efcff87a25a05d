// Every function that looks back has cells of its own, and every operator says whether it needs some.
#include <gtest/gtest.h>

#include "analysis/property.hpp"

namespace rungproof {
namespace {

ExprNode nodeOf(ExprOp op, std::uint32_t arg) {
  ExprNode node;
  node.op = op;
  node.milliseconds = 100;
  node.args = {arg, arg};
  return node;
}

/// The same operator twice, between two `once`: nobody shares.
TEST(Cells, OfEveryOperatorAreItsOwn) {
  for (std::size_t i = 0; i < exprOpCount; ++i) {
    const auto op = static_cast<ExprOp>(i);
    for (const int timeBase : {1, 10, 100}) {
      Property property;
      property.timeBase = timeBase;
      property.first.nodes = {ExprNode{}, nodeOf(ExprOp::Once, 0), nodeOf(op, 0), nodeOf(op, 0),
                              nodeOf(ExprOp::Once, 0)};
      layoutCells(property);
      const std::vector<ExprNode>& nodes = property.first.nodes;
      EXPECT_EQ(nodes[0].cell, noCell);
      EXPECT_EQ(nodes[1].cell, 0u);
      ASSERT_GE(property.cells.size(), 2u);
      const std::size_t each = (property.cells.size() - 2) / 2;
      EXPECT_EQ(nodes[2].cell, each == 0 ? noCell : 1u) << "operator " << i;
      EXPECT_EQ(nodes[3].cell, each == 0 ? noCell : 1u + each) << "operator " << i;
      EXPECT_EQ(nodes[4].cell, 1u + 2 * each) << "operator " << i;
    }
  }
}

/// The meaning in the contract: which functions depend on earlier scan ends.
TEST(Cells, BelongToWhatLooksBack) {
  for (std::size_t i = 0; i < exprOpCount; ++i) {
    const auto op = static_cast<ExprOp>(i);
    const bool looksBack = op == ExprOp::Rises || op == ExprOp::Falls || op == ExprOp::Prev || op == ExprOp::Once ||
                           op == ExprOp::Since || op == ExprOp::Held;
    Property property;
    property.first.nodes = {ExprNode{}, nodeOf(op, 0)};
    layoutCells(property);
    EXPECT_EQ(property.cells.empty(), !looksBack) << "operator " << i;
    EXPECT_EQ(property.patternCell, noCell) << "always carries nothing";
  }
}

}  // namespace
}  // namespace rungproof
