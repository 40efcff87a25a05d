// Questions of the first scan alone: bad needs a truth of the state that holds before the first scan and never again,
// as what memory has kept over a loss of power. Every state then is what it is initially, and what remains is one scan
// over inputs and kept memory. Tested by tests/solver/first_scan_test.cpp.
#pragma once

#include <optional>
#include <vector>

#include "analysis/graph/transition_system.hpp"

namespace rungproof {

struct FirstScanSystem {
  /// Same graph, states and inputs in the same order; only the question that was asked. States stay as they begin, so
  /// that each scan of a run is a first one.
  TransitionSystem system;
  Node isLater = noNode;     ///< over states of the given system: this is not the first scan
  std::vector<Node> starts;  ///< of width 1: states are what they are initially, those that the question depends on
};

/// Nothing if the question can be bad later. Adds nodes to the graph.
std::optional<FirstScanSystem> inFirstScan(const TransitionSystem& given, std::size_t question);

}  // namespace rungproof
