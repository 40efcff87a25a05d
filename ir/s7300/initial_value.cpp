// From constants to the bytes of a structure: what the places of a data block hold when it is loaded.
#include <algorithm>
#include <array>
#include <bit>
#include <string_view>

#include "ir/s7300/declaration.hpp"

namespace rungproof::s7300 {

namespace {

bool isBetween(std::int64_t value, std::int64_t least, std::int64_t most) { return value >= least && value <= most; }

/// Whether the constant is a row of bits of no type: it fits all types of that width.
bool isOfBits(ConstantKind kind) {
  return kind == ConstantKind::Hex || kind == ConstantKind::Binary || kind == ConstantKind::Byte ||
         kind == ConstantKind::Word || kind == ConstantKind::DWord;
}

/// The bits of an elementary value of `width` bytes, or nothing if the constant is none of the type.
std::optional<std::uint64_t> bitsFor(TypeKind type, const Constant& c) {
  const auto plain = static_cast<std::uint64_t>(c.value);
  const auto given = [&](bool fits) { return fits ? std::optional(plain) : std::nullopt; };
  const auto isObject = [&](std::string_view letters) { return c.kind == ConstantKind::Object && c.text == letters; };
  const bool isNumber = c.kind == ConstantKind::Integer || c.kind == ConstantKind::Long;
  switch (type) {
    case TypeKind::Bool:
      return given(c.kind == ConstantKind::Boolean ||
                   ((isNumber || c.kind == ConstantKind::Hex || c.kind == ConstantKind::Binary) && plain <= 1));
    case TypeKind::Byte: return given((isOfBits(c.kind) || isNumber) && plain <= 0xFF);
    case TypeKind::Char:
      if (c.kind == ConstantKind::Text)
        return c.text.size() == 1 ? std::optional<std::uint64_t>(static_cast<unsigned char>(c.text[0])) : std::nullopt;
      return given((c.kind == ConstantKind::Hex || c.kind == ConstantKind::Byte) && plain <= 0xFF);
    case TypeKind::Word:
      return given((isOfBits(c.kind) || isNumber || c.kind == ConstantKind::Count || c.kind == ConstantKind::TwoBytes ||
                    c.kind == ConstantKind::S5Time) &&
                   plain <= 0xFFFF);
    case TypeKind::Int:
      if (isOfBits(c.kind)) return given(plain <= 0xFFFF);
      return given(isNumber && isBetween(c.value, -32768, 32767));
    case TypeKind::S5Time: return given(c.kind == ConstantKind::S5Time || (isOfBits(c.kind) && plain <= 0x3999));
    case TypeKind::Date: return given(c.kind == ConstantKind::Date || (isOfBits(c.kind) && plain <= 0xFFFF));
    case TypeKind::DWord:
      return given((isOfBits(c.kind) || isNumber || c.kind == ConstantKind::FourBytes ||
                    c.kind == ConstantKind::TwoBytes || c.kind == ConstantKind::Pointer) &&
                   (plain <= 0xFFFFFFFF));
    case TypeKind::DInt:
      if (isOfBits(c.kind)) return given(plain <= 0xFFFFFFFF);
      return given(isNumber && isBetween(c.value, INT32_MIN, INT32_MAX));
    case TypeKind::Real:
      if (isNumber) return std::bit_cast<std::uint32_t>(static_cast<float>(c.value));
      return given(c.kind == ConstantKind::Real || c.kind == ConstantKind::DWord);
    case TypeKind::Time: return given(c.kind == ConstantKind::Time || (isOfBits(c.kind) && plain <= 0xFFFFFFFF));
    case TypeKind::TimeOfDay:
      return given(c.kind == ConstantKind::TimeOfDay || (isOfBits(c.kind) && plain <= 0xFFFFFFFF));
    case TypeKind::DateAndTime: return given(c.kind == ConstantKind::DateAndTime);
    case TypeKind::Timer: return given((isNumber || isObject("T")) && plain <= 0xFFFF);
    case TypeKind::Counter: return given((isNumber || isObject("C")) && plain <= 0xFFFF);
    case TypeKind::BlockDb: return given((isNumber || isObject("DB")) && plain <= 0xFFFF);
    case TypeKind::BlockSdb: return given((isNumber || isObject("SDB")) && plain <= 0xFFFF);
    case TypeKind::BlockFc: return given((isNumber || isObject("FC")) && plain <= 0xFFFF);
    case TypeKind::BlockFb: return given((isNumber || isObject("FB")) && plain <= 0xFFFF);
    default: return std::nullopt;
  }
}

void putBytes(std::vector<std::uint8_t>& bytes, std::uint64_t at, std::uint64_t bits, std::uint64_t width) {
  if (at + width > bytes.size()) return;
  for (std::uint64_t i = 0; i < width; ++i)
    bytes[at + i] = static_cast<std::uint8_t>(bits >> (8 * (width - 1 - i)) & 0xFFU);
}

/// One value that is no array and no structure.
bool writeOne(const Type& type, const Constant& value, std::uint64_t byte, std::uint8_t bit,
              std::vector<std::uint8_t>& bytes) {
  if (type.kind == TypeKind::String) {
    if (value.kind != ConstantKind::Text || value.text.size() > type.length) return false;
    putBytes(bytes, byte, std::uint64_t{type.length} << 8 | value.text.size(), 2);
    for (std::size_t i = 0; i < value.text.size(); ++i)
      putBytes(bytes, byte + 2 + i, static_cast<unsigned char>(value.text[i]), 1);
    return true;
  }
  if (type.kind == TypeKind::Pointer || type.kind == TypeKind::Any) {
    const bool isAny = type.kind == TypeKind::Any;
    if (value.kind != ConstantKind::Pointer && !(isAny && value.kind == ConstantKind::Any)) return false;
    if (isAny)
      putBytes(bytes, byte, std::uint64_t{0x10} << 24 | std::uint64_t{value.anyType} << 16 | value.anyCount, 4);
    const std::uint64_t at = byte + (isAny ? 4 : 0);
    putBytes(bytes, at, value.block, 2);
    putBytes(bytes, at + 2, static_cast<std::uint64_t>(value.value), 4);
    return true;
  }
  const std::optional<std::uint64_t> bits = bitsFor(type.kind, value);
  if (!bits) return false;
  if (type.kind != TypeKind::Bool) {
    putBytes(bytes, byte, *bits, sizeOf(type));
  } else if (byte < bytes.size()) {
    const auto mask = static_cast<std::uint8_t>(1U << bit);
    bytes[byte] = static_cast<std::uint8_t>(*bits != 0 ? bytes[byte] | mask : bytes[byte] & ~mask);
  }
  return true;
}

/// Calls `element(index, byte, bit)` for each element of an array; false ends it.
template <class Visit>
void forEachElement(const Type& array, std::uint64_t byte, Visit element) {
  std::uint64_t rows = 1;
  for (std::size_t i = 0; i + 1 < array.bounds.size(); ++i) rows *= array.bounds[i].count();
  const std::uint64_t columns = array.bounds.back().count();
  const bool isOfBits = array.element->kind == TypeKind::Bool;
  std::uint64_t stride = sizeOf(*array.element);
  if (startsEven(*array.element)) stride += stride & 1U;
  const std::uint64_t row = isOfBits ? (columns + 7) / 8 : columns * stride;
  for (std::uint64_t r = 0; r < rows; ++r) {
    for (std::uint64_t c = 0; c < columns; ++c) {
      const std::uint64_t at = byte + r * row + (isOfBits ? c / 8 : c * stride);
      if (!element(r * columns + c, at, static_cast<std::uint8_t>(isOfBits ? c % 8 : 0))) return;
    }
  }
}

void writeDefaults(const Type& type, std::uint64_t byte, std::vector<std::uint8_t>& bytes);

void writeFields(const Structure& structure, std::uint64_t byte, std::vector<std::uint8_t>& bytes) {
  for (const Field& field : structure.fields) {
    if (field.byReference || !field.viewOf.empty()) continue;
    writeDefaults(field.type, byte + field.byte, bytes);
    if (!field.initial.empty()) writeValues(field.type, field.initial, byte + field.byte, field.bit, bytes);
  }
}

/// Whether zeros are all that a place of this type holds where nothing is said; a structure is not looked into.
bool isZeroAtFirst(const Type& type) {
  switch (type.kind) {
    case TypeKind::Char:
    case TypeKind::String:
    case TypeKind::DateAndTime:
    case TypeKind::Any:
    case TypeKind::Struct: return false;
    case TypeKind::Array: return type.element == nullptr || isZeroAtFirst(*type.element);
    default: return true;
  }
}

/// What a place holds where nothing is said; zeros stand there already.
void writeDefaults(const Type& type, std::uint64_t byte, std::vector<std::uint8_t>& bytes) {
  if (isZeroAtFirst(type)) return;
  switch (type.kind) {
    case TypeKind::Char: putBytes(bytes, byte, ' ', 1); break;
    case TypeKind::String: putBytes(bytes, byte, type.length, 1); break;
    case TypeKind::DateAndTime: putBytes(bytes, byte, 0x9001'0100'0000'0002, 8); break;  // Monday, 1 January 1990
    case TypeKind::Any:
      putBytes(bytes, byte, 0x10, 1);
      putBytes(bytes, byte + 6, 0x80, 1);
      break;
    case TypeKind::Struct:
      if (type.structure != nullptr) writeFields(*type.structure, byte, bytes);
      break;
    case TypeKind::Array:
      if (type.element == nullptr || type.bounds.empty()) break;
      forEachElement(type, byte, [&](std::uint64_t, std::uint64_t at, std::uint8_t) {
        writeDefaults(*type.element, at, bytes);
        return at < bytes.size();
      });
      break;
    default: break;
  }
}

}  // namespace

std::optional<ValueFault> writeValues(const Type& type, std::span<const Constant> values, std::uint64_t byte,
                                      std::uint8_t bit, std::vector<std::uint8_t>& bytes) {
  if (type.kind != TypeKind::Array) {
    if (values.size() > 1) return ValueFault{1, true};
    if (!values.empty() && !writeOne(type, values[0], byte, bit, bytes)) return ValueFault{0, false};
    return std::nullopt;
  }
  if (type.element == nullptr || type.bounds.empty()) return std::nullopt;
  // A text fills an array of characters.
  std::vector<Constant> characters;
  if (type.element->kind == TypeKind::Char) {
    for (const Constant& value : values) {
      if (value.kind != ConstantKind::Text) {
        characters.push_back(value);
        continue;
      }
      for (const char c : value.text) {
        characters.push_back(value);
        characters.back().text = std::string(1, c);
      }
    }
    values = characters;
  }
  std::optional<ValueFault> fault;
  std::size_t written = 0;
  forEachElement(type, byte, [&](std::uint64_t index, std::uint64_t at, std::uint8_t atBit) {
    if (index >= values.size()) return false;
    if (!writeOne(*type.element, values[index], at, atBit, bytes)) {
      fault = ValueFault{index, false};
      return false;
    }
    ++written;
    return true;
  });
  if (!fault && written < values.size()) fault = ValueFault{written, true};
  return fault;
}

std::vector<std::uint8_t> initialBytes(const Structure& structure) {
  constexpr std::uint64_t largestBlock = 65536;
  std::vector<std::uint8_t> bytes(std::min(structure.size, largestBlock));
  writeFields(structure, 0, bytes);
  return bytes;
}

}  // namespace rungproof::s7300
