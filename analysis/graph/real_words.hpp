// REAL arithmetic out of whole-number operations: what IEEE 754 single precision, rounded to nearest even, makes of two
// 32-bit patterns, over any domain of values. Over Graph it turns REAL operations into operations on words, which every
// engine, export and certificate can state exactly; over Concrete it is compared with the processor's own arithmetic.
// Subnormal numbers, both zeros, infinities and NaN (one pattern, as in engine/concrete.hpp) are those of the standard.
// Covered by tests/differential/real_words_test.cpp.
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>
#include <utility>

#include "ir/domain.hpp"

namespace rungproof {

template <Domain D>
class RealWords {
 public:
  using Bits = typename D::Bits;
  using Bool = typename D::Bool;
  explicit RealWords(D& domain) : d(domain) {}

  Bits add(Bits a, Bits b) {
    const Bool isSwapped = d.ult(magnitude(a), magnitude(b), 31);
    const Bits larger = d.select(isSwapped, b, a, 32), smaller = d.select(isSwapped, a, b, 32);
    const Parts x = partsOf(larger), y = partsOf(smaller);
    const auto widened = [&](Bits significand) {
      return d.zext(d.concat(significand, 24, literal(0, 3), 3), 27, resultBits);
    };
    const Bits distance = d.zext(d.sub(x.exponent, y.exponent, exponentBits), exponentBits, resultBits);
    const Bits first = widened(x.significand), second = shiftedRight(widened(y.significand), distance);
    const Bool isDifference = d.lxor(x.isNegative, y.isNegative);
    const Bits sum =
        d.select(isDifference, d.sub(first, second, resultBits), d.add(first, second, resultBits), resultBits);
    const auto [normal, shift] = normalised(sum, resultBits);
    const Bits exponent = d.sub(d.add(x.exponent, literal(1, exponentBits), exponentBits), shift, exponentBits);
    Bits result = packed(x.isNegative, exponent, normal);
    result = d.select(isZero(sum, resultBits), zero(d.land(x.isNegative, y.isNegative)), result, 32);
    result = d.select(x.isInfinite, larger, result, 32);
    return orNan(d.lor(x.isNan, d.land(isDifference, d.land(x.isInfinite, y.isInfinite))), result);
  }
  Bits sub(Bits a, Bits b) { return add(a, d.bxor(b, literal(0x80000000, 32), 32)); }

  Bits mul(Bits a, Bits b) {
    const Parts x = normalPartsOf(a), y = normalPartsOf(b);
    const Bits product = d.mul(d.zext(x.significand, 24, 48), d.zext(y.significand, 24, 48), 48);
    const Bits top =
        d.concat(d.extract(product, 47, 21), 27, d.fromBool(d.lnot(isZero(d.extract(product, 20, 0), 21)), 1), 1);
    const Bits exponent =
        d.sub(d.add(x.exponent, y.exponent, exponentBits), literal(bias - 1, exponentBits), exponentBits);
    const Bool isNegative = d.lxor(x.isNegative, y.isNegative);
    const Bool isEmpty = d.lor(x.isZero, y.isZero), isEndless = d.lor(x.isInfinite, y.isInfinite);
    Bits result = d.select(isEmpty, zero(isNegative), nearlyNormal(isNegative, exponent, top), 32);
    result = d.select(isEndless, infinity(isNegative), result, 32);
    return orNan(d.lor(d.lor(x.isNan, y.isNan), d.land(isEmpty, isEndless)), result);
  }

