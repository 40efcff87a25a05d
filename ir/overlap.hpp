// Whether two direct operands share memory. A timer or counter is one thing under both its bit and its value.
// Tested by tests/ir/overlap_test.cpp.
#pragma once

#include "ir/operand.hpp"

namespace rungproof {

/// False unless both are direct.
bool overlaps(const Operand& a, const Operand& b);

}  // namespace rungproof
