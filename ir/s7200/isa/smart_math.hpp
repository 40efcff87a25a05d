// Arithmetic that the S7-200 SMART adds with firmware V2.8: double words in BCD, absolute values, linear scaling. Arc
// functions are in ir/s7200/isa/real.hpp, NAND and its kin in ir/s7200/isa/logic.hpp. The operands of the scaling boxes
// and the order in which they round are uncertain: their result is any value. Tests: tests/smart.
#pragma once

#include "ir/s7200/isa/convert.hpp"
#include "ir/s7200/isa/real.hpp"

namespace rungproof::isa {

constexpr Desc smartBox(std::string_view stl, std::string_view box, std::string_view meaning, std::string_view group,
                        StatusBits affects, std::initializer_list<OperandDesc> operands) {
  return withOperands({.stl = stl,
                       .meaning = meaning,
                       .group = group,
                       .drawn = box,
                       .stack = {1, 0, 0},
                       .eno = true,
                       .affects = affects,
                       .cpus = smartCpus,
                       .since28 = true,
                       .manual = smartManual},
                      operands);
}

inline constexpr std::uint64_t largestBcd = 99'999'999;

/// BCDDI: eight BCD digits to a number; a digit above 9 sets SM1.6.
struct BcdToDoubleInt {
  static constexpr Desc desc = smartBox("BCDDI", "BCD_DI", "BCD to double integer", "table, find, conversion",
                                        status::NotBcd, {inout("OUT", Type::DWord, form::dwordOut)});
  template <class D>
  static void run(Machine<D>& m, Args<D>& a) {
    D& d = m.d;
    const auto value = a.value(0);
    auto result = m.number(0, 32);
    auto bad = d.constant(false);
    for (int digit = 7; digit >= 0; --digit) {
      const auto nibble = d.extract(value, 4 * digit + 3, 4 * digit);
      bad = d.lor(bad, d.ult(m.number(9, 4), nibble, 4));
      result = d.add(d.mul(result, m.number(10, 32), 32), d.zext(nibble, 4, 32), 32);
    }
    storeUnless(m, a, 0, result, bad, Hazard::NotBcd, status::NotBcd);
  }
};

/// DIBCD: 0 to 99999999 to eight BCD digits; anything else sets SM1.1.
struct DoubleIntToBcd {
  static constexpr Desc desc = smartBox("DIBCD", "DI_BCD", "double integer to BCD", "table, find, conversion",
                                        status::Overflow, {inout("OUT", Type::DWord, form::dwordOut)});
  template <class D>
  static void run(Machine<D>& m, Args<D>& a) {
    D& d = m.d;
    const auto value = a.value(0), ten = m.number(10, 32);
    auto rest = value, result = m.number(0, 32);
    for (std::uint64_t digit = 0; digit < 8; ++digit) {
      result = d.bor(result, d.shl(d.urem(rest, ten, 32), m.number(4 * digit, 32), 32), 32);
      rest = d.udiv(rest, ten, 32);
    }
    storeUnless(m, a, 0, result, d.ult(m.number(largestBcd, 32), value, 32), Hazard::Overflow, status::Overflow);
  }
};

/// ABSI, ABSDI, ABSR: the smallest number stays as it is.
template <Type type, Name stlName, Name boxName, Name meaning>
struct Absolute {
  static constexpr int w = bits(widthOf(type));
  static constexpr Forms source = type == Type::Int ? form::wordIn : type == Type::DInt ? form::dwordIn : form::realIn;
  static constexpr Forms target = type == Type::Int ? form::wordOut : form::dwordOut;
  static constexpr Desc desc = smartBox(stlName.view(), boxName.view(), meaning.view(), "math, increment, decrement",
                                        status::Zero, {in("IN", type, source), out("OUT", type, target)});
  template <class D>
  static void run(Machine<D>& m, Args<D>& a) {
    D& d = m.d;
    const auto value = a.value(0), zero = m.number(0, w);
    typename D::Bits result{};
    if constexpr (type == Type::Real) {
      result = d.band(value, m.number(0x7FFFFFFF, 32), 32);
    } else {
      result = d.select(d.slt(value, zero, w), d.sub(zero, value, w), value, w);
    }
    a.store(1, result);
    m.flag(status::Zero, d.equal(result, zero, w));
  }
};

/// S_ITR, S_RTR, S_RTI: OUT = (OSH - OSL) * (IN - ISL) / (ISH - ISL) + OSL, with error 0090 outside the ranges.
template <Type from, Type to, Name stlName, Name meaning>
struct Scale {
  static constexpr Forms source = from == Type::Int ? form::wordIn : form::realIn;
  static constexpr Forms level = to == Type::Int ? form::wordIn : form::realIn;
  static constexpr Forms target = to == Type::Int ? form::wordOut : form::dwordOut;
  static constexpr Desc desc = smartBox(stlName.view(), {}, meaning.view(), "table, find, conversion", 0,
                                        {in("IN", from, source), in("ISH", from, source), in("ISL", from, source),
                                         in("OSH", to, level), in("OSL", to, level), out("OUT", to, target)});
  template <class D>
  static void run(Machine<D>& m, Args<D>& a) {
    a.store(5, m.external(External::UnknownResult, 0, bits(widthOf(to))));
    m.setBit(Reg::Eno, 0, m.externalBit(External::UnknownStatus, 0));
    m.setSm(4, 3, m.d.lor(m.sm(4, 3), m.externalBit(External::UnknownStatus, 3)));
  }
};

using AbsoluteInt = Absolute<Type::Int, "ABSI", "ABS_I", "absolute value of an integer">;
using AbsoluteDInt = Absolute<Type::DInt, "ABSDI", "ABS_DI", "absolute value of a double integer">;
using AbsoluteReal = Absolute<Type::Real, "ABSR", "ABS_R", "absolute value of a real">;
using ScaleIntToReal = Scale<Type::Int, Type::Real, "S_ITR", "scale an integer to a real">;
using ScaleRealToReal = Scale<Type::Real, Type::Real, "S_RTR", "scale a real">;
using ScaleRealToInt = Scale<Type::Real, Type::Int, "S_RTI", "scale a real to an integer">;

using SmartMathGroup = Group<BcdToDoubleInt, DoubleIntToBcd, AbsoluteInt, AbsoluteDInt, AbsoluteReal, ScaleIntToReal,
                             ScaleRealToReal, ScaleRealToInt>;

}  // namespace rungproof::isa
