// Spelling of operands.
#include "ir/operand.hpp"

#include <fmt/format.h>

#include <bit>

namespace rungproof {

std::string addressName(Area area, Width width, std::uint32_t offset, unsigned bit) {
  if (addressedByNumber(area)) return fmt::format("{}{}", areaName(area), offset);
  if (isAnalogue(area)) width = Width::Word;
  switch (width) {
    case Width::Bit: return fmt::format("{}{}.{}", areaName(area), offset, bit);
    case Width::Byte: return fmt::format("{}B{}", areaName(area), offset);
    case Width::Word: return fmt::format("{}W{}", areaName(area), offset);
    case Width::DWord: return fmt::format("{}D{}", areaName(area), offset);
  }
  return {};
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
      if (text.find_first_of(".eni") == std::string::npos) text += ".0";
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
      const std::string_view prefix = operand.width == Width::Byte ? "B" : operand.width == Width::Word ? "W" : "DW";
      return fmt::format("{}#{}", prefix, operand.value);
    }
    case ConstantForm::Boolean: return operand.value != 0 ? "TRUE" : "FALSE";
    default: return fmt::format("{}", operand.value);
  }
}

}  // namespace

std::string toString(const Operand& operand) {
  switch (operand.kind) {
    case OperandKind::Direct: return addressName(operand.area, operand.width, operand.offset, operand.bit);
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
