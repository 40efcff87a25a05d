// The machine of IEC 61131-3 programs. It is no CPU of a maker: its rows differ in how many bytes the variables of the
// program may take, and the reader takes the smallest that holds them. All variables lie in the area V, one behind the
// other; located ones too, because nothing of the machine reads or writes terminals by itself.
// Tested by tests/iec.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "ir/area.hpp"
#include "ir/target.hpp"

namespace rungproof {

struct IecMachineRow {
  std::string_view name;
  std::uint32_t bytes;  ///< of all variables
};

namespace cpu_rows {
inline constexpr auto iec = std::to_array<IecMachineRow>({{"IEC-4K", 4096}, {"IEC-64K", 65536}, {"IEC-1M", 1U << 20}});
}

/// Number of the first of these machines among all CPUs (ir/target.hpp).
inline constexpr std::size_t firstIecCpu = 24;
constexpr bool isIec(Cpu cpu) {
  const auto number = static_cast<std::size_t>(cpu);
  return number >= firstIecCpu && number < firstIecCpu + cpu_rows::iec.size();
}
constexpr bool isIec(const Target& target) { return isIec(target.cpu); }
constexpr const IecMachineRow& iecRow(Cpu cpu) { return cpu_rows::iec[static_cast<std::size_t>(cpu) - firstIecCpu]; }

/// Size of an area in bytes.
constexpr std::uint32_t iecAreaSize(const IecMachineRow& row, Area area) { return area == Area::V ? row.bytes : 0; }

}  // namespace rungproof
