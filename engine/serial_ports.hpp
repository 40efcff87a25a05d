// The ports in Freeport mode as devices: how long a transmission lasts, characters that the stimulus sends, the message
// that RCV collects with its start and end conditions (001:3135-3342, 001:14283-14294). Parity errors do not occur.
// Covered by tests/engine/device_test.cpp.
#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <vector>

#include "engine/high_speed_counters.hpp"

namespace rungproof {

class SerialPorts {
 public:
  static constexpr int breakSignal = 256;

  /// The other station sends a character (0..255) or a break to port 0 or 1; characters arrive one after the other
  /// at the rate that the port is set to.
  void send(std::uint32_t port, int character) { lines_[port].incoming.push_back(character); }
  /// Everything that XMT has sent so far.
  const std::vector<std::uint8_t>& transmitted(std::uint32_t port) const { return lines_[port].sent; }

  void transmitStarted(const Concrete::Store& store, std::uint32_t port);
  void receiveStarted(const Concrete::Store& store, std::uint32_t port);
  void receiveEnded(std::uint32_t port, const RaiseEvent& raise);
  void passMillisecond(Concrete::Store& store, const RaiseEvent& raise);
  void reset();
  /// Nothing is on its way.
  bool areIdle(const Concrete::Store& store) const {
    for (std::uint32_t port = 0; port < lines_.size(); ++port) {
      if (store.get(Reg::PortBusy, port) != 0 || !lines_[port].incoming.empty()) return false;
    }
    return true;
  }

 private:
  struct Line {
    std::deque<int> incoming;
    std::vector<std::uint8_t> sent;
    std::uint64_t transmitLeftUs = 0;
    std::uint64_t arrivalUs = 0;  ///< time that the line has had for the next character
    std::uint64_t quietMs = 0;    ///< since the last character
    bool isMessageOpen = false;   ///< the start condition is met
    bool sawIdle = false;
    bool sawBreak = false;
    std::uint32_t stored = 0;
    std::uint64_t messageMs = 0;
  };
  static std::uint64_t characterUs(const Concrete::Store& store, std::uint32_t port);
  void arrive(Concrete::Store& store, std::uint32_t port, int character, const RaiseEvent& raise);
  bool meetsStart(const Concrete::Store& store, std::uint32_t port, int character);
  void endMessage(Concrete::Store& store, std::uint32_t port, std::uint8_t status, const RaiseEvent& raise);

  std::array<Line, 2> lines_;
};

}  // namespace rungproof
