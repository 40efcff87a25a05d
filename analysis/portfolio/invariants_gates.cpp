// Classes of equal samples, refined by counterexamples to induction. A scan is built with the first of a class in place
// of all of it, before the scan and after: most of what stays equal is then the same gate, and only the rest is asked
// of the solver, from the inputs on, so that each question is about few gates.
#include "analysis/portfolio/invariants_gates.hpp"

#include <algorithm>
#include <map>
#include <random>
#include <unordered_map>

#include "analysis/bits/bit_cnf.hpp"
#include "analysis/bits/bit_cone.hpp"
#include "analysis/bits/simulation_runs.hpp"
#include "analysis/graph/substitution.hpp"
#include "analysis/schedule/schedule.hpp"

namespace rungproof {

namespace {

class GateMiner {
 public:
  GateMiner(BitSystem& system, std::uint64_t seed, const Budget& budget)
      : system_(system),
        seed_(seed),
        budget_(budget),
        simulator_(system),
        random_(seed),
        isConstrained_(constrainedVariables(system)) {}

  std::vector<Lit> run() {
    findWatched();
    if (watched_.size() > schedule::correspondingGates) return {};
    sample();
    if (!holdInitially()) return {};
    for (bool isRefined = true; isRefined;) {
      if (budget_.isExhausted() || !makeRound(isRefined)) return {};
    }
    return equalities();
  }

 private:
  /// Equal in all reachable states, presumably, by growing variable: gates come after what they are made of.
  using Class = std::vector<Lit>;

  void findWatched() {
    isOfState_.assign(system_.variableCount(), false);
    for (std::uint32_t v = 0; v < system_.variableCount(); ++v) {
      const bool isGate = system_.kind[v] == BitSystem::Kind::Gate;
      isOfState_[v] = system_.kind[v] == BitSystem::Kind::Constant || system_.kind[v] == BitSystem::Kind::Latch ||
                      (isGate && isOfState_[variableOf(system_.gateOf(positive(v)).left)] &&
                       isOfState_[variableOf(system_.gateOf(positive(v)).right)]);
      if (isOfState_[v] && v != 0) watched_.push_back(v);
    }
  }

  void sample() {
    std::vector<std::uint64_t> signature(watched_.size(), 0);
    std::vector<bool> isComplement(watched_.size(), false), isConstant(watched_.size(), true);
    SimulationRuns runs(system_, seed_);
    for (int scan = 0; scan < schedule::correspondenceScans && !budget_.isExhausted(); ++scan) {
      if (scan == schedule::correspondenceScans / 2) runs.restart();
      if (!runs.choose()) {
        runs.restart();
        continue;
      }
      const std::uint64_t live = runs.live(), one = live & -live;
      for (std::size_t i = 0; i < watched_.size(); ++i) {
        const std::uint64_t value = runs.simulator().value(positive(watched_[i]));
        std::uint64_t seen = (value & live) | ((value & one) != 0 ? ~live : 0);  // ended runs repeat a live one
        if (scan == 0) isComplement[i] = (seen & 1U) != 0;
        if (isComplement[i]) seen = ~seen;
        isConstant[i] = isConstant[i] && seen == 0;
        signature[i] = (signature[i] ^ seen) * 0x9E3779B97F4A7C15ULL;
        signature[i] ^= signature[i] >> 29U;
      }
      runs.step();
    }
    classes_.push_back({falseLit});
    std::unordered_map<std::uint64_t, std::size_t> index;
    for (std::size_t i = 0; i < watched_.size(); ++i) {
      const Lit l = positive(watched_[i]) ^ (isComplement[i] ? 1U : 0U);
      if (isConstant[i]) {
        classes_[0].push_back(l);
        continue;
      }
      const auto [at, isNew] = index.emplace(signature[i], classes_.size());
      if (isNew) classes_.emplace_back();
      classes_[at->second].push_back(l);
    }
  }

  /// By variable, what stands for it: the first of its class, the constant or itself.
  std::vector<Lit> leaders() const {
    std::vector<Lit> leader(system_.variableCount());
    for (std::uint32_t v = 0; v < leader.size(); ++v) leader[v] = positive(v);
    for (const Class& c : classes_) {
      for (std::size_t i = 1; i < c.size(); ++i) leader[variableOf(c[i])] = c[0] ^ (c[i] & 1U);
    }
    return leader;
  }

  /// Splits classes by values of 64 states, of which those of `lanes` count; true if anything has changed.
  bool refine(std::uint64_t lanes) {
    bool isChanged = false;
    const std::size_t before = classes_.size();
    for (std::size_t c = 0; c < before; ++c) {
      const std::uint64_t expected = simulator_.value(classes_[c][0]) & lanes;
      const auto stays = [&](Lit l) { return (simulator_.value(l) & lanes) == expected; };
      if (std::ranges::all_of(classes_[c], stays)) continue;
      isChanged = true;
      std::map<std::uint64_t, Class> others;
      for (const Lit l : classes_[c]) {
        if (!stays(l)) others[simulator_.value(l) & lanes].push_back(l);
      }
      std::erase_if(classes_[c], [&](Lit l) { return !stays(l); });
      for (auto& [value, members] : others) classes_.push_back(std::move(members));
    }
    std::erase_if(classes_, [&](const Class& c) { return c.size() == 1 && c[0] != falseLit; });
    return isChanged;
  }

