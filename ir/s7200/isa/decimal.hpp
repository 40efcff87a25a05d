// Writing numbers as decimal characters: the common part of ITA DTA RTA and ITS DTS RTS (001:3601-3693). FMT gives the
// digits right of the point (bits 2-0), the kind of point (bit 3) and, for REAL, the size of the buffer (bits 7-4).
// Rules: no plus sign, minus directly before the first digit, no leading zeros but the one next to the point,
// right-justified, blanks in front.
#pragma once

#include <vector>

#include "ir/s7200/isa/group.hpp"

namespace rungproof::isa {

template <class D>
struct DecimalField {
  std::vector<typename D::Bits> characters;  ///< left to right
  typename D::Bool tooLong;                  ///< the number does not fit
};

/// `magnitude` (width w, unsigned) over 10^fraction in `size` characters; size must exceed fraction + 1.
template <class D>
DecimalField<D> decimalField(Machine<D>& m, typename D::Bits magnitude, int w, typename D::Bool negative, int fraction,
                             typename D::Bool comma, int size) {
  D& d = m.d;
  std::vector<typename D::Bits> characters(static_cast<std::size_t>(size), m.number(' ', 8));
  const auto ten = m.number(10, w), zero = m.number(0, w);
  auto rest = magnitude;
  auto shownBefore = d.constant(true);
  int digit = 0;
  for (int place = 0; place < size; ++place) {  // from the right
    auto& character = characters[static_cast<std::size_t>(size - 1 - place)];
    if (fraction > 0 && place == fraction) {
      character = d.select(comma, m.number(',', 8), m.number('.', 8), 8);
      continue;
    }
    const auto shown = digit <= fraction ? d.constant(true) : d.lnot(d.equal(rest, zero, w));
    const auto minus = d.land(negative, d.land(shownBefore, d.lnot(shown)));
    const auto figure = d.add(d.extract(d.urem(rest, ten, w), 7, 0), m.number('0', 8), 8);
    character = d.select(shown, figure, d.select(minus, m.number('-', 8), m.number(' ', 8), 8), 8);
    rest = d.udiv(rest, ten, w);
    shownBefore = shown;
    ++digit;
  }
  return {std::move(characters), d.lor(d.lnot(d.equal(rest, zero, w)), d.land(negative, shownBefore))};
}

/// |REAL| * 10^fraction rounded to a whole number of 64 bits, halves upward; `tooBig` from 15 digits on and for
/// illegal numbers. Exact: mantissa and exponent are taken apart, no REAL operation rounds in between.
template <class D>
struct ScaledReal {
  typename D::Bits magnitude;
  typename D::Bool tooBig;
};
template <class D>
ScaledReal<D> scaledReal(Machine<D>& m, typename D::Bits real, int fraction) {
  D& d = m.d;
  std::uint64_t power = 1, limit = 1'000'000'000'000'000;
  for (int i = 0; i < fraction; ++i) {
    power *= 10;
    limit /= 10;
  }
  const auto exponent = d.extract(real, 30, 23), digits = d.zext(d.extract(real, 22, 0), 23, 64);
  const auto denormal = d.equal(exponent, m.number(0, 8), 8);
  const auto mantissa = d.select(denormal, digits, d.bor(digits, m.number(1U << 23, 64), 64), 64);
  const auto weight =
      d.select(denormal, m.number(1, 64), d.zext(exponent, 8, 64), 64);  // value = mantissa * 2^(weight - 150)
  const auto point = m.number(150, 64);
  const auto isWhole = d.ule(point, weight, 64);
  const auto up = d.sub(weight, point, 64), down = d.sub(point, weight, 64);
  const auto whole = d.shl(mantissa, up, 64);
  const auto tooBig = d.land(isWhole, d.lor(d.ult(m.number(26, 64), up, 64), d.ule(m.number(limit, 64), whole, 64)));
  const auto half = d.shl(m.number(1, 64), d.sub(down, m.number(1, 64), 64), 64);
  const auto part = d.lshr(d.add(d.mul(mantissa, m.number(power, 64), 64), half, 64), down, 64);
  return {d.select(isWhole, d.mul(whole, m.number(power, 64), 64), part, 64), tooBig};
}

enum class NumberKind { Int, DInt, Real };

/// Writes operand 0 as text into operand `outAt` by the format in operand `formatAt`; `first` is the first byte after a
/// possible length byte. nnn > 5, or a REAL that its buffer cannot hold, gives blanks; other bad formats write nothing.
template <NumberKind kind, class D>
void writeDecimal(Machine<D>& m, Args<D>& a, std::size_t outAt, std::size_t formatAt, int first) {
  D& d = m.d;
  const auto format = a.value(formatAt), value = a.value(0);
  const auto places = d.extract(format, 2, 0), upper = d.extract(format, 7, 4);
  const auto tooManyPlaces = d.ult(m.number(5, 3), places, 3);
  const auto write = [&](const std::vector<typename D::Bits>& characters) {
    if (first == 1) a.storeElement(outAt, 0, Width::Byte, m.number(characters.size(), 8));
    for (std::size_t i = 0; i < characters.size(); ++i)
      a.storeElement(outAt, first + static_cast<int>(i), Width::Byte, characters[i]);
  };
  const auto blanks = [&](int size) {
    write(std::vector<typename D::Bits>(static_cast<std::size_t>(size), m.number(' ', 8)));
  };
  const auto inSize = [&](int size) {
    const auto outside = d.lnot(a.fits(outAt, m.number(static_cast<std::uint64_t>(size + first), 16), Width::Byte));
    m.hazard(Hazard::OutOfRange, outside);
    m.when(d.lnot(outside), [&] {
      m.hazard(Hazard::BadFormat, tooManyPlaces);
      m.when(tooManyPlaces, [&] { blanks(size); });
      for (int fraction = 0; fraction <= 5; ++fraction) {
        m.when(d.equal(places, m.number(static_cast<std::uint64_t>(fraction), 3), 3), [&] {
          if constexpr (kind == NumberKind::Real) {
            const auto scaled = scaledReal(m, value, fraction);
            const auto isNegative = d.land(d.bit(value, 31), d.lnot(d.equal(scaled.magnitude, m.number(0, 64), 64)));
            auto field = decimalField(m, scaled.magnitude, 64, isNegative, fraction, d.bit(format, 3),
                                      std::max(size, fraction + 3));
            const auto tooSmall =
                size < fraction + 3 ? d.constant(true) : d.lor(scaled.tooBig, field.tooLong);  // 001:3689
            m.hazard(Hazard::BadFormat, tooSmall);
            m.when(tooSmall, [&] { blanks(size); });
            m.when(d.lnot(tooSmall), [&] { write(field.characters); });
          } else {
            constexpr int w = kind == NumberKind::Int ? 16 : 32;
            const auto isNegative = d.bit(value, w - 1);
            const auto magnitude = d.select(isNegative, d.sub(m.number(0, w), value, w), value, w);
            write(decimalField(m, magnitude, w, isNegative, fraction, d.bit(format, 3), size).characters);
          }
        });
      }
    });
  };
  if constexpr (kind == NumberKind::Real) {
    m.hazard(Hazard::BadFormat, d.ult(upper, m.number(3, 4), 4));
    for (int size = 3; size <= 15; ++size)
      m.when(d.equal(upper, m.number(static_cast<std::uint64_t>(size), 4), 4), [&] { inSize(size); });
  } else {
    const auto badUpper = d.land(d.lnot(d.equal(upper, m.number(0, 4), 4)), d.lnot(tooManyPlaces));
    m.hazard(Hazard::BadFormat, badUpper);
    m.when(d.lnot(badUpper), [&] { inSize(kind == NumberKind::Int ? 8 : 12); });
  }
}

}  // namespace rungproof::isa
