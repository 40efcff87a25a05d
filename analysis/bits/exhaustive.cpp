// Explicit search: visits every reachable state breadth first, 64 (state, input) pairs at a time. Beats everything
// on small sequencers; gives up beyond a few million states or 12 inputs. Its certificate is the set of visited
// states as a decision diagram. Tested by tests/solver/engine_agreement_test.cpp.
#include <algorithm>
#include <array>
#include <bit>
#include <unordered_map>

#include "analysis/bits/bit_simulator.hpp"
#include "analysis/bits/bit_unrolling.hpp"
#include "analysis/schedule/schedule.hpp"
#include "ir/check.hpp"

namespace rungproof {

namespace {

using State = std::uint64_t;  ///< bit i: latch i

class Exhaustive final : public Engine {
 public:
  Exhaustive(const BitSystem& system, const EngineOptions&) : system_(system), simulator_(system) {
    std::size_t freeLatches = 0;
    for (const Latch& latch : system.latches) freeLatches += latch.init == LatchInit::Free ? 1 : 0;
    tooLarge_ = system.latches.size() > schedule::explicitLatches || system.inputs.size() > schedule::explicitInputs ||
                freeLatches > schedule::explicitFree;
    if (!tooLarge_) addInitialStates();
  }

  bool isExhausted() const override { return tooLarge_; }

  Verdict advance(const Budget& budget) override {
    Verdict verdict;
    verdict.method = "explicit search";
    while (!tooLarge_ && done_ < states_.size()) {
      if (++batches_ % 64 == 0 && budget.isExhausted()) return verdict;
      if (expand(verdict)) return verdict;
      if (states_.size() > schedule::explicitStates) tooLarge_ = true;
    }
    if (tooLarge_) return verdict;
    Certificate evidence = certificate();
    tooLarge_ = evidence.gates.size() > schedule::explicitGates;
    if (tooLarge_) return verdict;
    verdict.answer = Answer::Proved;
    verdict.certificate = std::move(evidence);
    return verdict;
  }

 private:
  void add(State state, std::uint32_t parent, std::uint32_t inputs) {
    if (!index_.emplace(state, static_cast<std::uint32_t>(states_.size())).second) return;
    states_.push_back(state);
    parents_.push_back({parent, inputs});
  }

  void addInitialStates() {
    std::vector<std::size_t> free;
    State state = 0;
    for (std::size_t i = 0; i < system_.latches.size(); ++i) {
      if (system_.latches[i].init == LatchInit::Free) free.push_back(i);
      if (system_.latches[i].init == LatchInit::One) state |= 1ULL << i;
    }
    for (std::uint64_t choice = 0; choice < 1ULL << free.size(); ++choice) {
      State initial = state;
      for (std::size_t i = 0; i < free.size(); ++i) initial |= (choice >> i & 1U) << free[i];
      add(initial, ~0U, 0);
    }
  }

  /// Takes up to 64 pairs of state and inputs; true if one of them is bad.
  bool expand(Verdict& verdict) {
    const std::uint32_t choices = 1U << system_.inputs.size();
    std::array<std::uint32_t, 64> from{}, inputs{};
    unsigned lanes = 0;
    while (lanes < 64 && done_ < states_.size()) {
      from[lanes] = static_cast<std::uint32_t>(done_);
      inputs[lanes] = nextChoice_;
      ++lanes;
      if (++nextChoice_ == choices) {
        nextChoice_ = 0;
        ++done_;
      }
    }
    for (std::size_t i = 0; i < system_.latches.size(); ++i) {
      std::uint64_t word = 0;
      for (unsigned lane = 0; lane < lanes; ++lane) word |= (states_[from[lane]] >> i & 1U) << lane;
      simulator_.setLatch(i, word);
    }
    for (std::size_t i = 0; i < system_.inputs.size(); ++i) {
      std::uint64_t word = 0;
      for (unsigned lane = 0; lane < lanes; ++lane) word |= static_cast<std::uint64_t>(inputs[lane] >> i & 1U) << lane;
      simulator_.setInput(i, word);
    }
    simulator_.evaluate();
    std::uint64_t legal = lanes == 64 ? ~0ULL : (1ULL << lanes) - 1;
    for (const Lit l : system_.constraints) legal &= simulator_.value(l);
    std::uint64_t bad = 0;
    for (const Lit l : system_.bads) bad |= simulator_.value(l);
    if ((bad & legal) != 0) {
      const int lane = std::countr_zero(bad & legal);
      violated(verdict, from[lane], inputs[lane]);
      return true;
    }
    std::array<State, 64> next{};
    for (std::size_t i = 0; i < system_.latches.size(); ++i) {
      const std::uint64_t word = simulator_.value(system_.latches[i].next);
      for (unsigned lane = 0; lane < lanes; ++lane) next[lane] |= (word >> lane & 1U) << i;
    }
    for (unsigned lane = 0; lane < lanes; ++lane) {
      if ((legal >> lane & 1U) != 0) add(next[lane], from[lane], inputs[lane]);
    }
    return false;
  }

