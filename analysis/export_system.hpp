// A transition system with its questions in the formats of other model checkers: AIGER 1.9 (ascii, bits), BTOR2 and
// SMT-LIB 2 (words). REAL operations become free inputs.
#pragma once

#include <string>

#include "analysis/transition_system.hpp"

namespace rungproof {

std::string exportAiger(const TransitionSystem& system);
std::string exportBtor2(const TransitionSystem& system);
/// One scan as definitions, state |name@0| and next state |name@1|, from an initial state; for each question,
/// between push and pop, whether it can be bad in the first scan.
std::string exportSmt2(const TransitionSystem& system);

}  // namespace rungproof
