// Conversions of ACCU1 (002:2725-2742; BCD 003:1000-1008). Sign nibbles, ranges and flags that the text leaves out:
// general knowledge.
#pragma once

#include "ir/s7300/isa/load.hpp"

namespace rungproof::isa::step7 {

constexpr Desc convertDesc(std::string_view stl, std::string_view german, std::string_view meaning,
                           std::string_view manual) {
  return accuDesc(stl, german, meaning, "conversion", manual);
}

/// The number that `digits` BCD digits mean, and whether one of them is none.
template <class D>
struct Decimal {
  typename D::Bits value;
  typename D::Bool isWrong;
};
template <class D>
Decimal<D> fromBcd(D& d, typename D::Bits bcd, int digits, int w) {
  auto value = d.literal(0, w);
  auto isWrong = d.constant(false);
  for (int i = digits - 1; i >= 0; --i) {
    const auto digit = d.extract(bcd, 4 * i + 3, 4 * i);
    isWrong = d.lor(isWrong, d.ult(d.literal(9, 4), digit, 4));
    value = d.add(d.mul(value, d.literal(10, w), w), d.zext(digit, 4, w), w);
  }
  return {value, isWrong};
}
/// `digits` BCD digits of a number that fits them, 4 * digits bits wide.
template <class D>
typename D::Bits toBcd(D& d, typename D::Bits value, int digits, int w) {
  auto rest = value;
  auto bcd = d.extract(d.urem(rest, d.literal(10, w), w), 3, 0);
  for (int i = 1; i < digits; ++i) {
    rest = d.udiv(rest, d.literal(10, w), w);
    bcd = d.concat(d.extract(d.urem(rest, d.literal(10, w), w), 3, 0), 4, bcd, 4 * i);
  }
  return bcd;
}

/// BTI, BTD: the top bit alone is the sign. A digit above 9 is a synchronous error (002:1286).
template <int w, Name stlName, Name manualLine>
struct BcdToInteger {
  static constexpr Desc desc = convertDesc(stlName.view(), {}, "BCD to integer", manualLine.view());
  template <class D>
  static void run(Step7Args<D>& a) {
    D& d = a.d;
    const auto bcd = w == 16 ? a.low1() : a.accu1();
    const Decimal<D> number = fromBcd(d, bcd, w / 4 - 1, w);
    a.m.error(Hazard::S7Bcd, number.isWrong);
    const auto value = d.select(d.bit(bcd, w - 1), d.sub(a.number(0, w), number.value, w), number.value, w);
    a.m.when(d.lnot(number.isWrong), [&] {
      if constexpr (w == 16)
        a.setLow1(value);
      else
        a.setAccu1(value);
    });
  }
};

/// ITB, DTB: what does not fit stays as it is and sets OV and OS.
template <int w, Name stlName, Name manualLine>
struct IntegerToBcd {
  static constexpr Desc desc = convertDesc(stlName.view(), {}, "integer to BCD", manualLine.view());
  template <class D>
  static void run(Step7Args<D>& a) {
    D& d = a.d;
    const auto value = w == 16 ? a.low1() : a.accu1();
    const auto negative = d.bit(value, w - 1);
    const auto size = d.select(negative, d.sub(a.number(0, w), value, w), value, w);
    const auto fits = d.ule(size, a.number(w == 16 ? 999 : 9999999, w), w);
    const auto sign = d.select(negative, a.number(15, 4), a.number(0, 4), 4);
    const auto bcd = d.concat(sign, 4, toBcd(d, size, w / 4 - 1, w), w - 4);
    a.m.when(fits, [&] {
      if constexpr (w == 16)
        a.setLow1(bcd);
      else
        a.setAccu1(bcd);
    });
    a.setOverflow(d.lnot(fits));
  }
};

struct IntegerToDouble {
  static constexpr Desc desc = convertDesc("ITD", {}, "integer to double integer", "002:2730");
  template <class D>
  static void run(Step7Args<D>& a) {
    a.setAccu1(a.d.sext(a.low1(), 16, 32));
  }
};

struct DoubleToReal {
  static constexpr Desc desc = convertDesc("DTR", {}, "double integer to REAL", "002:2732");
  template <class D>
  static void run(Step7Args<D>& a) {
    a.setAccu1(a.d.rfromInt(a.accu1()));
  }
};

/// INVI, INVD, NEGI, NEGD.
template <int w, bool negates, Name stlName, Name manualLine>
struct Complement {
  static constexpr Desc desc =
      convertDesc(stlName.view(), {}, negates ? "twos complement" : "ones complement", manualLine.view());
  template <class D>
  static void run(Step7Args<D>& a) {
    D& d = a.d;
    const auto value = w == 16 ? a.low1() : a.accu1();
    const auto result = negates ? d.sub(a.number(0, w), value, w) : d.bnot(value, w);
    if constexpr (w == 16)
      a.setLow1(result);
    else
      a.setAccu1(result);
    if constexpr (!negates) return;
    a.setSign(result, w);
    a.setOverflow(d.equal(value, a.number(std::uint64_t{1} << (w - 1), w), w));
  }
};

struct NegateReal {
  static constexpr Desc desc = convertDesc("NEGR", {}, "negate a REAL", "002:2737");
  template <class D>
  static void run(Step7Args<D>& a) {
    a.setAccu1(a.d.bxor(a.accu1(), a.number(0x80000000), 32));
  }
};

struct SwapLowBytes {
  static constexpr Desc desc = convertDesc("CAW", "TAW", "exchange the bytes of ACCU1-L", "002:1503");
  template <class D>
  static void run(Step7Args<D>& a) {
    const auto v = a.accu1();
    a.setLow1(a.d.concat(a.d.extract(v, 7, 0), 8, a.d.extract(v, 15, 8), 8));
  }
};

struct ReverseBytes {
  static constexpr Desc desc = convertDesc("CAD", "TAD", "reverse the bytes of ACCU1", "002:1512");
  template <class D>
  static void run(Step7Args<D>& a) {
    const auto v = a.accu1();
    const auto low = a.d.concat(a.d.extract(v, 7, 0), 8, a.d.extract(v, 15, 8), 8);
    const auto high = a.d.concat(a.d.extract(v, 23, 16), 8, a.d.extract(v, 31, 24), 8);
    a.setAccu1(a.d.concat(low, 16, high, 16));
  }
};

enum class Rounding : std::uint8_t { HalfToEven, ToZero, Down, Up };

/// RND, TRUNC, RND-, RND+: REAL to DINT; what does not fit stays as it is and sets OV and OS.
template <Rounding kind, Name stlName, Name manualLine>
struct RoundReal {
  static constexpr Desc desc = convertDesc(stlName.view(), {}, "REAL to double integer", manualLine.view());
  template <class D>
  static void run(Step7Args<D>& a) {
    D& d = a.d;
    const auto real = a.accu1();
    const auto whole = d.rtoInt(real, false);  // 64 bits
    const auto back = d.rfromInt(d.extract(whole, 31, 0));
    const auto one = a.number(1, 64);
    // Below 2^23 the whole part fits and has its exact REAL; above there are no fractions.
    const auto hasFraction = d.lnot(d.requal(back, real));
    const auto isSmall = d.land(d.ult(d.band(real, a.number(0x7FFFFFFF), 32), a.number(0x4B000000), 32), hasFraction);
    const auto negative = d.bit(real, 31);
    auto step = a.no();  // away from zero
    if constexpr (kind == Rounding::Down) step = negative;
    if constexpr (kind == Rounding::Up) step = d.lnot(negative);
    if constexpr (kind == Rounding::HalfToEven) {
      const auto rest = d.band(d.rsub(real, back), a.number(0x7FFFFFFF), 32);
      const auto half = a.number(0x3F000000);
      step = d.lor(d.rless(half, rest), d.land(d.requal(half, rest), d.bit(whole, 0)));
    }
    const auto further = d.select(negative, d.sub(whole, one, 64), d.add(whole, one, 64), 64);
    const auto result = d.select(d.land(isSmall, step), further, whole, 64);
    const auto low = d.extract(result, 31, 0);
    const auto fits = d.land(d.rlegal(real), d.equal(d.sext(low, 32, 64), result, 64));
    a.m.when(fits, [&] { a.setAccu1(low); });
    a.setOverflow(d.lnot(fits));
  }
};

using Step7ConvertGroup =
    Group<BcdToInteger<16, "BTI", "002:2727">, IntegerToBcd<16, "ITB", "002:2728">, BcdToInteger<32, "BTD", "002:2729">,
          IntegerToDouble, IntegerToBcd<32, "DTB", "002:2731">, DoubleToReal, Complement<16, false, "INVI", "002:2733">,
          Complement<32, false, "INVD", "002:2734">, Complement<16, true, "NEGI", "002:2735">,
          Complement<32, true, "NEGD", "002:2736">, NegateReal, SwapLowBytes, ReverseBytes,
          RoundReal<Rounding::HalfToEven, "RND", "002:2740">, RoundReal<Rounding::ToZero, "TRUNC", "002:2741">,
          RoundReal<Rounding::Down, "RND-", "002:2742">, RoundReal<Rounding::Up, "RND+", "002:2742">>;

}  // namespace rungproof::isa::step7
