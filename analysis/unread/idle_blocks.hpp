// Idle data blocks of an S7-300/400: those that no statement can open and no question names. Whatever they hold, a
// proof is the same without them, and need not carry recipes of megabytes from state to state.
// Tested by tests/prover/idle_block_test.cpp.
#pragma once

#include "analysis/property.hpp"
#include "ir/program.hpp"

namespace rungproof {

/// Takes idle data blocks out of the program; none where a number that the program computes may open one.
void leaveOutIdleBlocks(Program& program, const PropertySet& set);

}  // namespace rungproof
