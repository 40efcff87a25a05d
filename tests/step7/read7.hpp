// Shorthand of these tests: read texts as one project, show what came out on one line.
#pragma once

#include <fmt/format.h>

#include <string>
#include <vector>

#include "frontend/input/project.hpp"
#include "ir/desc.hpp"

namespace rungproof {

/// Findings with line and column of their place: "SYN046 3:9 nothing defines \"x\"".
inline std::string findings7(const Program& program) {
  std::string result;
  for (const Finding& finding : program.findings) {
    const Position at = program.sources->position(finding.span);
    result +=
        fmt::format("{}{} {}:{} {}", result.empty() ? "" : " | ", finding.rule, at.line, at.column, finding.message);
  }
  return result;
}

inline std::string show7(const Operand& operand) {
  static const char* const ways[] = {"open", "instance", "parameter", "pointer", "register", "crossing", "handed"};
  static const char* const widths[] = {"", "B", "W", "D"};
  if (operand.kind == OperandKind::Missing) return "-";
  if (operand.kind == OperandKind::Text) return "'" + operand.text + "'";
  if (operand.kind == OperandKind::Constant)
    return operand.text.empty() ? fmt::format("{}", operand.value) : fmt::format("{}={}", operand.text, operand.value);
  if (operand.reach != nullptr && operand.reach->way == Way::PointerTo) {
    const Operand& place = operand.reach->pointer;
    return fmt::format("&{}:{:X}x{}", place.kind == OperandKind::Constant ? "'" + operand.text + "'" : show7(place),
                       operand.reach->anyType, operand.reach->anyCount);
  }
  const bool isData = operand.area == Area::DB && operand.reach == nullptr;
  const std::string number =
      isData ? fmt::format("{}:{}", operand.offset >> 16, operand.offset & 0xFFFF) : fmt::format("{}", operand.offset);
  std::string text = fmt::format("{}{}{}{}", operand.kind == OperandKind::Address ? "&" : "", areaName(operand.area),
                                 widths[static_cast<int>(operand.width)], number);
  const bool isBit = operand.width == Width::Bit && operand.area != Area::T && operand.area != Area::C;
  if (isBit) text += fmt::format(".{}", operand.bit);
  if (operand.reach == nullptr) return text;
  text += fmt::format("@{}", ways[static_cast<int>(operand.reach->way)]);
  if (operand.reach->way == Way::Parameter || operand.reach->way == Way::Handed)
    text += fmt::format("{}", operand.reach->parameter);
  if (operand.reach->way == Way::Pointer) text += fmt::format("[{}]", show7(operand.reach->pointer));
  if (operand.reach->inDi) text += "/DI";
  if (operand.reach->byAr2) text += "/AR2";
  return text;
}

/// Instructions of a network; "!" marks an incomplete one.
inline std::string show7(const Network& network) {
  std::string result = network.complete ? "" : "! ";
  for (const Instruction& instruction : network.instructions) {
    if (&instruction != network.instructions.data()) result += "; ";
    result += instruction.desc->stl;
    for (const Operand& operand : instruction.operands) result += " " + show7(operand);
  }
  return result;
}

inline std::string show7(const Pou& pou) {
  std::string result;
  for (const Network& network : pou.networks) result += (result.empty() ? "" : " | ") + show7(network);
  return result;
}

inline Program read7(const std::string& text, const ReadOptions& options = {}) {
  return readText("x.awl", text, options);
}

/// Statements as an OB 1.
inline Program readOb1(const std::string& statements) {
  return read7("ORGANIZATION_BLOCK OB 1\nBEGIN\nNETWORK\n" + statements + "\nEND_ORGANIZATION_BLOCK\n");
}

}  // namespace rungproof
