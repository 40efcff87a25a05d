// Walking through structures.
#include "frontend/mc7/structure_places.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace rungproof::mc7 {

namespace {

/// Bytes from one element of an array to the next.
std::uint64_t strideOf(const s7300::Type& element) {
  const std::uint64_t size = std::max<std::uint64_t>(1, s7300::sizeOf(element));
  return size > 1 && size % 2 != 0 && s7300::startsEven(element) ? size + 1 : size;
}

std::optional<std::string> pathInType(const s7300::Type& type, Size size, std::uint32_t byte, unsigned bit) {
  if (type.kind == s7300::TypeKind::Struct) {
    if (type.structure == nullptr) return std::nullopt;
    const auto inner = pathAt(*type.structure, size, byte, bit);
    return inner ? std::optional("." + *inner) : std::nullopt;
  }
  if (type.kind != s7300::TypeKind::Array || type.element == nullptr || type.bounds.size() != 1)
    return byte == 0 && bit == 0 && !s7300::isComplex(type) && !isHandedByPointer(type) && sizeOfType(type) == size &&
                   numberKind(type.kind).empty()
               ? std::optional(std::string())
               : std::nullopt;
  const bool ofBits = type.element->kind == s7300::TypeKind::Bool;
  const std::uint64_t stride = strideOf(*type.element);
  const std::uint64_t index = ofBits ? byte * 8ULL + bit : byte / stride;
  if (index >= type.bounds[0].count()) return std::nullopt;
  const auto inner = ofBits ? pathInType(*type.element, size, 0, 0)
                            : pathInType(*type.element, size, static_cast<std::uint32_t>(byte % stride), bit);
  if (!inner) return std::nullopt;
  return fmt::format("[{}]{}", type.bounds[0].first + static_cast<std::int64_t>(index), *inner);
}

std::optional<std::string> partInType(const s7300::Type& type, std::uint32_t byte,
                                      const std::function<bool(const s7300::Type&)>& isWanted) {
  if (byte == 0 && isWanted(type)) return std::string();
  if (type.kind == s7300::TypeKind::Struct && type.structure != nullptr) {
    const auto inner = partAt(*type.structure, byte, isWanted);
    return inner ? std::optional("." + *inner) : std::nullopt;
  }
  if (type.kind != s7300::TypeKind::Array || type.element == nullptr || type.bounds.size() != 1 ||
      type.element->kind == s7300::TypeKind::Bool)
    return std::nullopt;
  const std::uint64_t stride = strideOf(*type.element), index = byte / stride;
  if (index >= type.bounds[0].count()) return std::nullopt;
  const auto inner = partInType(*type.element, static_cast<std::uint32_t>(byte % stride), isWanted);
  if (!inner) return std::nullopt;
  return fmt::format("[{}]{}", type.bounds[0].first + static_cast<std::int64_t>(index), *inner);
}

}  // namespace

Size sizeOfType(const s7300::Type& type) {
  const std::uint64_t bytes = s7300::sizeOf(type);
  if (type.kind == s7300::TypeKind::Bool) return Size::Bit;
  return bytes == 1 ? Size::Byte : bytes == 2 ? Size::Word : Size::DWord;
}

bool isHandedByPointer(const s7300::Type& type) {
  return s7300::isComplex(type) || type.kind == s7300::TypeKind::Pointer || type.kind == s7300::TypeKind::Any;
}

std::string_view numberKind(s7300::TypeKind kind) {
  switch (kind) {
    case s7300::TypeKind::Timer: return "T";
    case s7300::TypeKind::Counter: return "C";
    case s7300::TypeKind::BlockDb: return "DB";
    case s7300::TypeKind::BlockFc: return "FC";
    case s7300::TypeKind::BlockFb: return "FB";
    case s7300::TypeKind::BlockSdb: return "SDB";
    default: return "";
  }
}

std::optional<std::string> pathAt(const s7300::Structure& structure, Size size, std::uint32_t byte, unsigned bit) {
  for (const s7300::Field& field : structure.fields) {
    if (field.byReference || field.byte > byte) continue;
    const std::uint64_t length = std::max<std::uint64_t>(1, s7300::sizeOf(field.type));
    if (byte >= field.byte + length) continue;
    const std::uint32_t inside = byte - field.byte;
    if (field.type.kind == s7300::TypeKind::Bool) {
      if (size == Size::Bit && inside == 0 && field.bit == bit) return field.name;
      continue;
    }
    const auto rest = pathInType(field.type, size, inside, bit);
    if (rest) return field.name + *rest;
  }
  return std::nullopt;
}

const s7300::Field* fieldAt(const s7300::Structure& structure, std::uint32_t byte, unsigned bit) {
  for (const s7300::Field& field : structure.fields) {
    if (field.byte == byte && field.bit == bit) return &field;
  }
  return nullptr;
}

std::optional<std::string> partAt(const s7300::Structure& structure, std::uint32_t byte,
                                  const std::function<bool(const s7300::Type&)>& isWanted) {
  for (const s7300::Field& field : structure.fields) {
    const std::uint64_t length = std::max<std::uint64_t>(1, s7300::sizeOf(field.type));
    if (field.byReference || field.bit != 0 || byte < field.byte || byte >= field.byte + length) continue;
    if (const auto rest = partInType(field.type, byte - field.byte, isWanted)) return field.name + *rest;
  }
  return std::nullopt;
}

}  // namespace rungproof::mc7
