// Lanes in pairs.
#include "frontend/simulation/expected_lanes.hpp"

#include <algorithm>
#include <map>

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
  const SignalIndex index(actual);
  std::map<int, std::size_t> wantedOf;  // of each signal the first that expects something of it
  for (std::size_t k = 0; k < expected.signals.size(); ++k) wantedOf.try_emplace(index.indexOf(expected.signals[k]), k);
  for (std::size_t i = 0; i < actual.signals.size(); ++i) {
    const auto add = [&](const TraceSignal& signal, int of) {
      result.trace.signals.push_back(signal);
      result.lanes.of.push_back(of);
    };
    add(actual.signals[i], -1);
    for (std::size_t r = 0; r < actual.rows.size(); ++r)
      result.trace.rows[r].values.push_back(actual.rows[r].values[i]);
    const auto wanted = wantedOf.find(static_cast<int>(i));
    if (wanted == wantedOf.end()) continue;
    const std::size_t column = wanted->second;
    TraceSignal signal = actual.signals[i];
    signal.symbol = "expected";
    lanes[column] = result.trace.signals.size();
    add(signal, static_cast<int>(lanes[column]) - 1);
    for (TraceRow& row : result.trace.rows) row.values.emplace_back();
    for (std::size_t row = 0; row < expected.rows.size(); ++row) {
      const std::optional<std::size_t> match = matchingRow(expected, row, actual);
      const std::optional<TraceNumber>& value = expected.rows[row].values[column];
      if (match && value) result.trace.rows[*match].values.back() = value;
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
