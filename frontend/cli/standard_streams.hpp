// The streams of this process, for a run of the program.
#pragma once

#include "frontend/cli/cli.hpp"

namespace rungproof {

Streams standardStreams();

}  // namespace rungproof
