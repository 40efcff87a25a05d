// Builds the plan of a program.
#include "ir/s7200/plan.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "ir/check.hpp"
#include "ir/s7200/cpu.hpp"
#include "ir/s7200/event.hpp"
#include "ir/s7200/frame.hpp"
#include "ir/s7300/block.hpp"
#include "ir/s7300/organization_block.hpp"

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
    if (counting() == Counting::Boxes) addBoxTimers(flows.back());
  }
  for (std::uint32_t timer = 0; timer < attachedTimers && counting() == Counting::Boxes; ++timer)
    timedEvents.push_back(timer);
  if (dialect_->run.startsBlocks) planBlocks();
}

void Plan::addBoxTimers(const Flow& flow) {
  for (const FlowStep& step : flow.steps) {
    const Instruction& instruction = *step.instruction;
    const bool isTimer = instruction.desc->operandCount > 0 && instruction.desc->operands[0].type == Type::Timer;
    if (!isTimer || instruction.operands.empty()) continue;
    const TimerUse use{instruction.operands[0].offset, instruction.desc,
                       timerResolution(static_cast<int>(instruction.operands[0].offset)), timerKind(*instruction.desc),
                       timer(instruction.operands[0].offset) == nullptr};
    const bool isKnown = std::any_of(timers.begin(), timers.end(),
                                     [&](const TimerUse& t) { return t.number == use.number && t.desc == use.desc; });
    if (!isKnown) timers.push_back(use);
  }
}

void Plan::number(const Instruction& instruction) {
  if (isEdge(roleOf(instruction))) edge[instruction.id] = edgeCount++;
  if (instruction.desc->control != Control::Call) return;
  for (const Operand& operand : instruction.operands) {
    if (operand.kind == OperandKind::Text) texts.push_back(&operand);
  }
}

namespace {

constexpr std::uint32_t leastLocalBytes = 256;

/// Calls visit with every operand of the program, also with those that lie within others.
template <class Visit>
void eachOperand(const Program& program, Visit&& visit) {
  for (const Pou& pou : program.pous) {
    for (const Network& network : pou.networks) {
      for (const Instruction& instruction : network.instructions) {
        for (const Operand& operand : instruction.operands) visit(operand);
      }
    }
  }
}

/// The IEC timers in an instance of that block, which begins at `first`; blocks lie within each other at most so
/// deeply.
void addIecTimers(const Program& program, int instanceOf, std::uint32_t first, int levels,
                  std::vector<std::uint32_t>& timers) {
  const bool isTimer = isIecTimer(instanceOf);
  if (isTimer) timers.push_back(first);
  const Pou* pou = levels > 0 && instanceOf != 0 && !isTimer ? program.subroutine(instanceOf) : nullptr;
  if (pou == nullptr) return;
  for (const LocalVariable& local : pou->locals) {
    if (local.type == DataType::Instance && local.section == VarSection::Static)
      addIecTimers(program, local.instanceOf, first + local.address.offset, levels - 1, timers);
  }
}

/// L memory of a chain of calls that begins with this block: the deepest one, as far as the CPU lets blocks nest.
std::uint32_t localsFrom(const Plan& plan, const Flow& flow, int levels,
                         std::map<std::pair<int, int>, std::uint32_t>& known) {
  const auto [place, isNew] = known.try_emplace({flow.pou->number, levels}, flow.pou->localBytes);
  if (!isNew || levels == 0) return place->second;
  std::uint32_t most = 0;
  for (const FlowStep& step : flow.steps) {
    const Instruction& instruction = *step.instruction;
    if (instruction.desc->control != Control::BlockCall || instruction.operands.empty()) continue;
    const Operand& block = instruction.operands[0];
    if (block.kind == OperandKind::Constant) {
      const Flow* callee = plan.block(static_cast<int>(block.value));
      if (callee != nullptr) most = std::max(most, localsFrom(plan, *callee, levels - 1, known));
    } else {
      for (const Flow& any : plan.flows) {
        if (any.pou->kind == PouKind::Subroutine) most = std::max(most, localsFrom(plan, any, levels - 1, known));
      }
    }
  }
  return known[{flow.pou->number, levels}] = flow.pou->localBytes + most;
}

}  // namespace

/// S7-300/400.
void Plan::planBlocks() {
  const Step7CpuRow& cpu = step7Row(program->target.cpu);
  for (std::size_t i = 0; i < flows.size(); ++i) {
    if (s7300::mayStart(*program, *flows[i].pou)) codeBlocks_.emplace(flows[i].pou->number, i);
  }
  const auto isUsed = [&](Area area, std::uint32_t number) {
    if (area == Area::C) counterCount = std::max(counterCount, std::min(number + 1, cpu.timers));
    if (area != Area::T || number >= cpu.timers) return;
    timerCount = std::max(timerCount, number + 1);
    if (timer(number) == nullptr) timers.push_back({number, nullptr, 1, TimerKind::S5});
  };
  eachOperand(*program, [&](const Operand& operand) {
    if (operand.kind == OperandKind::Direct) isUsed(operand.area, operand.offset);
    const bool isAny = operand.reach != nullptr && operand.reach->way == Way::Pointer && hasBitAndWord(operand.area);
    for (std::uint32_t number = 0; isAny && number < cpu.timers; ++number) isUsed(operand.area, number);
  });
  for (const DataBlock& block : program->dataBlocks)
    addIecTimers(*program, block.instanceOf, dataByte(block.number, 0), cpu.nesting, iecTimers);
  for (std::uint32_t timer = attachedTimers; timer < timedEventCount; ++timer) {
    const bool isThere = block(blockNumber(BlockType::Ob, blockOfEvent(eventOfTimed(timer)))) != nullptr;
    if (isThere) timedEvents.push_back(timer);
  }
  for (const Flow& flow : flows) {
    for (const FlowStep& step : flow.steps) {
      const Instruction& call = *step.instruction;
      if (call.desc->control != Control::BlockCall || call.operands.empty()) continue;
      const Operand& callee = call.operands[0];
      const int number = static_cast<int>(callee.value);
      if (callee.kind == OperandKind::Constant && blockTypeOf(number) == BlockType::Sfc)
        systemFunctions.insert(numberOfBlock(number));
    }
  }
  std::map<std::pair<int, int>, std::uint32_t> known;
  localBytes = 0;
  for (const Flow& flow : flows) {
    if (block(flow.pou->number) != nullptr && flow.pou->type == BlockType::Ob)
      localBytes += localsFrom(*this, flow, cpu.nesting, known);
  }
  localBytes = std::max(localBytes, leastLocalBytes);
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
