// Builds the plan of a program.
#include "ir/plan.hpp"

#include <algorithm>

namespace rungproof {

Plan::Plan(const Program& source) : program(&source) {
  edge.assign(source.instructionCount(), noPartner);
  for (const Pou& pou : source.pous) {
    flows.push_back(flowOf(pou));
    for (const FlowStep& step : flows.back().steps) {
      const Instruction& instruction = *step.instruction;
      if (instruction.desc->stl == "EU" || instruction.desc->stl == "ED") edge[instruction.id] = edgeCount++;
      const bool isTimer = instruction.desc->operandCount > 0 && instruction.desc->operands[0].type == Type::Timer;
      if (!isTimer || instruction.operands.empty()) continue;
      const TimerUse use{instruction.operands[0].offset, instruction.desc, timerResolution(static_cast<int>(instruction.operands[0].offset))};
      const bool isKnown = std::any_of(timers.begin(), timers.end(), [&](const TimerUse& t) { return t.number == use.number && t.desc == use.desc; });
      if (!isKnown) timers.push_back(use);
    }
  }
}

const Flow* Plan::find(PouKind kind, int number) const {
  for (const Flow& flow : flows) {
    if (flow.pou->kind == kind && (number < 0 || flow.pou->number == number)) return &flow;
  }
  return nullptr;
}

}  // namespace rungproof
