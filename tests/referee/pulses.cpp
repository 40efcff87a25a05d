// High-speed counters (001:4121-4508) and pulse trains (001:4510-4782). Of the counters' modes those with internal
// direction (0), with a reset input (1) and with external direction (3); of the pulse outputs the single-segment PTO.
#include <algorithm>

#include "machine.hpp"

namespace rungproof::referee {
namespace {

constexpr std::array<int, 6> controlByte = {37, 47, 57, 137, 147, 157};
constexpr std::array<int, 6> equalEvent = {12, 13, 16, 32, 29, 33};
constexpr std::array<int, 6> directionEvent = {27, 14, 17, -1, 30, -1};
constexpr std::array<int, 6> resetEvent = {28, 15, 18, -1, 31, -1};

}  // namespace

void Machine::defineCounter(const Instruction& i) {
  HighSpeedCounter& c = highSpeed_.at(static_cast<std::size_t>(i.a.value));
  if (inRoutine_ || c.defined) return runTimeError();  // 0004, 000A (001:4129)
  c.defined = true;
  c.mode = static_cast<int>(i.b.value);
}

void Machine::highSpeed(const Instruction& i) {
  const auto number = static_cast<std::size_t>(i.a.value);
  HighSpeedCounter& c = highSpeed_.at(number);
  if (!c.defined) return runTimeError();  // 0001
  const int at = controlByte[number];
  const std::uint32_t control = load(Area::SM, at, 1);
  if ((control & 0x10U) != 0) c.up = (control & 0x08U) != 0;
  if ((control & 0x40U) != 0) c.current = static_cast<std::int32_t>(load(Area::SM, at + 1, 4));
  if ((control & 0x20U) != 0) c.preset = static_cast<std::int32_t>(load(Area::SM, at + 5, 4));
  c.enabled = (control & 0x80U) != 0;
}

/// Pulses at the inputs of the counters: any number at any time.
void Machine::count() {
  for (std::size_t n = 0; n < highSpeed_.size(); ++n) {
    HighSpeedCounter& c = highSpeed_[n];
    if (!c.defined || !c.enabled || random_.chance(50)) continue;
    if (c.mode == 1 && random_.chance(15)) {
      c.current = 0;
      tell("HSC" + std::to_string(n) + " reset from outside");
      raise(resetEvent[n]);
      continue;
    }
    if (c.mode == 3 && random_.chance(25)) {
      c.up = !c.up;
      tell("HSC" + std::to_string(n) + " changes its direction");
      raise(directionEvent[n]);
      continue;
    }
    std::int64_t pulses = random_.between(1, 4);
    const std::int64_t distance = (static_cast<std::int64_t>(c.preset) - c.current) * (c.up ? 1 : -1);
    if (distance > 0 && distance < 100000 && random_.chance(50)) pulses = distance + random_.between(-1, 1);
    for (; pulses > 0; --pulses) {
      c.current += c.up ? 1 : -1;
      if (c.current != c.preset) continue;
      tell("HSC" + std::to_string(n) + " at its preset");
      raise(equalEvent[n]);
    }
    if (telling_) tell("HC" + std::to_string(n) + " = " + std::to_string(c.current));
  }
}

void Machine::startTrain(PulseTrain& train, std::int64_t microseconds) {
  train.active = true;
  train.from = now_ + microseconds / 1000;
  train.by = now_ + microseconds / 1000 + 1;
}

void Machine::pulseOutput(const Instruction& i) {
  const int number = static_cast<int>(i.a.value);
  PulseTrain& train = trains_.at(static_cast<std::size_t>(number));
  const int at = 67 + 10 * number;
  const std::uint32_t control = load(Area::SM, at, 1);
  if ((control & 0x60U) != 0) return;  // PWM, profiles: not modelled, not drawn
  if ((control & 0x80U) == 0) {
    if (train.active) setSystemBit(at - 1, 7, true);
    train.active = train.pending = false;
    return;
  }
  if ((control & 0x01U) != 0) train.cycle = std::max(2, static_cast<int>(load(Area::SM, at + 1, 2)));
  if ((control & 0x04U) != 0) train.count = std::max<std::int64_t>(1, load(Area::SM, at + 5, 4));
  const std::int64_t microseconds = train.cycle * train.count * ((control & 0x08U) != 0 ? 1000 : 1);
  if (train.active && train.pending) return setSystemBit(at - 1, 6, true);
  if (train.active) {
    train.pending = true;
    train.pendingMicroseconds = microseconds;
    return;
  }
  startTrain(train, microseconds);
  setSystemBit(at - 1, 7, false);
  tell("PTO begins");
}

void Machine::pulseTime() {
  for (std::size_t n = 0; n < trains_.size(); ++n) {
    PulseTrain& train = trains_[n];
    if (!train.active || now_ < train.by) continue;
    train.active = false;
    if (train.pending) {
      train.pending = false;
      startTrain(train, train.pendingMicroseconds);
    } else {
      setSystemBit(static_cast<int>(66 + 10 * n), 7, true);
    }
    tell("PTO done");
    raise(static_cast<int>(19 + n));
  }
}

}  // namespace rungproof::referee
