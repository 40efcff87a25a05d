// Levels at which blocks run: the main program and eight levels of calls, an interrupt routine and the levels below it
// (001:6744, 001:5444; S7-200 SMART: four). Each level has local memory of its own, its frame (001:1373).
#pragma once

#include <cstddef>
#include <cstdint>

namespace rungproof {

inline constexpr unsigned mainNesting = 8;
inline constexpr unsigned interruptFrame = mainNesting + 1;
/// Of all CPUs; ir/s7200/cpu.cpp compares it with their rows.
inline constexpr unsigned mostInterruptNesting = 4;
inline constexpr unsigned frameCount = interruptFrame + 1 + mostInterruptNesting;
inline constexpr std::uint32_t frameBytes = 64;
/// Bytes of the local memory of all levels.
inline constexpr std::uint32_t localBytes = frameCount * frameBytes;

/// Most levels of the logic stack that a CPU has.
inline constexpr std::size_t mostStackLevels = 32;

}  // namespace rungproof
