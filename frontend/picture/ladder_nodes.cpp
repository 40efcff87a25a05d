// A network as ladder. An And gate is drawn in series: the rails of its second input are replaced by the output of its
// first one, which has the same meaning as long as only contacts and branches stand there; an edge or a NOT in the
// second input would see other power than before.
#include <algorithm>
#include <map>

#include "frontend/picture/node_parts.hpp"

namespace rungproof {

namespace {

class LadderPlan {
 public:
  LadderPlan(const Drawing& drawing, const ElementTexts& texts)
      : drawing_(drawing), texts_(texts), uses_(usesOf(drawing)) {}

  PlanNodes plan() {
    const auto count = static_cast<int>(drawing_.elements.size());
    for (int i = 0; i < count && plan_.reason.empty(); ++i) {
      const Element& element = at(i);
      const bool isSink =
          element.shape == Shape::Coil || (element.shape == Shape::Box && uses_[static_cast<std::size_t>(i)] == 0);
      if (isSink) nodeFor(i, rail());
    }
    return std::move(plan_);
  }

 private:
  const Element& at(int i) const { return drawing_.elements[static_cast<std::size_t>(i)]; }
  int add(PlanNode node) {
    plan_.nodes.push_back(std::move(node));
    return static_cast<int>(plan_.nodes.size()) - 1;
  }
  int rail() {
    if (rail_ >= 0) return rail_;
    PlanNode node;
    node.kind = NodeKind::Rail;
    for (std::size_t i = 0; i < drawing_.elements.size(); ++i) {
      if (drawing_.elements[i].shape == Shape::Rail) node.output = texts_.output(static_cast<int>(i));
    }
    return rail_ = add(std::move(node));
  }

  /// The node of an element whose rails are `source`. Made once, unless a second input of an And moves it.
  int nodeFor(int i, int source) {
    const Element& element = at(i);
    if (element.shape == Shape::Rail) return source;
    if (const auto found = made_.find(i); found != made_.end()) return found->second;
    int node = -1;
    switch (element.shape) {
      case Shape::And: node = series(i, source); break;
      case Shape::Or: node = join(i, source); break;
      case Shape::Contact: node = contact(i, source); break;
      case Shape::Box: node = box(i, source); break;
      default: node = coil(i, source); break;
    }
    made_[i] = node;
    return node;
  }

  int input(const Wire& wire, int source) {
    const int node = nodeFor(static_cast<int>(wire.from), source);
    if (!wire.negated) return node;
    PlanNode negation;
    negation.kind = NodeKind::Contact;
    negation.sign = "NOT";
    negation.inputs = {{node}};
    const Flow3 before = plan_.nodes[static_cast<std::size_t>(node)].output;
    negation.output = negation.state = before == Flow3::Unknown ? before : before == Flow3::On ? Flow3::Off : Flow3::On;
    return add(std::move(negation));
  }

  int series(int i, int source) {
    int node = source;
    const std::vector<Wire>& inputs = at(i).inputs;
    for (std::size_t k = 0; k < inputs.size(); ++k) {
      if (k > 0 && (inputs[k].negated || !canMove(static_cast<int>(inputs[k].from)))) {
        plan_.reason =
            "an edge, a negation, a box or a branch stands behind the rail in the second part of an AND; ladder has no "
            "AND gate";
        return source;
      }
      node = input(inputs[k], node);
      if (k > 0 && node != source) powerThrough(node, i);
    }
    return node;
  }
  /// In series, power reaches what stood on the rail only through the first part.
  void powerThrough(int node, int gate) {
    const Flow3 flow = texts_.output(gate);
    if (flow != Flow3::Unknown) plan_.nodes[static_cast<std::size_t>(node)].output = flow;
  }

  /// Contacts and branches that feed nothing else.
  bool canMove(int i) const {
    const Element& element = at(i);
    if (element.shape == Shape::Rail) return true;
    if (uses_[static_cast<std::size_t>(i)] != 1 || made_.contains(i)) return false;
    if (element.shape == Shape::Box || (element.shape == Shape::Contact && element.operands.empty())) return false;
    return std::ranges::all_of(element.inputs,
                               [&](const Wire& wire) { return !wire.negated && canMove(static_cast<int>(wire.from)); });
  }

  int contact(int i, int source) {
    const int from = input(at(i).inputs.at(0), source);
    PlanNode node = nodeOf(texts_, i);
    node.kind = NodeKind::Contact;
    node.inputs = {{from}};
    node.sign = std::string(at(i).desc->drawnName());
    addAbove(node, texts_.operand(i, 0));
    if (at(i).operands.size() > 1) node.below = {texts_.operand(i, 1).whole()};
    // Moved behind another part of a series: power needs both.
    const Flow3 before = plan_.nodes[static_cast<std::size_t>(from)].output;
    if (!at(i).operands.empty() && before != Flow3::Unknown)
      node.output = before == Flow3::On && node.state == Flow3::On ? Flow3::On : Flow3::Off;
    return add(std::move(node));
  }

  int join(int i, int source) {
    PlanNode node = nodeOf(texts_, i);
    node.kind = NodeKind::Join;
    gather(i, source, node.inputs);
    bool isOn = false;
    for (const NodeInput& input : node.inputs)
      isOn = isOn || plan_.nodes[static_cast<std::size_t>(input.from)].output == Flow3::On;
    if (node.output != Flow3::Unknown) node.output = isOn ? Flow3::On : Flow3::Off;
    return add(std::move(node));
  }
  /// Branches of branches are branches of the same place.
  void gather(int i, int source, std::vector<NodeInput>& inputs) {
    for (const Wire& wire : at(i).inputs) {
      const auto from = static_cast<int>(wire.from);
      if (!wire.negated && at(from).shape == Shape::Or && uses_[wire.from] == 1)
        gather(from, source, inputs);
      else
        inputs.push_back({input(wire, source)});
    }
  }

  int box(int i, int source) {
    PlanNode node = boxNode(texts_, at(i), i, uses_[static_cast<std::size_t>(i)] > 0);
    const std::vector<std::string> pins = powerPinsOf(texts_, at(i));
    for (std::size_t k = 0; k < at(i).inputs.size(); ++k) {
      node.inputs.push_back({input(at(i).inputs[k], source), false, k < pins.size() ? pins[k] : std::string()});
    }
    return add(std::move(node));
  }

  int coil(int i, int source) {
    const Element& element = at(i);
    const int from = element.inputs.empty() ? rail() : input(element.inputs[0], source);
    PlanNode node = nodeOf(texts_, i);
    node.kind = isBracket(*element.desc) ? NodeKind::Heading : NodeKind::Coil;
    node.hasOutput = false;
    node.output = plan_.nodes[static_cast<std::size_t>(from)].output;
    node.inputs = {{from}};
    node.sign = std::string(element.desc->drawnName());
    addAbove(node, texts_.operand(i, 0));
    if (element.operands.size() > 1) node.below = {texts_.operand(i, 1).whole()};
    return add(std::move(node));
  }

  const Drawing& drawing_;
  const ElementTexts& texts_;
  std::vector<int> uses_;
  PlanNodes plan_;
  std::map<int, int> made_;
  int rail_ = -1;
};

}  // namespace

PlanNodes ladderNodes(const Drawing& drawing, const ElementTexts& texts) { return LadderPlan(drawing, texts).plan(); }

}  // namespace rungproof
