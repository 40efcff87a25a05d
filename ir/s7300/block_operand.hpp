// Operands of a call that are a data block itself: its instance, and what it gives for a BLOCK_DB (002:1972-1978). They
// look like the first byte of the block and are no access to it. Tested by tests/step7/parameter_kind_test.cpp.
#pragma once

#include <cstddef>

#include "ir/program.hpp"

namespace rungproof {

bool isBlockOperand(const Program& program, const Instruction& call, std::size_t operand);

}  // namespace rungproof
