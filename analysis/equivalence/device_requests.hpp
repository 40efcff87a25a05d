// What a program asks of devices, as nodes of its encoding: at each execution of HDEF, HSC, PLS, XMT, RCV, NETR, NETW
// and TODW whether it runs, and what it hands over that decides what the device does. Two programs that ask the same in
// the same order have devices that can be taken to do the same: the same count, the same answer, an end at the same
// time. Where they may ask for different things, nothing that depends on a device is known to be equal.
// Tested by tests/equivalence/requests_test.cpp.
#pragma once

#include <array>
#include <vector>

#include "analysis/encoding/encoder.hpp"
#include "ir/program.hpp"
#include "ir/s7200/pulse_output.hpp"

namespace rungproof {

enum class Device : std::uint8_t { Counter, PulseOutput, Port, Network, Ethernet, Clock };

/// One execution of an instruction in a scan.
struct DeviceRequest {
  const Instruction* instruction;
  Device device;
  std::uint32_t number;        ///< of the counter, pulse output or port; 0: the clock
  Node runs;                   ///< whether it is executed
  std::vector<Node> settings;  ///< what it hands over, what is not used as 0
};

class RequestRecord {
 public:
  /// In front of an instruction of the final round of the encoding.
  void at(Machine<Graph>& machine, const Instruction& instruction);
  /// In the order of the scan.
  const std::vector<DeviceRequest>& requests() const { return requests_; }

 private:
  std::vector<DeviceRequest> requests_;
};

/// The places that requests hand over, so that the encoding keeps them apart.
void observeRequests(EncoderOptions& options, const Program& program);

/// Whether it sends messages to others.
bool sendsMessages(const Program& program);
/// By pulse output: whether PLS may set its generator going.
using UsedPulses = std::array<bool, pulseOutputCount>;
UsedPulses pulseOutputsOf(const Program& program);
/// Without any PLS the generators stay off, whatever form their registers have.
bool usesPulses(const Program& before, const Program& after);
/// Whether a device tells of something by that event.
bool isDeviceEvent(int event);
/// The control byte of a serial port: baud rate, parity, protocol (001:14167).
constexpr std::uint32_t portControl(std::uint32_t port) { return port == 0 ? 30 : 130; }

}  // namespace rungproof
