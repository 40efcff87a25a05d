// Status writes to ends.
#include "engine/device_end.hpp"

#include <algorithm>
#include <array>

#include "ir/s7200/device_end.hpp"
#include "ir/s7200/special_memory.hpp"

namespace rungproof {

namespace {

constexpr std::uint64_t requestIsActive = 0x40;  // bit A of a network table (000:1137)

bool uses(const Machine<Concrete>& machine, std::uint32_t port, PortUse use) {
  return (machine.store.get(Reg::PortBusy, port) >> static_cast<unsigned>(use) & 1U) != 0;
}

std::optional<DeviceEnd> portEnd(Machine<Concrete>& machine, const Operand& operand, std::uint64_t value) {
  for (std::uint32_t port = 0; port < 2; ++port) {
    const bool isStatus = operand.width == Width::Byte && operand.offset == receiveStatus(port) && value != 0;
    const bool isIdle =
        operand.width == Width::Bit && operand.offset == 4 && operand.bit == transmitterBit(port) && value != 0;
    const PortUse use = isStatus ? PortUse::Reception : PortUse::Transmission;
    if ((!isStatus && !isIdle) || !uses(machine, port, use)) continue;
    endPortUse(machine, port, use);
    return DeviceEnd{eventOfEnd(use, port)};
  }
  return std::nullopt;
}

std::optional<DeviceEnd> trainEnd(Machine<Concrete>& machine, const Operand& operand) {
  if (operand.width != Width::Bit || operand.bit != pulseIdle) return std::nullopt;
  for (std::uint32_t output = 0; output < pulseOutputCount; ++output) {
    const bool isTrain = machine.getBit(Reg::PulseBusy, output) && !machine.getBit(Reg::PulseIsPwm, output);
    if (operand.offset != pulseStatus(output) || !isTrain) continue;
    endPulseTrain(machine, output);
    return DeviceEnd{eventOfTrain(output)};
  }
  return std::nullopt;
}

/// A place that a table holds: its distance from the table's first byte, if it lies there.
std::optional<std::uint32_t> offsetIn(std::uint64_t table, const Operand& operand) {
  const auto address = static_cast<std::uint32_t>(table);
  if (address == 0 || pointer::areaOf(address) != operand.area || operand.offset < pointer::offsetOf(address))
    return std::nullopt;
  return operand.offset - pointer::offsetOf(address);
}

bool mayReceive(Machine<Concrete>& machine, std::uint32_t port, const Operand& operand, std::uint64_t value) {
  if (!uses(machine, port, PortUse::Reception)) return false;
  const std::uint64_t limit = machine.store.get(Reg::PortLimit, port);
  const auto offset = offsetIn(machine.store.get(Reg::PortTable, port * 2 + 1), operand);
  return offset && *offset <= limit && (*offset != 0 || value <= limit);
}

bool mayAnswer(Machine<Concrete>& machine, std::uint32_t entry, const Operand& operand, std::uint64_t value) {
  const std::uint64_t length = machine.store.get(Reg::NetLength, entry);
  const auto inBuffer = offsetIn(machine.store.get(Reg::NetBuffer, entry), operand);
  if (inBuffer && *inBuffer < length) return true;
  const auto offset = offsetIn(machine.store.get(Reg::NetTable, entry), operand);
  if (!offset) return false;
  if (*offset == 0) {
    const std::uint64_t code = value & 0x0F;
    return value == 0x80 || ((value & 0x70) == 0x20 && code >= 1 && code <= lastNetworkError(machine.target));
  }
  const bool isData = *offset >= 7 && *offset < 7 + length;
  return isData && machine.store.get(Reg::NetIsWrite, entry) == 0;
}

bool mayWriteStatus(Machine<Concrete>& machine, const Operand& operand, std::uint64_t value) {
  const Concrete::Store& store = machine.store;
  const auto isBit = [&](std::uint32_t byte, std::uint32_t bit) {
    return operand.width == Width::Bit && operand.offset == byte && operand.bit == bit;
  };
  for (std::uint32_t i = 0; i < 2; ++i) {
    if (operand.width == Width::Byte && operand.offset == receiveStatus(i))
      return (machine.getBit(Reg::FirstScan) && (value & 0x18) == 0) ||
             (uses(machine, i, PortUse::Reception) && value != 0 && (value & ~0x27ULL) == 0);
    if (isBit(4, transmitterBit(i))) return value != 0 && uses(machine, i, PortUse::Transmission);
  }
  for (std::uint32_t i = 0; i < pulseOutputCount; ++i) {
    const bool isTrain = store.get(Reg::PulseBusy, i) != 0 && store.get(Reg::PulseIsPwm, i) == 0;
    const std::uint64_t segments = store.get(Reg::PulseSegments, i);
    if (isBit(pulseStatus(i), pulseIdle)) return isTrain && (value != 0) == (store.get(Reg::PulsePending, i) == 0);
    if (isBit(pulseStatus(i), pulseAborted)) return isTrain && segments != 0 && value != 0;
    if (operand.width == Width::Byte && operand.offset == segmentByte(i))
      return store.get(Reg::PulseBusy, i) != 0 && value >= 1 && value <= segments;
  }
  static constexpr std::array<std::uint32_t, 6> counters = {36, 46, 56, 136, 146, 156};
  for (std::uint32_t i = 0; i < counters.size(); ++i) {
    if (operand.offset == counters[i] && operand.width == Width::Bit && operand.bit >= 5)
      return store.get(Reg::HscMode, i) != 0;
  }
  return savesMemory(machine.target) && isBit(31, 7) && value == 0 && store.load(Area::SM, 31 * 8 + 7, 1) != 0;
}

bool asks(const Instruction& instruction) {
  static constexpr std::array roles = {Role::Xmt, Role::Rcv, Role::Netr, Role::Netw,
                                       Role::Get, Role::Put, Role::Pls,  Role::Hdef};
  if (std::ranges::find(roles, roleOf(instruction)) != roles.end()) return true;
  return std::ranges::any_of(instruction.operands, [](const Operand& operand) {
    return operand.kind == OperandKind::Direct && operand.area == Area::SM && operand.offset == 31;
  });
}

}  // namespace

bool mayDeviceWrite(Machine<Concrete>& machine, const Operand& operand, std::uint64_t value) {
  if (operand.area == Area::SM && mayWriteStatus(machine, operand, value)) return true;
  if (operand.width != Width::Byte) return false;
  for (std::uint32_t port = 0; port < 2; ++port) {
    if (mayReceive(machine, port, operand, value)) return true;
  }
  for (std::uint32_t entry = 0; entry < networkRequests(machine.target); ++entry) {
    if (mayAnswer(machine, entry, operand, value)) return true;
  }
  return false;
}

bool asksDevices(const Program& program) {
  for (const Pou& pou : program.pous) {
    for (const Network& network : pou.networks) {
      if (std::ranges::any_of(network.instructions, asks)) return true;
    }
  }
  return false;
}

std::optional<DeviceEnd> endShownBy(Machine<Concrete>& machine, const Operand& operand, std::uint64_t value) {
  if (operand.area == Area::SM) {
    if (auto end = portEnd(machine, operand, value)) return end;
    return trainEnd(machine, operand);
  }
  if (operand.width != Width::Byte || (value & requestIsActive) != 0) return std::nullopt;
  const std::uint32_t table = pointer::encode(operand.area, operand.offset);
  for (std::uint32_t entry = 0; entry < networkRequests(machine.target); ++entry) {
    if (table == 0 || machine.store.get(Reg::NetTable, entry) != table) continue;
    endNetworkRequest(machine, entry);
    return DeviceEnd{};
  }
  return std::nullopt;
}

}  // namespace rungproof
