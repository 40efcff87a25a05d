// What happens at instruction boundaries: the 1 ms clock, the watchdog, and the devices that instructions set going;
// interrupts: simulator_events.cpp. Instruction times: Appendix F (001:14522-14646); watchdog: 001:5697-5722.
// Tested by tests/engine.
#include <algorithm>
#include <utility>

#include "engine/device_end.hpp"
#include "engine/simulator_hooks.hpp"

namespace rungproof {

namespace {

constexpr std::uint32_t idleTime = 100;      // 1 us without power flow (001:14522)
constexpr std::uint32_t pointerTime = 1400;  // per indirect operand (001:14528)

}  // namespace

void Simulator::prepareCosts() {
  const RunModel& run = plan_.dialect().run;
  costs_.assign(plan_.program->instructionCount(), Cost{{run.usualTime, run.usualTime}, nullptr});
  for (const Flow& flow : plan_.flows) {
    for (const FlowStep& step : flow.steps) {
      const Desc& desc = *step.instruction->desc;
      costs_[step.id()].run = executionOf(*step.instruction, plan_.form());
      if (!run.listsTimes) continue;
      std::uint32_t time = desc.time == 0 ? run.usualTime : desc.time;
      for (const Operand& operand : step.instruction->operands) {
        if (operand.kind == OperandKind::Indirect) time += pointerTime;
      }
      costs_[step.id()].time = {desc.execution == Execution::Conditional ? idleTime : time, time};
    }
  }
}

std::vector<std::uint32_t> Simulator::longestTimes() const {
  std::vector<std::uint32_t> times;
  for (const Cost& cost : costs_) times.push_back(std::max(cost.time[0], cost.time[1]));
  return times;
}

std::optional<std::uint64_t> Simulator::quietTime(std::uint32_t lengthUs, std::uint32_t sinceTick) const {
  const std::uint64_t asked = static_cast<std::uint64_t>(lengthUs) * Cost::perUs;
  if (asked > watchdogTime()) return std::nullopt;
  return hasFineTimers_ ? std::min<std::uint64_t>(asked, Cost::perMs - sinceTick - 1) : asked;
}

void Simulator::boundary(Runner& runner, const FlowStep* step) {
  if (!machine_.guard) return;
  if (!hasWatchdog_ && step != nullptr) watchLoops(*step);
  if (script_ != nullptr) {
    checkWatchdog();
    const std::uint32_t id = step == nullptr ? ScanPlace::afterProgram : step->instruction->id;
    scripted(runner, {id, step == nullptr ? 0 : visits_[id]++});
  } else {
    while (position_ >= nextMs_ && machine_.guard) {
      nextMs_ += Cost::perMs;
      passMillisecond(runner);
    }
    serveInterrupts(runner);
    attention_ = !queue_.empty() || observer_ != nullptr || (!hasWatchdog_ && position_ >= Cost::perMs);
  }
  if (observer_ != nullptr && step != nullptr && machine_.guard) observer_->before(machine_, *step->instruction);
}

/// In a scan that lasts long already, in front of every instruction.
void Simulator::watchLoops(const FlowStep& step) {
  if (position_ < Cost::perMs) return;
  if (script_ != nullptr) nextMs_ = 0;
  loop_.step(step.instruction->id);
  if (step.instruction->desc->control != Control::LabelMark) return;
  if (loop_.returns(step.instruction->id, store_.area(Area::V))) machine_.hazard(plan_.dialect().run.endlessScan, true);
}

/// Writes that no running request allows are passed over, as are events that are not attached.
void Simulator::scriptedWrites(ScanPlace place) {
  std::vector<const ScanScript::Write*> legal;
  for (const ScanScript::Write& write : script_->writes) {
    if (write.place == place && mayDeviceWrite(machine_, write.operand, write.value)) legal.push_back(&write);
  }
  for (const ScanScript::Write* write : legal) writeByDevice(write->operand, write->value);
}

/// What an instruction did that the registers do not tell.
void Simulator::signal(Signal which, std::uint32_t index) {
  switch (which) {
    case Signal::EventAttached:
      if (script_ != nullptr && isTimedEvent(static_cast<int>(index))) attachTimed(index);
      break;
    case Signal::EventDetached:
      if (isBlockEvent(static_cast<int>(index)) ? machine_.isStartUp  // nothing has come before the start
                                                : options_.choices.is(Choice::DetachedEvents, "dropped"))
        queue_.drop(static_cast<int>(index));
      break;
    case Signal::EventsCleared: queue_.drop(static_cast<int>(index)); break;
    case Signal::WatchdogRestarted: watchdogFrom_ = position_; break;
    case Signal::Stopped: stoppedBy_ = machine_.current; break;
    case Signal::ClockSet: setClock(); break;
    case Signal::PulseCommand: devices_.pulses.command(store_, index); break;
    case Signal::TransmitStarted: devices_.ports.transmitStarted(store_, index); break;
    case Signal::ReceiveStarted: devices_.ports.receiveStarted(store_, index); break;
    case Signal::ReceiveEnded: devices_.ports.receiveEnded(index, [this](int event) { raise(event); }); break;
    case Signal::NetworkStarted: devices_.network.started(index); break;
    case Signal::HscLoaded: break;  // the registers say it all
  }
}

/// TODW and TODWX: the bytes are BCD and stand in Reg::ClockSetting.
void Simulator::setClock() {
  const auto field = [&](std::uint32_t i) {
    const auto byte = static_cast<int>(store_.get(Reg::ClockSetting, i));
    return byte / 16 * 10 + byte % 16;
  };
  devices_.clock.set({field(0), field(1), field(2), field(3), field(4), field(5), field(7)}, clockMs_);
}

/// One tick of the 1 ms clock.
void Simulator::passMillisecond(Runner& runner) {
  ++moment_;
  ++clockMs_;
  refreshTimers(machine_, 1, 1, [&](const TimerUse& use, bool reached) { raiseTimer(use, reached); });
  for (const std::uint32_t timer : plan_.timedEvents) {
    if (!runsTimed(timer)) continue;
    const TimedRegisters registers = timedRegisters(timer);
    const std::uint64_t period = periodOf(timer), elapsed = elapsedOf(timer) + 1;
    store_.set(registers.elapsed, registers.at, elapsed < period ? elapsed : 0, true);
    if (elapsed < period) continue;
    if (isDelayEvent(eventOfTimed(timer))) endDelay(timer);
    raise(eventOfTimed(timer));
  }
  devices_.passMillisecond(store_, [this, &runner](int event) {
    raise(event);
    serveInterrupts(runner);
  });
  checkWatchdog();
}

/// The first time in a scan an S7-300/400 calls OB80, if the program has it (002:1296, 002:1314).
void Simulator::checkWatchdog() {
  if (isInTime(position_)) return;
  const int event = eventOfBlock(80);
  const bool isCalled =
      plan_.dialect().run.startsBlocks && store_.get(Reg::EventRoutine, static_cast<std::uint32_t>(event)) != 0;
  if (script_ != nullptr || !isCalled || std::exchange(hasTimeError_, true))
    return machine_.hazard(plan_.dialect().run.endlessScan, true);
  watchdogFrom_ = position_;
  raise(event);
}

bool Simulator::isInTime(std::uint64_t position) const {
  return position - watchdogFrom_ <= watchdogTime() && position <= longestScan_;
}

/// 10 ns; how long a script that names no place in the scan is not looked at.
std::uint64_t Simulator::quietTime() const { return hasWatchdog_ ? watchdogTime() + 1 : Cost::perMs; }

/// Whether up to there the ticks of the 1 ms clock let timers count and do nothing else.
bool Simulator::isQuietUntil(std::uint64_t position) const {
  const auto isAttached = [&](int event) {
    return event >= 0 && store_.get(Reg::EventRoutine, static_cast<std::uint32_t>(event)) != 0;
  };
  if (std::ranges::any_of(plan_.timedEvents, [&](std::uint32_t t) { return isAttached(eventOfTimed(t)); }))
    return false;
  const bool raisesEvents =
      std::ranges::any_of(plan_.timers, [&](const TimerUse& use) { return isAttached(eventOfTimer(use.number)); });
  return !raisesEvents && queue_.empty() && observer_ == nullptr && devices_.areIdle(store_) && isInTime(position);
}

/// The rest of the scan after the program, tick by tick, or at once where no tick makes a difference.
void Simulator::passRest(Runner& runner, std::uint32_t lengthUs) {
  position_ += pending_;
  pending_ = 0;
  machine_.guard = !machine_.halted;
  machine_.current = nullptr;
  boundary(runner, nullptr);
  if (script_ != nullptr) {
    machine_.guard = true;
    return;
  }
  const std::uint64_t asked = static_cast<std::uint64_t>(lengthUs) * Cost::perUs;
  const auto end = [&] { return std::max(asked, (position_ + Cost::perUs - 1) / Cost::perUs * Cost::perUs); };
  if (machine_.guard && nextMs_ <= end() && isQuietUntil(end())) {
    const std::uint64_t ticks = (end() - nextMs_) / Cost::perMs + 1;
    position_ = std::max(position_, nextMs_ + (ticks - 1) * Cost::perMs);
    nextMs_ += ticks * Cost::perMs;
    moment_ += ticks;
    clockMs_ += ticks;
    for (std::uint64_t left = ticks; left > 0; left -= std::min<std::uint64_t>(left, longestStep))
      refreshTimers(machine_, 1, std::min<std::uint64_t>(left, longestStep));
  }
  while (machine_.guard && nextMs_ <= end()) {
    position_ = std::max(position_, nextMs_);
    boundary(runner, nullptr);
  }
  machine_.guard = true;
}

}  // namespace rungproof
