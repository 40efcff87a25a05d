// Nodes with other nodes in place of some, simplified on the way. What was rewritten once is kept, so that all parts of
// a transition system can be put through the same substitution. Tested by tests/solver/merging_test.cpp and
// tests/solver/word_caps_test.cpp.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <unordered_map>

#include "analysis/graph/graph.hpp"

namespace rungproof {

class Substitution {
 public:
  /// What stands for a node whose children are those given; noNode: the same operation on them.
  using Rule = std::function<Node(const NodeData& node, const std::array<Node, 3>& child)>;

  /// `replaced`: by index of a node, what stands in its place; of the same width.
  Substitution(Graph& graph, std::unordered_map<std::uint32_t, Node> replaced, Rule rule = {})
      : graph_(graph), known_(std::move(replaced)), rule_(std::move(rule)) {}
  /// Adds nodes to the graph.
  Node operator()(Node root);

 private:
  Graph& graph_;
  std::unordered_map<std::uint32_t, Node> known_;
  const Rule rule_;
};

}  // namespace rungproof
