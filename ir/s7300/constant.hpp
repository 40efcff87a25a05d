// Constants as STEP 7 writes them, and the bytes that a constant gives a place of some type (002:1951-1959,
// 003:885-897). Tested by tests/step7/constant_test.cpp and layout_test.cpp.
#pragma once

#include <cstdint>
#include <string>

#include "ir/source.hpp"

namespace rungproof::s7300 {

enum class ConstantKind : std::uint8_t {
  Integer,      ///< 5, -33
  Long,         ///< L#5
  Hex,          ///< 16#FF, of no width
  Byte,         ///< B#16#FF
  Word,         ///< W#16#FFFF
  DWord,        ///< DW#16#FFFF_FFFF
  Binary,       ///< 2#1010
  Real,         ///< 1.5e+3: bits of an IEEE single
  S5Time,       ///< S5T#2S: base and three digits, as the word holds them (003:1016-1043)
  Time,         ///< T#2S: milliseconds, signed
  Date,         ///< D#1990-1-1: days since that day
  TimeOfDay,    ///< TOD#1:2:3.4: milliseconds since midnight
  DateAndTime,  ///< DT#...: eight bytes of digits, first byte highest (002:1980-1996)
  Count,        ///< C#998: three digits
  TwoBytes,     ///< B#(1,2)
  FourBytes,    ///< B#(1,2,3,4)
  Text,         ///< 'abc': characters in Constant::text
  Boolean,      ///< TRUE, FALSE
  Pointer,      ///< P#1.0, P#M 1.0, P#DB1.DBX1.0: the pointer's double word, the block in Constant::block
  Any,          ///< P#M 1.0 BYTE 4, the type and number of elements besides
  Object        ///< T 5, C 5, DB 5, SDB 5, FB 5, FC 5: the number; Constant::text says of what
};

struct Constant {
  ConstantKind kind = ConstantKind::Integer;
  std::int64_t value = 0;      ///< the number or the bits; DateAndTime: its eight bytes
  std::uint16_t block = 0;     ///< Pointer, Any: number of the data block, 0: none
  std::uint8_t anyType = 0;    ///< Any: code of the element type (002:2257-2263)
  std::uint16_t anyCount = 0;  ///< Any: number of elements
  std::string text;            ///< Text: characters, one byte each; Object: "T", "C", "DB", "SDB", "FB", "FC"
  Span span;

  friend bool operator==(const Constant&, const Constant&) = default;
};

/// Bits that `L` of the constant leaves in ACCU1; a text of up to four characters stands right-justified (002:2219).
std::uint32_t accumulatorBits(const Constant& constant);

}  // namespace rungproof::s7300
