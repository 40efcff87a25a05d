// Answers about one operand.
#include "analysis/flow/operand_check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

namespace rungproof {

namespace {

Forms pointerForm(Area area) {
  switch (area) {
    case Area::V: return form::PtrV;
    case Area::L: return form::PtrL;
    case Area::AC: return form::PtrAC;
    default: return 0;
  }
}

}  // namespace

bool formIsAllowed(const OperandDesc& desc, const Operand& operand) {
  switch (operand.kind) {
    case OperandKind::Direct: return (desc.forms & form::area(operand.area)) != 0;
    case OperandKind::Indirect:
      return pointerForm(operand.area) == 0 ? (desc.forms & form::Pointers) != 0
                                            : (desc.forms & pointerForm(operand.area)) != 0;
    case OperandKind::Address: return (desc.forms & form::Address) != 0;
    case OperandKind::Constant: return (desc.forms & form::Const) != 0;
    case OperandKind::Text: return desc.type == Type::String && (desc.forms & form::Const) != 0;
    default: return true;
  }
}

Width accessWidth(const OperandDesc& desc, const Operand& operand) {
  if (hasBitAndWord(operand.area)) return desc.type == Type::Bool ? Width::Bit : Width::Word;
  return areaInfo(operand.area).width.value_or(operand.width);
}

bool widthIsAllowed(const OperandDesc& desc, const Operand& operand) {
  if (operand.kind != OperandKind::Direct || addressedByNumber(operand.area)) return true;
  if (isAnalogue(operand.area)) return true;
  if (desc.type == Type::Parameter) return true;
  return operand.width == widthOf(desc.type);
}

bool notationIsAllowed(const OperandDesc& desc, const Operand& operand) {
  if (desc.type == Type::Parameter) return true;
  if (operand.kind == OperandKind::Constant && desc.type == Type::String) return false;
  if (operand.kind != OperandKind::Constant) return true;
  const bool isReal = operand.form == ConstantForm::Real;
  if (desc.type != Type::Real) return !isReal && operand.form != ConstantForm::Boolean;
  const bool isPattern =
      operand.form == ConstantForm::Hex || operand.form == ConstantForm::Binary || operand.form == ConstantForm::Typed;
  return isReal || isPattern || operand.value == 0;
}

bool pointerMayStandThere(const Operand& operand) {
  return mayHoldPointer(operand.area) && (operand.area != Area::AC || operand.offset != 0);
}

std::string_view widthName(Width width) {
  switch (width) {
    case Width::Bit: return "a bit";
    case Width::Byte: return "a byte";
    case Width::Word: return "a word";
    case Width::LWord: return "64 bits";
    default: return "a double word";
  }
}

std::string allowedForms(const OperandDesc& desc) {
  std::vector<std::string> words;
  static constexpr std::string_view suffixes[] = {"", "B", "W", "D"};
  const std::string_view suffix = suffixes[static_cast<std::size_t>(widthOf(desc.type))];
  for (int a = 0; a < areaCount; ++a) {
    const Area area = static_cast<Area>(a);
    if ((desc.forms & form::area(area)) == 0) continue;
    const bool isFixed = addressedByNumber(area);
    words.push_back(fmt::format("{}{}", areaName(area), isFixed ? "" : isAnalogue(area) ? "W" : suffix));
  }
  if ((desc.forms & form::PtrV) != 0) words.emplace_back("*VD");
  if ((desc.forms & form::PtrL) != 0) words.emplace_back("*LD");
  if ((desc.forms & form::PtrAC) != 0) words.emplace_back("*AC");
  if ((desc.forms & form::Address) != 0) words.emplace_back("an address with &");
  if ((desc.forms & form::Const) != 0) words.emplace_back(desc.type == Type::String ? "a text" : "a constant");
  std::string text;
  for (std::size_t i = 0; i < words.size(); ++i)
    text += (i == 0 ? "" : i + 1 == words.size() ? " or " : ", ") + words[i];
  return text;
}

bool valueIsInRange(const OperandDesc& desc, std::int64_t value, CpuSet cpus) {
  if (!desc.hasRanges()) return true;
  return std::any_of(desc.ranges.begin(), desc.ranges.end(), [&](const ValueRange& range) {
    return (range.cpus & cpus) != 0 && value >= range.low && value <= range.high;
  });
}

std::string rangesText(const OperandDesc& desc, Cpu cpu) {
  std::string text;
  for (const ValueRange& range : desc.ranges) {
    if ((range.cpus & cpuBit(cpu)) == 0) continue;
    if (!text.empty()) text += ", ";
    text += range.low == range.high ? fmt::format("{}", range.low) : fmt::format("{} to {}", range.low, range.high);
  }
  return text;
}

std::optional<TypeLimits> typeLimits(Type type) {
  switch (type) {
    case Type::Byte: return TypeLimits{-128, 255};
    case Type::Word:
    case Type::Int: return TypeLimits{-32768, 65535};
    case Type::DWord:
    case Type::DInt: return TypeLimits{-2147483648LL, 4294967295LL};
    default: return std::nullopt;
  }
}

std::int64_t signedByteValue(std::int64_t value) { return value > 127 && value <= 255 ? value - 256 : value; }

}  // namespace rungproof
