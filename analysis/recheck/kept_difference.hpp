// Theorems that spare solvers the reasoning about adders: two words that count on by the same amount keep the
// difference of what they are compared by; a sum becomes the same sum of what its terms become. They hold by modular
// arithmetic, whatever the words are, as long as the nodes are the sums that they are said to be: that is looked up in
// the graph. Tested by tests/recheck.
#pragma once

#include <vector>

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

/// A term of a sum over states: at a step at which it counts it becomes `next`, over states and inputs.
struct SumTerm {
  Node term = noNode, next = noNode;
  bool isSubtracted = false;
  Node counts = noNode;  ///< of width 1 over states and inputs: where it does, presumably; noNode: at every step
};

/// Nodes of one width: at a step at which all terms count, the sum becomes `next`.
struct KeptSum {
  std::vector<SumTerm> terms;
  Node sum = noNode, next = noNode;
  /// Of width 1 over the states: what presumably is true of the sum in any state, each easy to see after those before.
  std::vector<Node> facts;
  /// The same over states and inputs, where the terms have become what they are said to: that nothing is added.
  std::vector<Node> steps;
};

/// Whether `sum` is the sum of the terms, or that and a constant, and `next` the same of what they become.
bool consistsOfSums(const Graph& graph, const KeptSum& sum);

}  // namespace rungproof
