// Actuals of FCs that lie in a data block and that the FC, or what interrupts it, reaches by another way too. The
// parameter is passed by reference (002:154); with a full address the call may pass a copy instead, which is taken back
// at its end (general knowledge). Only with such a second way do the two differ. Tested by
// tests/step7/block_actuals_test.cpp.
#pragma once

#include <string>
#include <vector>

#include "analysis/flow/facts.hpp"

namespace rungproof {

/// Whether some call of an FC has an actual with a full address in a data block.
bool givesBlockActuals(const Program& program);
/// What is assumed of such calls, one line for each FC and way.
std::vector<std::string> assumptionsOfActuals(const Facts& facts);

}  // namespace rungproof
