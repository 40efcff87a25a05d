// Value analysis of the transition relation: which values the state variables take in reachable scans, as far as the
// domain of ValueSet can tell, and from it the values that a pointer can have where it is followed. Finds constants
// (cells that never change) as well.
//
// Fixpoint from the initial values: a cell that pointers are made of is followed value by value through its own next
// function, so that "increase until the end, then start again" gives the exact set; others by the abstract operations
// with widening. Constraints are not used, which can only add values.
// Covered by tests/encoder/pointer_values_test.cpp.
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <unordered_map>
#include <vector>

#include "analysis/graph/transition_system.hpp"
#include "analysis/graph/value_set.hpp"

namespace rungproof {

/// Limits of the analysis: values listed of a pointer, and of other cells.
inline constexpr std::size_t pointerValueLimit = 512;
inline constexpr std::size_t valueLimit = 8;

/// Known values of variables; variables that are missing may have any. Other nodes that are in it have no other values
/// than these.
using VariableValues = std::unordered_map<Node, ValueSet>;

/// Abstract evaluation of nodes, given values of variables.
class ValueEvaluator {
 public:
  ValueEvaluator(const Graph& graph, const VariableValues& known);

  /// Values of `root` where `guard` (width 1) holds: its conjuncts are true, and comparisons with constants narrow what
  /// they compare.
  ValueSet valuesOf(Node root, Node guard, std::size_t limit);
  /// The same; where they are too many, after one variable of few values was given each of these in turn.
  ValueSet valuesByCase(Node root, Node guard, std::size_t limit);
  /// Values of `root` with one variable fixed.
  ValueSet valuesWith(std::span<const Node> cone, Node variable, const ValueSet& value, std::size_t limit);
  /// All nodes of a cone (children first); read with at().
  void run(std::span<const Node> cone, std::size_t limit);
  const ValueSet& at(Node n) const { return values_[indexOf(n)]; }

 private:
  struct Bounds {
    std::uint64_t low, high;
  };
  struct Limit {
    Node subject;
    std::optional<Bounds> asUnsigned, asSigned;
  };
  /// What is known of a node where it is chosen.
  struct Bounded {
    Bounds asUnsigned, asSigned;
  };
  std::optional<Limit> limitOf(Node n, bool isTrue = true) const;
  std::optional<Limit> limitOfAny(std::span<const Node> alternatives) const;
  void collectBounds(Node guard);
  void boundParts();
  ValueSet evaluate(Node n, std::size_t limit);
  Bounded boundedBy(Node subject, Node condition, bool isTrue, Bounded bounds) const;
  std::optional<ValueSet> boundedByPart(Node n, Node condition, bool isTrue, std::size_t limit, int depth) const;
  ValueSet choice(Node n, const Bounded& bounds, std::size_t limit, int depth) const;
  bool isFree(const Bounded& bounds, int width) const;
  void collectCompared();

  const Graph& graph_;
  const VariableValues& variables_;
  std::vector<ValueSet> values_;                        ///< by node; of the cone that was run last
  std::vector<bool> isCompared_;                        ///< by node: with a constant
  std::vector<bool> isKnown_;                           ///< by node: no variable, and its values are known
  std::unordered_map<Node, Bounds> unsigned_, signed_;  ///< signed bounds are shifted so that their order is unsigned
  Node fixed_ = noNode;
  ValueSet fixedValue_;
};

/// What cells can be together at the start of scans that are not the first one.
struct Walk {
  std::vector<std::uint64_t> values;  ///< of the first of them, the pointer
  std::vector<Node> cells;
  std::set<std::vector<std::uint64_t>> together;  ///< a value for each
};

/// The state variables that are 1 at the start of the first scan only.
std::vector<Node> firstScansOf(const TransitionSystem& system);

/// Grows `values` (at least the initial ones on entry, or nothing for a variable) to a set of values closed under all
/// next functions. `pointerCells`: variables to be followed value by value. `later`: what those of them that could be
/// followed have at the start of all scans but the first; missing without
/// firstScansOf. `interruption`, if set, is called now and then and may throw. `walks`: of pointers whose values end
/// only because other cells do.
void closeValues(const TransitionSystem& system, const std::set<Node>& pointerCells, VariableValues& values,
                 VariableValues& later, const std::function<void()>& interruption = {},
                 std::map<Node, Walk>* walks = nullptr);

/// The variables that a node depends on.
std::vector<Node> variablesOf(const Graph& graph, Node root);
/// Those that it is made of: what only decides between values is left out.
std::vector<Node> partsOf(const Graph& graph, Node root);

}  // namespace rungproof
