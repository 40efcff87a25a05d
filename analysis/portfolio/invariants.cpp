// Houdini over equivalence classes and pairs. A counterexample to induction drops what its successor breaks, and so
// do the successors of the same state under 63 other random inputs.
#include "analysis/portfolio/invariants.hpp"

#include <algorithm>
#include <map>
#include <unordered_map>

#include "analysis/bits/bit_unrolling.hpp"
#include "analysis/bits/simulation_runs.hpp"
#include "analysis/schedule/schedule.hpp"
#include "ir/check.hpp"

namespace rungproof {

namespace {

using Signature = std::vector<std::uint64_t>;

/// Literals with equal values in all reachable states, presumably; the first represents the others.
using Class = std::vector<Lit>;

/// At least one of them holds.
using Clause = std::vector<Lit>;

class Miner {
 public:
  Miner(const BitSystem& system, const std::vector<Lit>& truths, const std::vector<Clause>& guesses,
        const MiningOptions& options, const Budget& budget)
      : system_(system),
        truths_(truths),
        options_(options),
        budget_(budget),
        clauses_(guesses),
        steps_(system, Unrolling::Start::Any),
        sat_(Sat::Use::Many),
        cnf_(steps_.graph(), sat_) {}

  Invariants run() {
    for (std::size_t g = 0; g < options_.groups.size(); ++g) {
      for (const Lit l : options_.groups[g]) groupsOf_[l].push_back(g);
    }
    sample();
    makeClasses();
    makePairs();
    if (!holdInitially() || !makeInductive()) return {};
    return result();
  }

 private:
  std::uint64_t sampled(const BitSimulator& simulator, std::uint64_t live, Lit l) const {
    const std::uint64_t value = simulator.value(l);
    if (live == ~0ULL) return value;
    const bool first = (value & (live & -live)) != 0;  // ended runs repeat a live one
    return (value & live) | (first ? ~live : 0);
  }

  void sample() {
    for (const Latch& latch : system_.latches) {
      if (!options_.pairsOnly) watched_.push_back(positive(latch.variable));
    }
    for (const Lit l : truths_) {
      if (options_.pairsOnly || system_.isGate(l)) watched_.push_back(l & ~1U);
    }
    std::sort(watched_.begin(), watched_.end());
    watched_.erase(std::unique(watched_.begin(), watched_.end()), watched_.end());
    signatures_.resize(watched_.size());
    SimulationRuns runs(system_, options_.seed);
    for (int scan = 0; scan < options_.scans && !budget_.isExhausted(); ++scan) {
      if (scan == options_.scans / 2) runs.restart();
      if (!runs.choose())
        runs.restart();
      else {
        for (std::size_t i = 0; i < watched_.size(); ++i)
          signatures_[i].push_back(sampled(runs.simulator(), runs.live(), watched_[i]));
        refine([&](Lit l) { return runs.simulator().value(l); }, runs.live());
        runs.step();
      }
    }
  }

  void makeClasses() {
    if (options_.pairsOnly) {
      makeSingles();
      return;
    }
    std::map<Signature, std::size_t> index;
    classes_.push_back({falseLit});
    index.emplace(Signature(signatures_.empty() ? 0 : signatures_[0].size(), 0), 0);
    for (std::size_t i = 0; i < watched_.size(); ++i) {
      Signature signature = signatures_[i];
      const bool complement = !signature.empty() && (signature[0] & 1U) != 0;
      if (complement) {
        for (std::uint64_t& word : signature) word = ~word;
      }
      const auto [at, isNew] = index.emplace(std::move(signature), classes_.size());
      if (isNew) classes_.emplace_back();
      classes_[at->second].push_back(complement ? negate(watched_[i]) : watched_[i]);
    }
  }

  /// No classes: every watched literal stands for itself.
  void makeSingles() {
    classes_.push_back({falseLit});
    for (std::size_t i = 0; i < watched_.size(); ++i) {
      const bool isUnseen =
          std::all_of(signatures_[i].begin(), signatures_[i].end(), [](std::uint64_t lanes) { return lanes == 0; });
      if (isUnseen)
        unseen_.push_back(watched_[i]);
      else
        classes_.push_back({watched_[i]});
    }
  }

