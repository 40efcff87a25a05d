// How timers count. 100 ms timers advance inside their instruction, 10 ms timers at the start of a scan, 1 ms timers
// at any instruction boundary (001:6605-6611); all three come here. Effects: table 6-73 (001:6551-6586), IEC boxes
// 001:6693-6706. Timers that
// pass in ms: ir/s7300/timer_pass.hpp. Tests: tests/manual/timer_test.cpp, tests/agreement7.
#pragma once

#include "ir/machine/timers.hpp"

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
/// 1 ms timers at instruction boundaries. reached(use, condition) is called for each timer of an S7-200.
template <class D, class Reached>
void refreshTimers(Machine<D>& m, int resolution, typename D::Bits ticks, Reached&& reached) {
  if (m.plan.counting() == Counting::Elements) {
    if (resolution != 1) return;
    m.passedMs = m.d.add(m.passedMs, m.d.zext(ticks, 16, restBits), restBits);
    passTimers(m, ticks, [](std::uint32_t) { return true; });
    return;
  }
  for (const TimerUse& use : m.plan.timers) {
    if (use.resolution != resolution || !use.decides) continue;
    reached(use, advanceTimer(m, use.kind, use.number, ticks, m.d.constant(true)));
  }
}

template <class D>
void refreshTimers(Machine<D>& m, int resolution, typename D::Bits ticks) {
  refreshTimers(m, resolution, ticks, [](const TimerUse&, typename D::Bool) {});
}

}  // namespace rungproof
