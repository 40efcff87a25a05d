// The frames of IC3 as such, whatever its cubes speak about: over-approximations F_0 .. F_N of the states reachable in
// 0 .. N scans, each the lemmas of its level and of those above. The literals of a cube are latches (ic3_frames.hpp) or
// predicates (analysis/words/word_frames.hpp). Tested by tests/solver/lemma_frames_test.cpp.
#pragma once

#include <algorithm>
#include <optional>
#include <vector>

#include "analysis/bits/bit_system.hpp"

namespace rungproof {

/// A conjunction of literals, sorted by variable: a set of states. Its negation is a lemma.
using Cube = std::vector<Lit>;

/// Whether every state of `special` lies in `general`.
bool subsumes(const Cube& general, const Cube& special);

/// The budget ran out in the middle of a question; the frames are as sound as before.
struct Ic3Interrupted {};

class LemmaFrames {
 public:
  /// F_0 alone.
  LemmaFrames() : frames_(1) {}

  int top() const { return static_cast<int>(frames_.size()) - 1; }
  void addFrame() { frames_.emplace_back(); }
  /// Lemmas that hold up to this level and not (known) above.
  const std::vector<Cube>& at(int level) const { return frames_[static_cast<std::size_t>(level)]; }
  /// Lemmas of all levels from 1 on.
  std::size_t size() const;
  /// Lemmas that hold above `level`: an inductive invariant, if propagate() gave that level.
  std::vector<Cube> above(int level) const;

  /// Excludes the cube from F_1 .. F_level; lemmas that say less are forgotten.
  void add(const Cube& cube, int level);
  bool isBlocked(const Cube& cube, int level) const;
  /// How often a variable was in recent lemmas.
  double activity(Lit l) const { return variableOf(l) < activity_.size() ? activity_[variableOf(l)] : 0; }

  /// Pushes lemmas to higher frames: pushed(lemma, level) gives the part of the lemma that holds one level higher, if
  /// any, and add(core, level) takes it in. The level whose frame became inductive, if any.
  template <class Pushed, class Add>
  std::optional<int> propagate(Pushed&& pushed, Add&& add) {
    for (int level = 1; level < top(); ++level) {
      const std::vector<Cube> before = at(level);
      for (const Cube& lemma : before) {
        if (std::ranges::find(at(level), lemma) == at(level).end()) continue;
        if (const std::optional<Cube> core = pushed(lemma, level)) add(*core, level + 1);
      }
      if (at(level).empty()) return level;
    }
    return std::nullopt;
  }

 private:
  std::vector<std::vector<Cube>> frames_;
  std::vector<double> activity_;  ///< by variable
  double bump_ = 1;
};

}  // namespace rungproof
