// What any number of runs of some routines keeps of the state itself: sets of rules (state_rule.hpp) of which one run
// of each routine leaves all in force if all were. Rules are guessed: bounds by the constants of the routines, the few
// values that a cell was seen with, cells that were seen alike, what a bit was seen to imply, and what properties say.
// Those that held in all states that were seen are proved together, and what one run breaks is left out; then each is
// joined with those that it rests on, so that rules which have nothing to do with each other stay apart.
// Covered by tests/environment/routine_invariant_test.cpp.
#pragma once

#include <map>
#include <set>
#include <vector>

#include "analysis/encoding/run_bounds.hpp"
#include "analysis/encoding/state_rule.hpp"

namespace rungproof {

/// What rules are guessed from.
struct RuleHints {
  std::vector<std::shared_ptr<const SaidOfMemory>> said;
  std::vector<std::map<Place, std::uint64_t>> seen;  ///< states
  std::map<int, std::set<std::uint64_t>> constants;  ///< by width
};

/// Adds nodes to the graph. `cells`: that runs read or write and nothing else changes meanwhile.
std::vector<StateRules> keptStates(Graph& graph, const std::vector<RunBounds::Cell>& cells,
                                   const std::vector<RunBounds::Run>& runs, const RuleHints& hints);

}  // namespace rungproof
