// Invariants mined from samples: latches that are constant, equal or complementary (signal correspondence), and
// clauses of two literals between truth values (implications, one-hot groups, timer bit and comparison). Candidates
// come from random runs; those that a scan from a state satisfying all of them can break are dropped until the rest
// is inductive together. Used to merge latches and as lemmas of the engines.
// Tested by tests/solver/invariants_test.cpp.
#pragma once

#include <vector>

#include "analysis/bit_cone.hpp"

namespace rungproof {

struct Invariants {
  Substitution equal;  ///< by variable; latches that equal another latch or a constant
  /// All that was proved, as clauses over latches and gates over latches; includes the equalities.
  std::vector<std::vector<Lit>> clauses;
  bool empty() const { return clauses.empty(); }
};

struct MiningOptions {
  std::uint64_t seed = 1;
  int scans = 192;                     ///< sampled on 64 runs
  std::size_t implicationLimit = 3000;  ///< candidates of two literals
};

/// `truths`: literals over latches between which equalities and implications are looked for, besides the equalities
/// among all latches; `guesses`: further candidates, clauses over latches and gates over latches. When the budget
/// ends, nothing is returned.
Invariants mineInvariants(const BitSystem& system, const std::vector<Lit>& truths, const std::vector<std::vector<Lit>>& guesses,
                          const MiningOptions& options, const Budget& budget);

/// Of clauses that are inductive together, those that the proof of `goal` needs: a subset that is inductive by itself
/// and under which one scan from `assumed` (clauses, inductive relative to it) neither breaks `assumed` nor is bad.
/// All of them when the budget ends.
std::vector<std::vector<Lit>> neededInvariants(const BitSystem& system, Lit bad, const std::vector<std::vector<Lit>>& invariants,
                                               const Certificate& certificate, const Budget& budget);

}  // namespace rungproof
