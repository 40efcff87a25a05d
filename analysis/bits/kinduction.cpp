// k-induction: no run of k good scans, from any state that satisfies the known invariants, is followed by a bad
// scan, and the first k scans are good. With simple path the states on the way differ pairwise, which makes the
// method complete; differences are required only between states that a counterexample made equal.
// Tested by tests/solver/engine_agreement_test.cpp.
#include "analysis/bits/bmc.hpp"

namespace rungproof {

namespace {

class KInduction final : public Engine {
 public:
  KInduction(const BitSystem& system, const EngineOptions& options)
      : system_(system),
        options_(options),
        base_(system),
        unrolling_(system, Unrolling::Start::Any),
        sat_(Sat::Use::Few),
        cnf_(unrolling_.graph(), sat_) {}

  bool isExhausted() const override { return k_ >= options_.bound; }

  Verdict advance(const Budget& budget) override {
    while (k_ < options_.bound && !budget.isExhausted()) {
      if (!opened_) open();
      const Sat::Outcome outcome = step(budget);
      if (outcome == Sat::Outcome::Unknown) break;
      Verdict verdict = base_.search(outcome == Sat::Outcome::Unsatisfiable ? k_ : k_ + 1, budget);
      verdict.method = "k-induction";
      if (verdict.answer == Answer::Violated) return verdict;
      if (outcome == Sat::Outcome::Unsatisfiable) {
        if (base_.depth() < k_) return verdict;
        verdict.answer = Answer::Proved;
        verdict.certificate = Certificate{};
        verdict.certificate->k = k_;
        verdict.certificate->simplePath = different_;
        return verdict;
      }
      if (bad_ != falseLit) sat_.add({-cnf_.literal(bad_)});
      opened_ = false;
      ++k_;
    }
    Verdict verdict;
    verdict.method = "k-induction";
    verdict.depth = base_.depth();
    return verdict;
  }

 private:
  void open() {
    opened_ = true;
    for (const Lit constraint : system_.constraints) sat_.add({cnf_.literal(unrolling_.at(k_, constraint))});
    for (const std::vector<Lit>& clause : options_.invariants) {
      std::vector<int> literals;
      for (const Lit l : clause) literals.push_back(cnf_.literal(unrolling_.at(k_, l)));
      sat_.add(literals);
    }
    bad_ = falseLit;
    for (const Lit bad : system_.bads) bad_ = unrolling_.graph().addOr(bad_, unrolling_.at(k_, bad));
  }

  Sat::Outcome step(const Budget& budget) {
    if (bad_ == falseLit) return Sat::Outcome::Unsatisfiable;
    const int bad = cnf_.literal(bad_);
    for (;;) {
      const Sat::Outcome outcome = sat_.solve({bad}, budget);
      if (outcome != Sat::Outcome::Satisfiable || !options_.simplePath || !separateEqualStates()) return outcome;
    }
  }

  /// Requires a difference between the first two equal states of the model; false if there are none.
  bool separateEqualStates() {
    std::vector<std::vector<bool>> states;
    for (int frame = 0; frame <= k_; ++frame) {
      std::vector<bool> state;
      for (const Latch& latch : system_.latches)
        state.push_back(cnf_.value(unrolling_.at(frame, positive(latch.variable))));
      for (int earlier = 0; earlier < frame; ++earlier) {
        if (states[earlier] != state) continue;
        std::vector<Lit> differences;
        for (const Latch& latch : system_.latches) {
          const Lit l = positive(latch.variable);
          differences.push_back(unrolling_.graph().addXor(unrolling_.at(earlier, l), unrolling_.at(frame, l)));
        }
        std::vector<int> clause;
        for (const Lit l : differences) clause.push_back(cnf_.literal(l));
        sat_.add(clause);
        different_ = true;
        return true;
      }
      states.push_back(std::move(state));
    }
    return false;
  }

  const BitSystem& system_;
  const EngineOptions options_;
  BmcSearch base_;
  Unrolling unrolling_;
  Sat sat_;
  BitCnf cnf_;
  int k_ = 0;
  bool opened_ = false;     ///< frame k_ has its constraints, invariants and bad_
  bool different_ = false;  ///< simple-path clauses have been added
  Lit bad_ = falseLit;
};

}  // namespace

std::unique_ptr<Engine> makeKInduction(const BitSystem& system, const EngineOptions& options) {
  return std::make_unique<KInduction>(system, options);
}

}  // namespace rungproof
