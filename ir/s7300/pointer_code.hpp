// The codes in pointers: areas (002:1698-1707), and the elements that an ANY points to (002:2257-2263; those of timers
// and counters: general knowledge).
#pragma once

#include <cstdint>

namespace rungproof {

/// Codes of areas in pointers; V: local data of the calling block.
enum class PointerArea : std::uint8_t { P, I, Q, M, Db, Di, L, V };

enum class AnyType : std::uint8_t {
  Void = 0x00,
  Bool = 0x01,
  Byte = 0x02,
  Char = 0x03,
  Word = 0x04,
  Int = 0x05,
  DWord = 0x06,
  DInt = 0x07,
  Real = 0x08,
  Date = 0x09,
  TimeOfDay = 0x0A,
  Time = 0x0B,
  S5Time = 0x0C,
  DateAndTime = 0x0E,
  String = 0x13,
  Counter = 0x1C,
  Timer = 0x1D
};

/// Bytes of an element; 0: a bit, or a type whose elements have no size of their own.
constexpr std::uint32_t elementBytes(AnyType type) {
  switch (type) {
    case AnyType::Byte:
    case AnyType::Char: return 1;
    case AnyType::Word:
    case AnyType::Int:
    case AnyType::Date:
    case AnyType::S5Time: return 2;
    case AnyType::DWord:
    case AnyType::DInt:
    case AnyType::Real:
    case AnyType::TimeOfDay:
    case AnyType::Time: return 4;
    case AnyType::DateAndTime: return 8;
    default: return 0;
  }
}

/// Bytes that `count` elements cover from a byte on, 0 where that is not known. A STRING counts its bytes.
constexpr std::uint32_t bytesOfElements(AnyType type, std::uint32_t count) {
  if (type == AnyType::Bool) return (count + 7) / 8;
  return type == AnyType::String ? count : elementBytes(type) * count;
}

}  // namespace rungproof
