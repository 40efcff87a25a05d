// PTR002: a pointer that stands where none may stand, points where none may point, or is never set.
// Tested by its examples and tests/rules/data_rules_test.cpp.
#include <fmt/format.h>

#include "analysis/flow/dataflow_pointers.hpp"
#include "analysis/flow/operand_check.hpp"
#include "analysis/rule.hpp"

namespace rungproof {

namespace {

void checkUse(FindingSink& sink, const Instruction& instruction, const Operand& operand) {
  if (operand.kind == OperandKind::Indirect && !pointerMayStandThere(operand)) {
    Finding& finding =
        sink.report(operand.span, fmt::format("{} in {}: a pointer may stand in V or L memory or in AC1 to AC3 only",
                                              toString(operand), Facts::text(instruction)));
    finding.address = toString(operand);
    finding.help = "move the address to one of these places (001:1459)";
  }
  if (operand.kind != OperandKind::Address) return;
  const bool isBadArea = !mayBePointedTo(operand.area);
  const bool isBit = operand.width == Width::Bit && !hasBitAndWord(operand.area);
  if (!isBadArea && !isBit) return;
  Finding& finding = sink.report(
      operand.span,
      fmt::format("{} takes the address of {}; pointers cannot point there", Facts::text(instruction),
                  isBadArea ? fmt::format("area {}", areaName(operand.area)) : std::string("a single bit")));
  finding.address = toString(operand);
  finding.help = "pointers name bytes of I, Q, V, M, S, AI, AQ, SM and the values of T and C (001:1461)";
}

/// The pointer is used, and nothing that could make an address writes it.
void checkUnset(const Facts& facts, FindingSink& sink, const Pointer& pointer) {
  if (pointer.isSet || pointer.uses.empty()) return;
  const Access& access = *pointer.uses.front();
  const Instruction& instruction = facts.instruction(access.instruction);
  Finding& finding = sink.report(
      instruction.operands[access.operand].span,
      fmt::format("{} in {} is used, but nothing makes the pointer", accessName(access), Facts::text(instruction)));
  finding.address = accessName(access);
  finding.refused = false;  // the editor takes it; the access is a run-time error
  finding.help = "set it by MOVD &address first (001:1459)";
}

void checkPtr002(const Facts& facts, FindingSink& sink) {
  for (const OperandKind kind : {OperandKind::Indirect, OperandKind::Address}) {
    for (const std::uint32_t id : facts.withOperand(kind)) {
      const Instruction& instruction = facts.instruction(id);
      for (const Operand& operand : instruction.operands) {
        if (operand.kind == kind) checkUse(sink, instruction, operand);
      }
    }
  }
  if (facts.hasHiddenCode() || facts.withOperand(OperandKind::Indirect).empty()) return;
  const PointerTable& pointers = facts.pointers();
  for (const Pointer& pointer : pointers.all()) checkUnset(facts, sink, pointer);
}

}  // namespace

extern constexpr Rule ptr002_pointer_misused = {
    .id = "PTR002",
    .title = "Pointer misused",
    .severity = Severity::Error,
    .needs = Needs::Flow,
    .detects =
        "a pointer that is used though nothing sets it, that is kept elsewhere than in V, L or AC1-AC3, or that is "
        "aimed at HC, L, an accumulator or a single bit",
    .why =
        "the editor does not take it; a pointer that nothing sets is run-time error 0006, in a comparison the fatal "
        "error 0011",
    .manual = "001:1459-1461, 001:13954",
    .bad = "Network 1\nLD SM0.0\nMOVD &VB100, AC0\nMOVW *AC0, VW0\n",
    .good = "Network 1\nLD SM0.0\nMOVD &VB100, AC1\nMOVW *AC1, VW0\n",
    .peers = "SA0145 (nearest)",
    .dialects = dialect::S7200,
    .refuses = true,
    .check = checkPtr002,
};

}  // namespace rungproof
