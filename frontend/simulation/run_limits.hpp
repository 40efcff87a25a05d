// How long a run of `sim` may be, and how much of it can be kept. Tested by tests/trace/sim_command_test.cpp.
#pragma once

#include <cstdint>
#include <optional>

#include "engine/trace.hpp"
#include "frontend/files/failure.hpp"

namespace rungproof {

/// A day and more at one scan a millisecond.
inline constexpr std::uint64_t mostScans = 100'000'000;

/// Of the rows of a trace that is kept until it is written.
inline constexpr std::uint64_t mostTraceBytes = 2'000'000'000;

/// Why a run of so many scans is not made: too many of them, or more than `memory` bytes for the rows of its trace, of
/// which 0 are kept if `signals` is 0.
std::optional<Failure> refusedRun(std::uint64_t scans, std::size_t signals, std::uint64_t memory);

}  // namespace rungproof
