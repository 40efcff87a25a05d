// Spelling of operands.
#include "ir/operand.hpp"

#include <fmt/format.h>

#include <bit>

namespace rungproof {

std::string addressName(Area area, Width width, std::uint32_t offset, unsigned bit) {
  if (area == Area::DB) {
    static constexpr std::string_view letters[] = {"X", "B", "W", "D", "L"};
    const std::string place =
        fmt::format("DB{}.DB{}{}", offset >> 16, letters[static_cast<int>(width)], offset & 0xFFFF);
    return width == Width::Bit ? fmt::format("{}.{}", place, bit) : place;
  }
  // Messages name an address or two each, so these few letters are put together without a format.
  std::string name(areaName(area));
  if (addressedByNumber(area)) return name += std::to_string(offset);
  if (isAnalogue(area)) width = Width::Word;
  if (width != Width::Bit) name += "XBWDL"[static_cast<int>(width)];
  name += std::to_string(offset);
  if (width == Width::Bit) name.append(".").append(std::to_string(bit));
  return name;
}

std::string quoted(std::string_view characters, char mark) {
  std::string result(1, mark);
  for (std::size_t i = 0; i < characters.size(); ++i) {
    const auto c = static_cast<unsigned char>(characters[i]);
    if (c == '$' || characters[i] == mark) {
      result += '$';
      result += characters[i];
    } else if (c >= ' ' && c < 0x7F) {
      result += characters[i];
    } else {
      result += fmt::format("${:02X}", c);
    }
  }
  return result + mark;
}

namespace {

std::string constantText(const Operand& operand) {
  switch (operand.form) {
    case ConstantForm::Hex: return fmt::format("16#{:X}", static_cast<std::uint64_t>(operand.value));
    case ConstantForm::Binary: return fmt::format("2#{:b}", static_cast<std::uint64_t>(operand.value));
    case ConstantForm::SignedDecimal: return fmt::format("{:+}", operand.value);
    case ConstantForm::Real: {
      const float real = std::bit_cast<float>(static_cast<std::uint32_t>(operand.value));
      std::string text = fmt::format("{}", real);
      if (text.find_first_of(".ni") == std::string::npos) text.insert(std::min(text.find('e'), text.size()), ".0");
      return text;
    }
    case ConstantForm::Ascii: {
      std::string characters;
      for (int shift = 24; shift >= 0; shift -= 8) {
        const char c = static_cast<char>(operand.value >> shift);
        if (c != 0 || !characters.empty() || shift == 0) characters += c;
      }
      return rungproof::quoted(characters, '\'');
    }
    case ConstantForm::Typed: {
      if (!operand.text.empty()) return operand.text;
      const std::string_view prefix = operand.width == Width::Byte ? "B" : operand.width == Width::Word ? "W" : "DW";
      return fmt::format("{}#{}", prefix, operand.value);
    }
    case ConstantForm::Boolean: return operand.value != 0 ? "TRUE" : "FALSE";
    default: return fmt::format("{}", operand.value);
  }
}

}  // namespace

namespace {

constexpr std::string_view widths[] = {"", "B", "W", "D"};

/// "M", "MB", "DIW", "T": the letters before an offset or a bracket.
std::string step7Letters(const Operand& operand) {
  if (addressedByNumber(operand.area)) return std::string(areaName(operand.area));
  if (operand.area != Area::DB)
    return fmt::format("{}{}", areaName(operand.area), widths[static_cast<int>(operand.width)]);
  const std::string_view width = operand.width == Width::Bit ? "X" : widths[static_cast<int>(operand.width)];
  return fmt::format("D{}{}", operand.reach->inDi ? "I" : "B", width);
}

/// DBW 2, #name, M[MD4], M[AR1,P#2.1], W[AR2,P#0.0] (002:1622-1711); a name that stood there comes first.
std::string step7Text(const Operand& operand) {
  if (!operand.text.empty()) return operand.text;
  const Reach& reach = *operand.reach;
  const std::string offset = fmt::format("P#{}.{}", operand.offset, operand.bit);
  const std::string_view ar = reach.byAr2 ? "AR2" : "AR1";
  const auto place = [&] {
    return operand.width == Width::Bit ? fmt::format("{}{}.{}", step7Letters(operand), operand.offset, operand.bit)
                                       : fmt::format("{}{}", step7Letters(operand), operand.offset);
  };
  switch (reach.way) {
    case Way::OpenBlock:
    case Way::Instance: return place();
    case Way::Parameter: return fmt::format("#{}", reach.parameter);
    case Way::Pointer: return fmt::format("{}[{}]", step7Letters(operand), toString(reach.pointer));
    case Way::Register: return fmt::format("{}[{},{}]", step7Letters(operand), ar, offset);
    case Way::Crossing: return fmt::format("{}[{},{}]", widths[static_cast<int>(operand.width)], ar, offset);
    case Way::Handed: return fmt::format("#{}", reach.parameter);
    case Way::PointerTo: return toString(reach.pointer);
  }
  return {};
}

}  // namespace

std::string toString(const Operand& operand) {
  if (operand.reach != nullptr) return step7Text(operand);
  switch (operand.kind) {
    case OperandKind::Direct:
      // A variable of IEC 61131-3 has a name and a form; an address of another family has the usual form.
      if (operand.form != ConstantForm::Decimal && !std::string_view(operand.text).empty()) return operand.text;
      return addressName(operand.area, operand.width, operand.offset, operand.bit);
    case OperandKind::Indirect: return "*" + addressName(operand.area, Width::DWord, operand.offset);
    case OperandKind::Address: return "&" + addressName(operand.area, Width::Byte, operand.offset);
    case OperandKind::Constant: return constantText(operand);
    case OperandKind::Text: return rungproof::quoted(operand.text, '"');
    case OperandKind::Symbol: return operand.text;
    case OperandKind::Missing: return "????";
  }
  return {};
}

Operand direct(Area area, Width width, std::uint32_t offset, unsigned bit) {
  Operand operand;
  operand.kind = OperandKind::Direct;
  operand.area = area;
  operand.width = width;
  operand.offset = offset;
  operand.bit = static_cast<std::uint8_t>(bit);
  return operand;
}

Operand constant(std::int64_t value, ConstantForm form) {
  Operand operand;
  operand.kind = OperandKind::Constant;
  operand.value = value;
  operand.form = form;
  return operand;
}

}  // namespace rungproof
