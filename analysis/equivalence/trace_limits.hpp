// What of a run a trace can hold: a run that anyone can repeat by a stimulus is preferred, and what is needed beyond it
// is said. Tested by tests/equivalence/undefined_test.cpp.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "analysis/equivalence/both_runs.hpp"

namespace rungproof {

inline constexpr const char* differingReads = "several reads of one input in a scan that differ";

/// The run without values inside a scan that belong to a kind.
EquivalenceRun without(EquivalenceRun run, bool (*isLeftOut)(External));
/// The run from power-up with nothing but what every stimulus gives: inputs, lengths of scans, events, devices.
EquivalenceRun stimulusOnly(const Program& before, const Program& after, const EquivalenceRun& run);
/// What the difference is gone without, or what of a run the reader of a trace passes over.
std::vector<std::string> beyondTrace(const BothRuns& runs, const EquivalenceRun& run);
/// A read of something that nothing has given a value, in words, with its place.
std::string undefinedText(const Program& program, const ExternalSite& site);
/// Those of a run that find another value than usual.
std::set<std::string> undefinedReads(const Program& before, const Program& after, const EquivalenceRun& run);

}  // namespace rungproof
