// Invariants mined from samples: latches that are constant, equal or complementary (signal correspondence), and
// clauses of two literals between truth values (implications, one-hot groups, timer bit and comparison). Candidates
// come from random runs; those that a scan from a state satisfying all of them can break are dropped until the rest
// is inductive together. Used to merge latches and as lemmas of the engines.
// Tested by tests/solver/invariants_test.cpp.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "analysis/bits/bit_cone.hpp"
#include "analysis/portfolio/invariants_groups.hpp"
#include "analysis/schedule/schedule.hpp"

namespace rungproof {

struct Invariants {
  EqualLiterals equal;  ///< by variable; latches that equal another latch or a constant
  /// All that was proved, as clauses over latches and gates over latches; includes the equalities.
  std::vector<std::vector<Lit>> clauses;
  bool empty() const { return clauses.empty(); }
};

struct MiningOptions {
  std::uint64_t seed = 1;
  int scans = 192;                                            ///< sampled on 64 runs
  std::size_t implicationLimit = schedule::implicationLimit;  ///< candidates of two literals
  /// Only clauses of two truths: for merged systems, whose constants and equal latches are known already.
  bool pairsOnly = false;
  std::vector<ExclusiveGroup> groups{};  ///< known: their pairs are not looked for
  std::vector<Lit> known{};              ///< gates over latches, inductive together: they become invariants too
};

/// `truths`: literals over latches between which equalities and implications are looked for, besides the equalities
/// among all latches; `guesses`: further candidates, clauses over latches and gates over latches. When the budget
/// ends, nothing is returned.
Invariants mineInvariants(const BitSystem& system, const std::vector<Lit>& truths,
                          const std::vector<std::vector<Lit>>& guesses, const MiningOptions& options,
                          const Budget& budget);

/// Which of clauses that are inductive together proofs need. Serves many proofs about one system: what one clause rests
/// on is asked once.
class InvariantCores {
 public:
  using Clauses = std::vector<std::vector<Lit>>;

  /// Both must outlive the object; gates may be added to the system.
  InvariantCores(const BitSystem& system, const Clauses& invariants);
  ~InvariantCores();

  struct Needed {
    Clauses clauses;    ///< inductive by themselves
    Clauses immediate;  ///< those of them under which one scan is not bad and keeps the certificate's own clauses
  };
  /// For the proof of `bad`: under `immediate`, the certificate's own clauses are inductive and exclude bad. All
  /// invariants when the budget ends.
  Needed of(Lit bad, const Certificate& certificate, const Budget& budget);

 private:
  class Question;

  const BitSystem& system_;
  const Clauses& invariants_;
  std::unique_ptr<Question> closure_;                           ///< one scan under invariants; made when first needed
  std::vector<std::optional<std::vector<std::size_t>>> rests_;  ///< by invariant: those that a scan needs to keep it
  bool isDense_ = false;                                        ///< too many rest on each other to be told apart
};

}  // namespace rungproof
