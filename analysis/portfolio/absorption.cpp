// A latch is recognised by its form: s becomes "s or e", and bad is a conjunction with "not s" that excludes e.
#include "analysis/portfolio/absorption.hpp"

#include <algorithm>
#include <unordered_map>
#include <unordered_set>

#include "analysis/bits/bit_blast.hpp"
#include "analysis/bits/bit_cnf.hpp"
#include "analysis/bits/sat.hpp"
#include "analysis/graph/evaluate.hpp"
#include "analysis/graph/substitution.hpp"
#include "analysis/schedule/schedule.hpp"

namespace rungproof {

namespace {

/// Conjuncts of a node or of its complement, complements without their Not.
struct Conjuncts {
  std::unordered_set<std::uint32_t> positive, negative;

  void collect(const Graph& graph, Node n, bool isNegated) {
    const NodeData& node = graph[n];
    if (node.op == Op::Not) return collect(graph, node.child[0], !isNegated);
    if (!(isNegated ? negative : positive).insert(indexOf(n)).second) return;
    if (node.op != (isNegated ? Op::Or : Op::And)) return;
    collect(graph, node.child[0], isNegated);
    collect(graph, node.child[1], isNegated);
  }
};

/// Whether a scan that ends with the latch set is never bad. Mostly the graph sees it; else a solver has a moment.
bool isNeverBadWith(const TransitionSystem& system, Node bad, Node latchNow) {
  Graph& graph = *system.graph;
  const Node both = graph.make(Op::And, 1, bad, latchNow);
  if (graph[both].op == Op::Constant) return graph[both].value == 0;
  const BitBlast blast(system, both, {});
  const Lit l = blast.bits().bads[0];
  if (variableOf(l) == 0) return l == falseLit;
  Sat sat(Sat::Use::Many);
  BitCnf cnf(blast.bits(), sat);
  sat.add({cnf.literal(l)});
  return sat.solve({}, Budget::seconds(schedule::absorptionSeconds)) == Sat::Outcome::Unsatisfiable;
}

}  // namespace

std::optional<UnabsorbedSystem> beforeAbsorption(const TransitionSystem& given, std::size_t question) {
  Graph& graph = *given.graph;
  Conjuncts bad;
  bad.collect(graph, given.questions[question].bad, false);
  std::unordered_map<std::uint32_t, Node> replaced;
  UnabsorbedSystem result;
  result.latched = graph.constantNode(0, 1);
  Conjuncts excluded;
  for (const StateVariable& state : given.states) {
    if (graph[state.node].width != 1 || state.init == noNode || !bad.negative.contains(indexOf(state.node))) continue;
    const NodeData& init = graph[state.init];
    if (init.op != Op::Constant || init.value != 0) continue;
    Conjuncts unset;
    unset.collect(graph, state.next, true);
    if (!unset.negative.contains(indexOf(state.node)) ||
        !isNeverBadWith(given, given.questions[question].bad, state.next))
      continue;
    replaced.emplace(indexOf(state.node), graph.constantNode(0, 1));
    result.latched = graph.make(Op::Or, 1, result.latched, state.node);
    excluded.collect(graph, state.next, true);
  }
  if (replaced.empty()) return std::nullopt;

  const std::unordered_map<std::uint32_t, Node> latches = replaced;
  std::vector<Node> conditions, ofStates;  // on each scan, that leave the latches as they are
  const auto exclude = [&](std::uint32_t index, bool value) {
    const Node n = static_cast<Node>(index);
    if (latches.contains(index) || (graph[n].op == Op::Or && !value) || (graph[n].op == Op::And && value)) return;
    const Node condition = value ? n : graph.make(Op::Not, 1, n), constant = graph.constantNode(value ? 1 : 0, 1);
    if (graph[n].op != Op::Variable) {
      conditions.push_back(condition);
      return;
    }
    if (replaced.emplace(index, constant).first->second != constant) conditions.push_back(graph.constantNode(0, 1));
    // A state that would set a latch ends the run before the scan that finds it, not with the scan that makes it.
    if (graph.variables()[graph[n].value].isState) ofStates.push_back(condition);
  };
  for (const std::uint32_t index : excluded.negative) exclude(index, false);
  for (const std::uint32_t index : excluded.positive) exclude(index, true);
  for (std::size_t i = 0; i < given.inputs.size(); ++i) {
    if (const auto fixed = replaced.find(indexOf(given.inputs[i])); fixed != replaced.end())
      result.fixedInputs.emplace_back(i, graph[fixed->second].value);
  }

  Substitution unlatched(graph, replaced);
  TransitionSystem& system = result.system = given;
  for (StateVariable& state : system.states) state.next = unlatched(state.next);
  // What inputs of its own can meet in any state, a constant among them may not.
  std::erase_if(system.totalConstraints, [&](Node constraint) {
    const Node roots[] = {constraint};
    return std::ranges::any_of(coneOf(graph, roots), [&](Node n) { return replaced.contains(indexOf(n)); });
  });
  system.constraints.insert(system.constraints.end(), conditions.begin(), conditions.end());
  for (Node& constraint : system.constraints) constraint = unlatched(constraint);
  system.constraints.insert(system.constraints.end(), ofStates.begin(), ofStates.end());
  for (Question& q : system.questions) q.bad = noNode;
  system.questions[question].bad = unlatched(given.questions[question].bad);
  return result;
}

}  // namespace rungproof
