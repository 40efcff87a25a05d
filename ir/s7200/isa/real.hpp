// REAL arithmetic +R -R *R /R and functions SQRT SIN COS TAN LN EXP (001:4786-4872, 001:4938-4995). IEEE 754 single
// precision. A result or operand that is no legal number sets SM1.1 and leaves the operands as they were (001:4814,
// 001:4976). Tests: tests/manual/real_test.cpp.
#pragma once

#include "ir/s7200/isa/integer.hpp"

namespace rungproof::isa {

/// Stores a REAL result in operand `to` where `legal` holds, otherwise reports the overflow; sets SM1.0-SM1.2.
template <class D>
void storeReal(Machine<D>& m, Args<D>& a, std::size_t to, typename D::Bits result, typename D::Bool legal) {
  D& d = m.d;
  arithmeticOverflow(m, d.lnot(legal));
  m.when(legal, [&] {
    const auto zero = m.number(0, 32);
    a.store(to, result);
    m.flag(status::Zero, d.requal(result, zero));
    m.flag(status::Overflow, d.constant(false));
    m.flag(status::Negative, d.rless(result, zero));
  });
}

enum class RealOperation { Add, Sub, Mul, Div };
constexpr Role roleOf(RealOperation operation) {
  constexpr Role roles[] = {Role::Add, Role::Sub, Role::Mul, Role::Div};
  return roles[static_cast<std::size_t>(operation)];
}

template <RealOperation operation, Name stlName, Name boxName, Name meaning, std::uint32_t time>
struct RealMath {
  static constexpr bool divides = operation == RealOperation::Div;
  static constexpr Desc desc =
      withOperands({.stl = stlName.view(),
                    .meaning = meaning.view(),
                    .group = "math, increment, decrement",
                    .role = roleOf(operation),
                    .drawn = boxName.view(),
                    .stack = {1, 0, 0},
                    .eno = true,
                    .affects = static_cast<StatusBits>(arithmeticBits | (divides ? status::DivideByZero : 0)),
                    .time = time,
                    .manual = "001:4814"},
                   {in("IN1", Type::Real, form::realIn), inout("OUT", Type::Real, form::dwordOut)});
  template <class D>
  static void run(Machine<D>& m, Args<D>& a) {
    D& d = m.d;
    const auto operand = a.value(0);
    const auto old = a.value(1);
    auto divisible = d.constant(true);
    if constexpr (divides) {
      const auto byZero = d.requal(operand, m.number(0, 32));
      m.hazard(Hazard::DivideByZero, byZero);
      m.flag(status::DivideByZero, byZero);
      divisible = d.lnot(byZero);
    }
    m.when(divisible, [&] {
      typename D::Bits result{};
      if constexpr (operation == RealOperation::Add) result = d.radd(old, operand);
      if constexpr (operation == RealOperation::Sub) result = d.rsub(old, operand);
      if constexpr (operation == RealOperation::Mul) result = d.rmul(old, operand);
      if constexpr (operation == RealOperation::Div) result = d.rdiv(old, operand);
      storeReal(m, a, 1, result, d.land(d.rlegal(result), d.land(d.rlegal(old), d.rlegal(operand))));
    });
  }
};

/// Angles are in radians (001:4942). Illegal: SQRT of a negative, LN of 0 or less, EXP beyond the range,
/// ARCSIN and ARCCOS outside -1 to 1 (S7-200 SMART only).
template <RealFunction function, Name stlName, Name meaning, std::uint32_t time>
struct RealFunctionBox {
  static constexpr bool isArc = function >= RealFunction::ArcSin;
  static constexpr Desc desc =
      withOperands({.stl = stlName.view(),
                    .meaning = meaning.view(),
                    .group = "math, increment, decrement",
                    .stack = {1, 0, 0},
                    .eno = true,
                    .affects = arithmeticBits,
                    .cpus = isArc ? smartCpus : everyCpu,
                    .since28 = isArc,
                    .time = time,
                    .manual = isArc ? smartManual : "001:4976"},
                   {in("IN", Type::Real, form::realIn), out("OUT", Type::Real, form::dwordOut)});
  template <class D>
  static void run(Machine<D>& m, Args<D>& a) {
    const auto argument = a.value(0);
    const auto result = m.d.rfunction(static_cast<std::uint64_t>(function), argument);
    storeReal(m, a, 1, result, m.d.land(m.d.rlegal(argument), m.d.rlegal(result)));
  }
};

using AddReal = RealMath<RealOperation::Add, "+R", "ADD_R", "add reals", 7100>;
using SubReal = RealMath<RealOperation::Sub, "-R", "SUB_R", "subtract reals", 7200>;
using MulReal = RealMath<RealOperation::Mul, "*R", "MUL_R", "multiply reals", 5600>;
using DivReal = RealMath<RealOperation::Div, "/R", "DIV_R", "divide reals", 17700>;
using SquareRoot = RealFunctionBox<RealFunction::Sqrt, "SQRT", "square root", 46000>;
using Sine = RealFunctionBox<RealFunction::Sin, "SIN", "sine", 90000>;
using Cosine = RealFunctionBox<RealFunction::Cos, "COS", "cosine", 90000>;
using Tangent = RealFunctionBox<RealFunction::Tan, "TAN", "tangent", 108000>;
using Logarithm = RealFunctionBox<RealFunction::Ln, "LN", "natural logarithm", 68000>;
using Exponential = RealFunctionBox<RealFunction::Exp, "EXP", "natural exponential", 72000>;

using ArcSine = RealFunctionBox<RealFunction::ArcSin, "ARCSIN", "arc sine", 0>;
using ArcCosine = RealFunctionBox<RealFunction::ArcCos, "ARCCOS", "arc cosine", 0>;
using ArcTangent = RealFunctionBox<RealFunction::ArcTan, "ARCTAN", "arc tangent", 0>;

using RealGroup = Group<AddReal, SubReal, MulReal, DivReal, SquareRoot, Sine, Cosine, Tangent, Logarithm, Exponential,
                        ArcSine, ArcCosine, ArcTangent>;

}  // namespace rungproof::isa
