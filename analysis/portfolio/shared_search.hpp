// The part of the portfolio that treats all questions together: a few hundred simulated scans, then induction with
// k = 0 .. 3 over two unrollings that all questions share. Most questions about programs end here, within
// milliseconds. Tested by tests/solver/portfolio_test.cpp.
#pragma once

#include <memory>
#include <vector>

#include "analysis/bits/bit_unrolling.hpp"

namespace rungproof {

/// What is known about one question; bad literal i of the system is question i.
struct SharedAnswer {
  Verdict verdict;
  bool open() const { return verdict.answer == Answer::Unknown; }
};

class SharedSearch {
 public:
  /// `cleanScans`, by question: bad is known to be unreachable in that many first scans.
  SharedSearch(const BitSystem& system, std::uint64_t seed, std::vector<int> cleanScans);

  const std::vector<SharedAnswer>& answers() const { return answers_; }
  std::size_t openCount() const;
  /// Looks for violations on 64 random runs of `scans` scans.
  void simulate(int scans, const Budget& budget);
  /// k-induction for k = 0 .. most, under invariants that hold in all reachable states.
  void induce(int most, const std::vector<std::vector<Lit>>& invariants, const Budget& budget);

 private:
  void extendBase(int depth, const Budget& budget);
  const BitSystem& system_;
  std::uint64_t seed_;
  std::vector<SharedAnswer> answers_;
  Unrolling base_;
  Sat baseSat_;
  BitCnf baseCnf_;
  int baseFrames_ = 0;           ///< frames of base_ with constraints
  std::vector<int> cleanScans_;  ///< by question: bad is unreachable in that many first scans
};

}  // namespace rungproof