  Bits div(Bits a, Bits b) {
    const Parts x = normalPartsOf(a), y = normalPartsOf(b);
    constexpr int width = 25;  // of a remainder, which is less than twice the divisor
    const Bits divisor = d.zext(y.significand, 24, width);
    Bits remainder = d.zext(x.significand, 24, width), quotient = literal(0, 1);
    for (int i = 0; i < resultBits; ++i) {
      const Bool fits = d.ule(divisor, remainder, width);
      quotient = i == 0 ? d.fromBool(fits, 1) : d.concat(quotient, i, d.fromBool(fits, 1), 1);
      remainder = d.select(fits, d.sub(remainder, divisor, width), remainder, width);
      remainder = d.concat(d.extract(remainder, width - 2, 0), width - 1, literal(0, 1), 1);
    }
    const Bits rest = d.zext(d.fromBool(d.lnot(isZero(remainder, width)), 1), 1, resultBits);
    const Bits exponent = d.add(d.sub(x.exponent, y.exponent, exponentBits), literal(bias, exponentBits), exponentBits);
    const Bool isNegative = d.lxor(x.isNegative, y.isNegative);
    Bits result = nearlyNormal(isNegative, exponent, d.bor(quotient, rest, resultBits));
    result = d.select(d.lor(x.isZero, y.isInfinite), zero(isNegative), result, 32);
    result = d.select(d.lor(x.isInfinite, y.isZero), infinity(isNegative), result, 32);
    const Bool isUndefined = d.lor(d.land(x.isZero, y.isZero), d.land(x.isInfinite, y.isInfinite));
    return orNan(d.lor(d.lor(x.isNan, y.isNan), isUndefined), result);
  }

  Bits sqrt(Bits a) {
    const Parts x = normalPartsOf(a);
    const Bits power = d.sub(x.exponent, literal(bias, exponentBits), exponentBits);
    constexpr int whole = 2 * resultBits;  // one bit of the root for two of the radicand
    const Bits even = d.concat(d.zext(x.significand, 24, whole - 31), whole - 31, literal(0, 31), 31);
    const Bits odd = d.concat(d.extract(even, whole - 2, 0), whole - 1, literal(0, 1), 1);
    const Bits radicand = d.select(d.bit(power, 0), odd, even, whole);
    constexpr int width = resultBits + 4;
    Bits remainder = literal(0, width), root = literal(0, width);
    for (int i = resultBits - 1; i >= 0; --i) {
      remainder = d.concat(d.extract(remainder, width - 3, 0), width - 2, d.extract(radicand, 2 * i + 1, 2 * i), 2);
      const Bits trial = d.concat(d.extract(root, width - 3, 0), width - 2, literal(1, 2), 2);
      const Bool fits = d.ule(trial, remainder, width);
      remainder = d.select(fits, d.sub(remainder, trial, width), remainder, width);
      root = d.concat(d.extract(root, width - 2, 0), width - 1, d.fromBool(fits, 1), 1);
    }
    const Bits rest = d.zext(d.fromBool(d.lnot(isZero(remainder, width)), 1), 1, resultBits);
    const Bits half = d.sext(d.extract(power, exponentBits - 1, 1), exponentBits - 1, exponentBits);
    Bits result = packed(d.constant(false), d.add(half, literal(bias, exponentBits), exponentBits),
                         d.bor(d.extract(root, resultBits - 1, 0), rest, resultBits));
    result = d.select(d.lor(x.isZero, x.isInfinite), a, result, 32);
    return orNan(d.lor(x.isNan, d.land(x.isNegative, d.lnot(x.isZero))), result);
  }

  Bool equal(Bits a, Bits b) {
    const Bool isSame = d.lor(d.equal(a, b, 32), areZero(a, b));
    return d.land(isSame, d.lnot(d.lor(isNan(a), isNan(b))));
  }
  Bool less(Bits a, Bits b) {
    const Bool isNegative = d.bit(a, 31), otherIsNegative = d.bit(b, 31);
    const Bool isCloser = d.ult(magnitude(a), magnitude(b), 31), isFarther = d.ult(magnitude(b), magnitude(a), 31);
    const Bool isLess =
        d.select(isNegative, d.lor(d.lnot(otherIsNegative), isFarther), d.land(d.lnot(otherIsNegative), isCloser));
    return d.land(isLess, d.lnot(d.lor(areZero(a, b), d.lor(isNan(a), isNan(b)))));
  }
  Bool legal(Bits a) { return d.lnot(d.equal(d.extract(a, 30, 23), literal(255, 8), 8)); }

