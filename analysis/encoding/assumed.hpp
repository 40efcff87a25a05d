// What a condition decides in a node that matters only where the condition holds.
// Covered by tests/encoder/pointer_values_test.cpp.
#pragma once

#include "analysis/graph/graph.hpp"

namespace rungproof {

/// A node and the condition under which it is asked for, simplified by each other: what the parts of the condition
/// choose between is chosen, in the node and in the other parts. Adds nodes to the graph.
struct Assumed {
  Node node, guard;
};
Assumed assuming(Graph& graph, Node node, Node guard);

}  // namespace rungproof
