// Builds the plan of a program.
#include "ir/machine/plan.hpp"

#include <algorithm>

#include "ir/machine/frame.hpp"

namespace rungproof {

const TimerUse* Plan::timer(std::uint32_t number) const {
  const auto found =
      std::find_if(timers.begin(), timers.end(), [&](const TimerUse& use) { return use.number == number; });
  return found == timers.end() ? nullptr : &*found;
}

Plan::Plan(const Program& source, const std::vector<bool>& isLeftOut)
    : program(&source),
      blocks(std::make_shared<const BlockMap>(source)),
      localBytes(rungproof::localBytes),
      dialect_(&dialectOf(source.target)),
      form_(dialect_->form) {
  edge.assign(source.instructionCount(), noPartner);
  for (const Pou& pou : source.pous) {
    for (const Network& network : pou.networks) {
      for (const Instruction& instruction : network.instructions) number(instruction);
    }
    flows.push_back(flowOf(pou, isLeftOut));
  }
  if (counting() == Counting::Boxes) planBoxes();
  if (dialect_->run.startsBlocks) planBlocks();
}

void Plan::number(const Instruction& instruction) {
  if (isEdge(roleOf(instruction))) edge[instruction.id] = edgeCount++;
  if (instruction.desc->control != Control::Call) return;
  for (const Operand& operand : instruction.operands) {
    if (operand.kind == OperandKind::Text) texts.push_back(&operand);
  }
}

const Flow* Plan::block(int number) const {
  const auto found = codeBlocks_.find(number);
  return found == codeBlocks_.end() ? nullptr : &flows[found->second];
}

std::uint32_t registerCount(const RegInfo& info, const Plan& plan) {
  switch (info.count) {
    case perEdge: return plan.edgeCount;
    case perTimer: return plan.timerCount;
    case perCounter: return plan.counterCount;
    case perS5Timer: return plan.counting() == Counting::Elements ? plan.timerCount : 0;
    case perS7Counter: return plan.counting() == Counting::Elements ? plan.counterCount : 0;
    case perCyclicBlock: return plan.dialect().run.startsBlocks ? cyclicBlockCount : 0;
    default: return info.count;
  }
}

const Flow* Plan::find(PouKind kind, int number) const {
  for (const Flow& flow : flows) {
    if (flow.pou->kind == kind && (number < 0 || flow.pou->number == number)) return &flow;
  }
  return nullptr;
}

}  // namespace rungproof
