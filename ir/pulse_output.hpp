// The pulse outputs: which special memory, output and event each has (001:4656-4680, 001:14243-14266; the third and
// fourth on the S7-200 SMART only). Tests: tests/manual_a/pulse_test.cpp, tests/smart.
#pragma once

#include <array>
#include <cstdint>

#include "ir/cpu.hpp"

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

constexpr std::uint32_t pulseStatus(std::uint32_t output) { return pulseOutputs[output].status; }
constexpr std::uint32_t segmentByte(std::uint32_t output) { return pulseOutputs[output].segment; }
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
};
constexpr PulseForm pulseForm(const Target& target) {
  return isSmart(target) ? PulseForm{false, true, 12} : PulseForm{true, false, 8};
}

}  // namespace rungproof
