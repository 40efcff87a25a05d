// ADR008: LB60 to LB63 used by the program. Micro/WIN keeps the power flow of calls there: `= L60.0`, `= L63.7`,
// `LD L60.0`, CALL with L63.7 in one network are its own work (001:6809). Tested by tests/rules/address_rules_test.cpp.
#include <fmt/format.h>

#include <array>

#include "analysis/drawing/lower.hpp"
#include "analysis/flow/facts.hpp"
#include "analysis/rule.hpp"

namespace rungproof {

namespace {

constexpr std::uint32_t firstReserved = 60;

bool isReserved(const Access& access) {
  return access.area == Area::L && !access.viaPointer && access.offset + access.certainLength() > firstReserved &&
         access.operand != impliedOperand;
}

/// What the editor writes: a bit stored by = and read in the same network by LD or as a parameter.
bool isEditorForm(const Facts& facts, const Access& access) {
  if (access.width != Width::Bit || access.offset < firstReserved) return false;
  const Role role = roleOf(facts.instruction(access.instruction));
  const bool isCall = facts.instruction(access.instruction).desc->control == Control::Call;
  return isCall || (access.write ? role == Role::Assign : role == Role::Load);
}

void checkAdr008(const Facts& facts, FindingSink& sink) {
  std::array<const Network*, 32> storedIn{};  // by bit: network of the last =
  std::uint32_t reported = ~0U;
  for (const Access& access : facts.accesses().all()) {
    if (!isReserved(access) || access.instruction == reported) continue;
    const Network& here = facts.networkOf(access.instruction);
    if (here.drawing != nullptr && editorBitsUsed(*here.drawing) == 0) continue;  // what stands there was lowered
    const bool isBit =
        access.width == Width::Bit && access.offset >= firstReserved && access.offset < 64 && access.bit < 8;
    const Network** stored = isBit ? &storedIn[(access.offset - firstReserved) * 8 + access.bit] : nullptr;
    const bool isEditors = stored != nullptr && isEditorForm(facts, access) && (access.write || *stored == &here);
    if (stored != nullptr && access.write) *stored = &here;
    if (isEditors) continue;
    const Instruction& instruction = facts.instruction(access.instruction);
    const Operand& operand = instruction.operands[access.operand];
    Finding& finding = sink.report(
        operand.span, fmt::format("{} uses {}; LB60 to LB63 belong to Micro/WIN when a program is shown as LAD or FBD",
                                  Facts::text(instruction), toString(operand)));
    finding.address = toString(operand);
    finding.help = "use LB0 to LB59 (001:1364, 001:2672)";
    reported = access.instruction;
  }
  for (const Pou& pou : facts.program().pous) {
    for (const LocalVariable& local : pou.locals) {
      const std::uint32_t end = local.address.offset + static_cast<std::uint32_t>(bytes(local.address.width));
      if (local.address.area != Area::L || end <= firstReserved) continue;
      Finding& finding = sink.report(
          local.span, fmt::format("local variable {} of {} lies at {}, in the bytes that belong to Micro/WIN",
                                  local.name, pou.name, toString(local.address)));
      finding.address = toString(local.address);
      finding.help = "a block has 60 bytes for its own variables (001:1362-1364)";
    }
  }
}

}  // namespace

extern constexpr Rule adr008_editor_local_bytes = {
    .id = "ADR008",
    .title = "Local bytes reserved by the editor",
    .severity = Severity::Warning,
    .needs = Needs::Text,
    .detects =
        "use of LB60-LB63 other than the stores and loads that Micro/WIN itself makes around a CALL drawn as ladder",
    .why =
        "the last four local bytes belong to Micro/WIN when the program is shown as LAD or FBD: it stores the power "
        "flow of calls there",
    .manual = "001:1364, 001:2672, 001:6809",
    .bad = "Network 1\nLD SM0.0\nMOVB VB0, LB62\n",
    .good = "Network 1\nLD SM0.0\nMOVB VB0, LB10\n",
    .falsePositives = "a program that is never shown as LAD or FBD may use all 64 bytes",
    .dialects = dialect::S7200,
    .standsAlone = true,
    .check = checkAdr008,
};

}  // namespace rungproof
