// Candidate invariants between words that count the same thing: timer values, monitors of properties, counters.
// Where two words x and y grow by the same amount scan after scan, x - y stays within bounds - until one of them stops
// at its cap. Each bound becomes a clause "x - y <= hi or y has reached its cap" (and so for the other side), which
// does not depend on how far the words count: proofs about timers do not grow with presets.
// Tested by tests/solver/invariants_test.cpp.
#pragma once

#include <vector>

#include "analysis/bits/bit_blast.hpp"

namespace rungproof {

/// A clause of nodes over states: at least one holds, presumably in all reachable states.
using NodeClause = std::vector<Node>;

/// Guesses from random runs of the blasted system. `blast` covers the cone of interest.
std::vector<NodeClause> guessDifferences(const TransitionSystem& system, const BitBlast& blast, std::uint64_t seed,
                                         const Budget& budget);

}  // namespace rungproof
