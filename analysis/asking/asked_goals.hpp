// What the prover asks about declared properties: the properties themselves, and what shows whether they say anything.
// Covered by tests/prover and by the verdicts VACUOUS of the corpus.
#pragma once

#include "analysis/property.hpp"

namespace rungproof {

/// The goals of the set in their order, then their premises as goals to be reached, then someRun() if anything is
/// assumed, or if the program may end no scan.
std::vector<Property> askedGoals(const PropertySet& set, bool mayEndNoScan);

/// Reached at the end of the first scan of any run at all: unreachable only if the assumptions contradict each other or
/// every run stops or loops before. Properties are looked at when a scan ends: of such a program all of them hold.
Property someRun();

}  // namespace rungproof
