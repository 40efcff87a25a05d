// REAL arithmetic and functions (002:2507, 002:2763-2775; format 003:936-984). CC1, CC0, OV and OS tell what the result
// is; numbers below the smallest normal one count as underflow and become 0; all of it general knowledge.
#pragma once

#include "ir/s7300/isa/load.hpp"

namespace rungproof::isa::step7 {

inline constexpr std::uint64_t invalidSum = 0xFFFFFFFF, invalidFunction = 0x7FFFFFFF;

template <class D>
struct RealKind {
  typename D::Bool isNan, isInfinite, isSmall, isZero;  ///< isSmall: denormal
};
template <class D>
RealKind<D> realKind(D& d, typename D::Bits v) {
  const auto size = d.band(v, d.literal(0x7FFFFFFF, 32), 32);
  const auto infinity = d.literal(0x7F800000, 32), least = d.literal(0x00800000, 32), zero = d.literal(0, 32);
  const auto isZero = d.equal(size, zero, 32);
  return {d.ult(infinity, size, 32), d.equal(size, infinity, 32), d.land(d.ult(size, least, 32), d.lnot(isZero)),
          isZero};
}

/// Stores a result in ACCU1 and tells what it is. `vanishes`: where it is 0 the exact result is not.
/// `hasDenormal`: an operand counted as 0, which gives the flags of an underflow to any number.
template <class D>
void endReal(Step7Args<D>& a, typename D::Bits result, typename D::Bool isInvalid, std::uint64_t pattern,
             typename D::Bool vanishes, typename D::Bool hasDenormal) {
  D& d = a.d;
  const RealKind<D> kind = realKind(d, result);
  const auto invalid = d.lor(isInvalid, kind.isNan);
  const auto underflows = d.land(d.lnot(invalid), d.lor(kind.isSmall, d.land(kind.isZero, vanishes)));
  auto stored = d.select(underflows, a.number(0), result, 32);
  stored = d.select(invalid, a.number(pattern), stored, 32);
  a.setAccu1(stored);
  const auto hasSign = d.lnot(d.lor(d.lor(kind.isZero, kind.isSmall), hasDenormal));
  const auto negative = d.bit(result, 31);
  a.setConditions(d.lor(invalid, d.land(hasSign, d.lnot(negative))), d.lor(invalid, d.land(hasSign, negative)));
  a.setOverflow(d.lor(d.lor(invalid, d.lor(underflows, hasDenormal)), kind.isInfinite));
}

/// Operands below the smallest normal number count as 0.
template <class D>
typename D::Bits normal(D& d, typename D::Bits v) {
  return d.select(realKind(d, v).isSmall, d.band(v, d.literal(0x80000000, 32), 32), v, 32);
}

enum class RealSum : std::uint8_t { Add, Subtract, Multiply, Divide };

template <RealSum kind, Name stlName, Name manualLine>
struct RealArithmetic {
  static constexpr Desc desc =
      accuDesc(stlName.view(), {}, "REAL arithmetic of ACCU2 with ACCU1", "floating-point math", manualLine.view());
  template <class D>
  static void run(Step7Args<D>& a) {
    D& d = a.d;
    const auto isDenormal = d.lor(realKind(d, a.accu1()).isSmall, realKind(d, a.accu2()).isSmall);
    const auto x = normal(d, a.accu2()), y = normal(d, a.accu1());
    const auto result = kind == RealSum::Add        ? d.radd(x, y)
                        : kind == RealSum::Subtract ? d.rsub(x, y)
                        : kind == RealSum::Multiply ? d.rmul(x, y)
                                                    : d.rdiv(x, y);
    // A sum of normal numbers is 0 or not below them by rounding; a product or quotient may be too small for any bit.
    auto vanishes = a.no();
    if constexpr (kind == RealSum::Multiply) vanishes = d.lnot(d.lor(realKind(d, x).isZero, realKind(d, y).isZero));
    if constexpr (kind == RealSum::Divide) vanishes = d.lnot(d.lor(realKind(d, x).isZero, realKind(d, y).isInfinite));
    endReal(a, result, a.no(), invalidSum, vanishes, isDenormal);
    a.moveUp();
  }
};

struct AbsoluteReal {
  static constexpr Desc desc = accuDesc("ABS", {}, "absolute value", "floating-point math", "002:2765");
  template <class D>
  static void run(Step7Args<D>& a) {
    a.setAccu1(a.d.band(a.accu1(), a.number(0x7FFFFFFF), 32));
  }
};

struct SquareReal {
  static constexpr Desc desc = accuDesc("SQR", {}, "square", "floating-point math", "002:2773");
  template <class D>
  static void run(Step7Args<D>& a) {
    const auto isDenormal = realKind(a.d, a.accu1()).isSmall;
    const auto x = normal(a.d, a.accu1());
    endReal(a, a.d.rmul(x, x), a.no(), invalidFunction, a.d.lnot(realKind(a.d, x).isZero), isDenormal);
  }
};

template <RealFunction function, Name stlName, Name manualLine>
struct ApplyFunction {
  static constexpr Desc desc =
      accuDesc(stlName.view(), {}, "function of ACCU1", "floating-point math", manualLine.view());
  template <class D>
  static void run(Step7Args<D>& a) {
    D& d = a.d;
    const auto isDenormal = realKind(d, a.accu1()).isSmall;
    const auto x = normal(d, a.accu1());
    const auto size = [&] { return d.band(x, a.number(0x7FFFFFFF), 32); };
    const auto isZero = [&] { return d.equal(size(), a.number(0), 32); };
    auto isOutside = a.no();
    if constexpr (function == RealFunction::Sqrt) isOutside = d.land(d.bit(x, 31), d.lnot(isZero()));
    if constexpr (function == RealFunction::Ln) isOutside = d.lor(d.bit(x, 31), isZero());
    if constexpr (function == RealFunction::ArcSin || function == RealFunction::ArcCos)
      isOutside = d.ult(a.number(0x3F800000), size(), 32);
    auto vanishes = a.no();
    if constexpr (function == RealFunction::Exp) vanishes = d.lnot(realKind(d, x).isInfinite);
    endReal(a, d.rfunction(static_cast<std::uint64_t>(function), x), isOutside, invalidFunction, vanishes, isDenormal);
  }
};

using Step7RealGroup =
    Group<RealArithmetic<RealSum::Add, "+R", "002:1442">, RealArithmetic<RealSum::Subtract, "-R", "002:1442">,
          RealArithmetic<RealSum::Multiply, "*R", "002:1442">, RealArithmetic<RealSum::Divide, "/R", "002:2507">,
          AbsoluteReal, ApplyFunction<RealFunction::ArcCos, "ACOS", "002:2766">,
          ApplyFunction<RealFunction::ArcSin, "ASIN", "002:2767">,
          ApplyFunction<RealFunction::ArcTan, "ATAN", "002:2768">, ApplyFunction<RealFunction::Cos, "COS", "002:2769">,
          ApplyFunction<RealFunction::Exp, "EXP", "002:2770">, ApplyFunction<RealFunction::Ln, "LN", "002:2771">,
          ApplyFunction<RealFunction::Sin, "SIN", "002:2772">, SquareReal,
          ApplyFunction<RealFunction::Sqrt, "SQRT", "002:2774">, ApplyFunction<RealFunction::Tan, "TAN", "002:2775">>;

}  // namespace rungproof::isa::step7
