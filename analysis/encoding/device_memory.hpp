// Special memory that devices write: status of ports, counters, pulse outputs, potentiometers, I/O errors (appendix D,
// 001:14041-14420). The program finds any value there at the start of a scan.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>

namespace rungproof {

struct DeviceBytes {
  std::uint32_t first, last;
};

/// SMB2-3 received character (001:14083-14087), SMB5 I/O status (001:14118), SMB8-21 modules (001:14142), SMB28-29
/// potentiometers (001:14162), SMB36, 46, 56, 136, 146, 156 counter status (001:14216), SMB66, 76 pulse status
/// (001:14252), SMB86, 186 receive status (001:14278), SMW98 expansion bus errors, SMB166, 176 pulse segment
/// (001:14369).
inline constexpr std::array deviceBytes = {
    DeviceBytes{2, 3},     DeviceBytes{5, 5},     DeviceBytes{8, 21},    DeviceBytes{28, 29},   DeviceBytes{36, 36},
    DeviceBytes{46, 46},   DeviceBytes{56, 56},   DeviceBytes{66, 66},   DeviceBytes{76, 76},   DeviceBytes{86, 86},
    DeviceBytes{98, 99},   DeviceBytes{136, 136}, DeviceBytes{146, 146}, DeviceBytes{156, 156}, DeviceBytes{166, 166},
    DeviceBytes{176, 176}, DeviceBytes{186, 186}};

constexpr bool isDeviceByte(std::uint32_t byte) {
  return std::any_of(deviceBytes.begin(), deviceBytes.end(),
                     [&](const DeviceBytes& d) { return d.first <= byte && byte <= d.last; });
}

}  // namespace rungproof
