// Numbers to strings and back: ITS DTS RTS, STI STD STR (001:3762-3939). FMT stands before OUT here
// (001:14938), after it in ITA. Substrings are read from character INDX (1 is the first): blanks, one sign, digits; STR
// also takes a point or comma with digits, and no exponent. Tests: tests/manual/string_conversion_test.cpp.
#pragma once

#include <algorithm>

#include "ir/s7200/isa/ascii.hpp"

namespace rungproof::isa {

/// ITS, DTS, RTS: the characters of ITA, DTA, RTA behind a length byte (001:3770, 001:3804, 001:3821). ITS takes no
/// accumulator (001:3792).
template <NumberKind kind, Name stlName, Name boxName, Name meaning, std::uint32_t time>
struct NumberToString {
  static constexpr Forms source = kind == NumberKind::Int    ? form::wordIn & ~form::AC
                                  : kind == NumberKind::DInt ? form::dwordIn
                                                             : form::realIn;
  static constexpr Desc desc = withOperands(
      {.stl = stlName.view(),
       .meaning = meaning.view(),
       .group = "table, find, conversion",
       .drawn = boxName.view(),
       .stack = {1, 0, 0},
       .eno = true,
       .time = time,
       .manual = kind == NumberKind::Int    ? "001:3770"
                 : kind == NumberKind::DInt ? "001:3804"
                                            : "001:3821"},
      {in("IN", typeOf(kind), source), in("FMT", Type::Byte, form::byteIn), out("OUT", Type::String, form::stringOut)});
  template <class D>
  static void run(Machine<D>& m, Args<D>& a) {
    writeDecimal<kind>(m, a, 2, 1, 1);
  }
};

/// What the characters of a number have said so far.
template <class D>
struct NumberReader {
  using Bool = typename D::Bool;
  using Bits = typename D::Bits;
  static constexpr int w = 40;

  NumberReader(Machine<D>& machine, bool takesFraction)
      : m(machine),
        real(takesFraction),
        isNegative(m.d.constant(false)),
        hasDigit(m.d.constant(false)),
        isTooLarge(m.d.constant(false)),
        magnitude(m.number(0, w)),
        scale(m.number(0, 16)),
        started_(m.d.constant(false)),
        inFraction_(m.d.constant(false)),
        ended_(m.d.constant(false)) {}

  Machine<D>& m;
  const bool real;
  Bool isNegative, hasDigit;
  Bool isTooLarge;  ///< integers: above 2^31
  Bits magnitude;   ///< digits so far; of a REAL the first nine significant ones
  Bits scale;       ///< REAL: the number is magnitude / 10^scale, signed, width 16

  /// Takes the next character where `used` holds.
  void take(Bits c, Bool used) {
    D& d = m.d;
    const auto is = [&](char x) { return d.equal(c, m.number(static_cast<unsigned char>(x), 8), 8); };
    const Bool active = d.land(used, d.lnot(ended_));
    const Bool digit = d.land(active, d.land(d.ule(m.number('0', 8), c, 8), d.ule(c, m.number('9', 8), 8)));
    const Bool sign = d.land(d.land(active, d.lnot(started_)), d.lor(is('+'), is('-')));
    const Bool blank = d.land(d.land(active, d.lnot(started_)), is(' '));
    const Bool point = real ? d.land(d.land(active, hasDigit), d.land(d.lnot(inFraction_), d.lor(is('.'), is(','))))
                            : d.constant(false);
    ended_ = d.lor(ended_, d.land(active, d.lnot(d.lor(d.lor(digit, sign), d.lor(blank, point)))));
    isNegative = d.lor(isNegative, d.land(sign, is('-')));
    started_ = d.lor(started_, d.lor(sign, digit));
    hasDigit = d.lor(hasDigit, digit);
    inFraction_ = d.lor(inFraction_, point);
    addDigit(d.zext(d.sub(c, m.number('0', 8), 8), 8, w), digit);
  }

