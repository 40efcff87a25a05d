// The high-speed counters as devices: they count edges of their inputs and pulses that the stimulus gives per scan,
// obey direction, reset and start inputs, and raise their events (001:4121-4356). Modes and inputs:
// ir/s7200/hsc_inputs.hpp. In quadrature modes input A leading B counts up; the manual does not say which. Covered by
// tests/engine/device_test.cpp.
#pragma once

#include <array>
#include <cstdint>
#include <functional>

#include "engine/concrete.hpp"
#include "ir/s7200/pulse_output.hpp"

namespace rungproof {

/// Receives an interrupt event the moment it occurs; the routine may run inside the call.
using RaiseEvent = std::function<void(int event)>;

/// Pulses that each pulse output made.
using PulseCounts = std::array<std::uint32_t, pulseOutputCount>;

class HighSpeedCounters {
 public:
  static constexpr std::uint32_t count = 6;

  explicit HighSpeedCounters(const Target& target) : target_(target) {}

  /// Pulses of the clock (or up-clock) input and of the down-clock input in every scan from now on, spread evenly over
  /// its ms. In quadrature modes: whole periods forwards and backwards.
  void setPulses(std::uint32_t counter, std::uint32_t up, std::uint32_t down) { pulses_[counter] = {up, down}; }
  std::array<std::uint32_t, 2> pulses(std::uint32_t counter) const { return pulses_[counter]; }

  /// Start of a scan of `lengthMs`: takes up what the physical inputs did.
  void beginScan(Concrete::Store& store, std::uint32_t lengthMs, const RaiseEvent& raise);
  /// Whether beginScan() was last called with the physical inputs as they are.
  bool hasSeen(const Concrete::Store& store) const { return hasSeen_ && seen_ == store.terminals(Reg::PhysicalInput); }
  /// One ms of the scan. `ptoPulses`: pulses of PTO0 and PTO1 in it, for mode 12.
  void passMillisecond(Concrete::Store& store, const PulseCounts& ptoPulses, const RaiseEvent& raise);
  void reset();
  /// No counter has a mode.
  bool areIdle(const Concrete::Store& store) const {
    std::uint64_t modes = 0;
    for (std::uint32_t counter = 0; counter < count; ++counter) modes |= store.get(Reg::HscMode, counter);
    return modes == 0;
  }

 private:
  struct Lines {
    std::array<bool, 4> level{};  ///< clock, direction or second clock, reset, start
  };
  using Inputs = Concrete::Store::Terminals;
  Lines linesOf(const Inputs& inputs, std::uint32_t counter) const;
  void takeInputs(Concrete::Store& store, std::uint32_t counter, const Lines& before, const RaiseEvent& raise);
  void feed(Concrete::Store& store, std::uint32_t counter, std::uint32_t up, std::uint32_t down,
            const RaiseEvent& raise);
  bool mayCount(const Concrete::Store& store, std::uint32_t counter) const;
  void step(Concrete::Store& store, std::uint32_t counter, bool up, const RaiseEvent& raise);
  void turn(Concrete::Store& store, std::uint32_t counter, bool up, const RaiseEvent& raise);
  static void showStatus(Concrete::Store& store, std::uint32_t counter);

  Target target_;
  std::array<std::array<std::uint32_t, 2>, count> pulses_{};
  Inputs seen_{};  ///< what the lines show
  bool hasSeen_ = false;
  std::uint32_t scanMs_ = 1;
  std::uint32_t passed_ = 0;
};

}  // namespace rungproof
