// Runs of both programs by the engine, with the same inputs, that go on from states that are new: a difference that
// shows after hours of counting is found in a second, without any encoding. Finds differences; proves nothing.
// Tested by tests/equivalence/pair_exploration_test.cpp.
#pragma once

#include <atomic>
#include <chrono>
#include <optional>
#include <vector>

#include "analysis/equivalence/both_runs.hpp"

namespace rungproof {

/// The output bits that instructions of either program name; options.observed if there are any.
std::vector<ObservedBit> namedOutputs(const Program& before, const Program& after, const EquivalenceOptions& options);

/// A run on which an output of `runs` differs, judged. Both start at power-up with lost memory, and nothing but inputs
/// comes from outside. Nothing where none is found until `deadline` or `cancel`, or where an input of one program
/// stands for what is no input of the other, assumptions speak of both, or immediate reads are steady (they are quiet
/// here).
std::optional<EquivalenceRun> exploredRun(const Side& before, const Side& after, const BothRuns& runs,
                                          std::chrono::steady_clock::time_point deadline,
                                          const std::atomic<bool>& cancel);

}  // namespace rungproof
