// What the CPU does around the program in every scan, over any domain: inputs are read, clocks and 10 ms timers
// advance, the program runs, SM is refreshed, outputs are written (001:1205-1254, 001:14045, 001:6605-6611).
//
// Time: a scan lasts `elapsed` ms from the reading of its inputs to the writing of its outputs. The 10 ms and 100 ms
// ticks of that time reach the timers in the next scan: 10 ms at its start, 100 ms when the timer is executed. In
// between they are held in PhaseTen and PhaseHundred, which are reduced only by takeTicks(). The 1 ms ticks are not
// handled here: they come at any instruction (refreshTimers).
// Covered by tests/engine/scan_cycle_test.cpp.
#pragma once

#include <algorithm>

#include "ir/machine/scan.hpp"
#include "ir/s7200/pulse_output.hpp"
#include "ir/s7200/timer_refresh.hpp"

namespace rungproof {

/// Ticks of the time bases since the start of the previous scan, width 16.
template <class D>
struct Ticks {
  typename D::Bits ten;
  typename D::Bits hundred;
};

/// Longest `elapsed` of one call of advanceClocks(), in ms.
inline constexpr int longestStep = 999;

/// ms: the periods of SM0.4 and SM0.5 (001:14054).
inline constexpr std::uint32_t minuteClock = 60'000, secondClock = 1000;

/// The whole ticks that have gathered in the phases; what is left of a tick stays there.
template <class D>
Ticks<D> takeTicks(Machine<D>& m) {
  const auto take = [&](Reg phase, std::uint64_t unit) {
    const auto gathered = m.get(phase);
    const auto divisor = m.number(unit, 16);
    m.set(phase, 0, m.d.urem(gathered, divisor, 16));
    return m.d.udiv(gathered, divisor, 16);
  };
  return {take(Reg::PhaseTen, 10), take(Reg::PhaseHundred, 100)};
}

/// The physical inputs to the I image.
template <class D>
void readInputs(Machine<D>& m) {
  if constexpr (std::same_as<typename D::Bool, bool>) {  // the same, byte by byte
    const auto& inputs = m.store.terminals(Reg::PhysicalInput);
    std::copy_n(inputs.begin(), m.terminals() / 8, m.store.area(Area::I).begin());
  } else {
    for (std::uint32_t bit = 0; bit < m.terminals(); ++bit)
      m.saveBit(Area::I, bit / 8, bit % 8, m.getBit(Reg::PhysicalInput, bit));
  }
}

/// Lets `elapsed` ms (width 16, at most longestStep) pass for all clocks.
template <class D>
void advanceClocks(Machine<D>& m, typename D::Bits elapsed) {
  const auto wrapAt = [&](Reg phase, std::uint64_t period) {
    const auto width = regInfo(phase).width;
    const auto sum = m.d.add(m.d.zext(m.get(phase), width, 17), m.d.zext(elapsed, 16, 17), 17);
    const auto limit = m.number(period, 17);
    const auto wrapped = m.d.select(m.d.ule(limit, sum, 17), m.d.sub(sum, limit, 17), sum, 17);
    m.set(phase, 0, m.d.extract(wrapped, width - 1, 0));
  };
  m.set(Reg::PhaseTen, 0, m.d.add(m.get(Reg::PhaseTen), elapsed, 16));
  m.set(Reg::PhaseHundred, 0, m.d.add(m.get(Reg::PhaseHundred), elapsed, 16));
  wrapAt(Reg::PhaseSecond, secondClock);
  wrapAt(Reg::PhaseMinute, minuteClock);
}

/// Bits of SM0 by their numbers.
template <class D>
struct StatusBit {
  std::uint32_t bit;
  typename D::Bool isOn;
};
template <class D, std::size_t count>
void showStatus(Machine<D>& m, const StatusBit<D> (&bits)[count]) {
  if constexpr (std::same_as<typename D::Bool, bool>) {  // the same, at once
    std::vector<std::uint8_t>& bytes = m.store.area(Area::SM);
    if (!m.guard || bytes.empty()) return;
    unsigned status = bytes[0];
    for (const StatusBit<D>& s : bits) status = (status & ~(1U << s.bit)) | (s.isOn ? 1U << s.bit : 0U);
    bytes[0] = static_cast<std::uint8_t>(status);
  } else {
    for (const StatusBit<D>& s : bits) m.setSm(0, s.bit, s.isOn);
  }
}

/// SM0.1 and SM0.4 to SM0.6 as the scan that begins shows them; the manual refreshes SM0 at the end of the scan before
/// (001:14045), which no program can tell from this, and properties and traces find in SM0 what the program saw. SM0.4
/// (1 min) and SM0.5 (1 s) are clocks (001:14054-14055). Where SM0.6 starts is Choice::ScanClockStart.
template <class D>
void beginStatus(Machine<D>& m) {
  const auto half = [&](Reg phase, std::uint64_t period) {
    const int width = regInfo(phase).width;
    return m.d.ule(m.number(period / 2, width), m.get(phase), width);
  };
  const auto first = m.getBit(Reg::FirstScan);
  const auto startsOn = m.reads({Choice::ScanClockStart, "on"});
  const auto other = m.d.lxor(m.sm(0, 6), m.getBit(Reg::Running));
  showStatus<D>(m, {{4, half(Reg::PhaseMinute, minuteClock)},
                    {5, half(Reg::PhaseSecond, secondClock)},
                    {1, first},
                    {6, m.d.select(first, startsOn, other)}});
}

/// SM0.2 and SM0.3 are on in the first scan only, and there as the surroundings say (001:14052-14053).
template <class D>
void endFirstScanBits(Machine<D>& m) {
  const auto first = m.getBit(Reg::FirstScan);
  showStatus<D>(m, {{2, m.d.land(first, m.sm(0, 2))}, {3, m.d.land(first, m.sm(0, 3))}});
}

/// Part 1 of the scan: the inputs, and the ticks of the 10 ms and 100 ms time bases.
template <class D>
void beginScan(Machine<D>& m, const Ticks<D>& ticks) {
  m.guard = m.d.constant(true);
  m.halted = m.faulted = m.d.constant(false);
  beginStatus(m);
  endFirstScanBits(m);
  readInputs(m);
  m.ticks100 = ticks.hundred;
  refreshTimers(m, 10, ticks.ten);
  beginScanOfTimers(m);
}

/// Part 2 of the scan: the program, in RUN only (001:1683).
template <class D, class Hooks>
void runProgram(Scan<D, Hooks>& scan) {
  Machine<D>& m = scan.machine();
  m.when(m.getBit(Reg::Running), [&] { scan.program(); });
  m.guard = m.d.constant(true);
}

/// The scan times SMW22, SMW24, SMW26 (001:14151-14153). `elapsed`: ms, width 16.
template <class D>
void refreshSpecialMemory(Machine<D>& m, typename D::Bits elapsed) {
  const auto first = m.getBit(Reg::FirstScan);
  const auto shortest = m.load(Area::SM, 24, Width::Word);
  const auto longest = m.load(Area::SM, 26, Width::Word);
  m.save(Area::SM, 22, Width::Word, elapsed);
  m.save(Area::SM, 24, Width::Word, m.d.select(m.d.lor(first, m.d.ult(elapsed, shortest, 16)), elapsed, shortest, 16));
  m.save(Area::SM, 26, Width::Word, m.d.select(m.d.lor(first, m.d.ult(longest, elapsed, 16)), elapsed, longest, 16));
  if (m.plan.dialect().run.keepsLastScan) m.set(Reg::LastScan, 0, elapsed);
  m.setBit(Reg::FirstScan, 0, m.d.constant(false));
}

/// Part 5 of the scan: the Q image to the physical outputs, except those that a pulse generator owns (001:4528).
/// In STOP the output table applies, of which all values are 0 (001:1749-1753).
template <class D>
void writeOutputs(Machine<D>& m) {
  if (m.terminals() == 0) return;  // IEC 61131-3: variables only
  const auto running = m.getBit(Reg::Running);
  const auto write = [&](std::uint32_t bit, typename D::Bool value) {
    const auto image = m.d.land(running, value);
    const std::optional<std::uint32_t> generator = bit < 8 ? generatorOf(bit) : std::nullopt;
    if (!generator) return m.setBit(Reg::PhysicalOutput, bit, image);
    const auto owned = m.d.land(running, m.getBit(Reg::PulseBusy, *generator));
    m.setBit(Reg::PhysicalOutput, bit, m.d.select(owned, m.getBit(Reg::PhysicalOutput, bit), image));
  };
  std::uint32_t from = 0;
  if constexpr (std::same_as<typename D::Bool, bool>) {  // the same, byte by byte where no generator is
    auto& outputs = m.store.terminals(Reg::PhysicalOutput);
    const auto count = static_cast<std::ptrdiff_t>(m.terminals() / 8);
    if (running)
      std::copy_n(m.store.area(Area::Q).begin() + 1, count - 1, outputs.begin() + 1);
    else
      std::fill_n(outputs.begin() + 1, count - 1, std::uint8_t{0});
    from = 8;
    bool isOwned = false;
    for (std::uint32_t i = 0; i < regInfo(Reg::PulseBusy).count; ++i) isOwned = isOwned || m.getBit(Reg::PulseBusy, i);
    if (!isOwned) outputs[0] = running ? m.store.area(Area::Q)[0] : std::uint8_t{0};
    for (std::uint32_t bit = 0; isOwned && bit < from; ++bit) write(bit, m.loadBit(Area::Q, 0, bit));
  }
  for (std::uint32_t bit = from; bit < m.terminals(); ++bit) {
    if constexpr (!std::same_as<typename D::Bool, bool>) write(bit, m.loadBit(Area::Q, bit / 8, bit % 8));
  }
}

/// Parts 3 to 5 of the scan: time passes, SM is refreshed, outputs are written.
template <class D>
void endScan(Machine<D>& m, typename D::Bits elapsed) {
  m.guard = m.d.constant(true);
  advanceClocks(m, elapsed);
  endScanOfTimers(m, m.d.zext(elapsed, 16, restBits));
  refreshSpecialMemory(m, elapsed);
  writeOutputs(m);
}

}  // namespace rungproof
