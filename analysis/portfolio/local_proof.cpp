// The surface in layers by the distance from the property; negations count for nothing.
#include "analysis/portfolio/local_proof.hpp"

#include <unordered_set>

#include "analysis/bits/bit_blast.hpp"
#include "analysis/bits/bit_cnf.hpp"
#include "analysis/bits/sat.hpp"
#include "analysis/schedule/schedule.hpp"

namespace rungproof {

namespace {

constexpr int depths[] = {4, 16};

/// Nodes within that distance; those at its edge are open.
struct Surface {
  std::size_t size = 0;
  std::unordered_set<std::uint32_t> open;
  std::vector<Node> variables;
};

Surface surfaceOf(const Graph& graph, Node root, int depth) {
  Surface surface;
  std::unordered_set<std::uint32_t> seen{indexOf(root)};
  std::vector<Node> layer{root};
  for (int distance = 0; !layer.empty(); ++distance) {
    std::vector<Node> next;
    for (std::size_t i = 0; i < layer.size(); ++i) {
      const NodeData& node = graph[layer[i]];
      if (node.op == Op::Variable) surface.variables.push_back(layer[i]);
      if (node.op == Op::Variable || node.op == Op::Constant) continue;
      if (distance >= depth) {
        surface.open.insert(indexOf(layer[i]));
        continue;
      }
      ++surface.size;
      for (const Node child : node.child) {
        if (child == noNode || !seen.insert(indexOf(child)).second) continue;
        (graph[child].op == Op::Not ? layer : next).push_back(child);
      }
    }
    layer = std::move(next);
  }
  return surface;
}

}  // namespace

std::optional<std::vector<Node>> proveLocally(const TransitionSystem& system, Node bad, const Budget& budget,
                                              const KnownVariables& known, std::vector<Node>* used) {
  Graph& graph = *system.graph;
  for (const int depth : depths) {
    if (budget.isExhausted()) break;
    const Surface surface = surfaceOf(graph, bad, depth);
    if (surface.size > schedule::surfaceNodes) return std::nullopt;
    std::vector<Node> facts;
    for (const Node n : surface.variables) {
      if (const auto found = known.find(indexOf(n)); found != known.end())
        facts.push_back(graph.make(Op::Equal, 1, n, graph.constantNode(found->second, graph[n].width)));
    }
    Node goal = bad;
    for (const Node fact : facts) goal = graph.make(Op::And, 1, goal, fact);
    const BitBlast blast(system, goal, surface.open);
    const Lit l = blast.bits().bads[0];
    Sat::Outcome outcome = l == falseLit ? Sat::Outcome::Unsatisfiable : Sat::Outcome::Satisfiable;
    if (variableOf(l) != 0) {
      Sat sat(Sat::Use::Many);
      BitCnf cnf(blast.bits(), sat);
      sat.add({cnf.literal(l)});
      outcome = sat.solve({}, budget.slice(schedule::surfaceQuerySeconds));
    }
    if (outcome == Sat::Outcome::Unsatisfiable) {
      std::vector<Node> open;
      for (const std::uint32_t n : surface.open) open.push_back(static_cast<Node>(n));
      if (used != nullptr) used->insert(used->end(), facts.begin(), facts.end());
      return open;
    }
    if (surface.open.empty()) return std::nullopt;
  }
  return std::nullopt;
}

}  // namespace rungproof
