// ADR002: an operand of an area, width or kind that the instruction does not take. The lists are those of the
// descriptors (ir/s7200/isa), which tests compare with the manual's operand tables. Writes to read-only areas are
// ADR003, reads of AQ are ADR004. Tested by tests/rules/operand_rules_test.cpp.
#include <fmt/format.h>

#include <algorithm>

#include "analysis/flow/facts.hpp"
#include "analysis/flow/operand_check.hpp"
#include "analysis/rule.hpp"

namespace rungproof {

namespace {

bool isSpokenByOthers(const OperandDesc& desc, const Operand& operand) {
  const bool isPlace = desc.type != Type::Label && desc.type != Type::Subroutine && desc.type != Type::Interrupt;
  if (operand.kind != OperandKind::Direct || !isPlace) return false;
  const bool writesReadOnly = desc.direction != Direction::In && isReadOnlyArea(operand.area);
  const bool readsOutput = desc.direction == Direction::In && operand.area == Area::AQ;
  return writesReadOnly || readsOutput;
}

/// "a direct address of the M area", "a constant": what stands there.
std::string formText(const Operand& operand) {
  switch (operand.kind) {
    case OperandKind::Direct: return fmt::format("area {}", areaName(operand.area));
    case OperandKind::Indirect: return "a pointer";
    case OperandKind::Address: return "an address with &";
    case OperandKind::Constant: return "a constant";
    default: return "a text";
  }
}

void checkForm(const Facts& facts, FindingSink& sink, const Instruction& instruction, const OperandDesc& desc,
               const Operand& operand) {
  const auto report = [&](std::string message) {
    Finding& finding = sink.report(operand.span, std::move(message));
    finding.address = toString(operand);
    finding.help = fmt::format("{} of {} takes {} ({})", desc.name, instruction.desc->stl, allowedForms(desc),
                               instruction.desc->manual);
  };
  if (isSpokenByOthers(desc, operand)) return;
  if (!formIsAllowed(desc, operand)) {
    // The letters of a text are those of the source, not of the controller.
    const std::string written = operand.kind == OperandKind::Text
                                    ? std::string(facts.program().sources->file(operand.span.file).text(operand.span))
                                    : toString(operand);
    report(fmt::format("{} does not take {} as {}: {} is not allowed there{}", instruction.desc->stl, written,
                       desc.name, formText(operand),
                       written.starts_with('"') ? ", and no name of a symbol is written so" : ""));
  } else if (!widthIsAllowed(desc, operand)) {
    report(fmt::format("{} needs {} as {}, but {} is {}", instruction.desc->stl, widthName(widthOf(desc.type)),
                       desc.name, toString(operand), widthName(operand.width)));
  } else if (!notationIsAllowed(desc, operand)) {
    const std::string_view wanted = desc.type == Type::Real     ? "a real number such as 5.0"
                                    : desc.type == Type::String ? "a text in double quotes"
                                                                : "a whole number";
    report(fmt::format("{} needs {} as {}, not {}", instruction.desc->stl, wanted, desc.name, toString(operand)));
  } else if (operand.kind == OperandKind::Address && facts.target().edition == Edition::Edition2003 &&
             (operand.area == Area::SM || isAnalogue(operand.area))) {
    report(fmt::format(
        "{} in {} is not in the operand list of the 2003 edition (000:7587), only in that of 2004 (001:5619)",
        toString(operand), instruction.desc->stl));
  }
}

void checkAdr002(const Facts& facts, FindingSink& sink) {
  for (const InstructionPlace& place : facts.instructions()) {
    const Instruction& instruction = *place.instruction;
    const std::size_t count = std::min<std::size_t>(instruction.operands.size(), instruction.desc->operandCount);
    for (std::size_t i = 0; i < count; ++i) {
      const OperandDesc& desc = instruction.desc->operands[i];
      if (desc.type != Type::Parameter) checkForm(facts, sink, instruction, desc, instruction.operands[i]);
    }
  }
}

}  // namespace

extern constexpr Rule adr002_operand_not_allowed = {
    .id = "ADR002",
    .title = "Area or width not allowed here",
    .severity = Severity::Error,
    .needs = Needs::Text,
    .detects =
        "an operand whose area, width or kind of constant is not in the operand list of its instruction: an immediate "
        "contact on anything "
        "but I, an immediate coil on anything but Q, a constant as an output, a byte where a word is due",
    .why = "each instruction has its own list of operands; the download is refused with error 0090",
    .manual = "001:2747-2752, 001:2808-2813, 001:13996",
    .bad = "Network 1\nLD I0.0\n=I M0.0\n",
    .good = "Network 1\nLD I0.0\n=I Q0.0\n",
    .peers = "SA0005; Omron operand data types and operand ranges",
    .dialects = dialect::S7200,
    .refuses = true,
    .standsAlone = true,
    .check = checkAdr002,
};

}  // namespace rungproof
