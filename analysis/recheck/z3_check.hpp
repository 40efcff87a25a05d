// Z3 as judge of formulas that must be unsatisfiable, in a process of its own: there are phases in which Z3 neither
// looks at its time limit nor can be interrupted, and a proof run must come back in time. Tested by tests/certificate
// and tests/timing/limits_test.cpp.
#pragma once

#include <atomic>
#include <cstdint>
#include <string>
#include <vector>

namespace rungproof {

struct Worker;

enum class CheckResult : std::uint8_t { Valid, Invalid, Unknown };  ///< Unknown: not within the limits

struct CheckLimits {
  double each = 10;          ///< seconds for the formulas of one owner (a certificate: for each obligation)
  double total = 1e9;        ///< seconds for all
  std::uint64_t memory = 0;  ///< bytes; 0: no limit
  const std::atomic<bool>* cancel = nullptr;
};

/// `text`: declarations, then one assertion: a predicate applied to true and one formula for each element of `owners`,
/// which says whose it is. An owner is Valid if each of its formulas alone is unsatisfiable, Invalid if one is
/// satisfiable.
std::vector<CheckResult> checkApart(const std::string& text, const std::vector<std::size_t>& owners,
                                    std::size_t ownerCount, const CheckLimits& limits);
/// The process of its own.
extern const Worker formulaWorker;

}  // namespace rungproof
