// INT001: instructions that an interrupt routine must not run, in the routine or in a subroutine it calls: ENI, DISI,
// HDEF, END, SPA, steps, and the switch of a port to freeport mode. Tested by its examples.
#include <fmt/format.h>

#include "analysis/flow/facts.hpp"
#include "analysis/rule.hpp"

namespace rungproof {

namespace {

bool isStep(Control control) {
  return control == Control::Lscr || control == Control::Scrt || control == Control::ScrEnd ||
         control == Control::ScrEndConditional;
}

/// MOVB of a constant with protocol 01 (freeport) into SMB30 or SMB130 (001:13971).
bool switchesToFreeport(const Instruction& instruction) {
  if (!isMoveOf(*instruction.desc, Type::Byte) || instruction.operands.size() != 2) return false;
  const Operand& value = instruction.operands[0];
  const Operand& port = instruction.operands[1];
  const bool isPort =
      port.kind == OperandKind::Direct && port.area == Area::SM && (port.offset == 30 || port.offset == 130);
  return isPort && value.kind == OperandKind::Constant && (value.value & 3) == 1;
}

void checkInt001(const Facts& facts, FindingSink& sink) {
  for (const InstructionPlace& place : facts.instructions()) {
    const Instruction& instruction = *place.instruction;
    const Pou& pou = facts.program().pous[place.block];
    const bool isRoutine = pou.kind == PouKind::Interrupt;
    if (!isRoutine && !facts.calls().reachedFromInterrupt(place.block)) continue;
    const bool isForbidden = instruction.desc->notInInterrupt || (isRoutine && isStep(instruction.desc->control));
    const bool isFreeport = switchesToFreeport(instruction);
    if (!isForbidden && !isFreeport) continue;
    const std::string where = isRoutine ? fmt::format("the interrupt routine {}", pou.name)
                                        : fmt::format("{}, which an interrupt routine calls", pou.name);
    Finding& finding = sink.report(
        instruction.span,
        isFreeport ? fmt::format("{} switches a port to freeport mode in {}", Facts::text(instruction), where)
                   : fmt::format("{} is not allowed in {}", Facts::text(instruction), where));
    finding.refused = isRoutine && isForbidden;  // what a subroutine does is known at run time only
    finding.help =
        isFreeport
            ? "switch the port in the main program (error 009A, 001:13971)"
            : "do it in the main program, asked for by a bit that the routine sets (001:5426; errors 0004 and 0089)";
  }
}

}  // namespace

extern constexpr Rule int001_not_in_interrupt = {
    .id = "INT001",
    .title = "Instruction not allowed in an interrupt routine",
    .severity = Severity::Error,
    .needs = Needs::Text,
    .detects =
        "DISI, ENI, HDEF, END, SPA, an SCR instruction or the switch to freeport mode in an interrupt routine or in a "
        "subroutine that it calls",
    .why =
        "run-time error 0004 or 009A: the instruction is not executed; the compiler refuses most of them with error "
        "0089",
    .manual = "001:5426, 001:3353, 001:13952, 001:13971",
    .bad =
        "ORGANIZATION_BLOCK MAIN:OB1\nBEGIN\nNetwork 1\nLD SM0.1\nATCH INT0, 0\nENI\nEND_ORGANIZATION_BLOCK\n"
        "INTERRUPT_BLOCK INT_0:INT0\nBEGIN\nNetwork 1\nLD SM0.0\nDISI\nEND_INTERRUPT_BLOCK\n",
    .good =
        "ORGANIZATION_BLOCK MAIN:OB1\nBEGIN\nNetwork 1\nLD SM0.1\nATCH INT0, 0\nENI\nNetwork 2\nLD M0.0\nR M0.0, "
        "1\nDTCH 0\nEND_ORGANIZATION_BLOCK\n"
        "INTERRUPT_BLOCK INT_0:INT0\nBEGIN\nNetwork 1\nLD SM0.0\nS M0.0, 1\nEND_INTERRUPT_BLOCK\n",
    .dialects = dialect::S7200,
    .refuses = true,
    .check = checkInt001,
};

}  // namespace rungproof
