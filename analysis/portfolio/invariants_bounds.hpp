// Bounds on differences of words that count the same ticks: "while the motor runs, the timer is at most 10 ticks ahead
// of the property's clock". Two words belong together if their increments are the same, whether they are added at once
// or, as the ticks of a timer, one scan later. For such words, and conditions of the program, the smallest bounds that
// induction confirms are computed: they start from what random runs show and grow with counterexamples, each to its
// largest value. The cost does not depend on how far the words count. A word that counts scans is compared with a
// clock likewise (bound_rates.hpp).
// Tested by tests/solver/invariants_test.cpp.
#pragma once

#include <vector>

#include "analysis/bits/bit_blast.hpp"
#include "analysis/portfolio/bound_templates.hpp"
#include "analysis/portfolio/certificate.hpp"
#include "analysis/portfolio/invariants.hpp"

namespace rungproof {

struct MinedBounds {
  std::vector<BoundTemplate> templates;  ///< what was looked for
  bool isUnfinished = false;             ///< the budget ended
  std::vector<Node> clauses;
  std::vector<KeptDifference> differences;  ///< of two words, for all clauses that bound one
};

/// Clauses (nodes of width 1 over states) that hold in all reachable states, given `known` ones, which are literals of
/// `blast`. Adds nodes to its graph and gates to its bits. Nothing if there are no such words, if the budget ends, or
/// if the very `tried` templates would be looked for again.
MinedBounds mineBounds(const TransitionSystem& system, BitBlast& blast, const Invariants& known, std::uint64_t seed,
                       BoundScope scope, const Budget& budget, const std::vector<BoundTemplate>& tried = {});

}  // namespace rungproof
