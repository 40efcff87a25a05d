// Houdini over a table of pairs that may exclude each other, which is told to the solver as groups of it: first those
// pairs go that are seen together in runs, then those that one scan brings together from states that keep all groups.
// Such states are drawn at random, many at once; only when they show nothing more is the solver asked.
#include "analysis/portfolio/invariants_groups.hpp"

#include <algorithm>
#include <bit>
#include <numeric>
#include <random>

#include "analysis/bits/bit_cone.hpp"
#include "analysis/bits/bit_unrolling.hpp"
#include "analysis/bits/simulation_runs.hpp"
#include "analysis/schedule/schedule.hpp"
#include "ir/check.hpp"

namespace rungproof {

namespace {

/// A set of truths, by index.
class TruthSet {
 public:
  explicit TruthSet(std::size_t size, bool isFull = false) : words_((size + 63) / 64, isFull ? ~0ULL : 0) {
    if (isFull && size % 64 != 0) words_.back() = (1ULL << size % 64) - 1;
  }
  bool has(std::size_t i) const { return (words_[i / 64] >> i % 64 & 1U) != 0; }
  void add(std::size_t i) { words_[i / 64] |= 1ULL << i % 64; }
  void remove(std::size_t i) { words_[i / 64] &= ~(1ULL << i % 64); }
  void keep(const TruthSet& other) {
    for (std::size_t w = 0; w < words_.size(); ++w) words_[w] &= other.words_[w];
  }
  bool contains(const TruthSet& other) const {
    for (std::size_t w = 0; w < words_.size(); ++w) {
      if ((other.words_[w] & ~words_[w]) != 0) return false;
    }
    return true;
  }
  std::size_t count() const {
    return std::accumulate(words_.begin(), words_.end(), std::size_t{0}, [](std::size_t sum, std::uint64_t word) {
      return sum + static_cast<std::size_t>(std::popcount(word));
    });
  }
  std::size_t commonWith(const TruthSet& other) const {
    std::size_t sum = 0;
    for (std::size_t w = 0; w < words_.size(); ++w)
      sum += static_cast<std::size_t>(std::popcount(words_[w] & other.words_[w]));
    return sum;
  }

 private:
  std::vector<std::uint64_t> words_;
};

class GroupMiner {
 public:
  GroupMiner(const BitSystem& system, const std::vector<Lit>& truths, std::uint64_t seed, const Budget& budget)
      : system_(system),
        budget_(budget),
        runs_(system, seed),
        random_(seed),
        steps_(system, Unrolling::Start::Any),
        isConstrained_(constrainedVariables(system)) {
    for (const Lit l : truths) {
      if (system.latches[system.position[variableOf(l)]].init != LatchInit::Free) truths_.push_back(l);
    }
    apart_.assign(truths_.size(), TruthSet(truths_.size(), true));
    for (std::size_t i = 0; i < truths_.size(); ++i) apart_[i].remove(i);
  }

  std::vector<ExclusiveGroup> run() {
    if (truths_.size() < schedule::leastGroup) return {};
    dropInitial();
    sample();
    for (;;) {
      makeGroups();
      if (groups_.empty()) return {};
      while (!budget_.isExhausted() && dropBroken(false)) makeGroups();
      if (groups_.empty() || budget_.isExhausted()) return {};
      const Sat::Outcome outcome = breakGroups();
      if (outcome == Sat::Outcome::Unknown) return {};
      if (outcome == Sat::Outcome::Unsatisfiable) return result();
      CHECK(dropBroken(true), "a counterexample breaks a group");
    }
  }

 private:
  void part(std::size_t i, std::size_t j) {
    apart_[i].remove(j);
    apart_[j].remove(i);
  }
  bool startsOn(std::size_t i) const {
    const bool isOne = system_.latches[system_.position[variableOf(truths_[i])]].init == LatchInit::One;
    return isOne != isNegative(truths_[i]);
  }
  void dropInitial() {
    for (std::size_t i = 0; i < truths_.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        if (startsOn(i) && startsOn(j)) part(i, j);
      }
    }
  }

