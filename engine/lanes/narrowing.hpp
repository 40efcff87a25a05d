// Sums that instructions make exact in twice their width, only to see whether they fit, are made in their own width:
// there an overflow shows in the signs. Vector instructions take twice as many registers for twice the width.
#pragma once

#include "engine/compiled/code.hpp"

namespace rungproof::lanes {

/// The same code, some of whose values are no longer needed (engine/compiled/reduce.hpp).
compiled::Code narrowedSums(const compiled::Code& code);

}  // namespace rungproof::lanes
