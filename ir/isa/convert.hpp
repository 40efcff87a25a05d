// Standard conversions, seven-segment pattern, encode and decode (001:3435-3577, 001:3941-3980; s7200 digest A 11, 14).
// A value that does not fit sets SM1.1 (SM1.6 for BCD) and leaves OUT as it was. Tests:
// tests/manual_a/convert_test.cpp.
#pragma once

#include "ir/isa/group.hpp"

namespace rungproof::isa {

constexpr Desc conversion(std::string_view stl, std::string_view meaning, OperandDesc from, OperandDesc to,
                          std::uint32_t time, std::string_view manual, StatusBits affects = 0) {
  return withOperands({.stl = stl,
                       .meaning = meaning,
                       .group = "table, find, conversion",
                       .stack = {1, 0, 0},
                       .eno = true,
                       .affects = affects,
                       .time = time,
                       .manual = manual},
                      {from, to});
}

/// Stores `result` unless `bad`, which sets the status bit and drops ENO.
template <class D>
void storeUnless(Machine<D>& m, Args<D>& a, std::size_t i, typename D::Bits result, typename D::Bool bad, Hazard hazard,
                 StatusBits bit) {
  m.hazard(hazard, bad);
  m.flag(bit, bad);
  m.when(m.d.lnot(bad), [&] { a.store(i, result); });
}

/// BTI: zero-extends (001:3480).
struct ByteToInt {
  static constexpr Desc desc = conversion("BTI", "byte to integer", in("IN", Type::Byte, form::byteIn),
                                          out("OUT", Type::Int, form::wordOut), 1600, "001:3480");
  template <class D>
  static void run(Machine<D>& m, Args<D>& a) {
    a.store(1, m.d.zext(a.value(0), 8, 16));
  }
};

/// ITB: 0 to 255 only (001:3485).
struct IntToByte {
  static constexpr Desc desc = conversion("ITB", "integer to byte", in("IN", Type::Int, form::wordIn),
                                          out("OUT", Type::Byte, form::byteOut), 1700, "001:3485", status::Overflow);
  template <class D>
  static void run(Machine<D>& m, Args<D>& a) {
    const auto value = a.value(0);
    storeUnless(m, a, 1, m.d.extract(value, 7, 0), m.d.ult(m.number(255, 16), value, 16), Hazard::Overflow,
                status::Overflow);
  }
};

/// ITD: sign-extends (001:3475).
struct IntToDInt {
  static constexpr Desc desc = conversion("ITD", "integer to double integer", in("IN", Type::Int, form::wordIn),
                                          out("OUT", Type::DInt, form::dwordOut), 2000, "001:3475");
  template <class D>
  static void run(Machine<D>& m, Args<D>& a) {
    a.store(1, m.d.sext(a.value(0), 16, 32));
  }
};

/// DTI: -32768 to 32767 only (001:3470).
struct DIntToInt {
  static constexpr Desc desc = conversion("DTI", "double integer to integer", in("IN", Type::DInt, form::dwordIn),
                                          out("OUT", Type::Int, form::wordOut), 2100, "001:3470", status::Overflow);
  template <class D>
  static void run(Machine<D>& m, Args<D>& a) {
    const auto value = a.value(0), low = m.d.extract(value, 15, 0);
    storeUnless(m, a, 1, low, m.d.lnot(m.d.equal(m.d.sext(low, 16, 32), value, 32)), Hazard::Overflow,
                status::Overflow);
  }
};

/// DTR: to the nearest REAL, or toward zero by Choice::RealFromDInt (001:3465).
struct DIntToReal {
  static constexpr Desc desc = conversion("DTR", "double integer to real", in("IN", Type::DInt, form::dwordIn),
                                          out("OUT", Type::Real, form::dwordOut), 3500, "001:3465");
  template <class D>
  static void run(Machine<D>& m, Args<D>& a) {
    D& d = m.d;
    const auto value = a.value(0);
    auto real = d.rfromInt(value);
    if (m.choices.is(Choice::RealFromDInt, "truncated")) {
      // Rounded away from zero: the pattern one lower is the next REAL toward zero, for both signs.
      const auto wide = d.sext(value, 32, 64), back = d.rtoInt(real, false), zero = m.number(0, 64);
      const auto away = d.select(d.slt(wide, zero, 64), d.slt(back, wide, 64), d.slt(wide, back, 64));
      real = d.select(away, d.sub(real, m.number(1, 32), 32), real, 32);
    }
    a.store(1, real);
  }
};

/// ROUND and TRUNC: an illegal REAL or one beyond a double integer sets SM1.1 (001:3496-3499).
template <bool round, Name stlName, Name meaning, std::uint32_t time>
struct RealToDInt {
  static constexpr Desc desc = conversion(stlName.view(), meaning.view(), in("IN", Type::Real, form::realIn),
                                          out("OUT", Type::DInt, form::dwordOut), time, "001:3496", status::Overflow);
  template <class D>
  static void run(Machine<D>& m, Args<D>& a) {
    D& d = m.d;
    const auto real = a.value(0);
    auto wide = d.rtoInt(real, round);
    if (round && m.choices.is(Choice::RoundHalf, "up")) {
      const auto whole = d.rtoInt(real, false);
      const auto fraction = d.rsub(real, d.rfromInt(d.extract(whole, 31, 0)));
      wide = d.select(d.requal(fraction, m.number(0xBF000000, 32)), whole, wide, 64);  // -0.5
    }
    const auto result = d.extract(wide, 31, 0);
    const auto bad = d.lor(d.lnot(d.rlegal(real)), d.lnot(d.equal(d.sext(result, 32, 64), wide, 64)));
    storeUnless(m, a, 1, result, bad, Hazard::Overflow, status::Overflow);
  }
};

constexpr Desc bcdDesc(std::string_view stl, std::string_view meaning, std::uint32_t time) {
  return withOperands({.stl = stl,
                       .meaning = meaning,
                       .group = "table, find, conversion",
                       .stack = {1, 0, 0},
                       .eno = true,
                       .affects = status::NotBcd,
                       .time = time,
                       .manual = "001:3460"},
                      {inout("OUT", Type::Word, form::wordOut)});
}

/// In-place BCD conversion: the result, or SM1.6 and what Choice::BcdErrorResult says.
template <class D>
void storeBcd(Machine<D>& m, Args<D>& a, typename D::Bits result, typename D::Bool bad) {
  storeUnless(m, a, 0, result, bad, Hazard::NotBcd, status::NotBcd);
  if (m.choices.is(Choice::BcdErrorResult, "unknown"))
    m.when(bad, [&] { a.store(0, m.external(External::UnknownResult, 0, 16)); });
}

/// BCDI: four BCD digits to a number; a digit above 9 sets SM1.6.
struct BcdToInt {
  static constexpr Desc desc = bcdDesc("BCDI", "BCD to integer", 3500);
  template <class D>
  static void run(Machine<D>& m, Args<D>& a) {
    D& d = m.d;
    const auto value = a.value(0);
    auto result = m.number(0, 16);
    auto bad = d.constant(false);
    for (int digit = 3; digit >= 0; --digit) {
      const auto nibble = d.extract(value, 4 * digit + 3, 4 * digit);
      bad = d.lor(bad, d.ult(m.number(9, 4), nibble, 4));
      result = d.add(d.mul(result, m.number(10, 16), 16), d.zext(nibble, 4, 16), 16);
    }
    storeBcd(m, a, result, bad);
  }
};

/// IBCD: 0 to 9999 to four BCD digits, anything else sets SM1.6.
struct IntToBcd {
  static constexpr Desc desc = bcdDesc("IBCD", "integer to BCD", 5200);
  template <class D>
  static void run(Machine<D>& m, Args<D>& a) {
    D& d = m.d;
    const auto value = a.value(0), ten = m.number(10, 16);
    auto rest = value, result = m.number(0, 16);
    for (std::uint64_t digit = 0; digit < 4; ++digit) {
      result = d.bor(result, d.shl(d.urem(rest, ten, 16), m.number(4 * digit, 16), 16), 16);
      rest = d.udiv(rest, ten, 16);
    }
    storeBcd(m, a, result, d.ult(m.number(9999, 16), value, 16));
  }
};

/// Segments 0gfedcba of the digits 0 to F; 9 is drawn without the lowest segment (000:2560-2605).
inline constexpr std::array<std::uint8_t, 16> segments = {0x3F, 0x06, 0x5B, 0x4F, 0x66, 0x6D, 0x7D, 0x07,
                                                          0x7F, 0x67, 0x77, 0x7C, 0x39, 0x5E, 0x79, 0x71};

/// SEG: the low nibble as a seven-segment pattern (001:3545).
struct SevenSegment {
  static constexpr Desc desc = conversion("SEG", "seven-segment pattern", in("IN", Type::Byte, form::byteIn),
                                          out("OUT", Type::Byte, form::byteOut), 1500, "001:3545");
  template <class D>
  static void run(Machine<D>& m, Args<D>& a) {
    D& d = m.d;
    const auto digit = d.extract(a.value(0), 3, 0);
    auto pattern = m.number(segments[0], 8);
    for (std::size_t k = 1; k < segments.size(); ++k)
      pattern = d.select(d.equal(digit, m.number(k, 4), 4), m.number(segments[k], 8), pattern, 8);
    a.store(1, pattern);
  }
};

/// ENCO: number of the lowest 1 bit into the low nibble of OUT (001:3947).
struct Encode {
  static constexpr Desc desc = conversion("ENCO", "encode", in("IN", Type::Word, form::wordIn),
                                          out("OUT", Type::Byte, form::byteOut), 2400, "001:3947");
  template <class D>
  static void run(Machine<D>& m, Args<D>& a) {
    D& d = m.d;
    const auto value = a.value(0);
    auto number = m.number(0, 4);
    for (int bit = 15; bit >= 0; --bit)
      number = d.select(d.bit(value, bit), m.number(static_cast<std::uint64_t>(bit), 4), number, 4);
    const bool keepsHigh = m.choices.is(Choice::EncodeHighNibble, "kept");
    const auto high = keepsHigh ? d.extract(a.value(1), 7, 4) : m.number(0, 4);
    const bool keepsForZero = m.choices.is(Choice::EncodeZero, "unchanged");
    const auto writes = keepsForZero ? d.lnot(d.equal(value, m.number(0, 16), 16)) : d.constant(true);
    m.when(writes, [&] { a.store(1, d.concat(high, 4, number, 4)); });
  }
};

/// DECO: the bit of OUT that the low nibble of IN names, all others 0 (001:3952).
struct Decode {
  static constexpr Desc desc = conversion("DECO", "decode", in("IN", Type::Byte, form::byteIn),
                                          out("OUT", Type::Word, form::wordOut | form::AQ), 1900, "001:3952");
  template <class D>
  static void run(Machine<D>& m, Args<D>& a) {
    a.store(1, m.d.shl(m.number(1, 16), m.d.zext(m.d.extract(a.value(0), 3, 0), 4, 16), 16));
  }
};

using Round = RealToDInt<true, "ROUND", "real to double integer, rounding", 5600>;
using Truncate = RealToDInt<false, "TRUNC", "real to double integer, truncating", 5300>;

using ConvertGroup = Group<BcdToInt, IntToBcd, ByteToInt, IntToByte, IntToDInt, DIntToInt, DIntToReal, Round, Truncate,
                           SevenSegment, Encode, Decode>;

}  // namespace rungproof::isa
