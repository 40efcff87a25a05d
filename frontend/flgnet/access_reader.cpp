// Each form becomes the text that a source has for it where there is one, and is read as that.
#include "frontend/flgnet/access_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <iterator>
#include <string>

#include "frontend/flgnet/fragment.hpp"
#include "frontend/stl/stl_lexer.hpp"
#include "frontend/xml/xml_text.hpp"

namespace rungproof::flgnet {

namespace {

using step7::Operand;
using step7::OperandForm;

struct AreaLetters {
  std::string_view area, letters;
  bool isBlock = false;  ///< of data, whose bits are DBX
};
constexpr AreaLetters areaLetters[] = {
    {"Input", "I"},     {"Output", "Q"},    {"Memory", "M"}, {"PeripheryInput", "PI"}, {"PeripheryOutput", "PQ"},
    {"DB", "DB", true}, {"DI", "DI", true}, {"Local", "L"},  {"Timer", "T"},           {"Counter", "C"},
    {"FC", "FC"},       {"FB", "FB"}};

const AreaLetters* areaNamed(std::string_view name) {
  const auto row = std::ranges::find(areaLetters, name, &AreaLetters::area);
  return row == std::end(areaLetters) ? nullptr : row;
}

/// 'X' for bits, 'B', 'W', 'D'; '\0': no single access reaches the type.
char widthLetterOf(std::string_view type) {
  struct TypeWidth {
    std::string_view type;
    char width;
  };
  static constexpr TypeWidth rows[] = {
      {"Bool", 'X'},  {"Byte", 'B'}, {"Char", 'B'}, {"Word", 'W'},        {"Int", 'W'},  {"Date", 'W'}, {"S5Time", 'W'},
      {"DWord", 'D'}, {"DInt", 'D'}, {"Real", 'D'}, {"Time_Of_Day", 'D'}, {"Time", 'D'}, {"TOD", 'D'}};
  const auto row = std::ranges::find(rows, type, &TypeWidth::type);
  return row == std::end(rows) ? '\0' : row->width;
}

std::string areaText(const AreaLetters& area, char width) {
  if (width == 'X') return fmt::format("{}{}", area.letters, area.isBlock ? "X" : "");
  return fmt::format("{}{}", area.letters, width);
}

/// <Address Area="DB" BlockNumber="10" Type="Int" BitOffset="16"/> is DB10.DBW2.
std::string textOfAddress(const pugi::xml_node& node) {
  const AreaLetters* area = areaNamed(node.attribute("Area").value());
  const std::optional<std::uint32_t> bit = numberIn(node.attribute("BitOffset").value());
  if (area == nullptr || !bit) return "";
  if (area->letters == "T" || area->letters == "C") return fmt::format("{}{}", area->letters, *bit);
  std::string text;
  if (const pugi::xml_attribute number = node.attribute("BlockNumber")) {
    const std::optional<std::uint32_t> block = numberIn(number.value());
    if (!block || area->letters != "DB") return "";
    text = fmt::format("DB{}.", *block);
  }
  const char width = widthLetterOf(node.attribute("Type").value());
  if (width == '\0' || (width != 'X' && *bit % 8 != 0)) return "";
  text += areaText(*area, width);
  return width == 'X' ? fmt::format("{} {}.{}", text, *bit / 8, *bit % 8) : fmt::format("{} {}", text, *bit / 8);
}

/// The operand of that form whose pointer the inner access holds.
std::optional<Operand> throughPointer(const std::string& text, const pugi::xml_node& inner, Span span) {
  std::optional<Operand> operand = operandFrom(text, span);
  const std::optional<Operand> pointer = accessFrom(inner, span);
  if (!operand || !pointer) return std::nullopt;
  operand->pointer = std::make_shared<const Operand>(*pointer);
  return operand;
}

std::optional<Operand> indirectFrom(const pugi::xml_node& node, Span span) {
  static constexpr std::pair<std::string_view, char> widths[] = {
      {"Bit", 'X'}, {"Byte", 'B'}, {"Word", 'W'}, {"Double", 'D'}};
  const auto width = std::ranges::find(widths, std::string_view(node.attribute("Width").value()),
                                       &std::pair<std::string_view, char>::first);
  const std::string_view areaName = node.attribute("Area").value(), reg = node.attribute("Register").value();
  const AreaLetters* area = areaNamed(areaName);
  if (area == nullptr && !areaName.empty() && areaName != "None") return std::nullopt;
  const bool isNumbered = area != nullptr && (area->letters == "T" || area->letters == "C");
  if (width == std::end(widths) && !isNumbered) return std::nullopt;
  std::string text;
  if (isNumbered)
    text = area->letters;
  else if (area != nullptr)
    text = areaText(*area, width->second);
  else if (width->second != 'X')
    text = width->second;
  if (const pugi::xml_node inner = childNamed(node, "Access"); inner && area != nullptr && reg.empty())
    return throughPointer(text + (isNumbered ? " [MW 0]" : " [MD 0]"), inner, span);
  const std::optional<std::uint32_t> bit = numberIn(node.attribute("BitOffset").value());
  if ((reg != "AR1" && reg != "AR2") || !bit || isNumbered) return std::nullopt;
  return operandFrom(fmt::format("{} [{},P#{}.{}]", text, reg, *bit / 8, *bit % 8), span);
}

/// OV, ==0, STW.
std::optional<Operand> statusFrom(const pugi::xml_node& node, Span span) {
  static constexpr std::pair<std::string_view, std::string_view> words[] = {
      {"BR", "BR"}, {"OV", "OV"},  {"OS", "OS"},  {"EQ", "==0"}, {"NE", "<>0"}, {"LT", "<0"},
      {"GT", ">0"}, {"LE", "<=0"}, {"GE", ">=0"}, {"UO", "UO"},  {"STW", "STW"}};
  const auto row = std::ranges::find(words, std::string_view(node.attribute("Combination").value()),
                                     &std::pair<std::string_view, std::string_view>::first);
  return row == std::end(words) ? std::nullopt : operandFrom(row->second, span);
}

std::optional<Operand> symbolFrom(const pugi::xml_node& components, bool isLocal, Span span) {
  std::vector<step7::PathStep> path;
  bool isPeripheral = false;
  for (const pugi::xml_node& node : components.children()) {
    if (localName(node) != "Component") continue;
    step7::PathStep step;
    step.name = node.attribute("Name").value();
    step.span = span;
    const std::string_view slice = node.attribute("SliceAccessModifier").value();
    if (!slice.empty() && slice != "undef") return std::nullopt;
    isPeripheral = isPeripheral || std::string_view(node.attribute("SimpleAccessModifier").value()) == "Periphery";
    for (const pugi::xml_node& index : node.children()) {
      if (localName(index) != "Access") continue;
      const std::optional<std::uint32_t> number =
          numberIn(trimmed(childNamed(childNamed(index, "Constant"), "ConstantValue").child_value()));
      if (!number) return std::nullopt;
      step.indices.push_back(*number);
    }
    const bool isElement = std::string_view(node.attribute("AccessModifier").value()) == "Array";
    if (isElement == step.indices.empty()) return std::nullopt;
    path.push_back(std::move(step));
  }
  if (path.empty() || path.front().name.empty()) return std::nullopt;
  Operand operand;
  operand.span = span;
  if (isLocal) {
    if (isPeripheral) return std::nullopt;
    operand.form = OperandForm::Local;
    operand.path = std::move(path);
    return operand;
  }
  if (!path.front().indices.empty()) return std::nullopt;
  operand.form = OperandForm::Symbol;
  operand.name = path.front().name;
  operand.isPeripheral = isPeripheral;
  operand.path.assign(path.begin() + 1, path.end());
  return operand;
}

Operand named(OperandForm form, std::string name, Span span) {
  Operand operand;
  operand.form = form;
  operand.span = span;
  if (form == OperandForm::Local)
    operand.path.push_back({std::move(name), {}, span});
  else
    operand.name = std::move(name);
  return operand;
}

}  // namespace

std::optional<Operand> accessFrom(const pugi::xml_node& node, Span span) {
  const std::string_view scope = node.attribute("Scope").value();
  if (scope == "Label") return named(OperandForm::Word, childNamed(node, "Label").attribute("Name").value(), span);
  if (scope == "Statusword") return statusFrom(childNamed(node, "Statusword"), span);
  if (const pugi::xml_node indirect = childNamed(node, "Indirect")) return indirectFrom(indirect, span);
  if (scope == "Address") return operandFrom(textOfAddress(childNamed(node, "Address")), span);
  const pugi::xml_node constant = childNamed(node, "Constant");
  if (scope == "LocalConstant" && constant) return named(OperandForm::Local, constant.attribute("Name").value(), span);
  if (scope == "GlobalConstant" && constant)
    return named(OperandForm::Symbol, constant.attribute("Name").value(), span);
  if (constant) {
    return constantFrom(trimmed(childNamed(constant, "ConstantType").child_value()),
                        trimmed(childNamed(constant, "ConstantValue").child_value()), span);
  }
  const pugi::xml_node symbol = childNamed(node, "Symbol");
  return symbol ? symbolFrom(symbol, scope == "LocalVariable", span) : std::nullopt;
}

std::optional<Operand> blockFrom(const pugi::xml_node& node, Span span) {
  if (const pugi::xml_node indirect = childNamed(node, "Indirect")) {
    const AreaLetters* area = areaNamed(indirect.attribute("Area").value());
    const pugi::xml_node inner = childNamed(indirect, "Access");
    return area == nullptr || !inner ? std::nullopt
                                     : throughPointer(fmt::format("{} [MW 0]", area->letters), inner, span);
  }
  const pugi::xml_node address = childNamed(node, "Address");
  if (!address || address.attribute("Type")) return accessFrom(node, span);
  const AreaLetters* area = areaNamed(address.attribute("Area").value());
  const pugi::xml_attribute written = address.attribute("BlockNumber");
  const std::optional<std::uint32_t> number = numberIn((written ? written : address.attribute("BitOffset")).value());
  return area == nullptr || !number ? std::nullopt : operandFrom(fmt::format("{} {}", area->letters, *number), span);
}

std::optional<Operand> instanceFrom(const pugi::xml_node& instance, Span span) {
  if (childNamed(instance, "Address")) {
    const std::string text = textOfAddress(childNamed(instance, "Address"));
    return text.empty() ? blockFrom(instance, span) : operandFrom(text, span);
  }
  return symbolFrom(instance, std::string_view(instance.attribute("Scope").value()) == "LocalVariable", span);
}

std::optional<std::uint32_t> numberIn(std::string_view text) {
  std::uint32_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc() && !text.empty() && end == text.data() + text.size() ? std::optional(value)
                                                                                   : std::nullopt;
}

}  // namespace rungproof::flgnet
