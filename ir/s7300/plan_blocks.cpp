// What a program of blocks needs to know before it runs: which of them run, timers and counters, local memory.
#include <algorithm>

#include "ir/machine/plan.hpp"
#include "ir/machine/timed_event.hpp"
#include "ir/s7300/block.hpp"
#include "ir/s7300/library.hpp"
#include "ir/s7300/organization_block.hpp"
#include "ir/s7300/written_parameters.hpp"

namespace rungproof {

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

void Plan::planBlocks() {
  for (Flow& flow : flows) {
    if (!hasInstance(*flow.pou)) flow.writtenParameters = s7300::writtenParameters(flow);
  }
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
      if (callee.kind != OperandKind::Constant) continue;
      const int number = static_cast<int>(callee.value);
      const s7300::LibraryBlock* block =
          s7300::libraryBlock(blockTypeOf(number), static_cast<std::uint32_t>(numberOfBlock(number)));
      masksErrors = masksErrors || (block != nullptr && block->masksErrors);
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

}  // namespace rungproof
