// What surrounds the program in a simulated run: real-time clock and the values that library blocks and the network
// deliver. High-speed counters, pulse outputs and ports have files of their own.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>

#include "engine/real_time_clock.hpp"

namespace rungproof {

class Devices {
 public:
  explicit Devices(const ClockTime& time) : clock(time) {}

  RealTimeClock clock;

  /// Output parameter `position` (place in the operand list of CALL, from 1) of library block `name`.
  void setLibraryOutput(const std::string& name, std::uint32_t position, std::uint64_t value) { library_[{name, position}] = value; }
  std::uint64_t libraryOutput(const std::string& name, std::uint32_t position) const {
    const auto found = library_.find({name, position});
    return found == library_.end() ? 0 : found->second;
  }

 private:
  std::map<std::pair<std::string, std::uint32_t>, std::uint64_t> library_;
};

}  // namespace rungproof
