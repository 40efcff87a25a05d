// From a difference of two traces to the comparison of a report: names, values, and the scans around it.
// Tested by tests/trace/comparison_test.cpp.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/trace_comparison.hpp"
#include "frontend/files/failure.hpp"
#include "frontend/report.hpp"

namespace rungproof {

/// Scans on either side of a difference that are shown.
inline constexpr std::size_t scansAround = 3;

Comparison comparisonOf(const Trace& expected, const Trace& actual, const std::optional<TraceDifference>& difference);

/// Whether some cell has a value: a trace without any agrees with everything.
bool expectsAnything(const Trace& expected);
Failure expectsNothing(const std::string& name);

/// "Q0.0=1" or "VD100=0.5" of --tolerance; a failure otherwise, and for a signal that `expected` does not have.
std::optional<Tolerance> toleranceIn(const std::string& text, const Trace& expected, Failure& failure);

}  // namespace rungproof
