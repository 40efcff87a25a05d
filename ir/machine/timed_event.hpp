// Events that come with time: their numbers and registers.
#pragma once

#include "ir/block_event.hpp"
#include "ir/machine/register.hpp"

namespace rungproof {

/// Events 10 and 11, whose period in ms stands in SMB34 and SMB35 (001:5470).
inline constexpr std::uint32_t firstTimedEvent = 10, timedPeriodByte = 34;

/// Timed events are counted through: 0 and 1 are 10 and 11, those that follow the cyclic and the time-delay interrupts
/// of an S7-300/400.
inline constexpr std::uint32_t attachedTimers = 2, firstDelayTimer = attachedTimers + cyclicBlockCount,
                               timedEventCount = firstDelayTimer + delayBlockCount;
inline constexpr int noTimer = -1;
constexpr int timerOfEvent(int event) {
  if (event == 10 || event == 11) return event - static_cast<int>(firstTimedEvent);
  if (isDelayEvent(event)) return static_cast<int>(firstDelayTimer) + event - firstDelayEvent;
  return isCyclicEvent(event) ? static_cast<int>(attachedTimers) + event - firstCyclicEvent : noTimer;
}
constexpr int eventOfTimed(std::uint32_t timer) {
  if (timer >= firstDelayTimer) return firstDelayEvent + static_cast<int>(timer - firstDelayTimer);
  return timer < attachedTimers ? static_cast<int>(firstTimedEvent + timer)
                                : firstCyclicEvent + static_cast<int>(timer - attachedTimers);
}
constexpr bool isTimedEvent(int event) { return timerOfEvent(event) != noTimer; }

/// Registers of a timed event: the period in ms (0: none), and the ms since it came last or was started.
struct TimedRegisters {
  Reg period, elapsed;
  std::uint32_t at;
};
constexpr TimedRegisters timedRegisters(std::uint32_t timer) {
  if (timer < attachedTimers) return {Reg::TimedPeriod, Reg::TimedElapsed, timer};
  if (timer >= firstDelayTimer) return {Reg::DelayPeriod, Reg::DelayElapsed, timer - firstDelayTimer};
  return {Reg::CyclicPeriod, Reg::CyclicElapsed, timer - attachedTimers};
}

}  // namespace rungproof
