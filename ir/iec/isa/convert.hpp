// Conversions between whole numbers of any width, and between whole numbers and REAL.
#pragma once

#include <bit>
#include <cmath>

#include "ir/iec/isa/iec_group.hpp"

namespace rungproof::isa::iec {

/// To a wider or narrower number: a signed one is extended by its sign, a narrower result has the low bits.
struct Resize {
  static constexpr Desc desc =
      withOperands(described("RESIZE", "to another width"), {part("FROM"), part("TO"), part("SIGNED")});
  template <class D>
  static void run(IecArgs<D>& a) {
    const auto value = a.pop();
    const int from = a.width(0), to = a.width(1);
    if (to < from) return a.push(a.d.extract(value, to - 1, 0));
    if (to == from) return a.push(value);
    a.push(a.flag(2) ? a.d.sext(value, from, to) : a.d.zext(value, from, to));
  }
};

/// From a number of 32 bits. An unsigned one above 16#7FFFFFFF is halved first; the last bit sticks, so that the sum is
/// rounded once.
struct ToReal {
  static constexpr Desc desc = withOperands(described("TO.REAL", "whole number to REAL"), {part("SIGNED")});
  template <class D>
  static void run(IecArgs<D>& a) {
    const auto value = a.pop();
    const auto direct = a.d.rfromInt(value);
    if (a.flag(0)) return a.push(direct);
    const auto half = a.d.bor(a.d.lshr(value, a.literal(1, 32), 32), a.d.band(value, a.literal(1, 32), 32), 32);
    const auto halved = a.d.rfromInt(half);
    a.push(a.d.select(a.d.bit(value, 31), a.d.radd(halved, halved), direct, 32));
  }
};

/// To a number of WIDTH bits: rounded (halves by the reading in force), or cut towards zero. What does not fit has any
/// value: the nearest one with some bits changed, none of them in a run that nothing is told about.
struct FromReal {
  static constexpr Desc desc =
      withOperands(described("FROM.REAL", "REAL to whole number"), {part("WIDTH"), part("SIGNED"), part("ROUNDS")});
  template <class D>
  static void run(IecArgs<D>& a) {
    D& d = a.d;
    const auto value = a.pop();
    const int w = a.width(0);
    const auto cut = d.rtoInt(value, false);
    auto number = cut;
    if (a.flag(2)) {
      const auto away = d.rtoInt(value, true);
      const auto distance = d.rsub(value, d.rfromInt(d.extract(cut, 31, 0)));
      const auto isHalf = d.equal(d.band(distance, a.literal(0x7FFFFFFFU, 32), 32), a.literal(0x3F000000U, 32), 32);
      const auto even = d.select(d.land(isHalf, d.lnot(d.bit(cut, 0))), cut, away, 64);
      number = d.select(a.m.reads({Choice::IecRound, "half-even"}), even, away, 64);
    }
    const std::uint64_t range = std::uint64_t{1} << (a.flag(1) ? w - 1 : w);
    const auto low = a.literal(a.flag(1) ? 0 - range : 0, 64), high = a.literal(range - 1, 64);
    const auto isBelow = d.slt(number, low, 64), isAbove = d.slt(high, number, 64);
    const auto nearest = d.select(isBelow, low, d.select(isAbove, high, number, 64), 64);
    const auto result = d.extract(nearest, w - 1, 0);
    const auto any = [&] { return a.m.external(External::UnknownResult, 0, w); };
    if constexpr (std::same_as<typename D::Bool, bool>) {
      const bool isNumber = !std::isnan(std::bit_cast<float>(static_cast<std::uint32_t>(value)));
      return a.push(isNumber && !isBelow && !isAbove ? result : result ^ any());
    }
    const auto fits = d.land(d.rlegal(value), d.lnot(d.lor(isBelow, isAbove)));
    if (const auto known = d.truth(fits); known && *known) return a.push(result);
    a.push(d.select(fits, result, d.bxor(result, any(), w), w));
  }
};

using ConvertGroup = Group<Resize, ToReal, FromReal>;

}  // namespace rungproof::isa::iec