  void makePairs() {
    std::vector<std::size_t> representatives;  // of truths, by index in watched_
    std::vector<bool> isTruth(system_.variableCount(), false);
    for (const Lit l : truths_) isTruth[variableOf(l)] = true;
    for (const Class& c : classes_) {
      if (c[0] == falseLit) continue;
      // All truth values of the state, since what was equal up to now may part; of comparisons one is enough.
      std::size_t taken = 0;
      for (const Lit l : c) {
        if (!isTruth[variableOf(l)] || taken == schedule::ofOneClass || (taken > 0 && system_.isGate(l))) continue;
        representatives.push_back(
            static_cast<std::size_t>(std::lower_bound(watched_.begin(), watched_.end(), l & ~1U) - watched_.begin()));
        ++taken;
      }
    }
    for (std::size_t i = 0; i < representatives.size(); ++i) {
      for (std::size_t j = i + 1; j < representatives.size(); ++j) {
        const Signature& a = signatures_[representatives[i]];
        const Signature& b = signatures_[representatives[j]];
        for (unsigned polarity = 0; polarity < 4; ++polarity) {
          const std::uint64_t flipA = (polarity & 1U) != 0 ? ~0ULL : 0, flipB = (polarity & 2U) != 0 ? ~0ULL : 0;
          bool holds = true;
          for (std::size_t w = 0; w < a.size() && holds; ++w) holds = ((a[w] ^ flipA) | (b[w] ^ flipB)) == ~0ULL;
          if (!holds ||
              isKnown(watched_[representatives[i]] ^ (polarity & 1U), watched_[representatives[j]] ^ (polarity >> 1U)))
            continue;
          clauses_.push_back(
              {watched_[representatives[i]] ^ (polarity & 1U), watched_[representatives[j]] ^ (polarity >> 1U)});
          if (clauses_.size() >= options_.implicationLimit) return;
        }
      }
    }
    makePairsOfUnseen(isTruth, representatives);
    if (!options_.pairsOnly) makePairsByReading(representatives);
  }

  /// A clause of two whose literals are both denied in one group.
  bool isKnown(Lit a, Lit b) const {
    const auto first = groupsOf_.find(negate(a)), second = groupsOf_.find(negate(b));
    if (first == groupsOf_.end() || second == groupsOf_.end()) return false;
    return std::ranges::find_first_of(first->second, second->second) != first->second.end();
  }

  /// Pairs of latches that hold under one value of a latch that keeps any value it starts with, as the readings of open
  /// points do.
  void makePairsByReading(const std::vector<std::size_t>& representatives) {
    std::vector<std::size_t> latches;
    for (const std::size_t r : representatives) {
      if (!system_.isGate(watched_[r])) latches.push_back(r);
    }
    if (latches.size() > schedule::ofReadings) return;
    for (const Latch& latch : system_.latches) {
      const Lit own = positive(latch.variable);
      const auto at = std::lower_bound(watched_.begin(), watched_.end(), own);
      if (latch.init != LatchInit::Free || latch.next != own || at == watched_.end() || *at != own) continue;
      const Signature& reading = signatures_[static_cast<std::size_t>(at - watched_.begin())];
      for (const Lit other : {own, negate(own)}) {
        const std::uint64_t flip = isNegative(other) ? ~0ULL : 0;
        for (std::size_t i = 0; i < latches.size(); ++i) {
          for (std::size_t j = i + 1; j < latches.size(); ++j)
            addPairsUnless(other, flip, reading, latches[i], latches[j]);
        }
      }
    }
  }
  void addPairsUnless(Lit other, std::uint64_t flip, const Signature& reading, std::size_t i, std::size_t j) {
    const Signature &a = signatures_[i], &b = signatures_[j];
    for (unsigned polarity = 0; polarity < 4; ++polarity) {
      const std::uint64_t flipA = (polarity & 1U) != 0 ? ~0ULL : 0, flipB = (polarity & 2U) != 0 ? ~0ULL : 0;
      bool holds = true, holdsAlone = true;
      for (std::size_t w = 0; w < a.size() && holds; ++w) {
        const std::uint64_t either = (a[w] ^ flipA) | (b[w] ^ flipB);
        holds = (either | (reading[w] ^ flip)) == ~0ULL;
        holdsAlone = holdsAlone && either == ~0ULL;
      }
      if (!holds || holdsAlone || clauses_.size() >= options_.implicationLimit) continue;
      clauses_.push_back({other, watched_[i] ^ (polarity & 1U), watched_[j] ^ (polarity >> 1U)});
    }
  }

