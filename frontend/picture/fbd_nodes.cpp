// A network as FBD. A contact on the rail becomes a name at the left end of a wire, a negated one gets a circle at the
// pin it leads to; a contact behind something becomes an input of an AND; compare contacts, edges and coils become
// boxes.
#include <algorithm>
#include <map>

#include "frontend/picture/node_parts.hpp"

namespace rungproof {

namespace {

/// What an element is as an input: a node, and whether a circle is to be drawn.
struct Source {
  int node = -1;  ///< -1: power itself
  bool negated = false;
};

class FbdPlan {
 public:
  FbdPlan(const Drawing& drawing, const ElementTexts& texts)
      : drawing_(drawing), texts_(texts), uses_(usesOf(drawing)) {}

  PlanNodes plan() {
    plan_.hasRails = false;
    const auto count = static_cast<int>(drawing_.elements.size());
    for (int i = 0; i < count; ++i) {
      const bool isSink =
          at(i).shape == Shape::Coil || (at(i).shape == Shape::Box && uses_[static_cast<std::size_t>(i)] == 0);
      if (isSink) sourceOf(i);
    }
    return std::move(plan_);
  }

 private:
  const Element& at(int i) const { return drawing_.elements[static_cast<std::size_t>(i)]; }
  int add(PlanNode node) {
    plan_.nodes.push_back(std::move(node));
    return static_cast<int>(plan_.nodes.size()) - 1;
  }

  Source sourceOf(int i) {
    if (at(i).shape == Shape::Rail) return {};
    if (const auto found = made_.find(i); found != made_.end()) return found->second;
    Source source;
    switch (at(i).shape) {
      case Shape::And:
      case Shape::Or: source.node = gate(i); break;
      case Shape::Contact: source = contact(i); break;
      case Shape::Box: source.node = box(i); break;
      default: source.node = coil(i); break;
    }
    made_[i] = source;
    return source;
  }
  Source sourceOf(const Wire& wire) {
    Source source = sourceOf(static_cast<int>(wire.from));
    if (wire.negated) source.negated = !source.negated;
    return source;
  }

  /// A pin on that wire; power itself is written as the constant that it is.
  NodeInput pin(Source source, std::string name = {}) {
    if (source.node < 0) {
      PlanNode constant;
      constant.kind = NodeKind::Leaf;
      constant.above = {source.negated ? "0" : "1"};
      if (texts_.showsScan()) constant.output = source.negated ? Flow3::Off : Flow3::On;
      return {add(std::move(constant)), false, std::move(name)};
    }
    return {source.node, source.negated, std::move(name)};
  }
  NodeInput pin(const Wire& wire, std::string name = {}) { return pin(sourceOf(wire), std::move(name)); }

  int gate(int i) {
    PlanNode node = nodeOf(texts_, i);
    node.kind = NodeKind::Box;
    node.name = at(i).shape == Shape::And ? "AND" : "OR";
    gather(i, at(i).shape, node.inputs);
    return add(std::move(node));
  }
  /// A gate of the same kind that feeds nothing else is part of this one.
  void gather(int i, Shape shape, std::vector<NodeInput>& inputs) {
    for (const Wire& wire : at(i).inputs) {
      const auto from = static_cast<int>(wire.from);
      if (!wire.negated && uses_[wire.from] == 1 && at(from).shape == shape)
        gather(from, shape, inputs);
      else if (!wire.negated && shape == Shape::And && isSeries(from))
        addSeries(from, inputs);
      else
        inputs.push_back(pin(wire));
    }
  }
  bool isSeries(int i) const {
    const Element& e = at(i);
    return e.shape == Shape::Contact && !e.operands.empty() && uses_[static_cast<std::size_t>(i)] == 1 &&
           at(static_cast<int>(e.inputs.at(0).from)).shape != Shape::Rail;
  }
  /// The contact and what stands in series before it, as inputs of one AND.
  void addSeries(int i, std::vector<NodeInput>& inputs) {
    const Wire& wire = at(i).inputs[0];
    const auto from = static_cast<int>(wire.from);
    if (!wire.negated && isSeries(from))
      addSeries(from, inputs);
    else if (!wire.negated && at(from).shape == Shape::And && uses_[wire.from] == 1)
      gather(from, Shape::And, inputs);
    else
      inputs.push_back(pin(wire));
    inputs.push_back(pin(finds(i)));
  }

