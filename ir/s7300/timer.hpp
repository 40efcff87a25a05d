// The S5 timers of an S7-300/400 (002:2874-2878, 003:1016-1043): how their time passes. What starts and stops them
// stands in ir/s7300/isa/timer.hpp. Reg::S5Rest of a running timer is the ms from the start of the scan to its end, so
// that nothing is computed while the scan goes on: whether the end has come is a comparison with Machine::passedMs, and
// what is subtracted is the length of the scan, when it is over. At the end the bit takes the value that the
// instruction which started the timer has left for that moment.
#pragma once

#include "ir/machine/machine.hpp"

namespace rungproof {

inline constexpr std::uint64_t longestS5Time = 9'990'000;  ///< ms (003:1043)

/// Ends one timer if its time is up `now` ms (width restBits) after the start of the scan.
template <class D>
void endS5(Machine<D>& m, std::uint32_t number, typename D::Bits now) {
  m.when(m.getBit(Reg::TimerRunning, number), [&] {
    m.when(m.d.ule(m.get(Reg::S5Rest, number), now, restBits), [&] {
      m.setBit(Reg::TimerBit, number, m.getBit(Reg::S5AtEnd, number));
      m.setBit(Reg::TimerRunning, number, m.d.constant(false));
      m.set(Reg::S5Rest, number, m.number(0, restBits));
    });
  });
}

/// A scan of `ms` (width restBits) is over: running timers count from the start of the next one. A timer whose time is
/// up by then has 0 left; where its end is seen at the start of a scan only, it runs until then.
template <class D>
void passScanOfS5(Machine<D>& m, std::uint32_t number, typename D::Bits ms) {
  D& d = m.d;
  m.when(m.getBit(Reg::TimerRunning, number), [&] {
    const auto rest = m.get(Reg::S5Rest, number);
    const auto isUp = d.ule(rest, ms, restBits);
    m.set(Reg::S5Rest, number, d.select(isUp, m.number(0, restBits), d.sub(rest, ms, restBits), restBits));
  });
}

/// ms (width restBits) of this scan that a timer which starts now does not count: none where ends are seen at the start
/// of a scan only.
template <class D>
typename D::Bits passedBefore(Machine<D>& m) {
  return m.d.select(m.reads({Choice::S5Time, "any"}), m.passedMs, m.number(0, restBits), restBits);
}

}  // namespace rungproof
