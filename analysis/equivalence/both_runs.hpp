// A run of two programs on the reference engine, and the first scan at whose end an observed output differs: the judge
// of every difference that a solver finds. Tested by tests/equivalence.
#pragma once

#include "analysis/equivalence/equivalence.hpp"

namespace rungproof {

/// Two programs and what is compared of them.
struct BothRuns {
  const Program& before;
  const Program& after;
  const EquivalenceOptions& options;
  const std::vector<ObservedBit> observed;
  bool comparesStops = true;

  /// The first difference of the run; `run` has scans and initial states.
  std::optional<EquivalenceRun> judged(EquivalenceRun run) const;
  /// A judged run, with the usual readings of open points and clocks that start at 0 as far as it differs with them
  /// too.
  EquivalenceRun plain(EquivalenceRun run) const;
};

}  // namespace rungproof
