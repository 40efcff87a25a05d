// Statements from their spelling, as the manual's examples write them. Read here so that these tests depend on nothing
// but the instruction table and the meanings.
#pragma once

#include <bit>
#include <cstdlib>
#include <string>
#include <string_view>
#include <vector>

#include "ir/check.hpp"
#include "ir/program.hpp"
#include "ir/s7200/isa.hpp"

namespace rungproof::manual {

/// Operand from its spelling: I0.0, VW10, T37, AC1, *VD4, &VB0, 12, +12, -3, 16#FF, 1.5, "text".
inline Operand operandOf(std::string_view text) {
  Operand o;
  if (text.front() == '"') {
    o.kind = OperandKind::Text;
    o.text = text.substr(1, text.size() - 2);
    return o;
  }
  if (text.front() == '*' || text.front() == '&') {
    o = operandOf(text.substr(1));
    o.kind = text.front() == '*' ? OperandKind::Indirect : OperandKind::Address;
    return o;
  }
  const std::string s(text);
  if (s.starts_with("16#")) return constant(std::strtoll(s.c_str() + 3, nullptr, 16), ConstantForm::Hex);
  if (std::string_view("+-0123456789").find(s[0]) != std::string_view::npos) {
    if (s.find('.') == std::string::npos) return constant(std::strtoll(s.c_str(), nullptr, 10));
    return constant(std::bit_cast<std::uint32_t>(std::strtof(s.c_str(), nullptr)), ConstantForm::Real);
  }
  static constexpr std::string_view areas[] = {"SM", "AC", "AI", "AQ", "HC", "I", "Q", "V", "M", "S", "L", "T", "C"};
  static constexpr Area values[] = {Area::SM, Area::AC, Area::AI, Area::AQ, Area::HC, Area::I, Area::Q,
                                    Area::V,  Area::M,  Area::S,  Area::L,  Area::T,  Area::C};
  std::size_t k = 0;
  while (!s.starts_with(areas[k])) ++k;
  std::size_t at = areas[k].size();
  Width width = Width::Bit;
  if (s[at] == 'B') width = Width::Byte;
  if (s[at] == 'W') width = Width::Word;
  if (s[at] == 'D' || values[k] == Area::AC || values[k] == Area::HC) width = Width::DWord;
  if (s[at] == 'B' || s[at] == 'W' || s[at] == 'D') ++at;
  const std::size_t dot = s.find('.');
  const auto bit = dot == std::string::npos ? 0U : static_cast<unsigned>(std::atoi(s.c_str() + dot + 1));
  return direct(values[k], width, static_cast<std::uint32_t>(std::atoi(s.c_str() + at)), bit);
}

/// Statement from its spelling: "ITA VW2, VB10, 16#0B".
inline Instruction statement(std::string_view line) {
  Instruction instruction;
  const std::size_t space = line.find(' ');
  const std::string_view name = line.substr(0, space);
  instruction.desc = s7200Instructions().named(name);
  CHECK(instruction.desc != nullptr, std::string(name).c_str());
  std::string word;
  bool quoted = false;
  const auto flush = [&] {
    if (!word.empty()) instruction.operands.push_back(operandOf(word));
    word.clear();
  };
  for (const char c : space == std::string_view::npos ? std::string_view{} : line.substr(space)) {
    if (c == '"') quoted = !quoted;
    if (!quoted && c == ',')
      flush();
    else if (quoted || c != ' ')
      word += c;
  }
  flush();
  return instruction;
}

inline std::vector<std::string> split(std::string_view text, char separator) {
  std::vector<std::string> parts;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find(separator), text.size());
    std::string_view part = text.substr(0, end);
    while (!part.empty() && part.front() == ' ') part.remove_prefix(1);
    while (!part.empty() && part.back() == ' ') part.remove_suffix(1);
    if (!part.empty()) parts.emplace_back(part);
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return parts;
}

}  // namespace rungproof::manual
