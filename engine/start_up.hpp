// The state of the machine at its start: power-up with and without retained data, and the change from STOP to RUN
// (001:1623-1625, 001:14045-14056, state at the first scan: 001:6552-6554, 001:4028-4030, 001:5295).
// Covered by tests/engine/mode_test.cpp.
#pragma once

#include <vector>

#include "engine/concrete.hpp"

namespace rungproof {

/// Bytes of V or M, or numbers of T or C, first to last, that keep their values without power (001:1534).
struct RetentiveRange {
  Area area;
  std::uint32_t first;
  std::uint32_t last;
};
/// The manual gives no default for V, T and C; taken are those that the programming software sets: all of V, MB14-MB31,
/// the TONR timers, all counters. MB0-MB13 are not retentive (001:1619).
std::vector<RetentiveRange> defaultRetentiveRanges(const Target& target);

/// Puts the time bases of the 10 ms and 100 ms timers `phase` ms behind a tick of both.
void setTickPhase(Concrete::Store& store, std::uint32_t phase);

/// State after a download and power-up into RUN: everything 0, V from the data block, status bits as the first scan
/// shows them. `dataLost` sets SM0.2 as after a loss of retained data (001:14052).
Concrete::Store powerUpState(const Plan& plan, const Choices& choices, bool dataLost = false);

/// The same after power was off: cells of `ranges` keep the value they have in `before` (001:1624). Timers and
/// counters keep their current values, never their bits.
Concrete::Store powerCycledState(const Plan& plan, const Choices& choices, const Concrete::Store& before,
                                 const std::vector<RetentiveRange>& ranges);

/// Entering RUN without loss of power: V, M and retentive current values stay; edges, devices and interrupts start
/// anew; the time bases run on. What is cleared is not in the manual text except for interrupts (001:5333) and HDEF
/// (001:4360).
void enterRun(const Plan& plan, Concrete::Store& store, const Choices& choices,
              const std::vector<RetentiveRange>& ranges);

/// Whether V, M, T or C cell `index` (byte or number) is in one of the ranges.
bool isRetentive(const std::vector<RetentiveRange>& ranges, Area area, std::uint32_t index);

}  // namespace rungproof
