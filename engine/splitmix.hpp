// SplitMix64: a number that looks drawn, from a place in a sequence. The same on every machine.
#pragma once

#include <cstdint>

namespace rungproof {

/// Numbers of a sequence have states that are this far apart.
inline constexpr std::uint64_t splitmixStep = 0x9E3779B97F4A7C15ULL;

constexpr std::uint64_t splitmix(std::uint64_t state) {
  state = (state ^ state >> 30) * 0xBF58476D1CE4E5B9ULL;
  state = (state ^ state >> 27) * 0x94D049BB133111EBULL;
  return state ^ state >> 31;
}

}  // namespace rungproof
