// What can happen in front of an instruction and after the program: 1 ms ticks, then interrupts. Where nothing can be
// noticed there, nothing is let in (argument: footprint.hpp).
//
// Ticks: how many of the scan's ms have passed at a place is an input, at least as many as at the place before and at
// most dt; what is left passes after the program. An IEC timer reads the time once, in front of its call.
//
// Interrupts: scan_interrupts.cpp.
#include <algorithm>
#include <utility>

#include "analysis/encoding/scan_encoding.hpp"
#include "ir/families/run.hpp"
#include "ir/s7300/block.hpp"

namespace rungproof {

Attachments attachmentsOf(const Plan& plan) {
  Attachments result;
  for (int event = firstBlockEvent; plan.dialect().run.startsBlocks && event < blockEventEnd; ++event) {
    const int block = blockOfEvent(event);
    if (plan.block(blockNumber(BlockType::Ob, block)) != nullptr) result[event].insert(block);
  }
  for (const Flow& flow : plan.flows) {
    for (const FlowStep& step : flow.steps) {
      const Instruction& instruction = *step.instruction;
      if (roleOf(instruction) != Role::Atch || instruction.operands.size() != 2) continue;
      const auto number = [&](std::size_t i) { return static_cast<int>(instruction.operands[i].value); };
      if (number(1) < 0 || number(1) >= eventCount || plan.interrupt(number(0)) == nullptr) continue;
      result[number(1)].insert(number(0));
    }
  }
  return result;
}

namespace {

/// What a timer is made of.
constexpr std::array timerRegisters = {Reg::TimerCurrent, Reg::TimerBit, Reg::TimerRunning, Reg::TimerPreset,
                                       Reg::S5Rest};

}  // namespace

void ScanEncoding::prepareTicks() {
  for (const TimerUse& use : plan_.timers) {
    if (use.resolution != 1) continue;
    for (const Reg reg : timerRegisters) addKeys(registerPlace(reg, use.number), tickKeys_.reads);
  }
  for (const Flow& flow : plan_.flows) {
    for (const FlowStep& step : flow.steps) {
      const Instruction& instruction = *step.instruction;
      const bool isCall = instruction.desc->control == Control::BlockCall && !instruction.operands.empty() &&
                          instruction.operands[0].kind == OperandKind::Constant;
      if (isCall && isIecTimer(static_cast<int>(instruction.operands[0].value))) iecCalls_.insert(instruction.id);
    }
  }
  if (program_.clockMemory) addKeys(memoryPlace(Area::M, *program_.clockMemory, Width::Byte), tickKeys_.reads);
  tickKeys_.writes = tickKeys_.reads;
  consumed_ = graph.constantNode(0, time.width());
}

void ScanEncoding::prepareWatched() {
  for (const Operand& operand : options_.watched) {
    switch (operand.area) {
      case Area::T:
        for (const Reg reg : {Reg::TimerBit, timerRegister(operand.width)})
          addKeys(registerPlace(reg, operand.offset), watched_.reads);
        break;
      case Area::C:
        for (const Reg reg : {Reg::CounterBit, Reg::CounterCurrent})
          addKeys(registerPlace(reg, operand.offset), watched_.reads);
        break;
      case Area::AC: addKeys(registerPlace(Reg::Accumulator, operand.offset), watched_.reads); break;
      case Area::HC:
      case Area::AI:
      case Area::PI: break;  // not written by instructions
      default: addKeys(memoryPlace(operand.area, operand.offset, operand.width, operand.bit), watched_.reads);
    }
  }
}

bool ScanEncoding::needsTicks(std::uint32_t instruction) const {
  if (iecCalls_.contains(instruction)) return true;
  if (tickKeys_.reads.empty()) return false;
  if (instruction == ScanPlace::afterProgram || watched_.conflictsWith(tickKeys_)) return true;
  const auto found = knowledge_.footprints.ofInstruction.find(instruction);
  return found != knowledge_.footprints.ofInstruction.end() && found->second.conflictsWith(tickKeys_);
}

/// The timers for which it matters in front of the instruction that an S5 timer has come to its end: time passes for
/// each of them alone, so that it can be told to each when somebody asks.
std::set<std::uint32_t> ScanEncoding::timersTouchedBy(std::uint32_t instruction) const {
  std::set<std::uint32_t> timers = indicesIn(watched_, timerRegisters);
  const auto found = knowledge_.footprints.ofInstruction.find(instruction);
  if (found != knowledge_.footprints.ofInstruction.end()) timers.merge(indicesIn(found->second, timerRegisters));
  return timers;
}

bool ScanEncoding::mayInterrupt(int event, std::uint32_t instruction) const {
  if (instruction == ScanPlace::afterProgram || isAfterEnable_) return true;
  if (!options_.interruptsInside) return false;
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
  addCauseKeys(event, needed);
  if (const int bit = static_cast<int>(eventInfo(event).group); eventStates_.overflowBits.contains(bit))
    addKeys(memoryPlace(Area::SM, 4, Width::Bit, static_cast<std::uint32_t>(bit)), needed.writes);
  if (own->second.conflictsWith(needed)) return true;
  for (const int routine : attachments_.at(event)) {
    const auto its = knowledge_.footprints.ofRoutine.find(routine);
    if (its != knowledge_.footprints.ofRoutine.end() && own->second.conflictsWith(its->second)) return true;
  }
  return false;
}

void ScanEncoding::boundary(Runner& runner, std::uint32_t instruction) {
  bool hasTicks = needsTicks(instruction), hasEvents = false;
  visit_.reset();
  const bool isUninterrupted = machine_.inInterrupt || machine_.isStartUp;
  for (const int event : events_) {
    if (!mayInterrupt(event, instruction)) continue;
    hasEvents = true;
    hasTicks = hasTicks || (!isUninterrupted && isTimerEvent(event) && !tickKeys_.reads.empty());
  }
  // A routine may run what has places elsewhere: its executions count as well.
  if (hasEvents && isUninterrupted) visitOf(instruction);
  hasEvents = hasEvents && !isUninterrupted;
  if (!hasTicks && !hasEvents) return;
  widening_.block();
  const bool wasRecording = isRecording_;
  isRecording_ = false;
  const std::uint32_t visit = visitOf(instruction);
  if (hasTicks) tick(instruction, visit);
  if (hasEvents) interrupts(runner, instruction);
  visit_ = visit;  // routines have had places of their own
  if (!machine_.inInterrupt) isAfterEnable_ = false;
  isRecording_ = wasRecording;
}

/// Number of this execution of the instruction among those that have a site.
std::uint32_t ScanEncoding::visitOf(std::uint32_t instruction) {
  if (visit_) return *visit_;
  std::vector<Node>& executions = visits[instruction];
  visit_ = static_cast<std::uint32_t>(executions.size());
  executions.push_back(machine_.guard.node);
  return *visit_;
}

Node ScanEncoding::siteInput(int event, std::uint32_t instruction, int width) {
  const std::string what = event == SiteInput::ticks ? "ms" : "event " + std::to_string(event);
  const Node node = input(what + " before instruction " + std::to_string(instruction), width);
  siteInputs.push_back({event, instruction, node});
  return node;
}

void ScanEncoding::tick(std::uint32_t instruction, std::uint32_t visit) {
  const int w = time.width();
  const Node guard = machine_.guard.node;
  Node now = time.dt();
  if (instruction != ScanPlace::afterProgram) {
    now = siteInput(SiteInput::ticks, instruction, w);
    const Node inOrder =
        graph.make(Op::And, 1, graph.make(Op::Ule, 1, consumed_, now), graph.make(Op::Ule, 1, now, time.dt()));
    const Node constraint = graph.make(Op::Or, 1, graph.make(Op::Not, 1, guard), inOrder);
    constraints_.push_back(constraint);
    totalConstraints_.push_back(constraint);
  }
  const Node ticks = time.saturated16(graph.make(Op::Sub, w, now, consumed_));
  if (plan_.counting() == Counting::Elements) {
    machine_.passedMs = {time.saturated(graph.make(Op::Ite, w, guard, now, consumed_), restBits)};
    const bool isAtEnd = instruction == ScanPlace::afterProgram;
    const std::set<std::uint32_t> touched = timersTouchedBy(instruction);
    passTimers(machine_, {ticks}, [&](std::uint32_t timer) { return isAtEnd || touched.contains(timer); });
  } else {
    const Graph::Bool passes = graph.lnot(graph.equal({ticks}, graph.literal(0, 16), 16));
    machine_.when(passes, [&] {
      refreshTimers(machine_, 1, {ticks},
                    [&](const TimerUse& use, Graph::Bool reached) { timerReached(use, reached); });
    });
  }
  tickSites.push_back({{instruction, visit, guard}, ticks});
  consumed_ = graph.make(Op::Ite, w, guard, now, consumed_);
}

}  // namespace rungproof
