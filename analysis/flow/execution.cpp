// The sweeps behind analysis/flow/execution.hpp.
#include "analysis/flow/execution.hpp"

#include <algorithm>
#include <utility>

#include "analysis/flow/statement_paths.hpp"
#include "ir/check.hpp"
#include "ir/s7300/organization_block.hpp"

namespace rungproof {

namespace {

bool isAlways(const StackRun& stack, const Instruction& instruction) {
  return (stack.at(instruction.id).flow & condition::Always) != 0;
}
bool isNever(const StackRun& stack, const Instruction& instruction) {
  return (stack.at(instruction.id).flow & condition::Never) != 0;
}

}  // namespace

ExecutionTable::ExecutionTable(const Program& program, const Plan& plan, const CallGraph& calls,
                               const StackRun& stack) {
  points_.resize(program.instructionCount());
  for (const Flow& flow : plan.flows) {
    reach(flow, stack);
    sweep(flow, stack);
    narrow(flow, stack);
  }
  count(program, calls, stack);
}

/// Follows every branch whose condition is not a constant.
void ExecutionTable::reach(const Flow& flow, const StackRun& stack) {
  const auto end = static_cast<std::uint32_t>(flow.steps.size());
  std::vector<std::uint8_t> seen(end + 1, 0);
  std::vector<std::uint32_t> open;
  const auto go = [&](std::uint32_t target) {
    if (target > end || seen[target] != 0) return;
    seen[target] = 1;
    open.push_back(target);
  };
  go(0);
  while (!open.empty()) {
    const std::uint32_t at = open.back();
    open.pop_back();
    if (at == end) continue;
    const FlowStep& step = flow.steps[at];
    const Instruction& instruction = *step.instruction;
    bool goesOn = true;
    switch (instruction.desc->control) {
      case Control::Branch:
      case Control::Distributor:
      case Control::BlockEnd:
        eachNext(flow, at, go);
        goesOn = false;
        break;
      case Control::Jump:
        if (step.partner != noPartner && !isNever(stack, instruction)) go(step.partner);
        if (step.partner != noPartner && isAlways(stack, instruction)) goesOn = false;
        break;
      case Control::For:
        if (step.partner != noPartner) go(step.partner + 1);
        break;
      case Control::ScrEndConditional:
        if (step.partner != noPartner) go(step.partner);
        break;
      case Control::Return:
      case Control::InterruptReturn:
      case Control::MainEnd: goesOn = false; break;
      case Control::ReturnConditional:
      case Control::InterruptReturnConditional:
      case Control::End: goesOn = !isAlways(stack, instruction); break;
      default: break;
    }
    if (goesOn) go(at + 1);
  }
  for (std::uint32_t i = 0; i < end; ++i) points_[flow.steps[i].instruction->id].isReachable = seen[i] != 0;
}

/// Marks what jumps, steps and returns may leave out, and what loops repeat.
void ExecutionTable::sweep(const Flow& flow, const StackRun& stack) {
  const auto end = static_cast<std::uint32_t>(flow.steps.size());
  std::vector<std::int32_t> loops(end + 1, 0);
  std::uint32_t skipEnd = 0;
  bool isNew = false;  // nothing is left out yet by the last one that may
  std::uint32_t skipper = 0;
  for (std::uint32_t i = 0; i < end; ++i) {
    const FlowStep& step = flow.steps[i];
    const Instruction& instruction = *step.instruction;
    if (i < skipEnd) {
      points_[instruction.id].isSkipped = true;
      if (std::exchange(isNew, false)) skipped_.push_back({instruction.id, skipper});
    }
    const auto skipTo = [&](std::uint32_t target) {
      if (target <= skipEnd) return;
      skipEnd = target;
      skipper = instruction.id;
      isNew = true;
    };
    switch (instruction.desc->control) {
      case Control::BlockEnd: skipTo(end); break;
      case Control::Jump:
      case Control::Branch:
      case Control::Distributor:
        if (step.partner == noPartner || isNever(stack, instruction)) break;
        if (step.partner > i) {
          skipTo(step.partner);
        } else {
          ++loops[step.partner];
          --loops[i + 1];
        }
        break;
      case Control::For:
        if (step.partner == noPartner) break;
        ++loops[i];
        --loops[step.partner + 1];
        skipTo(step.partner);
        break;
      case Control::Lscr:
      case Control::ScrEndConditional:
        if (step.partner == noPartner) break;
        if (instruction.desc->control == Control::Lscr || !isNever(stack, instruction)) skipTo(step.partner);
        break;
      case Control::ReturnConditional:
      case Control::InterruptReturnConditional:
      case Control::End:
        if (!isNever(stack, instruction)) skipTo(end);
        break;
      default: break;
    }
  }
  std::int32_t depth = 0;
  for (std::uint32_t i = 0; i < end; ++i) {
    depth += loops[i];
    points_[flow.steps[i].instruction->id].inLoop = depth > 0;
  }
}

std::uint32_t ExecutionTable::skipper(std::uint32_t instruction) const {
  const auto behind = std::ranges::upper_bound(skipped_, instruction, {}, &Skipped::first);
  CHECK(behind != skipped_.begin(), "an instruction that nothing leaves out");
  return (behind - 1)->skipper;
}

/// A jump over code that is taken but for one scan, or but for the first one, as in `LDN SM0.1; JMP`.
void ExecutionTable::narrow(const Flow& flow, const StackRun& stack) {
  const auto end = static_cast<std::uint32_t>(flow.steps.size());
  const auto isEntered = [&](std::uint32_t from, std::uint32_t to) {  // from outside of the range
    for (std::uint32_t i = 0; i < end; ++i) {
      const FlowStep& step = flow.steps[i];
      if (step.instruction->desc->control != Control::Jump || (i >= from && i < to)) continue;
      if (step.partner != noPartner && step.partner >= from && step.partner < to) return true;
    }
    return false;
  };
  for (std::uint32_t i = 0; i < end; ++i) {
    const Instruction& instruction = *flow.steps[i].instruction;
    const Control control = instruction.desc->control;
    const Condition rest = negation(stack.at(instruction.id).flow) & (condition::FirstScan | condition::Pulse);
    if (rest == 0) continue;
    const bool isJump = control == Control::Jump && flow.steps[i].partner != noPartner && flow.steps[i].partner > i;
    const bool isEnd = control == Control::ReturnConditional || control == Control::InterruptReturnConditional ||
                       control == Control::End;
    const std::uint32_t to = isJump ? flow.steps[i].partner : isEnd ? end : 0;
    if (to == 0 || isEntered(i + 1, to)) continue;
    for (std::uint32_t k = i + 1; k < to; ++k) points_[flow.steps[k].instruction->id].within |= rest;
  }
}

/// Adds up the calls of each block, callers first; calls that certainly run count as Once.
void ExecutionTable::count(const Program& program, const CallGraph& calls, const StackRun& stack) {
  const std::size_t blocks = program.pous.size();
  runs_.assign(blocks, Runs::Never);
  conditions_.assign(blocks, 0);
  std::vector<std::uint32_t> missing(blocks, 0), open;
  std::vector<int> certain(blocks, 0), possible(blocks, 0);
  std::vector<std::uint8_t> isFirst(blocks, 1), isDone(blocks, 0);
  const auto isLive = [&](std::uint32_t b) { return calls.reachedFromMain(b); };
  for (const CallSite& site : calls.sites()) {
    if (site.callee != noBlock && isLive(site.caller)) ++missing[site.callee];
  }
  const auto close = [&](std::uint32_t block) {
    isDone[block] = 1;
    open.push_back(block);
  };
  for (std::uint32_t b = 0; b < blocks; ++b) {
    if (program.pous[b].kind == PouKind::Main) certain[b] = possible[b] = 1;
    if (program.pous[b].type == BlockType::Ob && s7300::mayStart(program, program.pous[b])) possible[b] = 1;
    if (s7300::isStartUpBlock(program.pous[b])) conditions_[b] = condition::FirstScan;
    if (isLive(b) && missing[b] == 0) close(b);
  }
  const auto propagate = [&](std::uint32_t block) {
    runs_[block] = possible[block] == 0  ? Runs::Never
                   : possible[block] > 1 ? Runs::Several
                   : certain[block] > 0  ? Runs::Once
                                         : Runs::AtMostOnce;
    for (const std::uint32_t s : calls.callsIn(block)) {
      const CallSite& site = calls.sites()[s];
      if (site.callee == noBlock || isDone[site.callee] != 0) continue;
      const ExecutionPoint& point = points_[site.instruction->id];
      const Condition flow = stack.at(site.instruction->id).flow;
      if (point.isReachable && (flow & condition::Never) == 0) {
        const int times = point.inLoop ? 2 : 1;
        possible[site.callee] = std::min(possible[site.callee] + times * possible[block], 1000);
        const bool isAlwaysCalled =
            (flow & condition::Always) != 0 || statementRole(*site.instruction) == StatementRole::Call;
        if (isAlwaysCalled && !point.isSkipped) certain[site.callee] += certain[block];
        Condition known = flow | point.within | conditions_[block];
        known &= condition::FirstScan | condition::Pulse;
        conditions_[site.callee] =
            isFirst[site.callee] != 0 ? known : static_cast<Condition>(conditions_[site.callee] & known);
        isFirst[site.callee] = 0;
      }
      if (--missing[site.callee] == 0) close(site.callee);
    }
  };
  while (!open.empty()) {
    const std::uint32_t block = open.back();
    open.pop_back();
    propagate(block);
  }
  for (std::uint32_t b = 0; b < blocks; ++b) {
    if (isLive(b) && isDone[b] == 0) runs_[b] = Runs::Several;  // on or behind a cycle of calls
    if (calls.reachedFromInterrupt(b)) {
      runs_[b] = runs_[b] == Runs::Never ? Runs::AtMostOnce : Runs::Several;
      if (!isLive(b)) conditions_[b] = condition::Pulse;
    }
  }
}

}  // namespace rungproof
