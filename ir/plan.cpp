// Builds the plan of a program.
#include "ir/plan.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "ir/check.hpp"

namespace rungproof {

TimerKind timerKind(const Desc& desc) {
  static constexpr std::array<std::pair<std::string_view, TimerKind>, 6> kinds = {{{"TON", TimerKind::OnDelay},
                                                                                   {"TONR", TimerKind::Retentive},
                                                                                   {"TOF", TimerKind::OffDelay},
                                                                                   {"TON.IEC", TimerKind::IecOnDelay},
                                                                                   {"TOF.IEC", TimerKind::OffDelay},
                                                                                   {"TP.IEC", TimerKind::IecPulse}}};
  const auto found = std::find_if(kinds.begin(), kinds.end(), [&](const auto& kind) { return kind.first == desc.stl; });
  CHECK(found != kinds.end(), "instruction with a timer operand that is no timer");
  return found->second;
}

const TimerUse* Plan::timer(std::uint32_t number) const {
  const auto found =
      std::find_if(timers.begin(), timers.end(), [&](const TimerUse& use) { return use.number == number; });
  return found == timers.end() ? nullptr : &*found;
}

Plan::Plan(const Program& source, const std::vector<bool>& isLeftOut) : program(&source) {
  edge.assign(source.instructionCount(), noPartner);
  for (const Pou& pou : source.pous) {
    for (const Network& network : pou.networks) {
      for (const Instruction& instruction : network.instructions) number(instruction);
    }
    flows.push_back(flowOf(pou, isLeftOut));
    for (const FlowStep& step : flows.back().steps) {
      const Instruction& instruction = *step.instruction;
      const bool isTimer = instruction.desc->operandCount > 0 && instruction.desc->operands[0].type == Type::Timer;
      if (!isTimer || instruction.operands.empty()) continue;
      const TimerUse use{instruction.operands[0].offset, instruction.desc,
                         timerResolution(static_cast<int>(instruction.operands[0].offset)),
                         timerKind(*instruction.desc), timer(instruction.operands[0].offset) == nullptr};
      const bool isKnown = std::any_of(timers.begin(), timers.end(),
                                       [&](const TimerUse& t) { return t.number == use.number && t.desc == use.desc; });
      if (!isKnown) timers.push_back(use);
    }
  }
}

void Plan::number(const Instruction& instruction) {
  if (isEdge(roleOf(instruction))) edge[instruction.id] = edgeCount++;
  if (instruction.desc->control != Control::Call) return;
  for (const Operand& operand : instruction.operands) {
    if (operand.kind == OperandKind::Text) texts.push_back(&operand);
  }
}

const Flow* Plan::find(PouKind kind, int number) const {
  for (const Flow& flow : flows) {
    if (flow.pou->kind == kind && (number < 0 || flow.pou->number == number)) return &flow;
  }
  return nullptr;
}

}  // namespace rungproof
