// Compares an actual trace with an expected one and gives the first difference.
// Covered by tests/trace/comparison_test.cpp.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <unordered_map>
#include <vector>

#include "engine/trace.hpp"

namespace rungproof {

/// How far a numeric signal may be off.
struct Tolerance {
  std::string signal;
  double value;
};

struct CompareOptions {
  std::vector<Tolerance> tolerances;
  unsigned slack = 0;  ///< an expected value may come up to so many scans earlier or later
};

/// The first expected value that the actual trace does not show.
struct TraceDifference {
  std::size_t expectedRow = 0;
  std::optional<std::size_t> actualRow;  ///< nothing: the actual trace ends before
  std::size_t expectedSignal = 0;        ///< index in the expected trace
  std::uint64_t scan = 0;
  std::uint64_t timeUs = 0;
  TraceNumber expected = 0;
  std::optional<TraceNumber> actual;  ///< nothing: the actual trace has no value there
};

/// The signals of a trace by address and name: what Trace::indexOf() says, without a look at each of them.
class SignalIndex {
 public:
  explicit SignalIndex(const Trace& trace);
  int indexOf(const TraceSignal& signal) const;
  int signalNamed(std::string_view name) const;

 private:
  using Place = std::tuple<Area, decltype(Operand::offset), decltype(Operand::bit), Width>;
  std::map<Place, int> byPlace_;
  std::unordered_map<std::string, int> byName_, bySymbol_;  ///< in capitals
};

/// Signals of the expected trace that the actual one lacks.
std::vector<std::string> missingSignals(const Trace& expected, const Trace& actual);

/// The row of `actual` that belongs to a row of `expected`: the same scan, or the scan in which the time falls. A scan
/// bears the time of its end, which is its own, and that of its beginning is the end of the scan before (at 0 the first
/// one begins). What a logger saw at the beginning of a scan belongs to that scan. Nothing: beyond the end.
std::optional<std::size_t> matchingRow(const Trace& expected, std::size_t expectedRow, const Trace& actual);

/// Expected values that the actual trace does not show, in the order of the expected rows, at most so many.
std::vector<TraceDifference> differences(const Trace& expected, const Trace& actual, const CompareOptions& options,
                                         std::size_t most);
/// Nothing: every expected value is there. Signals are matched by name; missing ones are passed over.
std::optional<TraceDifference> firstDifference(const Trace& expected, const Trace& actual,
                                               const CompareOptions& options);

}  // namespace rungproof