  /// Truths that no sample shows may still exclude each other, and need or exclude what is seen.
  void makePairsOfUnseen(const std::vector<bool>& isTruth, const std::vector<std::size_t>& seen) {
    std::vector<Lit> unseen = unseen_;
    for (const Lit l : classes_[0]) {
      if (variableOf(l) != 0 && isTruth[variableOf(l)] && unseen.size() < schedule::unseenLimit) unseen.push_back(l);
    }
    const bool isFew = unseen.size() <= schedule::unseenLimit;
    for (std::size_t i = 0; i < unseen.size(); ++i) {
      for (std::size_t j = i + 1; j < unseen.size(); ++j) {
        if (!isKnown(negate(unseen[i]), negate(unseen[j]))) clauses_.push_back({negate(unseen[i]), negate(unseen[j])});
        if (!isFew) continue;
        clauses_.push_back({unseen[i], negate(unseen[j])});
        clauses_.push_back({negate(unseen[i]), unseen[j]});
      }
    }
    for (const Lit l : unseen) {
      for (const std::size_t i : seen) {
        if (clauses_.size() + 2 > options_.implicationLimit) return;
        clauses_.push_back({negate(l), watched_[i]});
        if (!isKnown(negate(l), negate(watched_[i]))) clauses_.push_back({negate(l), negate(watched_[i])});
      }
    }
  }

  Lit same(Unrolling& u, int frame, Lit a, Lit b) { return negate(u.graph().addXor(u.at(frame, a), u.at(frame, b))); }
  Lit some(Unrolling& u, int frame, const Clause& clause) {
    Lit result = falseLit;
    for (const Lit l : clause) result = u.graph().addOr(result, u.at(frame, l));
    return result;
  }

  /// Drops and splits what `value` (64 states at once, those of `lanes` count) contradicts; true if anything.
  template <class Value>
  bool refine(Value&& value, std::uint64_t lanes) {
    bool changed = false;
    for (std::size_t c = 0; c < classes_.size(); ++c) {
      if (classes_[c].size() < 2) continue;
      const std::uint64_t expected = value(classes_[c][0]) & lanes;
      std::map<std::uint64_t, Class> others;
      std::erase_if(classes_[c], [&](Lit l) {
        const std::uint64_t v = value(l) & lanes;
        if (v == expected) return false;
        others[v].push_back(l);
        return true;
      });
      changed = changed || !others.empty();
      for (auto& [v, members] : others) classes_.push_back(std::move(members));
    }
    const auto isBroken = [&](const Clause& clause) {
      std::uint64_t holds = 0;
      for (const Lit l : clause) holds |= value(l);
      return (holds & lanes) != lanes;
    };
    std::size_t kept = 0;
    for (std::size_t i = 0; i < clauses_.size(); ++i) {
      if (isBroken(clauses_[i])) continue;
      if (kept != i) clauses_[kept] = std::move(clauses_[i]);
      if (!blockOf_.empty()) blockOf_[kept] = blockOf_[i];
      ++kept;
    }
    changed = changed || kept != clauses_.size();
    clauses_.resize(kept);
    if (!blockOf_.empty()) blockOf_.resize(kept);
    return changed;
  }

