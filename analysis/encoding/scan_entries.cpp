// What the effects of interrupt routines rest on (RoutineEffects::entry): learned at each place where routines can
// come, and at last shown there. Where the values at a place are so in any case, whether or not a routine comes, they
// are so behind the routines as well, because each run keeps them; that spares the analysis a look into each run.
#include "analysis/encoding/scan_encoding.hpp"
#include "analysis/encoding/scan_round.hpp"

namespace rungproof {

void ScanEncoding::noteEntry(Round& round, Graph::Bool mayCome) {
  for (const auto& [place, known] : effects_->entry()) {
    if (known == ValueSet::any(place.width)) continue;
    const Node value = store_.value(place), guard = here(mayCome).node;
    ValueSet values;
    const auto answer = graph.listed([&]() -> std::optional<std::vector<std::uint64_t>> {
      values = pointerValues(value, graph.constantNode(1, 1));
      return std::vector<std::uint64_t>{known.includes(values) ? 1ULL : 0ULL};
    });
    const bool isAlways = answer && !answer->empty() && answer->front() == 1;
    if (isAlways) round.kept.emplace(place, known);
    if (graph.isAsWritten()) {
      const Graph::Bool fact = isIn(graph, value, known);
      listFacts.push_back(isAlways ? fact.node : graph.lor(graph.lnot({guard}), fact).node);
      continue;
    }
    if (!isAlways) values = pointerValues(value, guard);
    restsOnEntries_ = true;
    entryValues_[place].join(values, pointerValueLimit);
    if (knowledge_.isFinal && !known.includes(values))
      leaveOut(nullptr, "an interrupt routine begins with values that its effects were not found for", {guard});
  }
}

void ScanEncoding::tellKept(const Round& round) {
  for (const auto& [place, known] : round.kept) {
    const Node value = store_.value(place);
    if (graph.isAsWritten())
      listFacts.push_back(isIn(graph, value, known).node);
    else if (graph[value].op != Op::Variable && graph[value].op != Op::Constant)
      known_[value] = keptValues_[value] = known;
  }
}

}  // namespace rungproof
