// Absorption: where a question can be bad only as long as something has never occurred ("A only after B", "once(E) or
// C"), a run that has come to it is of no more interest. The latch that remembers it is 0 in all states that matter,
// and the scans that set it are left out: inputs that would set it are constants, and often most of the program goes
// with them. A proof about what remains, joined by the latch, is one about the given system, and its runs are runs of
// the given one. Tested by tests/solver/absorption_test.cpp.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "analysis/graph/transition_system.hpp"

namespace rungproof {

struct UnabsorbedSystem {
  /// Same graph, states and inputs in the same order; only the question that was asked. The latches stay 0.
  TransitionSystem system;
  Node latched = noNode;  ///< over states of the given system: one of the latches is 1
  /// Inputs that have one value in all scans that matter: index and value.
  std::vector<std::pair<std::size_t, std::uint64_t>> fixedInputs;
};

/// Nothing if the question has no such latch. Adds nodes to the graph.
std::optional<UnabsorbedSystem> beforeAbsorption(const TransitionSystem& given, std::size_t question);

}  // namespace rungproof
