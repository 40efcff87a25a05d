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

ScanTime scanTimeFor(const Settings& settings, const Program& program, ScanTime usual) {
  if (const std::optional<ScanTime> given = settings.scanTime()) return *given;
  if (!program.taskMs) return usual;
  const std::chrono::milliseconds interval(std::min<std::uint32_t>(*program.taskMs, 60'000));
  return {interval, interval};
}

}  // namespace rungproof
