// Signal correspondence over gates: latches and gates over latches that are constant or equal to each other in every
// reachable state. Sums and comparisons that a program and its property make in two ways are tied together bit by bit,
// which proves much that clauses over the state's own truth values cannot say.
// Tested by tests/solver/invariants_gates_test.cpp.
#pragma once

#include <cstdint>
#include <vector>

#include "analysis/bits/engine_contract.hpp"
#include "analysis/graph/transition_system.hpp"

namespace rungproof {

/// What the questions ask about the end of a scan, asked about its start: nodes with states in place of what becomes of
/// them. Adds nodes to the graph.
std::vector<Node> askedAtStart(const TransitionSystem& system, const Questions& questions);

/// Literals over latches that are true in every reachable state, inductive together: each says that two gates are
/// equal, or what one is. Adds gates. Nothing if the budget ends.
std::vector<Lit> mineEqualGates(BitSystem& system, std::uint64_t seed, const Budget& budget);

}  // namespace rungproof
