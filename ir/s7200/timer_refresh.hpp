// How timers count. 100 ms timers advance inside their instruction, 10 ms timers at the start of a scan, 1 ms timers
// at any instruction boundary (001:6605-6611); all three come here. Effects: table 6-73 (001:6551-6586), IEC boxes
// 001:6693-6706. Tests: tests/manual/timer_test.cpp.
#pragma once

#include "ir/s7300/clock_memory.hpp"
#include "ir/s7300/timer.hpp"

namespace rungproof {

/// Lets `ticks` (width 16, unsigned) of its resolution pass for one timer where it is running; they are added where
/// `isCounting`. Gives the condition that this update brought the current value up to the preset (events 21 and 22,
/// 001:5476).
template <class D>
typename D::Bool advanceTimer(Machine<D>& m, TimerKind kind, std::uint32_t number, typename D::Bits ticks,
                              typename D::Bool isCounting) {
  D& d = m.d;
  constexpr int w = 18;  // holds -32768 + 65535 and 32767 + 65535
  const auto running = m.getBit(Reg::TimerRunning, number);
  auto reached = d.constant(false);
  m.when(running, [&] {
    const auto old = m.get(Reg::TimerCurrent, number);
    const auto preset = m.get(Reg::TimerPreset, number);
    const auto sum = d.add(d.sext(old, 16, w), d.zext(ticks, 16, w), w);
    const auto most = m.number(32767, w);
    const auto later = d.extract(d.select(d.slt(most, sum, w), most, sum, w), 15, 0);
    const auto counted = d.select(isCounting, later, old, 16);
    const auto elapsed = d.sle(preset, counted, 16);
    const bool stopsAtPreset = kind != TimerKind::OnDelay && kind != TimerKind::Retentive;
    const bool endsTheSignal = kind == TimerKind::OffDelay || kind == TimerKind::IecPulse;
    m.set(Reg::TimerCurrent, number, stopsAtPreset ? d.select(elapsed, preset, counted, 16) : counted);
    m.when(elapsed, [&] {
      m.setBit(Reg::TimerBit, number, d.constant(!endsTheSignal));
      if (endsTheSignal) m.setBit(Reg::TimerRunning, number, d.constant(false));
    });
    reached = d.land(running, d.land(elapsed, d.slt(old, preset, 16)));
  });
  return reached;
}

/// Lets `ticks` pass for all timers of a resolution, 1 or 10 ms: the scan calls it for 10 ms timers at its start, for
/// 1 ms timers at instruction boundaries. reached(use, condition) is called for each timer.
template <class D, class Reached>
void refreshTimers(Machine<D>& m, int resolution, typename D::Bits ticks, Reached&& reached) {
  for (const TimerUse& use : m.plan.timers) {
    if (use.resolution != resolution || !use.decides) continue;
    if (use.kind == TimerKind::S5)
      m.when(m.reads({Choice::S5Time, "any"}), [&] { advanceS5(m, use.number, ticks); });
    else
      reached(use, advanceTimer(m, use.kind, use.number, ticks, m.d.constant(true)));
  }
  if (resolution == 1 && !m.plan.iecTimers.empty())
    m.when(m.reads({Choice::S5Time, "any"}), [&] { advanceIecTimers(m, ticks); });
  if (resolution == 1 && m.plan.program->clockMemory)
    m.when(m.reads({Choice::S5Time, "any"}), [&] { advanceClockMemory(m, ticks); });
}
/// Lets `ms` (width 16) pass for the IEC timers of an S7-300/400: their instances keep the time since the start in
/// ATIME, at byte 18, while STATE, at byte 12, is 1 (frontend/step7/library_source.cpp).
template <class D>
void advanceIecTimers(Machine<D>& m, typename D::Bits ms) {
  for (const std::uint32_t instance : m.plan.iecTimers) {
    const auto state = m.load(Area::DB, instance + 12, Width::Byte);
    m.when(m.d.equal(state, m.number(1, 8), 8), [&] {
      const auto passed = m.d.add(m.load(Area::DB, instance + 18, Width::DWord), m.d.zext(ms, 16, 32), 32);
      m.save(Area::DB, instance + 18, Width::DWord,
             m.d.select(m.d.bit(passed, 31), m.number(0x7FFFFFFF, 32), passed, 32));
    });
  }
}

/// S5 timers by the reading that their time passes between the scans; IEC timers and clock memory in the same way.
template <class D>
void refreshS5Timers(Machine<D>& m) {
  const bool hasClock = m.plan.program->clockMemory.has_value();
  if (!m.plan.isStep7() || (m.plan.timers.empty() && m.plan.iecTimers.empty() && !hasClock)) return;
  const auto passed = m.get(Reg::LastScan);
  m.when(m.reads({Choice::S5Time, "synchronous"}), [&] {
    for (const TimerUse& use : m.plan.timers) advanceS5(m, use.number, passed);
    advanceIecTimers(m, passed);
    if (hasClock) advanceClockMemory(m, passed);
  });
  if (hasClock) showClockMemory(m);
}

template <class D>
void refreshTimers(Machine<D>& m, int resolution, typename D::Bits ticks) {
  refreshTimers(m, resolution, ticks, [](const TimerUse&, typename D::Bool) {});
}

}  // namespace rungproof
