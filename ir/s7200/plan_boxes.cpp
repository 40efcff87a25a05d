// The timers of a program that counts with boxes.
#include <algorithm>
#include <array>
#include <utility>

#include "ir/check.hpp"
#include "ir/machine/plan.hpp"
#include "ir/machine/timed_event.hpp"
#include "ir/s7200/cpu.hpp"

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

void Plan::planBoxes() {
  for (const Flow& flow : flows) {
    for (const FlowStep& step : flow.steps) {
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
  for (std::uint32_t timer = 0; timer < attachedTimers; ++timer) timedEvents.push_back(timer);
}

}  // namespace rungproof
