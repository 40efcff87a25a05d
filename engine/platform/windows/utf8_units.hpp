// UTF-8 and the units of UTF-16, one unit at a time, as the C functions mbrtowc() and wcrtomb() do it. It names nothing
// of a system: tests/platform tries it everywhere.
#pragma once

#include <cstddef>

namespace rungproof::utf8 {

constexpr std::size_t invalid = static_cast<std::size_t>(-1), unfinished = static_cast<std::size_t>(-2);
constexpr std::size_t longestCharacter = 4;
constexpr unsigned highFirst = 0xD800, lowFirst = 0xDC00, lowLast = 0xDFFF;

/// Reads one unit and says how many bytes it took: 0 for the character 0, `unfinished`, `invalid`. A character beyond
/// the first plane is two units: the first call takes three of its bytes and keeps the second unit in `pending`, the
/// next call takes the fourth byte.
inline std::size_t takeUnit(const char* from, std::size_t count, unsigned& unit, unsigned& pending) {
  if (count == 0) return unfinished;
  if (pending != 0) {
    unit = pending;
    pending = 0;
    return 1;
  }
  const auto byte = [&](std::size_t i) { return static_cast<unsigned>(static_cast<unsigned char>(from[i])); };
  const unsigned first = byte(0);
  if (first < 0x80) {
    unit = first;
    return first == 0 ? 0 : 1;
  }
  if (first < 0xC2 || first > 0xF4) return invalid;
  const std::size_t length = first >= 0xF0 ? 4 : first >= 0xE0 ? 3 : 2;
  unsigned code = first & (0xFFU >> (length + 1));
  for (std::size_t i = 1; i < length; ++i) {
    if (i >= count) return unfinished;
    if ((byte(i) & 0xC0U) != 0x80) return invalid;
    code = code << 6 | (byte(i) & 0x3FU);
  }
  const bool isTooShort = code < (length == 4 ? 0x10000U : length == 3 ? 0x800U : 0x80U);
  if (isTooShort || code > 0x10FFFF || (code >= highFirst && code <= lowLast)) return invalid;
  if (length < 4) {
    unit = code;
    return length;
  }
  code -= 0x10000;
  unit = highFirst + (code >> 10);
  pending = lowFirst + (code & 0x3FFU);
  return 3;
}

/// Writes the bytes of one unit, at most `longestCharacter`, and says how many: none for the first unit of two, which
/// is kept in `pending`; `invalid` for a unit that has no fellow.
inline std::size_t putUnit(unsigned unit, char* to, unsigned& pending) {
  const bool isHigh = unit >= highFirst && unit < lowFirst, isLow = unit >= lowFirst && unit <= lowLast;
  if (isLow != (pending != 0)) return invalid;
  if (isHigh) {
    pending = unit;
    return 0;
  }
  unsigned code = unit;
  if (isLow) {
    code = 0x10000 + ((pending - highFirst) << 10) + (unit - lowFirst);
    pending = 0;
  }
  const std::size_t length = code < 0x80 ? 1 : code < 0x800 ? 2 : code < 0x10000 ? 3 : 4;
  constexpr unsigned marks[] = {0, 0, 0xC0, 0xE0, 0xF0};
  for (std::size_t i = length; i-- > 1;) {
    to[i] = static_cast<char>(0x80U | (code & 0x3FU));
    code >>= 6;
  }
  to[0] = static_cast<char>(marks[length] | code);
  return length;
}

}  // namespace rungproof::utf8
