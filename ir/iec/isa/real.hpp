// REAL: IEEE 754 single, round to nearest even; nothing is an error (x/0.0 is infinite).
#pragma once

#include "ir/iec/isa/iec_group.hpp"

namespace rungproof::isa::iec {

enum class RealOperator : std::uint8_t { Add, Sub, Mul, Div };

template <RealOperator which, Name mnemonic>
struct RealArithmetic {
  static constexpr Desc desc = described(mnemonic.view(), "combine two REAL numbers");
  template <class D>
  static void run(IecArgs<D>& a) {
    const auto right = a.pop(), left = a.pop();
    a.push(which == RealOperator::Add   ? a.d.radd(left, right)
           : which == RealOperator::Sub ? a.d.rsub(left, right)
           : which == RealOperator::Mul ? a.d.rmul(left, right)
                                        : a.d.rdiv(left, right));
  }
};

struct RealNegate {
  static constexpr Desc desc = described("NEG.REAL", "negate a REAL number");
  template <class D>
  static void run(IecArgs<D>& a) {
    a.push(a.d.bxor(a.pop(), a.literal(0x80000000U, 32), 32));
  }
};

struct RealAbsolute {
  static constexpr Desc desc = described("ABS.REAL", "absolute value of a REAL number");
  template <class D>
  static void run(IecArgs<D>& a) {
    a.push(a.d.band(a.pop(), a.literal(0x7FFFFFFFU, 32), 32));
  }
};

/// Which: a RealFunction (ir/domain.hpp).
struct RealCall {
  static constexpr Desc desc = withOperands(described("FUNC.REAL", "function of a REAL number"), {part("WHICH")});
  template <class D>
  static void run(IecArgs<D>& a) {
    a.push(a.d.rfunction(static_cast<std::uint64_t>(a.number(0)), a.pop()));
  }
};

template <bool isMost, Name mnemonic>
struct RealExtreme {
  static constexpr Desc desc = described(mnemonic.view(), isMost ? "the greater of two" : "the lesser of two");
  template <class D>
  static void run(IecArgs<D>& a) {
    const auto right = a.pop(), left = a.pop();
    const auto isLess = a.d.rless(left, right);
    a.push(isMost ? a.d.select(isLess, right, left, 32) : a.d.select(isLess, left, right, 32));
  }
};

/// A comparison with NaN is FALSE, <> is TRUE.
template <Relation relation, Name mnemonic>
struct RealCompare {
  static constexpr Desc desc = [] {
    Desc made = described(mnemonic.view(), "compare two REAL numbers");
    made.relation = relation;
    return made;
  }();
  template <class D>
  static void run(IecArgs<D>& a) {
    const auto right = a.pop(), left = a.pop();
    if constexpr (relation == Relation::Equal) a.pushBool(a.d.requal(left, right));
    if constexpr (relation == Relation::NotEqual) a.pushBool(a.d.lnot(a.d.requal(left, right)));
    if constexpr (relation == Relation::Less) a.pushBool(a.d.rless(left, right));
    if constexpr (relation == Relation::Greater) a.pushBool(a.d.rless(right, left));
    if constexpr (relation == Relation::LessEqual) a.pushBool(a.d.lor(a.d.rless(left, right), a.d.requal(left, right)));
    if constexpr (relation == Relation::GreaterEqual)
      a.pushBool(a.d.lor(a.d.rless(right, left), a.d.requal(left, right)));
  }
};

using RealGroup =
    Group<RealArithmetic<RealOperator::Add, "ADD.REAL">, RealArithmetic<RealOperator::Sub, "SUB.REAL">,
          RealArithmetic<RealOperator::Mul, "MUL.REAL">, RealArithmetic<RealOperator::Div, "DIV.REAL">, RealNegate,
          RealAbsolute, RealCall, RealExtreme<true, "MAX.REAL">, RealExtreme<false, "MIN.REAL">,
          RealCompare<Relation::Equal, "EQ.REAL">, RealCompare<Relation::NotEqual, "NE.REAL">,
          RealCompare<Relation::Less, "LT.REAL">, RealCompare<Relation::LessEqual, "LE.REAL">,
          RealCompare<Relation::Greater, "GT.REAL">, RealCompare<Relation::GreaterEqual, "GE.REAL">>;

}  // namespace rungproof::isa::iec
