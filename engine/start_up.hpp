// The state of the machine at its start: power-up with and without retained data, and the change from STOP to RUN
// (001:1623-1625, 001:14045-14056, state at the first scan: 001:6552-6554, 001:4028-4030, 001:5295).
// Covered by tests/engine/mode_test.cpp.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "engine/concrete.hpp"
#include "ir/retentive_range.hpp"

namespace rungproof {

/// What the CPU keeps where the project says nothing.
std::vector<RetentiveRange> defaultRetentiveRanges(const Target& target);
/// What of a program keeps its value: `given` by the project or that of the CPU, as far as its family can keep it
/// (MemoryModel::retentive).
std::vector<RetentiveRange> retentiveRanges(const Program& program,
                                            const std::optional<std::vector<RetentiveRange>>& given);

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
/// (001:4360). An S7-300/400 makes a warm restart: what is not retentive is as after a download (002:1367-1375).
void enterRun(const Plan& plan, Concrete::Store& store, const Choices& choices,
              const std::vector<RetentiveRange>& ranges);

/// What of a retentive timer or counter is kept: the current value; of numbered elements all but the edges that their
/// instructions have seen.
std::span<const Reg> retainedRegisters(Area area, Counting counting);
/// Whether V, M, DB, T or C cell `index` (byte or number) is in one of the ranges.
bool isRetentive(const std::vector<RetentiveRange>& ranges, Area area, std::uint32_t index);

}  // namespace rungproof
