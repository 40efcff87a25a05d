// For each parameter the statements that can run before it is written; if the end is among them, it may stay unwritten.
#include "ir/s7300/written_parameters.hpp"

#include <algorithm>

#include "ir/s7300/statement_role.hpp"

namespace rungproof::s7300 {

namespace {

bool writes(const Instruction& instruction, std::uint32_t parameter) {
  const StatementRole role = statementRole(instruction);
  if ((role != StatementRole::Assign && role != StatementRole::Transfer) || instruction.operands.empty()) return false;
  const Operand& operand = instruction.operands[0];
  return operand.kind != OperandKind::Address && operand.reach != nullptr && operand.reach->way == Way::Parameter &&
         operand.reach->parameter == parameter && operand.offset == 0 && operand.bit == 0;
}

bool isAlwaysWritten(const Flow& flow, std::uint32_t parameter) {
  const auto end = static_cast<std::uint32_t>(flow.steps.size());
  std::vector<bool> isReached(end + 1, false);
  std::vector<std::uint32_t> open;
  const auto reach = [&](std::uint32_t step) {
    const std::uint32_t at = std::min(step, end);  // a jump without a label ends the block
    if (isReached[at]) return;
    isReached[at] = true;
    open.push_back(at);
  };
  reach(0);
  while (!open.empty() && !isReached[end]) {
    const std::uint32_t at = open.back();
    open.pop_back();
    const FlowStep& step = flow.steps[at];
    if (writes(*step.instruction, parameter)) continue;
    switch (step.instruction->desc->control) {
      case Control::BlockEnd: reach(end); break;
      case Control::Branch: reach(step.partner); break;
      case Control::Distributor: return false;  // its list is not followed
      default: break;
    }
    reach(at + 1);
  }
  return !isReached[end];
}

}  // namespace

std::vector<bool> writtenParameters(const Flow& flow) {
  std::vector<bool> written(flow.pou->locals.size(), false);
  for (std::uint32_t i = 0; i < written.size(); ++i) {
    const LocalVariable& local = flow.pou->locals[i];
    written[i] = local.section == VarSection::Output && local.address.reach != nullptr && isAlwaysWritten(flow, i);
  }
  return written;
}

}  // namespace rungproof::s7300
