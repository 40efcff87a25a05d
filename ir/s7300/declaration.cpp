// Types, their sizes, and places of fields.
#include "ir/s7300/declaration.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace rungproof::s7300 {

namespace {

struct TypeRow {
  TypeKind kind;
  std::string_view name;
  std::uint8_t bytes;
};
// The first row of a kind has the name by which it is printed.
constexpr std::array<TypeRow, 27> typeRows = {{
    {TypeKind::Void, "VOID", 0},
    {TypeKind::Bool, "BOOL", 1},
    {TypeKind::Byte, "BYTE", 1},
    {TypeKind::Char, "CHAR", 1},
    {TypeKind::Word, "WORD", 2},
    {TypeKind::Int, "INT", 2},
    {TypeKind::S5Time, "S5TIME", 2},
    {TypeKind::Date, "DATE", 2},
    {TypeKind::DWord, "DWORD", 4},
    {TypeKind::DInt, "DINT", 4},
    {TypeKind::Real, "REAL", 4},
    {TypeKind::Time, "TIME", 4},
    {TypeKind::TimeOfDay, "TIME_OF_DAY", 4},
    {TypeKind::TimeOfDay, "TOD", 4},
    {TypeKind::DateAndTime, "DATE_AND_TIME", 8},
    {TypeKind::DateAndTime, "DT", 8},
    {TypeKind::String, "STRING", 0},
    {TypeKind::Timer, "TIMER", 2},
    {TypeKind::Counter, "COUNTER", 2},
    {TypeKind::BlockDb, "BLOCK_DB", 2},
    {TypeKind::BlockSdb, "BLOCK_SDB", 2},
    {TypeKind::BlockFc, "BLOCK_FC", 2},
    {TypeKind::BlockFb, "BLOCK_FB", 2},
    {TypeKind::Pointer, "POINTER", 6},
    {TypeKind::Any, "ANY", 10},
    {TypeKind::Struct, "STRUCT", 0},
    {TypeKind::Unknown, "(unknown)", 0},
}};

constexpr std::uint64_t evenUp(std::uint64_t bytes) { return bytes + (bytes & 1U); }

/// Where the next field can begin.
struct FreePlace {
  std::uint64_t byte = 0;
  unsigned bit = 0;  ///< of `byte`; 0: it is untouched

  void closeByte() {
    if (bit > 0) ++byte;
    bit = 0;
  }
  void even() {
    closeByte();
    byte = evenUp(byte);
  }
};

/// Bytes from one element to the next, of elements that are no bits.
std::uint64_t strideOf(const Type& element) {
  const std::uint64_t size = sizeOf(element);
  return startsEven(element) ? evenUp(size) : size;
}

/// Bytes of a row of an array: of all elements of its last dimension. Rows of bits begin at bytes.
std::uint64_t rowSize(const Type& array) {
  const std::uint64_t count = array.bounds.back().count();
  return array.element->kind == TypeKind::Bool ? (count + 7) / 8 : count * strideOf(*array.element);
}

void placeField(Field& field, FreePlace& next) {
  if (field.type.kind == TypeKind::Bool) {
    if (next.bit == 8) next.closeByte();
    field.byte = static_cast<std::uint32_t>(next.byte);
    field.bit = static_cast<std::uint8_t>(next.bit++);
    return;
  }
  if (field.byReference || startsEven(field.type))
    next.even();
  else
    next.closeByte();
  field.byte = static_cast<std::uint32_t>(next.byte);
  field.bit = 0;
  next.byte += field.byReference ? 6 : sizeOf(field.type);
}

/// Code points of two bytes that have a small form: Latin-1, Cyrillic.
unsigned smallForm(unsigned c) {
  if ((c >= 0xC0 && c <= 0xDE && c != 0xD7) || (c >= 0x410 && c <= 0x42F)) return c + 0x20;
  return c >= 0x400 && c <= 0x40F ? c + 0x50 : c;
}

}  // namespace

std::string foldedName(std::string_view name) {
  std::string result;
  result.reserve(name.size());
  for (std::size_t i = 0; i < name.size(); ++i) {
    const auto c = static_cast<unsigned char>(name[i]);
    if (c >= 'A' && c <= 'Z') {
      result += static_cast<char>(c - 'A' + 'a');
    } else if (c >= 0xC3 && c <= 0xD1 && i + 1 < name.size()) {
      const unsigned folded = smallForm((c & 0x1FU) << 6 | (static_cast<unsigned char>(name[++i]) & 0x3FU));
      result += static_cast<char>(0xC0U | folded >> 6);
      result += static_cast<char>(0x80U | (folded & 0x3FU));
    } else {
      result += name[i];
    }
  }
  return result;
}

bool isSameName(std::string_view a, std::string_view b) {
  return a.size() == b.size() && (a == b || foldedName(a) == foldedName(b));
}

const Field* Structure::field(std::string_view name) const {
  const auto found = std::ranges::find_if(fields, [&](const Field& f) { return isSameName(f.name, name); });
  return found == fields.end() ? nullptr : &*found;
}

bool startsEven(const Type& type) {
  return type.kind != TypeKind::Bool && type.kind != TypeKind::Byte && type.kind != TypeKind::Char;
}

bool isComplex(const Type& type) {
  return type.kind == TypeKind::DateAndTime || type.kind == TypeKind::String || type.kind == TypeKind::Array ||
         type.kind == TypeKind::Struct;
}

