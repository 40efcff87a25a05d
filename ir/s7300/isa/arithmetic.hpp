// Integer arithmetic and word logic on ACCU2 and ACCU1 (002:1442-1446, 002:2716-2761). The wrapped result is stored;
// CC1 and CC0 tell its sign, OV and OS that it did not fit. What a result leaves in ACCU1-H, and the flags of *I, *D
// and divisions: general knowledge.
#pragma once

#include "ir/s7300/isa/load.hpp"

namespace rungproof::isa::step7 {

enum class Sum : std::uint8_t { Add, Subtract };

template <Sum kind, int w, Name stlName, Name manualLine>
struct AddIntegers {
  static constexpr Desc desc = accuDesc(stlName.view(), {}, kind == Sum::Add ? "ACCU2 plus ACCU1" : "ACCU2 minus ACCU1",
                                        "integer math", manualLine.view());
  template <class D>
  static void run(Step7Args<D>& a) {
    D& d = a.d;
    const auto x = w == 16 ? a.low2() : a.accu2(), y = w == 16 ? a.low1() : a.accu1();
    const auto result = kind == Sum::Add ? d.add(x, y, w) : d.sub(x, y, w);
    const auto signX = d.bit(x, w - 1), signY = d.bit(y, w - 1), sign = d.bit(result, w - 1);
    const auto couldLeave = kind == Sum::Add ? d.lnot(d.lxor(signX, signY)) : d.lxor(signX, signY);
    if constexpr (w == 16)
      a.setLow1(result);
    else
      a.setAccu1(result);
    a.moveUp();
    a.setSign(result, w);
    a.setOverflow(d.land(couldLeave, d.lxor(sign, signX)));
  }
};

/// *I leaves 32 bits, *D the low 32; CC1 and CC0 tell the sign of the true product.
template <int w, Name stlName>
struct MultiplyIntegers {
  static constexpr Desc desc = accuDesc(stlName.view(), {}, "ACCU2 times ACCU1", "integer math", "002:2759");
  template <class D>
  static void run(Step7Args<D>& a) {
    D& d = a.d;
    constexpr int wide = 2 * w;
    const auto x = w == 16 ? a.low2() : a.accu2(), y = w == 16 ? a.low1() : a.accu1();
    const auto product = d.mul(d.sext(x, w, wide), d.sext(y, w, wide), wide);
    const auto fits = d.equal(product, d.sext(d.extract(product, w - 1, 0), w, wide), wide);
    a.setAccu1(d.extract(product, 31, 0));
    a.moveUp();
    a.setSign(product, wide);
    a.setOverflow(d.lnot(fits));
  }
};

/// /I leaves the quotient in ACCU1-L and the remainder in ACCU1-H, /D the quotient, MOD the remainder.
template <int w, bool remainder, Name stlName, Name manualLine>
struct DivideIntegers {
  static constexpr Desc desc =
      accuDesc(stlName.view(), {}, remainder ? "remainder of ACCU2 by ACCU1" : "ACCU2 divided by ACCU1", "integer math",
               manualLine.view());
  template <class D>
  static void run(Step7Args<D>& a) {
    D& d = a.d;
    const auto x = w == 16 ? a.low2() : a.accu2(), y = w == 16 ? a.low1() : a.accu1();
    const auto isZero = d.equal(y, a.number(0, w), w);
    const auto least = a.number(std::uint64_t{1} << (w - 1), w);
    const auto leaves = d.land(d.equal(x, least, w), d.equal(y, d.bnot(a.number(0, w), w), w));
    const auto quotient = d.select(isZero, a.number(0, w), d.sdiv(x, y, w), w);
    const auto rest = d.select(d.lor(isZero, leaves), a.number(0, w), d.srem(x, y, w), w);
    if constexpr (w == 16)
      a.setAccu1(d.concat(rest, 16, quotient, 16));
    else
      a.setAccu1(remainder ? rest : quotient);
    a.moveUp();
    // The quotient that leaves the range is the positive number behind it.
    const auto shown = remainder && w == 32 ? rest : quotient;
    const auto negative = d.land(d.bit(shown, w - 1), d.lnot(leaves));
    const auto positive = d.lor(leaves, d.land(d.lnot(d.bit(shown, w - 1)), d.lnot(d.equal(shown, a.number(0, w), w))));
    a.setConditions(d.lor(isZero, positive), d.lor(isZero, negative));
    a.setOverflow(d.lor(isZero, leaves));
  }
};

/// + : a constant to ACCU1; 16 bits leave ACCU1-H as it is (002:1478-1485).
struct AddConstant {
  static constexpr Desc desc = withOperands(accuDesc("+", {}, "add a constant to ACCU1", "integer math", "002:1480"),
                                            {in("number", Type::Value, form7::Const)});
  template <class D>
  static void run(Step7Args<D>& a) {
    const auto value = static_cast<std::uint64_t>(a.operand().value);
    if (a.operand().width == Width::DWord) return a.setAccu1(a.d.add(a.accu1(), a.number(value), 32));
    a.setLow1(a.d.add(a.low1(), a.number(value & 0xFFFF, 16), 16));
  }
};

enum class WordOp : std::uint8_t { And, Or, Xor };

/// AW, OW, XOW, AD, OD, XOD: with ACCU2 or a constant.
template <WordOp kind, int w, Name stlName, Name germanName, Name manualLine>
struct WordLogic {
  static constexpr Desc desc =
      withOperands(accuDesc(stlName.view(), germanName.view(), "word logic", "word logic", manualLine.view()),
                   {optional(in("mask", w == 16 ? Type::Word : Type::DWord, form7::Const))});
  template <class D>
  static void run(Step7Args<D>& a) {
    D& d = a.d;
    const auto x = w == 16 ? a.low1() : a.accu1();
    const auto y = a.hasOperand() ? a.number(static_cast<std::uint64_t>(a.operand().value), w)
                   : w == 16      ? a.low2()
                                  : a.accu2();
    const auto result = kind == WordOp::And ? d.band(x, y, w) : kind == WordOp::Or ? d.bor(x, y, w) : d.bxor(x, y, w);
    if constexpr (w == 16)
      a.setLow1(result);
    else
      a.setAccu1(result);
    a.setConditions(d.lnot(d.equal(result, a.number(0, w), w)), a.no());
    a.setBit(a.s.ov, a.no());
  }
};

using Step7ArithmeticGroup =
    Group<AddConstant, AddIntegers<Sum::Add, 16, "+I", "002:2757">, AddIntegers<Sum::Add, 32, "+D", "002:2757">,
          AddIntegers<Sum::Subtract, 16, "-I", "002:2758">, AddIntegers<Sum::Subtract, 32, "-D", "002:2758">,
          MultiplyIntegers<16, "*I">, MultiplyIntegers<32, "*D">, DivideIntegers<16, false, "/I", "002:2760">,
          DivideIntegers<32, false, "/D", "002:2760">, DivideIntegers<32, true, "MOD", "002:2761">,
          WordLogic<WordOp::And, 16, "AW", "UW", "002:2718">, WordLogic<WordOp::And, 32, "AD", "UD", "002:2718">,
          WordLogic<WordOp::Or, 16, "OW", "OW", "002:2719">, WordLogic<WordOp::Or, 32, "OD", "OD", "002:2720">,
          WordLogic<WordOp::Xor, 16, "XOW", "XOW", "002:2720">, WordLogic<WordOp::Xor, 32, "XOD", "XOD", "002:2721">>;

}  // namespace rungproof::isa::step7
