// The predicates that states are abstracted to: truth values over the state words of a cone, each with its value after
// the scan by substitution of the next-state functions, and with its values in sampled reachable states. Tested by
// tests/words/predicates_test.cpp.
#pragma once

#include <optional>
#include <unordered_map>
#include <vector>

#include "analysis/bits/bit_system.hpp"
#include "analysis/graph/evaluate.hpp"
#include "analysis/graph/substitution.hpp"
#include "analysis/words/word_cone.hpp"

namespace rungproof {

/// Values of all states of a cone, in its order.
using WordState = std::vector<std::uint64_t>;

struct Predicate {
  Node now = noNode;                   ///< width 1, over states
  Node next = noNode;                  ///< the same after the scan, over states and inputs
  std::vector<std::uint32_t> words;    ///< states that it speaks of, ascending
  std::optional<bool> initially;       ///< its value in all initial states; nothing: it depends
  std::vector<std::uint64_t> samples;  ///< its value in sampled states, 64 to a number
};

/// Literals 2 * predicate + 1 if negated, ascending: a set of states. Its negation is a lemma.
using WordCube = std::vector<Lit>;

class Predicates {
 public:
  Predicates(WordCone& cone, std::vector<WordState> samples);

  std::size_t size() const { return predicates_.size(); }
  const Predicate& operator[](std::size_t i) const { return predicates_[i]; }
  const Predicate& of(Lit l) const { return predicates_[variableOf(l)]; }
  /// False if it is there already, constant, or looks at inputs.
  bool add(Node n);
  bool contains(Node n) const;
  Node now(Lit l) { return isNegative(l) ? negated(of(l).now) : of(l).now; }
  Node next(Lit l) { return isNegative(l) ? negated(of(l).next) : of(l).next; }
  /// The node after the scan.
  Node afterScan(Node n) { return afterScan_(n); }
  /// Values of nodes over states in one state.
  std::vector<bool> valuesIn(const WordState& state, std::span<const Node> nodes) const;
  bool contains(const WordCube& cube, const WordState& state) const;
  /// Which sampled states lie in the cube, 64 to a number.
  std::vector<std::uint64_t> samplesIn(const WordCube& cube) const;
  /// A sampled state inside the cube, if there is one.
  std::optional<std::size_t> sampleIn(const WordCube& cube) const;
  const std::vector<WordState>& samples() const { return samples_; }
  /// The values of a node over states in all samples, 64 to a number.
  std::vector<std::uint64_t> overSamples(Node n) const;
  /// States under a node, ascending; nothing if inputs are under it as well.
  std::optional<std::vector<std::uint32_t>> wordsUnder(Node n) const;

 private:
  Node negated(Node n) { return cone_.graph().make(Op::Not, 1, n); }
  Node positive(Node n) const { return cone_.graph()[n].op == Op::Not ? cone_.graph()[n].child[0] : n; }
  std::optional<bool> initialValue(const Predicate& predicate) const;

  WordCone& cone_;
  std::vector<Predicate> predicates_;
  std::unordered_map<std::uint32_t, std::size_t> index_;    ///< by node
  std::unordered_map<std::uint32_t, std::uint32_t> state_;  ///< by node of a state variable
  Substitution afterScan_;
  std::vector<WordState> samples_;
};

}  // namespace rungproof
