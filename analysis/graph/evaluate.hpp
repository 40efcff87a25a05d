// Evaluates graph nodes on numbers: one operation (also the constant folder of Graph), or a fixed set of roots over
// assignments of the variables. The arithmetic is that of the concrete domain, so both agree by construction.
// Covered by tests/differential/domain_laws_test.cpp.
#pragma once

#include <span>
#include <vector>

#include "analysis/graph/graph.hpp"

namespace rungproof {

/// Result of one operation on numbers. `childWidth`: width of the first and of the second child.
std::uint64_t evaluateOperation(Op op, int width, std::array<int, 2> childWidth, std::array<std::uint64_t, 3> operand,
                                std::uint64_t value);

/// The nodes that `roots` depend on, children before parents.
std::vector<Node> coneOf(const Graph& graph, std::span<const Node> roots);

/// Values of the nodes in the cone of some roots, for one assignment of the variables at a time.
class Evaluator {
 public:
  Evaluator(const Graph& graph, std::span<const Node> roots);

  /// Sets the value of a variable node; variables outside the cone are ignored.
  void set(Node variable, std::uint64_t value);
  /// Computes all nodes of the cone from the variables.
  void run();
  /// Value of a root, or of any node of its cone, after run().
  std::uint64_t operator[](Node n) const { return value_[indexOf(n)]; }

 private:
  const Graph& graph_;
  std::vector<Node> computed_;  ///< of the cone: operations, each after its operands
  std::vector<std::uint64_t> value_;
};

/// The same for 64 assignments at once: truth values are one bit of a word each, wider values 64 numbers.
class LaneEvaluator {
 public:
  static constexpr int lanes = 64;

  LaneEvaluator(const Graph& graph, std::span<const Node> roots);

  /// Lanes of a variable of width 1.
  void setBits(Node variable, std::uint64_t bits);
  /// One lane of a variable of any width.
  void set(Node variable, int lane, std::uint64_t value);
  void run();
  /// The lanes of a node of width 1.
  std::uint64_t bits(Node n) const { return values_[place_[indexOf(n)]]; }
  std::uint64_t at(Node n, int lane) const;

 private:
  void runNode(Node n);

  const Graph& graph_;
  std::vector<Node> cone_;
  std::vector<std::uint32_t> place_;  ///< by node: first index in values_; nodes outside the cone: absent
  std::vector<std::uint64_t> values_;
};

}  // namespace rungproof
