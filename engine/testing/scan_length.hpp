// Lengths of scans by their number, so that a player can look ahead. Covered by tests/tables/player_test.cpp.
#pragma once

#include <cstdint>
#include <functional>

#include "engine/splitmix.hpp"

namespace rungproof {

/// Length of a scan in us, by its number from 1.
using ScanLength = std::function<std::uint32_t(std::uint64_t scan)>;

/// Anything from `lowUs` to `highUs` in steps of `unitUs`, drawn with the seed for each scan.
inline ScanLength drawnScanLengths(std::uint32_t lowUs, std::uint32_t highUs, std::uint32_t unitUs,
                                   std::uint64_t seed) {
  if (lowUs == highUs) return [lowUs](std::uint64_t) { return lowUs; };
  return [=](std::uint64_t scan) {
    const std::uint64_t steps = (highUs - lowUs) / unitUs + 1;
    return static_cast<std::uint32_t>(lowUs + splitmix(seed * splitmixStep + scan) % steps * unitUs);
  };
}

}  // namespace rungproof
