// Depth first, children before their parents.
#include "analysis/graph/substitution.hpp"

#include <vector>

namespace rungproof {

Node Substitution::operator()(Node root) {
  std::vector<Node> stack{root};
  while (!stack.empty()) {
    const Node n = stack.back();
    if (known_.contains(indexOf(n))) {
      stack.pop_back();
      continue;
    }
    const NodeData node = graph_[n];
    std::array<Node, 3> child = node.child;
    bool isReady = true;
    for (std::size_t i = 0; i < child.size() && node.op != Op::Variable && node.op != Op::Constant; ++i) {
      if (child[i] == noNode) continue;
      const auto known = known_.find(indexOf(child[i]));
      if (known == known_.end()) {
        stack.push_back(child[i]);
        isReady = false;
      } else {
        child[i] = known->second;
      }
    }
    if (!isReady) continue;
    stack.pop_back();
    Node result = rule_ ? rule_(node, child) : noNode;
    if (result == noNode)
      result = child == node.child ? n : graph_.make(node.op, node.width, child[0], child[1], child[2], node.value);
    known_.emplace(indexOf(n), result);
  }
  return known_.at(indexOf(root));
}

}  // namespace rungproof
