// The page of an instruction. Pinned by tests/golden/explain.
#include "frontend/explain/instruction_page.hpp"

#include <fmt/core.h>

#include "frontend/text/columns.hpp"
#include "ir/dialect.hpp"
#include "ir/manual.hpp"
#include "ir/s7200/cpu.hpp"

namespace rungproof {

namespace {

std::string_view typeText(Type type) {
  switch (type) {
    case Type::Bool: return "BOOL";
    case Type::Byte: return "BYTE";
    case Type::Word: return "WORD";
    case Type::Int: return "INT";
    case Type::DWord: return "DWORD";
    case Type::DInt: return "DINT";
    case Type::Real: return "REAL";
    case Type::String: return "STRING";
    case Type::Timer: return "timer number";
    case Type::Counter: return "counter number";
    case Type::Label: return "label number";
    case Type::Subroutine: return "subroutine number";
    case Type::Interrupt: return "interrupt routine number";
    default: return "actual parameter";
  }
}

std::string_view directionText(Direction direction) {
  return direction == Direction::In ? "in" : direction == Direction::Out ? "out" : "in and out";
}

std::string_view executionText(Execution execution) {
  switch (execution) {
    case Execution::Stack: return "always; works on the logic stack";
    case Execution::Compare: return "always, even without power flow; errors in it are fatal";
    case Execution::Coil: return "always; copies the top of the stack";
    case Execution::Conditional: return "only with power flow";
    case Execution::Sampled: return "always; takes stack levels as data";
    default: return "moves the flow of the program";
  }
}

std::string cpusText(CpuSet cpus) {
  if (cpus == everyCpu) return "all";
  std::string text;
  for (const Dialect* dialect : dialects()) {
    for (const CpuModel& model : dialect->cpus) {
      if ((cpus & cpuBit(model.cpu)) != 0) text += fmt::format("{}{}", text.empty() ? "" : ", ", model.name);
    }
  }
  return text;
}

std::string rangesText(const OperandDesc& operand) {
  std::string text;
  for (const ValueRange& range : operand.ranges) {
    if (range.cpus == 0) continue;
    text += fmt::format("{}{} to {}", text.empty() ? "" : "; ", range.low, range.high);
    if (range.cpus != everyCpu) text += fmt::format(" ({})", cpusText(range.cpus));
  }
  return text;
}

std::string statusText(StatusBits bits) {
  std::string text;
  for (int i = 0; i < 8; ++i) {
    if ((bits >> i & 1) != 0) text += fmt::format("{}SM1.{}", text.empty() ? "" : ", ", i);
  }
  return text;
}

}  // namespace

std::string formsText(Forms forms) {
  std::string text;
  const auto add = [&](std::string_view name) { text += fmt::format("{}{}", text.empty() ? "" : ", ", name); };
  for (int i = 0; i < areaCount; ++i) {
    if ((forms & form::area(static_cast<Area>(i))) != 0) add(areaName(static_cast<Area>(i)));
  }
  if ((forms & form::PtrV) != 0) add("*VD");
  if ((forms & form::PtrL) != 0) add("*LD");
  if ((forms & form::PtrAC) != 0) add("*AC");
  if ((forms & form::Const) != 0) add("constant");
  if ((forms & form::Address) != 0) add("&address");
  return text;
}

std::string instructionPage(const Desc& desc, const Paint& paint) {
  std::string text = fmt::format("{}: {}\n\n", paint.bold(desc.stl), desc.meaning);
  std::vector<TextRow> rows;
  if (!desc.german.empty() && desc.german != desc.stl) rows.push_back({"German", std::string(desc.german)});
  rows.push_back({"Group", std::string(desc.group)});
  rows.push_back({"Executed", std::string(executionText(desc.execution))});
  rows.push_back({"CPUs", cpusText(desc.cpus)});
  if (desc.since2004) rows.push_back({"Since", "edition 2004"});
  if (desc.olderDialectOnly) rows.push_back({"Written in", "the one-text dialect of the S7-212/214 only"});
  if (desc.drawingOnly) rows.push_back({"Written in", "LAD and FBD only"});
  if (desc.notInInterrupt) rows.push_back({"Not allowed", "in interrupt routines"});
  if (desc.affects != 0) rows.push_back({"Changes", statusText(desc.affects)});
  if (desc.time != 0) rows.push_back({"Time", fmt::format("{:g} us with power flow", desc.time / 100.0)});
  if (!desc.manual.empty()) rows.push_back({"Manual", manualPlace(desc.manual)});
  appendRows(text, rows, 16);
  if (desc.operandCount == 0) return text;
  text += fmt::format("\n  {}\n", paint.bold("Operands"));
  for (int i = 0; i < desc.operandCount; ++i) {
    const OperandDesc& operand = desc.operand(i);
    std::string line =
        fmt::format("{} ({}, {}{}): {}", operand.name, directionText(operand.direction), typeText(operand.type),
                    operand.optional ? ", may be left out" : "", formsText(operand.forms));
    if (operand.hasRanges()) line += fmt::format("; {}", rangesText(operand));
    appendParagraph(text, line, 4);
  }
  return text;
}

Json instructionJson(const Desc& desc) {
  Json json = {{"stl", desc.stl},     {"german", desc.german}, {"meaning", desc.meaning},
               {"group", desc.group}, {"manual", desc.manual}, {"cpus", cpusText(desc.cpus)}};
  json["operands"] = Json::array();
  for (int i = 0; i < desc.operandCount; ++i) {
    const OperandDesc& operand = desc.operand(i);
    json["operands"].push_back({{"name", operand.name},
                                {"direction", directionText(operand.direction)},
                                {"type", typeText(operand.type)},
                                {"forms", formsText(operand.forms)},
                                {"ranges", rangesText(operand)}});
  }
  return json;
}

}  // namespace rungproof