  /// Drops pairs that are on together in one of these runs; true if there are any.
  bool dropSeen(const BitSimulator& simulator, std::uint64_t lanes) {
    std::vector<std::pair<std::size_t, std::uint64_t>> on;
    bool isChanged = false;
    for (std::size_t i = 0; i < truths_.size(); ++i) {
      const std::uint64_t value = simulator.value(truths_[i]) & lanes;
      if (value == 0) continue;
      for (const auto& [j, other] : on) {
        if ((value & other) == 0 || !apart_[i].has(j)) continue;
        part(i, j);
        isChanged = true;
      }
      on.emplace_back(i, value);
    }
    return isChanged;
  }

  void sample() {
    for (int scan = 0; scan < schedule::groupScans && !budget_.isExhausted() && runs_.choose(); ++scan) {
      dropSeen(runs_.simulator(), runs_.live());
      keepBase(runs_.simulator());
      runs_.step();
    }
  }
  void keepBase(const BitSimulator& simulator) {
    state_.clear();
    inputs_.clear();
    for (std::size_t i = 0; i < system_.latches.size(); ++i) state_.push_back(simulator.latch(i));
    for (std::size_t i = 0; i < system_.inputs.size(); ++i) inputs_.push_back(simulator.input(i));
  }

  /// From each truth the largest group that is found by always taking the one that leaves most others; groups within
  /// others say nothing more.
  void makeGroups() {
    groups_.clear();
    std::vector<TruthSet> sets;
    TruthSet isGrouped(truths_.size());
    for (std::size_t first = 0; first < truths_.size() && groups_.size() < schedule::mostGroups; ++first) {
      if (isGrouped.has(first) || apart_[first].count() + 1 < schedule::leastGroup) continue;
      TruthSet open = apart_[first], set(truths_.size());
      std::vector<std::size_t> members{first};
      set.add(first);
      for (std::size_t left = open.count(); left > 0; left = open.count()) {
        std::size_t best = 0, most = 0;
        for (std::size_t i = 0; i < truths_.size(); ++i) {
          if (!open.has(i)) continue;
          const std::size_t common = open.commonWith(apart_[i]) + 1;
          if (common > most) best = i, most = common;
          if (common == left) break;
        }
        members.push_back(best);
        set.add(best);
        open.keep(apart_[best]);
      }
      if (members.size() < schedule::leastGroup) continue;
      if (std::ranges::any_of(sets, [&](const TruthSet& other) { return other.contains(set); })) continue;
      std::ranges::sort(members);
      for (const std::size_t m : members) isGrouped.add(m);
      groups_.push_back(std::move(members));
      sets.push_back(std::move(set));
    }
  }

  /// One scan from states that keep all groups: the solver's, and others near it or near a run. Drops what comes
  /// together; true if there is anything.
  bool dropBroken(bool isModel) {
    BitSimulator simulator(system_);
    bool isChanged = false;
    for (int round = 0; round < schedule::groupRounds; ++round) {
      for (std::size_t i = 0; i < state_.size(); ++i) {
        const bool isFree = !isConstrained_[system_.latches[i].variable] && (random_() & 1U) != 0;
        simulator.setLatch(i, isFree ? random_() : state_[i]);
      }
      drawTruths(simulator);
      for (std::size_t i = 0; i < inputs_.size(); ++i)
        simulator.setInput(i, isConstrained_[system_.inputs[i]] ? inputs_[i] : random_());
      if (isModel && round == 0) {
        for (std::size_t i = 0; i < state_.size(); ++i) simulator.setLatch(i, state_[i]);
        for (std::size_t i = 0; i < inputs_.size(); ++i) simulator.setInput(i, inputs_[i]);
      }
      simulator.evaluate();
      std::uint64_t lanes = ~0ULL;
      for (const Lit constraint : system_.constraints) lanes &= simulator.value(constraint);
      for (const std::vector<std::size_t>& group : groups_) lanes &= atMostOneOf(simulator, group);
      simulator.step();
      if (lanes != 0 && dropSeen(simulator, lanes)) isChanged = true;
    }
    return isChanged;
  }

