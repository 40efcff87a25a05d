// The SAT solver as the engines see it: incremental clauses, assumptions with failed core, one temporary clause
// per call, and an end when the budget is used up. A thin wrapper over CaDiCaL, the only place that knows it.
// Tested by tests/solver/sat_test.cpp.
#pragma once

#include <initializer_list>
#include <memory>
#include <span>
#include <vector>

#include "analysis/bits/engine_contract.hpp"

namespace CaDiCaL {
class Solver;
}

namespace rungproof {

/// Literals are DIMACS ones: +v or -v with v from 1.
class Sat {
 public:
  enum class Outcome : std::uint8_t { Satisfiable, Unsatisfiable, Unknown };
  /// Few: some long searches, with inprocessing. Many: thousands of short questions, without.
  enum class Use : std::uint8_t { Few, Many };

  explicit Sat(Use use);
  ~Sat();
  Sat(const Sat&) = delete;
  Sat& operator=(const Sat&) = delete;

  int newVariable() { return ++variables_; }
  int variables() const { return variables_; }
  void add(std::span<const int> clause);
  void add(std::initializer_list<int> clause) { add(std::span<const int>(clause.begin(), clause.size())); }
  /// `temporary` (if not empty) is a clause for this call only. Unknown when the budget is used up.
  Outcome solve(std::span<const int> assumptions, const Budget& budget, std::span<const int> temporary = {});
  Outcome solve(std::initializer_list<int> assumptions, const Budget& budget) {
    return solve(std::span<const int>(assumptions.begin(), assumptions.size()), budget);
  }
  bool value(int literal) const;   ///< after Satisfiable
  bool failed(int literal) const;  ///< after Unsatisfiable: the assumption belongs to the core
  /// The phase a variable is tried with first.
  void prefer(int literal);

 private:
  template <class Work>
  auto guarded(Work&& work);
  std::unique_ptr<CaDiCaL::Solver> solver_;
  bool isBroken_ = false;  ///< memory ended in a call
  int variables_ = 0;
};

}  // namespace rungproof
