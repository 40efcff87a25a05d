// What a person at a test bench can change and see: the inputs of a program with the values worth trying, and its
// outputs. Covered by tests/tables/generate_command_test.cpp.
#pragma once

#include <vector>

#include "analysis/property.hpp"
#include "engine/stimulus.hpp"
#include "engine/trace.hpp"

namespace rungproof {

struct TestInput {
  TraceSignal signal;
  std::vector<TraceNumber> values;  ///< 0 and 1; of a number limits that the program compares with, one below and above
};

struct TestSignals {
  std::vector<TestInput> inputs;
  std::vector<TraceSignal> outputs;
  /// Numbers that the program keeps, without those of timers.
  std::vector<TraceSignal> memory;
};

TestSignals testSignalsOf(const Program& program, const PropertySet& set);

/// Whether time decides something: timers, clocks, times of IEC 61131-3.
bool dependsOnTime(const Program& program);
/// Whether devices have a part in runs (fast counters, pulses, ports, the network, the clock), so that none can go on
/// from a kept state.
bool hasDevices(const Program& program);
/// The same, or interrupts.
bool hasEventsOrDevices(const Program& program);

}  // namespace rungproof
