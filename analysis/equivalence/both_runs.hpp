// A run of two programs on the reference engine, and the first scan at whose end an observed output differs: the judge
// of every difference that a solver finds. Tested by tests/equivalence.
#pragma once

#include <deque>

#include "analysis/equivalence/equivalence.hpp"

namespace rungproof {

/// A program at the end of a scan.
struct ScanOutputs {
  bool runs = false;
  std::vector<std::uint64_t> values;  ///< by observed output
};

/// Two programs and what is compared of them.
struct BothRuns {
  const Program& before;
  const Program& after;
  const EquivalenceOptions& options;
  const std::vector<ObservedBit> observed;
  bool comparesStops = true;

  ScanOutputs outputsOf(const Concrete::Store& state, bool isOld) const;
  /// The first difference of the run; `run` has scans and initial states.
  std::optional<EquivalenceRun> judged(EquivalenceRun run) const;
  /// A judged run, with the usual readings of open points and clocks that start at 0 as far as it differs with them
  /// too.
  EquivalenceRun plain(EquivalenceRun run) const;
};

/// Compares two runs scan end by scan end, latency and settling counted in. A copy can go on in another way.
class OutputWatch {
 public:
  explicit OutputWatch(const BothRuns& runs)
      : latency_(runs.options.latency),
        settleMs_(runs.options.settleMs),
        comparesStops_(runs.comparesStops),
        lasted_(runs.observed.size()) {
    for (const ObservedBit& bit : runs.observed) pulses_.push_back(bit.pulses);
  }

  struct Difference {
    std::size_t output = 0;  ///< BothRuns::observed.size(): one program has stopped
    std::uint64_t before = 0, after = 0;
  };
  /// Both programs at the end of the next scan, which took that long.
  std::optional<Difference> next(ScanOutputs before, const ScanOutputs& after, std::uint32_t lengthMs);

 private:
  bool isAlike(std::size_t output, std::uint64_t before, std::uint64_t after) const;

  std::vector<std::optional<PulseSignal>> pulses_;  ///< by observed output
  std::size_t latency_;
  std::uint32_t settleMs_;
  bool comparesStops_;
  std::vector<std::optional<std::uint64_t>> lasted_;  ///< ms since the first scan end with a difference
  std::deque<ScanOutputs> old_;                       ///< OLD's last scan ends that NEW has not come to
};

}  // namespace rungproof
