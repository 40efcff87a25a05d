// A run that ends with a difference, without what it does not need: scans, rounds of scans, inputs that are on. For
// runs of nothing but inputs; what devices and events do has causes. Tested by
// tests/equivalence/pair_exploration_test.cpp.
#pragma once

#include <chrono>

#include "analysis/equivalence/both_runs.hpp"

namespace rungproof {

/// The same output differs, not later than before. Ends at `deadline` with the shortest one found.
EquivalenceRun shorterRun(const BothRuns& runs, EquivalenceRun run, std::chrono::steady_clock::time_point deadline);

}  // namespace rungproof
