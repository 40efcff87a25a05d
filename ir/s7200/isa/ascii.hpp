// ASCII arrays: ATH, HTA, ITA, DTA, RTA (001:3579-3760). Source and destination of ATH and HTA may
// overlap; the source is read completely before anything is written (the manual is silent). Tests:
// tests/manual/ascii_test.cpp.
#pragma once

#include <algorithm>

#include "ir/s7200/isa/decimal.hpp"

namespace rungproof::isa {

constexpr Desc hexDesc(Role role, std::string_view stl, std::string_view meaning, std::uint32_t time,
                       StatusBits affects) {
  return withOperands(
      {.stl = stl,
       .meaning = meaning,
       .group = "table, find, conversion",
       .role = role,
       .stack = {1, 0, 0},
       .eno = true,
       .affects = affects,
       .time = time,
       .manual = "001:3583"},
      {in("IN", Type::Byte, form::byteBuffer).elements(1, 0).counted(2, 255, role == Role::HexToAscii ? 2 : 1),
       out("OUT", Type::Byte, form::byteBuffer).elements(1, 0).counted(2, 255, role == Role::AsciiToHex ? 2 : 1),
       in("LEN", Type::Byte, form::byteIn)});
}

/// LEN hexadecimal digits: one byte each as characters, two in a byte as digits.
inline constexpr int maximumDigits = 255;

/// Error 0091 unless `characters` bytes at operand `wide` and half as many at operand `packed` are inside their areas.
template <class D>
typename D::Bool digitsFit(Machine<D>& m, Args<D>& a, std::size_t wide, std::size_t packed, typename D::Bits length) {
  D& d = m.d;
  const auto characters = d.zext(length, 8, 16);
  const auto half = d.lshr(d.add(characters, m.number(1, 16), 16), m.number(1, 16), 16);
  const auto fits = d.land(a.fits(wide, characters, Width::Byte), a.fits(packed, half, Width::Byte));
  m.hazard(Hazard::OutOfRange, d.lnot(fits));
  return fits;
}

/// Number of digits to follow: LEN where it is known, else what the buffers can hold.
template <class D>
int digitLimit(Machine<D>& m, Args<D>& a, std::size_t wide, std::size_t packed, typename D::Bits length) {
  const auto known = m.d.known(length);
  return std::min({known ? static_cast<int>(*known) : maximumDigits, a.room(wide, Width::Byte, maximumDigits),
                   2 * a.room(packed, Width::Byte, maximumDigits)});
}

/// ATH: characters 0-9 and A-F to digits, high nibble first; the low nibble left over by an odd LEN keeps its value
/// (001:3709-3714). What stands before an illegal character is written or not by Choice::AthError.
struct AsciiToHex {
  static constexpr Desc desc = hexDesc(Role::AsciiToHex, "ATH", "ASCII to hexadecimal", 2300, status::NotAscii);
  template <class D>
  static void run(Machine<D>& m, Args<D>& a) {
    D& d = m.d;
    const auto length = a.value(2);
    m.when(digitsFit(m, a, 0, 1, length), [&] {
      std::vector<typename D::Bits> digits;
      std::vector<typename D::Bool> legal;  // digit k and all before it
      auto bad = d.constant(false);
      const int limit = digitLimit(m, a, 0, 1, length);
      for (int k = 0; k < limit; ++k) {
        const auto c = a.element(0, k, Width::Byte);
        const auto isDigit = d.land(d.ule(m.number('0', 8), c, 8), d.ule(c, m.number('9', 8), 8));
        const auto isLetter = d.land(d.ule(m.number('A', 8), c, 8), d.ule(c, m.number('F', 8), 8));
        const auto used = d.ult(m.number(static_cast<std::uint64_t>(k), 8), length, 8);
        bad = d.lor(bad, d.land(used, d.lnot(d.lor(isDigit, isLetter))));
        legal.push_back(d.lnot(bad));
        digits.push_back(d.extract(d.sub(c, d.select(isDigit, m.number('0', 8), m.number('A' - 10, 8), 8), 8), 3, 0));
      }
      m.hazard(Hazard::NotAscii, bad);
      m.flag(status::NotAscii, bad);
      const auto allOrNothing = m.reads({Choice::AthError, "nothing"});
      m.repeat(length, 8, limit, [&](int k) {
        const auto at = static_cast<std::size_t>(k);
        m.when(d.select(allOrNothing, d.lnot(bad), legal[at]), [&] {
          const auto old = a.element(1, k / 2, Width::Byte);
          a.storeElement(1, k / 2, Width::Byte,
                         k % 2 == 0 ? d.concat(digits[at], 4, d.extract(old, 3, 0), 4)
                                    : d.concat(d.extract(old, 7, 4), 4, digits[at], 4));
        });
      });
    });
  }
};

/// HTA: digits to characters, high nibble first (001:3583-3589).
struct HexToAscii {
  static constexpr Desc desc = hexDesc(Role::HexToAscii, "HTA", "hexadecimal to ASCII", 2000, 0);
  template <class D>
  static void run(Machine<D>& m, Args<D>& a) {
    D& d = m.d;
    const auto length = a.value(2);
    m.when(digitsFit(m, a, 1, 0, length), [&] {
      std::vector<typename D::Bits> characters;
      const int limit = digitLimit(m, a, 1, 0, length);
      for (int k = 0; k < limit; ++k) {
        const auto pair = a.element(0, k / 2, Width::Byte);
        const auto digit = d.zext(k % 2 == 0 ? d.extract(pair, 7, 4) : d.extract(pair, 3, 0), 4, 8);
        const auto base = d.select(d.ult(digit, m.number(10, 8), 8), m.number('0', 8), m.number('A' - 10, 8), 8);
        characters.push_back(d.add(digit, base, 8));
      }
      m.repeat(length, 8, limit,
               [&](int k) { a.storeElement(1, k, Width::Byte, characters[static_cast<std::size_t>(k)]); });
    });
  }
};

constexpr Type typeOf(NumberKind kind) {
  return kind == NumberKind::Int ? Type::Int : kind == NumberKind::DInt ? Type::DInt : Type::Real;
}

/// ITA, DTA, RTA (001:3601-3693).
template <NumberKind kind, Name stlName, Name meaning, std::uint32_t time>
struct NumberToAscii {
  static constexpr Forms source = kind == NumberKind::Int    ? form::wordIn
                                  : kind == NumberKind::DInt ? form::dwordIn
                                                             : form::realIn;
  static constexpr OperandDesc buffer = out("OUT", Type::Byte, form::byteBuffer)
                                            .elements(kind == NumberKind::Int    ? 8
                                                      : kind == NumberKind::DInt ? 12
                                                                                 : 3,
                                                      kind == NumberKind::Int    ? 8
                                                      : kind == NumberKind::DInt ? 12
                                                                                 : 15);
  static constexpr Desc desc =
      withOperands({.stl = stlName.view(),
                    .meaning = meaning.view(),
                    .group = "table, find, conversion",
                    .stack = {1, 0, 0},
                    .eno = true,
                    .time = time,
                    .manual = kind == NumberKind::Int    ? "001:3601"
                              : kind == NumberKind::DInt ? "001:3655"
                                                         : "001:3674"},
                   {in("IN", typeOf(kind), source), buffer, in("FMT", Type::Byte, form::byteIn)});
  template <class D>
  static void run(Machine<D>& m, Args<D>& a) {
    writeDecimal<kind>(m, a, 1, 2, 0);
  }
};

using IntToAscii = NumberToAscii<NumberKind::Int, "ITA", "integer to ASCII", 13600>;
using DIntToAscii = NumberToAscii<NumberKind::DInt, "DTA", "double integer to ASCII", 30200>;
using RealToAscii = NumberToAscii<NumberKind::Real, "RTA", "real to ASCII", 14900>;

using AsciiGroup = Group<AsciiToHex, HexToAscii, IntToAscii, DIntToAscii, RealToAscii>;

}  // namespace rungproof::isa
