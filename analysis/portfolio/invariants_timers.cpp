// Timers are those that the encoder names; what stays on, and what two bits have in common until then, by
// their next-state functions.
#include "analysis/portfolio/invariants_timers.hpp"

#include <unordered_map>
#include <unordered_set>

#include "analysis/schedule/schedule.hpp"

namespace rungproof {

namespace {

bool isConstantOne(const Graph& graph, Node n) { return graph[n].op == Op::Constant && graph[n].value == 1; }

/// A timer that a jump may leave out has seen its input's driver as long as the jump was never taken: while a bit that
/// then stays on is off, the remembered input equals each bit that is written with the same value.
void guessSeenInputs(const TransitionSystem& system, const std::vector<std::size_t>& inputs,
                     std::vector<NodeClause>& clauses) {
  Graph& graph = *system.graph;
  std::vector<std::size_t> bits, lasting;
  for (std::size_t i = 0; i < system.states.size(); ++i) {
    if (graph[system.states[i].node].width != 1 || system.states[i].next == noNode) continue;
    bits.push_back(i);
    const bool isLasting = isConstantOne(graph, graph.given(system.states[i].next, system.states[i].node));
    if (isLasting && lasting.size() < schedule::lastingLimit) lasting.push_back(i);
  }
  std::size_t looks = 0;
  for (const std::size_t last : lasting) {
    const Node off = graph.make(Op::Not, 1, system.states[last].next);
    for (const std::size_t input : inputs) {
      const Node seen = graph.given(system.states[input].next, off);
      for (const std::size_t bit : bits) {
        if (bit == input || bit == last || ++looks > schedule::timerPairs) continue;
        if (graph.given(system.states[bit].next, off) != seen) continue;
        const Node in = system.states[input].node, other = system.states[bit].node;
        clauses.push_back({system.states[last].node, graph.make(Op::Not, 1, in), other});
        clauses.push_back({system.states[last].node, in, graph.make(Op::Not, 1, other)});
      }
    }
  }
}

}  // namespace

std::vector<NodeClause> guessTimerStates(const TransitionSystem& system) {
  Graph& graph = *system.graph;
  std::unordered_map<Node, const TimerHint*> byRunning;
  std::unordered_set<Node> isInput;
  for (const TimerHint& timer : system.timers) {
    byRunning.emplace(timer.running, &timer);
    isInput.insert(timer.input);
  }
  std::unordered_set<Node> isState;
  std::vector<std::size_t> inputs;
  for (std::size_t i = 0; i < system.states.size(); ++i) {
    isState.insert(system.states[i].node);
    if (isInput.contains(system.states[i].node) && system.states[i].next != noNode) inputs.push_back(i);
  }
  std::vector<NodeClause> clauses;
  for (const StateVariable& state : system.states) {
    const auto timer = byRunning.find(state.node);
    if (timer == byRunning.end()) continue;
    const auto [bit, input, running, rest, current] = *timer->second;
    if (isState.contains(bit) && isState.contains(input))
      clauses.push_back({graph.make(Op::Not, 1, bit), input, running});
    if (isState.contains(rest))
      clauses.push_back({running, graph.make(Op::Equal, 1, rest, graph.constantNode(0, graph[rest].width))});
  }
  guessSeenInputs(system, inputs, clauses);
  return clauses;
}

}  // namespace rungproof
