// What a scan reads of the state.
#include "analysis/graph/transition_system.hpp"

namespace rungproof {

std::unordered_set<std::uint32_t> statesUnder(const TransitionSystem& system, const std::vector<Node>& roots) {
  std::unordered_set<std::uint32_t> states, seen, result;
  for (const StateVariable& state : system.states) states.insert(indexOf(state.node));
  std::vector<Node> stack = roots;
  while (!stack.empty()) {
    const Node n = stack.back();
    stack.pop_back();
    if (!seen.insert(indexOf(n)).second) continue;
    const NodeData& node = (*system.graph)[n];
    if (states.contains(indexOf(n))) result.insert(indexOf(n));
    if (node.op == Op::Variable || node.op >= Op::RealAdd) continue;
    for (const Node child : node.child) {
      if (child != noNode) stack.push_back(child);
    }
  }
  return result;
}

}  // namespace rungproof
