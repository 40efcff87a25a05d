// The lengths of scans that --scan-time and --seed ask for. Tested by tests/tables/player_test.cpp.
#pragma once

#include "engine/testing/scan_length.hpp"
#include "frontend/settings/options.hpp"
#include "ir/program.hpp"

namespace rungproof {

/// Of scans of which nothing is said.
inline constexpr ScanTime tenMilliseconds{std::chrono::milliseconds(10), std::chrono::milliseconds(10)};

/// One value, or anything in the range; whole milliseconds where both ends are. No scan is longer than a minute.
ScanLength scanLengthsOf(const ScanTime& range, std::uint64_t seed);

/// How long the scans of a run are: what the settings say, otherwise the interval of the program's task, or `usual`
/// where it has none.
ScanTime scanTimeFor(const Settings& settings, const Program& program, ScanTime usual = tenMilliseconds);

}  // namespace rungproof
