// Programs of the encoder's tests, written as statements: one instruction a line, operands separated by commas,
// SBR n and INT n begin blocks. Only what these tests need; the product's reader is frontend/.
#pragma once

#include <cctype>
#include <sstream>
#include <stdexcept>
#include <string>
#include <string_view>

#include "ir/program.hpp"
#include "ir/s7200/isa.hpp"

namespace rungproof {

inline Operand operandOf(std::string_view text) {
  const auto number = [](std::string_view digits, int base = 10) {
    return std::stoll(std::string(digits), nullptr, base);
  };
  if (text[0] == '*' || text[0] == '&') {
    Operand operand = operandOf(text.substr(1));
    operand.kind = text[0] == '*' ? OperandKind::Indirect : OperandKind::Address;
    return operand;
  }
  if (text.substr(0, 3) == "16#") return constant(number(text.substr(3), 16), ConstantForm::Hex);
  if (text[0] == '-' || text[0] == '+' || std::isdigit(static_cast<unsigned char>(text[0])) != 0)
    return constant(number(text));
  static constexpr std::pair<std::string_view, Area> areas[] = {
      {"AIW", Area::AI}, {"AQW", Area::AQ}, {"SM", Area::SM}, {"AC", Area::AC}, {"HC", Area::HC},
      {"I", Area::I},    {"Q", Area::Q},    {"V", Area::V},   {"M", Area::M},   {"S", Area::S},
      {"L", Area::L},    {"T", Area::T},    {"C", Area::C}};
  for (const auto& [name, area] : areas) {
    if (text.substr(0, name.size()) != name) continue;
    std::string_view rest = text.substr(name.size());
    if (area == Area::AI || area == Area::AQ)
      return direct(area, Width::Word, static_cast<std::uint32_t>(number(rest)));
    if (area == Area::AC || area == Area::HC)
      return direct(area, Width::DWord, static_cast<std::uint32_t>(number(rest)));
    if (area == Area::T || area == Area::C) return direct(area, Width::Bit, static_cast<std::uint32_t>(number(rest)));
    Width width = Width::Bit;
    if (rest[0] == 'B' || rest[0] == 'W' || rest[0] == 'D') {
      width = rest[0] == 'B' ? Width::Byte : rest[0] == 'W' ? Width::Word : Width::DWord;
      rest.remove_prefix(1);
    }
    const std::size_t dot = rest.find('.');
    const unsigned bit = dot == std::string_view::npos ? 0 : static_cast<unsigned>(number(rest.substr(dot + 1)));
    return direct(area, width, static_cast<std::uint32_t>(number(rest.substr(0, dot))), bit);
  }
  throw std::runtime_error("operand " + std::string(text));
}

inline Program programOf(std::string_view text) {
  Program program;
  const auto block = [&](PouKind kind, int number) {
    program.pous.push_back({});
    program.pous.back().kind = kind;
    program.pous.back().number = number;
    program.pous.back().networks.push_back({});
  };
  block(PouKind::Main, 0);
  std::istringstream lines{std::string(text)};
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    std::string mnemonic;
    if (!(words >> mnemonic)) continue;
    std::string rest, operand;
    std::getline(words, rest);
    if (mnemonic == "SBR" || mnemonic == "INT") {
      block(mnemonic == "SBR" ? PouKind::Subroutine : PouKind::Interrupt, std::stoi(rest));
      continue;
    }
    Instruction instruction;
    instruction.desc = s7200Instructions().named(mnemonic);
    if (instruction.desc == nullptr) throw std::runtime_error("mnemonic " + mnemonic);
    std::istringstream operands(rest);
    while (std::getline(operands, operand, ',')) {
      const std::size_t first = operand.find_first_not_of(' '), last = operand.find_last_not_of(' ');
      if (first != std::string::npos)
        instruction.operands.push_back(operandOf(operand.substr(first, last - first + 1)));
    }
    program.pous.back().networks.back().instructions.push_back(std::move(instruction));
  }
  program.number();
  return program;
}

}  // namespace rungproof
