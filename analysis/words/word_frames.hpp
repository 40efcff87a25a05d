// The frames of IC3 as clauses over predicates, and the questions about them. The scan itself is exact; only sets of
// states are abstracted. Tested
// by tests/words/word_engine_test.cpp.
#pragma once

#include <memory>

#include "analysis/bits/lemma_frames.hpp"
#include "analysis/words/predicates.hpp"
#include "analysis/words/word_solver.hpp"

namespace rungproof {

/// A state that leads to a goal with some inputs, and the set of states that stands for it.
struct WordStep {
  WordState state;
  std::vector<std::uint64_t> inputs;  ///< by input of the cone
  WordCube cube;
};

class WordFrames {
 public:
  /// `blast` (over the cone's system) serves both solvers; none: Z3 does.
  WordFrames(WordCone& cone, Predicates& predicates, BitBlast* blast);

  const LemmaFrames& lemmas() const { return frames_; }
  int top() const { return frames_.top(); }
  void addFrame() { frames_.addFrame(); }
  void setBudget(const Budget& budget) { budget_ = &budget; }
  /// Cubes of steps hold all predicates, not only those that the step needs.
  void takeWholeCubes() { wholeCubes_ = true; }

  /// An initial state inside the cube.
  std::optional<WordState> initialIn(const WordCube& cube);
  /// A state of F_level that is bad in its scan.
  std::optional<WordStep> findBad(int level);
  /// Is the cube unreachable from F_level & !cube (`strengthened`) or from F_level in one scan? If so, `core` (if
  /// given) is a subset of the cube with the same property, outside the initial states; otherwise step() gives a state.
  bool isInductive(const WordCube& cube, int level, bool strengthened, WordCube* core);
  /// After isInductive(cube ...) was false: the state found.
  WordStep step(const WordCube& cube);
  /// Inputs that lead from the state into the cube (nullptr: that make the scan bad), if there are any.
  std::optional<std::vector<std::uint64_t>> inputsBetween(const WordState& from, const WordCube* to);
  /// Excludes the cube from F_1 .. F_level.
  void addLemma(const WordCube& cube, int level);
  /// Pushes lemmas to higher frames; the level whose frame became inductive, if any.
  std::optional<int> propagate();
  /// Questions asked of the solvers so far.
  std::size_t queries() const { return queries_; }

 private:
  Sat::Outcome solve(WordSolver& solver, const std::vector<int>& assumptions, std::span<const int> temporary = {});
  void assumeFrame(int level);
  WordStep model(std::vector<int> goal);
  void generaliseStep(WordStep& step, std::vector<int> goal);
  std::vector<int> goalOf(const WordCube& cube);
  int now(Lit l) { return frame_->literal(predicates_.now(l)); }
  int next(Lit l) { return frame_->literal(predicates_.next(l)); }
  std::vector<std::uint64_t> modelInputs(WordSolver& solver) const;

  WordCone& cone_;
  Predicates& predicates_;
  std::unique_ptr<WordSolver>
      frame_;  ///< the scan, its constraints, and all lemmas, each under the literal of its level
  std::unique_ptr<WordSolver> lift_;  ///< the scan alone
  std::vector<int> frameLiterals_;    ///< by level, of frame_
  int initial_ = 0;                   ///< of lift_: the state is an initial one
  LemmaFrames frames_;
  std::vector<int> assumptions_;
  const Budget* budget_ = nullptr;
  std::size_t queries_ = 0;
  bool wholeCubes_ = false;
};

}  // namespace rungproof
