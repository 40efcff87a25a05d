// DBA001: an access to the open data block where the block has opened none, or a call may have opened another.
// Tested by its examples and tests/rules/data_block_rules_test.cpp.
#include <fmt/format.h>

#include "analysis/flow/open_blocks.hpp"
#include "analysis/flow/step7_blocks.hpp"
#include "analysis/rule.hpp"

namespace rungproof {

namespace {

void reportUnopened(const Facts& facts, FindingSink& sink, const Instruction& instruction, const Operand& operand,
                    Openers by) {
  const bool isByCall = (by & openedByCall) != 0;
  Finding& finding = sink.report(
      operand.span,
      isByCall ? fmt::format("{} stands behind a call, which may have left another data block open: the instance of an "
                             "FB, or the block of a full address among its parameters",
                             Facts::text(instruction))
               : fmt::format("{} takes whatever data block is open: {} has opened none{}", Facts::text(instruction),
                             facts.pouOf(instruction.id).name, (by & openedHere) != 0 ? " on some path" : ""));
  finding.address = toString(operand);
  finding.help = isByCall ? "open the block again behind the call, or write the full address"
                          : "open the block before with OPN, or write the full address";
}

void checkDba001(const Facts& facts, FindingSink& sink) {
  eachOwnBlock(facts, [&](std::uint32_t, const Flow& flow) {
    const OpenStates states = openStates(facts.program(), flow);
    Openers told[2] = {0, 0};  // one finding for each register and reason
    for (std::uint32_t at = 0; at < flow.steps.size(); ++at) {
      if (!states[at]) continue;
      const Instruction& instruction = *flow.steps[at].instruction;
      eachDataOperand(facts.program(), instruction, [&](const Operand& operand, bool) {
        for (const bool inDi : {false, true}) {
          const OpenBlock& block = inDi ? states[at]->di : states[at]->db;
          const auto foreign = static_cast<Openers>(block.by & ~openedHere & ~told[inDi ? 1 : 0]);
          if (foreign == 0 || !reachesOpenBlock(operand, inDi)) continue;
          told[inDi ? 1 : 0] |= foreign;
          reportUnopened(facts, sink, instruction, operand, block.by);
        }
      });
    }
  });
}

}  // namespace

extern constexpr Rule dba001_no_block_open = {
    .id = "DBA001",
    .title = "Data accessed with no block opened",
    .severity = Severity::Warning,
    .needs = Needs::Flow,
    .detects =
        "DBX, DBB, DBW, DBD before the block has opened a data block; the same behind a call of an FB, or behind one "
        "that gets a full data block address as a parameter; DIX and its kind in an OB or FC",
    .why =
        "the access goes to the block that the caller, or the call, has left open, and none is open at the start of "
        "an OB",
    .manual = "002:567, 002:603, 002:653",
    .bad =
        "DATA_BLOCK DB 1\nSTRUCT\nX : INT;\nEND_STRUCT;\nBEGIN\nEND_DATA_BLOCK\nORGANIZATION_BLOCK OB 1\nBEGIN\n"
        "NETWORK\nL DBW 0;\nT QW 0;\nEND_ORGANIZATION_BLOCK\n",
    .good =
        "DATA_BLOCK DB 1\nSTRUCT\nX : INT;\nEND_STRUCT;\nBEGIN\nEND_DATA_BLOCK\nORGANIZATION_BLOCK OB 1\nBEGIN\n"
        "NETWORK\nOPN DB 1;\nL DBW 0;\nT QW 0;\nEND_ORGANIZATION_BLOCK\n",
    .exampleCpu = "319-3",
    .falsePositives = "FCs for whom every caller opens the block by agreement",
    .dialects = dialect::S7300,
    .check = checkDba001,
};

}  // namespace rungproof