  /// States in which all members of each class are equal.
  std::uint64_t satisfying() const {
    std::uint64_t lanes = ~0ULL;
    for (const Class& c : classes_) {
      const std::uint64_t first = simulator_.value(c[0]);
      for (std::size_t i = 1; i < c.size(); ++i) lanes &= ~(first ^ simulator_.value(c[i]));
    }
    return lanes;
  }

  /// The initial state, or where there are several what the solver says of all: random runs may have met none, if the
  /// constraints forbid them.
  bool holdInitially() {
    for (std::size_t i = 0; i < system_.latches.size(); ++i)
      simulator_.setLatch(i, system_.latches[i].init == LatchInit::One ? ~0ULL : 0);
    simulator_.evaluate();
    refine(~0ULL);
    if (std::ranges::none_of(system_.latches, [](const Latch& l) { return l.init == LatchInit::Free; })) return true;
    BitSystem start;
    std::vector<Lit> value(system_.variableCount(), falseLit);
    for (const Latch& latch : system_.latches) {
      value[latch.variable] = latch.init == LatchInit::Free  ? start.addInput()
                              : latch.init == LatchInit::One ? trueLit
                                                             : falseLit;
    }
    const auto of = [&](Lit l) { return value[variableOf(l)] ^ (l & 1U); };
    for (const std::uint32_t v : watched_) {
      if (!system_.isGate(positive(v))) continue;
      value[v] = start.addAnd(of(system_.gateOf(positive(v)).left), of(system_.gateOf(positive(v)).right));
    }
    Sat sat(Sat::Use::Many);
    BitCnf cnf(start, sat);
    for (;;) {
      std::vector<int> broken;
      for (const Class& c : classes_) {
        for (std::size_t i = 1; i < c.size(); ++i) {
          if (const Lit differs = start.addXor(of(c[0]), of(c[i])); differs != falseLit)
            broken.push_back(cnf.literal(differs));
        }
      }
      if (broken.empty()) return true;
      const Sat::Outcome outcome = sat.solve({}, budget_, broken);
      if (outcome != Sat::Outcome::Satisfiable) return outcome == Sat::Outcome::Unsatisfiable;
      for (std::size_t i = 0; i < system_.latches.size(); ++i)
        simulator_.setLatch(i, cnf.value(of(positive(system_.latches[i].variable))) ? ~0ULL : 0);
      simulator_.evaluate();
      refine(~0ULL);
    }
  }

  /// One scan, asked whether it keeps each member equal to its first; false if the budget ends.
  bool makeRound(bool& isRefined) {
    isRefined = false;
    const std::vector<Lit> leader = leaders();
    BitSystem graph;
    std::vector<Lit> before(system_.variableCount(), falseLit), after(system_.variableCount(), falseLit);
    const auto in = [](const std::vector<Lit>& values, Lit l) { return values[variableOf(l)] ^ (l & 1U); };
    std::vector<std::pair<Lit, Lit>> assumed;
    for (const std::uint32_t v : system_.inputs) before[v] = graph.addInput();
    for (const Latch& latch : system_.latches) {
      const std::uint32_t v = latch.variable;
      before[v] = leader[v] == positive(v) ? graph.addInput() : in(before, leader[v]);
    }
    for (std::size_t i = 0; i < system_.gates.size(); ++i) {
      const std::uint32_t v = system_.gateVariables[i];
      const Lit own = graph.addAnd(in(before, system_.gates[i].left), in(before, system_.gates[i].right));
      before[v] = leader[v] == positive(v) ? own : in(before, leader[v]);
      if (own != before[v]) assumed.emplace_back(own, before[v]);
    }
    struct Asked {
      std::uint32_t variable;
      Lit differs;
    };
    std::vector<Asked> asked;
    const auto follow = [&](std::uint32_t v, Lit own) {
      after[v] = leader[v] == positive(v) ? own : in(after, leader[v]);
      if (own != after[v]) asked.push_back({v, graph.addXor(own, after[v])});
    };
    for (const std::uint32_t v : watched_) {
      if (system_.kind[v] == BitSystem::Kind::Latch) {
        follow(v, in(before, system_.latches[system_.position[v]].next));
      } else {
        const AndGate& gate = system_.gateOf(positive(v));
        follow(v, graph.addAnd(in(after, gate.left), in(after, gate.right)));
      }
    }
    if (asked.empty()) return true;
    Sat sat(Sat::Use::Many);
    BitCnf cnf(graph, sat);
    for (const Lit constraint : system_.constraints) sat.add({cnf.literal(in(before, constraint))});
    for (const auto& [own, wanted] : assumed) sat.add({-cnf.literal(graph.addXor(own, wanted))});
    std::vector<Lit> now = leader;
    for (std::size_t next = 0; next < asked.size();) {
      std::vector<int> some;
      std::size_t end = next;
      for (; end < asked.size() && some.size() < schedule::askedTogether; ++end) {
        if (now[asked[end].variable] != leader[asked[end].variable]) continue;  // split in this round
        some.push_back(cnf.literal(asked[end].differs));
      }
      if (some.empty()) break;
      const Sat::Outcome outcome = sat.solve({}, budget_, some);
      if (outcome == Sat::Outcome::Unknown) return false;
      if (outcome == Sat::Outcome::Unsatisfiable) {
        for (const int l : some) sat.add({-l});
        next = end;
        continue;
      }
      std::vector<bool> state, inputs;
      for (const Latch& latch : system_.latches) state.push_back(cnf.value(before[latch.variable]));
      for (const std::uint32_t v : system_.inputs) inputs.push_back(cnf.value(before[v]));
      if (!refineFrom(state, inputs)) {
        next = end;  // the scan breaks only what has been split already: asked again in the next round
        isRefined = true;
        continue;
      }
      isRefined = true;
      now = leaders();
    }
    return true;
  }

