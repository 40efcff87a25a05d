// State predicates worth relating to each other: truth values of the state, and comparisons of its words with the
// constants that the program compares them with ("the timer has reached its preset").
// Tested by tests/solver/invariants_test.cpp.
#pragma once

#include <vector>

#include "analysis/graph/transition_system.hpp"

namespace rungproof {

/// Nodes of width 1 over state variables in the cone of the questions; comparisons are made in the graph. At most
/// `limit` of them, truth values first.
std::vector<Node> stateTruths(const TransitionSystem& system, const std::vector<std::size_t>& questions,
                              std::size_t limit);

/// By index in TransitionSystem::states: what the questions speak of themselves, as it is before a scan or after it.
std::vector<bool> statesAskedFor(const TransitionSystem& system, const std::vector<std::size_t>& questions);

}  // namespace rungproof
