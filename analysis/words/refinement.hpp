// Refinement: a set of states that was to lead somewhere holds a reached state that does not lead there. Some predicate
// must tell that state from the one which does. Taken are those that tell most sampled states in the set from it, the
// simplest first; where none tells them all, also comparisons from the goal itself, carried back through the scan with
// the inputs of the step.
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
  /// Comparisons over states that decide `goal` in that state with those inputs: where all of them have the same
  /// values, so has the goal.
  std::vector<Node> carriedBack(const WordState& state, const std::vector<std::uint64_t>& inputs, Node goal);

 private:
  struct Candidate {
    Node node;
    std::vector<std::uint64_t> samples;  ///< its value in the sampled states, 64 to a number
  };
  bool add(const std::vector<Node>& nodes, std::size_t most);

  WordCone& cone_;
  Predicates& predicates_;
  std::vector<Candidate> store_;  ///< simplest first
};

}  // namespace rungproof
