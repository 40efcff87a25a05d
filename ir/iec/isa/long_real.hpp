// LREAL: IEEE 754 double, round to nearest even; nothing is an error (x/0.0 is infinite). The engine computes exactly;
// in proofs the result of a sum, product or function is any number, what is compared, moved or negated is exact.
#pragma once

#include <bit>
#include <cmath>

#include "ir/iec/isa/iec_group.hpp"
#include "ir/long_real_order.hpp"

namespace rungproof::isa::iec {

template <class D>
typename D::Bits longReal(IecArgs<D>& a, LongRealOperation which, typename D::Bits value, int width = 64) {
  return a.d.longReal(static_cast<std::uint64_t>(which), value, width);
}

template <LongRealOperation which, Name mnemonic>
struct LongRealArithmetic {
  static constexpr Desc desc = described(mnemonic.view(), "combine two LREAL numbers");
  template <class D>
  static void run(IecArgs<D>& a) {
    const auto right = a.pop(), left = a.pop();
    a.push(a.d.longReal(static_cast<std::uint64_t>(which), left, right, 64));
  }
};

struct LongRealNegate {
  static constexpr Desc desc = described("NEG.LREAL", "negate an LREAL number");
  template <class D>
  static void run(IecArgs<D>& a) {
    a.push(a.d.bxor(a.pop(), a.literal(LongRealOrder<D>::sign, 64), 64));
  }
};

struct LongRealAbsolute {
  static constexpr Desc desc = described("ABS.LREAL", "absolute value of an LREAL number");
  template <class D>
  static void run(IecArgs<D>& a) {
    a.push(LongRealOrder<D>{a.d}.size(a.pop()));
  }
};

/// Which: a LongRealOperation of one LREAL that gives an LREAL (ir/domain.hpp).
struct LongRealCall {
  static constexpr Desc desc = withOperands(described("FUNC.LREAL", "function of an LREAL number"), {part("WHICH")});
  template <class D>
  static void run(IecArgs<D>& a) {
    a.push(longReal(a, static_cast<LongRealOperation>(a.number(0)), a.pop()));
  }
};

template <bool isMost, Name mnemonic>
struct LongRealExtreme {
  static constexpr Desc desc = described(mnemonic.view(), isMost ? "the greater of two" : "the lesser of two");
  template <class D>
  static void run(IecArgs<D>& a) {
    const auto right = a.pop(), left = a.pop();
    const auto isLess = LongRealOrder<D>{a.d}.less(left, right);
    a.push(isMost ? a.d.select(isLess, right, left, 64) : a.d.select(isLess, left, right, 64));
  }
};

template <Relation relation, Name mnemonic>
struct LongRealCompare {
  static constexpr Desc desc = [] {
    Desc made = described(mnemonic.view(), "compare two LREAL numbers");
    made.relation = relation;
    return made;
  }();
  template <class D>
  static void run(IecArgs<D>& a) {
    const auto right = a.pop(), left = a.pop();
    LongRealOrder<D> order{a.d};
    if constexpr (relation == Relation::Equal) a.pushBool(order.equal(left, right));
    if constexpr (relation == Relation::NotEqual) a.pushBool(a.d.lnot(order.equal(left, right)));
    if constexpr (relation == Relation::Less) a.pushBool(order.less(left, right));
    if constexpr (relation == Relation::Greater) a.pushBool(order.less(right, left));
    if constexpr (relation == Relation::LessEqual)
      a.pushBool(a.d.lor(order.less(left, right), order.equal(left, right)));
    if constexpr (relation == Relation::GreaterEqual)
      a.pushBool(a.d.lor(order.less(right, left), order.equal(left, right)));
  }
};

/// A whole number of 64 bits to LREAL (WIDTH 64) or REAL (32).
struct LongToReal {
  static constexpr Desc desc =
      withOperands(described("TO.LREAL", "whole number to LREAL or REAL"), {part("WIDTH"), part("SIGNED")});
  template <class D>
  static void run(IecArgs<D>& a) {
    const auto which = a.flag(1) ? LongRealOperation::FromSigned : LongRealOperation::FromUnsigned;
    a.push(longReal(a, which, a.pop(), a.width(0)));
  }
};

struct Lengthen {
  static constexpr Desc desc = described("REAL.LREAL", "REAL to LREAL");
  template <class D>
  static void run(IecArgs<D>& a) {
    a.push(longReal(a, LongRealOperation::FromReal, a.pop()));
  }
};
struct Shorten {
  static constexpr Desc desc = described("LREAL.REAL", "LREAL to REAL");
  template <class D>
  static void run(IecArgs<D>& a) {
    a.push(longReal(a, LongRealOperation::ToReal, a.pop(), 32));
  }
};

/// To a number of WIDTH bits: rounded (halves by the reading in force), or cut towards zero. What does not fit has any
/// value: the nearest one with some bits changed, none of them in a run that nothing is told about.
struct FromLongReal {
  static constexpr Desc desc =
      withOperands(described("FROM.LREAL", "LREAL to whole number"), {part("WIDTH"), part("SIGNED"), part("ROUNDS")});
  template <class D>
  static void run(IecArgs<D>& a) {
    D& d = a.d;
    const auto value = a.pop();
    const int w = a.width(0);
    const bool isSigned = a.flag(1);
    auto whole = longReal(a, LongRealOperation::Truncate, value);
    if (a.flag(2)) {
      const auto even = longReal(a, LongRealOperation::RoundEven, value);
      whole = d.select(a.m.reads({Choice::IecRound, "half-even"}), even,
                       longReal(a, LongRealOperation::RoundAway, value), 64);
    }
    const bool isLong = w == 64 && !isSigned;
    const auto number = longReal(a, isLong ? LongRealOperation::ToUnsigned : LongRealOperation::ToSigned, whole);
    auto result = number;
    if (w < 64) {
      const std::uint64_t range = std::uint64_t{1} << (isSigned ? w - 1 : w);
      const auto low = a.literal(isSigned ? 0 - range : 0, 64), high = a.literal(range - 1, 64);
      const auto isBelow = d.slt(number, low, 64), isAbove = d.slt(high, number, 64);
      result = d.extract(d.select(isBelow, low, d.select(isAbove, high, number, 64), 64), w - 1, 0);
    }
    const auto any = [&] { return a.m.external(External::UnknownResult, 0, w); };
    if constexpr (std::same_as<typename D::Bool, bool>) {
      const auto exact = std::bit_cast<double>(whole);
      const double beyond = std::ldexp(1.0, isSigned ? w - 1 : w);
      return a.push(exact >= (isSigned ? -beyond : 0) && exact < beyond ? result : result ^ any());
    }
    // 2^63 or 2^64 is the first number that 64 bits do not hold; -2^63 is one that they do.
    LongRealOrder<D> order{d};
    auto fits = order.less(order.size(whole), a.literal(isLong ? 0x43F0000000000000U : 0x43E0000000000000U, 64));
    if (isSigned && w == 64) fits = d.lor(fits, d.equal(whole, a.literal(0xC3E0000000000000U, 64), 64));
    if (isLong) fits = d.land(fits, d.lor(d.lnot(d.bit(whole, 63)), order.equal(whole, a.literal(0, 64))));
    // Sign or zero extended, a result of fewer bits is the number again.
    if (w < 64) fits = d.land(fits, d.equal(isSigned ? d.sext(result, w, 64) : d.zext(result, w, 64), number, 64));
    if (const auto known = d.truth(fits); known && *known) return a.push(result);
    a.push(d.select(fits, result, d.bxor(result, any(), w), w));
  }
};

using LongRealGroup = Group<
    LongRealArithmetic<LongRealOperation::Add, "ADD.LREAL">, LongRealArithmetic<LongRealOperation::Sub, "SUB.LREAL">,
    LongRealArithmetic<LongRealOperation::Mul, "MUL.LREAL">, LongRealArithmetic<LongRealOperation::Div, "DIV.LREAL">,
    LongRealArithmetic<LongRealOperation::Power, "POW.LREAL">,
    LongRealArithmetic<LongRealOperation::ArcTan2, "ATAN2.LREAL">, LongRealNegate, LongRealAbsolute, LongRealCall,
    LongRealExtreme<true, "MAX.LREAL">, LongRealExtreme<false, "MIN.LREAL">,
    LongRealCompare<Relation::Equal, "EQ.LREAL">, LongRealCompare<Relation::NotEqual, "NE.LREAL">,
    LongRealCompare<Relation::Less, "LT.LREAL">, LongRealCompare<Relation::LessEqual, "LE.LREAL">,
    LongRealCompare<Relation::Greater, "GT.LREAL">, LongRealCompare<Relation::GreaterEqual, "GE.LREAL">, LongToReal,
    Lengthen, Shorten, FromLongReal>;

}  // namespace rungproof::isa::iec
