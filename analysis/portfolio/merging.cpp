// Candidates are whole words, or the single bits of narrow ones, in classes of equal samples. A scan from a state in
// which all members of a class have one value is built with that value in place of all of them: most of what stays
// equal is then the same gate, and only the rest is asked of the SAT solver.
#include "analysis/portfolio/merging.hpp"

#include <algorithm>
#include <map>
#include <random>
#include <unordered_map>
#include <unordered_set>

#include "analysis/bits/bit_blast.hpp"
#include "analysis/bits/bit_cnf.hpp"
#include "analysis/bits/bit_cone.hpp"
#include "analysis/bits/simulation_runs.hpp"
#include "analysis/graph/substitution.hpp"
#include "analysis/schedule/schedule.hpp"
#include "ir/check.hpp"

namespace rungproof {

namespace {

/// A word or a bit of one. Its literals are those of the difference to its initial value, so every item starts with 0.
struct Item {
  std::size_t state = 0;
  std::uint32_t bit = 0;      ///< lowest of the word
  std::vector<Lit> literals;  ///< over latches, lowest first
  std::vector<std::uint32_t> latches;
};

class Merger {
 public:
  Merger(const TransitionSystem& given, const Questions& questions, std::uint64_t seed, const Budget& budget)
      : given_(given),
        graph_(*given.graph),
        seed_(seed),
        budget_(budget),
        blast_(given, questions, {}, &budget),
        bits_(blast_.bits()),
        isConstrained_(constrainedVariables(bits_)) {}

  MergedSystem run() {
    collectItems();
    sample();
    if (!makeInductive()) classes_.clear();
    return substituted();
  }

 private:
  int widthOf(std::size_t state) const { return graph_[given_.states[state].node].width; }

  void collectItems() {
    for (std::uint32_t latch = 0; latch < bits_.latches.size(); ++latch) {
      const auto [state, bit] = blast_.stateBit(latch);
      if (bits_.latches[latch].init == LatchInit::Free) continue;
      const bool isWide = static_cast<std::size_t>(widthOf(state)) > schedule::narrowWord;
      if (!isWide || bit == 0) items_.push_back({state, bit, {}, {}});
      items_.back().literals.push_back(positive(bits_.latches[latch].variable) ^
                                       (bits_.latches[latch].init == LatchInit::One ? 1U : 0U));
      items_.back().latches.push_back(latch);
    }
    // A class is represented by a truth value, if it has one: properties and invariants speak of those.
    std::stable_partition(items_.begin(), items_.end(), [&](const Item& item) { return widthOf(item.state) == 1; });
  }

  /// Classes of items that have equal values in all samples; class 0: those that never change.
  void sample() {
    std::vector<std::vector<std::uint64_t>> seen(items_.size());
    SimulationRuns runs(bits_, seed_);
    for (int scan = 0; scan < schedule::mergingScans && !budget_.isExhausted(); ++scan) {
      if (scan == schedule::mergingScans / 2) runs.restart();
      if (!runs.choose()) {
        runs.restart();
        continue;
      }
      for (std::size_t i = 0; i < items_.size(); ++i) {
        for (const Lit l : items_[i].literals) seen[i].push_back(runs.simulator().value(l) & runs.live());
      }
      runs.step();
    }
    std::map<std::vector<std::uint64_t>, std::size_t> index;
    classes_.emplace_back();
    for (std::size_t i = 0; i < items_.size(); ++i) {
      const bool isConstant =
          std::all_of(seen[i].begin(), seen[i].end(), [](std::uint64_t lanes) { return lanes == 0; });
      if (isConstant) {
        classes_[0].push_back(i);
        continue;
      }
      seen[i].push_back(items_[i].literals.size());
      const auto [at, isNew] = index.emplace(std::move(seen[i]), classes_.size());
      if (isNew) classes_.emplace_back();
      classes_[at->second].push_back(i);
    }
  }

