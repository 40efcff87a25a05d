// When an interrupt event can occur, and what it changes in the machine at that moment, over any domain. Ports,
// counters and pulse outputs end what they do from outside: an event that tells of it can occur only while they are at
// it. Events 10 and 11 follow from the time, 21 and 22 from their timers: they have no cause here. Engine (scripted
// runs) and encoder both ask here. Covered by tests/environment/event_cause_test.cpp.
#pragma once

#include <optional>

#include "ir/machine/machine.hpp"
#include "ir/s7200/device_end.hpp"
#include "ir/s7200/event.hpp"
#include "ir/s7200/hsc_inputs.hpp"

namespace rungproof {

/// Entries that the queue of a group holds (001:5487).
inline std::size_t queueDepth(const Target& target, EventGroup group) {
  const CpuFeatures features = cpuFeatures(target);
  switch (group) {
    case EventGroup::Communication: return static_cast<std::size_t>(features.queueCommunication);
    case EventGroup::InputOutput: return static_cast<std::size_t>(features.queueIo);
    case EventGroup::Timed: return static_cast<std::size_t>(features.queueTimed);
  }
  return 0;
}

/// What a high-speed counter tells by an event (table 6-46).
enum class CounterEvent : std::uint8_t { Equal, Direction, Reset };
struct CounterEventInfo {
  std::uint32_t counter;
  CounterEvent kind;
};
constexpr std::optional<CounterEventInfo> counterEvent(int event) {
  using enum CounterEvent;
  switch (event) {
    case 12: return CounterEventInfo{0, Equal};
    case 27: return CounterEventInfo{0, Direction};
    case 28: return CounterEventInfo{0, Reset};
    case 13: return CounterEventInfo{1, Equal};
    case 14: return CounterEventInfo{1, Direction};
    case 15: return CounterEventInfo{1, Reset};
    case 16: return CounterEventInfo{2, Equal};
    case 17: return CounterEventInfo{2, Direction};
    case 18: return CounterEventInfo{2, Reset};
    case 32: return CounterEventInfo{3, Equal};
    case 29: return CounterEventInfo{4, Equal};
    case 30: return CounterEventInfo{4, Direction};
    case 31: return CounterEventInfo{4, Reset};
    case 33: return CounterEventInfo{5, Equal};
    case 43: return CounterEventInfo{5, Direction};
    case 44: return CounterEventInfo{5, Reset};
    default: return std::nullopt;
  }
}

/// Whether a counter in that mode can have such an event: a direction changes from outside in modes 3 to 11, a reset
/// comes in modes with a reset input (001:4216-4237, 001:4464).
constexpr bool counterModeHas(CounterEvent kind, int mode) {
  switch (kind) {
    case CounterEvent::Equal: return true;
    case CounterEvent::Direction: return mode >= 3 && mode <= 11;
    case CounterEvent::Reset: return hscModeUses(mode, 2);
  }
  return false;
}

/// What a serial port tells by an event.
enum class PortEvent : std::uint8_t { Character, Transmitted, Message };
struct PortEventInfo {
  std::uint32_t port;
  PortEvent kind;
};
constexpr std::optional<PortEventInfo> portEvent(int event) {
  switch (event) {
    case 8: return PortEventInfo{0, PortEvent::Character};
    case 9: return PortEventInfo{0, PortEvent::Transmitted};
    case 23: return PortEventInfo{0, PortEvent::Message};
    case 25: return PortEventInfo{1, PortEvent::Character};
    case 26: return PortEventInfo{1, PortEvent::Transmitted};
    case 24: return PortEventInfo{1, PortEvent::Message};
    default: return std::nullopt;
  }
}

/// Whether the event can occur in the state as it is, the time aside (false for 10, 11, 21 and 22).
template <class D>
typename D::Bool eventHasCause(Machine<D>& m, int event) {
  D& d = m.d;
  if (isTimedEvent(event) || isTimerEvent(event)) return d.constant(false);
  if (isPulseEvent(event)) {  // a train of pulses ends (001:4584)
    const std::uint32_t output = outputOfTrain(event);
    return d.land(m.getBit(Reg::PulseBusy, output), d.lnot(m.getBit(Reg::PulseIsPwm, output)));
  }
  if (const auto port = portEvent(event)) {
    const auto busy = m.get(Reg::PortBusy, port->port);
    if (port->kind == PortEvent::Transmitted) return d.bit(busy, 0);
    if (port->kind == PortEvent::Message) return d.bit(busy, 1);
    // A single character, in Freeport mode, that no reception takes (001:3324, 001:14176).
    const auto mode = d.extract(m.load(Area::SM, port->port == 0 ? 30 : 130, Width::Byte), 1, 0);
    return d.land(d.equal(mode, m.number(1, 2), 2), d.lnot(d.bit(busy, 1)));
  }
  if (const auto counter = counterEvent(event)) {  // after HDEF and HSC only (001:4308)
    const auto defined = m.get(Reg::HscMode, counter->counter);
    auto isInMode = d.constant(false);
    for (int mode = 0; mode <= 12; ++mode) {
      if (hscHasMode(m.target, static_cast<int>(counter->counter), mode) && counterModeHas(counter->kind, mode))
        isInMode = d.lor(isInMode, d.equal(defined, m.number(static_cast<std::uint64_t>(mode) + 1, 8), 8));
    }
    return d.land(isInMode, m.getBit(Reg::HscEnabled, counter->counter));
  }
  return d.constant(true);
}

/// What the device writes when the event occurs, before any routine runs. Bytes from the line are external values.
template <class D>
void deviceEvent(Machine<D>& m, int event) {
  D& d = m.d;
  if (isPulseEvent(event)) {
    const std::uint32_t output = outputOfTrain(event);
    const auto goesOn = m.getBit(Reg::PulsePending, output);
    endPulseTrain(m, output);
    m.when(d.lnot(goesOn), [&] { m.setSm(pulseStatus(output), pulseIdle, d.constant(true)); });
    return;
  }
  const auto port = portEvent(event);
  if (!port) return;
  switch (port->kind) {
    case PortEvent::Character:  // 001:3324, 001:14079
      m.save(Area::SM, 2, Width::Byte, m.external(External::ReceivedByte, port->port, 8));
      m.setSm(3, 0, m.externalBit(External::ReceivedByte, 2 + port->port));
      break;
    case PortEvent::Transmitted:
      endPortUse(m, port->port, PortUse::Transmission);
      m.setSm(4, transmitterBit(port->port), d.constant(true));
      break;
    case PortEvent::Message: {  // the status tells how it ended by itself: by e, t, c or p (001:14286)
      const auto status = d.band(m.external(External::ReceivedByte, 4 + port->port, 8), m.number(0x27, 8), 8);
      endPortUse(m, port->port, PortUse::Reception);
      m.save(Area::SM, receiveStatus(port->port), Width::Byte,
             d.select(d.equal(status, m.number(0, 8), 8), m.number(0x02, 8), status, 8));
      break;
    }
  }
}

}  // namespace rungproof
