// ValueSet: what is known of the values that a node takes in all reachable scans: the values themselves while they are
// few, else bounds and constant bits. The abstract domain of the pointer analysis.
// Covered by tests/encoder/pointer_values_test.cpp.
#pragma once

#include <cstdint>
#include <vector>

#include "analysis/graph/graph.hpp"

namespace rungproof {

class ValueSet {
 public:
  ValueSet() = default;  ///< no value at all
  static ValueSet any(int width);
  static ValueSet of(std::uint64_t value);
  static ValueSet within(const Graph::Facts& facts);

  bool isEmpty() const { return kind_ == Kind::Empty; }
  bool isSingle() const { return kind_ == Kind::Single; }
  bool isListed() const { return kind_ != Kind::Range; }
  /// The values in ascending order; only if listed.
  std::vector<std::uint64_t> values() const;
  const Graph::Facts& facts() const { return facts_; }
  bool contains(std::uint64_t value) const;
  /// Whether each value of the other set is in it.
  bool includes(const ValueSet& other) const;

  /// Adds the values of another set; more than `limit` are no longer listed. Gives whether anything was added.
  bool join(const ValueSet& other, std::size_t limit);
  /// Gives up what grows: bounds that moved go to the end of the width.
  void widen(const ValueSet& before, int width);
  /// Leaves only values in [low, high]; lists them if they are at most `limit`.
  void restrict(std::uint64_t low, std::uint64_t high, std::size_t limit);
  /// The same set; lists its values if they are at most `limit`.
  ValueSet listedIfFew(std::size_t limit) const;

  /// Result of an operation; listed if all operands are and the result has at most `limit` values.
  static ValueSet combine(const NodeData& node, std::array<int, 2> childWidth, std::array<const ValueSet*, 3> operand,
                          std::size_t limit);

  friend bool operator==(const ValueSet&, const ValueSet&) = default;

 private:
  /// Truth values that may be either are a range: they are too many to make lists of.
  enum class Kind : std::uint8_t { Empty, Single, List, Range };
  /// The set of these values, in any order; a range if they are more than `limit`.
  static ValueSet list(std::vector<std::uint64_t> values, std::size_t limit);

  Kind kind_ = Kind::Empty;
  std::vector<std::uint64_t> values_;           ///< List only
  Graph::Facts facts_{~0ULL, ~0ULL, ~0ULL, 0};  ///< of all values
};

/// That the value of a node is in the set; the constant 1 if any value is.
Graph::Bool isIn(Graph& graph, Node value, const ValueSet& set);

}  // namespace rungproof
