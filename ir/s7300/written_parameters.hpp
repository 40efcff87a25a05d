// Which parameters a block writes whatever way it takes: an output of an FC that is written hands out what the block
// wrote, and nothing else (Choice::UnwrittenOutput). Tested by tests/step7/unwritten_output_test.cpp.
#pragma once

#include <vector>

#include "ir/flow.hpp"

namespace rungproof::s7300 {

/// By number in Pou::locals. = and T write, S and R need not; a block that is called with the parameter may leave it
/// alone. Of a jump both ways count.
std::vector<bool> writtenParameters(const Flow& flow);

}  // namespace rungproof::s7300
