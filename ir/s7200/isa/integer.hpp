// Integer arithmetic: +I -I *I /I, +D -D *D /D, MUL, DIV (001:4786-4936).
// On overflow SM1.1 is set and the operands stay as they were; on division by zero SM1.3 is set and the other
// status bits keep their values (001:4814). Tests: tests/manual/integer_results_test.cpp.
#pragma once

#include "ir/s7200/isa/group.hpp"

namespace rungproof::isa {

inline constexpr StatusBits arithmeticBits = status::Zero | status::Overflow | status::Negative;

/// Sets SM1.0-SM1.2 from a signed result of width w and clears SM1.1.
template <class D>
void arithmeticFlags(Machine<D>& m, typename D::Bits result, int w) {
  m.flag(status::Zero, m.d.equal(result, m.number(0, w), w));
  m.flag(status::Overflow, m.d.constant(false));
  m.flag(status::Negative, m.d.bit(result, w - 1));
}

/// The overflow case: SM1.1, meaningless SM1.0 and SM1.2 (001:4814), ENO 0.
template <class D>
void arithmeticOverflow(Machine<D>& m, typename D::Bool overflow) {
  m.hazard(Hazard::Overflow, overflow);
  m.when(overflow, [&] {
    m.flag(status::Overflow, m.d.constant(true));
    m.flag(status::Zero, m.externalBit(External::UnknownStatus, 0));
    m.flag(status::Negative, m.externalBit(External::UnknownStatus, 2));
  });
}

enum class Integer { Add, Sub, Mul, Div };
constexpr Role roleOf(Integer operation) {
  constexpr Role roles[] = {Role::Add, Role::Sub, Role::Mul, Role::Div};
  return roles[static_cast<std::size_t>(operation)];
}

template <Integer operation, bool wide, Name stlName, Name boxName, Name meaning, std::uint16_t time>
struct IntegerMath {
  static constexpr Type type = wide ? Type::DInt : Type::Int;
  static constexpr int w = wide ? 32 : 16;
  static constexpr Desc desc = withOperands(
      {.stl = stlName.view(),
       .meaning = meaning.view(),
       .group = "math, increment, decrement",
       .role = roleOf(operation),
       .drawn = boxName.view(),
       .stack = {1, 0, 0},
       .eno = true,
       .affects = static_cast<StatusBits>(arithmeticBits | (operation == Integer::Div ? status::DivideByZero : 0)),
       .time = time,
       .manual = "001:4814"},
      {in("IN1", type, wide ? form::dwordIn : form::wordIn),
       inout("OUT", type, wide ? form::dwordOut : form::wordOut)});

