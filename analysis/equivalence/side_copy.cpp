// Children before parents.
#include "analysis/equivalence/side_copy.hpp"

#include "ir/check.hpp"

namespace rungproof {

void SideCopy::replace(Node variable, Node by) {
  CHECK(to_[by].width == from_[variable].width, "a variable is replaced by a node of its width");
  copies_[variable] = by;
}

Node SideCopy::operator()(Node node) {
  if (node == noNode) return noNode;
  if (const auto known = copies_.find(node); known != copies_.end()) return known->second;
  std::vector<Node> open{node};
  while (!open.empty()) {
    const Node inner = open.back();
    if (copies_.contains(inner)) {
      open.pop_back();
      continue;
    }
    const std::size_t before = open.size();
    for (const Node child : from_[inner].child) {
      if (child != noNode && !copies_.contains(child)) open.push_back(child);
    }
    if (open.size() > before) continue;
    copies_[inner] = made(inner);
    open.pop_back();
  }
  return copies_.at(node);
}

Node SideCopy::made(Node node) {
  const NodeData& data = from_[node];
  if (data.op == Op::Constant) return to_.constantNode(data.value, data.width);
  if (data.op == Op::Variable) {
    const Variable& variable = from_.variables()[data.value];
    const Node copy = to_.variable(variable.name + suffix_, data.width, variable.isState);
    if (!variable.isState) newInputs_.push_back(copy);
    return copy;
  }
  const auto child = [&](std::size_t i) { return data.child[i] == noNode ? noNode : copies_.at(data.child[i]); };
  return to_.make(data.op, data.width, child(0), child(1), child(2), data.value);
}

}  // namespace rungproof
