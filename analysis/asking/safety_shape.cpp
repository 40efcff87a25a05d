// Trees are looked through from their root; anything unexpected means that the property has another form.
#include "analysis/asking/safety_shape.hpp"

#include <algorithm>

namespace rungproof {

namespace {

class Shape {
 public:
  explicit Shape(const Expr& expr) : nodes_(expr.nodes) {}

  const ExprNode& at(std::uint32_t i) const { return nodes_[i]; }
  bool isBit(std::uint32_t i, Area area) const {
    return at(i).op == ExprOp::Address && at(i).type == ExprType::Truth && at(i).operand.area == area;
  }

  bool stops(std::uint32_t i, std::vector<StopInput>& found) const {
    const ExprNode& node = at(i);
    if (node.op == ExprOp::Or)
      return std::all_of(node.args.begin(), node.args.end(), [&](std::uint32_t arg) { return stops(arg, found); });
    const bool isOff = node.op == ExprOp::Not;
    const std::uint32_t bit = isOff ? node.args[0] : i;
    if (!isBit(bit, Area::I)) return false;
    found.push_back({at(bit).operand, isOff});
    return true;
  }
  /// Outputs of a disjunction.
  bool some(std::uint32_t i, Operands& found) const { return outputs(i, ExprOp::Or, found); }
  bool all(std::uint32_t i, Operands& found) const { return outputs(i, ExprOp::And, found); }
  /// Outputs that are all off where the expression holds.
  bool off(std::uint32_t i, Operands& found) const {
    const ExprNode& node = at(i);
    if (node.op == ExprOp::And)
      return std::all_of(node.args.begin(), node.args.end(), [&](std::uint32_t arg) { return off(arg, found); });
    return node.op == ExprOp::Not && some(node.args[0], found);
  }

 private:
  bool outputs(std::uint32_t i, ExprOp joint, Operands& found) const {
    if (at(i).op == joint)
      return std::all_of(at(i).args.begin(), at(i).args.end(),
                         [&](std::uint32_t arg) { return outputs(arg, joint, found); });
    if (!isBit(i, Area::Q)) return false;
    found.push_back(at(i).operand);
    return true;
  }

  const std::vector<ExprNode>& nodes_;
};

std::uint32_t rootOf(const Expr& expr) { return static_cast<std::uint32_t>(expr.nodes.size() - 1); }

}  // namespace

std::optional<StopShape> stopShapeOf(const Property& property) {
  if (property.kind != PropertyKind::Always || property.first.empty() || property.first.root().op != ExprOp::Implies)
    return std::nullopt;
  const Shape shape(property.first);
  StopShape found;
  const ExprNode& root = property.first.root();
  if (!shape.stops(root.args[0], found.stops) || !shape.off(root.args[1], found.outputs)) return std::nullopt;
  return found;
}

bool excludesOutputs(const Property& property) {
  if (property.first.empty()) return false;
  const Shape shape(property.first);
  Operands outputs;
  const ExprNode& root = property.first.root();
  if (property.kind == PropertyKind::Never) return root.op == ExprOp::And && shape.all(rootOf(property.first), outputs);
  return property.kind == PropertyKind::Always && root.op == ExprOp::Not && shape.at(root.args[0]).op == ExprOp::And &&
         shape.all(root.args[0], outputs);
}

}  // namespace rungproof
