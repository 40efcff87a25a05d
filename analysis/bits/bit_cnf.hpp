// Clauses of an and-inverter graph, made on demand: a literal asked for brings the clauses of its cone, once.
// Exclusive ors and choices get one variable instead of three. Tested by tests/solver/sat_test.cpp.
#pragma once

#include <vector>

#include "analysis/bits/bit_system.hpp"
#include "analysis/bits/sat.hpp"

namespace rungproof {

/// The graph may grow between calls; literals once given stay valid.
class BitCnf {
 public:
  BitCnf(const BitSystem& graph, Sat& sat) : graph_(graph), sat_(sat) {}
  /// The SAT literal that equals graph literal `l`; latches and inputs are free variables.
  int literal(Lit l);
  /// The SAT literal if the variable has one already, else 0.
  int known(Lit l) const;
  /// Value of `l` in the model; false for variables that the formula does not mention.
  bool value(Lit l) const;

 private:
  int trueLiteral();
  void encode(std::uint32_t variable);
  int signedOf(Lit l) const { return isNegative(l) ? -of_[variableOf(l)] : of_[variableOf(l)]; }

  const BitSystem& graph_;
  Sat& sat_;
  std::vector<int> of_;  ///< by graph variable; 0: none yet
  std::vector<std::uint32_t> stack_;
};

}  // namespace rungproof
