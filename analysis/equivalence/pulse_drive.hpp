// What a pulse generator gives to its output past the process image (001:4528), over any domain: numbers at the end
// of a scan that two programs can be compared by. Tested by tests/equivalence/requests_test.cpp.
#pragma once

#include <array>
#include <string_view>

#include "ir/machine/register.hpp"
#include "ir/s7200/pulse_output.hpp"

namespace rungproof {

enum class PulseNumber : std::uint8_t { Mode, Cycle, Width, Count, Frequency };
inline constexpr std::array pulseNumbers = {PulseNumber::Mode, PulseNumber::Cycle, PulseNumber::Width,
                                            PulseNumber::Count, PulseNumber::Frequency};
/// Cycle and width in us, frequency in Hz.
constexpr std::string_view pulseNumberName(PulseNumber number) {
  constexpr std::array<std::string_view, pulseNumbers.size()> names = {"mode", "cycle", "width", "count", "frequency"};
  return names[static_cast<std::size_t>(number)];
}

/// Values of PulseNumber::Mode. A width of 0 and one as long as the cycle are no pulses (001:4622).
enum class PulseMode : std::uint8_t { Off, Train, WidthModulation, Profile, AlwaysLow, AlwaysHigh };
inline constexpr int pulseBits = 32;

/// 32 bits; 0 for what the mode does not have. `get(Reg)`: a register of the generator, or Reg::Running.
template <class D, class Get>
typename D::Bits pulseNumber(D& d, PulseNumber number, const PulseForm& form, const Get& get) {
  constexpr int w = pulseBits;
  const auto literal = [&](auto value) { return d.literal(static_cast<std::uint64_t>(value), w); };
  const auto isSet = [&](Reg reg) { return d.bit(get(reg), 0); };
  const auto inUs = [&](Reg reg) {
    const auto value = d.zext(get(reg), regInfo(reg).width, w);
    return d.select(isSet(Reg::PulseIsMs), d.mul(value, literal(1000), w), value, w);
  };
  const auto isProfile = d.lnot(d.equal(get(Reg::PulseSegments), d.literal(0, 8), 8));
  const auto isPwm = isSet(Reg::PulseIsPwm), runs = d.land(isSet(Reg::Running), isSet(Reg::PulseBusy));
  const auto width = get(Reg::PulseWidth), cycle = get(Reg::PulseCycle);
  const auto isLow = d.equal(width, d.literal(0, 16), 16), isHigh = d.ule(cycle, width, 16);
  const auto modulates = d.land(d.land(runs, isPwm), d.lnot(d.lor(isLow, isHigh)));
  const auto trains = d.land(d.land(runs, d.lnot(isPwm)), d.lnot(isProfile));
  const auto where = [&](auto condition, auto value) { return d.select(condition, value, literal(0), w); };
  switch (number) {
    case PulseNumber::Mode: {
      const auto level = d.select(isLow, literal(PulseMode::AlwaysLow), literal(PulseMode::AlwaysHigh), w);
      const auto modulation = d.select(modulates, literal(PulseMode::WidthModulation), level, w);
      const auto train = d.select(isProfile, literal(PulseMode::Profile), literal(PulseMode::Train), w);
      return where(runs, d.select(isPwm, modulation, train, w));
    }
    case PulseNumber::Cycle:
      return where(form.hasFrequency ? modulates : d.lor(modulates, trains), inUs(Reg::PulseCycle));
    case PulseNumber::Frequency:
      return form.hasFrequency ? where(trains, d.zext(cycle, regInfo(Reg::PulseCycle).width, w)) : literal(0);
    case PulseNumber::Width: return where(modulates, inUs(Reg::PulseWidth));
    case PulseNumber::Count: return where(trains, get(Reg::PulseCount));
  }
  return literal(0);
}

/// Whether the two drive their output differently for certain: a level of the generator may be that of the process
/// image, and numbers are compared where both generators have them.
template <class D>
typename D::Bool pulsesDiffer(D& d, PulseNumber number, typename D::Bits a, typename D::Bits b) {
  constexpr int w = pulseBits;
  const auto is = [&](typename D::Bits value, PulseMode mode) {
    return d.equal(value, d.literal(static_cast<std::uint64_t>(mode), w), w);
  };
  const auto isLevel = [&](typename D::Bits value) {
    return d.lor(is(value, PulseMode::AlwaysLow), is(value, PulseMode::AlwaysHigh));
  };
  const auto isOff = [&](typename D::Bits value) { return is(value, PulseMode::Off); };  // also: has no such number
  const auto differs = d.lnot(d.equal(a, b, w));
  const auto isOpen = number == PulseNumber::Mode ? d.lor(d.land(isOff(a), isLevel(b)), d.land(isLevel(a), isOff(b)))
                                                  : d.lor(isOff(a), isOff(b));
  return d.land(differs, d.lnot(isOpen));
}

}  // namespace rungproof
