// Bits that are on for one scan at a time, or in the first scan only, as the text shows it: coils behind an edge, edges
// made by hand, latches that are taken back at once, timers and counters that reset themselves.
// Tested by tests/rules/pulse_test.cpp.
#pragma once

#include "analysis/flow/facts.hpp"

namespace rungproof {

/// With what is known up to now about power flow (Facts::stack); asked again, it may know more.
KnownBits pulseBits(const Facts& facts);

}  // namespace rungproof
