// What is true of sums in any state, in steps that a solver sees one after the other and hardly ever by itself: without
// terms below zero no part is more than the whole, and terms within a limit make sums within so many times the limit.
// Tested by tests/solver/sums_test.cpp.
#pragma once

#include <cstdint>
#include <set>
#include <vector>

#include "analysis/graph/graph.hpp"

namespace rungproof {

/// Nodes of width 1, 1 whatever the terms are, as long as no addition leaves the width that it is made in. `limits`:
/// those above 0 are looked at. Adds nodes to the graph.
std::vector<Node> factsOfSum(Graph& graph, Node sum, const std::set<std::int64_t>& limits);

}  // namespace rungproof
