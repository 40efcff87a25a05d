// What a word that counts scans says about time, and time about the word: each scan adds a constant to the word and
// between the shortest and the longest scan to a clock, so that a multiple of the word bounds the clock on both sides.
// Ramps and debouncing counters are proved so. Tested by tests/solver/rates_test.cpp.
#pragma once

#include <functional>
#include <vector>

#include "analysis/bits/bit_blast.hpp"
#include "analysis/portfolio/bound_templates.hpp"

namespace rungproof {

/// A clock that is compared with such words: by what it grows, and where it stops.
struct RateClock {
  std::size_t state = 0;  ///< index in TransitionSystem::states
  Node increment = noNode;
  std::vector<std::uint64_t> stops;
};

/// Conditions under which two states (indices) are compared, noNode among them.
using RateGuards = std::function<std::vector<Node>(std::size_t clock, std::size_t word)>;

/// Adds templates for each of some clocks and the words among `states` (indices) that count on or down by constants.
/// Nothing where what a clock grows by has no limits. Adds nodes to the graph.
void addRates(BoundTemplates& to, const TransitionSystem& system, const BitBlast& blast,
              const std::vector<RateClock>& clocks, const std::vector<std::uint32_t>& states, const RateGuards& guards,
              const Budget& budget);

}  // namespace rungproof
