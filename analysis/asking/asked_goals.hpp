// What the prover asks about declared properties: the properties themselves, and what shows whether they say anything.
// Covered by tests/prover and by the verdicts VACUOUS of the corpus.
#pragma once

#include "analysis/property.hpp"

namespace rungproof {

/// The goals of the set in their order, then their premises as goals to be reached, then someRun() if anything is
/// assumed.
std::vector<Property> askedGoals(const PropertySet& set);

/// Reached in the first scan of any run at all: unreachable only if the assumptions contradict each other.
Property someRun();

}  // namespace rungproof
