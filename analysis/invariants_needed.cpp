// Which of many invariants a proof rests on, by the cores of its obligations: certificates stay small, and their
// check by another solver quick.
#include <algorithm>

#include "analysis/bit_unrolling.hpp"
#include "analysis/invariants.hpp"

namespace rungproof {

namespace {

class Needed {
 public:
  Needed(const BitSystem& system, const std::vector<std::vector<Lit>>& invariants, const Budget& budget)
      : system_(system), invariants_(invariants), budget_(budget), steps_(system, Unrolling::Start::Any), sat_(Sat::Use::Many),
        cnf_(steps_.graph(), sat_), isNeeded_(invariants.size(), false) {
    constrain(0);
    assume(0);
  }

  void constrain(int frame) {
    for (const Lit constraint : system_.constraints) sat_.add({cnf_.literal(steps_.at(frame, constraint))});
  }
  /// Switches for the invariants, which hold in that scan's state if switched on.
  void assume(int frame) {
    for (std::size_t i = 0; i < invariants_.size(); ++i) {
      if (switches_.size() <= i) switches_.push_back(sat_.newVariable());
      std::vector<int> clause{-switches_[i]};
      for (const Lit l : invariants_[i]) clause.push_back(cnf_.literal(steps_.at(frame, l)));
      sat_.add(clause);
    }
  }
  void addClause(int frame, const std::vector<Lit>& clause) {
    std::vector<int> literals;
    for (const Lit l : clause) literals.push_back(cnf_.literal(steps_.at(frame, l)));
    sat_.add(literals);
  }
  int literal(int frame, Lit l) { return cnf_.literal(steps_.at(frame, l)); }

  /// Marks the invariants that make `denied` impossible, in addition to those that are marked already; false if they do
  /// not, or not in time.
  bool require(const std::vector<int>& denied) {
    std::vector<std::size_t> candidates;
    for (std::size_t i = 0; i < switches_.size(); ++i) {
      if (isNeeded_[i]) candidates.push_back(i);
    }
    const Sat::Outcome marked = solve(denied, candidates);
    if (marked == Sat::Outcome::Unknown) return false;
    if (marked == Sat::Outcome::Unsatisfiable) return true;
    candidates.clear();
    for (std::size_t i = 0; i < switches_.size(); ++i) candidates.push_back(i);
    for (int round = 0; round < coreRounds; ++round) {
      if (solve(denied, candidates) != Sat::Outcome::Unsatisfiable) return false;
      const std::size_t before = candidates.size();
      std::erase_if(candidates, [&](std::size_t i) { return !isNeeded_[i] && !sat_.failed(switches_[i]); });
      if (candidates.size() == before) break;
      // The last ones are tried to be left out first: the solver takes assumptions in their order.
      std::stable_partition(candidates.begin(), candidates.end(), [&](std::size_t i) { return isNeeded_[i]; });
      std::reverse(std::find_if(candidates.begin(), candidates.end(), [&](std::size_t i) { return !isNeeded_[i]; }), candidates.end());
    }
    for (const std::size_t i : candidates) {
      if (isNeeded_[i]) continue;
      isNeeded_[i] = true;
      open_.push_back(i);
    }
    return true;
  }
  bool requireAfterScan(const std::vector<Lit>& clause) {
    std::vector<int> denied;
    for (const Lit l : clause) denied.push_back(-literal(1, l));
    return require(denied);
  }
  bool close() {
    while (!open_.empty()) {
      const std::size_t i = open_.back();
      open_.pop_back();
      if (!requireAfterScan(invariants_[i])) return false;
    }
    return true;
  }
  std::vector<std::vector<Lit>> result() const {
    std::vector<std::vector<Lit>> kept;
    for (std::size_t i = 0; i < invariants_.size(); ++i) {
      if (isNeeded_[i]) kept.push_back(invariants_[i]);
    }
    return kept;
  }

 private:
  static constexpr int coreRounds = 4;

  Sat::Outcome solve(const std::vector<int>& denied, const std::vector<std::size_t>& candidates) {
    std::vector<int> assumptions = denied;
    for (const std::size_t i : candidates) assumptions.push_back(switches_[i]);
    return sat_.solve(assumptions, budget_);
  }

  const BitSystem& system_;
  const std::vector<std::vector<Lit>>& invariants_;
  const Budget& budget_;
  Unrolling steps_;
  Sat sat_;
  BitCnf cnf_;
  std::vector<int> switches_;
  std::vector<bool> isNeeded_;
  std::vector<std::size_t> open_;
};

}  // namespace

std::vector<std::vector<Lit>> neededInvariants(const BitSystem& system, Lit bad, const std::vector<std::vector<Lit>>& invariants,
                                               const Certificate& certificate, const Budget& budget) {
  if (invariants.empty() || certificate.simplePath || !certificate.gates.empty()) return invariants;
  {
    Needed path(system, invariants, budget);
    bool done = true;
    if (certificate.k > 0) {
      // The step case: invariants in every scan.
      std::vector<int> denied{path.literal(certificate.k, bad)};
      for (int frame = 1; frame <= certificate.k; ++frame) {
        path.constrain(frame);
        path.assume(frame);
      }
      for (int frame = 0; frame < certificate.k; ++frame) denied.push_back(-path.literal(frame, bad));
      done = path.require(denied);
    } else {
      for (const std::vector<Lit>& clause : certificate.clauses) path.addClause(0, clause);
      done = path.require({path.literal(0, bad)});
      for (const std::vector<Lit>& clause : certificate.clauses) done = done && path.requireAfterScan(clause);
    }
    if (!done) return invariants;
    const std::vector<std::vector<Lit>> first = path.result();
    if (first.empty()) return first;
    // Closing under induction: each needed invariant is kept by a scan from states that satisfy needed ones.
    Needed closure(system, invariants, budget);
    for (const std::vector<Lit>& clause : first) {
      if (!closure.requireAfterScan(clause)) return invariants;
    }
    if (!closure.close()) return invariants;
    std::vector<std::vector<Lit>> result = closure.result();
    for (const std::vector<Lit>& clause : first) {
      if (std::find(result.begin(), result.end(), clause) == result.end()) result.push_back(clause);
    }
    return result;
  }
}

}  // namespace rungproof