  bool holdInitially() {
    Unrolling start(system_, Unrolling::Start::Initial);
    Sat sat(Sat::Use::Many);
    BitCnf cnf(start.graph(), sat);
    for (;;) {
      std::vector<int> broken;
      const auto candidate = [&](Lit l) {
        if (l != trueLit) broken.push_back(-cnf.literal(l));
      };
      for (const Class& c : classes_) {
        for (std::size_t i = 1; i < c.size(); ++i) candidate(same(start, 0, c[0], c[i]));
      }
      for (const Clause& c : clauses_) candidate(some(start, 0, c));
      if (broken.empty()) return true;
      const Sat::Outcome outcome = sat.solve({}, budget_, broken);
      if (outcome == Sat::Outcome::Unsatisfiable) return true;
      if (outcome == Sat::Outcome::Unknown) return false;
      const auto value = [&](Lit l) { return cnf.value(start.at(0, l)) ? ~0ULL : 0; };
      CHECK(refine(value, 1), "an initial state breaks a candidate");
    }
  }

  /// Candidates are asked for group by group, since the solver is quick to see that no scan breaks a few of them, and
  /// slow to see it of thousands. Done when every group has been asked since the last candidate was dropped.
  bool makeInductive() {
    for (const Lit constraint : system_.constraints) sat_.add({cnf_.literal(steps_.at(0, constraint))});
    for (const Lit known : options_.known) sat_.add({cnf_.literal(steps_.at(0, known))});
    std::mt19937_64 random(options_.seed);
    BitSimulator simulator(system_);
    isConstrained_ = constrainedVariables(system_);
    blockOf_.resize(clauses_.size());
    for (std::size_t i = 0; i < clauses_.size(); ++i) blockOf_[i] = i / schedule::invariantBlock;
    blocks_.resize(clauses_.size() / schedule::invariantBlock + 1);
    for (std::size_t first = 0;;) {
      const std::vector<int> assumed = assumeCandidates();
      const std::vector<Group> groups = candidatesAfterScan();
      std::size_t asked = 0;
      bool isGuided = system_.guide.empty();
      for (Sat::Outcome outcome = Sat::Outcome::Unsatisfiable; asked < groups.size(); ++asked) {
        const Group& group = groups[(first + asked) % groups.size()];
        std::vector<int> assumptions = assumed;
        if (group.denied != 0) assumptions.push_back(group.denied);
        outcome = sat_.solve(assumptions, isGuided ? budget_ : budget_.slice(schedule::unguidedSeconds), group.some);
        if (outcome == Sat::Outcome::Unknown && !isGuided) {
          followGuide(system_, steps_, 0, sat_, cnf_, assumed, budget_);
          for (const int broken : group.some) teach(sat_, -broken, assumptions, budget_);
          isGuided = true;
          outcome = sat_.solve(assumptions, budget_, group.some);
        }
        if (outcome == Sat::Outcome::Unknown) return false;
        if (outcome == Sat::Outcome::Satisfiable) break;
      }
      if (asked == groups.size()) return true;
      first = (first + asked) % groups.size();
      CHECK(dropBroken(simulator, random), "a counterexample breaks a candidate");
    }
  }

  /// Literals that make all candidates true before the scan. Clauses are switched on by the block; a block that has
  /// lost some is added anew.
  std::vector<int> assumeCandidates() {
    std::vector<int> assumed;
    for (const Class& c : classes_) {
      for (std::size_t i = 1; i < c.size(); ++i) {
        const Lit equal = same(steps_, 0, c[0], c[i]);
        if (equal != trueLit) assumed.push_back(cnf_.literal(equal));
      }
    }
    std::vector<std::size_t> left(blocks_.size(), 0);
    for (const std::size_t block : blockOf_) ++left[block];
    std::vector<bool> isStale(blocks_.size(), false);
    for (std::size_t b = 0; b < blocks_.size(); ++b) {
      isStale[b] = blocks_[b].clauses != left[b];
      if (isStale[b]) {
        if (blocks_[b].on != 0) sat_.add({-blocks_[b].on});
        blocks_[b] = {sat_.newVariable(), left[b]};
      }
      if (left[b] > 0) assumed.push_back(blocks_[b].on);
    }
    for (std::size_t i = 0; i < clauses_.size(); ++i) {
      if (!isStale[blockOf_[i]]) continue;
      std::vector<int> literals{-blocks_[blockOf_[i]].on};
      for (const Lit l : clauses_[i]) literals.push_back(cnf_.literal(steps_.at(0, l)));
      sat_.add(literals);
    }
    return assumed;
  }

