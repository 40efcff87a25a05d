// States that a program was seen in: the reference engine makes some runs with any inputs, in which interrupts come at
// any place. What holds in all of them is worth a proof (kept_states.hpp). Covered by
// tests/environment/routine_invariant_test.cpp.
#pragma once

#include <map>
#include <vector>

#include "analysis/encoding/symbolic_store.hpp"
#include "engine/concrete.hpp"
#include "ir/machine/plan.hpp"

namespace rungproof {

/// The value at a place in a state of the engine, as encodings have it: memory with its first byte highest.
std::uint64_t valueAt(const Place& place, const Concrete::Store& state);

/// Values of the places at the ends of scans, each state once; of a long program at power-up only. `events`: those that
/// the program attaches.
std::vector<std::map<Place, std::uint64_t>> seenStates(const Plan& plan, const std::vector<int>& events,
                                                       const std::vector<Place>& places);

}  // namespace rungproof
