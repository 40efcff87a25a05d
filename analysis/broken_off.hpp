// What is said of a question whose answer was broken off by an exception. Tested by tests/faults.
#pragma once

#include <exception>
#include <string>

namespace rungproof {

/// "ran out of memory", what the system refused, or "internal error: ...; this is a defect of rungproof".
std::string whyBrokenOff(const std::exception& error);

}  // namespace rungproof