  /// What the contact itself finds, whatever stands before it.
  Source finds(int i) {
    const Element& element = at(i);
    PlanNode node = nodeOf(texts_, i);
    node.output = node.state;
    if (element.operands.size() > 1) {
      node.kind = NodeKind::Box;
      node.name = std::string(element.desc->drawnName());
      for (std::size_t k = 0; k < element.operands.size(); ++k) {
        const OperandText text = texts_.operand(i, k);
        node.left.push_back({"IN" + std::to_string(k + 1), text.whole(), text.isConstant});
      }
      return {add(std::move(node))};
    }
    if (element.desc->role == Role::Eu || element.desc->role == Role::Ed) {  // of a variable
      node.kind = NodeKind::Box;
      node.name = std::string(element.desc->drawnName());
      node.left.push_back({{}, texts_.operand(i, 0).whole(), false});
      return {add(std::move(node))};
    }
    const bool isNegated = element.desc->negated;
    const bool isImmediate = element.desc->immediate;
    node.kind = NodeKind::Leaf;
    node.above = {texts_.operand(i, 0).whole() + (isImmediate ? " (I)" : "")};
    if (isNegated && node.output != Flow3::Unknown) node.output = node.output == Flow3::On ? Flow3::Off : Flow3::On;
    return {add(std::move(node)), isNegated};
  }

  Source contact(int i) {
    const Element& element = at(i);
    const Wire& wire = element.inputs.at(0);
    if (!element.operands.empty()) {
      if (at(static_cast<int>(wire.from)).shape == Shape::Rail && !wire.negated) return finds(i);
      PlanNode node = nodeOf(texts_, -1);
      node.output = texts_.output(i);
      node.kind = NodeKind::Box;
      node.name = "AND";
      addSeries(i, node.inputs);
      return {add(std::move(node))};
    }
    PlanNode node = nodeOf(texts_, i);
    node.kind = NodeKind::Box;
    node.name = std::string(element.desc->drawnName());
    node.inputs = {pin(wire)};
    return {add(std::move(node))};
  }

  int box(int i) {
    PlanNode node = boxNode(texts_, at(i), i, uses_[static_cast<std::size_t>(i)] > 0);
    const std::vector<std::string> pins = powerPinsOf(texts_, at(i));
    for (std::size_t k = 0; k < at(i).inputs.size(); ++k)
      node.inputs.push_back(pin(at(i).inputs[k], k < pins.size() ? pins[k] : std::string()));
    return add(std::move(node));
  }

  int coil(int i) {
    const Element& element = at(i);
    PlanNode node = nodeOf(texts_, i);
    node.kind = NodeKind::Box;
    node.hasOutput = false;
    node.isLast = !element.inputs.empty();
    node.name = std::string(element.desc->drawnName());
    if (isCoil(element.desc->role)) node.name = element.desc->stl;  // a box has no round sign to stand for "="
    for (const Wire& wire : element.inputs) node.inputs.push_back(pin(wire));
    addAbove(node, texts_.operand(i, 0));
    if (element.operands.size() > 1) {
      const OperandText text = texts_.operand(i, 1);
      node.left.push_back({std::string(element.desc->operands[1].name), text.whole(), text.isConstant});
    }
    return add(std::move(node));
  }

  const Drawing& drawing_;
  const ElementTexts& texts_;
  std::vector<int> uses_;
  PlanNodes plan_;
  std::map<int, Source> made_;
};

}  // namespace

PlanNodes fbdNodes(const Drawing& drawing, const ElementTexts& texts) { return FbdPlan(drawing, texts).plan(); }

}  // namespace rungproof