  bool makeInductive() {
    std::mt19937_64 random(seed_);
    BitSimulator simulator(bits_);
    for (;;) {
      if (budget_.isExhausted()) return false;
      // One scan, members of a class replaced by their first, of class 0 by their initial value.
      BitSystem graph;
      std::vector<Lit> values(bits_.variableCount(), falseLit);
      for (const std::uint32_t v : bits_.inputs) values[v] = graph.addInput();
      std::vector<bool> isMember(bits_.latches.size(), false);
      for (std::size_t c = 0; c < classes_.size(); ++c) {
        for (std::size_t i = c == 0 ? 0 : 1; i < classes_[c].size(); ++i) {
          for (const std::uint32_t latch : items_[classes_[c][i]].latches) isMember[latch] = true;
        }
      }
      for (std::uint32_t latch = 0; latch < bits_.latches.size(); ++latch) {
        if (!isMember[latch]) values[bits_.latches[latch].variable] = graph.addInput();
      }
      const auto valueOf = [&](Lit l) { return values[variableOf(l)] ^ (l & 1U); };
      forMembers([&](const Item& member, const Item* first) {
        for (std::size_t bit = 0; bit < member.literals.size(); ++bit) {
          values[variableOf(member.literals[bit])] =
              (first == nullptr ? falseLit : valueOf(first->literals[bit])) ^ (member.literals[bit] & 1U);
        }
      });
      for (std::size_t i = 0; i < bits_.gates.size(); ++i)
        values[bits_.gateVariables[i]] = graph.addAnd(valueOf(bits_.gates[i].left), valueOf(bits_.gates[i].right));
      const auto after = [&](const Item& item, std::size_t bit) {
        return valueOf(bits_.latches[item.latches[bit]].next) ^ (item.literals[bit] & 1U);
      };
      std::vector<Lit> differences;
      forMembers([&](const Item& member, const Item* first) {
        Lit differs = falseLit;
        for (std::size_t bit = 0; bit < member.literals.size(); ++bit) {
          differs =
              graph.addOr(differs, graph.addXor(after(member, bit), first == nullptr ? falseLit : after(*first, bit)));
        }
        if (differs != falseLit) differences.push_back(differs);
      });
      if (differences.empty()) return true;
      Sat sat(Sat::Use::Many);
      BitCnf cnf(graph, sat);
      for (const Lit constraint : bits_.constraints) sat.add({cnf.literal(valueOf(constraint))});
      std::vector<int> some;
      for (const Lit l : differences) {
        some.push_back(cnf.literal(l));
        sat.prefer(some.back());
      }
      sat.add(some);
      const Sat::Outcome outcome = sat.solve({}, budget_);
      if (outcome == Sat::Outcome::Unsatisfiable) return true;
      if (outcome == Sat::Outcome::Unknown) return false;
      std::vector<bool> state, inputs;
      for (const Latch& latch : bits_.latches) state.push_back(cnf.value(values[latch.variable]));
      for (const std::uint32_t v : bits_.inputs) inputs.push_back(cnf.value(values[v]));
      bool isRefined = false;
      for (int batch = 0; batch < schedule::mergingBatches; ++batch)
        isRefined = refineNear(simulator, random, state, inputs, batch) || isRefined;
      CHECK(isRefined, "a counterexample breaks a candidate");
      walk(simulator, random, state, inputs);
    }
  }

  /// Every member with the first item of its class, nullptr for class 0.
  template <class Use>
  void forMembers(Use&& use) const {
    for (std::size_t c = 0; c < classes_.size(); ++c) {
      for (std::size_t i = c == 0 ? 0 : 1; i < classes_[c].size(); ++i)
        use(items_[classes_[c][i]], c == 0 ? nullptr : &items_[classes_[c][0]]);
    }
  }

  /// Splits classes by what one scan makes of a state and of 63 others near it; batch 0 has the state itself.
  bool refineNear(BitSimulator& simulator, std::mt19937_64& random, const std::vector<bool>& state,
                  const std::vector<bool>& inputs, int batch) {
    const auto flips = [&] {
      std::uint64_t mask = random();
      for (int i = 0; i < batch; ++i) mask &= random();
      return batch == 0 ? mask & random() & ~1ULL : mask;
    };
    for (std::size_t i = 0; i < state.size(); ++i) simulator.setLatch(i, (state[i] ? ~0ULL : 0) ^ flips());
    for (std::size_t i = 0; i < inputs.size(); ++i) simulator.setInput(i, (inputs[i] ? ~0ULL : 0) ^ flips());
    std::uint64_t lanes = 0;
    return refineAfterScan(simulator, lanes);
  }

