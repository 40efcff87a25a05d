// The pulse generators as devices: how long a PTO train or profile lasts, when it ends, the next train
// of the pipeline, events 19 and 20 (001:4510-4699). PWM runs until it is stopped. The wave itself is not drawn.
// Covered by tests/engine/device_test.cpp.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "engine/high_speed_counters.hpp"

namespace rungproof {

class PulseOutputs {
 public:
  explicit PulseOutputs(const Target& target) : form_(pulseForm(target)) {}

  /// PLS started, changed or stopped that output.
  void command(const Concrete::Store& store, std::uint32_t output);
  /// One ms; gives the pulses that each output made in it.
  PulseCounts passMillisecond(Concrete::Store& store, const RaiseEvent& raise);
  void reset() { trains_ = {}; }
  /// No train is running.
  bool areIdle() const { return std::ranges::none_of(trains_, &Train::isRunning); }

 private:
  /// `count` pulses, the first `cycleUs` long, each longer than the one before by `changeUs`.
  struct Segment {
    std::int64_t cycleUs;
    std::int64_t changeUs;
    std::uint64_t count;
  };
  struct Train {
    std::vector<Segment> segments;
    bool isAborted = false;  ///< a cycle time becomes illegal; the segments end there (001:4649)
    std::uint64_t passedUs = 0;
    bool isRunning = false;
  };
  Train trainOf(const Concrete::Store& store, std::uint32_t output) const;
  Segment segmentIn(const Concrete::Store& store, std::uint32_t bit, std::int64_t unitUs, bool& isAborted) const;
  static std::uint64_t durationUs(const Segment& segment, std::uint64_t pulses);
  static std::uint64_t durationUs(const Train& train);
  static std::uint64_t pulsesAt(const Train& train, std::uint64_t timeUs);
  static std::size_t segmentAt(const Train& train, std::uint64_t timeUs);
  void finish(Concrete::Store& store, std::uint32_t output, const RaiseEvent& raise);

  PulseForm form_;
  std::array<Train, pulseOutputCount> trains_;
};

}  // namespace rungproof
