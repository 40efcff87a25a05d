// Counting, one pulse at a time, so that an interrupt routine can act between two pulses.
#include "engine/high_speed_counters.hpp"

#include <utility>

#include "ir/s7200/hsc_inputs.hpp"

namespace rungproof {

namespace {

/// Events of a counter; -1: it has none (table 6-46). HSC5 has direction and reset on the S7-200 SMART only.
struct CounterEvents {
  int equal, direction, reset;
};
constexpr std::array<CounterEvents, HighSpeedCounters::count> events = {
    {{12, 27, 28}, {13, 14, 15}, {16, 17, 18}, {32, -1, -1}, {29, 30, 31}, {33, 43, 44}}};
constexpr std::array<std::uint32_t, HighSpeedCounters::count> statusByte = {36, 46, 56, 136, 146, 156};

int modeOf(const Concrete::Store& store, std::uint32_t counter) {
  return static_cast<int>(store.get(Reg::HscMode, counter)) - 1;
}
bool setupBit(const Concrete::Store& store, std::uint32_t counter, int bit) {
  return (store.get(Reg::HscSetup, counter) >> bit & 1) != 0;
}
bool hasReset(int mode) { return mode < 12 && mode % 3 >= 1; }
bool hasStart(int mode) { return mode < 12 && mode % 3 == 2; }
bool isQuadrature(int mode) { return mode >= 9 && mode <= 11; }

/// Steps from one state of the lines A and B to the next: 1 forwards, -1 backwards, 0 none or both lines at once.
int quadratureStep(bool a0, bool b0, bool a1, bool b1) {
  if (a0 == a1 && b0 == b1) return 0;
  if (a0 != a1 && b0 != b1) return 0;
  if (a0 != a1) return a1 != b1 ? 1 : -1;
  return a1 == b1 ? 1 : -1;
}

}  // namespace

void HighSpeedCounters::reset() {
  seen_ = {};
  hasSeen_ = false;
}

void HighSpeedCounters::beginScan(Concrete::Store& store, std::uint32_t lengthMs, const RaiseEvent& raise) {
  scanMs_ = lengthMs == 0 ? 1 : lengthMs;
  passed_ = 0;
  const auto& inputs = store.terminals(Reg::PhysicalInput);
  const Inputs before = std::exchange(seen_, inputs);
  hasSeen_ = true;
  if (areIdle(store)) return;
  for (std::uint32_t counter = 0; counter < count; ++counter)
    takeInputs(store, counter, linesOf(before, counter), raise);
}

HighSpeedCounters::Lines HighSpeedCounters::linesOf(const Inputs& inputs, std::uint32_t counter) const {
  Lines lines;
  for (std::size_t k = 0; k < lines.level.size(); ++k) {
    const int input = hscInputs(target_, static_cast<int>(counter))[k];
    lines.level[k] = input >= 0 && (inputs[static_cast<std::size_t>(input) / 8] >> (input % 8) & 1) != 0;
  }
  return lines;
}

void HighSpeedCounters::takeInputs(Concrete::Store& store, std::uint32_t counter, const Lines& before,
                                   const RaiseEvent& raise) {
  const Lines now = linesOf(seen_, counter);
  const int mode = modeOf(store, counter);
  if (mode < 0 || store.get(Reg::HscEnabled, counter) == 0) return;
  const bool starts = !hasStart(mode) || now.level[3] != setupBit(store, counter, 1);
  if (hasReset(mode) && starts) {
    const bool activeNow = now.level[2] != setupBit(store, counter, 0);
    const bool activeBefore = before.level[2] != setupBit(store, counter, 0);
    if (activeNow) store.set(Reg::HscCurrent, counter, 0, true);
    if (activeNow && !activeBefore && events[counter].reset >= 0) raise(events[counter].reset);
  }
  if (mode >= 3 && mode <= 5) turn(store, counter, now.level[1], raise);
  if (mode <= 5 && now.level[0] && !before.level[0]) feed(store, counter, 1, 0, raise);
  if (mode >= 6 && mode <= 8) {
    const bool up = now.level[0] && !before.level[0], down = now.level[1] && !before.level[1];
    if (up != down) feed(store, counter, up ? 1 : 0, down ? 1 : 0, raise);  // both at once count nothing (001:4249)
  }
  if (isQuadrature(mode) && mayCount(store, counter)) {
    const int steps = quadratureStep(before.level[0], before.level[1], now.level[0], now.level[1]);
    const bool everyStep = !setupBit(store, counter, 2);
    const bool isPeriod = now.level[0] != before.level[0] && now.level[0] && !now.level[1];
    const bool isPeriodBack = now.level[0] != before.level[0] && !now.level[0] && !now.level[1];
    if (steps > 0 && (everyStep || isPeriod)) step(store, counter, true, raise);
    if (steps < 0 && (everyStep || isPeriodBack)) step(store, counter, false, raise);
  }
}

void HighSpeedCounters::passMillisecond(Concrete::Store& store, const PulseCounts& ptoPulses, const RaiseEvent& raise) {
  const auto share = [&](std::uint32_t total) {
    const std::uint64_t before = static_cast<std::uint64_t>(total) * (passed_ - 1) / scanMs_;
    const std::uint64_t after = static_cast<std::uint64_t>(total) * passed_ / scanMs_;
    return static_cast<std::uint32_t>(passed_ <= scanMs_ ? after - before : 0);
  };
  ++passed_;
  for (std::uint32_t counter = 0; counter < count; ++counter) {
    const int mode = modeOf(store, counter);
    if (mode < 0) continue;
    const std::uint32_t up = share(pulses_[counter][0]), down = share(pulses_[counter][1]);
    if (mode == 12) {
      feed(store, counter, ptoPulses[counter == 0 ? 0 : 1], 0, raise);
      continue;
    }
    const std::uint32_t factor = isQuadrature(mode) && !setupBit(store, counter, 2) ? 4 : 1;
    feed(store, counter, up * factor, down * factor, raise);
  }
}

bool HighSpeedCounters::mayCount(const Concrete::Store& store, std::uint32_t counter) const {
  const int mode = modeOf(store, counter);
  if (mode < 0 || store.get(Reg::HscEnabled, counter) == 0) return false;
  const Lines lines = linesOf(seen_, counter);
  if (hasStart(mode) && lines.level[3] == setupBit(store, counter, 1)) return false;  // frozen (001:4184)
  return !(hasReset(mode) && lines.level[2] != setupBit(store, counter, 0));          // held at 0
}

void HighSpeedCounters::feed(Concrete::Store& store, std::uint32_t counter, std::uint32_t up, std::uint32_t down,
                             const RaiseEvent& raise) {
  const int mode = modeOf(store, counter);
  const bool bySign = mode >= 6 && mode != 12;
  for (std::uint32_t i = 0; i < up && mayCount(store, counter); ++i)
    step(store, counter, bySign || store.get(Reg::HscUp, counter) != 0, raise);
  for (std::uint32_t i = 0; i < down && bySign && mayCount(store, counter); ++i) step(store, counter, false, raise);
}

void HighSpeedCounters::step(Concrete::Store& store, std::uint32_t counter, bool up, const RaiseEvent& raise) {
  turn(store, counter, up, raise);
  const auto value = static_cast<std::uint32_t>(store.get(Reg::HscCurrent, counter)) + (up ? 1U : 0xFFFFFFFFU);
  store.set(Reg::HscCurrent, counter, value, true);
  showStatus(store, counter);
  if (value == store.get(Reg::HscPreset, counter)) raise(events[counter].equal);
}

void HighSpeedCounters::turn(Concrete::Store& store, std::uint32_t counter, bool up, const RaiseEvent& raise) {
  if ((store.get(Reg::HscUp, counter) != 0) == up) return;
  store.set(Reg::HscUp, counter, up ? 1 : 0, true);
  showStatus(store, counter);
  if (events[counter].direction >= 0 && modeOf(store, counter) >= 3) raise(events[counter].direction);
}

/// Status byte: bit 5 direction, 6 equal, 7 greater (001:4344).
void HighSpeedCounters::showStatus(Concrete::Store& store, std::uint32_t counter) {
  const auto current = static_cast<std::int32_t>(store.get(Reg::HscCurrent, counter));
  const auto preset = static_cast<std::int32_t>(store.get(Reg::HscPreset, counter));
  const unsigned bits = (store.get(Reg::HscUp, counter) != 0 ? 0x20U : 0U) | (current == preset ? 0x40U : 0U) |
                        (current > preset ? 0x80U : 0U);
  std::vector<std::uint8_t>& memory = store.area(Area::SM);
  if (statusByte[counter] < memory.size()) memory[statusByte[counter]] = static_cast<std::uint8_t>(bits);
}

}  // namespace rungproof