  /// Candidates that a scan breaks if it makes `denied` (0: none) and one of `some` true.
  struct Group {
    int denied = 0;
    std::vector<int> some;
  };
  std::vector<Group> candidatesAfterScan() {
    std::vector<Group> groups(1);
    const auto alone = [&](Lit after) {
      if (after == trueLit) return;
      groups[0].some.push_back(-cnf_.literal(after));
      sat_.prefer(groups[0].some.back());  // one counterexample should break many
    };
    for (const Class& c : classes_) {
      for (std::size_t i = 1; i < c.size(); ++i) alone(same(steps_, 1, c[0], c[i]));
    }
    std::unordered_map<Lit, std::size_t> pairsOf;  // by the first literal of clauses of two
    for (const Clause& c : clauses_) {
      if (c.size() != 2) {
        alone(some(steps_, 1, c));
        continue;
      }
      const Lit first = steps_.at(1, c[0]), second = steps_.at(1, c[1]);
      if (steps_.graph().addOr(first, second) == trueLit) continue;
      const auto [at, isNew] = pairsOf.emplace(c[0], groups.size());
      if (isNew) groups.push_back({-cnf_.literal(first), {}});
      groups[at->second].some.push_back(-cnf_.literal(second));
      for (const int literal : {groups[at->second].denied, groups[at->second].some.back()}) sat_.prefer(literal);
    }
    if (groups[0].some.empty()) groups.erase(groups.begin());
    return groups;
  }

  /// Drops what the model's scan breaks, and what scans from states nearby break that satisfy all candidates too.
  bool dropBroken(BitSimulator& simulator, std::mt19937_64& random) {
    std::vector<bool> state, inputs;
    for (const Latch& latch : system_.latches) state.push_back(cnf_.value(steps_.at(0, positive(latch.variable))));
    for (const std::uint32_t v : system_.inputs) inputs.push_back(cnf_.value(steps_.at(0, positive(v))));
    bool changed = false;
    for (int batch = 0; batch < schedule::neighbourBatches; ++batch) {
      for (std::size_t i = 0; i < state.size(); ++i) simulator.setLatch(i, state[i] ? ~0ULL : 0);
      for (std::size_t i = 0; i < inputs.size(); ++i)
        simulator.setInput(i, (batch == 0 ? random() & ~1ULL : random()) | (inputs[i] && batch == 0 ? 1U : 0U));
      // Members of a class change together; the first run stays the model itself.
      for (std::size_t c = 1; c < classes_.size(); ++c) {
        std::uint64_t flips = random();
        for (int i = 0; i < batch; ++i) flips &= random();
        if (batch == 0) flips &= ~1ULL;
        for (const Lit l : classes_[c]) {
          if (classes_[c][0] == falseLit || system_.isGate(l)) continue;
          const std::uint32_t latch = system_.position[variableOf(l)];
          simulator.setLatch(latch, simulator.latch(latch) ^ flips);
        }
      }
      simulator.evaluate();
      const std::uint64_t lanes = satisfying(simulator);
      simulator.step();
      simulator.evaluate();
      changed = refine([&](Lit l) { return simulator.value(l); }, lanes) || changed;
    }
    if (!unseen_.empty()) walk(simulator, random, state, inputs);
    return changed;
  }