  /// On from where the last scans have led, with other inputs in every scan: what a sequence does step by step comes up
  /// without a question to the solver. What the constraints speak of stays as it is.
  void walk(BitSimulator& simulator, std::mt19937_64& random, const std::vector<bool>& state,
            const std::vector<bool>& inputs) {
    std::uint64_t lanes = 0;
    for (int idle = 0; idle < schedule::walkPatience && !budget_.isExhausted(); ++idle) {
      for (std::size_t i = 0; i < state.size(); ++i) {
        const bool stays = isConstrained_[bits_.latches[i].variable];
        const std::uint64_t start = state[i] ? ~0ULL : 0;
        simulator.setLatch(i, stays ? start : (simulator.latch(i) & lanes) | (start & ~lanes));
      }
      for (std::size_t i = 0; i < inputs.size(); ++i)
        simulator.setInput(i, !isConstrained_[bits_.inputs[i]] ? random() : inputs[i] ? ~0ULL : 0);
      if (refineAfterScan(simulator, lanes)) idle = 0;
    }
  }

  /// Splits classes by what one scan makes of states in which their members are equal; `lanes`: runs that meet the
  /// constraints.
  bool refineAfterScan(BitSimulator& simulator, std::uint64_t& lanes) {
    forMembers([&](const Item& member, const Item* first) {
      for (std::size_t bit = 0; bit < member.literals.size(); ++bit) {
        const std::uint64_t value = first == nullptr ? 0 : simulator.value(first->literals[bit]);
        simulator.setLatch(member.latches[bit], value ^ (isNegative(member.literals[bit]) ? ~0ULL : 0));
      }
    });
    simulator.evaluate();
    lanes = ~0ULL;
    for (const Lit constraint : bits_.constraints) lanes &= simulator.value(constraint);
    if (lanes == 0) return false;
    simulator.step();
    bool isRefined = false;
    const std::size_t before = classes_.size();
    for (std::size_t c = 0; c < before; ++c) {
      if (classes_[c].size() < (c == 0 ? 1U : 2U)) continue;
      const auto valuesOf = [&](std::size_t item) {
        std::vector<std::uint64_t> result;
        for (const Lit l : items_[item].literals) result.push_back(simulator.value(l) & lanes);
        if (c == 0) result.push_back(result.size());  // items of different widths
        return result;
      };
      std::vector<std::uint64_t> expected;
      if (c != 0) expected = valuesOf(classes_[c][0]);
      std::map<std::vector<std::uint64_t>, std::vector<std::size_t>> others;
      std::erase_if(classes_[c], [&](std::size_t item) {
        std::vector<std::uint64_t> v = valuesOf(item);
        const bool stays =
            c == 0 ? std::all_of(v.begin(), v.end() - 1, [](std::uint64_t l) { return l == 0; }) : v == expected;
        if (!stays) others[std::move(v)].push_back(item);
        return !stays;
      });
      isRefined = isRefined || !others.empty();
      for (auto& [value, members] : others) classes_.push_back(std::move(members));
    }
    return isRefined;
  }

  // ---- The smaller system ----------------------------------------------------------------------------

  std::uint64_t initOf(std::size_t state) const { return graph_[given_.states[state].init].value; }
  Node bitOf(std::size_t state, std::uint32_t bit) {
    const Node word = given_.states[state].node;
    return widthOf(state) == 1 ? word : graph_.make(Op::Extract, 1, word, noNode, noNode, bit);
  }

  /// The word in terms of the firsts of the classes; itself if nothing is known of it.
  Node replacement(std::size_t state,
                   const std::unordered_map<std::size_t, std::vector<std::pair<const Item*, const Item*>>>& members) {
    const Node word = given_.states[state].node;
    const auto found = members.find(state);
    if (found == members.end()) return word;
    const int width = widthOf(state);
    if (static_cast<std::size_t>(width) > schedule::narrowWord) {
      const Item* first = found->second[0].second;
      if (first == nullptr) return graph_.constantNode(initOf(state), width);
      return graph_.make(Op::Xor, width, given_.states[first->state].node,
                         graph_.constantNode(initOf(state) ^ initOf(first->state), width));
    }
    std::vector<Node> bits;
    for (int bit = 0; bit < width; ++bit) bits.push_back(bitOf(state, static_cast<std::uint32_t>(bit)));
    for (const auto& [member, first] : found->second) {
      const std::uint64_t init = initOf(state) >> member->bit & 1U;
      if (first == nullptr) {
        bits[member->bit] = graph_.constantNode(init, 1);
      } else {
        const Node other = bitOf(first->state, first->bit);
        bits[member->bit] = init != (initOf(first->state) >> first->bit & 1U) ? graph_.make(Op::Not, 1, other) : other;
      }
    }
    Node result = bits[0];
    for (int bit = 1; bit < width; ++bit)
      result = graph_.make(Op::Concat, bit + 1, bits[static_cast<std::size_t>(bit)], result);
    return result;
  }

