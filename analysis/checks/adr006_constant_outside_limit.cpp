// ADR006: a constant outside the limits of its operand. Ranges that hold on every CPU and the limits of the types
// come from the descriptors; ranges that differ by CPU are ADR009, numbers of timers TIM003.
// Tested by tests/rules/operand_rules_test.cpp.
#include <fmt/format.h>

#include <algorithm>

#include "analysis/flow/facts.hpp"
#include "analysis/flow/operand_check.hpp"
#include "analysis/rule.hpp"

namespace rungproof {

namespace {

/// Width of what a shift moves: the bits of its first operand.
int shiftedBits(const Instruction& instruction) { return bits(widthOf(instruction.desc->operands[0].type)); }

void checkConstant(const Facts& facts, FindingSink& sink, const Instruction& instruction, std::size_t i) {
  const OperandDesc& desc = instruction.desc->operands[i];
  const Operand& operand = instruction.operands[i];
  if (operand.kind != OperandKind::Constant || operand.form == ConstantForm::Real || !notationIsAllowed(desc, operand))
    return;
  const Role role = roleOf(instruction);
  const std::int64_t value = role == Role::Shrb ? signedByteValue(operand.value) : operand.value;
  const auto report = [&](std::string message) -> Finding& {
    Finding& finding = sink.report(operand.span, std::move(message));
    finding.address = toString(operand);
    return finding;
  };
  if (desc.hasRanges()) {
    const Cpu cpu = facts.target().cpu;
    if ((instruction.desc->cpus & cpuBit(cpu)) == 0) return;
    // Some CPU of the family has it: ADR009 asks whether this one has.
    if (valueIsInRange(desc, value, seriesOf(cpu))) return;
    const std::string limits = rangesText(desc, cpu);
    report(fmt::format("{} of {} must be {}, not {}", desc.name, Facts::text(instruction), limits, operand.value))
        .help = fmt::format("the limit stands with the instruction ({}); error 0092 or 0090 at download",
                            instruction.desc->manual);
    return;
  }
  const std::optional<TypeLimits> limits = typeLimits(desc.type);
  if (limits && (value < limits->low || value > limits->high)) {
    report(fmt::format("{} of {} does not hold {}: {} has {} bits", desc.name, Facts::text(instruction),
                       toString(operand), widthName(widthOf(desc.type)), bits(widthOf(desc.type))))
        .help = "use a smaller constant or a wider instruction";
    return;
  }
  if (role == Role::Shift && i == 1 && value >= shiftedBits(instruction)) {
    Finding& finding = report(fmt::format("{} shifts {} bits by {}: nothing of the value is left",
                                          Facts::text(instruction), shiftedBits(instruction), value));
    finding.severity = Severity::Warning;
    finding.help = "the count is cut to the width (001:5925); use MOV with 0 if the value is to be cleared";
  }
  const bool isIndex = role == Role::StringConvert || role == Role::StringPart;
  if (isIndex && i == 1 && value == 0) {
    report(fmt::format("INDX of {} is 0; characters of a string are counted from 1", Facts::text(instruction))).help =
        "error 009B (001:14005)";
  }
}

constexpr std::size_t longestText = 126;  ///< of a constant; a string in memory may have 254 (001:1414)

/// Characters of a text, at least: $ begins one that is written by two or three.
std::size_t charactersOf(std::string_view text) {
  const auto isBeginning = [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80; };
  const auto count = static_cast<std::size_t>(std::ranges::count_if(text, isBeginning));
  const auto escapes = static_cast<std::size_t>(std::ranges::count(text, '$'));
  return count - std::min(count, escapes * 2);
}

void checkText(FindingSink& sink, const Instruction& instruction, const Operand& operand) {
  if (operand.kind != OperandKind::Text || charactersOf(operand.text) <= longestText) return;
  Finding& finding =
      sink.report(operand.span, fmt::format("the text of {} has {} characters; a constant has at most {}",
                                            instruction.desc->stl, charactersOf(operand.text), longestText));
  finding.help = "write it in two parts with SCPY and SCAT, or into the data block (001:1414)";
}

void checkAdr006(const Facts& facts, FindingSink& sink) {
  for (const std::uint32_t id : facts.withOperand(OperandKind::Text)) {
    const Instruction& instruction = facts.instruction(id);
    for (const Operand& operand : instruction.operands) checkText(sink, instruction, operand);
  }
  for (const std::uint32_t id : facts.withOperand(OperandKind::Constant)) {
    const Instruction& instruction = facts.instruction(id);
    const std::size_t count = std::min<std::size_t>(instruction.operands.size(), instruction.desc->operandCount);
    for (std::size_t i = 0; i < count; ++i) checkConstant(facts, sink, instruction, i);
  }
}

}  // namespace

extern constexpr Rule adr006_constant_outside_limit = {
    .id = "ADR006",
    .title = "Constant outside its own limit",
    .severity = Severity::Error,
    .needs = Needs::Text,
    .detects =
        "a constant that its operand does not take: N of S and R not 1-255, of SI and RI not 1-128, SHRB longer than "
        "64, FILL and block moves "
        "not 1-255, label above 255, PID loop above 7, depth of LDS above 8, string index 0; a constant too large for "
        "its type; a text of more than 126 characters; a shift count that leaves nothing",
    .why = "the limits stand with each instruction; the download is refused with error 0092",
    .manual = "001:2789, 001:2800, 001:6024, 001:6385, 001:2665, 001:2669, 001:2859, 001:5925, 001:1414, 001:13998",
    .bad = "Network 1\nLD I0.0\nSI Q0.0, 200\n",
    .good = "Network 1\nLD I0.0\nSI Q0.0, 8\n",
    .peers = "Omron constants; SA0056; SA0053 for the shift count",
    .dialects = dialect::S7200,
    .refuses = true,
    .standsAlone = true,
    .check = checkAdr006,
};

}  // namespace rungproof
