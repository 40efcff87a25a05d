// Functions of date and time: FC 1 AD_DT_TM, FC 3 D_TOD_DT, FC 6 DT_DATE, FC 7 DT_DAY, FC 8 DT_TOD, the comparisons
// FC 9, 12, 14, 18, 23, 28, FC 34 SB_DT_DT, FC 35 SB_DT_TM, FC 33 S5TI_TIM, FC 40 TIM_S5TI, SFC 0 SET_CLK and SFC 1
// READ_CLK. DATE_AND_TIME holds BCD digits from 1990 to 2089 (002:1980-1996). What is not stated is any value: a
// DATE_AND_TIME that is none, results beyond the range of their type, the weekday where the one that is given is wrong,
// and which way a TIME that is no multiple of its unit is rounded.
// Tested by tests/step7/date_functions_test.cpp.
#pragma once

#include "ir/s7300/system_args.hpp"

namespace rungproof {

template <class D>
class DateFunctions {
 public:
  using Bool = typename D::Bool;
  using Bits = typename D::Bits;

  explicit DateFunctions(SystemArgs<D>& args) : a_(args), d_(args.d) {}

  /// AD_DT_TM and SB_DT_TM.
  void addTime(bool subtracts) {
    const Moment moment = read(0);
    const Bits time = a_.value(1);
    Bits days = d_.sdiv(time, n(msOfDay), 32), ms = d_.srem(time, n(msOfDay), 32);
    days = subtracts ? d_.sub(moment.days, days, 32) : d_.add(moment.days, days, 32);
    ms = subtracts ? d_.sub(moment.ms, ms, 32) : d_.add(moment.ms, ms, 32);
    const Bool isBefore = d_.slt(ms, n(0), 32), isAfter = d_.sle(n(msOfDay), ms, 32);
    days = d_.select(isBefore, d_.sub(days, n(1), 32), d_.select(isAfter, d_.add(days, n(1), 32), days, 32), 32);
    ms = d_.select(isBefore, d_.add(ms, n(msOfDay), 32), d_.select(isAfter, d_.sub(ms, n(msOfDay), 32), ms, 32), 32);
    const Bool isStated = d_.land(moment.isValid, d_.ult(days, n(allDays), 32));
    write(2, days, ms, isStated);
    a_.finish(a_.orAny(isStated, a_.yes()));
  }

  void fromDateAndTime() {
    const Bits days = d_.zext(a_.value(0), 16, 32), ms = a_.value(1);
    const Bool isStated = d_.land(d_.ult(days, n(allDays), 32), d_.ult(ms, n(msOfDay), 32));
    write(2, days, ms, isStated);
    a_.finish(a_.orAny(isStated, a_.yes()));
  }

  void date() {
    const Moment moment = read(0);
    give(moment.isValid, d_.extract(moment.days, 15, 0), 16);
  }
  void weekday() {
    const Moment moment = read(0);
    const Bits given = d_.zext(d_.extract(a_.byteOf(0, 7), 3, 0), 4, 16), meant = weekdayOf(moment.days);
    give(d_.land(moment.isValid, d_.equal(given, meant, 16)), meant, 16);
  }
  void timeOfDay() {
    const Moment moment = read(0);
    give(moment.isValid, moment.ms, 32);
  }

  /// `whenEqual`, `whenLess`, `whenGreater`: the result for DT1 against DT2.
  void compare(bool whenEqual, bool whenLess, bool whenGreater) {
    const Moment x = read(0), y = read(1);
    const Bool isSameDay = d_.equal(x.days, y.days, 32);
    const Bool isLess = d_.lor(d_.ult(x.days, y.days, 32), d_.land(isSameDay, d_.ult(x.ms, y.ms, 32)));
    const Bool isEqual = d_.land(isSameDay, d_.equal(x.ms, y.ms, 32));
    const Bits days[] = {d_.extract(a_.byteOf(0, 7), 3, 0), d_.extract(a_.byteOf(1, 7), 3, 0)};
    const Bool isStated =
        d_.land(d_.land(x.isValid, y.isValid), d_.lor(d_.lnot(isEqual), d_.equal(days[0], days[1], 4)));
    const auto constant = [&](bool value) { return d_.constant(value); };
    const Bool result =
        d_.select(isEqual, constant(whenEqual), d_.select(isLess, constant(whenLess), constant(whenGreater)));
    give(isStated, d_.fromBool(result, 1), 1);
  }

