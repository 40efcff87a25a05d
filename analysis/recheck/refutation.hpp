// Whether clauses contradict each other, believed only step by step: CaDiCaL looks for the refutation, and each clause
// that it learns is checked (rup_checker.hpp). Tested by tests/recheck.
#pragma once

#include <atomic>

#include "analysis/recheck/gate_clauses.hpp"
#include "analysis/recheck/z3_check.hpp"

namespace rungproof {

struct RefutationLimits {
  double seconds = 1;
  const std::atomic<bool>* cancel = nullptr;
};

/// Valid: they contradict each other. Invalid: some values meet them. Unknown: not within the limits.
CheckResult refute(const GateClauses::Clauses& clauses, const RefutationLimits& limits);

}  // namespace rungproof
