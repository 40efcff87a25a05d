// Runs of the engine that look for what takes long: inputs that stay, scans as long as they may be, thousands of scans
// in milliseconds. Several goals are watched at once. What such a run shows needs no solver, however far a timer
// counts. Tested by tests/prover/guided_runs_test.cpp.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "analysis/encoding/encoder.hpp"
#include "analysis/schedule/schedule.hpp"
#include "analysis/witness/witness.hpp"

namespace rungproof {

struct GuidedLimits {
  double seconds;
  /// Without a new goal shown, of the run with all inputs on, of that with all off, of those with one input on alone
  /// together, and of all random runs together.
  std::uint64_t instructions = schedule::guidedInstructions;
  /// Goals, the last ones, that are watched as long as runs are made for others.
  std::size_t alsoWatched = 0;
};

/// A run that the reference engine has repeated. Its scans, of which there may be a hundred thousand, are written down
/// for those who ask for them.
struct GuidedRun {
  std::shared_ptr<const std::vector<ReplayScan>> scans;
  bool comesAgain;      ///< the scans are made over and over
  std::uint64_t count;  ///< of the engine's scans, up to the one that shows the goal

  Witness witness() const;
};

/// By goal: a run that shows it, if one was found within the limits. `encoding` tells the program's inputs.
std::vector<std::optional<GuidedRun>> guidedRuns(const Program& program, const EncodedScan& encoding,
                                                 const std::vector<Property>& assumptions,
                                                 const std::vector<const Property*>& goals, std::uint64_t seed,
                                                 const GuidedLimits& limits);

}  // namespace rungproof