  void difference() {
    const Moment x = read(0), y = read(1);
    const auto wide = [&](Bits value) { return d_.sext(value, 32, 64); };
    const Bits days = wide(d_.sub(x.days, y.days, 32)), ms = wide(d_.sub(x.ms, y.ms, 32));
    const Bits all = d_.add(d_.mul(days, d_.literal(msOfDay, 64), 64), ms, 64);
    const Bits low = d_.extract(all, 31, 0);
    give(d_.land(d_.land(x.isValid, y.isValid), d_.equal(wide(low), all, 64)), low, 32);
  }

  void timeOfS5Time() {
    const Bits word = a_.value(0);
    Bool isValid = a_.yes();
    Bits count = n(0);
    for (const int digit : {2, 1, 0}) {
      const Bits four = d_.extract(word, digit * 4 + 3, digit * 4);
      isValid = d_.land(isValid, d_.ule(four, a_.number(9, 4), 4));
      count = d_.add(d_.mul(count, n(10), 32), d_.zext(four, 4, 32), 32);
    }
    const Bits base = d_.extract(word, 13, 12);
    Bits unit = n(10000);
    for (const std::uint64_t i : {2U, 1U, 0U})
      unit = d_.select(d_.equal(base, a_.number(i, 2), 2), n(i == 2 ? 1000 : i == 1 ? 100 : 10), unit, 32);
    give(isValid, d_.mul(count, unit, 32), 32);
  }

  /// The smallest unit in which the time has three digits.
  void s5TimeOfTime() {
    const Bits time = a_.value(0);
    Bits result = a_.number(0, 16);
    Bool isStated = a_.no(), isLonger = d_.constant(true);
    std::uint64_t unit = 10;
    for (std::uint64_t base = 0; base < 4; ++base, unit *= 10) {
      const Bool isHere = d_.land(isLonger, d_.ult(time, n(unit * 1000), 32));
      const Bits count = d_.udiv(time, n(unit), 32);
      const Bits digits = bcd(count, 3);
      result = d_.select(isHere, d_.bor(d_.extract(digits, 15, 0), a_.number(base << 12, 16), 16), result, 16);
      isStated = d_.lor(isStated, d_.land(isHere, d_.equal(d_.urem(time, n(unit), 32), n(0), 32)));
      isLonger = d_.land(isLonger, d_.lnot(isHere));
    }
    give(isStated, result, 16);
  }

  /// What a valid date and time asks of the clock. RET_VAL and BR as of a call that succeeds, or any.
  void setClock() {
    a_.m.when(read(0).isValid, [&] {
      constexpr std::uint32_t clockBytes = 8, weekday = 7, zero = 6;
      for (std::uint32_t i = 0; i < zero; ++i) a_.m.set(Reg::ClockSetting, i, a_.byteOf(0, i));
      a_.m.set(Reg::ClockSetting, zero, a_.number(0, 8));
      a_.m.set(Reg::ClockSetting, weekday, d_.band(a_.byteOf(0, weekday), a_.number(0x0F, 8), 8));
      a_.m.signal(Signal::ClockSet, clockBytes);
    });
    a_.set(1, a_.any(16));
    a_.finish(d_.lnot(a_.anyBit()));
  }
  /// The clock is set from outside, and may be set while the program runs: to proofs any moment.
  void readClock() {
    const Bits days = a_.m.external(External::CalendarDay, 0, 16), ms = a_.m.external(External::TimeOfDay, 0, 32);
    const Bits day = d_.zext(days, 16, 32);
    write(1, d_.select(d_.ult(day, n(allDays), 32), day, n(0), 32), d_.select(d_.ult(ms, n(msOfDay), 32), ms, n(0), 32),
          a_.yes());
    a_.set(0, a_.any(16));
    a_.finish(d_.lnot(a_.anyBit()));
  }
  /// ms since some moment, which come round to 0 (002:2494): to proofs any number of them.
  void systemTime() {
    a_.set(0, d_.band(a_.m.external(External::IntervalClock, 0, 32), n(0x7FFFFFFF), 32));
    a_.finish(a_.yes());
  }

