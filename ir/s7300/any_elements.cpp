// Elements of types.
#include "ir/s7300/any_elements.hpp"

namespace rungproof::s7300 {

namespace {

AnyType elementaryCode(TypeKind kind) {
  switch (kind) {
    case TypeKind::Bool: return AnyType::Bool;
    case TypeKind::Byte: return AnyType::Byte;
    case TypeKind::Char: return AnyType::Char;
    case TypeKind::Word: return AnyType::Word;
    case TypeKind::Int: return AnyType::Int;
    case TypeKind::DWord: return AnyType::DWord;
    case TypeKind::DInt: return AnyType::DInt;
    case TypeKind::Real: return AnyType::Real;
    case TypeKind::Date: return AnyType::Date;
    case TypeKind::TimeOfDay: return AnyType::TimeOfDay;
    case TypeKind::Time: return AnyType::Time;
    case TypeKind::S5Time: return AnyType::S5Time;
    case TypeKind::DateAndTime: return AnyType::DateAndTime;
    case TypeKind::Timer: return AnyType::Timer;
    case TypeKind::Counter: return AnyType::Counter;
    default: return AnyType::Byte;
  }
}

/// Bytes of the elements of an array, without what fills it up to an even number.
std::uint64_t bytesOfArray(const Type& array) {
  const std::uint64_t last = array.bounds.back().count(), size = sizeOf(*array.element);
  std::uint64_t bytes =
      array.element->kind == TypeKind::Bool ? (last + 7) / 8 : last * (size > 1 ? size + size % 2 : size);
  for (std::size_t i = 0; i + 1 < array.bounds.size(); ++i) bytes *= array.bounds[i].count();
  return bytes;
}

}  // namespace

AnyElements anyElementsOf(const Type& type) {
  if (type.kind == TypeKind::Array && type.element != nullptr) {
    const bool isText = type.element->kind == TypeKind::Char;
    return {isText ? AnyType::Char : AnyType::Byte, bytesOfArray(type)};
  }
  if (type.kind == TypeKind::Struct) return {AnyType::Byte, sizeOf(type)};
  if (type.kind == TypeKind::String) return {AnyType::String, sizeOf(type)};
  return {elementaryCode(type.kind), 1};
}

}  // namespace rungproof::s7300
