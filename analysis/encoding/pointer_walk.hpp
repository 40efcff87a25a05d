// The walk of a pointer that another cell limits: a ring buffer increases its pointer and starts again when a counter
// says so. Pointer and counters are followed together, tuple by tuple, through their next-state functions; all else may
// have any value. Exact in conditions that both depend on.
// Covered by tests/encoder/pointer_values_test.cpp.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "analysis/encoding/pointer_values.hpp"
#include "analysis/graph/transition_system.hpp"

namespace rungproof {

/// The values that the state variable takes after one scan or more, in ascending order, with the cells that limit it;
/// nothing if they are more than `limit`, or if no few cells limit it. `firstScans`: variables that are 1 at the start
/// of the first scan only. `interruption`, if set, is called now and then and may throw.
std::optional<Walk> walkOf(const TransitionSystem& system, Node pointer, const std::vector<Node>& firstScans,
                           std::size_t limit, const std::function<void()>& interruption = {});

}  // namespace rungproof
