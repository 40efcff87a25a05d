// Numbers that somebody can set: steps with REAL values of many digits, such as the prover finds at limits, with fewer
// of them. Covered by tests/tables/rounded_steps_test.cpp.
#pragma once

#include <vector>

#include "analysis/testing/test_plan.hpp"
#include "analysis/testing/test_signals.hpp"

namespace rungproof {

/// Significant digits up to which a number is easy to set.
inline constexpr std::size_t easyDigits = 5;

/// Digits that are to be typed for a REAL value, without zeros at the end; those behind the point count from there on:
/// 3 of 12.5, 45 of 1e-45.
std::size_t digitsOf(TraceNumber value, const TraceSignal& signal);

/// Digits with which it can be set at all.
inline constexpr std::size_t mostDigits = 17;
bool canBeSet(const BenchTest& steps, const TestSignals& signals);

/// The steps with REAL values rounded down and up, to whole numbers first, then to more decimals; empty if all values
/// are easy to set.
std::vector<BenchTest> roundedSteps(const BenchTest& steps, const TestSignals& signals);

}  // namespace rungproof
