// The rule for long scans as constraints.
#include "analysis/encoding/accelerate.hpp"

namespace rungproof {

void accelerate(TransitionSystem& system, Node dt, int width, const TimeRange& ordinary,
                const std::function<bool(Node)>& isTime) {
  Graph& graph = *system.graph;
  const Graph::Bool isLong = graph.ult(graph.literal(ordinary.high, width), {dt}, width);
  Graph::Bool steady = graph.constant(true);
  for (const StateVariable& state : system.states) {
    if (isTime(state.node)) continue;
    const int w = graph[state.node].width;
    steady = graph.land(steady, graph.equal({state.next}, {state.node}, w));
  }
  const Graph::Bool wasLong{graph.variable("long scan before", 1, true)};
  Graph::Bool same = graph.constant(true);
  std::vector<StateVariable> added{{wasLong.node, graph.constantNode(0, 1), isLong.node}};
  for (const Node input : system.inputs) {
    const Variable& variable = graph.variables()[graph[input].value];
    if (variable.name.rfind("time.", 0) == 0 || variable.name == "dt") continue;
    const int w = graph[input].width;
    const Node before = graph.variable(variable.name + " before", w, true);
    added.push_back({before, graph.constantNode(0, w), input});
    same = graph.land(same, graph.equal({before}, {input}, w));
  }
  system.states.insert(system.states.end(), added.begin(), added.end());
  for (Question& question : system.questions) {
    if (question.bad != noNode) question.bad = graph.land({question.bad}, graph.lnot(isLong)).node;
  }
  system.constraints.push_back(graph.lor(graph.lnot(isLong), steady).node);
  system.constraints.push_back(graph.lor(graph.lnot(wasLong), same).node);
  // From twice the shortest on, every length is that of some scans in a row.
  if (ordinary.high >= 2 * ordinary.low) return;
  const Node scans = graph.variable("time.scans", width, false);
  const auto together = [&](std::uint32_t length) { return graph.mul({scans}, graph.literal(length, width), width); };
  const std::uint64_t most = Graph::maskOf(width) / ordinary.high;
  const Graph::Bool fits =
      graph.land(graph.ule(together(ordinary.low), {dt}, width), graph.ule({dt}, together(ordinary.high), width));
  system.inputs.push_back(scans);
  system.constraints.push_back(graph.land(graph.ule({scans}, graph.literal(most, width), width), fits).node);
}

}  // namespace rungproof
