// From statements of an S7-300/400 to a drawing: bit logic with its parentheses, OR of AND groups, comparisons in
// parentheses, edges, coils, timers and counters as coils, boxes with EN and ENO, and the temporary bits by which the
// LAD/FBD compiler writes branches (003:1213, 003:1292; the compiler's ways are general knowledge). What else stands
// there has no picture. Tested by tests/drawing/raise_step7_test.cpp.
#pragma once

#include "analysis/drawing/raise.hpp"

namespace rungproof {

/// As raise(); contacts and coils of the drawing keep the instruction that they were.
Raised raiseStep7(const Network& network, Form form);

}  // namespace rungproof
