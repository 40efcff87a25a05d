// One pass from the left over a date and a time of day.
#include "frontend/logger/moment.hpp"

#include <array>
#include <chrono>

namespace rungproof {

namespace {

constexpr std::int64_t second = 1'000'000, dayLength = 86'400 * second;

class MomentReader {
 public:
  MomentReader(std::string_view text, bool dayFirst) : text_(text), dayFirst_(dayFirst) {}

  std::optional<Moment> read() {
    skipBlanks();
    const std::size_t begin = at_;
    if (!readDate()) {
      at_ = begin;
      if (isBad_) return std::nullopt;
    }
    if (at_ < text_.size()) {
      if (moment_.hasDate && (text_[at_] == 'T' || text_[at_] == 't')) ++at_;
      skipBlanks();
      if (at_ < text_.size() && !readTime()) return std::nullopt;
    }
    skipBlanks();
    if (isBad_ || at_ != text_.size() || (!moment_.hasDate && !moment_.hasTime)) return std::nullopt;
    return moment_;
  }

 private:
  void skipBlanks() {
    while (at_ < text_.size() && (text_[at_] == ' ' || text_[at_] == ',' || text_[at_] == '\t')) ++at_;
  }
  char here() const { return at_ < text_.size() ? text_[at_] : '\0'; }
  static bool isDigitSign(char c) { return c >= '0' && c <= '9'; }

  /// A whole number of at most `most` digits; -1: none stands here.
  int number(int most) {
    int value = 0, digits = 0;
    while (digits < most && isDigitSign(here())) {
      value = value * 10 + (text_[at_++] - '0');
      ++digits;
    }
    digits_ = digits;
    return digits == 0 ? -1 : value;
  }

  bool readDate() {
    const int first = number(4);
    const int firstDigits = digits_;
    const char mark = here();
    if (first < 0 || (mark != '-' && mark != '.' && mark != '/')) return false;
    ++at_;
    const int middle = number(2);
    if (middle < 0 || here() != mark) return false;
    ++at_;
    int last = number(4);
    if (last < 0) return false;
    int year = 0, month = 0, day = 0;
    if (firstDigits == 4) {
      year = first, month = middle, day = last;
    } else {
      if (digits_ == 2)
        last += 2000;
      else if (digits_ != 4)
        return false;
      const bool isDayFirst = mark != '/' || dayFirst_ || first > 12;
      year = last, month = isDayFirst ? middle : first, day = isDayFirst ? first : middle;
    }
    const std::chrono::year_month_day date{std::chrono::year(year), std::chrono::month(static_cast<unsigned>(month)),
                                           std::chrono::day(static_cast<unsigned>(day))};
    if (!date.ok()) {
      isBad_ = true;
      return false;
    }
    moment_.hasDate = true;
    moment_.us = std::chrono::sys_days(date).time_since_epoch().count() * dayLength;
    return true;
  }

  /// Digits behind the sign of a fraction, as us; further ones are cut off.
  std::int64_t fraction() {
    std::int64_t us = 0, weight = second / 10;
    for (; isDigitSign(here()); ++at_, weight /= 10) us += (text_[at_] - '0') * weight;
    return us;
  }

  bool readTime() {
    int hour = number(2);
    if (hour < 0 || here() != ':') return false;
    ++at_;
    const int minute = number(2);
    if (minute < 0 || digits_ != 2) return false;
    int seconds = 0;
    std::int64_t us = 0;
    if (here() == ':') {
      ++at_;
      seconds = number(2);
      if (seconds < 0 || digits_ != 2) return false;
      const bool hasFraction =
          (here() == '.' || here() == ',' || here() == ':') && at_ + 1 < text_.size() && isDigitSign(text_[at_ + 1]);
      if (hasFraction) {
        ++at_;
        us = fraction();
      }
    }
    skipBlanks();
    const char letter = static_cast<char>(here() | 0x20);
    if ((letter == 'a' || letter == 'p') && at_ + 1 < text_.size() && (text_[at_ + 1] | 0x20) == 'm') {
      if (hour < 1 || hour > 12) return false;
      hour = hour % 12 + (letter == 'p' ? 12 : 0);
      at_ += 2;
    }
    if (hour > 23 || minute > 59 || seconds > 59) return false;
    moment_.hasTime = true;
    moment_.us += ((hour * 60 + minute) * 60LL + seconds) * second + us;
    return readOffset();
  }

  /// "Z", "+01:00", "-0530", or nothing.
  bool readOffset() {
    if (here() == 'Z' || here() == 'z') {
      ++at_;
      return true;
    }
    const char sign = here();
    if (sign != '+' && sign != '-') return true;
    ++at_;
    const int hours = number(2);
    if (hours < 0 || hours > 14) return false;
    if (here() == ':') ++at_;
    const int minutes = isDigitSign(here()) ? number(2) : 0;
    if (minutes > 59) return false;
    moment_.us -= (sign == '+' ? 1 : -1) * (hours * 60 + minutes) * 60LL * second;
    return true;
  }

  std::string_view text_;
  bool dayFirst_;
  Moment moment_;
  std::size_t at_ = 0;
  int digits_ = 0;
  bool isBad_ = false;
};

}  // namespace

std::optional<Moment> momentIn(std::string_view text, bool dayFirst) { return MomentReader(text, dayFirst).read(); }

bool needsDayFirst(std::string_view text) {
  const std::size_t stroke = text.find('/');
  if (stroke == std::string_view::npos || stroke == 0 || stroke > 2) return false;
  int value = 0;
  for (const char c : text.substr(0, stroke)) {
    if (c < '0' || c > '9') return false;
    value = value * 10 + (c - '0');
  }
  return value > 12;
}

}  // namespace rungproof
