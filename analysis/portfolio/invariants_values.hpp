// Words that take few values: a step word, a ramp that goes up and down in tens, an index of a table. Which values
// these are is found from the initial one on: what a scan can make of the values so far, whatever the rest of the state
// is, is added until nothing new comes. Bounds say less: 999 and 10 more would be beyond 1000, but no multiple of ten
// is. Tested by tests/solver/word_values_test.cpp.
#pragma once

#include <cstdint>
#include <vector>

#include "analysis/bits/bit_blast.hpp"
#include "analysis/portfolio/invariants.hpp"

namespace rungproof {

/// Of one state: all values that it takes, ascending.
struct WordValues {
  std::size_t state = 0;  ///< index in TransitionSystem::states
  std::vector<std::uint64_t> values;
};

/// Words in the cone of the blasted questions whose values are at most schedule::valueLimit. Each set is kept by every
/// scan from states that satisfy `known` and the other sets. What the budget cuts off is left out.
std::vector<WordValues> mineWordValues(const TransitionSystem& system, BitBlast& blast, const Invariants& known,
                                       std::uint64_t seed, const Budget& budget);

/// "The word has one of these values", of width 1.
Node isOneOf(Graph& graph, Node word, const std::vector<std::uint64_t>& values);

}  // namespace rungproof
