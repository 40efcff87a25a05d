// Candidates are told apart by evaluating them in the two states; no solver is asked.
#include "analysis/words/refinement.hpp"

#include <algorithm>

#include "analysis/words/terms.hpp"

namespace rungproof {

namespace {

constexpr std::size_t storeLimit = 1500;
constexpr std::size_t mostHeld = 6, mostFitting = 2, mostCarried = 4;  ///< predicates that one refinement adds

}  // namespace

Refinement::Refinement(WordCone& cone, Predicates& predicates) : cone_(cone), predicates_(predicates) {
  std::vector<Node> nodes = linearPredicates(cone, predicates.samples());
  for (const Node n : orderPredicates(cone, storeLimit)) nodes.push_back(n);
  for (const Node n : nodes) {
    if (cone.graph()[n].op == Op::Constant) continue;
    const std::vector<std::uint64_t> values = predicates.overSamples(n);
    std::size_t ones = 0;
    for (const std::uint64_t block : values) ones += static_cast<std::size_t>(std::popcount(block));
    const bool hasHeld = !values.empty() && (ones == 0 || ones == predicates.samples().size());
    store_.push_back({n, hasHeld, ones != 0});
  }
}

bool Refinement::addDistinguishing(const std::vector<Node>& nodes, std::size_t most, const WordState& reached, const WordState& other) {
  const std::vector<bool> here = predicates_.valuesIn(reached, nodes), there = predicates_.valuesIn(other, nodes);
  std::size_t added = 0;
  for (std::size_t i = 0; i < nodes.size() && added < most; ++i) {
    if (here[i] != there[i] && predicates_.add(nodes[i])) ++added;
  }
  return added > 0;
}

bool Refinement::refine(const WordState& reached, const WordStep& step, Node goal) {
  std::vector<Node> all;
  for (const Candidate& c : store_) all.push_back(c.node);
  const std::vector<bool> here = predicates_.valuesIn(reached, all);
  std::vector<Node> held, fitting;
  for (std::size_t i = 0; i < store_.size(); ++i) {
    if (store_[i].hasHeld && store_[i].value == here[i]) held.push_back(all[i]);
    else fitting.push_back(all[i]);
  }
  if (addDistinguishing(held, mostHeld, reached, step.state)) return true;
  const bool hasFitting = addDistinguishing(fitting, mostFitting, reached, step.state);
  const bool hasCarried = addDistinguishing(carriedBack(step.state, step.inputs, goal), mostCarried, reached, step.state);
  return hasFitting || hasCarried;
}

std::vector<Node> Refinement::carriedBack(const WordState& state, const std::vector<std::uint64_t>& inputs, Node goal) {
  Graph& graph = cone_.graph();
  std::unordered_map<std::uint32_t, Node> chosen;
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    const Node input = cone_.system().inputs[i];
    chosen.emplace(indexOf(input), graph.constantNode(inputs[i], graph[input].width));
  }
  const Node root = Substitution(graph, std::move(chosen))(goal);

  // Terms take the arms that the state chooses; the conditions of the choices are predicates as well.
  const Node roots[] = {root};
  Evaluator evaluator(graph, roots);
  for (std::size_t i = 0; i < state.size(); ++i) evaluator.set(cone_.system().states[i].node, state[i]);
  evaluator.run();
  std::vector<Node> result;
  std::unordered_map<std::uint32_t, Node> straight;
  for (const Node n : coneOf(graph, roots)) {
    const NodeData node = graph[n];
    if (node.op == Op::Variable || node.op == Op::Constant) {
      straight.emplace(indexOf(n), n);
      if (node.op == Op::Variable && node.width == 1) result.push_back(n);
      continue;
    }
    if (node.op == Op::Ite && node.width > 1) {
      straight.emplace(indexOf(n), straight.at(indexOf(node.child[evaluator[node.child[0]] != 0 ? 1 : 2])));
      continue;
    }
    std::array<Node, 3> child = node.child;
    for (Node& c : child) {
      if (c != noNode) c = straight.at(indexOf(c));
    }
    const Node made = child == node.child ? n : graph.make(node.op, node.width, child[0], child[1], child[2], node.value);
    straight.emplace(indexOf(n), made);
    const bool isOverWords = node.width == 1 && graph[node.child[0]].width > 1;
    if (isOverWords && graph[made].op != Op::Constant) result.push_back(made);
  }
  return result;
}

}  // namespace rungproof
