// Durations to microseconds of the engine.
#include "frontend/simulation/scan_lengths.hpp"

#include <algorithm>

namespace rungproof {

ScanLength scanLengthsOf(const ScanTime& range, std::uint64_t seed) {
  const auto limited = [](Duration duration) {
    return static_cast<std::uint32_t>(std::min<std::int64_t>(duration.count(), 60'000'000));
  };
  const std::uint32_t low = limited(range.low), high = limited(range.high);
  return drawnScanLengths(low, high, low % 1000 == 0 && high % 1000 == 0 ? 1000 : 1, seed);
}

}  // namespace rungproof
