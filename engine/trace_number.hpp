// The value in a cell of a trace. It holds every number of 64 bits exactly: LINT, ULINT, LWORD and LREAL.
// Covered by tests/iec/long_cell_test.cpp.
#pragma once

#include <limits>

namespace rungproof {

using TraceNumber = long double;
static_assert(std::numeric_limits<TraceNumber>::digits >= 64);

}  // namespace rungproof
