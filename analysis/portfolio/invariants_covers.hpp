// "One of the steps is always active": clauses over state bits of which no two are ever true together. A search that
// knows that steps exclude each other still has to find out that one of them is there, a clause of many literals.
// Tested by tests/solver/invariants_test.cpp.
#pragma once

#include <vector>

#include "analysis/portfolio/invariants.hpp"

namespace rungproof {

/// Clauses that hold in all reachable states, given `known` ones. Nothing when the budget ends. `asked`: indices of
/// latches for which "while it is on, one of the steps is active" is sought as well.
std::vector<std::vector<Lit>> mineCovers(const BitSystem& system, const Invariants& known,
                                         const std::vector<std::size_t>& asked, std::uint64_t seed,
                                         const Budget& budget);

}  // namespace rungproof
