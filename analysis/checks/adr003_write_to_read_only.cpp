// ADR003: a write to memory that the program cannot write: SM0 to SM29, analogue inputs, fast counter values.
// Tested by its examples and tests/rules/address_rules_test.cpp.
#include <fmt/format.h>

#include "analysis/flow/facts.hpp"
#include "analysis/rule.hpp"
#include "ir/s7200/special_memory.hpp"

namespace rungproof {

namespace {

void checkAdr003(const Facts& facts, FindingSink& sink) {
  std::uint32_t lastInstruction = ~0U;
  std::uint8_t lastOperand = 0;
  for (const Access& access : facts.accesses().all()) {
    if (!access.write || access.maybe || access.viaPointer || access.operand == impliedOperand) continue;
    const bool isStatus = access.area == Area::SM && !smRow(facts.target(), access.offset, 0).isWritable();
    if (!isStatus && !isReadOnlyArea(access.area)) continue;
    if (access.instruction == lastInstruction && access.operand == lastOperand) continue;
    lastInstruction = access.instruction;
    lastOperand = access.operand;
    const Instruction& instruction = facts.instruction(access.instruction);
    const Operand& operand = instruction.operands[access.operand];
    const std::string_view reason = isStatus                  ? "SM0.0 to SM29.7 are read-only (001:2652)"
                                    : access.area == Area::AI ? "analogue inputs are read-only (001:2647)"
                                                              : "the value of a fast counter is read-only (001:1336)";
    Finding& finding = sink.report(
        operand.span, fmt::format("{} writes {}, but {}", Facts::text(instruction), toString(operand), reason));
    finding.address = toString(operand);
    finding.help = access.area == Area::HC ? "load the new current value through its SM double word and HSC (001:4308)"
                                           : "write to M or V memory instead";
  }
}

}  // namespace

extern constexpr Rule adr003_write_to_read_only = {
    .id = "ADR003",
    .title = "Write to read-only memory",
    .severity = Severity::Error,
    .needs = Needs::Text,
    .detects = "an instruction that writes SM0.0-SM29.7, an analogue input word or a fast counter value",
    .why = "tables 6-1 and 6-2 mark these as read-only: the value would not arrive, or the download is refused",
    .manual = "001:2647, 001:2652, 001:1336",
    .bad = "Network 1\nLD I0.0\n= SM0.5\n",
    .good = "Network 1\nLD I0.0\n= SM30.0\n",
    .peers = "Omron read-only areas; SA0037 (nearest)",
    .dialects = dialect::S7200,
    .refuses = true,
    .standsAlone = true,
    .check = checkAdr003,
};

}  // namespace rungproof
