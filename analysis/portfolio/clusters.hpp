// Groups of questions that depend on much the same variables: each group shares invariants and inductions, while
// questions about separate parts of a program stay small problems. Tested by tests/solver/portfolio_test.cpp.
#pragma once

#include <vector>

#include "analysis/graph/transition_system.hpp"

namespace rungproof {

/// Partition of `questions` (indices). A question joins the first larger group that covers half of its state bits.
std::vector<std::vector<std::size_t>> clustersOf(const TransitionSystem& system,
                                                 const std::vector<std::size_t>& questions);

}  // namespace rungproof
