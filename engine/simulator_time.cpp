// What happens at instruction boundaries: the 1 ms clock, the watchdog, interrupts, and the devices that instructions
// set going. Instruction times: Appendix F (001:14522-14646); interrupts: 001:5327-5547; watchdog: 001:5697-5722.
#include <algorithm>

#include "engine/device_end.hpp"
#include "engine/simulator_hooks.hpp"

namespace rungproof {

namespace {

constexpr std::uint32_t idleTime = 100;      // 1 us without power flow (001:14522)
constexpr std::uint32_t pointerTime = 1400;  // per indirect operand (001:14528)
constexpr std::uint32_t unlistedTime = 100;  // instructions whose time the text has lost
constexpr std::uint32_t firstTimedEvent = 10;

}  // namespace

void Simulator::prepareCosts() {
  costs_.assign(plan_.program->instructionCount(), Cost{{unlistedTime, unlistedTime}, nullptr});
  for (const Flow& flow : plan_.flows) {
    for (const FlowStep& step : flow.steps) {
      const Desc& desc = *step.instruction->desc;
      std::uint32_t time = desc.time == 0 ? unlistedTime : desc.time;
      for (const Operand& operand : step.instruction->operands) {
        if (operand.kind == OperandKind::Indirect) time += pointerTime;
      }
      costs_[step.id] = {{desc.execution == Execution::Conditional ? idleTime : time, time},
                         executionOf(*step.instruction)};
    }
  }
}

/// Edges of I0.0-I0.3 are events 0 to 7: rising even, falling odd (001:5460).
void Simulator::raiseInputEdges() {
  for (std::uint32_t input = 0; input < 4; ++input) {
    const auto now = static_cast<std::uint32_t>(store_.get(Reg::PhysicalInput, input));
    if (now != (edgeInputs_ >> input & 1)) raise(static_cast<int>(input * 2 + (now == 0 ? 1 : 0)));
    edgeInputs_ = (edgeInputs_ & ~(1U << input)) | now << input;
  }
}

void Simulator::raise(int event) {
  if (!isRunning() || event < 0 || event >= eventCount) return;
  if (store_.get(Reg::EventRoutine, static_cast<std::uint32_t>(event)) == 0) return;
  attention_ = true;
  if (queue_.add(event, moment_)) return;
  store_.save(Area::SM, 4 * 8 + static_cast<std::uint32_t>(eventInfo(event).group), 1, 1, true);
  report(Hazard::QueueOverflow, nullptr);
}

void Simulator::boundary(Runner& runner, const FlowStep* step) {
  if (!machine_.guard) return;
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
    attention_ = !queue_.empty() || observer_ != nullptr;
  }
  if (observer_ != nullptr && step != nullptr && machine_.guard) observer_->before(machine_, *step->instruction);
}

/// Writes that no running request allows are passed over, as are events that are not attached.
void Simulator::scriptedWrites(ScanPlace place) {
  std::vector<const ScanScript::Write*> legal;
  for (const ScanScript::Write& write : script_->writes) {
    if (write.place == place && mayDeviceWrite(machine_, write.operand, write.value)) legal.push_back(&write);
  }
  for (const ScanScript::Write* write : legal) writeByDevice(write->operand, write->value);
}

void Simulator::scripted(Runner& runner, ScanPlace place) {
  const auto isHere = [&](const ScanPlace& other) { return other == place; };
  for (const ScanScript::Tick& tick : script_->ticks1) {
    if (!isHere(tick.place)) continue;
    refreshTimers(machine_, 1, tick.ticks);
    scriptedTicks_ += tick.ticks;
  }
  scriptedWrites(place);
  for (const ScanScript::Event& event : script_->events) {
    if (isHere(event.place)) runRoutine(runner, event.event);
  }
}

/// What an instruction did that the registers do not tell.
void Simulator::signal(Signal which, std::uint32_t index) {
  switch (which) {
    case Signal::EventAttached:
      if (index != firstTimedEvent && index != firstTimedEvent + 1) break;
      timedPeriod_[index - firstTimedEvent] = store_.area(Area::SM)[34 + index - firstTimedEvent];
      timedElapsed_[index - firstTimedEvent] = 0;
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
    case Signal::HscLoaded:
    case Signal::EventDetached: break;  // the registers say it all
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
  refreshTimers(machine_, 1, 1, [&](const TimerUse& use, bool reached) {
    if (reached && use.number == 32) raise(21);
    if (reached && use.number == 96) raise(22);
  });
  for (std::uint32_t timer = 0; timer < timedPeriod_.size(); ++timer) {
    const std::uint32_t event = firstTimedEvent + timer;
    if (timedPeriod_[timer] == 0 || store_.get(Reg::EventRoutine, event) == 0) continue;
    if (++timedElapsed_[timer] < timedPeriod_[timer]) continue;
    timedElapsed_[timer] = 0;
    raise(static_cast<int>(event));
  }
  devices_.passMillisecond(store_, [this, &runner](int event) {
    raise(event);
    serveInterrupts(runner);
  });
  checkWatchdog();
}

void Simulator::checkWatchdog() {
  machine_.hazard(Hazard::FatalWatchdog,
                  position_ - watchdogFrom_ > static_cast<std::uint64_t>(options_.choices.watchdogMs()) * Cost::perMs);
}

void Simulator::serveInterrupts(Runner& runner) {
  if (machine_.inInterrupt) return;
  while (!queue_.empty() && machine_.guard && isRunning() && store_.get(Reg::InterruptsEnabled, 0) != 0) {
    runRoutine(runner, *queue_.take());
  }
  if (queue_.empty()) {
    for (std::uint32_t bit = 0; bit < eventGroupCount; ++bit)
      store_.save(Area::SM, 4 * 8 + bit, 1, 0, true);  // 001:14113
  }
}

/// Runs the routine of an event, if it still has one.
void Simulator::runRoutine(Runner& runner, int event) {
  const std::uint64_t routine = store_.get(Reg::EventRoutine, static_cast<std::uint32_t>(event));
  if (routine == 0 || store_.get(Reg::InterruptsEnabled, 0) == 0 || machine_.inInterrupt) return;
  runner.interrupt(static_cast<int>(routine) - 1, true);
  position_ += pending_;
  pending_ = 0;
  if (!isRunning()) queue_.clear();  // STOP in the routine (001:5695)
}

/// The rest of the scan after the program, tick by tick.
void Simulator::passRest(Runner& runner, std::uint32_t lengthUs) {
  position_ += pending_;
  pending_ = 0;
  machine_.guard = !machine_.halted;
  machine_.current = nullptr;
  boundary(runner, nullptr);
  if (script_ != nullptr) {
    const std::uint32_t ticks = lengthUs / 1000;
    if (machine_.guard && ticks > scriptedTicks_) refreshTimers(machine_, 1, ticks - scriptedTicks_);
    machine_.guard = true;
    return;
  }
  const std::uint64_t asked = static_cast<std::uint64_t>(lengthUs) * Cost::perUs;
  const auto end = [&] { return std::max(asked, (position_ + Cost::perUs - 1) / Cost::perUs * Cost::perUs); };
  while (machine_.guard && nextMs_ <= end()) {
    position_ = std::max(position_, nextMs_);
    boundary(runner, nullptr);
  }
  machine_.guard = true;
}

}  // namespace rungproof