  Bits fromInt(Bits a) {
    const Bool isNegative = d.bit(a, 31);
    const Bits size = d.select(isNegative, d.sub(literal(0, 32), a, 32), a, 32);
    const auto [normal, shift] = normalised(size, 32);
    const Bits top =
        d.concat(d.extract(normal, 31, 5), 27, d.fromBool(d.lnot(isZero(d.extract(normal, 4, 0), 5)), 1), 1);
    const Bits exponent = d.sub(literal(bias + 31, exponentBits), shift, exponentBits);
    return d.select(isZero(a, 32), literal(0, 32), packed(isNegative, exponent, top), 32);
  }
  /// As Concrete::rtoInt: 64 bits, saturated.
  Bits toInt(Bits a, bool round) {
    const Parts x = partsOf(a);
    constexpr int point = bias + 23;  // the exponent of numbers whose significand is whole
    const Bits doubled = d.zext(d.concat(x.significand, 24, literal(0, 1), 1), 25, 64);
    const auto distance = [&](Bits from, Bits to) { return d.zext(d.sub(from, to, exponentBits), exponentBits, 64); };
    const Bits place = literal(point, exponentBits);
    const Bool isLarge = d.sle(place, x.exponent, exponentBits);
    const Bits shifted = d.select(isLarge, d.shl(doubled, distance(x.exponent, place), 64),
                                  d.lshr(doubled, distance(place, x.exponent), 64), 64);
    Bits size = d.zext(d.extract(shifted, 63, 1), 63, 64);
    if (round) size = d.add(size, d.zext(d.extract(shifted, 0, 0), 1, 64), 64);
    const Bits value = d.select(x.isNegative, d.sub(literal(0, 64), size, 64), size, 64);
    const Bits furthest =
        d.select(d.land(x.isNegative, d.lnot(x.isNan)), literal(1ULL << 63, 64), literal(~0ULL >> 1, 64), 64);
    return d.select(d.ult(magnitude(a), literal(largestWhole(), 31), 31), value, furthest, 64);
  }

 private:
  static constexpr int bias = 127;
  static constexpr int exponentBits = 12;  ///< signed: those of products and quotients of subnormal numbers too
  static constexpr int resultBits = 28;    ///< of a result before it is rounded: 24, and four that decide how
  struct Parts {
    Bool isNegative, isNan, isInfinite, isZero;
    Bits exponent;     ///< biased
    Bits significand;  ///< 24 bits, with the hidden one
  };

  Bits literal(std::uint64_t value, int width) { return d.literal(value, width); }
  Bool isZero(Bits a, int width) { return d.equal(a, literal(0, width), width); }
  Bits magnitude(Bits a) { return d.extract(a, 30, 0); }
  Bool isNan(Bits a) { return d.ult(literal(0x7F800000, 31), magnitude(a), 31); }
  Bool areZero(Bits a, Bits b) { return d.land(isZero(magnitude(a), 31), isZero(magnitude(b), 31)); }
  Bits zero(Bool isNegative) { return d.concat(d.fromBool(isNegative, 1), 1, literal(0, 31), 31); }
  Bits infinity(Bool isNegative) { return d.concat(d.fromBool(isNegative, 1), 1, literal(0x7F800000, 31), 31); }
  Bits orNan(Bool isUndefined, Bits value) { return d.select(isUndefined, literal(0x7FC00000, 32), value, 32); }
  /// Pattern of the smallest number that Concrete::rtoInt takes for too large.
  static std::uint64_t largestWhole() {
    float limit = 9.0e18F;
    if (static_cast<double>(limit) < 9.0e18) limit = std::nextafter(limit, 1.0e19F);
    return std::bit_cast<std::uint32_t>(limit);
  }

