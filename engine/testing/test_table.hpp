// A test table: tests with their steps, what each sets, how long it waits and what is then expected. A new test begins
// with power-on. Read by frontend/testing/table_reader, made by analysis/testing. Covered by tests/tables.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "engine/stimulus.hpp"

namespace rungproof {

/// How long a step lasts: scans, or the least number of scans that is not shorter than a time.
struct TestWait {
  std::uint64_t scans = 1;  ///< counts if timeUs is 0
  std::uint64_t timeUs = 0;

  bool isTime() const { return timeUs != 0; }
};
/// "1 scan", "5 scans", "500ms".
std::string waitText(const TestWait& wait);

/// An expected value: all from low to high.
struct TestRange {
  TraceNumber low = 0, high = 0;

  /// No number of a REAL is expected where both ends are none.
  bool isNone() const { return low != low && high != high; }
  bool holds(TraceNumber value) const { return isNone() ? value != value : low <= value && value <= high; }
};
std::string rangeText(const TestRange& range, SignalType type);

struct TestRow {
  std::string step{};  ///< text
  TestWait wait{};
  std::vector<std::optional<TraceNumber>> sets{};   ///< by column; nothing: keeps its value
  std::vector<std::optional<TestRange>> expects{};  ///< by column; nothing: any value
  std::string note{};
  std::uint32_t line = 0;  ///< in the file, from 1
};

struct TestCase {
  std::string name;
  std::vector<TestRow> rows;
};

/// As steps and sheets name it: "Start (I0.0)", or its name where the program has none for it.
std::string signalText(const TraceSignal& signal);

struct TestTable {
  std::string file;
  std::vector<StimulusColumn> sets;
  std::vector<TraceSignal> expects;
  std::vector<TestCase> tests;

  bool expectsAnything() const;
};

}  // namespace rungproof