 private:
  static constexpr std::uint64_t msOfDay = 86400000;
  static constexpr std::uint64_t allDays = 36525;  ///< from 1990-01-01 to 2089-12-31
  static constexpr std::array<std::uint64_t, 12> daysBefore = {0, 31, 59, 90, 120, 151, 181, 212, 243, 273, 304, 334};

  /// Days since 1990-01-01 and ms since midnight.
  struct Moment {
    Bits days, ms;
    Bool isValid;
  };

  Bits n(std::uint64_t value) { return a_.number(value, 32); }

  Bits twoDigits(Bits byte, Bool& isValid) {
    const Bits tens = d_.extract(byte, 7, 4), ones = d_.extract(byte, 3, 0);
    isValid = d_.land(isValid, d_.land(d_.ule(tens, a_.number(9, 4), 4), d_.ule(ones, a_.number(9, 4), 4)));
    return d_.add(d_.mul(d_.zext(tens, 4, 32), n(10), 32), d_.zext(ones, 4, 32), 32);
  }
  /// Digits of a number below 10 to the power of `count`, in 32 bits.
  Bits bcd(Bits value, int count) {
    Bits result = n(0);
    for (int i = 0; i < count; ++i) {
      result = d_.bor(result, d_.shl(d_.urem(value, n(10), 32), n(static_cast<std::uint64_t>(i) * 4), 32), 32);
      value = d_.udiv(value, n(10), 32);
    }
    return result;
  }

  /// 1992 is the first leap year, and 2000 is one.
  Bool isLeap(Bits year) { return d_.equal(d_.extract(year, 1, 0), a_.number(2, 2), 2); }
  Bits firstDayOf(Bits year) { return d_.add(d_.mul(year, n(365), 32), d_.lshr(d_.add(year, n(1), 32), n(2), 32), 32); }
  /// 1: Sunday; 1990-01-01 was a Monday.
  Bits weekdayOf(Bits days) { return d_.extract(d_.add(d_.urem(d_.add(days, n(1), 32), n(7), 32), n(1), 32), 15, 0); }

