// Levels at which blocks run: the main program and eight levels of calls, an interrupt routine and the levels below it
// (001:6744, 001:5444; S7-200 SMART: four). Each level has local memory of its own, its frame (001:1373).
#pragma once

#include <algorithm>
#include <cstdint>

#include "ir/s7200/cpu.hpp"

namespace rungproof {

inline constexpr unsigned mainNesting = 8;
inline constexpr unsigned interruptFrame = mainNesting + 1;
inline constexpr unsigned mostInterruptNesting = [] {
  int most = 0;
  for (const CpuRow& row : cpu_rows::rows) most = std::max(most, row.features.interruptNesting);
  return static_cast<unsigned>(most);
}();
inline constexpr unsigned frameCount = interruptFrame + 1 + mostInterruptNesting;
inline constexpr std::uint32_t frameBytes = 64;
/// Bytes of the local memory of all levels.
inline constexpr std::uint32_t localBytes = frameCount * frameBytes;

/// Most levels of the logic stack that a CPU has.
inline constexpr std::size_t mostStackLevels = [] {
  int most = 0;
  for (const CpuRow& row : cpu_rows::rows) most = std::max(most, row.features.stackLevels);
  return static_cast<std::size_t>(most);
}();

}  // namespace rungproof
