// The truth is recognised by its form: it begins with 1, becomes 0, and bad is a conjunction with it.
#include "analysis/portfolio/first_scan.hpp"

#include <unordered_map>

#include "analysis/graph/evaluate.hpp"
#include "analysis/graph/substitution.hpp"

namespace rungproof {

namespace {

bool isConjunct(const Graph& graph, Node n, Node all) {
  if (n == all) return true;
  const NodeData& node = graph[all];
  return node.op == Op::And && (isConjunct(graph, n, node.child[0]) || isConjunct(graph, n, node.child[1]));
}

}  // namespace

std::optional<FirstScanSystem> inFirstScan(const TransitionSystem& given, std::size_t question) {
  Graph& graph = *given.graph;
  const Node bad = given.questions[question].bad;
  const auto isConstant = [&](Node n, std::uint64_t value) {
    return n != noNode && graph[n].op == Op::Constant && graph[n].value == value;
  };
  FirstScanSystem result;
  for (const StateVariable& state : given.states) {
    if (graph[state.node].width == 1 && isConstant(state.init, 1) && isConstant(state.next, 0) &&
        isConjunct(graph, state.node, bad))
      result.isLater = graph.make(Op::Not, 1, state.node);
  }
  if (result.isLater == noNode) return std::nullopt;

  std::unordered_map<std::uint32_t, Node> initial;
  for (const StateVariable& state : given.states) {
    if (state.init != noNode && graph[state.init].op == Op::Constant) initial.emplace(indexOf(state.node), state.init);
  }
  std::vector<Node> roots = given.constraints;
  roots.push_back(bad);
  for (const Node n : coneOf(graph, roots)) {
    if (const auto init = initial.find(indexOf(n)); init != initial.end())
      result.starts.push_back(graph.make(Op::Equal, 1, n, init->second));
  }
  Substitution atStart(graph, initial);
  TransitionSystem& system = result.system = given;
  for (StateVariable& state : system.states) state.next = state.node;
  for (Node& n : system.constraints) n = atStart(n);
  system.totalConstraints.clear();
  for (Question& q : system.questions) q.bad = noNode;
  system.questions[question].bad = atStart(bad);
  return result;
}

}  // namespace rungproof
