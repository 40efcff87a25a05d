// Whole numbers: sums and products wrap at the width of their operands, quotients are cut towards zero, a remainder has
// the sign of the dividend. Operands: width, and whether the values are signed.
#pragma once

#include "ir/iec/isa/iec_group.hpp"

namespace rungproof::isa::iec {

enum class NumberOperator : std::uint8_t { Add, Sub, Mul };

template <NumberOperator which, Name mnemonic, Role role>
struct Arithmetic {
  static constexpr Desc desc = withOperands(described(mnemonic.view(), "combine two numbers", role), {part("WIDTH")});
  template <class D>
  static void run(IecArgs<D>& a) {
    const auto right = a.pop(), left = a.pop();
    const int w = a.width();
    a.push(which == NumberOperator::Add   ? a.d.add(left, right, w)
           : which == NumberOperator::Sub ? a.d.sub(left, right, w)
                                          : a.d.mul(left, right, w));
  }
};

/// A division by zero ends the scan, or gives 0, by the reading in force.
template <bool isRemainder, Name mnemonic>
struct Divide {
  static constexpr Desc desc =
      withOperands(described(mnemonic.view(), isRemainder ? "remainder of a division" : "quotient", Role::Div),
                   {part("WIDTH"), part("SIGNED")});
  template <class D>
  static void run(IecArgs<D>& a) {
    const auto right = a.pop(), left = a.pop();
    const int w = a.width();
    const auto isZero = a.d.equal(right, a.literal(0, w), w);
    const auto faults =
        isRemainder ? a.m.reads({Choice::IecModZero, "fault"}) : a.m.reads({Choice::IecDivZero, "fault"});
    a.m.stop(Hazard::IecDivideByZero, a.d.land(isZero, faults));
    const auto result = isRemainder ? (a.flag(1) ? a.d.srem(left, right, w) : a.d.urem(left, right, w))
                                    : (a.flag(1) ? a.d.sdiv(left, right, w) : a.d.udiv(left, right, w));
    a.push(a.d.select(isZero, a.literal(0, w), result, w));
  }
};

struct Negate {
  static constexpr Desc desc = withOperands(described("NEG", "negate a number"), {part("WIDTH")});
  template <class D>
  static void run(IecArgs<D>& a) {
    a.push(a.d.sub(a.literal(0, a.width()), a.pop(), a.width()));
  }
};

/// The least number stays as it is.
struct Absolute {
  static constexpr Desc desc = withOperands(described("ABS", "absolute value of a signed number"), {part("WIDTH")});
  template <class D>
  static void run(IecArgs<D>& a) {
    const auto value = a.pop();
    const int w = a.width();
    a.push(a.d.select(a.d.bit(value, w - 1), a.d.sub(a.literal(0, w), value, w), value, w));
  }
};

template <bool isMost, Name mnemonic>
struct Extreme {
  static constexpr Desc desc = withOperands(
      described(mnemonic.view(), isMost ? "the greater of two" : "the lesser of two"), {part("WIDTH"), part("SIGNED")});
  template <class D>
  static void run(IecArgs<D>& a) {
    const auto right = a.pop(), left = a.pop();
    const auto isLess = a.less(left, right, a.width(), a.flag(1));
    a.push(isMost ? a.d.select(isLess, right, left, a.width()) : a.d.select(isLess, left, right, a.width()));
  }
};

template <Relation relation, Name mnemonic>
struct Compare {
  static constexpr Desc desc = [] {
    Desc made = withOperands(described(mnemonic.view(), "compare two values"), {part("WIDTH"), part("SIGNED")});
    made.relation = relation;
    return made;
  }();
  template <class D>
  static void run(IecArgs<D>& a) {
    const auto right = a.pop(), left = a.pop();
    const int w = a.width();
    if constexpr (relation == Relation::Equal) a.pushBool(a.d.equal(left, right, w));
    if constexpr (relation == Relation::NotEqual) a.pushBool(a.d.lnot(a.d.equal(left, right, w)));
    if constexpr (relation == Relation::Less) a.pushBool(a.less(left, right, w, a.flag(1)));
    if constexpr (relation == Relation::Greater) a.pushBool(a.less(right, left, w, a.flag(1)));
    if constexpr (relation == Relation::LessEqual) a.pushBool(a.d.lnot(a.less(right, left, w, a.flag(1))));
    if constexpr (relation == Relation::GreaterEqual) a.pushBool(a.d.lnot(a.less(left, right, w, a.flag(1))));
  }
};

using ArithmeticGroup =
    Group<Arithmetic<NumberOperator::Add, "ADD", Role::Add>, Arithmetic<NumberOperator::Sub, "SUB", Role::Sub>,
          Arithmetic<NumberOperator::Mul, "MUL", Role::Mul>, Divide<false, "DIV">, Divide<true, "MOD">, Negate,
          Absolute, Extreme<true, "MAX">, Extreme<false, "MIN">, Compare<Relation::Equal, "EQ">,
          Compare<Relation::NotEqual, "NE">, Compare<Relation::Less, "LT">, Compare<Relation::LessEqual, "LE">,
          Compare<Relation::Greater, "GT">, Compare<Relation::GreaterEqual, "GE">>;

}  // namespace rungproof::isa::iec
