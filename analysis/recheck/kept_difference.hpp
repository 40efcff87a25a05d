// A theorem that spares solvers the reasoning about adders: two words that count on by the same amount keep the
// difference of what they are compared by. It holds by modular arithmetic, whatever the words are, as long as the nodes
// are the sums that they are said to be: that is looked up in the graph. Tested by tests/recheck.
#pragma once

#include "analysis/graph/graph.hpp"

namespace rungproof {

/// A word as part of a sum: at a step at which it counts it becomes `next` = word + increment. Nodes of one width over
/// states and, unless the increment is pending, inputs.
struct Summand {
  Node word = noNode;
  Node increment = noNode;
  Node next = noNode;
  /// The increment is known at the start of the scan, because it came about in the scan before.
  bool isPending = false;
  /// What two words are compared by: with a pending increment, what the word is about to become.
  Node progress() const { return isPending ? next : word; }
};

struct KeptDifference {
  Summand left, right;
  Node difference = noNode;  ///< left.progress() - right.progress()
};

/// Whether `next` of both is word + increment and `difference` the difference of what they are compared by.
bool consistsOfSums(const Graph& graph, const KeptDifference& d);

}  // namespace rungproof
