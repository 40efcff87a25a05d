// Words as vectors of literals (lowest bit first) in an and-inverter graph: adders, comparators, multipliers,
// dividers, shifters. Operands of one operation have equal width unless said otherwise.
// Tested by tests/solver/bit_arithmetic_test.cpp.
#pragma once

#include <vector>

#include "analysis/bits/bit_system.hpp"

namespace rungproof {

using LitVector = std::vector<Lit>;

class BitArithmetic {
 public:
  explicit BitArithmetic(BitSystem& graph) : g_(graph) {}

  static LitVector constant(std::uint64_t value, int width);
  LitVector bitNot(LitVector a) const;
  LitVector bitAnd(const LitVector& a, const LitVector& b);
  LitVector bitOr(const LitVector& a, const LitVector& b);
  LitVector bitXor(const LitVector& a, const LitVector& b);
  LitVector add(const LitVector& a, const LitVector& b, Lit carry = falseLit);
  LitVector subtract(const LitVector& a, const LitVector& b);
  LitVector multiply(const LitVector& a, const LitVector& b);
  /// Quotient and remainder, unsigned. By 0: all ones and the dividend, as SMT-LIB has it.
  void divide(const LitVector& a, const LitVector& b, LitVector& quotient, LitVector& remainder);
  /// Signed, truncating; the remainder has the dividend's sign (SMT-LIB bvsdiv, bvsrem).
  void divideSigned(const LitVector& a, const LitVector& b, LitVector& quotient, LitVector& remainder);
  /// Shifts by a word of the same width; shifting by the width or more gives 0.
  LitVector shiftLeft(const LitVector& a, const LitVector& amount);
  LitVector shiftRight(const LitVector& a, const LitVector& amount);
  LitVector choose(Lit condition, const LitVector& a, const LitVector& b);
  Lit equal(const LitVector& a, const LitVector& b);
  Lit less(const LitVector& a, const LitVector& b);  ///< unsigned
  Lit lessSigned(const LitVector& a, const LitVector& b);
  Lit any(const LitVector& a);  ///< some bit is 1

 private:
  LitVector negative(const LitVector& a) { return subtract(constant(0, static_cast<int>(a.size())), a); }
  LitVector shift(LitVector a, const LitVector& amount, bool left);
  Lit majority(Lit a, Lit b, Lit c);
  BitSystem& g_;
};

}  // namespace rungproof
