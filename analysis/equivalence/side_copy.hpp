// Copies nodes of one graph into another, with other nodes in place of some variables. What is not replaced becomes a
// variable of its own. Tested by tests/equivalence.
#pragma once

#include <string>
#include <unordered_map>
#include <vector>

#include "analysis/graph/graph.hpp"

namespace rungproof {

class SideCopy {
 public:
  /// Variables that are not replaced are named as in `from` with `suffix`.
  SideCopy(Graph& to, const Graph& from, std::string suffix) : to_(to), from_(from), suffix_(std::move(suffix)) {}

  /// The node of the other graph that stands for a variable; before it is copied.
  void replace(Node variable, Node by);
  bool isReplaced(Node variable) const { return copies_.contains(variable); }
  /// The copy of a node; noNode stays what it is.
  Node operator()(Node node);
  /// Inputs that have become inputs of their own, in the order of their copies.
  const std::vector<Node>& newInputs() const { return newInputs_; }

 private:
  Node made(Node node);

  Graph& to_;
  const Graph& from_;
  std::string suffix_;
  std::unordered_map<Node, Node> copies_;
  std::vector<Node> newInputs_;
};

}  // namespace rungproof