 private:
  void addDigit(Bits value, Bool digit) {
    D& d = m.d;
    const Bits longer = d.add(d.mul(magnitude, m.number(10, w), w), value, w);
    if (!real) {
      isTooLarge = d.lor(isTooLarge, d.land(digit, d.ult(m.number(1ULL << 31, w), longer, w)));
      magnitude = d.select(d.land(digit, d.lnot(isTooLarge)), longer, magnitude, w);
      return;
    }
    const Bool kept = d.land(digit, d.ult(magnitude, m.number(100'000'000, w), w));
    const Bool more = d.land(kept, inFraction_), less = d.land(digit, d.land(d.lnot(kept), d.lnot(inFraction_)));
    scale = d.select(more, d.add(scale, m.number(1, 16), 16),
                     d.select(less, d.sub(scale, m.number(1, 16), 16), scale, 16), 16);
    magnitude = d.select(kept, longer, magnitude, w);
  }
  Bool started_, inFraction_, ended_;
};

/// magnitude / 10^scale as a REAL; steps of 10^10, the largest power of ten that a REAL holds exactly.
template <class D>
typename D::Bits realOfDecimal(Machine<D>& m, typename D::Bits magnitude, typename D::Bits scale) {
  D& d = m.d;
  static constexpr std::array<float, 11> powers = {1e0F, 1e1F, 1e2F, 1e3F, 1e4F, 1e5F, 1e6F, 1e7F, 1e8F, 1e9F, 1e10F};
  const auto zero = m.number(0, 16), ten = m.number(10, 16);
  const auto isLarge = d.slt(scale, zero, 16);
  auto rest = d.select(isLarge, d.sub(zero, scale, 16), scale, 16);
  auto real = d.rfromInt(d.extract(magnitude, 31, 0));
  for (int step = 0; step < 6; ++step) {  // 10^60 leaves the range of REAL from any nine digits
    const auto part = d.select(d.ult(rest, ten, 16), rest, ten, 16);
    auto power = m.number(std::bit_cast<std::uint32_t>(powers[0]), 32);
    for (std::size_t k = 1; k < powers.size(); ++k) {
      power = d.select(d.equal(part, m.number(k, 16), 16), m.number(std::bit_cast<std::uint32_t>(powers[k]), 32), power,
                       32);
    }
    real = d.select(isLarge, d.rmul(real, power), d.rdiv(real, power), 32);
    rest = d.sub(rest, part, 16);
  }
  return real;
}

/// STI, STD, STR (001:3865-3913). No digit where one must stand sets SM1.1 and leaves OUT; a number too large for OUT
/// as well, by Choice::SubstringOverflow.
template <NumberKind kind, Name stlName, Name boxName, Name meaning, std::uint32_t time>
struct SubstringToNumber {
  static constexpr Forms target = kind == NumberKind::Int ? form::wordOut | form::AQ : form::dwordOut;
  static constexpr Desc desc = withOperands({.stl = stlName.view(),
                                             .meaning = meaning.view(),
                                             .group = "table, find, conversion",
                                             .role = Role::StringConvert,
                                             .drawn = boxName.view(),
                                             .stack = {1, 0, 0},
                                             .eno = true,
                                             .affects = status::Overflow,
                                             .time = time,
                                             .manual = "001:3865"},
                                            {in("IN", Type::String, form::byteBuffer | form::Const),
                                             in("INDX", Type::Byte, form::byteIn), out("OUT", typeOf(kind), target)});

  template <class D>
  static void run(Machine<D>& m, Args<D>& a) {
    D& d = m.d;
    const auto length = a.byteAt(0, 0), index = a.value(1);
    const auto total = d.add(d.zext(length, 8, 16), m.number(1, 16), 16);
    const auto outside = d.lor(d.ult(m.number(254, 8), length, 8), d.lnot(a.fits(0, total, Width::Byte)));
    const auto indexIsZero = d.equal(index, m.number(0, 8), 8);
    m.hazard(Hazard::OutOfRange, outside);
    m.hazard(Hazard::StringIndexZero, indexIsZero);
    m.when(d.lnot(d.lor(outside, indexIsZero)), [&] {
      NumberReader<D> reader(m, kind == NumberKind::Real);
      const auto known = d.known(length);
      const int room = a.room(0, Width::Byte, 255) - 1;
      const int limit = std::min(known ? static_cast<int>(*known) : 254, room);
      for (int k = 1; k <= limit; ++k) {
        const auto position = m.number(static_cast<std::uint64_t>(k), 8);
        reader.take(a.byteAt(0, k), d.land(d.ule(index, position, 8), d.ule(position, length, 8)));
      }
      store(m, a, reader);
    });
  }

  template <class D>
  static void store(Machine<D>& m, Args<D>& a, const NumberReader<D>& reader) {
    D& d = m.d;
    typename D::Bits result{};
    auto tooLarge = reader.isTooLarge;
    if constexpr (kind == NumberKind::Real) {
      const auto real = realOfDecimal(m, reader.magnitude, reader.scale);
      tooLarge = d.lnot(d.rlegal(real));
      result = d.bor(real, d.select(reader.isNegative, m.number(1U << 31, 32), m.number(0, 32), 32), 32);
    } else {
      constexpr int n = kind == NumberKind::Int ? 16 : 32;
      constexpr int w = NumberReader<D>::w;
      const auto limit =
          d.select(reader.isNegative, m.number(1ULL << (n - 1), w), m.number((1ULL << (n - 1)) - 1, w), w);
      tooLarge = d.lor(tooLarge, d.ult(limit, reader.magnitude, w));
      const auto magnitude = d.extract(reader.magnitude, n - 1, 0);
      result = d.select(reader.isNegative, d.sub(m.number(0, n), magnitude, n), magnitude, n);
    }
    const auto bad = d.lor(d.lnot(reader.hasDigit), tooLarge);
    m.hazard(Hazard::Overflow, bad);
    m.flag(status::Overflow, bad);
    m.when(d.lnot(bad), [&] { a.store(2, result); });
    const auto isUnknown = m.reads({Choice::SubstringOverflow, "unknown"});
    m.when(d.land(isUnknown, d.land(reader.hasDigit, tooLarge)),
           [&] { a.store(2, m.external(External::UnknownResult, 0, bits(a.width(2)))); });
  }
};

using IntToString = NumberToString<NumberKind::Int, "ITS", "I_S", "integer to string", 13900>;
using DIntToString = NumberToString<NumberKind::DInt, "DTS", "DI_S", "double integer to string", 30500>;
using RealToString = NumberToString<NumberKind::Real, "RTS", "R_S", "real to string", 15400>;
using SubstringToInt = SubstringToNumber<NumberKind::Int, "STI", "S_I", "substring to integer", 5800>;
using SubstringToDInt = SubstringToNumber<NumberKind::DInt, "STD", "S_DI", "substring to double integer", 6900>;
using SubstringToReal = SubstringToNumber<NumberKind::Real, "STR", "S_R", "substring to real", 0>;

using StringGroup = Group<IntToString, DIntToString, RealToString, SubstringToInt, SubstringToDInt, SubstringToReal>;

}  // namespace rungproof::isa