  template <class D>
  static void run(Machine<D>& m, Args<D>& a) {
    D& d = m.d;
    const auto operand = a.value(0);
    const auto old = a.value(1);
    auto legal = d.constant(true);
    if constexpr (operation == Integer::Div) {
      const auto byZero = d.equal(operand, m.number(0, w), w);
      m.hazard(Hazard::DivideByZero, byZero);
      m.flag(status::DivideByZero, byZero);
      legal = d.lnot(byZero);
    }
    m.when(legal, [&] {
      const auto x = d.sext(old, w, 2 * w), y = d.sext(operand, w, 2 * w);
      typename D::Bits exact{};
      if constexpr (operation == Integer::Add) exact = d.add(x, y, 2 * w);
      if constexpr (operation == Integer::Sub) exact = d.sub(x, y, 2 * w);
      if constexpr (operation == Integer::Mul) exact = d.mul(x, y, 2 * w);
      if constexpr (operation == Integer::Div) exact = d.sdiv(x, y, 2 * w);
      const auto result = d.extract(exact, w - 1, 0);
      const auto overflow = d.lnot(d.equal(d.sext(result, w, 2 * w), exact, 2 * w));
      arithmeticOverflow(m, overflow);
      m.when(d.lnot(overflow), [&] {
        a.store(1, result);
        arithmeticFlags(m, result, w);
      });
    });
  }
};

using AddInt = IntegerMath<Integer::Add, false, "+I", "ADD_I", "add integers, IN1 + OUT = OUT", 2500>;
using SubInt = IntegerMath<Integer::Sub, false, "-I", "SUB_I", "subtract integers, OUT - IN1 = OUT", 2500>;
using MulInt = IntegerMath<Integer::Mul, false, "*I", "MUL_I", "multiply integers, IN1 * OUT = OUT", 3700>;
using DivInt = IntegerMath<Integer::Div, false, "/I", "DIV_I", "divide integers, OUT / IN1 = OUT", 6400>;
using AddDInt = IntegerMath<Integer::Add, true, "+D", "ADD_DI", "add double integers, IN1 + OUT = OUT", 2900>;
using SubDInt = IntegerMath<Integer::Sub, true, "-D", "SUB_DI", "subtract double integers, OUT - IN1 = OUT", 2900>;
using MulDInt = IntegerMath<Integer::Mul, true, "*D", "MUL_DI", "multiply double integers, IN1 * OUT = OUT", 4700>;
using DivDInt = IntegerMath<Integer::Div, true, "/D", "DIV_DI", "divide double integers, OUT / IN1 = OUT", 25000>;

constexpr Desc wideDesc(Role role, std::string_view stl, std::string_view meaning, std::uint32_t time,
                        std::string_view manual) {
  return withOperands({.stl = stl,
                       .meaning = meaning,
                       .group = "math, increment, decrement",
                       .role = role,
                       .stack = {1, 0, 0},
                       .eno = true,
                       .affects = static_cast<StatusBits>(arithmeticBits | status::DivideByZero),
                       .time = time,
                       .manual = manual},
                      {in("IN1", Type::Int, form::wordIn), lowWordRead(inout("OUT", Type::DInt, form::dwordOut))});
}

/// MUL: IN1 times the low word of OUT into the double word OUT (001:4881).
struct MulWide {
  static constexpr Desc desc = wideDesc(Role::MulWide, "MUL", "multiply integers, 16*16 -> 32", 3700, "001:4881");
  template <class D>
  static void run(Machine<D>& m, Args<D>& a) {
    D& d = m.d;
    const auto product = d.mul(d.sext(a.value(0), 16, 32), d.sext(d.extract(a.value(1), 15, 0), 16, 32), 32);
    a.store(1, product);
    arithmeticFlags(m, product, 32);
    m.flag(status::DivideByZero, d.constant(false));
  }
};

/// DIV: low word of OUT by IN1; remainder to the high word of OUT, quotient to the low one (001:4890-4894). The
/// remainder has the dividend's sign; -32768 / -1 overflows and leaves OUT (the manual is silent on both).
struct DivWide {
  static constexpr Desc desc = wideDesc(
      Role::DivWide, "DIV", "divide integers with remainder, 16/16 -> 32 (remainder high word, quotient low word)",
      6700, "001:4890");
  template <class D>
  static void run(Machine<D>& m, Args<D>& a) {
    D& d = m.d;
    const auto divisor = a.value(0), dividend = d.extract(a.value(1), 15, 0);
    const auto byZero = d.equal(divisor, m.number(0, 16), 16);
    m.hazard(Hazard::DivideByZero, byZero);
    m.flag(status::DivideByZero, byZero);
    m.when(d.lnot(byZero), [&] {
      const auto overflow =
          d.land(d.equal(divisor, m.number(0xFFFF, 16), 16), d.equal(dividend, m.number(0x8000, 16), 16));
      arithmeticOverflow(m, overflow);
      m.when(d.lnot(overflow), [&] {
        const auto quotient = d.sdiv(dividend, divisor, 16);
        const auto result = d.concat(d.srem(dividend, divisor, 16), 16, quotient, 16);
        a.store(1, result);
        const auto ofQuotient = m.reads({Choice::DivideFlags, "quotient"});
        arithmeticFlags(m, d.select(ofQuotient, d.sext(quotient, 16, 32), result, 32), 32);
      });
    });
  }
};

using IntegerGroup = Group<AddInt, SubInt, MulInt, DivInt, AddDInt, SubDInt, MulDInt, DivDInt, MulWide, DivWide>;

}  // namespace rungproof::isa
