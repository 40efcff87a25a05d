// Groups of truth values of which at most one holds, such as the steps of a sequence. A group says in one invariant
// what takes a clause for each of its pairs, n (n - 1) / 2 of them: a literal l is not on together with any literal
// before it, and "one of those before l" is one gate more than for the literal before. So mining, proofs and
// certificates grow with the number of steps and not with its square. Tested by tests/solver/invariant_groups_test.cpp.
#pragma once

#include <vector>

#include "analysis/bits/bit_system.hpp"
#include "analysis/bits/engine_contract.hpp"

namespace rungproof {

/// Literals of latches; at most one of them is on in every reachable state.
using ExclusiveGroup = std::vector<Lit>;

/// Groups that are inductive together, each of at least schedule::leastGroup literals. `truths`: literals of latches.
/// When the budget ends, nothing is returned.
std::vector<ExclusiveGroup> mineGroups(const BitSystem& system, const std::vector<Lit>& truths, std::uint64_t seed,
                                       const Budget& budget);

/// "At most one of them", in gates that are added to the system.
Lit atMostOne(BitSystem& system, const ExclusiveGroup& group);

}  // namespace rungproof
