// Which blocks of two S7-300/400 programs are the same: does the CPU run what was approved? Blocks are matched by type
// and number. Stored ones are compared byte by byte, others statement by statement.
// Tested by tests/s7project/upload_comparison_test.cpp.
#pragma once

#include <vector>

#include "frontend/compared_block.hpp"
#include "frontend/mc7/stored_block.hpp"
#include "frontend/sides/sides.hpp"

namespace rungproof {

/// Empty where neither program has stored blocks.
std::vector<ComparedBlock> compareBlocks(const Sides& sides);

/// Why both programs do the same without a proof: each block of one is a block of the other byte by byte, and so are
/// the values that they begin with. `ignoresValues`: both begin with those of OLD.
bool areSameBlocks(const std::vector<ComparedBlock>& blocks, bool ignoresValues);

}  // namespace rungproof
