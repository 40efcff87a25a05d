// Interrupt events of a run: edges of inputs, those of a stimulus and of a script, the queue they wait in, and the
// routines that run when interrupts are enabled (001:5327-5547).
#include <algorithm>
#include <utility>

#include "engine/simulator_hooks.hpp"
#include "ir/s7200/event_cause.hpp"
#include "ir/s7300/interrupt_lock.hpp"

namespace rungproof {

/// Edges of inputs that are events.
void Simulator::raiseInputEdges() {
  for (std::size_t input = 0; input < edgeInputs.size(); ++input) {
    const auto now = static_cast<std::uint32_t>(store_.get(Reg::PhysicalInput, edgeInputs[input].bit));
    if (now != (edgeInputs_ >> input & 1)) raise(edgeInputs[input].rising + (now == 0 ? 1 : 0));
    edgeInputs_ = (edgeInputs_ & ~(1U << input)) | now << input;
  }
}

/// The inputs are as the last scan has seen them.
void Simulator::forgetInputEdges() {
  for (std::size_t input = 0; input < edgeInputs.size(); ++input) {
    const auto now = static_cast<std::uint32_t>(store_.get(Reg::PhysicalInput, edgeInputs[input].bit));
    edgeInputs_ = (edgeInputs_ & ~(1U << input)) | now << input;
  }
}

/// An attached event enters its queue; a full queue loses it, as does a lock of SFC 39.
void Simulator::raise(int event) {
  if (!isRunning() || event < 0 || event >= blockEventEnd) return;
  const std::uint64_t content = store_.get(Reg::EventRoutine, static_cast<std::uint32_t>(event));
  if (content == 0 || isLocked(event, content)) return;
  attention_ = true;
  if (queue_.add(event, moment_, static_cast<int>(content) - 1)) return;
  if (!plan_.dialect().memory.hasSpecialMemory) return;  // no bit tells of it
  store_.save(Area::SM, 4 * 8 + static_cast<std::uint32_t>(eventInfo(event).group), 1, 1, true);
  report(Hazard::QueueOverflow, nullptr);
}

/// An event that somebody's stimulus names comes as it is; that nothing causes it is said.
void Simulator::raiseByStimulus(int event) {
  if (event < 0 || event >= blockEventEnd) return;
  if (!eventHasCause(machine_, event)) withoutCause_.insert(event);
  if (!meetsMissingBlock(event)) raise(event);
}

/// An event of an S7-300/400 whose block the program does not have; false: it has one.
bool Simulator::meetsMissingBlock(int event) {
  const auto isMissing = [&](int e) {
    return routineIn(e, store_.get(Reg::EventRoutine, static_cast<std::uint32_t>(e))) == 0;
  };
  if (!plan_.dialect().run.startsBlocks || !isRunning() || !isBlockEvent(event) || !isMissing(event)) return false;
  const WithoutBlock reaction = blockEventRow(blockOfEvent(event))->withoutBlock;
  if (reaction == WithoutBlock::Nothing) return true;
  const int programError = eventOfBlock(85);
  if (reaction == WithoutBlock::ProgramError && !isMissing(programError)) {
    raise(programError);
    return true;
  }
  withoutBlock_.insert(event);
  machine_.stop(Hazard::S7NotLoaded, true);
  return true;
}

/// 1 ms timers that reach their preset (001:5476).
void Simulator::raiseTimer(const TimerUse& use, bool reached) {
  if (reached && eventOfTimer(use.number) >= 0) raise(eventOfTimer(use.number));
}

/// Whether nothing can come in front of an instruction of this scan: the script names no place, no event waits, no edge
/// is remembered, and the CPU has no bit to reset there.
bool Simulator::isScriptQuiet() const {
  const bool namesNoPlace = script_->events.empty() && script_->ticks1.empty() && script_->writes.empty();
  const auto isUnknown = [](int edge) { return edge == 0; };
  if (!namesNoPlace || !queue_.empty() || !std::ranges::all_of(lastEdge_, isUnknown)) return false;
  return !touchesQueueBits_ &&
         (!plan_.dialect().memory.hasSpecialMemory || (store_.load(Area::SM, 4 * 8, 8) & 7U) == 0);
}

void Simulator::beginScript(std::uint32_t lengthMs) {
  visits_.assign(costs_.size(), 0);
  scriptedMs_ = lengthMs;
  passedMs_ = 0;
  for (const std::uint32_t timer : plan_.timedEvents)
    timedMs_[timer] = static_cast<std::uint32_t>(elapsedOf(timer)) + lengthMs;
}

void Simulator::endScript() {
  if (!isRunning()) return;
  for (const std::uint32_t timer : plan_.timedEvents) {
    const TimedRegisters registers = timedRegisters(timer);
    if (runsTimed(timer)) store_.set(registers.elapsed, registers.at, timedMs_[timer] % periodOf(timer), true);
  }
  scriptedMs_ = passedMs_ = 0;
}

/// ATCH of event 10 or 11 at a time of the scan that comes from outside, not before what has been.
void Simulator::attachTimed(std::uint32_t event) {
  const std::uint64_t now = external({External::AsyncTicks, event, machine_.current->id}, 32);
  if (now > passedMs_ && now <= scriptedMs_) passedMs_ = static_cast<std::uint32_t>(now);
  timedMs_[static_cast<std::size_t>(timerOfEvent(static_cast<int>(event)))] = scriptedMs_ - passedMs_;
}

std::uint64_t Simulator::periodOf(std::uint32_t timer) const {
  return store_.get(timedRegisters(timer).period, timedRegisters(timer).at);
}
std::uint64_t Simulator::elapsedOf(std::uint32_t timer) const {
  return store_.get(timedRegisters(timer).elapsed, timedRegisters(timer).at);
}
/// The delay that SFC 32 has started has passed.
void Simulator::endDelay(std::uint32_t timer) {
  const TimedRegisters registers = timedRegisters(timer);
  starts_.delayEnded(registers.at, periodOf(timer));
  store_.set(registers.period, registers.at, 0, true);
}
/// Whether the time of that event is counted.
bool Simulator::runsTimed(std::uint32_t timer) const {
  return periodOf(timer) != 0 && store_.get(Reg::EventRoutine, static_cast<std::uint32_t>(eventOfTimed(timer))) != 0;
}

/// Whether a timed event is due by the end of the scan, and before the others.
bool Simulator::mayBeDue(int event) const {
  const auto timer = static_cast<std::uint32_t>(timerOfEvent(event));
  const auto isDue = [&](std::uint32_t t) { return runsTimed(t) && timedMs_[t] >= periodOf(t); };
  const auto dueFor = [&](std::uint32_t t) { return timedMs_[t] - periodOf(t); };
  return isDue(timer) && std::ranges::all_of(plan_.timedEvents, [&](std::uint32_t other) {
           if (other == timer || !isDue(other) || dueFor(timer) > dueFor(other)) return true;
           return dueFor(timer) == dueFor(other) && eventInfo(event).rank < eventInfo(eventOfTimed(other)).rank;
         });
}

bool Simulator::hasCause(int event) {
  if (isTimedEvent(event)) return mayBeDue(event);
  if (isEdgeEvent(event)) return lastEdge_[static_cast<std::size_t>(edgeInputOf(event))] != edgeKind(event);
  return eventHasCause(machine_, event);
}

/// An event of the script.
void Simulator::occur(int event) {
  if (isTimerEvent(event) && script_->needsCauses) return;
  if (!script_->needsCauses && meetsMissingBlock(event)) return;
  const bool isAttached = store_.get(Reg::EventRoutine, static_cast<std::uint32_t>(event)) != 0;
  if (!isAttached || !isRunning()) return;
  forgetEdges();
  if (!hasCause(event)) {
    withoutCause_.insert(event);
    if (!script_->needsCauses) raise(event);
    return;
  }
  if (isTimedEvent(event)) {
    const auto timer = static_cast<std::uint32_t>(timerOfEvent(event));
    timedMs_[timer] -= static_cast<std::uint32_t>(periodOf(timer));
    passedMs_ = std::max(passedMs_, scriptedMs_ - std::min(scriptedMs_, timedMs_[timer]));
    if (isDelayEvent(event)) endDelay(timer);
  }
  if (isEdgeEvent(event)) lastEdge_[static_cast<std::size_t>(edgeInputOf(event))] = edgeKind(event);
  deviceEvent(machine_, event);
  raise(event);
}

/// Both edges of an input come in turn as long as both are followed; then nothing is known of the last one.
void Simulator::forgetEdges() {
  for (std::size_t input = 0; input < edgeInputs.size(); ++input) {
    const auto rising = static_cast<std::uint32_t>(edgeInputs[input].rising);
    const bool areFollowed = store_.get(Reg::EventRoutine, rising) != 0 &&
                             store_.get(Reg::EventRoutine, rising + 1) != 0 &&
                             store_.get(Reg::InterruptsEnabled, 0) != 0;
    if (!areFollowed) lastEdge_[input] = 0;
  }
}

/// What the script says of a place: ticks, no more of them than the scan has ms, then events. After the program the
/// rest of the scan's time passes.
void Simulator::scripted(Runner& runner, ScanPlace place) {
  const auto isHere = [&](const ScanPlace& other) { return other == place; };
  const auto pass = [&](std::uint32_t ticks) {
    if (ticks == 0) return;
    refreshTimers(machine_, 1, ticks, [&](const TimerUse& use, bool reached) { raiseTimer(use, reached); });
    scriptedTicks_ += ticks;
  };
  const bool isEnd = place.instruction == ScanPlace::afterProgram;
  for (const ScanScript::Tick& tick : script_->ticks1) {
    if (!isEnd && isHere(tick.place)) pass(std::min(tick.ticks, scriptedMs_ - std::min(scriptedMs_, scriptedTicks_)));
  }
  if (isEnd && scriptedMs_ > scriptedTicks_) pass(scriptedMs_ - scriptedTicks_);
  scriptedWrites(place);
  forgetEdges();
  bool isTogether = false;  // with the event before
  for (const ScanScript::Event& event : script_->events) {
    if (!isHere(event.place)) continue;
    if (!event.isFromQueue) occur(event.event);
    if (!event.isWithNext && isTogether)
      serveInterrupts(runner);
    else if (!event.isWithNext)
      serveEvent(runner, event.event);
    isTogether = event.isWithNext;
  }
  serveInterrupts(runner);
  if (!isEnd || machine_.inInterrupt) return;
  while (machine_.guard && isRunning()) {
    const auto due =
        std::ranges::find_if(plan_.timedEvents, [&](std::uint32_t t) { return mayBeDue(eventOfTimed(t)); });
    if (due == plan_.timedEvents.end()) return;
    occur(eventOfTimed(*due));
    serveInterrupts(runner);
  }
}

/// Runs the routine of an event that waits: where several came at one place, the script says in which order they run.
void Simulator::serveEvent(Runner& runner, int event) {
  if (!mayServe() || !machine_.guard || !isRunning() || store_.get(Reg::InterruptsEnabled, 0) == 0) return;
  if (const auto waiting = queue_.take(event)) runRoutine(runner, *waiting);
}

/// A routine of an S7-200 is not interrupted (001:5426), an organization block by higher priority (002:817) and never
/// the start-up. What a script names stands where nothing runs.
bool Simulator::mayServe() const {
  if (machine_.isStartUp) return false;
  if (!machine_.inInterrupt) return true;
  return plan_.dialect().run.ranksEvents && script_ == nullptr && !queue_.empty() &&
         priorityOf(*queue_.next()) > priority_;
}

void Simulator::serveInterrupts(Runner& runner) {
  if (!mayServe()) return;
  while (!queue_.empty() && mayServe() && machine_.guard && isRunning() && store_.get(Reg::InterruptsEnabled, 0) != 0) {
    runRoutine(runner, *queue_.take());
  }
  if (queue_.empty() && (store_.load(Area::SM, 4 * 8, 8) & 7U) != 0) {  // no S7-300/400 has SM
    for (std::uint32_t bit = 0; bit < eventGroupCount; ++bit)
      store_.save(Area::SM, 4 * 8 + bit, 1, 0, true);  // 001:14113
  }
}

/// Runs the routine that the event has now, or had when it was queued (Choice::DetachedEvents).
void Simulator::runRoutine(Runner& runner, const InterruptQueue::Waiting& waiting) {
  const auto now = static_cast<int>(
      routineIn(waiting.event, store_.get(Reg::EventRoutine, static_cast<std::uint32_t>(waiting.event))));
  const int interrupted = std::exchange(priority_, isBlockEvent(waiting.event) ? priorityOf(waiting.event) : 0);
  runner.interrupt(now != 0 ? now - 1 : waiting.routine, true);
  priority_ = interrupted;
  position_ += pending_;
  pending_ = 0;
  if (!isRunning()) queue_.clear();  // STOP in the routine (001:5695)
}

}  // namespace rungproof
