// How LREAL numbers compare, over a domain of values: by their patterns of 64 bits, so that solvers need no other
// arithmetic than that of whole numbers. As IEEE 754 has it: +0 and -0 are equal, nothing is true of NaN but <>.
// Tested by tests/iec/long_types_test.cpp.
#pragma once

#include <cstdint>

namespace rungproof {

template <class D>
struct LongRealOrder {
  using Bool = typename D::Bool;
  using Bits = typename D::Bits;
  D& d;

  static constexpr std::uint64_t sign = std::uint64_t{1} << 63;
  static constexpr std::uint64_t infinity = 0x7FF0000000000000U;

  Bits literal(std::uint64_t value) { return d.literal(value, 64); }
  /// Without its sign.
  Bits size(Bits a) { return d.band(a, literal(~sign), 64); }
  Bool isNan(Bits a) { return d.ult(literal(infinity), size(a), 64); }
  Bool areZero(Bits a, Bits b) { return d.equal(size(d.bor(a, b, 64)), literal(0), 64); }
  /// Neither is NaN.
  Bool areNumbers(Bits a, Bits b) { return d.lnot(d.lor(isNan(a), isNan(b))); }
  Bool equal(Bits a, Bits b) { return d.land(areNumbers(a, b), d.lor(d.equal(a, b, 64), areZero(a, b))); }
  Bool less(Bits a, Bits b) {
    const Bool isLess = d.ult(key(a), key(b), 64);
    return d.land(areNumbers(a, b), d.land(isLess, d.lnot(areZero(a, b))));
  }

 private:
  /// Grows with the number.
  Bits key(Bits a) { return d.select(d.bit(a, 63), d.bnot(a, 64), d.bor(a, literal(sign), 64), 64); }
};

}  // namespace rungproof
