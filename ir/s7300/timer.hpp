// The S5 timers of an S7-300/400 (002:2874-2878, 003:1016-1043): how their time passes. What starts and stops them
// stands in ir/s7300/isa/timer.hpp. The rest of a running timer is kept in ms; when it is gone the bit takes the value
// that the instruction which started the timer has left for that moment.
#pragma once

#include "ir/s7200/machine.hpp"

namespace rungproof {

inline constexpr int restBits = 24;                        ///< holds 999 x 10 s
inline constexpr std::uint64_t longestS5Time = 9'990'000;  ///< ms (003:1043)

/// Lets `ms` (width 16) pass for one timer. Gives the condition that its time is up now.
template <class D>
typename D::Bool advanceS5(Machine<D>& m, std::uint32_t number, typename D::Bits ms) {
  D& d = m.d;
  const auto running = m.getBit(Reg::TimerRunning, number);
  auto ends = d.constant(false);
  m.when(running, [&] {
    const auto rest = m.get(Reg::S5Rest, number), passed = d.zext(ms, 16, restBits);
    const auto isUp = d.ule(rest, passed, restBits);
    m.set(Reg::S5Rest, number, d.select(isUp, m.number(0, restBits), d.sub(rest, passed, restBits), restBits));
    m.when(isUp, [&] {
      m.setBit(Reg::TimerBit, number, m.getBit(Reg::S5AtEnd, number));
      m.setBit(Reg::TimerRunning, number, d.constant(false));
    });
    ends = d.land(running, isUp);
  });
  return ends;
}

}  // namespace rungproof
