// Proofs within one scan that look at the surface of a property only: "the second output is built from the first one's
// inverse" needs neither the state nor how deep the logic below goes. Nodes below the surface may have any value; what
// is impossible then is impossible. The surface grows as long as that pays. Tested by
// tests/solver/local_proof_test.cpp.
#pragma once

#include <optional>
#include <unordered_map>
#include <vector>

#include "analysis/bits/engine_contract.hpp"
#include "analysis/graph/transition_system.hpp"

namespace rungproof {

/// Nodes below which the proof does not look, if `bad` (width 1) is 0 for all their values and all values of variables;
/// nothing if it can be 1 or the surface would become too large. `known`: what variables (indices) are known to be; the
/// constant nodes' equations with those that were used are added to `used`.
using KnownVariables = std::unordered_map<std::uint32_t, std::uint64_t>;
std::optional<std::vector<Node>> proveLocally(const TransitionSystem& system, Node bad, const Budget& budget,
                                              const KnownVariables& known = {}, std::vector<Node>* used = nullptr);

}  // namespace rungproof
