// DBA005: an instance data block that no call uses. Tested by its examples and tests/rules/data_block_rules_test.cpp.
#include <fmt/format.h>

#include <set>

#include "analysis/flow/open_blocks.hpp"
#include "analysis/flow/step7_blocks.hpp"
#include "analysis/rule.hpp"
#include "ir/block_map.hpp"
#include "ir/s7300/block.hpp"

namespace rungproof {

namespace {

void checkDba005(const Facts& facts, FindingSink& sink) {
  if (facts.hasHiddenCode()) return;
  std::set<std::uint32_t> used;
  for (const InstructionPlace& place : facts.instructions()) {
    const Instruction& instruction = *place.instruction;
    const StatementRole role = statementRole(instruction);
    if (role != StatementRole::Call && role != StatementRole::OpenBlock) continue;
    for (const Operand& operand : instruction.operands) {
      if (role == StatementRole::OpenBlock && operand.kind != OperandKind::Direct) return;  // any block
      if (operand.kind == OperandKind::Direct && operand.area == Area::DB) used.insert(blockOfByte(operand.offset));
    }
  }
  for (const DataBlock& block : facts.program().dataBlocks) {
    if (block.instanceOf == 0 || used.contains(block.number)) continue;
    const Pou* owner = facts.program().subroutine(block.instanceOf);
    Finding& finding =
        sink.report(block.span, fmt::format("DB{} is an instance of {}, but no call uses it", block.number,
                                            owner != nullptr ? owner->name : blockName(block.instanceOf)));
    finding.address = fmt::format("DB{}", block.number);
    finding.help = "remove it, or call the block with it";
  }
}

}  // namespace

extern constexpr Rule dba005_instance_not_used = {
    .id = "DBA005",
    .title = "Instance data block without a call",
    .severity = Severity::Warning,
    .needs = Needs::Text,
    .detects = "an instance data block that no CALL names and no OPN opens",
    .why = "what others read from it never changes: usually the call has another number, or has been removed",
    .manual = "002:161-169",
    .bad =
        "FUNCTION_BLOCK FB 1\nVAR\nX : INT;\nEND_VAR\nBEGIN\nNETWORK\nL 1;\nT #X;\nEND_FUNCTION_BLOCK\n"
        "DATA_BLOCK DB 1\nFB 1\nBEGIN\nEND_DATA_BLOCK\nDATA_BLOCK DB 2\nFB 1\nBEGIN\nEND_DATA_BLOCK\n"
        "ORGANIZATION_BLOCK OB 1\nBEGIN\nNETWORK\nCALL FB 1, DB 1;\nEND_ORGANIZATION_BLOCK\n",
    .good =
        "FUNCTION_BLOCK FB 1\nVAR\nX : INT;\nEND_VAR\nBEGIN\nNETWORK\nL 1;\nT #X;\nEND_FUNCTION_BLOCK\n"
        "DATA_BLOCK DB 1\nFB 1\nBEGIN\nEND_DATA_BLOCK\nORGANIZATION_BLOCK OB 1\nBEGIN\nNETWORK\nCALL FB 1, DB 1;\n"
        "END_ORGANIZATION_BLOCK\n",
    .exampleCpu = "319-3",
    .dialects = dialect::S7300,
    .surplus = true,
    .check = checkDba005,
};

}  // namespace rungproof