  Parts partsOf(Bits a) {
    const Bits field = d.extract(a, 30, 23), fraction = d.extract(a, 22, 0);
    const Bool isSmall = isZero(field, 8), isLast = d.equal(field, literal(255, 8), 8), isWhole = isZero(fraction, 23);
    const Bits exponent = d.select(isSmall, literal(1, exponentBits), d.zext(field, 8, exponentBits), exponentBits);
    const Bits significand = d.concat(d.fromBool(d.lnot(isSmall), 1), 1, fraction, 23);
    return {d.bit(a, 31), d.land(isLast, d.lnot(isWhole)), d.land(isLast, isWhole), d.land(isSmall, isWhole), exponent,
            significand};
  }
  /// Parts with the highest bit of the significand set, unless the number is zero.
  Parts normalPartsOf(Bits a) {
    Parts parts = partsOf(a);
    const auto [normal, shift] = normalised(parts.significand, 24);
    parts.significand = normal;
    parts.exponent = d.sub(parts.exponent, shift, exponentBits);
    return parts;
  }
  /// The value shifted left until its highest bit is set, and by how much. 0 stays 0.
  std::pair<Bits, Bits> normalised(Bits value, int width) {
    Bits shift = literal(0, exponentBits);
    for (int step = 16; step > 0; step /= 2) {
      const Bool isSmall = isZero(d.extract(value, width - 1, width - step), step);
      const Bits moved = d.concat(d.extract(value, width - 1 - step, 0), width - step, literal(0, step), step);
      value = d.select(isSmall, moved, value, width);
      shift = d.bor(shift,
                    d.select(isSmall, literal(static_cast<std::uint64_t>(step), exponentBits), literal(0, exponentBits),
                             exponentBits),
                    exponentBits);
    }
    return {value, shift};
  }
  /// Shifted right; the lowest bit tells whether a 1 was lost.
  Bits shiftedRight(Bits value, Bits distance) {
    const Bits shifted = d.lshr(value, distance, resultBits);
    const Bool isLossy = d.lnot(d.equal(d.shl(shifted, distance, resultBits), value, resultBits));
    return d.bor(shifted, d.zext(d.fromBool(isLossy, 1), 1, resultBits), resultBits);
  }
  /// A result whose highest bit may be the second one.
  Bits nearlyNormal(Bool isNegative, Bits exponent, Bits value) {
    const Bool isNormal = d.bit(value, resultBits - 1);
    const Bits moved = d.concat(d.extract(value, resultBits - 2, 0), resultBits - 1, literal(0, 1), 1);
    const Bits lower = d.sub(exponent, literal(1, exponentBits), exponentBits);
    return packed(isNegative, d.select(isNormal, exponent, lower, exponentBits),
                  d.select(isNormal, value, moved, resultBits));
  }
  /// Rounded to nearest even. A carry out of the significand goes into the exponent, up to infinity.
  Bits packed(Bool isNegative, Bits exponent, Bits value) {
    const Bool isTiny = d.slt(exponent, literal(1, exponentBits), exponentBits);
    const Bits lack = d.select(isTiny, d.sub(literal(1, exponentBits), exponent, exponentBits),
                               literal(0, exponentBits), exponentBits);
    const Bits kept = shiftedRight(value, d.zext(lack, exponentBits, resultBits));
    const Bits field = d.select(isTiny, literal(0, exponentBits),
                                d.sub(exponent, literal(1, exponentBits), exponentBits), exponentBits);
    const Bool isHalf = d.bit(kept, 3), isMore = d.lnot(isZero(d.extract(kept, 2, 0), 3)), isOdd = d.bit(kept, 4);
    const Bits base = d.concat(d.extract(field, 8, 0), 9, literal(0, 23), 23);
    const Bits number = d.add(base, d.zext(d.extract(kept, resultBits - 1, 4), 24, 32), 32);
    const Bits rounded = d.add(number, d.zext(d.fromBool(d.land(isHalf, d.lor(isMore, isOdd)), 1), 1, 32), 32);
    const Bool isTooLarge = d.sle(literal(255, exponentBits), exponent, exponentBits);
    return d.select(isTooLarge, infinity(isNegative),
                    d.concat(d.fromBool(isNegative, 1), 1, d.extract(rounded, 30, 0), 31), 32);
  }

  D& d;
};

}  // namespace rungproof
