// The pulse outputs: which special memory, output and event each has (001:4656-4680, 001:14243-14266; the third and
// fourth on the S7-200 SMART only). Tests: tests/manual/pulse_test.cpp, tests/smart.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "ir/s7200/cpu.hpp"

namespace rungproof {

inline constexpr std::uint32_t pulseOutputCount = 4;

struct PulseOutputInfo {
  std::uint32_t status;   ///< byte of SM; the control byte stands behind it
  std::uint32_t segment;  ///< byte of SM: active segment of a profile; two behind it the word with the profile's place
  std::uint32_t point;    ///< Q0.n
  int event;              ///< of the end of a train; -1: no number is known
};
inline constexpr std::array<PulseOutputInfo, pulseOutputCount> pulseOutputs = {
    {{66, 166, 0, 19}, {76, 176, 1, 20}, {566, 576, 3, 34}, {580, 590, 2, -1}}};

/// Bits of the status byte that the end of a train writes.
inline constexpr std::uint32_t pulseAborted = 4, pulseIdle = 7;

/// The pulse output that drives Q0.`point`.
constexpr std::optional<std::uint32_t> generatorOf(std::uint32_t point) {
  for (std::uint32_t output = 0; output < pulseOutputCount; ++output) {
    if (pulseOutputs[output].point == point) return output;
  }
  return std::nullopt;
}

constexpr std::uint32_t pulseStatus(std::uint32_t output) { return pulseOutputs[output].status; }
/// The control byte. From it on: +1 cycle time or frequency (word), +3 pulse width (word), +5 number of pulses.
constexpr std::uint32_t pulseControl(std::uint32_t output) { return pulseStatus(output) + 1; }
constexpr std::uint32_t segmentByte(std::uint32_t output) { return pulseOutputs[output].segment; }
/// Word with the place of the profile in V.
constexpr std::uint32_t profileWord(std::uint32_t output) { return segmentByte(output) + 2; }
constexpr int eventOfTrain(std::uint32_t output) { return pulseOutputs[output].event; }
constexpr bool isPulseEvent(int event) { return event == 19 || event == 20 || event == 34; }
constexpr std::uint32_t outputOfTrain(int event) { return event == 19 ? 0 : event == 20 ? 1 : 2; }

constexpr CpuSet cpusWithPulseOutputs(int count) {
  return cpusWith([=](const CpuRow& row) { return row.features.pulseOutputs == count; });
}

/// How a family of CPUs describes trains. S7-200: control bit 6 is PWM, a train has a cycle time, a segment of a
/// profile 8 bytes. S7-200 SMART: bit 6 is PTO, a train has a frequency, a segment 12 bytes: frequency at its start and
/// at its end, number of pulses, 32 bits each.
struct PulseForm {
  bool bit6IsPwm;
  bool hasFrequency;
  std::uint32_t segmentBytes;

  bool operator==(const PulseForm&) const = default;
};
constexpr PulseForm pulseForm(const Target& target) {
  return isSmart(target) ? PulseForm{false, true, 12} : PulseForm{true, false, 8};
}

}  // namespace rungproof
