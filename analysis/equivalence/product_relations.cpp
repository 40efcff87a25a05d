// What the memories of both programs have in common before any proof: relations between cells of different form, each
// with its start, its break and whether it is true at first, and equal starts of what is paired.
#include <algorithm>
#include <map>

#include "analysis/equivalence/product.hpp"
#include "analysis/graph/evaluate.hpp"
#include "ir/check.hpp"

namespace rungproof {

std::vector<std::string> ProgramProduct::oldBitNames() const {
  std::vector<std::string> names;
  const Graph& graph = *oldSystem_.graph;
  for (const StateVariable& state : oldSystem_.states) {
    if (graph[state.node].width == 1) names.push_back(graph.variables()[graph[state.node].value].name);
  }
  return names;
}

std::vector<PairCondition> ProgramProduct::relationConditions() const {
  std::vector<PairCondition> conditions;
  for (std::string& name : relations_.names()) conditions.push_back({std::move(name), {}, true});
  return conditions;
}

/// Whether OLD's memory begins with it.
bool ProgramProduct::isTrueAtFirst(Node relation) const {
  const Graph& graph = *oldSystem_.graph;
  const Node roots[] = {relation};
  Evaluator evaluator(graph, roots);
  for (const Node n : coneOf(graph, roots)) {
    if (graph[n].op != Op::Variable) continue;
    const auto state = std::ranges::find(oldSystem_.states, n, &StateVariable::node);
    if (state == oldSystem_.states.end() || state->init == noNode) return false;
    evaluator.set(n, graph[state->init].value);
  }
  evaluator.run();
  return evaluator[relation] != 0;
}

void ProgramProduct::addRelations(JoinedSystem& result, const std::vector<PairCondition>& conditions) {
  if (std::ranges::none_of(conditions, [](const PairCondition& c) { return c.condition.empty(); })) return;
  Graph& graph = old_.encoding().graph();
  SideCopy first(graph, new_.encoding().graph(), " (new, before the first scan)");
  for (const StateVariable& state : newSystem_.states) {
    if (state.init != noNode) first.replace(state.node, (*result.copy)(state.init));
  }
  std::map<std::string, MemoryRelation> relations;
  for (MemoryRelation& relation :
       relations_.relations({[&](Node n) { return (*result.copy)(n); }, [&](Node n) { return first(n); }}))
    relations.emplace(relation.name, relation);
  for (std::size_t i = 0; i < conditions.size(); ++i) {
    if (!conditions[i].condition.empty()) continue;
    const MemoryRelation& relation = relations.at(conditions[i].state);
    if (!isTrueAtFirst(relation.first)) {
      result.conditionBreaks[i] = graph.constantNode(1, 1);
      continue;
    }
    result.starts.push_back(relation.first);
    result.conditionStarts[i] = relation.start;
    result.conditionBreaks[i] = graph.lnot({relation.end}).node;
  }
}

/// What starts with any value starts with the same where it is paired, whatever becomes of it later.
void ProgramProduct::startAlike(JoinedSystem& result, Node before, Node after) {
  Graph& graph = old_.encoding().graph();
  const Graph::Bool later = graph.lnot({firstScan_});
  const Node alike = graph.lor(later, graph.equal({before}, {after}, graph[after].width)).node;
  result.system.constraints.push_back(alike);
  result.system.totalConstraints.push_back(alike);
}

}  // namespace rungproof
