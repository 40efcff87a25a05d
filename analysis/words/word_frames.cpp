// One solver holds the scan and the lemmas; a second one, with the scan alone, finds out what a step depends on.
#include "analysis/words/word_frames.hpp"

#include <algorithm>

#include "analysis/bits/bit_blast.hpp"
#include "ir/check.hpp"

namespace rungproof {

WordFrames::WordFrames(WordCone& cone, Predicates& predicates, BitBlast* blast) : cone_(cone), predicates_(predicates) {
  const auto make = [&] { return blast != nullptr ? makeBitSolver(*blast) : makeTermSolver(cone.graph()); };
  frame_ = make();
  lift_ = make();
  for (const Node n : cone.system().constraints) {
    const int clause[] = {frame_->literal(n)};
    frame_->add(clause);
  }
  frameLiterals_.push_back(frame_->newLiteral());
  initial_ = lift_->newLiteral();
  for (const StateVariable& state : cone.system().states) {
    if (state.init == noNode) continue;
    const Node isInitial = cone.graph().make(Op::Equal, 1, state.node, state.init);
    const int inFrame[] = {-frameLiterals_[0], frame_->literal(isInitial)};
    frame_->add(inFrame);
    const int inLift[] = {-initial_, lift_->literal(isInitial)};
    lift_->add(inLift);
  }
}

Sat::Outcome WordFrames::solve(WordSolver& solver, const std::vector<int>& assumptions,
                               std::span<const int> temporary) {
  ++queries_;
  const Sat::Outcome outcome = solver.solve(assumptions, *budget_, temporary);
  if (outcome == Sat::Outcome::Unknown) throw Ic3Interrupted{};
  return outcome;
}

std::optional<WordState> WordFrames::initialIn(const WordCube& cube) {
  for (const Lit l : cube) {
    const std::optional<bool>& initially = predicates_.of(l).initially;
    if (initially && *initially == isNegative(l)) return std::nullopt;
  }
  std::vector<int> assumptions{initial_};
  for (const Lit l : cube) assumptions.push_back(lift_->literal(predicates_.now(l)));
  if (solve(*lift_, assumptions) == Sat::Outcome::Unsatisfiable) return std::nullopt;
  WordState state;
  for (const StateVariable& variable : cone_.system().states) state.push_back(lift_->value(variable.node));
  return state;
}

void WordFrames::assumeFrame(int level) {
  assumptions_.clear();
  while (static_cast<int>(frameLiterals_.size()) <= top()) frameLiterals_.push_back(frame_->newLiteral());
  if (level == 0) assumptions_.push_back(frameLiterals_[0]);
  for (int i = std::max(level, 1); i <= top(); ++i) assumptions_.push_back(frameLiterals_[static_cast<std::size_t>(i)]);
}

std::vector<std::uint64_t> WordFrames::modelInputs(WordSolver& solver) const {
  std::vector<std::uint64_t> inputs;
  for (const Node n : cone_.system().inputs) inputs.push_back(solver.value(n));
  return inputs;
}

std::vector<int> WordFrames::goalOf(const WordCube& cube) {
  std::vector<int> goal;
  for (const Lit l : cube) goal.push_back(lift_->literal(predicates_.next(l)));
  return goal;
}

WordStep WordFrames::model(std::vector<int> goal) {
  WordStep step;
  for (const StateVariable& variable : cone_.system().states) step.state.push_back(frame_->value(variable.node));
  step.inputs = modelInputs(*frame_);
  generaliseStep(step, std::move(goal));
  return step;
}

/// The predicates that matter for reaching the goal with these inputs: a core if they suffice, else also all predicates
/// about words whose very values matter.
void WordFrames::generaliseStep(WordStep& step, std::vector<int> goal) {
  for (const Node n : cone_.system().constraints) goal.push_back(lift_->literal(n));
  for (int& l : goal) l = -l;
  std::vector<Node> nodes;
  for (std::size_t i = 0; i < predicates_.size(); ++i) nodes.push_back(predicates_[i].now);
  const std::vector<bool> values = predicates_.valuesIn(step.state, nodes);
  WordCube whole;
  for (std::size_t i = 0; i < values.size(); ++i)
    whole.push_back(positive(static_cast<std::uint32_t>(i)) ^ (values[i] ? 0U : 1U));
  std::vector<int> assumptions;
  for (std::size_t i = 0; i < step.inputs.size(); ++i)
    lift_->fix(cone_.system().inputs[i], step.inputs[i], assumptions);
  std::vector<int> literals;
  for (const Lit l : whole) literals.push_back(lift_->literal(predicates_.now(l)));
  assumptions.insert(assumptions.end(), literals.begin(), literals.end());
  const auto core = [&] {
    WordCube kept;
    for (std::size_t i = 0; i < whole.size(); ++i) {
      if (lift_->failed(literals[i])) kept.push_back(whole[i]);
    }
    return kept;
  };
  if (solve(*lift_, assumptions, goal) == Sat::Outcome::Unsatisfiable) {
    step.cube = core();
    return;
  }
  if (wholeCubes_) {
    step.cube = std::move(whole);
    return;
  }
  std::vector<std::vector<int>> valueLiterals(step.state.size());
  for (std::size_t i = 0; i < step.state.size(); ++i) {
    lift_->fix(cone_.system().states[i].node, step.state[i], valueLiterals[i]);
    assumptions.insert(assumptions.end(), valueLiterals[i].begin(), valueLiterals[i].end());
  }
  if (solve(*lift_, assumptions, goal) != Sat::Outcome::Unsatisfiable) {
    // Only a solver that lacks the exact meaning of an operation gets here.
    step.cube = std::move(whole);
    return;
  }
  std::vector<bool> matters(step.state.size(), false);
  for (std::size_t i = 0; i < matters.size(); ++i) {
    matters[i] = std::ranges::any_of(valueLiterals[i], [&](int l) { return lift_->failed(l); });
  }
  for (std::size_t i = 0; i < whole.size(); ++i) {
    const std::vector<std::uint32_t>& words = predicates_.of(whole[i]).words;
    if (lift_->failed(literals[i]) || std::ranges::any_of(words, [&](std::uint32_t w) { return matters[w]; }))
      step.cube.push_back(whole[i]);
  }
}

std::optional<WordStep> WordFrames::findBad(int level) {
  assumeFrame(level);
  assumptions_.push_back(frame_->literal(cone_.bad()));
  if (solve(*frame_, assumptions_) == Sat::Outcome::Unsatisfiable) return std::nullopt;
  return model({lift_->literal(cone_.bad())});
}

bool WordFrames::isInductive(const WordCube& cube, int level, bool strengthened, WordCube* core) {
  assumeFrame(level);
  for (const Lit l : cube) assumptions_.push_back(next(l));
  std::vector<int> temporary;
  if (strengthened) {
    for (const Lit l : cube) temporary.push_back(-now(l));
  }
  if (solve(*frame_, assumptions_, temporary) == Sat::Outcome::Satisfiable) return false;
  if (core == nullptr) return true;
  WordCube kept;
  for (const Lit l : cube) {
    if (frame_->failed(next(l))) kept.push_back(l);
  }
  // The core must stay outside the initial states.
  for (const Lit l : cube) {
    if (!initialIn(kept)) break;
    if (!std::ranges::binary_search(kept, l)) kept.insert(std::ranges::lower_bound(kept, l), l);
  }
  *core = std::move(kept);
  return true;
}

WordStep WordFrames::step(const WordCube& cube) { return model(goalOf(cube)); }

std::optional<std::vector<std::uint64_t>> WordFrames::inputsBetween(const WordState& from, const WordCube* to) {
  std::vector<int> assumptions;
  for (const Node n : cone_.system().constraints) assumptions.push_back(lift_->literal(n));
  if (to == nullptr)
    assumptions.push_back(lift_->literal(cone_.bad()));
  else {
    const std::vector<int> goal = goalOf(*to);
    assumptions.insert(assumptions.end(), goal.begin(), goal.end());
  }
  for (std::size_t i = 0; i < from.size(); ++i) lift_->fix(cone_.system().states[i].node, from[i], assumptions);
  if (solve(*lift_, assumptions) == Sat::Outcome::Unsatisfiable) return std::nullopt;
  return modelInputs(*lift_);
}

void WordFrames::addLemma(const WordCube& cube, int level) {
  frames_.add(cube, level);
  while (static_cast<int>(frameLiterals_.size()) <= level) frameLiterals_.push_back(frame_->newLiteral());
  std::vector<int> clause{-frameLiterals_[static_cast<std::size_t>(level)]};
  for (const Lit l : cube) clause.push_back(-now(l));
  frame_->add(clause);
}

std::optional<int> WordFrames::propagate() {
  return frames_.propagate(
      [&](const WordCube& lemma, int level) -> std::optional<WordCube> {
        WordCube core;
        return isInductive(lemma, level, false, &core) ? std::optional(std::move(core)) : std::nullopt;
      },
      [&](const WordCube& core, int level) { addLemma(core, level); });
}

}  // namespace rungproof