std::uint64_t sizeOf(const Type& type) {
  switch (type.kind) {
    case TypeKind::String: return std::uint64_t{type.length} + 2;
    case TypeKind::Struct: return type.structure != nullptr ? type.structure->size : 0;
    case TypeKind::Array: {
      if (type.element == nullptr || type.bounds.empty()) return 0;
      // More bytes than any block holds are all the same to who asks.
      constexpr std::uint64_t tooLarge = std::uint64_t{1} << 40;
      std::uint64_t size = rowSize(type);
      for (std::size_t i = 0; i + 1 < type.bounds.size(); ++i) size = std::min(size, tooLarge) * type.bounds[i].count();
      return evenUp(std::min(size, tooLarge));
    }
    default: return std::ranges::find(typeRows, type.kind, &TypeRow::kind)->bytes;
  }
}

std::optional<Type> typeNamed(std::string_view name) {
  const auto same = [&](const TypeRow& row) {
    return row.name.size() == name.size() && std::ranges::equal(row.name, name, [](char a, char b) {
             return a == (b >= 'a' && b <= 'z' ? static_cast<char>(b - 'a' + 'A') : b);
           });
  };
  const auto row = std::ranges::find_if(typeRows, same);
  if (row == typeRows.end()) return std::nullopt;
  Type type;
  type.kind = row->kind;
  if (type.kind == TypeKind::String) type.length = 254;
  return type;
}

std::string toString(const Type& type) {
  switch (type.kind) {
    case TypeKind::String: return fmt::format("STRING[{}]", type.length);
    case TypeKind::Struct: return type.name.empty() ? "STRUCT" : type.name;
    case TypeKind::Array: {
      std::string text;
      for (const Bounds& b : type.bounds) text += fmt::format("{}{}..{}", text.empty() ? "" : ",", b.first, b.last);
      return fmt::format("ARRAY[{}] OF {}", text, type.element != nullptr ? toString(*type.element) : "?");
    }
    default: return std::string(std::ranges::find(typeRows, type.kind, &TypeRow::kind)->name);
  }
}

bool isSameType(const Type& a, const Type& b) {
  if (a.kind != b.kind || a.length != b.length || a.bounds != b.bounds) return false;
  if (a.kind == TypeKind::Array)
    return a.element != nullptr && b.element != nullptr && isSameType(*a.element, *b.element);
  if (a.kind != TypeKind::Struct) return true;
  if (!a.name.empty() && a.name == b.name) return true;
  if (a.structure == nullptr || b.structure == nullptr) return false;
  return std::ranges::equal(a.structure->fields, b.structure->fields,
                            [](const Field& x, const Field& y) { return isSameType(x.type, y.type); });
}

namespace {

/// Views share the places of fields, which have theirs by now.
void placeViews(Structure& structure) {
  for (Field& field : structure.fields) {
    if (field.viewOf.empty()) continue;
    const Field* seen = &field;  // a view of a view leads to a field in the end: each names one that stands before it
    while (!seen->viewOf.empty()) seen = structure.field(seen->viewOf);
    field.byte = seen->byte;
    field.bit = seen->bit;
  }
}

}  // namespace

void layOut(Structure& structure) {
  FreePlace next;
  for (Field& field : structure.fields) {
    if (field.viewOf.empty()) placeField(field, next);
  }
  placeViews(structure);
  next.even();
  structure.size = next.byte;
}

void layOutInstance(Structure& structure) {
  std::ranges::stable_sort(structure.fields, {}, &Field::section);
  FreePlace next;
  Section section = Section::Input;
  for (Field& field : structure.fields) {
    if (!field.viewOf.empty()) continue;
    if (field.section != section) next.even();
    section = field.section;
    field.byReference = section == Section::InOut && isComplex(field.type);
    placeField(field, next);
  }
  placeViews(structure);
  next.even();
  structure.size = next.byte;
}

PathResult lookUp(const Structure& structure, std::span<const PathStep> path) {
  PathResult result;
  const Structure* inside = &structure;
  std::uint64_t byte = 0;
  for (const PathStep& step : path) {
    const auto fault = [&](PathFault kind) {
      result.fault = kind;
      return result;
    };
    if (inside == nullptr) return fault(PathFault::NoStructure);
    const Field* field = inside->field(step.name);
    if (field == nullptr) return fault(PathFault::NoField);
    if (result.field == nullptr) {
      result.field = field;
      result.byReference = field->byReference;
    }
    result.type = &field->type;
    result.bit = field->bit;
    byte = field->byReference ? 0 : byte + field->byte;
    if (!step.indices.empty()) {
      if (field->type.kind != TypeKind::Array || field->type.element == nullptr) return fault(PathFault::NoArray);
      const std::vector<Bounds>& bounds = field->type.bounds;
      if (step.indices.size() != bounds.size()) return fault(PathFault::IndexCount);
      for (std::size_t i = 0; i < bounds.size(); ++i) {
        if (step.indices[i] < bounds[i].first || step.indices[i] > bounds[i].last) return fault(PathFault::IndexRange);
      }
      std::uint64_t row = 0;
      for (std::size_t i = 0; i + 1 < bounds.size(); ++i)
        row = row * bounds[i].count() + static_cast<std::uint64_t>(step.indices[i] - bounds[i].first);
      const auto column = static_cast<std::uint64_t>(step.indices.back() - bounds.back().first);
      byte += row * rowSize(field->type);
      const Type& element = *field->type.element;
      if (element.kind == TypeKind::Bool) {
        byte += column / 8;
        result.bit = static_cast<std::uint8_t>(column % 8);
      } else {
        byte += column * strideOf(element);
      }
      result.type = &element;
    }
    inside = result.type->kind == TypeKind::Struct ? result.type->structure.get() : nullptr;
    ++result.step;
  }
  result.byte = static_cast<std::uint32_t>(byte);
  return result;
}

}  // namespace rungproof::s7300
