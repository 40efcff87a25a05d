// Refinement: a set of states that was to lead somewhere holds a reached state that does not lead there. Some predicate
// must tell that state from the one which does: the simplest of those that have held in all samples, else of those that
// fit the words, else a comparison from the goal itself, carried back through the scan with the inputs of the step.
// Tested by tests/words/refinement_test.cpp.
#pragma once

#include "analysis/words/word_frames.hpp"

namespace rungproof {

class Refinement {
 public:
  Refinement(WordCone& cone, Predicates& predicates);
  /// Adds predicates that tell `reached` from the state of `step`, which leads to `goal` (width 1, over states and
  /// inputs) with its inputs while `reached` does not. False: all that there are are known already.
  bool refine(const WordState& reached, const WordStep& step, Node goal);
  /// Comparisons over states that decide `goal` in that state with those inputs: where all of them have the same values,
  /// so has the goal.
  std::vector<Node> carriedBack(const WordState& state, const std::vector<std::uint64_t>& inputs, Node goal);

 private:
  struct Candidate {
    Node node;
    bool hasHeld;  ///< the same value in all samples
    bool value;    ///< that value
  };
  bool addDistinguishing(const std::vector<Node>& nodes, std::size_t most, const WordState& reached, const WordState& other);

  WordCone& cone_;
  Predicates& predicates_;
  std::vector<Candidate> store_;  ///< simplest first
};

}  // namespace rungproof
