// Calendar of the real-time clock.
#include "engine/real_time_clock.hpp"

#include <chrono>

namespace rungproof {

namespace {

constexpr std::chrono::sys_days epoch = std::chrono::year{1990} / 1 / 1;
constexpr std::int64_t secondsPerDay = 86400;

std::int64_t floorDivide(std::int64_t a, std::int64_t b) { return a / b - (a % b < 0 ? 1 : 0); }
std::uint8_t bcd(int value) { return static_cast<std::uint8_t>(value / 10 * 16 + value % 10); }

}  // namespace

void RealTimeClock::set(const ClockTime& time, std::uint64_t nowMs) {
  const std::chrono::year year{time.year < 90 ? 2000 + time.year : 1900 + time.year};
  const std::chrono::sys_days date = year / time.month / time.day;
  const std::int64_t days = (date - epoch).count();
  const std::int64_t atSet = (days * secondsPerDay + time.hour * 3600 + time.minute * 60 + time.second) * 1000;
  const std::int64_t atZero = atSet - static_cast<std::int64_t>(nowMs);
  secondsAtZero_ = floorDivide(atZero, 1000);
  restMs_ = atZero - secondsAtZero_ * 1000;
  weekdayShift_ = time.weekday - 1 - days;
}

ClockTime RealTimeClock::at(std::uint64_t nowMs) const {
  const std::int64_t seconds = secondsAtZero_ + (restMs_ + static_cast<std::int64_t>(nowMs)) / 1000;
  const std::int64_t days = floorDivide(seconds, secondsPerDay);
  const int rest = static_cast<int>(seconds - days * secondsPerDay);
  const std::chrono::year_month_day date{epoch + std::chrono::days{days}};
  ClockTime time;
  time.year = static_cast<int>(date.year()) % 100;
  time.month = static_cast<int>(static_cast<unsigned>(date.month()));
  time.day = static_cast<int>(static_cast<unsigned>(date.day()));
  time.hour = rest / 3600;
  time.minute = rest / 60 % 60;
  time.second = rest % 60;
  time.weekday = static_cast<int>(((days + weekdayShift_) % 7 + 7) % 7) + 1;
  return time;
}

std::uint8_t RealTimeClock::byteAt(std::uint32_t index, std::uint64_t nowMs) const {
  const ClockTime time = at(nowMs);
  const std::array<int, 8> fields = {time.year,   time.month,  time.day, time.hour,
                                     time.minute, time.second, 0,        time.weekday};
  return index < fields.size() ? bcd(fields[index]) : 0;
}

std::uint64_t RealTimeClock::dayAt(std::uint64_t nowMs) const {
  const std::int64_t seconds = secondsAtZero_ + (restMs_ + static_cast<std::int64_t>(nowMs)) / 1000;
  return static_cast<std::uint64_t>(floorDivide(seconds, secondsPerDay));
}

std::uint64_t RealTimeClock::timeOfDayAt(std::uint64_t nowMs) const {
  const std::int64_t ms = secondsAtZero_ * 1000 + restMs_ + static_cast<std::int64_t>(nowMs);
  return static_cast<std::uint64_t>(ms - floorDivide(ms, secondsPerDay * 1000) * secondsPerDay * 1000);
}

std::array<std::uint8_t, 8> RealTimeClock::dateAndTime(std::uint64_t nowMs) const {
  std::array<std::uint8_t, 8> result{};
  for (std::uint32_t i = 0; i < 6; ++i) result[i] = byteAt(i, nowMs);
  const auto ms = static_cast<int>((restMs_ + static_cast<std::int64_t>(nowMs)) % 1000);
  const std::chrono::weekday weekday{epoch + std::chrono::days{static_cast<std::int64_t>(dayAt(nowMs))}};
  result[6] = bcd(ms / 10);
  result[7] = static_cast<std::uint8_t>(ms % 10 << 4 | (weekday.c_encoding() + 1));
  return result;
}

}  // namespace rungproof
