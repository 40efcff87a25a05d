// The frames of IC3 as clauses over the latches, and the SAT questions about them. Everything that talks to the solver
// is here; ic3.cpp has the strategy.
// Tested by tests/solver/engine_agreement_test.cpp.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "analysis/bits/bit_unrolling.hpp"
#include "analysis/bits/lemma_frames.hpp"

namespace rungproof {

/// A state with the inputs of the scan that starts in it.
struct Ic3State {
  Cube latches;              ///< what the inputs need of the state to lead where they led
  Cube whole;                ///< the state itself, one literal for each latch
  std::vector<bool> inputs;  ///< by input index
};

class Ic3Frames {
 public:
  Ic3Frames(const BitSystem& system, const EngineOptions& options);

  const LemmaFrames& lemmas() const { return frames_; }
  int top() const { return frames_.top(); }
  void addFrame() { frames_.addFrame(); }
  void setBudget(const Budget& budget) { budget_ = &budget; }

  /// Can an initial state lie in the cube? Initial values only; constraints are not looked at.
  bool meetsInitial(const Cube& cube) const;
  /// A state of F_level that is bad in its scan, with enlarged set of states in which the same inputs are bad.
  std::optional<Ic3State> findBad(int level);
  /// Is the cube unreachable from F_level & !cube (`strengthened`) or from F_level in one scan? If so, `core` is a
  /// subset of the cube with the same property, outside the initial states; otherwise predecessor() gives a state.
  bool isInductive(const Cube& cube, int level, bool strengthened, Cube* core);
  /// After isInductive(cube ...) was false: the state found, enlarged to states from which the same inputs lead
  /// into the cube.
  Ic3State predecessor(const Cube& cube);
  /// Excludes the cube from F_1 .. F_level.
  void addLemma(const Cube& cube, int level);
  /// Pushes lemmas to higher frames; the level whose frame became inductive, if any.
  std::optional<int> propagate();

 private:
  void build();
  Sat::Outcome solve(std::span<const int> assumptions, std::span<const int> temporary);
  int next(Lit latchLiteral);
  int current(Lit latchLiteral) { return cnf_->literal(unrolling_.at(0, latchLiteral)); }
  void assumeFrame(int level);
  Ic3State model();
  void enlarge(Ic3State& state, std::vector<int> goal);
  void assertLemma(const Cube& cube, int level);

  const BitSystem& system_;
  const EngineOptions& options_;
  const Budget* budget_ = nullptr;
  Unrolling unrolling_;
  Lit bad_ = falseLit;
  std::vector<LatchInit> init_;  ///< by variable
  LemmaFrames frames_;

  std::unique_ptr<Sat> sat_;
  std::unique_ptr<BitCnf> cnf_;
  std::vector<int> frameLiterals_;  ///< by level: assumed to switch the lemmas of that level on
  std::unique_ptr<Sat> lift_;       ///< the scan alone, without lemmas
  std::unique_ptr<BitCnf> liftCnf_;
  std::vector<int> assumptions_;
  std::size_t asserted_ = 0;  ///< clauses given to sat_, for rebuilding it in time
};

}  // namespace rungproof