  MergedSystem substituted() {
    std::unordered_map<std::size_t, std::vector<std::pair<const Item*, const Item*>>> members;
    forMembers([&](const Item& member, const Item* first) { members[member.state].emplace_back(&member, first); });
    MergedSystem result;
    std::unordered_map<std::uint32_t, Node> replaced;
    std::vector<bool> isBlasted(given_.states.size(), false);
    for (std::uint32_t latch = 0; latch < bits_.latches.size(); ++latch) isBlasted[blast_.stateBit(latch).state] = true;
    for (std::size_t s = 0; s < given_.states.size(); ++s) {
      const Node word = given_.states[s].node;
      const Node other = isBlasted[s] ? replacement(s, members) : word;
      if (other != word) {
        result.facts.push_back({word, other, graph_.make(Op::Equal, 1, word, other)});
        replaced.emplace(indexOf(word), other);
      }
      const std::size_t replacedBits =
          members.contains(s)
              ? (static_cast<std::size_t>(widthOf(s)) > schedule::narrowWord ? static_cast<std::size_t>(widthOf(s))
                                                                             : members[s].size())
              : 0;
      if (isBlasted[s] && replacedBits < static_cast<std::size_t>(widthOf(s))) result.kept.push_back(s);
    }
    Substitution rewritten(graph_, std::move(replaced));
    result.system.graph = given_.graph;
    result.system.inputs = given_.inputs;
    result.system.timers = given_.timers;
    result.system.steadySteps = given_.steadySteps;
    for (const std::size_t s : result.kept)
      result.system.states.push_back({given_.states[s].node, given_.states[s].init, rewritten(given_.states[s].next)});
    for (const Node n : given_.constraints) {
      const Node other = rewritten(n);
      if (graph_[other].op == Op::Constant && graph_[other].value == 1) continue;
      result.system.constraints.push_back(other);
      if (std::find(given_.totalConstraints.begin(), given_.totalConstraints.end(), n) != given_.totalConstraints.end())
        result.system.totalConstraints.push_back(other);
    }
    result.system.questions = given_.questions;
    for (Question& question : result.system.questions) question.bad = noNode;
    for (const std::size_t q : blast_.questions()) result.system.questions[q].bad = rewritten(given_.questions[q].bad);
    return result;
  }

  const TransitionSystem& given_;
  Graph& graph_;
  const std::uint64_t seed_;
  const Budget& budget_;
  const BitBlast blast_;
  const BitSystem& bits_;
  const std::vector<bool> isConstrained_;  ///< by variable
  std::vector<Item> items_;
  std::vector<std::vector<std::size_t>> classes_;  ///< indices in items_
};

}  // namespace

std::vector<Node> factsBehind(const TransitionSystem& given, const std::vector<Replaced>& facts,
                              const std::vector<Node>& roots) {
  const Graph& graph = *given.graph;
  std::unordered_map<std::uint32_t, Node> next, other;
  for (const StateVariable& state : given.states) next.emplace(indexOf(state.node), state.next);
  for (const Replaced& fact : facts) other.emplace(indexOf(fact.word), fact.other);
  std::unordered_set<std::uint32_t> seen;
  std::vector<Node> open = roots;
  while (!open.empty()) {
    const Node n = open.back();
    open.pop_back();
    if (n == noNode || !seen.insert(indexOf(n)).second) continue;
    if (const auto later = next.find(indexOf(n)); later != next.end()) open.push_back(later->second);
    if (const auto first = other.find(indexOf(n)); first != other.end()) open.push_back(first->second);
    if (graph[n].op != Op::Variable) open.insert(open.end(), graph[n].child.begin(), graph[n].child.end());
  }
  std::vector<Node> result;
  for (const Replaced& fact : facts) {
    if (seen.contains(indexOf(fact.word))) result.push_back(fact.equation);
  }
  return result;
}

MergedSystem mergeStates(const TransitionSystem& given, const Questions& questions, std::uint64_t seed,
                         const Budget& budget) {
  try {
    return Merger(given, questions, seed, budget).run();
  } catch (const OutOfBudget&) {
    MergedSystem same;
    same.system = given;
    for (std::size_t s = 0; s < given.states.size(); ++s) same.kept.push_back(s);
    return same;
  }
}

}  // namespace rungproof