  /// In each run as many truths of groups as go together, or fewer.
  void drawTruths(BitSimulator& simulator) {
    std::vector<std::size_t> order;
    TruthSet isGrouped(truths_.size());
    for (const std::vector<std::size_t>& group : groups_) {
      for (const std::size_t i : group) {
        if (!isGrouped.has(i)) order.push_back(i);
        isGrouped.add(i);
      }
    }
    std::vector<std::uint64_t> on(truths_.size(), 0);
    for (std::size_t lane = 0; lane < 64; ++lane) {
      std::ranges::shuffle(order, random_);
      TruthSet open = isGrouped;
      for (const std::size_t i : order) {
        if (!open.has(i) || (lane % 4 == 3 && (random_() & 1U) != 0)) continue;
        on[i] |= 1ULL << lane;
        open.keep(apart_[i]);
      }
    }
    for (const std::size_t i : order)
      simulator.setLatch(system_.position[variableOf(truths_[i])], on[i] ^ (isNegative(truths_[i]) ? ~0ULL : 0));
  }

  std::uint64_t atMostOneOf(const BitSimulator& simulator, const std::vector<std::size_t>& group) const {
    std::uint64_t some = 0, several = 0;
    for (const std::size_t i : group) {
      const std::uint64_t value = simulator.value(truths_[i]);
      several |= some & value;
      some |= value;
    }
    return ~several;
  }

  /// A scan from a state that keeps all groups to one that breaks one of them.
  Sat::Outcome breakGroups() {
    Sat sat(Sat::Use::Many);
    BitCnf cnf(steps_.graph(), sat);
    for (const Lit constraint : system_.constraints) sat.add({cnf.literal(steps_.at(0, constraint))});
    std::vector<int> some;
    for (const std::vector<std::size_t>& group : groups_) {
      Lit before = falseLit, after = falseLit;
      for (const std::size_t i : group) {
        const Lit was = steps_.at(0, truths_[i]), is = steps_.at(1, truths_[i]);
        const Lit both = steps_.graph().addAnd(was, before);
        if (both != falseLit) sat.add({-cnf.literal(both)});
        before = steps_.graph().addOr(before, was);
        const Lit wrong = steps_.graph().addAnd(is, after);
        if (wrong != falseLit) some.push_back(cnf.literal(wrong));
        after = steps_.graph().addOr(after, is);
      }
    }
    if (some.empty()) return Sat::Outcome::Unsatisfiable;
    const Sat::Outcome outcome = sat.solve({}, budget_, some);
    if (outcome != Sat::Outcome::Satisfiable) return outcome;
    state_.clear();
    inputs_.clear();
    for (const Latch& latch : system_.latches)
      state_.push_back(cnf.value(steps_.at(0, positive(latch.variable))) ? ~0ULL : 0);
    for (const std::uint32_t v : system_.inputs) inputs_.push_back(cnf.value(steps_.at(0, positive(v))) ? ~0ULL : 0);
    return outcome;
  }

  std::vector<ExclusiveGroup> result() const {
    std::vector<ExclusiveGroup> groups;
    for (const std::vector<std::size_t>& group : groups_) {
      ExclusiveGroup& literals = groups.emplace_back();
      for (const std::size_t i : group) literals.push_back(truths_[i]);
    }
    return groups;
  }

  const BitSystem& system_;
  const Budget& budget_;
  SimulationRuns runs_;
  std::mt19937_64 random_;
  Unrolling steps_;
  std::vector<Lit> truths_;
  std::vector<TruthSet> apart_;  ///< by truth: those that may exclude it
  std::vector<std::vector<std::size_t>> groups_;
  const std::vector<bool> isConstrained_;  ///< by variable
  std::vector<std::uint64_t> state_;       ///< by latch: of runs, or the solver's in each of them
  std::vector<std::uint64_t> inputs_;      ///< by input, of the same
};

}  // namespace

std::vector<ExclusiveGroup> mineGroups(const BitSystem& system, const std::vector<Lit>& truths, std::uint64_t seed,
                                       const Budget& budget) {
  return GroupMiner(system, truths, seed, budget).run();
}

Lit atMostOne(BitSystem& system, const ExclusiveGroup& group) {
  Lit result = trueLit, before = falseLit;
  for (const Lit l : group) {
    result = system.addAnd(result, negate(system.addAnd(l, before)));
    before = system.addOr(before, l);
  }
  return result;
}

}  // namespace rungproof
