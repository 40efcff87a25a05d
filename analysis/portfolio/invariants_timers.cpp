// Timers are recognised by the names of their registers.
#include "analysis/portfolio/invariants_timers.hpp"

#include <string_view>
#include <unordered_map>

namespace rungproof {

std::vector<NodeClause> guessTimerStates(const TransitionSystem& system) {
  constexpr std::string_view running = ".running", input = ".in";
  Graph& graph = *system.graph;
  std::unordered_map<std::string_view, Node> states;
  for (const StateVariable& state : system.states)
    states.emplace(graph.variables()[graph[state.node].value].name, state.node);
  std::vector<NodeClause> clauses;
  for (const StateVariable& state : system.states) {
    const std::string& name = graph.variables()[graph[state.node].value].name;
    if (name.size() <= running.size() || name.compare(name.size() - running.size(), running.size(), running) != 0)
      continue;
    const std::string timer = name.substr(0, name.size() - running.size());
    const auto bit = states.find(timer), in = states.find(timer + std::string(input));
    if (bit == states.end() || in == states.end()) continue;
    clauses.push_back({graph.make(Op::Not, 1, bit->second), in->second, state.node});
  }
  return clauses;
}

}  // namespace rungproof
