// Writes of devices that a stimulus or a script gives: whether the requests that run allow them, and which request
// their status ends. Covered by tests/environment/devices_test.cpp.
#pragma once

#include <cstdint>
#include <optional>

#include "engine/concrete.hpp"

namespace rungproof {

struct DeviceEnd {
  std::optional<int> event;  ///< that the end raises; network requests have none
};

/// A device has written `value` to a direct operand: a status byte of RCV other than 0, the bit of an idle
/// transmitter, the status byte of an active network table without its bit 6, or SM66.7 or SM76.7 ends the request, if
/// it runs.
std::optional<DeviceEnd> endShownBy(Machine<Concrete>& machine, const Operand& operand, std::uint64_t value);

/// Whether a device may write `value` to a direct operand before this scan: some request runs that writes there, and
/// the manual allows the value. What each may write stands in analysis/encoding/device_writes.hpp.
bool mayDeviceWrite(Machine<Concrete>& machine, const Operand& operand, std::uint64_t value);

/// Whether the program has an instruction or a bit that sets a device going which writes memory later.
bool asksDevices(const Program& program);

}  // namespace rungproof
