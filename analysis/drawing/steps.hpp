// Lowering step by step, in the order of the elements: every value that is not used at once waits in a bit of L60 to
// L63. Takes every drawing that lowerAlongBranches cannot follow, as long as 32 waiting values are enough.
// Tested by tests/drawing/lower_test.cpp.
#pragma once

#include "analysis/drawing/circuit.hpp"

namespace rungproof {

Lowered lowerStepByStep(const Drawing& drawing, const Circuit& circuit, EditorBits taken);

}  // namespace rungproof
