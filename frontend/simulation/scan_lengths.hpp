// The lengths of scans that --scan-time and --seed ask for. Tested by tests/tables/player_test.cpp.
#pragma once

#include "engine/testing/scan_length.hpp"
#include "frontend/settings/options.hpp"

namespace rungproof {

/// One value, or anything in the range; whole milliseconds where both ends are. No scan is longer than a minute.
ScanLength scanLengthsOf(const ScanTime& range, std::uint64_t seed);

}  // namespace rungproof