  /// Scan after scan from `state`, with other words every time: what long waits keep apart (a ring of timers) comes up
  /// at once, and the pairs that it breaks go without a question to the solver. A run that leaves the candidates starts
  /// anew. What the constraints speak of stays as it is, else hardly a run would meet them.
  void walk(BitSimulator& simulator, std::mt19937_64& random, const std::vector<bool>& state,
            const std::vector<bool>& inputs) {
    std::vector<bool> isTruth(system_.variableCount(), false);
    for (const Lit l : watched_) isTruth[variableOf(l)] = true;
    std::uint64_t lanes = 0;
    for (int idle = 0; idle < schedule::walkPatience && !budget_.isExhausted(); ++idle) {
      for (std::size_t i = 0; i < state.size(); ++i) {
        const std::uint32_t v = system_.latches[i].variable;
        const std::uint64_t start = state[i] ? ~0ULL : 0;
        simulator.setLatch(i, isTruth[v]          ? (simulator.latch(i) & lanes) | (start & ~lanes)
                              : isConstrained_[v] ? start
                                                  : random());
      }
      for (std::size_t i = 0; i < inputs.size(); ++i)
        simulator.setInput(i, !isConstrained_[system_.inputs[i]] ? random() : inputs[i] ? ~0ULL : 0);
      simulator.evaluate();
      lanes = satisfying(simulator);
      simulator.step();
      simulator.evaluate();
      if (refine([&](Lit l) { return simulator.value(l); }, lanes)) idle = 0;
    }
  }

  /// Runs whose state satisfies all candidates and whose inputs meet the constraints.
  std::uint64_t satisfying(const BitSimulator& simulator) const {
    std::uint64_t lanes = ~0ULL;
    for (const Lit constraint : system_.constraints) lanes &= simulator.value(constraint);
    for (const Lit known : options_.known) lanes &= simulator.value(known);
    for (const Class& c : classes_) {
      for (std::size_t i = 1; i < c.size(); ++i) lanes &= ~(simulator.value(c[0]) ^ simulator.value(c[i]));
    }
    for (const Clause& clause : clauses_) {
      std::uint64_t holds = 0;
      for (const Lit l : clause) holds |= simulator.value(l);
      lanes &= holds;
    }
    return lanes;
  }

  Invariants result() const {
    Invariants invariants;
    for (std::uint32_t v = 0; v < system_.variableCount(); ++v) invariants.equal.push_back(positive(v));
    for (Class c : classes_) {
      // A latch represents latches; gates are tied to it by clauses only.
      const auto byKind = [&](Lit l) { return std::pair(system_.isGate(l), l); };
      if (c[0] != falseLit) std::sort(c.begin(), c.end(), [&](Lit a, Lit b) { return byKind(a) < byKind(b); });
      for (std::size_t i = 1; i < c.size(); ++i) {
        if (!system_.isGate(c[i])) invariants.equal[variableOf(c[i])] = c[0] ^ (c[i] & 1U);
        if (c[0] == falseLit) {
          invariants.clauses.push_back({negate(c[i])});
        } else {
          invariants.clauses.push_back({negate(c[0]), c[i]});
          invariants.clauses.push_back({c[0], negate(c[i])});
        }
      }
    }
    invariants.clauses.insert(invariants.clauses.end(), clauses_.begin(), clauses_.end());
    for (const Lit known : options_.known) invariants.clauses.push_back({known});
    return invariants;
  }

  const BitSystem& system_;
  const std::vector<Lit>& truths_;
  const MiningOptions options_;
  const Budget& budget_;
  std::vector<Lit> watched_;  ///< positive literals
  std::vector<Signature> signatures_;
  std::vector<Class> classes_;
  std::vector<Lit> unseen_;  ///< pairs only: truths that are 0 in all samples
  std::vector<Clause> clauses_;
  std::unordered_map<Lit, std::vector<std::size_t>> groupsOf_;  ///< by literal: indices in MiningOptions::groups
  struct Block {
    int on = 0;               ///< switch of the clauses that were added last
    std::size_t clauses = 0;  ///< how many these are
  };
  std::vector<Block> blocks_;
  std::vector<std::size_t> blockOf_;  ///< by clause
  std::vector<bool> isConstrained_;   ///< by variable
  Unrolling steps_;
  Sat sat_;
  BitCnf cnf_;
};

}  // namespace

Invariants mineInvariants(const BitSystem& system, const std::vector<Lit>& truths,
                          const std::vector<std::vector<Lit>>& guesses, const MiningOptions& options,
                          const Budget& budget) {
  return Miner(system, truths, guesses, options, budget).run();
}

}  // namespace rungproof
