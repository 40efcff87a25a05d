// What the registers of devices become when a request ends, over any domain: transmission, reception, network request,
// pulse train. The bytes that the end writes into memory come from the device (engine/serial_ports.hpp, encoder:
// analysis/encoding/device_writes.hpp). Covered by tests/environment/devices_test.cpp.
#pragma once

#include "ir/machine/machine.hpp"
#include "ir/s7200/pulse_output.hpp"

namespace rungproof {

/// Bit of Reg::PortBusy.
enum class PortUse : std::uint8_t { Transmission = 0, Reception = 1 };

/// Events 9, 26 and 23, 24 (001:5378-5415).
constexpr int eventOfEnd(PortUse use, std::uint32_t port) {
  if (use == PortUse::Transmission) return port == 0 ? 9 : 26;
  return port == 0 ? 23 : 24;
}

/// Status byte of RCV (001:14286), bit of SM4 for an idle transmitter (001:14109).
constexpr std::uint32_t receiveStatus(std::uint32_t port) { return port == 0 ? 86 : 186; }
constexpr std::uint32_t transmitterBit(std::uint32_t port) { return port == 0 ? 5 : 6; }

template <class D>
void endPortUse(Machine<D>& m, std::uint32_t port, PortUse use) {
  const std::uint64_t others = use == PortUse::Transmission ? 2 : 1;
  m.set(Reg::PortBusy, port, m.d.band(m.get(Reg::PortBusy, port), m.number(others, 2), 2));
}

/// Network requests that can be active at one time: NETR and NETW (001:3033), GET and PUT.
constexpr std::uint32_t networkRequests(const Target& target) { return isSmart(target) ? 16 : 8; }
/// The highest error code with which such a request ends: 1 to 9 (001:3052), of GET and PUT 1 to 5.
constexpr std::uint64_t lastNetworkError(const Target& target) { return isSmart(target) ? 5 : 9; }
/// The request in entry `entry` of Reg::NetTable.
template <class D>
void endNetworkRequest(Machine<D>& m, std::uint32_t entry) {
  constexpr int width = regInfo(Reg::NetActive).width;
  m.set(Reg::NetTable, entry, m.number(0, 32));
  if (isSmart(m.target)) m.set(Reg::NetBuffer, entry, m.number(0, 32));
  m.set(Reg::NetActive, 0, m.d.sub(m.get(Reg::NetActive), m.number(1, width), width));
}

/// A train or profile ends: the waiting train starts without a gap (001:4584), otherwise the output is free.
template <class D>
void endPulseTrain(Machine<D>& m, std::uint32_t output) {
  const auto waits = m.getBit(Reg::PulsePending, output);
  m.when(waits, [&] {
    m.set(Reg::PulseCycle, output, m.get(Reg::PulseNextCycle, output));
    m.set(Reg::PulseCount, output, m.get(Reg::PulseNextCount, output));
    m.set(Reg::PulseIsMs, output, m.get(Reg::PulseNextIsMs, output));
    m.setBit(Reg::PulsePending, output, m.d.constant(false));
  });
  m.when(m.d.lnot(waits), [&] {
    m.setBit(Reg::PulseBusy, output, m.d.constant(false));
    m.set(Reg::PulseSegments, output, m.number(0, 8));
  });
}

}  // namespace rungproof
