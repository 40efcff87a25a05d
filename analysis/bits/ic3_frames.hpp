// The frames of IC3: over-approximations F_0 .. F_N of the states reachable in 0 .. N scans, as clauses over the
// latches, and the SAT questions about them. Everything that talks to the solver is here; ic3.cpp has the strategy.
// Tested by tests/solver/engine_agreement_test.cpp.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "analysis/bits/bit_unrolling.hpp"

namespace rungproof {

/// A conjunction of latch literals, sorted by variable: a set of states. Its negation is a lemma.
using Cube = std::vector<Lit>;

/// A state with the inputs of the scan that starts in it.
struct Ic3State {
  Cube latches;              ///< what the inputs need of the state to lead where they led
  Cube whole;                ///< the state itself, one literal for each latch
  std::vector<bool> inputs;  ///< by input index
};

/// The budget ran out in the middle of a question; the frames are as sound as before.
struct Ic3Interrupted {};

class Ic3Frames {
 public:
  Ic3Frames(const BitSystem& system, const EngineOptions& options);

  int top() const { return static_cast<int>(frames_.size()) - 1; }
  void addFrame() { frames_.emplace_back(); }
  const std::vector<Cube>& lemmas(int level) const { return frames_[level]; }
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
  bool isBlocked(const Cube& cube, int level) const;
  /// Pushes lemmas to higher frames; the level whose frame became inductive, if any.
  std::optional<int> propagate();
  double activity(Lit l) const { return activity_[variableOf(l)]; }

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
  std::vector<LatchInit> init_;            ///< by variable
  std::vector<std::vector<Cube>> frames_;  ///< by level: lemmas that hold up to this level and not (known) above
  std::vector<double> activity_;           ///< by variable: how often in recent lemmas
  double bump_ = 1.0;

  std::unique_ptr<Sat> sat_;
  std::unique_ptr<BitCnf> cnf_;
  std::vector<int> frameLiterals_;  ///< by level: assumed to switch the lemmas of that level on
  std::unique_ptr<Sat> lift_;       ///< the scan alone, without lemmas
  std::unique_ptr<BitCnf> liftCnf_;
  std::vector<int> assumptions_;
  std::size_t asserted_ = 0;  ///< clauses given to sat_, for rebuilding it in time
};

bool subsumes(const Cube& general, const Cube& special);

}  // namespace rungproof
