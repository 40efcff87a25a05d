// A group is sought of which exactly one bit is on in every state seen: a state without one of them asks for one more
// that excludes all the others. The states come from random runs, then from scans that leave a group that was tried.
#include "analysis/portfolio/invariants_covers.hpp"

#include <algorithm>
#include <set>

#include "analysis/bits/bit_unrolling.hpp"
#include "analysis/bits/simulation_runs.hpp"
#include "analysis/schedule/schedule.hpp"

namespace rungproof {

namespace {

class CoverSearch {
 public:
  CoverSearch(const BitSystem& system, const Invariants& known, const std::vector<std::size_t>& asked,
              std::uint64_t seed, const Budget& budget)
      : system_(system),
        known_(known),
        budget_(budget),
        steps_(system, Unrolling::Start::Any),
        cnf_(steps_.graph(), sat_) {
    collect();
    if (members() > 1) addHeads(asked);
    sample(seed);
  }

  std::vector<std::vector<Lit>> run() {
    std::vector<std::vector<Lit>> covers;
    if (candidates_.size() < schedule::leastCovers || candidates_.size() > schedule::mostCovers) return covers;
    prepare();
    for (std::size_t first = 0; first < candidates_.size(); ++first) {
      if (!isInitial_[first]) continue;
      for (int group = 0; group < schedule::coverGroups; ++group) {
        members_ = {first};
        if (!extend()) break;
        const Sat::Outcome outcome = leave();
        if (outcome == Sat::Outcome::Unknown) return covers;
        if (outcome == Sat::Outcome::Satisfiable) continue;
        std::vector<Lit>& cover = covers.emplace_back();
        for (const std::size_t m : members_) cover.push_back(candidates_[m]);
        break;
      }
    }
    return covers;
  }

 private:
  /// Latches that exclude some other one.
  void collect() {
    std::set<std::pair<Lit, Lit>> apart;
    for (const std::vector<Lit>& clause : known_.clauses) {
      if (clause.size() != 2 || !isNegative(clause[0]) || !isNegative(clause[1])) continue;
      apart.emplace(negate(clause[0]), negate(clause[1]));
      apart.emplace(negate(clause[1]), negate(clause[0]));
    }
    for (std::size_t i = 0; i < system_.latches.size(); ++i) {
      const Lit l = positive(system_.latches[i].variable);
      const auto pair = apart.lower_bound({l, 0});
      if (pair == apart.end() || pair->first != l) continue;
      candidates_.push_back(l);
      latches_.push_back(i);
      isInitial_.push_back(system_.latches[i].init == LatchInit::One);
    }
    for (const Lit a : candidates_) {
      std::vector<bool>& row = apart_.emplace_back();
      for (const Lit b : candidates_) row.push_back(apart.contains({a, b}));
    }
  }

  std::size_t members() const { return apart_.size(); }

  /// "Not l" for latches that are off at the start: while l is on, one of the others is. They exclude nothing.
  void addHeads(const std::vector<std::size_t>& asked) {
    for (const std::size_t latch : asked) {
      if (system_.latches[latch].init != LatchInit::Zero) continue;
      candidates_.push_back(negate(positive(system_.latches[latch].variable)));
      latches_.push_back(latch);
      isInitial_.push_back(true);
    }
  }

  bool areApart(std::size_t member, std::size_t other) const {
    return member >= members() ? latches_[member] != latches_[other] : apart_[member][other];
  }

  void sample(std::uint64_t seed) {
    SimulationRuns runs(system_, seed);
    std::set<std::vector<bool>> seen;
    for (int scan = 0; scan < schedule::coverScans && !budget_.isExhausted() && runs.choose(); ++scan) {
      for (std::size_t lane = 0; lane < 64; ++lane) {
        if ((runs.live() >> lane & 1U) == 0) continue;
        std::vector<bool> state;
        for (std::size_t c = 0; c < latches_.size(); ++c)
          state.push_back(((runs.simulator().latch(latches_[c]) >> lane & 1U) != 0) != isNegative(candidates_[c]));
        if (seen.insert(state).second) states_.push_back(std::move(state));
      }
      runs.step();
    }
  }

  void prepare() {
    for (const Lit constraint : system_.constraints) sat_.add({cnf_.literal(steps_.at(0, constraint))});
    for (const std::vector<Lit>& clause : known_.clauses) {
      std::vector<int> literals;
      for (const Lit l : clause) literals.push_back(cnf_.literal(steps_.at(0, l)));
      sat_.add(literals);
    }
    for (const Lit l : candidates_) cnf_.literal(steps_.at(1, l));
  }

  bool isOneOn(const std::vector<bool>& state) const {
    return std::any_of(members_.begin(), members_.end(), [&](std::size_t m) { return state[m]; });
  }
  /// Adds members until each state seen has one; false if there are none that do it.
  bool extend() {
    const auto open =
        std::find_if(states_.begin(), states_.end(), [&](const std::vector<bool>& state) { return !isOneOn(state); });
    if (open == states_.end()) return true;
    for (std::size_t c = 0; c < members(); ++c) {
      if (!(*open)[c] || ++trials_ > schedule::coverTrials) continue;
      if (!std::all_of(members_.begin(), members_.end(), [&](std::size_t m) { return areApart(m, c); })) continue;
      members_.push_back(c);
      if (extend()) return true;
      members_.pop_back();
    }
    return false;
  }

  /// Can a scan begin with a member on and end with none? Where it ends is a state seen.
  Sat::Outcome leave() {
    const int isCovered = sat_.newVariable();
    std::vector<int> before{-isCovered}, assumed{isCovered};
    for (const std::size_t m : members_) {
      before.push_back(cnf_.literal(steps_.at(0, candidates_[m])));
      assumed.push_back(-cnf_.literal(steps_.at(1, candidates_[m])));
    }
    sat_.add(before);
    const Sat::Outcome outcome = sat_.solve(assumed, budget_);
    if (outcome == Sat::Outcome::Satisfiable) {
      std::vector<bool>& state = states_.emplace_back();
      for (const Lit l : candidates_) {
        const Lit after = steps_.at(1, l);
        state.push_back(after == trueLit || (after != falseLit && cnf_.value(after)));
      }
    }
    return outcome;
  }

  const BitSystem& system_;
  const Invariants& known_;
  const Budget& budget_;
  Unrolling steps_;
  Sat sat_{Sat::Use::Many};
  BitCnf cnf_;
  std::vector<Lit> candidates_;       ///< literals of latches
  std::vector<std::size_t> latches_;  ///< their indices
  std::vector<bool> isInitial_;       ///< on at the start
  std::vector<std::vector<bool>> apart_;
  std::vector<std::vector<bool>> states_;  ///< by candidate
  std::vector<std::size_t> members_;       ///< of the group at hand
  int trials_ = 0;
};

}  // namespace

std::vector<std::vector<Lit>> mineCovers(const BitSystem& system, const Invariants& known,
                                         const std::vector<std::size_t>& asked, std::uint64_t seed,
                                         const Budget& budget) {
  return CoverSearch(system, known, asked, seed, budget).run();
}

}  // namespace rungproof
