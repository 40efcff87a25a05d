// From the image of a data block to assignments.
#include "frontend/mc7/actual_values.hpp"

#include <fmt/format.h>

#include <vector>

#include "frontend/step7/constant_parser.hpp"
#include "frontend/step7/constant_spelling.hpp"

namespace rungproof::mc7 {

namespace {

using s7300::ConstantKind;
using s7300::Structure;
using s7300::Type;
using s7300::TypeKind;

std::optional<ConstantKind> constantKindOf(TypeKind kind) {
  switch (kind) {
    case TypeKind::Byte: return ConstantKind::Byte;
    case TypeKind::Word: return ConstantKind::Word;
    case TypeKind::Int: return ConstantKind::Integer;
    case TypeKind::DWord: return ConstantKind::DWord;
    case TypeKind::DInt: return ConstantKind::Long;
    case TypeKind::Real: return ConstantKind::Real;
    case TypeKind::S5Time: return ConstantKind::S5Time;
    case TypeKind::Date: return ConstantKind::Date;
    case TypeKind::Time: return ConstantKind::Time;
    case TypeKind::TimeOfDay: return ConstantKind::TimeOfDay;
    case TypeKind::DateAndTime: return ConstantKind::DateAndTime;
    default: return std::nullopt;
  }
}

class ValueWriter {
 public:
  ValueWriter(const std::vector<std::uint8_t>& initial, std::string_view image) : initial_(initial), image_(image) {}

  void structure(const Structure& structure, const std::string& prefix, std::uint64_t base) {
    for (const s7300::Field& field : structure.fields) {
      if (!field.byReference) value(field.type, prefix + field.name, base + field.byte, field.bit);
    }
  }
  std::vector<NamedValue> take() { return std::move(values_); }

 private:
  void value(const Type& type, const std::string& name, std::uint64_t byte, unsigned bit) {
    if (type.kind == TypeKind::Struct) {
      if (type.structure != nullptr) structure(*type.structure, name + ".", byte);
      return;
    }
    if (type.kind == TypeKind::Array) return array(type, name, byte);
    const std::uint64_t size = std::max<std::uint64_t>(1, s7300::sizeOf(type));
    if (byte + size > image_.size() || byte + size > initial_.size()) return;
    if (type.kind == TypeKind::Bool) {
      const bool is = (at(byte) >> bit & 1U) != 0, was = (initial_[byte] >> bit & 1U) != 0;
      if (is != was) line(name, is ? "TRUE" : "FALSE");
      return;
    }
    bool isSame = true;
    std::uint64_t bits = 0;
    for (std::uint64_t i = 0; i < size; ++i) {
      isSame = isSame && at(byte + i) == initial_[byte + i];
      bits = bits << 8 | at(byte + i);
    }
    if (isSame) return;
    if (type.kind == TypeKind::Char) return line(name, fmt::format("'${:02X}'", bits));
    if (type.kind == TypeKind::String) return string(name, byte, size);
    const std::optional<ConstantKind> kind = constantKindOf(type.kind);
    if (!kind) return;
    s7300::Constant constant;
    constant.kind = *kind;
    constant.value = static_cast<std::int64_t>(bits);
    if (*kind == ConstantKind::Integer) constant.value = static_cast<std::int16_t>(bits);
    if (*kind == ConstantKind::Long) constant.value = static_cast<std::int32_t>(bits);
    line(name, step7::spellingOf(constant));
  }

  void string(const std::string& name, std::uint64_t byte, std::uint64_t size) {
    const std::uint64_t length = std::min<std::uint64_t>(at(byte + 1), size - 2);
    std::string text = "'";
    for (std::uint64_t i = 0; i < length; ++i) text += fmt::format("${:02X}", at(byte + 2 + i));
    line(name, text + "'");
  }

  void array(const Type& type, const std::string& name, std::uint64_t byte) {
    // The place of each element is that which its name has.
    Structure whole;
    whole.fields.emplace_back().name = name;
    whole.fields.back().type = type;
    std::vector<std::int64_t> indices;
    for (const s7300::Bounds& bounds : type.bounds) indices.push_back(bounds.first);
    // Elements that take no room are none.
    std::size_t most = image_.size() * 8;
    for (bool isMore = !indices.empty() && type.element != nullptr; isMore && most > 0; --most) {
      const s7300::PathStep step{name, indices, {}};
      const s7300::PathResult found = s7300::lookUp(whole, std::span(&step, 1));
      if (found.fault != s7300::PathFault::None || byte + found.byte >= image_.size()) return;
      std::string element = name + "[";
      for (std::size_t i = 0; i < indices.size(); ++i) element += fmt::format("{}{}", i > 0 ? "," : "", indices[i]);
      value(*type.element, element + "]", byte + found.byte, found.bit);
      isMore = false;
      for (std::size_t i = indices.size(); i-- > 0 && !isMore;) {
        isMore = ++indices[i] <= type.bounds[i].last;
        if (!isMore) indices[i] = type.bounds[i].first;
      }
    }
  }

  std::uint8_t at(std::uint64_t byte) const { return static_cast<std::uint8_t>(image_[byte]); }
  void line(const std::string& name, std::string_view value) {
    step7::Cursor cursor(value, 0);
    const step7::ConstantOutcome read =
        step7::readConstant(cursor, step7::MnemonicSet::International, TextEncoding::Utf8);
    const bool isConstant = read.constant && cursor.at() == value.size();
    values_.push_back({name, isConstant ? std::string(value) : ""});
  }

  const std::vector<std::uint8_t>& initial_;
  std::string_view image_;
  std::vector<NamedValue> values_;
};

}  // namespace

std::vector<NamedValue> valuesUnlike(const Structure& structure, const std::vector<std::uint8_t>& reference,
                                     std::string_view image) {
  ValueWriter writer(reference, image);
  writer.structure(structure, "", 0);
  return writer.take();
}

std::string actualValues(const Structure& structure, std::string_view image) {
  std::string text;
  for (const NamedValue& one : valuesUnlike(structure, s7300::initialBytes(structure), image)) {
    // Bytes that no constant of the type spells, such as a date of zeros, are said in a remark.
    text += one.value.empty() ? fmt::format("   // {}: its actual value is none of its type\n", one.name)
                              : fmt::format("   {} := {} ;\n", one.name, one.value);
  }
  return text;
}

}  // namespace rungproof::mc7
