// DBA006: a read-only data block is written, or one that is not loaded is used.
// Tested by its examples and tests/rules/data_block_rules_test.cpp.
#include <fmt/format.h>

#include <map>

#include "analysis/flow/open_blocks.hpp"
#include "analysis/flow/step7_blocks.hpp"
#include "analysis/rule.hpp"
#include "ir/block_map.hpp"

namespace rungproof {

namespace {

void checkDba006(const Facts& facts, FindingSink& sink) {
  std::map<std::uint32_t, const DataBlock*> guarded;
  for (const DataBlock& block : facts.program().dataBlocks) {
    if (block.readOnly || block.unlinked) guarded.emplace(block.number, &block);
  }
  if (guarded.empty()) return;
  eachReadStretch(facts, [&](std::uint32_t, const Flow& flow) {
    const OpenStates states = openStates(facts.program(), flow);
    for (std::uint32_t at = 0; at < flow.steps.size(); ++at) {
      if (!states[at]) continue;
      const Instruction& instruction = *flow.steps[at].instruction;
      for (const Access& access : facts.accesses().of(instruction.id)) {
        if (access.operand >= instruction.operands.size()) continue;
        const Operand& operand = instruction.operands[access.operand];
        const bool inOpen = operand.reach != nullptr && operand.reach->way == Way::OpenBlock;
        if (!isFullAddress(operand) && !inOpen) continue;
        const OpenBlock& open = inOpen && operand.reach->inDi ? states[at]->di : states[at]->db;
        const auto found = guarded.find(inOpen ? open.number : blockOfByte(operand.offset));
        if (found == guarded.end() || (inOpen && open.by != openedHere)) continue;
        const DataBlock& block = *found->second;
        if (!block.unlinked && (!access.write || access.maybe)) continue;
        Finding& finding = sink.report(
            operand.span,
            block.unlinked ? fmt::format("{} uses DB{}, which is not loaded into the work memory",
                                         Facts::text(instruction), block.number)
                           : fmt::format("{} writes DB{}, which is read-only", Facts::text(instruction), block.number));
        finding.address = toString(operand);
        finding.related.push_back({block.span, "the data block"});
        finding.help = block.unlinked ? "copy what is needed with SFC 20 into a block that is loaded"
                                      : "write into another block, or remove READ_ONLY";
        break;
      }
    }
  });
}

}  // namespace

extern constexpr Rule dba006_block_not_writable = {
    .id = "DBA006",
    .title = "Read-only or unlinked data block used",
    .severity = Severity::Error,
    .needs = Needs::Flow,
    .detects = "a write into a data block with READ_ONLY; any access to one with UNLINKED",
    .why = "a synchronous error: OB121 runs, and without it the CPU goes to STOP",
    .manual = "002:537-563, 002:1284-1290",
    .bad =
        "DATA_BLOCK DB 1\nREAD_ONLY\nSTRUCT\nX : INT;\nEND_STRUCT;\nBEGIN\nEND_DATA_BLOCK\nORGANIZATION_BLOCK OB 1\n"
        "BEGIN\nNETWORK\nL IW 0;\nT DB1.DBW 0;\nEND_ORGANIZATION_BLOCK\n",
    .good =
        "DATA_BLOCK DB 1\nREAD_ONLY\nSTRUCT\nX : INT;\nEND_STRUCT;\nBEGIN\nEND_DATA_BLOCK\nORGANIZATION_BLOCK OB 1\n"
        "BEGIN\nNETWORK\nL DB1.DBW 0;\nT QW 0;\nEND_ORGANIZATION_BLOCK\n",
    .exampleCpu = "319-3",
    .dialects = dialect::S7300,
    .check = checkDba006,
};

}  // namespace rungproof
