// The search of bounded model checking, shared by its engine and by the base case of k-induction.
// Tested by tests/solver/engine_agreement_test.cpp.
#pragma once

#include "analysis/bits/bit_unrolling.hpp"

namespace rungproof {

/// Unrolls scan by scan from the initial states and asks one incremental SAT solver whether bad can be true in the
/// newest scan: finds shortest violations.
class BmcSearch {
 public:
  explicit BmcSearch(const BitSystem& system)
      : system_(system),
        unrolling_(system, Unrolling::Start::Initial),
        sat_(Sat::Use::Few),
        cnf_(unrolling_.graph(), sat_) {}

  /// Looks for a violation in the first `scans` scans. Unknown with the number of scans that are free of bad:
  /// less than `scans` when the budget was used up.
  Verdict search(int scans, const Budget& budget);
  int depth() const { return depth_; }

 private:
  void open();

  const BitSystem& system_;
  Unrolling unrolling_;
  Sat sat_;
  BitCnf cnf_;
  int depth_ = 0;
  bool opened_ = false;  ///< scan depth_ has its constraints and bad_
  Lit bad_ = falseLit;
};

}  // namespace rungproof
