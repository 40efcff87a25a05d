// What surrounds the program in a simulated run: clock, counters, pulse outputs, ports, network, library blocks.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>

#include "engine/high_speed_counters.hpp"
#include "engine/network_requests.hpp"
#include "engine/pulse_outputs.hpp"
#include "engine/real_time_clock.hpp"
#include "engine/serial_ports.hpp"

namespace rungproof {

class Devices {
 public:
  Devices(const ClockTime& time, const Target& target) : clock(time), counters(target), pulses(target) {}

  RealTimeClock clock;
  HighSpeedCounters counters;
  PulseOutputs pulses;
  SerialPorts ports;
  NetworkRequests network;

  /// Output parameter `position` (place in the operand list of CALL, from 1) of library block `name`.
  void setLibraryOutput(const std::string& name, std::uint32_t position, std::uint64_t value) {
    library_[{name, position}] = value;
  }
  bool hasLibraryOutput(const std::string& name) const {
    const auto first = library_.lower_bound({name, 0});
    return first != library_.end() && first->first.first == name;
  }
  std::uint64_t libraryOutput(const std::string& name, std::uint32_t position) const {
    const auto found = library_.find({name, position});
    return found == library_.end() ? 0 : found->second;
  }

  /// S7-300/400: a byte of the start information of an organization block, `bits` of it.
  void setStartInformation(int block, std::uint32_t byte, std::uint8_t value, std::uint8_t bits = 0xFF) {
    std::uint8_t& given = starts_[{block, byte}];
    given = static_cast<std::uint8_t>((given & ~bits) | (value & bits));
  }
  bool hasStartInformation() const { return !starts_.empty(); }
  /// Nothing: no stimulus says it.
  std::optional<std::uint8_t> startInformation(int block, std::uint32_t byte) const {
    const auto found = starts_.find({block, byte});
    return found == starts_.end() ? std::nullopt : std::optional(found->second);
  }

  /// Nothing happens at the ticks of the 1 ms clock to come until the program asks for something.
  bool areIdle(const Concrete::Store& store) const {
    return counters.areIdle(store) && pulses.areIdle() && ports.areIdle(store);
  }
  /// One tick of the 1 ms clock.
  void passMillisecond(Concrete::Store& store, const RaiseEvent& raise) {
    counters.passMillisecond(store, pulses.passMillisecond(store, raise), raise);
    ports.passMillisecond(store, raise);
  }
  /// The CPU enters RUN or loses power; what is on the way from outside stays on the way.
  void reset() {
    counters.reset();
    pulses.reset();
    ports.reset();
    network.reset();
  }

 private:
  std::map<std::pair<int, std::uint32_t>, std::uint8_t> starts_;
  std::map<std::pair<std::string, std::uint32_t>, std::uint64_t> library_;
};

}  // namespace rungproof
