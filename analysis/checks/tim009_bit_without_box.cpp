// TIM009: a contact on, or the value of, a timer or counter that has no box. Tested by its examples.
#include <fmt/format.h>

#include <array>
#include <map>
#include <set>

#include "analysis/flow/facts.hpp"
#include "analysis/rule.hpp"
#include "ir/s7300/statement_role.hpp"

namespace rungproof {

namespace {

/// S7-300/400: a timer or counter that no statement starts, counts or sets. Nothing where numbers are computed.
void checkElements(const Facts& facts, FindingSink& sink) {
  std::set<std::pair<Area, std::uint32_t>> worked;
  std::map<std::pair<Area, std::uint32_t>, const Instruction*> read;
  for (const InstructionPlace& place : facts.instructions()) {
    const Instruction& instruction = *place.instruction;
    const StatementRole role = statementRole(instruction);
    const bool isCall = instruction.desc->control == Control::BlockCall;
    for (const Operand& operand : instruction.operands) {
      if (!hasBitAndWord(operand.area) || !operand.isMemory()) continue;
      const bool isParameter = operand.reach != nullptr && operand.reach->way == Way::Parameter;
      if (operand.kind == OperandKind::Indirect && !isParameter) return;
      if (operand.kind != OperandKind::Direct) continue;
      const std::pair element(operand.area, operand.offset);
      const bool ends = role == StatementRole::ResetTimer || role == StatementRole::ResetCounter;
      if (remembersRlo(role) || isCall) {
        worked.insert(element);
      } else if (!ends) {
        read.emplace(element, &instruction);
      }
    }
  }
  for (const auto& [element, instruction] : read) {
    if (worked.contains(element)) continue;
    const Operand& operand = instruction->operands[0];
    Finding& finding = sink.report(
        operand.span, fmt::format("{} reads {}, but nothing {} it", Facts::text(*instruction), facts.name(operand),
                                  element.first == Area::T ? "starts" : "counts or sets"));
    finding.address = toString(operand);
    finding.help = "correct the number, or add the statement; without it bit and value stay 0";
  }
}

void checkTim009(const Facts& facts, FindingSink& sink) {
  if (facts.hasHiddenCode()) return;
  if (facts.form() == StatementForm::Accumulators) return checkElements(facts, sink);
  std::array<bool, 512> reported{};
  for (const Access& access : facts.accesses().all()) {
    const bool isTimer = access.area == Area::T;
    if ((!isTimer && access.area != Area::C) || access.write || access.viaPointer || access.maybe ||
        access.offset >= 256)
      continue;
    if (access.operand == impliedOperand ||
        !(isTimer ? facts.timerBoxes(access.offset) : facts.counterBoxes(access.offset)).empty())
      continue;
    const std::uint32_t cell = facts.cellOf(access);
    if (cell == facts.index().cells().size() || facts.index().isWrittenAtLarge(cell) || facts.isExternal(cell) ||
        facts.writers(cell, 0) > 0)
      continue;
    bool& isDone = reported[access.offset + (isTimer ? 0 : 256)];
    if (isDone) continue;
    isDone = true;
    const Instruction& instruction = facts.instruction(access.instruction);
    const Operand& operand = instruction.operands[access.operand];
    Finding& finding = sink.report(
        operand.span, fmt::format("{} reads {}, but the program has no {} box with that number",
                                  Facts::text(instruction), facts.name(operand), isTimer ? "timer" : "counter"));
    finding.address = toString(operand);
    finding.help = "correct the number, or add the box; without it bit and value stay 0";
  }
}

}  // namespace

extern constexpr Rule tim009_bit_without_box = {
    .id = "TIM009",
    .title = "Bit read without a box",
    .severity = Severity::Warning,
    .needs = Needs::Text,
    .detects =
        "a contact or value of a T or C number whose box does not exist; S7-300/400: that no statement starts, "
        "counts or sets",
    .why = "it is always 0, usually because of a wrong number",
    .manual = "001:1309-1329",
    .bad = "Network 1\nLD I0.0\nTON T37, +10\nNetwork 2\nLD T38\n= Q0.0\n",
    .good = "Network 1\nLD I0.0\nTON T37, +10\nNetwork 2\nLD T37\n= Q0.0\n",
    .check = checkTim009,
};

}  // namespace rungproof
