// Candidate invariants that follow from what timers are, but relate three truth values, more than random runs are
// searched for: the bit of an off-delay timer or of a pulse timer is on only while its input is, or it times
// (001:6573); a timer that may be left out has seen its input as long as it never was.
// Tested by tests/solver/invariants_test.cpp.
#pragma once

#include "analysis/portfolio/invariants_words.hpp"

namespace rungproof {

/// One clause for each timer of which bit, input and running state are state variables, one for each that counts down
/// (stopped, it has nothing left), and those of remembered inputs.
std::vector<NodeClause> guessTimerStates(const TransitionSystem& system);

}  // namespace rungproof
