// What can happen in front of an instruction and after the program: 1 ms ticks, then interrupts. Where nothing can be
// noticed there, nothing is let in (argument: footprint.hpp).
//
// Ticks: how many of the scan's ms have passed at a place is an input, at least as many as at the place before and at
// most dt; what is left passes after the program.
//
// Interrupts: whether an event occurs at a place is an input. Events that wait at one place are served by priority,
// and at most one of each is taken: an event that occurs more often between two places is not followed.
#include <algorithm>

#include "analysis/encoding/scan_encoding.hpp"
#include "ir/event.hpp"
#include "ir/timer_refresh.hpp"

namespace rungproof {

namespace {

/// Places at which routines are run in one scan; more would repeat the routines' text too often.
constexpr std::size_t eventSiteLimit = 400;

}  // namespace

Attachments attachmentsOf(const Plan& plan) {
  Attachments result;
  for (const Flow& flow : plan.flows) {
    for (const FlowStep& step : flow.steps) {
      const Instruction& instruction = *step.instruction;
      if (instruction.desc->stl != "ATCH" || instruction.operands.size() != 2) continue;
      const auto number = [&](std::size_t i) { return static_cast<int>(instruction.operands[i].value); };
      if (number(1) < 0 || number(1) >= eventCount || plan.interrupt(number(0)) == nullptr) continue;
      result[number(1)].insert(number(0));
    }
  }
  return result;
}

void ScanEncoding::prepareTicks() {
  for (const TimerUse& use : plan_.timers) {
    if (use.resolution != 1) continue;
    for (const Reg reg : {Reg::TimerCurrent, Reg::TimerBit, Reg::TimerRunning, Reg::TimerPreset})
      addKeys(registerPlace(reg, use.number), tickKeys_);
  }
  consumed_ = graph.constantNode(0, time.width());
}

void ScanEncoding::prepareWatched() {
  for (const Operand& operand : options_.watched) {
    switch (operand.area) {
      case Area::T:
        for (const Reg reg : {Reg::TimerBit, Reg::TimerCurrent})
          addKeys(registerPlace(reg, operand.offset), watched_.reads);
        break;
      case Area::C:
        for (const Reg reg : {Reg::CounterBit, Reg::CounterCurrent})
          addKeys(registerPlace(reg, operand.offset), watched_.reads);
        break;
      case Area::AC: addKeys(registerPlace(Reg::Accumulator, operand.offset), watched_.reads); break;
      case Area::HC:
      case Area::AI: break;  // not written by instructions
      default: addKeys(memoryPlace(operand.area, operand.offset, operand.width, operand.bit), watched_.reads);
    }
  }
}

bool ScanEncoding::needsTicks(std::uint32_t instruction) const {
  if (tickKeys_.empty()) return false;
  if (instruction == ScanPlace::afterProgram || watched_.conflictsWith({tickKeys_, tickKeys_})) return true;
  const auto found = knowledge_.footprints.ofInstruction.find(instruction);
  return found != knowledge_.footprints.ofInstruction.end() && found->second.conflictsWith({tickKeys_, tickKeys_});
}

bool ScanEncoding::mayInterrupt(int event, std::uint32_t instruction) const {
  if (instruction == ScanPlace::afterProgram) return true;
  const auto isSeen = [&](int routine) {
    const auto its = knowledge_.footprints.ofRoutine.find(routine);
    return its != knowledge_.footprints.ofRoutine.end() && watched_.conflictsWith(its->second);
  };
  if (std::ranges::any_of(attachments_.at(event), isSeen)) return true;
  const auto own = knowledge_.footprints.ofInstruction.find(instruction);
  if (own == knowledge_.footprints.ofInstruction.end()) return false;
  Footprint needed;
  addKeys(registerPlace(Reg::EventRoutine, static_cast<std::uint32_t>(event)), needed.reads);
  addKeys(registerPlace(Reg::InterruptsEnabled, 0), needed.reads);
  addKeys(registerPlace(Reg::Running, 0), needed.reads);
  if (own->second.conflictsWith(needed)) return true;
  for (const int routine : attachments_.at(event)) {
    const auto its = knowledge_.footprints.ofRoutine.find(routine);
    if (its != knowledge_.footprints.ofRoutine.end() && own->second.conflictsWith(its->second)) return true;
  }
  return false;
}

void ScanEncoding::boundary(Runner& runner, std::uint32_t instruction) {
  const bool hasTicks = needsTicks(instruction);
  bool hasEvents = false;
  if (!machine_.inInterrupt) {
    for (const int event : events_) hasEvents = hasEvents || mayInterrupt(event, instruction);
  }
  if (!hasTicks && !hasEvents) return;
  widening_.block();
  const bool wasRecording = isRecording_;
  isRecording_ = false;
  std::vector<Node>& executions = visits[instruction];
  const auto visit = static_cast<std::uint32_t>(executions.size());
  executions.push_back(machine_.guard.node);
  if (hasTicks) tick(instruction, visit);
  if (hasEvents) interrupts(runner, instruction, visit);
  isRecording_ = wasRecording;
}

void ScanEncoding::tick(std::uint32_t instruction, std::uint32_t visit) {
  const int w = time.width();
  const Node guard = machine_.guard.node;
  Node now = time.dt();
  if (instruction != ScanPlace::afterProgram) {
    now = input("ms before instruction " + std::to_string(instruction), w);
    const Node inOrder =
        graph.make(Op::And, 1, graph.make(Op::Ule, 1, consumed_, now), graph.make(Op::Ule, 1, now, time.dt()));
    const Node constraint = graph.make(Op::Or, 1, graph.make(Op::Not, 1, guard), inOrder);
    constraints_.push_back(constraint);
    totalConstraints_.push_back(constraint);
  }
  const Node ticks = time.saturated16(graph.make(Op::Sub, w, now, consumed_));
  const Graph::Bool passes = graph.lnot(graph.equal({ticks}, graph.literal(0, 16), 16));
  machine_.when(passes, [&] { refreshTimers(machine_, 1, {ticks}); });
  tickSites.push_back({{instruction, visit, guard}, ticks});
  consumed_ = graph.make(Op::Ite, w, guard, now, consumed_);
}

void ScanEncoding::interrupts(Runner& runner, std::uint32_t instruction, std::uint32_t visit) {
  for (const int event : events_) {
    if (!mayInterrupt(event, instruction)) continue;
    const Graph::Bits routine = machine_.get(Reg::EventRoutine, static_cast<std::uint32_t>(event));
    const Graph::Bool enabled = graph.land(machine_.getBit(Reg::InterruptsEnabled), machine_.getBit(Reg::Running));
    const auto isAttached = [&](int number) {
      return graph.land(enabled, graph.equal(routine, graph.literal(static_cast<std::uint64_t>(number) + 1, 8), 8));
    };
    Graph::Bool ready = graph.constant(false);
    for (const int number : attachments_.at(event)) ready = graph.lor(ready, isAttached(number));
    if (graph.truth(graph.land(machine_.guard, ready)) == false) continue;
    if (eventSites.size() >= eventSiteLimit) {
      approximate(nullptr,
                  "interrupts are followed at the first " + std::to_string(eventSiteLimit) + " places of a scan only")
          .leftOut = graph.constant(true).node;
      return;
    }
    const Graph::Bool occurs{
        input("event " + std::to_string(event) + " before instruction " + std::to_string(instruction), 1)};
    eventSites.push_back({{instruction, visit, machine_.guard.node}, event, graph.land(occurs, ready).node});
    for (const int number : attachments_.at(event)) {
      routine_ = number;
      isRecording_ = true;
      runner.interrupt(number, graph.land(occurs, isAttached(number)));
      isRecording_ = false;
      routine_ = -1;
    }
  }
}

}  // namespace rungproof
