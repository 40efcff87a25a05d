// A scan as it would be with the program's memory at rest: whether old memory is the cause of what an output does. A
// start button that is held down is no old memory. For the rules about power-up and restarts, by whose examples it is
// tested.
#pragma once

#include <map>

#include "analysis/encoding/encoder.hpp"
#include "analysis/graph/substitution.hpp"

namespace rungproof {

/// Values of the end of a scan as they would be with the program's memory at its start as power-up leaves it, and the
/// same inputs.
Substitution restedScan(EncodedScan& encoding);

/// Output bits with the first instruction that drives them.
std::map<Place, const Instruction*> outputsOf(const EncodedScan& encoding);

}  // namespace rungproof
