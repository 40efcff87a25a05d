// The cone as a fixpoint over next states and constraints, then copied node by node, children first.
#include "analysis/words/word_cone.hpp"

#include <algorithm>

#include "analysis/graph/evaluate.hpp"
#include "ir/domain.hpp"

namespace rungproof {

namespace {

/// Adds to `to` what stands for `nodes` of `from`; `known` maps variables, by index in `from`.
void copyNodes(const Graph& from, Graph& to, std::span<const Node> nodes,
               std::unordered_map<std::uint32_t, Node>& known) {
  for (const Node n : coneOf(from, nodes)) {
    if (known.contains(indexOf(n))) continue;
    const NodeData& node = from[n];
    if (node.op == Op::Constant) {
      known.emplace(indexOf(n), to.constantNode(node.value, node.width));
      continue;
    }
    std::array<Node, 3> child = node.child;
    for (Node& c : child) {
      if (c != noNode) c = known.at(indexOf(c));
    }
    known.emplace(indexOf(n), to.make(node.op, node.width, child[0], child[1], child[2], node.value));
  }
}

bool computesReals(Op op) { return op >= Op::RealAdd; }

/// Which nodes of the graph the question depends on, through any number of scans.
class Reached {
 public:
  explicit Reached(const TransitionSystem& system) : system_(system), graph_(*system.graph), in_(graph_.size(), false) {
    for (std::size_t i = 0; i < system.states.size(); ++i) state_.emplace(indexOf(system.states[i].node), i);
  }
  bool contains(Node n) const { return in_[indexOf(n)]; }
  void add(Node root) {
    std::vector<Node> stack{root};
    while (!stack.empty()) {
      const Node n = stack.back();
      stack.pop_back();
      if (in_[indexOf(n)]) continue;
      in_[indexOf(n)] = true;
      for (const Node child : graph_[n].child) {
        if (child != noNode) stack.push_back(child);
      }
      if (const auto state = state_.find(indexOf(n)); state != state_.end())
        stack.push_back(system_.states[state->second].next);
    }
  }
  bool meets(Node root) const {
    const Node roots[] = {root};
    return std::ranges::any_of(coneOf(graph_, roots),
                               [&](Node n) { return graph_[n].op == Op::Variable && contains(n); });
  }

 private:
  const TransitionSystem& system_;
  const Graph& graph_;
  std::vector<bool> in_;
  std::unordered_map<std::uint32_t, std::size_t> state_;
};

}  // namespace

WordCone::WordCone(const TransitionSystem& given, std::size_t question) {
  Reached reached(given);
  reached.add(given.questions[question].bad);
  std::vector<Node> constraints, optional;
  for (const Node n : given.constraints) {
    const bool isTotal = std::ranges::find(given.totalConstraints, n) != given.totalConstraints.end();
    (isTotal ? optional : constraints).push_back(n);
    if (!isTotal) reached.add(n);
  }
  for (bool grows = true; grows;) {
    grows = false;
    for (Node& n : optional) {
      if (n == noNode || !reached.meets(n)) continue;
      reached.add(n);
      constraints.push_back(n);
      n = noNode;
      grows = true;
    }
  }

  const Graph& from = *given.graph;
  std::unordered_map<std::uint32_t, Node> known;
  std::vector<Node> roots = constraints;
  roots.push_back(given.questions[question].bad);
  for (std::size_t i = 0; i < given.inputs.size(); ++i) {
    if (!reached.contains(given.inputs[i])) continue;
    const NodeData& node = from[given.inputs[i]];
    inputs_.push_back(i);
    system_.inputs.push_back(graph_.variable(from.variables()[node.value].name, node.width, false));
    known.emplace(indexOf(given.inputs[i]), system_.inputs.back());
  }
  for (std::size_t i = 0; i < given.states.size(); ++i) {
    const StateVariable& state = given.states[i];
    if (!reached.contains(state.node)) continue;
    const NodeData& node = from[state.node];
    states_.push_back(i);
    const Node copy = graph_.variable(from.variables()[node.value].name, node.width, true);
    system_.states.push_back(
        {copy, state.init == noNode ? noNode : graph_.constantNode(from[state.init].value, node.width), noNode});
    known.emplace(indexOf(state.node), copy);
    roots.push_back(state.next);
  }
  copyNodes(from, graph_, roots, known);
  for (std::size_t i = 0; i < states_.size(); ++i)
    system_.states[i].next = known.at(indexOf(given.states[states_[i]].next));
  for (const Node n : constraints) system_.constraints.push_back(known.at(indexOf(n)));
  system_.questions.push_back({given.questions[question].name, known.at(indexOf(given.questions[question].bad))});
  system_.graph = &graph_;
  for (std::uint32_t i = 0; i < graph_.size(); ++i) {
    const NodeData& node = graph_[static_cast<Node>(i)];
    hasReals_ = hasReals_ || computesReals(node.op);
    hasOpaque_ = hasOpaque_ || node.op == Op::LongReal ||
                 (node.op == Op::RealFunction && static_cast<RealFunction>(node.value) != RealFunction::Sqrt);
  }
}

Node WordCone::onGivenSystem(const TransitionSystem& given, Node n) const {
  std::unordered_map<std::uint32_t, Node> known;
  for (std::size_t i = 0; i < states_.size(); ++i)
    known.emplace(indexOf(system_.states[i].node), given.states[states_[i]].node);
  for (std::size_t i = 0; i < inputs_.size(); ++i) known.emplace(indexOf(system_.inputs[i]), given.inputs[inputs_[i]]);
  const Node roots[] = {n};
  copyNodes(graph_, *given.graph, roots, known);
  return known.at(indexOf(n));
}

}  // namespace rungproof
