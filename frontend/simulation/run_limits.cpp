// Both limits are asked for before a run as far as its length is known, and again while it goes on.
#include "frontend/simulation/run_limits.hpp"

#include <fmt/format.h>

namespace rungproof {

std::optional<Failure> refusedRun(std::uint64_t scans, std::size_t signals, std::uint64_t memory) {
  if (scans > mostScans) {
    return Failure{fmt::format("the run would have more than {} scans", mostScans),
                   {},
                   "end it earlier: stimulus and expected trace, --scans, --duration; or make the scans longer"};
  }
  const std::uint64_t row = sizeof(TraceRow) + signals * sizeof(TraceRow::values[0]);
  if (signals == 0 || scans <= memory / row) return std::nullopt;
  return Failure{fmt::format("the trace of {} scans with {} signal{} does not fit into {} MB of memory", scans, signals,
                             signals == 1 ? "" : "s", memory / 1'000'000),
                 {},
                 "name fewer signals with --signals, make the run shorter, or give --memory"};
}

}  // namespace rungproof
