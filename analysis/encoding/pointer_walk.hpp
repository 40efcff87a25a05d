// The walk of a pointer that another cell limits: a ring buffer increases its pointer and starts again when a counter
// says so. Pointer and counters are followed together, tuple by tuple, through their next-state functions; all else may
// have any value. Exact in conditions that both depend on.
// Covered by tests/encoder/pointer_values_test.cpp.
#pragma once

#include <optional>
#include <vector>

#include "analysis/graph/transition_system.hpp"

namespace rungproof {

/// The values that the state variable takes, in ascending order; nothing if they are more than `limit`, or if no few
/// cells limit it.
std::optional<std::vector<std::uint64_t>> walkOf(const TransitionSystem& system, Node pointer, std::size_t limit);

}  // namespace rungproof
