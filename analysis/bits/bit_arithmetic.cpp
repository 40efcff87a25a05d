// Ripple-carry circuits: small, and what SAT solvers propagate best through. Constants fold in the graph.
#include "analysis/bits/bit_arithmetic.hpp"

#include "ir/check.hpp"

namespace rungproof {

LitVector BitArithmetic::constant(std::uint64_t value, int width) {
  LitVector result;
  for (int i = 0; i < width; ++i) result.push_back((value >> i & 1U) != 0 ? trueLit : falseLit);
  return result;
}

LitVector BitArithmetic::bitNot(LitVector a) const {
  for (Lit& l : a) l = negate(l);
  return a;
}

LitVector BitArithmetic::bitAnd(const LitVector& a, const LitVector& b) {
  LitVector result;
  for (std::size_t i = 0; i < a.size(); ++i) result.push_back(g_.addAnd(a[i], b[i]));
  return result;
}

LitVector BitArithmetic::bitOr(const LitVector& a, const LitVector& b) {
  LitVector result;
  for (std::size_t i = 0; i < a.size(); ++i) result.push_back(g_.addOr(a[i], b[i]));
  return result;
}

LitVector BitArithmetic::bitXor(const LitVector& a, const LitVector& b) {
  LitVector result;
  for (std::size_t i = 0; i < a.size(); ++i) result.push_back(g_.addXor(a[i], b[i]));
  return result;
}

Lit BitArithmetic::majority(Lit a, Lit b, Lit c) { return g_.addIte(g_.addXor(a, b), c, a); }

LitVector BitArithmetic::add(const LitVector& a, const LitVector& b, Lit carry) {
  CHECK(a.size() == b.size(), "words of different width");
  LitVector result;
  for (std::size_t i = 0; i < a.size(); ++i) {
    result.push_back(g_.addXor(g_.addXor(a[i], b[i]), carry));
    carry = majority(a[i], b[i], carry);
  }
  return result;
}

LitVector BitArithmetic::subtract(const LitVector& a, const LitVector& b) { return add(a, bitNot(b), trueLit); }

LitVector BitArithmetic::multiply(const LitVector& a, const LitVector& b) {
  const std::size_t width = a.size();
  const auto constants = [](const LitVector& v) {
    std::size_t n = 0;
    for (const Lit l : v) n += variableOf(l) == 0 ? 1 : 0;
    return n;
  };
  const bool swap = constants(a) > constants(b);
  const LitVector& x = swap ? b : a;
  const LitVector& factor = swap ? a : b;
  LitVector sum = constant(0, static_cast<int>(width));
  for (std::size_t i = 0; i < width; ++i) {
    if (factor[i] == falseLit) continue;
    LitVector partial(width, falseLit);
    for (std::size_t j = i; j < width; ++j) partial[j] = g_.addAnd(x[j - i], factor[i]);
    sum = add(sum, partial);
  }
  return sum;
}

void BitArithmetic::divide(const LitVector& a, const LitVector& b, LitVector& quotient, LitVector& remainder) {
  const std::size_t width = a.size();
  LitVector divisor = b;
  divisor.push_back(falseLit);
  LitVector rest(width + 1, falseLit);
  quotient.assign(width, falseLit);
  for (std::size_t i = width; i-- > 0;) {
    rest.insert(rest.begin(), a[i]);
    rest.pop_back();
    quotient[i] = negate(less(rest, divisor));
    rest = choose(quotient[i], subtract(rest, divisor), rest);
  }
  rest.pop_back();
  remainder = std::move(rest);
}

void BitArithmetic::divideSigned(const LitVector& a, const LitVector& b, LitVector& quotient, LitVector& remainder) {
  const Lit signA = a.back(), signB = b.back();
  divide(choose(signA, negative(a), a), choose(signB, negative(b), b), quotient, remainder);
  quotient = choose(g_.addXor(signA, signB), negative(quotient), quotient);
  remainder = choose(signA, negative(remainder), remainder);
}

LitVector BitArithmetic::shift(LitVector a, const LitVector& amount, bool left) {
  const std::size_t width = a.size();
  Lit tooFar = falseLit;
  for (std::size_t stage = 0; stage < amount.size(); ++stage) {
    const std::uint64_t distance = stage < 63 ? 1ULL << stage : ~0ULL;
    if (distance >= width) {
      tooFar = g_.addOr(tooFar, amount[stage]);
      continue;
    }
    LitVector moved(width, falseLit);
    for (std::size_t i = 0; i + distance < width; ++i) {
      if (left)
        moved[i + distance] = a[i];
      else
        moved[i] = a[i + distance];
    }
    a = choose(amount[stage], moved, a);
  }
  for (Lit& l : a) l = g_.addAnd(l, negate(tooFar));
  return a;
}

LitVector BitArithmetic::shiftLeft(const LitVector& a, const LitVector& amount) { return shift(a, amount, true); }
LitVector BitArithmetic::shiftRight(const LitVector& a, const LitVector& amount) { return shift(a, amount, false); }

LitVector BitArithmetic::choose(Lit condition, const LitVector& a, const LitVector& b) {
  LitVector result;
  for (std::size_t i = 0; i < a.size(); ++i) result.push_back(g_.addIte(condition, a[i], b[i]));
  return result;
}

Lit BitArithmetic::equal(const LitVector& a, const LitVector& b) {
  Lit result = trueLit;
  for (std::size_t i = 0; i < a.size(); ++i) result = g_.addAnd(result, negate(g_.addXor(a[i], b[i])));
  return result;
}

Lit BitArithmetic::less(const LitVector& a, const LitVector& b) {
  Lit result = falseLit;
  for (std::size_t i = 0; i < a.size(); ++i) result = g_.addIte(g_.addXor(a[i], b[i]), b[i], result);
  return result;
}

Lit BitArithmetic::lessSigned(const LitVector& a, const LitVector& b) {
  LitVector x = a, y = b;
  x.back() = negate(x.back());
  y.back() = negate(y.back());
  return less(x, y);
}

Lit BitArithmetic::any(const LitVector& a) {
  Lit result = falseLit;
  for (const Lit l : a) result = g_.addOr(result, l);
  return result;
}

}  // namespace rungproof
