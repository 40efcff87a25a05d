// What of recorded code is needed: stores that are overwritten before anybody reads fall away, and so does everything
// whose value nobody uses. Covered by tests/compiled.
#pragma once

#include <vector>

#include "engine/compiled/code.hpp"

namespace rungproof::compiled {

/// By step: whether it is needed. `registers`: how many there are.
std::vector<bool> neededSteps(const Code& code, std::size_t registers);

}  // namespace rungproof::compiled