  /// Splits by what the scan makes of the state, with other inputs too, and by scans on from there, as long as the
  /// classes hold before them. Most runs go on with some of the bits on that were on before: what counts comes so from
  /// one bit to the next in a few scans.
  bool refineFrom(const std::vector<bool>& state, const std::vector<bool>& inputs) {
    constexpr std::uint64_t givenInputs = 0x5555555555555555ULL;  // runs
    constexpr std::uint64_t joined = 0xEEEEEEEEEEEEEEEEULL;
    bool isChanged = false;
    std::uint64_t goesOn = 0;
    std::vector<std::uint64_t> before(state.size());
    for (int idle = 0; idle < schedule::correspondenceWalk && !budget_.isExhausted(); ++idle) {
      const std::vector<Lit> leader = leaders();
      for (std::size_t i = 0; i < state.size(); ++i) {
        const std::uint32_t v = system_.latches[i].variable;
        const std::uint64_t kept = isConstrained_[v] ? 0 : before[i] & joined & random_();
        const std::uint64_t own = ((simulator_.latch(i) | kept) & goesOn) | ((state[i] ? ~0ULL : 0) & ~goesOn);
        simulator_.setLatch(i, before[i] = leader[v] == positive(v) ? own : simulator_.value(leader[v]));
      }
      for (std::size_t i = 0; i < inputs.size(); ++i)
        simulator_.setInput(i, (inputs[i] ? givenInputs : 0) | (random_() & ~givenInputs));
      simulator_.evaluate();
      goesOn = satisfying();
      for (const Lit constraint : system_.constraints) goesOn &= simulator_.value(constraint);
      simulator_.step();
      simulator_.evaluate();
      if (!refine(goesOn)) continue;
      isChanged = true;
      idle = -1;
    }
    return isChanged;
  }

  std::vector<Lit> equalities() {
    std::map<std::uint32_t, Lit> equal;  // by variable: in the order in which they follow
    for (const Class& c : classes_) {
      for (std::size_t i = 1; i < c.size(); ++i) equal.emplace(variableOf(c[i]), negate(system_.addXor(c[0], c[i])));
    }
    std::vector<Lit> result;
    for (const auto& [variable, literal] : equal) result.push_back(literal);
    return result;
  }

  BitSystem& system_;
  const std::uint64_t seed_;
  const Budget& budget_;
  BitSimulator simulator_;
  std::mt19937_64 random_;
  const std::vector<bool> isConstrained_;  ///< by variable
  std::vector<bool> isOfState_;            ///< by variable
  std::vector<std::uint32_t> watched_;     ///< latches and gates over latches, ascending
  std::vector<Class> classes_;             ///< the first one begins with the constant
};

}  // namespace

std::vector<Node> askedAtStart(const TransitionSystem& system, const Questions& questions) {
  Graph& graph = *system.graph;
  std::unordered_map<std::uint32_t, Node> replaced;
  for (const StateVariable& state : system.states) {
    if (graph[state.next].op != Op::Constant) replaced.emplace(indexOf(state.next), state.node);
  }
  Substitution atStart(graph, std::move(replaced));
  std::vector<Node> result;
  for (const std::size_t q : questions) result.push_back(atStart(system.questions[q].bad));
  return result;
}

std::vector<Lit> mineEqualGates(BitSystem& system, std::uint64_t seed, const Budget& budget) {
  return GateMiner(system, seed, budget).run();
}

}  // namespace rungproof
