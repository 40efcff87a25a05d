// A checker of refutations: clauses are added, and each further one is accepted only if it follows by unit propagation
// (reverse unit propagation). What a SAT solver says is believed for its steps alone. Literals are DIMACS ones.
// Tested by tests/recheck.
#pragma once

#include <cstdint>
#include <span>
#include <unordered_map>
#include <vector>

namespace rungproof {

class RupChecker {
 public:
  /// Clauses speak of the variables 1 to `variables`.
  explicit RupChecker(int variables);

  /// Takes a clause as given.
  void add(std::span<const int> clause);
  /// Takes a clause if it follows: with all its literals 0, unit propagation meets a contradiction. False: it does not
  /// follow so, and is not taken.
  bool derive(std::span<const int> clause);
  /// A derived clause is not needed any more. What is not known is left alone.
  void forget(std::span<const int> clause);
  /// Whether the clauses contradict each other.
  bool isRefuted() const { return isRefuted_; }

 private:
  using Reference = std::uint32_t;
  struct Watch {
    Reference clause;
    int other;  ///< a literal of the clause: it is satisfied where that is
  };
  static std::size_t index(int literal) {
    return 2 * static_cast<std::size_t>(literal < 0 ? -literal : literal) + (literal < 0 ? 1 : 0);
  }
  static std::uint64_t keyOf(std::span<const int> clause);
  bool isTrue(int literal) const { return values_[index(literal)] > 0; }
  bool isFalse(int literal) const { return values_[index(literal)] < 0; }
  void assign(int literal);
  bool propagate();
  bool visit(int falsified);
  Reference take(std::span<const int> clause);

  std::vector<signed char> values_;          ///< by literal: 1 true, -1 false, 0 open
  std::vector<std::vector<Watch>> watches_;  ///< by literal: clauses to be looked at when it becomes false
  std::vector<int> clauses_;                 ///< each its length (0: forgotten), then its literals
  std::vector<int> trail_;
  std::size_t done_ = 0;  ///< literals of the trail that are propagated
  std::unordered_multimap<std::uint64_t, Reference> derived_;
  bool isRefuted_ = false;
};

}  // namespace rungproof
