// How the time of S5 timers, IEC timers and clock memory passes in a scan: in ms (ir/machine/timers.hpp). Tested by
// tests/agreement7 and tests/step7/clock_memory_test.cpp.
#pragma once

#include "ir/machine/timers.hpp"
#include "ir/s7300/clock_memory.hpp"
#include "ir/s7300/timer.hpp"

namespace rungproof {

/// A scan of `ms` (width restBits) is over for the IEC timers of an S7-300/400: their instances keep the time from
/// their start to the start of the scan in ATIME, at byte 18, while STATE, at byte 12, is 1
/// (frontend/step7/library_source.cpp). As S5 timers they add nothing inside the scan.
template <class D>
void passScanOfIec(Machine<D>& m, typename D::Bits ms) {
  for (const std::uint32_t instance : m.plan.iecTimers) {
    const auto state = m.load(Area::DB, instance + 12, Width::Byte);
    m.when(m.d.equal(state, m.number(1, 8), 8), [&] {
      const auto passed = m.d.add(m.load(Area::DB, instance + 18, Width::DWord), m.d.zext(ms, restBits, 32), 32);
      m.save(Area::DB, instance + 18, Width::DWord,
             m.d.select(m.d.bit(passed, 31), m.number(0x7FFFFFFF, 32), passed, 32));
    });
  }
}

/// Of an S7-300/400, at the start of a scan: ends of timers by the reading that they are seen there only, and the clock
/// memory.
template <class D>
void beginScanOfTimers(Machine<D>& m) {
  if (m.plan.counting() != Counting::Elements) return;
  m.passedMs = m.number(0, restBits);
  const bool hasClock = m.plan.program->clockMemory.has_value();
  const auto isSynchronous = m.reads({Choice::S5Time, "synchronous"});
  if (m.d.truth(isSynchronous) != false) {
    for (const TimerUse& use : m.plan.timers) endS5(m, use.number, m.passedMs);  // the other reading leaves none
    if (hasClock) {
      const auto passed = m.get(Reg::LastScan);
      m.when(isSynchronous, [&] { advanceClockMemory(m, passed); });
    }
  }
  if (hasClock) showClockMemory(m);
}

/// The same inside the scan, by the reading that time passes at any instruction: `ticks` ms (width 16) more have
/// passed, Machine::passedMs in all. isAsked(number): whether it matters now that this S5 timer has come to its end.
template <class D, class IsAsked>
void passTimers(Machine<D>& m, typename D::Bits ticks, IsAsked&& isAsked) {
  m.when(m.reads({Choice::S5Time, "any"}), [&] {
    for (const TimerUse& use : m.plan.timers) {
      if (isAsked(use.number)) endS5(m, use.number, m.passedMs);
    }
    if (m.plan.program->clockMemory) advanceClockMemory(m, ticks);
  });
}

/// The same at the end of a scan of `ms` (width restBits), whatever has ended the program: the scan goes on behind it.
template <class D>
void endScanOfTimers(Machine<D>& m, typename D::Bits ms) {
  if (m.plan.counting() != Counting::Elements) return;
  const auto guard = m.guard;
  for (const TimerUse& use : m.plan.timers) {
    passScanOfS5(m, use.number, ms);
    m.guard = guard;
  }
  passScanOfIec(m, ms);
}

}  // namespace rungproof
