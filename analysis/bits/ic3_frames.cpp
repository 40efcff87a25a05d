// One solver holds the scan and all lemmas, each switched on by the literal of its level; a second solver, with the
// scan alone, enlarges predecessors by the core of "these inputs in these states do not lead there: impossible".
#include "analysis/bits/ic3_frames.hpp"

#include <algorithm>

#include "ir/check.hpp"

namespace rungproof {

Ic3Frames::Ic3Frames(const BitSystem& system, const EngineOptions& options)
    : system_(system),
      options_(options),
      unrolling_(system, Unrolling::Start::Any),
      init_(system.variableCount(), LatchInit::Free) {
  for (const Lit bad : system.bads) bad_ = unrolling_.graph().addOr(bad_, unrolling_.at(0, bad));
  for (const Latch& latch : system.latches) init_[latch.variable] = latch.init;
  build();
}

void Ic3Frames::build() {
  sat_ = std::make_unique<Sat>(Sat::Use::Many);
  cnf_ = std::make_unique<BitCnf>(unrolling_.graph(), *sat_);
  const bool first = lift_ == nullptr;
  if (first) {
    lift_ = std::make_unique<Sat>(Sat::Use::Many);
    liftCnf_ = std::make_unique<BitCnf>(unrolling_.graph(), *lift_);
  }
  for (const Lit constraint : system_.constraints) sat_->add({cnf_->literal(unrolling_.at(0, constraint))});
  for (const std::vector<Lit>& clause : options_.invariants) {
    std::vector<int> inFrame, inLift;
    for (const Lit l : clause) {
      inFrame.push_back(current(l));
      if (first) inLift.push_back(liftCnf_->literal(unrolling_.at(0, l)));
    }
    sat_->add(inFrame);
    if (first) lift_->add(inLift);
  }
  frameLiterals_.clear();
  asserted_ = 0;
  frameLiterals_.push_back(sat_->newVariable());
  for (const Latch& latch : system_.latches) {
    if (latch.init == LatchInit::Free) continue;
    sat_->add({-frameLiterals_[0], current(positive(latch.variable) ^ (latch.init == LatchInit::One ? 0U : 1U))});
  }
  for (int level = 1; level <= top(); ++level) {
    for (const Cube& cube : frames_.at(level)) assertLemma(cube, level);
  }
}

Sat::Outcome Ic3Frames::solve(std::span<const int> assumptions, std::span<const int> temporary) {
  const Sat::Outcome outcome = sat_->solve(assumptions, *budget_, temporary);
  if (outcome == Sat::Outcome::Unknown) throw Ic3Interrupted{};
  return outcome;
}

int Ic3Frames::next(Lit latchLiteral) {
  const Latch& latch = system_.latches[system_.position[variableOf(latchLiteral)]];
  return cnf_->literal(unrolling_.at(0, latch.next ^ (latchLiteral & 1U)));
}

bool Ic3Frames::meetsInitial(const Cube& cube) const {
  return std::none_of(cube.begin(), cube.end(), [&](Lit l) {
    const LatchInit init = init_[variableOf(l)];
    return init != LatchInit::Free && (init == LatchInit::One) == isNegative(l);
  });
}

void Ic3Frames::assumeFrame(int level) {
  assumptions_.clear();
  if (level == 0) assumptions_.push_back(frameLiterals_[0]);
  for (int i = std::max(level, 1); i < static_cast<int>(frameLiterals_.size()); ++i)
    assumptions_.push_back(frameLiterals_[i]);
}

Ic3State Ic3Frames::model() {
  Ic3State state;
  for (const Latch& latch : system_.latches) {
    const Lit l = positive(latch.variable);
    state.whole.push_back(l ^ (cnf_->value(unrolling_.at(0, l)) ? 0U : 1U));
  }
  for (const std::uint32_t v : system_.inputs) state.inputs.push_back(cnf_->value(unrolling_.at(0, positive(v))));
  state.latches = state.whole;
  return state;
}

/// Drops latches that the inputs do not need to make all `goal` literals (of the lift solver) true.
void Ic3Frames::enlarge(Ic3State& state, std::vector<int> goal) {
  for (const Lit constraint : system_.constraints) goal.push_back(liftCnf_->literal(unrolling_.at(0, constraint)));
  for (int& l : goal) l = -l;
  std::vector<int> inputs;
  for (std::size_t i = 0; i < system_.inputs.size(); ++i) {
    const int l = liftCnf_->known(unrolling_.at(0, positive(system_.inputs[i])));
    if (l != 0) inputs.push_back(state.inputs[i] ? l : -l);
  }
  for (int round = 0; round < 2; ++round) {
    std::vector<int> assumptions = inputs;
    Cube known;
    for (const Lit l : state.latches) {
      const int literal = liftCnf_->known(unrolling_.at(0, l));
      if (literal == 0) continue;
      known.push_back(l);
      assumptions.push_back(literal);
    }
    if (round == 1) std::reverse(assumptions.begin() + static_cast<std::ptrdiff_t>(inputs.size()), assumptions.end());
    const Sat::Outcome outcome = lift_->solve(assumptions, *budget_, goal);
    if (outcome == Sat::Outcome::Unknown) throw Ic3Interrupted{};
    CHECK(outcome == Sat::Outcome::Unsatisfiable, "state and inputs decide the next state");
    Cube core;
    for (const Lit l : known) {
      if (lift_->failed(liftCnf_->known(unrolling_.at(0, l)))) core.push_back(l);
    }
    const bool shrunk = core.size() < state.latches.size();
    state.latches = std::move(core);
    if (!shrunk) break;
  }
}

std::optional<Ic3State> Ic3Frames::findBad(int level) {
  if (bad_ == falseLit) return std::nullopt;
  assumeFrame(level);
  assumptions_.push_back(cnf_->literal(bad_));
  if (solve(assumptions_, {}) == Sat::Outcome::Unsatisfiable) return std::nullopt;
  Ic3State state = model();
  enlarge(state, {liftCnf_->literal(bad_)});
  return state;
}

bool Ic3Frames::isInductive(const Cube& cube, int level, bool strengthened, Cube* core) {
  assumeFrame(level);
  for (const Lit l : cube) assumptions_.push_back(next(l));
  std::vector<int> temporary;
  if (strengthened) {
    for (const Lit l : cube) temporary.push_back(-current(l));
  }
  if (solve(assumptions_, temporary) == Sat::Outcome::Satisfiable) return false;
  if (core == nullptr) return true;
  Cube kept;
  for (const Lit l : cube) {
    if (sat_->failed(next(l))) kept.push_back(l);
  }
  if (meetsInitial(kept)) {
    for (const Lit l : cube) {
      if (meetsInitial({l})) continue;
      kept.insert(std::lower_bound(kept.begin(), kept.end(), l), l);
      break;
    }
  }
  *core = std::move(kept);
  return true;
}

Ic3State Ic3Frames::predecessor(const Cube& cube) {
  Ic3State state = model();
  std::vector<int> goal;
  for (const Lit l : cube) {
    const Latch& latch = system_.latches[system_.position[variableOf(l)]];
    goal.push_back(liftCnf_->literal(unrolling_.at(0, latch.next ^ (l & 1U))));
  }
  enlarge(state, std::move(goal));
  return state;
}

void Ic3Frames::assertLemma(const Cube& cube, int level) {
  while (static_cast<int>(frameLiterals_.size()) <= level) frameLiterals_.push_back(sat_->newVariable());
  std::vector<int> clause{-frameLiterals_[level]};
  for (const Lit l : cube) clause.push_back(-current(l));
  sat_->add(clause);
  ++asserted_;
}

void Ic3Frames::addLemma(const Cube& cube, int level) {
  frames_.add(cube, level);
  if (asserted_ > 500 + 3 * frames_.size())
    build();
  else
    assertLemma(cube, level);
}

std::optional<int> Ic3Frames::propagate() {
  return frames_.propagate(
      [&](const Cube& lemma, int level) -> std::optional<Cube> {
        Cube core;
        return isInductive(lemma, level, false, &core) ? std::optional(std::move(core)) : std::nullopt;
      },
      [&](const Cube& core, int level) { addLemma(core, level); });
}

}  // namespace rungproof
