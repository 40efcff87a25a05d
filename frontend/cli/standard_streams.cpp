// Streams, and whether a terminal stands behind them.
#include "frontend/cli/standard_streams.hpp"

#include <iostream>

#include "engine/platform/console.hpp"

namespace rungproof {

Streams standardStreams() { return {std::cin, std::cout, std::cerr, isTerminal(Stream::Out), isTerminal(Stream::Err)}; }

}  // namespace rungproof
