// Sizes of nodes in cells, and the symbols and labels that a node becomes once its place is known.
// Tested by tests/show/layout_test.cpp.
#pragma once

#include <vector>

#include "frontend/picture/plan_nodes.hpp"

namespace rungproof {

/// Rows that a node needs above its row, and below it. A box: without its pins, see boxRowsBelow().
int rowsAbove(const PlanNode& node);
int rowsBelow(const PlanNode& node);
/// Rows from the row of a box to its lower edge; `pinRows`: of its power inputs.
int boxRowsBelow(const PlanNode& node, const std::vector<int>& pinRows);
/// Columns that the node needs, with room for wires on both sides.
int columnWidth(const PlanNode& node);
/// Columns from the left end of its column to its left edge.
int entryOffset(const PlanNode& node, int width);

/// The place of a node: left end and width of its column, its row, the rows of its power inputs.
struct NodeFrame {
  int x = 0;
  int width = 0;
  int row = 0;
  std::vector<int> pinRows;
};

/// Adds the symbol with its labels; gives the column of its right edge, where the output wire begins.
int drawSymbol(const PlanNode& node, const NodeFrame& frame, Picture& picture);

}  // namespace rungproof
