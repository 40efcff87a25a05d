// Lanes in pairs.
#include "frontend/simulation/expected_lanes.hpp"

#include <algorithm>

namespace rungproof {

namespace {
constexpr std::size_t mostMarks = 10000;  ///< differences that a page shows
}  // namespace

TraceBeside besideExpected(const Trace& expected, const Trace& actual, const CompareOptions& options) {
  TraceBeside result;
  result.trace = actual;
  result.trace.signals.clear();
  for (TraceRow& row : result.trace.rows) row.values.clear();
  std::vector<std::size_t> lanes(expected.signals.size());  // of each expected signal
  for (std::size_t i = 0; i < actual.signals.size(); ++i) {
    const auto add = [&](const TraceSignal& signal, int of) {
      result.trace.signals.push_back(signal);
      result.lanes.of.push_back(of);
    };
    add(actual.signals[i], -1);
    for (std::size_t r = 0; r < actual.rows.size(); ++r)
      result.trace.rows[r].values.push_back(actual.rows[r].values[i]);
    const auto wanted = std::ranges::find_if(
        expected.signals, [&](const TraceSignal& signal) { return actual.indexOf(signal) == static_cast<int>(i); });
    if (wanted == expected.signals.end()) continue;
    const auto column = static_cast<std::size_t>(wanted - expected.signals.begin());
    TraceSignal signal = actual.signals[i];
    signal.symbol = "expected";
    lanes[column] = result.trace.signals.size();
    add(signal, static_cast<int>(lanes[column]) - 1);
    for (TraceRow& row : result.trace.rows) row.values.emplace_back();
    for (const TraceRow& row : expected.rows) {
      const std::optional<std::size_t> match = matchingRow(expected, row, actual);
      if (match && row.values[column]) result.trace.rows[*match].values.back() = row.values[column];
    }
  }
  result.lanes.wrong.resize(result.trace.signals.size());
  for (const TraceDifference& difference : differences(expected, actual, options, mostMarks)) {
    if (!difference.actualRow || lanes[difference.expectedSignal] == 0) continue;
    result.lanes.wrong[lanes[difference.expectedSignal]].push_back(*difference.actualRow);
  }
  return result;
}

Trace named(Trace trace, SignalNames names) {
  for (TraceSignal& signal : trace.signals) {
    if (names == SignalNames::Address || signal.symbol.empty()) continue;
    signal.name = names == SignalNames::Symbol ? signal.symbol : signal.name + " " + signal.symbol;
    signal.symbol.clear();
  }
  return trace;
}

}  // namespace rungproof