  Moment read(std::uint32_t parameter) {
    Bool isValid = a_.yes();
    std::array<Bits, 6> part;
    for (std::uint32_t i = 0; i < part.size(); ++i) part[i] = twoDigits(a_.byteOf(parameter, i), isValid);
    const Bits hundredths = twoDigits(a_.byteOf(parameter, 6), isValid);
    const Bits last = d_.extract(a_.byteOf(parameter, 7), 7, 4);
    isValid = d_.land(isValid, d_.ule(last, a_.number(9, 4), 4));
    const Bits year = d_.select(d_.ult(part[0], n(90), 32), d_.add(part[0], n(10), 32), d_.sub(part[0], n(90), 32), 32);
    const Bool isLeapYear = isLeap(year);
    Bits before = n(0), length = n(31);
    Bool isMonth = a_.no();
    for (std::uint64_t month = 1; month <= 12; ++month) {
      const Bool isThis = d_.equal(part[1], n(month), 32);
      isMonth = d_.lor(isMonth, isThis);
      const std::uint64_t end = month == 12 ? 365 : daysBefore[month];
      before = d_.select(isThis, n(daysBefore[month - 1]), before, 32);
      length = d_.select(isThis, n(end - daysBefore[month - 1]), length, 32);
    }
    const Bool isFebruary = d_.equal(part[1], n(2), 32);
    length = d_.select(d_.land(isLeapYear, isFebruary), n(29), length, 32);
    before = d_.select(d_.land(isLeapYear, d_.ult(n(2), part[1], 32)), d_.add(before, n(1), 32), before, 32);
    isValid = d_.land(isValid, isMonth);
    isValid = d_.land(isValid, d_.land(d_.ule(n(1), part[2], 32), d_.ule(part[2], length, 32)));
    isValid = d_.land(isValid, d_.ult(part[3], n(24), 32));
    for (const std::size_t i : {4U, 5U}) isValid = d_.land(isValid, d_.ult(part[i], n(60), 32));
    const Bits minutes = d_.add(d_.mul(part[3], n(60), 32), part[4], 32);
    const Bits seconds = d_.add(d_.mul(minutes, n(60), 32), part[5], 32);
    const Bits tens = d_.add(d_.mul(seconds, n(100), 32), hundredths, 32);
    Moment moment{d_.add(d_.add(firstDayOf(year), before, 32), d_.sub(part[2], n(1), 32), 32),
                  d_.add(d_.mul(tens, n(10), 32), d_.zext(last, 4, 32), 32), isValid};
    return moment;
  }

  void write(std::uint32_t parameter, Bits days, Bits ms, Bool isStated) {
    const Bits year = d_.udiv(d_.add(d_.mul(days, n(4), 32), n(2), 32), n(1461), 32);
    const Bits day = d_.sub(days, firstDayOf(year), 32);
    const Bool isLeapYear = isLeap(year);
    Bits month = n(1), before = n(0);
    for (std::uint64_t m = 2; m <= 12; ++m) {
      const Bits first =
          m > 2 ? d_.select(isLeapYear, n(daysBefore[m - 1] + 1), n(daysBefore[m - 1]), 32) : n(daysBefore[m - 1]);
      const Bool isThere = d_.ule(first, day, 32);
      month = d_.select(isThere, n(m), month, 32);
      before = d_.select(isThere, first, before, 32);
    }
    const Bits shown = d_.select(d_.ult(year, n(10), 32), d_.add(year, n(90), 32), d_.sub(year, n(10), 32), 32);
    const Bits seconds = d_.udiv(ms, n(1000), 32), minutes = d_.udiv(seconds, n(60), 32);
    const Bits parts[] = {shown,
                          month,
                          d_.add(d_.sub(day, before, 32), n(1), 32),
                          d_.udiv(minutes, n(60), 32),
                          d_.urem(minutes, n(60), 32),
                          d_.urem(seconds, n(60), 32)};
    std::uint32_t byte = 0;
    for (const Bits& part : parts) put(parameter, byte++, d_.extract(bcd(part, 2), 7, 0), isStated);
    const Bits rest = bcd(d_.urem(ms, n(1000), 32), 3);
    put(parameter, 6, d_.extract(rest, 11, 4), isStated);
    put(parameter, 7, d_.concat(d_.extract(rest, 3, 0), 4, d_.extract(weekdayOf(days), 3, 0), 4), isStated);
  }
  void put(std::uint32_t parameter, std::uint32_t byte, Bits value, Bool isStated) {
    a_.setByte(parameter, byte, a_.orAny(isStated, value, 8));
  }

  /// RET_VAL, the first output, and BR.
  void give(Bool isStated, Bits value, int width) {
    std::uint32_t result = 0;
    while (a_.pou.locals[result].section != VarSection::Output) ++result;
    a_.set(result, a_.orAny(isStated, value, width));
    a_.finish(a_.orAny(isStated, a_.yes()));
  }

  SystemArgs<D>& a_;
  D& d_;
};

}  // namespace rungproof
