// The pulse generators of Q0.0 and Q0.1 as devices: how long a PTO train or profile lasts, when it ends, the next train
// of the pipeline, events 19 and 20 (001:4510-4699). PWM runs until it is stopped. The wave itself is not drawn.
// Covered by tests/engine/device_test.cpp.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "engine/high_speed_counters.hpp"

namespace rungproof {

class PulseOutputs {
 public:
  /// PLS started, changed or stopped output 0 or 1.
  void command(const Concrete::Store& store, std::uint32_t output);
  /// One ms; gives the pulses that each output made in it.
  std::array<std::uint32_t, 2> passMillisecond(Concrete::Store& store, const RaiseEvent& raise);
  void reset() { trains_ = {}; }

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
  static Train trainOf(const Concrete::Store& store, std::uint32_t output);
  static std::uint64_t durationUs(const Segment& segment, std::uint64_t pulses);
  static std::uint64_t durationUs(const Train& train);
  static std::uint64_t pulsesAt(const Train& train, std::uint64_t timeUs);
  static std::size_t segmentAt(const Train& train, std::uint64_t timeUs);
  void finish(Concrete::Store& store, std::uint32_t output, const RaiseEvent& raise);

  std::array<Train, 2> trains_;
};

}  // namespace rungproof
