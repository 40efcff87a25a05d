// Real-time clock: TODR, TODW and, since 2004, TODRX, TODWX with the daylight-saving rule (001:2910-3018). Buffer in
// BCD: year, month, day, hour, minute, second, 0, weekday (1 = Sunday, 0 = none); the long form adds the mode and ten
// bytes of the user's own rule. The time itself lies outside the program; a setting goes to Reg::ClockSetting. Tests:
// tests/manual/clock_test.cpp.
#pragma once

#include "ir/s7200/isa/group.hpp"

namespace rungproof::isa {

/// Legal values of a byte of the buffer, as plain numbers.
struct ClockField {
  std::uint8_t low, high;
};
inline constexpr std::array<ClockField, 8> clockFields = {
    {{0, 99}, {1, 12}, {1, 31}, {0, 23}, {0, 59}, {0, 59}, {0, 99}, {0, 7}}};
/// Bytes 9-18, which count for mode FFh only: correction hours and minutes, begin and end (month, day, hour, minute).
inline constexpr std::array<ClockField, 10> clockRuleFields = {
    {{0, 23}, {0, 59}, {1, 12}, {1, 31}, {0, 23}, {0, 59}, {1, 12}, {1, 31}, {0, 23}, {0, 59}}};
inline constexpr std::array<std::uint8_t, 10> clockModes = {0x00, 0x01, 0x02, 0x03, 0x08, 0x10, 0x11, 0x12, 0x13, 0xFF};
inline constexpr int clockModeAt = 8;

template <class D>
typename D::Bool isBcdByte(Machine<D>& m, typename D::Bits byte) {
  D& d = m.d;
  const auto nine = m.number(9, 4);
  return d.land(d.ule(d.extract(byte, 7, 4), nine, 4), d.ule(d.extract(byte, 3, 0), nine, 4));
}

/// A byte in BCD, inside its field.
template <class D>
typename D::Bool isOfClockField(Machine<D>& m, typename D::Bits byte, ClockField field) {
  D& d = m.d;
  const auto tens = d.zext(d.extract(byte, 7, 4), 4, 8), ones = d.zext(d.extract(byte, 3, 0), 4, 8);
  const auto value = d.add(d.mul(tens, m.number(10, 8), 8), ones, 8);
  const auto inRange = d.land(d.ule(m.number(field.low, 8), value, 8), d.ule(value, m.number(field.high, 8), 8));
  return d.land(isBcdByte(m, byte), inRange);
}

/// Whether TODW takes a byte: BCD and inside its field, as far as the choice asks for it.
template <class D>
typename D::Bool clockFieldHolds(Machine<D>& m, typename D::Bits byte, ClockField field) {
  D& d = m.d;
  const auto bcdOnly = d.land(m.reads({Choice::ClockData, "bcd"}), isBcdByte(m, byte));
  return d.lor(m.reads({Choice::ClockData, "any"}), d.lor(bcdOnly, isOfClockField(m, byte, field)));
}

/// Whether a clock that runs by itself can show this in byte `index` of the buffer (001:2935). After a TODW that
/// accepts anything it may show anything.
template <class D>
typename D::Bool clockShows(Machine<D>& m, typename D::Bits byte, std::uint32_t index) {
  if (index < clockFields.size()) return isOfClockField(m, byte, clockFields[index]);
  if (index > static_cast<std::uint32_t>(clockModeAt))
    return m.d.constant(true);  // the rule counts for one mode only and may be anything else
  auto known = m.d.constant(false);
  for (const std::uint8_t value : clockModes) known = m.d.lor(known, m.d.equal(byte, m.number(value, 8), 8));
  return known;
}

template <bool writes, bool extended, Name stlName, Name boxName, Name meaning, std::uint32_t time>
struct Clock {
  static constexpr int size = extended ? 19 : 8;
  static constexpr Desc desc = withOperands(
      {.stl = stlName.view(),
       .meaning = meaning.view(),
       .group = "real-time clock",
       .role = writes ? Role::Todw : Role::Todr,
       .drawn = boxName.view(),
       .stack = {1, 0, 0},
       .eno = true,
       .since2004 = extended,
       .time = time,
       .manual = extended ? "001:2984" : "001:2933"},
      {operandDesc("T", writes ? Direction::In : Direction::Out, Type::Byte, form::byteBuffer).elements(size, size)});

  template <class D>
  static void run(Machine<D>& m, Args<D>& a) {
    D& d = m.d;
    const auto hasClock =
        cpuFeatures(m.target).clockBuiltIn ? d.constant(true) : m.reads({Choice::ClockModule, "fitted"});
    m.hazard(Hazard::NoClock, d.lnot(hasClock));
    const auto fits = a.fits(0, m.number(size, 16), Width::Byte);
    m.hazard(Hazard::OutOfRange, d.lnot(fits));
    m.when(d.land(fits, hasClock), [&] {
      if constexpr (writes) {
        set(m, a);
      } else {
        for (int k = 0; k < size; ++k) {
          const auto byte = k == 6 ? m.number(0, 8) : m.external(External::ClockByte, static_cast<std::uint32_t>(k), 8);
          a.storeElement(0, k, Width::Byte, byte);
        }
      }
    });
  }

  /// Which data are refused is Choice::ClockData; 30 February is not (001:2947).
  template <class D>
  static void set(Machine<D>& m, Args<D>& a) {
    D& d = m.d;
    auto legal = d.constant(true);
    for (int k = 0; k < 8; ++k) {
      if (k == 6) continue;
      ClockField field = clockFields[static_cast<std::size_t>(k)];
      if (extended && k == 7) field.low = 1;
      legal = d.land(legal, clockFieldHolds(m, a.element(0, k, Width::Byte), field));
    }
    if constexpr (extended) {
      const auto mode = a.element(0, clockModeAt, Width::Byte);
      auto known = m.reads({Choice::ClockData, "any"});
      for (const std::uint8_t value : clockModes) known = d.lor(known, d.equal(mode, m.number(value, 8), 8));
      auto rule = d.constant(true);
      for (int k = 0; k < 10; ++k)
        rule = d.land(
            rule, clockFieldHolds(m, a.element(0, k + 9, Width::Byte), clockRuleFields[static_cast<std::size_t>(k)]));
      legal = d.land(d.land(legal, known), d.lor(rule, d.lnot(d.equal(mode, m.number(0xFF, 8), 8))));
    }
    m.hazard(Hazard::ClockData, d.lnot(legal));
    m.when(legal, [&] {
      for (int k = 0; k < size; ++k)
        m.set(Reg::ClockSetting, static_cast<std::uint32_t>(k), a.element(0, k, Width::Byte));
      m.signal(Signal::ClockSet, size);
    });
  }
};

using ReadClock = Clock<false, false, "TODR", "READ_RTC", "read the real-time clock", 33100>;
using WriteClock = Clock<true, false, "TODW", "SET_RTC", "write the real-time clock", 43600>;
using ReadClockExtended = Clock<false, true, "TODRX", "READ_RTCX", "read the extended clock (daylight saving)", 39100>;
using WriteClockExtended = Clock<true, true, "TODWX", "SET_RTCX", "set the extended clock (daylight saving)", 55400>;

using ClockGroup = Group<ReadClock, WriteClock, ReadClockExtended, WriteClockExtended>;

}  // namespace rungproof::isa
