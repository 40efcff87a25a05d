// Runs of the system on numbers, 64 at once, for questions whose cone multiplies or divides: the circuits of that are
// long, the numbers are not. Inputs are 0, all ones, or what makes the comparisons of the cone true or false.
// Tested by tests/solver/word_runs_test.cpp.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "analysis/bits/bit_blast.hpp"

namespace rungproof {

/// By index in `open`: a run of a few scans that ends in the question's bad scan, if one was found. Questions without
/// such arithmetic, and systems with too many nodes, are not looked at.
std::vector<std::optional<WordTrace>> wordRuns(const TransitionSystem& system, const Questions& open,
                                               std::uint64_t seed, const Budget& budget);

}  // namespace rungproof
