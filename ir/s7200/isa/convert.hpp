// Standard conversions, seven-segment pattern, encode and decode (001:3435-3577, 001:3941-3980).
// A value that does not fit sets SM1.1 (SM1.6 for BCD) and leaves OUT as it was. Tests:
// tests/manual/convert_test.cpp.
#pragma once

#include "ir/s7200/isa/group.hpp"

namespace rungproof::isa {

constexpr Desc conversion(std::string_view stl, std::string_view box, std::string_view meaning, OperandDesc from,
                          OperandDesc to, std::uint32_t time, std::string_view manual, StatusBits affects = 0) {
  return withOperands({.stl = stl,
                       .meaning = meaning,
                       .group = "table, find, conversion",
                       .drawn = box,
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
  static constexpr Desc desc = conversion("BTI", "B_I", "byte to integer", in("IN", Type::Byte, form::byteIn),
                                          out("OUT", Type::Int, form::wordOut), 1600, "001:3480");
  template <class D>
  static void run(Machine<D>& m, Args<D>& a) {
    a.store(1, m.d.zext(a.value(0), 8, 16));
  }
};

/// ITB: 0 to 255 only (001:3485).
struct IntToByte {
  static constexpr Desc desc = conversion("ITB", "I_B", "integer to byte", in("IN", Type::Int, form::wordIn),
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
  static constexpr Desc desc = conversion("ITD", "I_DI", "integer to double integer", in("IN", Type::Int, form::wordIn),
                                          out("OUT", Type::DInt, form::dwordOut), 2000, "001:3475");
  template <class D>
  static void run(Machine<D>& m, Args<D>& a) {
    a.store(1, m.d.sext(a.value(0), 16, 32));
  }
};

/// DTI: -32768 to 32767 only (001:3470).
struct DIntToInt {
  static constexpr Desc desc =
      conversion("DTI", "DI_I", "double integer to integer", in("IN", Type::DInt, form::dwordIn),
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
  static constexpr Desc desc = conversion("DTR", "DI_R", "double integer to real", in("IN", Type::DInt, form::dwordIn),
                                          out("OUT", Type::Real, form::dwordOut), 3500, "001:3465");
  template <class D>
  static void run(Machine<D>& m, Args<D>& a) {
    D& d = m.d;
    const auto value = a.value(0);
    const auto truncated = m.reads({Choice::RealFromDInt, "truncated"});
    a.store(1, d.rfromInt(d.select(truncated, leading(m, value), value, 32)));
  }

 private:
  /// The 24 leading binary digits, the others 0: what a REAL can hold.
  template <class D>
  static typename D::Bits leading(Machine<D>& m, typename D::Bits value) {
    D& d = m.d;
    const auto isNegative = d.bit(value, 31);
    const auto negated = [&](typename D::Bits v) { return d.select(isNegative, d.sub(m.number(0, 32), v, 32), v, 32); };
    const auto size = negated(value);
    auto kept = size;
    for (int high = 24; high < 32; ++high) {
      const auto mask = m.number(0xFFFFFFFFU << (high - 23), 32);
      kept = d.select(d.bit(size, high), d.band(size, mask, 32), kept, 32);
    }
    return negated(kept);
  }
};

/// ROUND and TRUNC: an illegal REAL or one beyond a double integer sets SM1.1 (001:3496-3499).
template <bool round, Name stlName, Name meaning, std::uint32_t time>
struct RealToDInt {
  static constexpr Desc desc = conversion(stlName.view(), {}, meaning.view(), in("IN", Type::Real, form::realIn),
                                          out("OUT", Type::DInt, form::dwordOut), time, "001:3496", status::Overflow);
  template <class D>
  static void run(Machine<D>& m, Args<D>& a) {
    D& d = m.d;
    const auto real = a.value(0);
    auto wide = d.rtoInt(real, round);
    if constexpr (round) {
      const auto goesUp = d.land(m.reads({Choice::RoundHalf, "up"}), isNegativeHalf(m, real));
      wide = d.select(goesUp, d.add(wide, m.number(1, 64), 64), wide, 64);
    }
    const auto result = d.extract(wide, 31, 0);
    const auto bad = d.lor(d.lnot(d.rlegal(real)), d.lnot(d.equal(d.sext(result, 32, 64), wide, 64)));
    storeUnless(m, a, 1, result, bad, Hazard::Overflow, status::Overflow);
  }

 private:
  /// Whether a REAL is negative with the fraction one half: the digit after the point is its last 1. Exponents 126 (the
  /// leading 1 is that digit) to 149 leave room for it.
  template <class D>
  static typename D::Bool isNegativeHalf(Machine<D>& m, typename D::Bits real) {
    D& d = m.d;
    const auto exponent = d.extract(real, 30, 23), low = m.number(126, 8);
    const auto inside = d.land(d.ule(low, exponent, 8), d.ule(exponent, m.number(149, 8), 8));
    const auto digits = d.concat(m.number(1, 1), 1, d.extract(real, 22, 0), 23);
    const auto fraction = d.shl(digits, d.zext(d.sub(exponent, low, 8), 8, 24), 24);
    return d.land(d.bit(real, 31), d.land(inside, d.equal(fraction, m.number(0x800000, 24), 24)));
  }
};

constexpr Desc bcdDesc(std::string_view stl, std::string_view box, std::string_view meaning, std::uint32_t time) {
  return withOperands({.stl = stl,
                       .meaning = meaning,
                       .group = "table, find, conversion",
                       .drawn = box,
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
  m.when(m.d.land(bad, m.reads({Choice::BcdErrorResult, "unknown"})),
         [&] { a.store(0, m.external(External::UnknownResult, 0, 16)); });
}

/// BCDI: four BCD digits to a number; a digit above 9 sets SM1.6.
struct BcdToInt {
  static constexpr Desc desc = bcdDesc("BCDI", "BCD_I", "BCD to integer", 3500);
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
  static constexpr Desc desc = bcdDesc("IBCD", "I_BCD", "integer to BCD", 5200);
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
  static constexpr Desc desc = conversion("SEG", {}, "seven-segment pattern", in("IN", Type::Byte, form::byteIn),
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
  static constexpr Desc desc = conversion("ENCO", {}, "encode", in("IN", Type::Word, form::wordIn),
                                          out("OUT", Type::Byte, form::byteOut), 2400, "001:3947");
  template <class D>
  static void run(Machine<D>& m, Args<D>& a) {
    D& d = m.d;
    const auto value = a.value(0);
    auto number = m.number(0, 4);
    for (int bit = 15; bit >= 0; --bit)
      number = d.select(d.bit(value, bit), m.number(static_cast<std::uint64_t>(bit), 4), number, 4);
    const auto keepsHigh = m.reads({Choice::EncodeHighNibble, "kept"});
    const auto high = d.select(keepsHigh, d.extract(a.value(1), 7, 4), m.number(0, 4), 4);
    const auto writesZero = m.reads({Choice::EncodeZero, "zero"});
    const auto writes = d.lor(writesZero, d.lnot(d.equal(value, m.number(0, 16), 16)));
    m.when(writes, [&] { a.store(1, d.concat(high, 4, number, 4)); });
  }
};

/// DECO: the bit of OUT that the low nibble of IN names, all others 0 (001:3952).
struct Decode {
  static constexpr Desc desc = conversion("DECO", {}, "decode", in("IN", Type::Byte, form::byteIn),
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
