// The real-time clock of the CPU as TODR reads it: eight BCD bytes (001:2927-2949). It runs with the time of the
// simulation. After a long power loss it stands at 1 January 1990, Sunday (001:2918-2922).
// Covered by tests/engine/device_test.cpp.
#pragma once

#include <array>
#include <cstdint>

namespace rungproof {

/// Date and time; year 0-99 (90-99 are the nineties), weekday 1 = Sunday ... 7 = Saturday.
struct ClockTime {
  int year = 90;
  int month = 1;
  int day = 1;
  int hour = 0;
  int minute = 0;
  int second = 0;
  int weekday = 1;
};

class RealTimeClock {
 public:
  explicit RealTimeClock(const ClockTime& start = {}) { set(start, 0); }
  /// The clock shows `time` at `nowMs` of the simulation.
  void set(const ClockTime& time, std::uint64_t nowMs);
  ClockTime at(std::uint64_t nowMs) const;
  /// Byte 0..7 of the TODR buffer at that time: year, month, day, hour, minute, second, 0, weekday. Bytes beyond are 0.
  std::uint8_t byteAt(std::uint32_t index, std::uint64_t nowMs) const;
  /// Days since 1 January 1990, and ms since midnight.
  std::uint64_t dayAt(std::uint64_t nowMs) const;
  std::uint64_t timeOfDayAt(std::uint64_t nowMs) const;
  /// A DATE_AND_TIME of an S7-300/400 (002:1980-1996), its weekday by the calendar.
  std::array<std::uint8_t, 8> dateAndTime(std::uint64_t nowMs) const;

 private:
  std::int64_t secondsAtZero_ = 0;  ///< since 1 January 1990, at time 0 of the simulation
  std::int64_t restMs_ = 0;         ///< part of the second at time 0
  std::int64_t weekdayShift_ = 0;
};

}  // namespace rungproof
