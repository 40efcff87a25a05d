// Blocks without text in a comparison. What a block does that a password protects, or that no file holds, is any value
// within its contract (ir/s7200/call_contract.hpp). That says nothing about a block whose instructions the other
// program shows, nor about a call that only one program makes: then equality is open. Tested by
// tests/equivalence/undefined_test.cpp.
#pragma once

#include <string>
#include <vector>

#include "ir/program.hpp"

namespace rungproof {

/// Why nothing can be said about what both programs do, one line for each block; empty: no such block is in the way.
/// Both without what may not be run (UnreadCode::executable).
std::vector<std::string> hiddenInOneOnly(const Program& before, const Program& after);

}  // namespace rungproof
