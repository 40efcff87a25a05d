// Cones of influence on words, largest first.
#include "analysis/portfolio/clusters.hpp"

#include <algorithm>
#include <unordered_map>

namespace rungproof {

namespace {

struct ConeOfQuestion {
  std::size_t question = 0;
  std::vector<std::size_t> states;  ///< indices in TransitionSystem::states
  int bits = 0;
};

}  // namespace

std::vector<std::vector<std::size_t>> clustersOf(const TransitionSystem& system,
                                                 const std::vector<std::size_t>& questions) {
  const Graph& graph = *system.graph;
  std::unordered_map<std::uint32_t, std::size_t> stateOf;
  for (std::size_t i = 0; i < system.states.size(); ++i) stateOf.emplace(indexOf(system.states[i].node), i);
  std::vector<std::uint32_t> mark(graph.size(), 0);
  std::uint32_t round = 0;
  std::vector<ConeOfQuestion> reaches;
  for (const std::size_t q : questions) {
    ++round;
    ConeOfQuestion& reach = reaches.emplace_back(ConeOfQuestion{q, {}, 0});
    std::vector<Node> stack{system.questions[q].bad};
    while (!stack.empty()) {
      const Node n = stack.back();
      stack.pop_back();
      if (mark[indexOf(n)] == round) continue;
      mark[indexOf(n)] = round;
      const NodeData& node = graph[n];
      if (node.op == Op::Variable) {
        const auto state = stateOf.find(indexOf(n));
        if (state == stateOf.end()) continue;
        reach.states.push_back(state->second);
        reach.bits += node.width;
        stack.push_back(system.states[state->second].next);
        continue;
      }
      for (const Node child : node.child) {
        if (child != noNode) stack.push_back(child);
      }
    }
  }
  std::stable_sort(reaches.begin(), reaches.end(),
                   [](const ConeOfQuestion& a, const ConeOfQuestion& b) { return a.bits > b.bits; });
  std::vector<std::vector<std::size_t>> clusters;
  std::vector<std::vector<bool>> covered;
  for (const ConeOfQuestion& reach : reaches) {
    std::size_t home = clusters.size();
    for (std::size_t c = 0; c < clusters.size() && home == clusters.size(); ++c) {
      int shared = 0;
      for (const std::size_t s : reach.states) shared += covered[c][s] ? graph[system.states[s].node].width : 0;
      if (shared * 2 >= reach.bits) home = c;
    }
    if (home == clusters.size()) {
      clusters.emplace_back();
      covered.emplace_back(system.states.size(), false);
    }
    clusters[home].push_back(reach.question);
    for (const std::size_t s : reach.states) covered[home][s] = true;
  }
  return clusters;
}

}  // namespace rungproof
