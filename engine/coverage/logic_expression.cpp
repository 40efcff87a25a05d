// Leaves of a tree.
#include "engine/coverage/logic_expression.hpp"

#include <algorithm>

namespace rungproof {

std::vector<std::uint32_t> LogicTrees::leavesOf(LogicNode root) const {
  std::vector<std::uint32_t> leaves;
  std::vector<LogicNode> open{root};
  while (!open.empty()) {
    const LogicPart& part = parts_[open.back()];
    open.pop_back();
    if (part.op == LogicOp::Leaf) leaves.push_back(part.leaf);
    if (part.op >= LogicOp::Not) open.push_back(part.a);
    if (part.op >= LogicOp::And) open.push_back(part.b);
  }
  std::ranges::sort(leaves);
  leaves.erase(std::unique(leaves.begin(), leaves.end()), leaves.end());
  return leaves;
}

}  // namespace rungproof
