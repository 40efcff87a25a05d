// IC3 (property directed reachability) on bits: finds an inductive invariant clause by clause, or a violation, with
// one-scan questions only. Generalisation drops literals one by one and handles counterexamples to generalisation
// (Hassan, Bradley, Somenzi 2013); predecessors are enlarged by SAT cores; obligations go on to higher frames.
// Tested by tests/solver/engine_agreement_test.cpp.
#include <algorithm>
#include <queue>

#include "analysis/bits/ic3_frames.hpp"
#include "analysis/schedule/schedule.hpp"
#include "ir/check.hpp"

namespace rungproof {

namespace {

struct Obligation {
  Ic3State state;
  int successor = -1;  ///< obligation it leads to; -1: bad in this very scan
  int distance = 0;    ///< scans from here to bad
};

class Ic3 final : public Engine {
 public:
  Ic3(const BitSystem& system, const EngineOptions& options)
      : system_(system), options_(options), frames_(system, options_) {}

  Verdict advance(const Budget& budget) override {
    frames_.setBudget(budget);
    Verdict verdict;
    verdict.method = "IC3";
    try {
      run(verdict);
    } catch (const Ic3Interrupted&) {
      verdict.depth = frames_.top();
    }
    return verdict;
  }

 private:
  void run(Verdict& verdict) {
    for (;;) {
      while (const std::optional<Ic3State> bad = frames_.findBad(frames_.top())) {
        if (block(*bad, verdict)) return;
      }
      frames_.addFrame();
      if (const std::optional<int> level = frames_.propagate()) {
        verdict.answer = Answer::Proved;
        verdict.certificate = Certificate{};
        for (const Cube& cube : frames_.lemmas().above(*level)) {
          std::vector<Lit>& clause = verdict.certificate->clauses.emplace_back();
          for (const Lit l : cube) clause.push_back(negate(l));
        }
        return;
      }
    }
  }

  /// Blocks the bad state at the top frame, with all its predecessors; true if a violation was found.
  bool block(const Ic3State& bad, Verdict& verdict) {
    obligations_.clear();
    using Entry = std::pair<std::pair<int, int>, int>;  // (level, distance), obligation
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
    const auto oblige = [&](Ic3State state, int level, int successor) {
      const int distance = successor < 0 ? 0 : obligations_[successor].distance + 1;
      obligations_.push_back({std::move(state), successor, distance});
      queue.push({{level, distance}, static_cast<int>(obligations_.size()) - 1});
      return frames_.meetsInitial(obligations_.back().state.latches);
    };
    if (oblige(bad, frames_.top(), -1)) return violated(verdict);
    while (!queue.empty()) {
      const auto [key, index] = queue.top();
      const int level = key.first;
      const Cube cube = obligations_[index].state.latches;
      if (frames_.lemmas().isBlocked(cube, level)) {
        queue.pop();
        if (level < frames_.top()) queue.push({{level + 1, key.second}, index});
        continue;
      }
      Cube core;
      if (frames_.isInductive(cube, level - 1, true, &core)) {
        queue.pop();
        generalise(core, level - 1, 0);
        int high = level;
        while (high < frames_.top() && frames_.isInductive(core, high, true, nullptr)) ++high;
        frames_.addLemma(core, high);
        if (high < frames_.top()) queue.push({{high + 1, key.second}, index});
      } else if (oblige(frames_.predecessor(cube), level - 1, index)) {
        return violated(verdict);
      }
    }
    return false;
  }

  /// Shrinks a cube that is inductive relative to F_level to one with fewer literals.
  void generalise(Cube& cube, int level, int depth) {
    Cube order = cube;
    std::stable_sort(order.begin(), order.end(),
                     [&](Lit a, Lit b) { return frames_.lemmas().activity(a) < frames_.lemmas().activity(b); });
    std::vector<Lit> needed;
    for (const Lit drop : order) {
      if (cube.size() <= 1) break;
      if (!std::binary_search(cube.begin(), cube.end(), drop)) continue;
      Cube smaller;
      std::copy_if(cube.begin(), cube.end(), std::back_inserter(smaller), [&](Lit l) { return l != drop; });
      if (shrinks(smaller, level, depth, needed))
        cube = std::move(smaller);
      else
        needed.push_back(drop);
    }
  }

  /// Is the cube inductive relative to F_level, perhaps after blocking a few states that spoil it or after dropping
  /// further literals (none of `needed`)? Then it is replaced by the core.
  bool shrinks(Cube& cube, int level, int depth, const std::vector<Lit>& needed) {
    int spoilers = 0;
    for (;;) {
      if (frames_.meetsInitial(cube)) return false;
      Cube core;
      if (frames_.isInductive(cube, level, true, &core)) {
        cube = std::move(core);
        return true;
      }
      if (depth >= 1) return false;
      const Ic3State state = frames_.predecessor(cube);
      const Cube& spoiler = state.latches;
      Cube spoilerCore;
      if (spoilers < schedule::ctgLimit && level > 0 && !frames_.meetsInitial(spoiler) &&
          frames_.isInductive(spoiler, level - 1, true, &spoilerCore)) {
        ++spoilers;
        int high = level;
        while (high < frames_.top() && frames_.isInductive(spoilerCore, high, true, nullptr)) ++high;
        generalise(spoilerCore, high - 1, depth + 1);
        frames_.addLemma(spoilerCore, high);
        continue;
      }
      spoilers = 0;
      // Join: keep the literals that hold in the spoiling state too.
      Cube joined;
      std::set_intersection(cube.begin(), cube.end(), state.whole.begin(), state.whole.end(),
                            std::back_inserter(joined));
      if (joined.size() == cube.size() || joined.empty()) return false;
      for (const Lit l : needed) {
        if (!std::binary_search(joined.begin(), joined.end(), l)) return false;
      }
      cube = std::move(joined);
    }
  }

  bool violated(Verdict& verdict) {
    const int first = static_cast<int>(obligations_.size()) - 1;
    BitTrace trace;
    for (const Latch& latch : system_.latches) trace.initial.push_back(latch.init == LatchInit::One);
    for (const Lit l : obligations_[first].state.latches)
      trace.initial[system_.position[variableOf(l)]] = !isNegative(l);
    for (int i = first; i >= 0; i = obligations_[i].successor) trace.inputs.push_back(obligations_[i].state.inputs);
    CHECK(isViolation(system_, trace), "an IC3 run does not violate the property");
    verdict.answer = Answer::Violated;
    verdict.depth = static_cast<int>(trace.inputs.size()) - 1;
    verdict.trace = std::move(trace);
    return true;
  }

  const BitSystem& system_;
  const EngineOptions options_;
  Ic3Frames frames_;
  std::vector<Obligation> obligations_;
};

}  // namespace

std::unique_ptr<Engine> makeIc3(const BitSystem& system, const EngineOptions& options) {
  return std::make_unique<Ic3>(system, options);
}

}  // namespace rungproof
