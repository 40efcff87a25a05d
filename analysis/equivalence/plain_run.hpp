// Plain runs: one that needs nothing but inputs, lengths of scans, events and devices is preferred, and what it reads
// that nothing has given a value is said. Tested by tests/equivalence/undefined_test.cpp.
#pragma once

#include <set>
#include <string>

#include "analysis/equivalence/both_runs.hpp"

namespace rungproof {

/// The run without values inside a scan that belong to a kind.
EquivalenceRun without(EquivalenceRun run, bool (*isLeftOut)(External));
/// The run from power-up with nothing but inputs, lengths of scans, events and devices.
EquivalenceRun stimulusOnly(const Program& before, const Program& after, const EquivalenceRun& run);
/// A read of something that nothing has given a value, in words, with its place.
std::string undefinedText(const Program& program, const ExternalSite& site);
/// Those of a run that find another value than usual.
std::set<std::string> undefinedReads(const Program& before, const Program& after, const EquivalenceRun& run);

}  // namespace rungproof