  void violated(Verdict& verdict, std::uint32_t state, std::uint32_t inputs) {
    BitTrace trace;
    const auto scan = [&](std::uint32_t choice) {
      std::vector<bool>& values = trace.inputs.emplace_back();
      for (std::size_t i = 0; i < system_.inputs.size(); ++i) values.push_back((choice >> i & 1U) != 0);
    };
    scan(inputs);
    for (; parents_[state].first != ~0U; state = parents_[state].first) scan(parents_[state].second);
    std::reverse(trace.inputs.begin(), trace.inputs.end());
    for (std::size_t i = 0; i < system_.latches.size(); ++i) trace.initial.push_back((states_[state] >> i & 1U) != 0);
    CHECK(isViolation(system_, trace), "a run of the explicit search does not violate the property");
    verdict.answer = Answer::Violated;
    verdict.depth = static_cast<int>(trace.inputs.size()) - 1;
    verdict.trace = std::move(trace);
  }

  /// The decision diagram of the sorted states [begin, end) over latches `bit` .. 0.
  Lit diagram(BitSystem& graph, const State* begin, const State* end, int bit) const {
    if (begin == end) return falseLit;
    if (bit < 63 && static_cast<std::uint64_t>(end - begin) == 1ULL << (bit + 1)) return trueLit;
    const State* split = std::partition_point(begin, end, [&](State s) { return (s >> bit & 1U) == 0; });
    const Lit low = diagram(graph, begin, split, bit - 1);
    const Lit high = diagram(graph, split, end, bit - 1);
    return graph.addIte(positive(graph.inputs[bit]), high, low);
  }

  Certificate certificate() const {
    std::vector<State> sorted = states_;
    std::sort(sorted.begin(), sorted.end());
    BitSystem graph;
    for (std::size_t i = 0; i < system_.latches.size(); ++i) graph.addInput();
    const int bits = static_cast<int>(system_.latches.size());
    const Lit visited = diagram(graph, sorted.data(), sorted.data() + sorted.size(), bits - 1);
    const auto translated = [&](Lit l) {
      const std::uint32_t v = variableOf(l);
      if (v == 0) return l;
      const std::uint32_t p = graph.position[v];
      return positive(graph.isGate(l) ? system_.variableCount() + p : system_.latches[p].variable) ^ (l & 1U);
    };
    Certificate result;
    for (const AndGate& gate : graph.gates) result.gates.push_back({translated(gate.left), translated(gate.right)});
    if (visited != trueLit) result.clauses.push_back({translated(visited)});
    return result;
  }

  const BitSystem& system_;
  BitSimulator simulator_;
  bool tooLarge_ = false;
  std::vector<State> states_;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> parents_;  ///< by state: predecessor, its inputs
  std::unordered_map<State, std::uint32_t> index_;
  std::size_t done_ = 0;          ///< states fully expanded
  std::uint32_t nextChoice_ = 0;  ///< inputs to try next on state done_
  unsigned batches_ = 0;
};

}  // namespace

std::unique_ptr<Engine> makeExhaustive(const BitSystem& system, const EngineOptions& options) {
  return std::make_unique<Exhaustive>(system, options);
}

}  // namespace rungproof
