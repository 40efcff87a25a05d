// What one question depends on, as a transition system with a graph of its own: the engine on words adds thousands of
// terms to its graph, and engines at work on other questions must not see them. Tested by
// tests/words/word_cone_test.cpp.
#pragma once

#include <cstdint>
#include <unordered_map>
#include <vector>

#include "analysis/graph/transition_system.hpp"

namespace rungproof {

class WordCone {
 public:
  /// Only reads `given`. Constraints that can always be met are left out unless they share variables with the cone.
  WordCone(const TransitionSystem& given, std::size_t question);
  WordCone(const WordCone&) = delete;
  WordCone& operator=(const WordCone&) = delete;

  Graph& graph() { return graph_; }
  const TransitionSystem& system() const { return system_; }
  Node bad() const { return system_.questions[0].bad; }
  /// Puts an equal node in the place of bad().
  void writeBadAs(Node n) { system_.questions[0].bad = n; }
  /// By state and by input of system(): index in the given system.
  const std::vector<std::size_t>& states() const { return states_; }
  const std::vector<std::size_t>& inputs() const { return inputs_; }
  /// Some operation on REAL numbers belongs to the cone.
  bool hasReals() const { return hasReals_; }
  /// Some operation has no exact meaning for any solver (sine, logarithm ...).
  bool hasOpaque() const { return hasOpaque_; }

  /// A node of the cone's graph as one of the graph of `given`, the system that the cone was made from.
  Node onGivenSystem(const TransitionSystem& given, Node n) const;

 private:
  Graph graph_;
  TransitionSystem system_;
  std::vector<std::size_t> states_, inputs_;
  bool hasReals_ = false, hasOpaque_ = false;
};

}  // namespace rungproof
