// GRF002: a contact, coil or pin that was left with question marks. The readers of graphical files speak of drawings,
// the check of the text that an editor wrote of one. Tested by its examples and tests/cli/rule_table_test.cpp.
#include "analysis/flow/facts.hpp"
#include "analysis/rule.hpp"

namespace rungproof {

namespace {

void checkGrf002(const Facts& facts, FindingSink& sink) {
  for (const std::uint32_t id : facts.withOperand(OperandKind::Missing)) {
    const Instruction& instruction = facts.instruction(id);
    if (facts.isUnread(id)) continue;
    for (std::size_t i = 0; i < instruction.operands.size(); ++i) {
      if (instruction.operands[i].kind != OperandKind::Missing) continue;
      if (instruction.desc->control == Control::BlockCall) continue;  // a parameter of an FB need not be given
      Finding& finding =
          sink.report(instruction.span, fmt::format("operand {} of {} is left open", i + 1, instruction.desc->stl));
      finding.help = "give it an operand; the editor writes question marks where none was entered";
    }
  }
}

}  // namespace

extern constexpr Rule grf002_operand_left_open = {
    .id = "GRF002",
    .title = "Operand left open",
    .severity = Severity::Error,
    .needs = Needs::Text,
    .detects = "a contact, coil or box of a ladder or FBD network without an operand that it needs: ??.? or ????",
    .why = "the editor marks it in red and refuses the download; whatever the network should do is not decided yet",
    .manual = "001:2228",
    .bad = "Network 1\nLD I0.0\n= ??.?\n",
    .good = "Network 1\nLD I0.0\n= Q0.0\n",
    .peers = "the editor's own check",
    .refuses = true,
    .standsAlone = true,
    .check = checkGrf002,
};

}  // namespace rungproof
