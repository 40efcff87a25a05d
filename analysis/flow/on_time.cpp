// Follows the levels of the logic stack, or the string of scans, up to the timer.
#include "analysis/flow/on_time.hpp"

#include <algorithm>
#include <vector>

#include "analysis/flow/logic_string.hpp"
#include "ir/s7300/clock_memory.hpp"

namespace rungproof {

namespace {

using FlowLevel = std::optional<OnTime>;

FlowLevel shorterTime(const FlowLevel& a, const FlowLevel& b) {
  if (!a || !b) return a ? a : b;
  return b->ms < a->ms ? b : a;
}

/// SM0.4, SM0.5 and SM0.6 are as long on as off; SM0.1 is on in the first scan (001:14050-14056, 001:14681).
FlowLevel onTimeOfContact(const Facts& facts, const Instruction& contact) {
  if (contact.operands.empty() || contact.desc->execution == Execution::Compare) return {};
  const Operand& bit = contact.operands[0];
  if (bit.kind != OperandKind::Direct || bit.area != Area::SM || bit.offset != 0) return {};
  const std::string name = facts.name(bit);
  switch (bit.bit) {
    case 1: return contact.desc->negated ? FlowLevel{} : OnTime{0, name, true};
    case 4: return OnTime{30'000, name, true};
    case 5: return OnTime{500, name, true};
    case 6: return OnTime{0, name, true};
    default: return {};
  }
}

/// The stack of one network; what was there before is not known.
class FlowLevels {
 public:
  FlowLevel top() const { return levels_.empty() ? FlowLevel{} : levels_.back(); }

  void step(const Facts& facts, const Instruction& instruction) {
    const Desc& desc = *instruction.desc;
    switch (desc.role) {
      case Role::Load: levels_.push_back(onTimeOfContact(facts, instruction)); return;
      case Role::And: return setTop(shorterTime(top(), onTimeOfContact(facts, instruction)));
      case Role::Eu:
      case Role::Ed: return setTop(OnTime{0, Facts::text(instruction), false});
      case Role::Ald: {
        const FlowLevel above = pop();
        return setTop(shorterTime(top(), above));
      }
      case Role::Old: pop(); return setTop({});
      case Role::Lps: levels_.push_back(top()); return;
      case Role::Lrd:
        pop();
        levels_.push_back(top());
        return;
      case Role::Lpp: pop(); return;
      case Role::Nop:
      case Role::Assign:
      case Role::Set:
      case Role::Reset:
      case Role::Ton:
      case Role::Tof:
      case Role::Tonr: return;
      case Role::Or: return setTop({});
      default: levels_.clear();
    }
  }

 private:
  FlowLevel pop() {
    const FlowLevel level = top();
    if (!levels_.empty()) levels_.pop_back();
    return level;
  }
  void setTop(FlowLevel level) {
    pop();
    levels_.push_back(std::move(level));
  }

  std::vector<FlowLevel> levels_;
};

}  // namespace

std::optional<OnTime> onTimeOfFlow(const Facts& facts, const InstructionPlace& place) {
  const Flow& flow = facts.plan().flows[place.block];
  std::uint32_t first = place.step;
  while (first > 0 && flow.steps[first - 1].network == place.network) --first;
  FlowLevels levels;
  for (std::uint32_t at = first; at < place.step; ++at) levels.step(facts, *flow.steps[at].instruction);
  return levels.top();
}

std::optional<OnTime> onTimeOfRlo(const Facts& facts, std::uint32_t block, std::uint32_t step) {
  const Flow& flow = facts.plan().flows[block];
  const std::optional<std::uint32_t>& clock = facts.program().clockMemory;
  const LogicStates states = logicStates(flow);
  FlowLevel shortest;
  for (std::uint32_t at = step; at-- > 0;) {
    const Instruction& instruction = *flow.steps[at].instruction;
    const StatementRole role = statementRole(instruction);
    if (role == StatementRole::Edge) return shorterTime(shortest, OnTime{0, Facts::text(instruction), false});
    if (role == StatementRole::Nothing) continue;
    if (role != StatementRole::AndScan || !states[at] || instruction.operands.empty()) return {};
    const Operand& bit = instruction.operands[0];
    const bool isClock = clock && bit.kind == OperandKind::Direct && bit.area == Area::M && bit.offset == *clock &&
                         bit.width == Width::Bit && bit.reach == nullptr;
    if (isClock) shortest = shorterTime(shortest, OnTime{clockPeriods[bit.bit] / 2, facts.name(bit), true});
    if (states[at]->firstCheck == mayBe0) return shortest;
    if (states[at]->firstCheck != mayBe1) return {};
  }
  return {};
}

std::size_t startsOf(const Facts& facts, std::uint32_t timer) {
  std::size_t count = 0;
  for (const Flow& flow : facts.plan().flows) {
    count += static_cast<std::size_t>(std::ranges::count_if(flow.steps, [&](const FlowStep& step) {
      return statementRole(*step.instruction) == StatementRole::StartTimer && !step.instruction->operands.empty() &&
             step.instruction->operands[0].offset == timer;
    }));
  }
  return count;
}

bool usesUnnamedTimers(const Facts& facts) {
  for (const Flow& flow : facts.plan().flows) {
    for (const FlowStep& step : flow.steps) {
      const Instruction& instruction = *step.instruction;
      if (instruction.operands.empty()) continue;
      const StatementRole role = statementRole(instruction);
      const bool isStart = role == StatementRole::StartTimer || role == StatementRole::ResetTimer;
      if (isStart && (instruction.operands[0].kind != OperandKind::Direct || instruction.operands[0].reach != nullptr))
        return true;
      const bool isGiven = instruction.desc->control == Control::BlockCall &&
                           std::ranges::any_of(instruction.operands, [](const Operand& operand) {
                             return operand.area == Area::T && operand.kind == OperandKind::Direct;
                           });
      if (isGiven) return true;
    }
  }
  return false;
}

}  // namespace rungproof
