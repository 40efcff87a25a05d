// Which of many invariants a proof rests on, by the cores of its obligations: certificates stay small, and their
// check by another solver quick.
#include <algorithm>

#include "analysis/bits/bit_unrolling.hpp"
#include "analysis/portfolio/invariants.hpp"
#include "analysis/schedule/schedule.hpp"

namespace rungproof {

class InvariantCores::Question {
 public:
  Question(const BitSystem& system, const Clauses& invariants, const Budget& budget)
      : system_(system),
        invariants_(invariants),
        budget_(budget),
        steps_(system, Unrolling::Start::Any),
        sat_(Sat::Use::Many),
        cnf_(steps_.graph(), sat_),
        isPreferred_(invariants.size(), false) {
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
    followGuide(system_, steps_, frame, sat_, cnf_, switches_, budget_);
  }
  void addClause(int frame, const std::vector<Lit>& clause) {
    std::vector<int> literals;
    for (const Lit l : clause) literals.push_back(cnf_.literal(steps_.at(frame, l)));
    sat_.add(literals);
  }
  int literal(int frame, Lit l) { return cnf_.literal(steps_.at(frame, l)); }

  /// Invariants that make `denied` impossible, preferably such as are in use already; nothing if they do not, or not in
  /// time.
  std::optional<std::vector<std::size_t>> core(const std::vector<int>& denied, const Budget& budget) {
    std::vector<std::size_t> candidates;
    for (std::size_t i = 0; i < switches_.size(); ++i) {
      if (isPreferred_[i]) candidates.push_back(i);
    }
    Sat::Outcome outcome = candidates.empty() ? Sat::Outcome::Satisfiable : solve(denied, candidates, budget);
    if (outcome == Sat::Outcome::Satisfiable) {
      for (std::size_t i = 0; i < switches_.size(); ++i) {
        if (!isPreferred_[i]) candidates.push_back(i);
      }
      outcome = solve(denied, candidates, budget);
    }
    if (outcome != Sat::Outcome::Unsatisfiable) return std::nullopt;
    for (int round = 0; round < schedule::coreRounds; ++round) {
      const std::size_t before = candidates.size();
      std::erase_if(candidates, [&](std::size_t i) { return !sat_.failed(switches_[i]); });
      if (candidates.size() == before || round + 1 == schedule::coreRounds) break;
      // The solver takes assumptions in their order: in the next round the last ones come first.
      std::reverse(candidates.begin(), candidates.end());
      std::stable_partition(candidates.begin(), candidates.end(), [&](std::size_t i) { return isPreferred_[i]; });
      if (solve(denied, candidates, budget) != Sat::Outcome::Unsatisfiable) return std::nullopt;
    }
    for (const std::size_t i : candidates) isPreferred_[i] = true;
    return candidates;
  }
  std::optional<std::vector<std::size_t>> coreAfterScan(const std::vector<Lit>& clause, const Budget& budget) {
    std::vector<int> denied;
    for (const Lit l : clause) denied.push_back(-literal(1, l));
    return core(denied, budget);
  }

 private:
  Sat::Outcome solve(const std::vector<int>& denied, const std::vector<std::size_t>& candidates, const Budget& budget) {
    std::vector<int> assumptions = denied;
    for (const std::size_t i : candidates) assumptions.push_back(switches_[i]);
    return sat_.solve(assumptions, budget);
  }

  const BitSystem& system_;
  const Clauses& invariants_;
  const Budget budget_;  ///< for what is learned beforehand
  Unrolling steps_;
  Sat sat_;
  BitCnf cnf_;
  std::vector<int> switches_;
  std::vector<bool> isPreferred_;  ///< taken by an earlier core
};

InvariantCores::InvariantCores(const BitSystem& system, const Clauses& invariants)
    : system_(system), invariants_(invariants), rests_(invariants.size()) {}
InvariantCores::~InvariantCores() = default;

InvariantCores::Needed InvariantCores::of(Lit bad, const Certificate& certificate, const Budget& budget) {
  const Needed all{invariants_, invariants_};
  if (invariants_.empty() || certificate.simplePath || !certificate.gates.empty()) return all;
  std::vector<bool> isImmediate(invariants_.size(), false);
  std::vector<std::size_t> open;
  const auto take = [&](const std::optional<std::vector<std::size_t>>& core) {
    if (!core) return false;
    for (const std::size_t i : *core) {
      if (!isImmediate[i]) open.push_back(i);
      isImmediate[i] = true;
    }
    return true;
  };
  if (!closure_) closure_ = std::make_unique<Question>(system_, invariants_, budget);
  if (certificate.k > 0) {
    // The step case: invariants in every scan.
    Question path(system_, invariants_, budget);
    std::vector<int> denied{path.literal(certificate.k, bad)};
    for (int frame = 1; frame <= certificate.k; ++frame) {
      path.constrain(frame);
      path.assume(frame);
    }
    for (int frame = 0; frame < certificate.k; ++frame) denied.push_back(-path.literal(frame, bad));
    if (!take(path.core(denied, budget))) return all;
  } else if (certificate.clauses.empty()) {
    if (!take(closure_->core({closure_->literal(0, bad)}, budget))) return all;
  } else {
    Question path(system_, invariants_, budget);
    for (const std::vector<Lit>& clause : certificate.clauses) path.addClause(0, clause);
    if (!take(path.core({path.literal(0, bad)}, budget))) return all;
    for (const std::vector<Lit>& clause : certificate.clauses) {
      if (!take(path.coreAfterScan(clause, budget))) return all;
    }
  }
  // Closing under induction: each needed invariant is kept by a scan from states that satisfy needed ones.
  std::vector<bool> isNeeded = isImmediate;
  std::size_t count = open.size();
  while (!open.empty() && !isDense_) {
    const std::size_t i = open.back();
    open.pop_back();
    if (!rests_[i]) rests_[i] = closure_->coreAfterScan(invariants_[i], budget);
    if (!rests_[i]) return all;
    for (const std::size_t other : *rests_[i]) {
      if (isNeeded[other]) continue;
      open.push_back(other);
      isNeeded[other] = true;
      isDense_ = isDense_ || ++count > schedule::closureLimit;
    }
  }
  if (isDense_) isNeeded.assign(invariants_.size(), true);
  Needed result;
  for (std::size_t i = 0; i < invariants_.size(); ++i) {
    if (isNeeded[i]) result.clauses.push_back(invariants_[i]);
    if (isImmediate[i]) result.immediate.push_back(invariants_[i]);
  }
  return result;
}

}  // namespace rungproof
