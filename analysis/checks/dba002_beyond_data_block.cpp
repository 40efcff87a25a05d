// DBA002: an access behind the last byte of its data block.
// Tested by its examples and tests/rules/data_block_rules_test.cpp.
#include <fmt/format.h>

#include "analysis/flow/open_blocks.hpp"
#include "analysis/flow/step7_blocks.hpp"
#include "analysis/rule.hpp"
#include "ir/block_map.hpp"

namespace rungproof {

namespace {

void checkDba002(const Facts& facts, FindingSink& sink) {
  const BlockMap& blocks = *facts.plan().blocks;
  eachReadStretch(facts, [&](std::uint32_t, const Flow& flow) {
    const OpenStates states = openStates(facts.program(), flow);
    for (std::uint32_t at = 0; at < flow.steps.size(); ++at) {
      if (!states[at]) continue;
      const Instruction& instruction = *flow.steps[at].instruction;
      eachDataOperand(facts.program(), instruction, [&](const Operand& operand, bool isParameter) {
        const bool inOpen = operand.reach != nullptr && operand.reach->way == Way::OpenBlock;
        if (!isFullAddress(operand) && !inOpen) return;
        const OpenBlock& open = inOpen && operand.reach->inDi ? states[at]->di : states[at]->db;
        const std::uint32_t number = isFullAddress(operand) ? blockOfByte(operand.offset) : open.number;
        if (number == 0 || blocks.length(number) == 0 || (inOpen && open.by != openedHere)) return;
        // A parameter of complex type is named by its first byte.
        const std::uint32_t first = byteInBlock(operand.offset);
        const std::uint32_t end = first + (isParameter ? 1 : static_cast<std::uint32_t>(bytes(operand.width)));
        if (end <= blocks.length(number)) return;
        Finding& finding =
            sink.report(operand.span, fmt::format("{} ends at byte {}, but DB{} has only {} bytes", toString(operand),
                                                  end - 1, number, blocks.length(number)));
        finding.address = toString(operand);
        for (const DataBlock& block : facts.program().dataBlocks) {
          if (block.number == number) finding.related.push_back({block.span, "the data block"});
        }
        finding.help = "correct the address or declare what is missing";
      });
    }
  });
}

}  // namespace

extern constexpr Rule dba002_beyond_data_block = {
    .id = "DBA002",
    .title = "Access beyond the data block",
    .severity = Severity::Error,
    .needs = Needs::Flow,
    .detects = "a full address, or one of the block opened before, whose last byte the data block does not have",
    .why = "a synchronous error: OB121 runs, and without it the CPU goes to STOP",
    .manual = "002:1284-1290",
    .bad =
        "DATA_BLOCK DB 1\nSTRUCT\nX : INT;\nEND_STRUCT;\nBEGIN\nEND_DATA_BLOCK\nORGANIZATION_BLOCK OB 1\nBEGIN\n"
        "NETWORK\nL DB1.DBW 2;\nT QW 0;\nEND_ORGANIZATION_BLOCK\n",
    .good =
        "DATA_BLOCK DB 1\nSTRUCT\nX : INT;\nEND_STRUCT;\nBEGIN\nEND_DATA_BLOCK\nORGANIZATION_BLOCK OB 1\nBEGIN\n"
        "NETWORK\nL DB1.DBW 0;\nT QW 0;\nEND_ORGANIZATION_BLOCK\n",
    .exampleCpu = "319-3",
    .dialects = dialect::S7300,
    .check = checkDba002,
};

}  // namespace rungproof
