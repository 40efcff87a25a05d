// Row by row, signal by signal.
#include "engine/trace_comparison.hpp"

#include <algorithm>
#include <cmath>

namespace rungproof {

namespace {

bool agree(TraceNumber expected, TraceNumber actual, double tolerance, SignalType type) {
  if (expected == actual || (std::isnan(expected) && std::isnan(actual))) return true;
  if (type == SignalType::Real && static_cast<float>(expected) == static_cast<float>(actual)) return true;
  return std::abs(expected - actual) <= tolerance;
}

/// Where the scan of a row begins.
std::uint64_t startOf(const Trace& trace, std::size_t row) {
  const TraceRow& r = trace.rows[row];
  if (r.scanUs != 0) return r.timeUs - std::min<std::uint64_t>(r.scanUs, r.timeUs);
  return row == 0 ? 0 : trace.rows[row - 1].timeUs;
}

std::string capitalsOf(std::string_view name) {
  std::string result(name);
  for (char& c : result) {
    if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 32);
  }
  return result;
}

}  // namespace

SignalIndex::SignalIndex(const Trace& trace) {
  for (std::size_t i = 0; i < trace.signals.size(); ++i) {
    const TraceSignal& signal = trace.signals[i];
    const int index = static_cast<int>(i);
    const Operand& o = signal.operand;
    if (o.isMemory()) byPlace_.try_emplace({o.area, o.offset, o.bit, o.width}, index);
    byName_.try_emplace(capitalsOf(signal.name), index);
    if (!signal.symbol.empty()) bySymbol_.try_emplace(capitalsOf(signal.symbol), index);
  }
}

int SignalIndex::signalNamed(std::string_view name) const {
  const std::string capitals = capitalsOf(name);
  if (const auto found = byName_.find(capitals); found != byName_.end()) return found->second;
  const auto found = bySymbol_.find(capitals);
  return found == bySymbol_.end() ? -1 : found->second;
}

int SignalIndex::indexOf(const TraceSignal& signal) const {
  const Operand& o = signal.operand;
  if (o.isMemory()) {
    if (const auto found = byPlace_.find({o.area, o.offset, o.bit, o.width}); found != byPlace_.end())
      return found->second;
  }
  const int named = signalNamed(signal.name);
  return named >= 0 || signal.symbol.empty() ? named : signalNamed(signal.symbol);
}

std::vector<std::string> missingSignals(const Trace& expected, const Trace& actual) {
  std::vector<std::string> missing;
  const SignalIndex index(actual);
  for (const TraceSignal& signal : expected.signals) {
    if (index.indexOf(signal) < 0) missing.push_back(signal.name);
  }
  return missing;
}

std::optional<std::size_t> matchingRow(const Trace& expected, std::size_t expectedRow, const Trace& actual) {
  const TraceRow& row = expected.rows[expectedRow];
  const std::vector<TraceRow>& rows = actual.rows;
  if (rows.empty()) return std::nullopt;
  if (!expected.isByTime && !actual.isByTime) {
    const auto found = std::lower_bound(rows.begin(), rows.end(), row.scan,
                                        [](const TraceRow& r, std::uint64_t scan) { return r.scan < scan; });
    if (found == rows.end() || found->scan != row.scan) return std::nullopt;
    return static_cast<std::size_t>(found - rows.begin());
  }
  if (actual.isByTime) {  // the value holds until the next row
    if (!expected.hasTimes) return std::nullopt;
    const bool isAtStart = !expected.isByTime && actual.isSampled;
    const std::uint64_t time = isAtStart ? startOf(expected, expectedRow) : row.timeUs;
    const auto later = std::ranges::upper_bound(rows, time, {}, &TraceRow::timeUs);
    if (later == rows.begin() || (later == rows.end() && rows.back().timeUs < time)) return std::nullopt;
    return static_cast<std::size_t>(later - rows.begin()) - 1;
  }
  const auto found = expected.isSampled ? std::ranges::upper_bound(rows, row.timeUs, {}, &TraceRow::timeUs)
                                        : std::ranges::lower_bound(rows, row.timeUs, {}, &TraceRow::timeUs);
  if (found == rows.end())
    return expected.isSampled && rows.back().timeUs == row.timeUs ? std::optional(rows.size() - 1) : std::nullopt;
  const auto index = static_cast<std::size_t>(found - rows.begin());
  const std::uint64_t start = startOf(actual, index);
  const bool isAtStart = start == row.timeUs && (expected.isSampled || start == 0);
  return start < row.timeUs || isAtStart ? std::optional(index) : std::nullopt;
}

std::optional<TraceDifference> firstDifference(const Trace& expected, const Trace& actual,
                                               const CompareOptions& options) {
  const std::vector<TraceDifference> list = differences(expected, actual, options, 1);
  return list.empty() ? std::nullopt : std::optional(list.front());
}

std::vector<TraceDifference> differences(const Trace& expected, const Trace& actual, const CompareOptions& options,
                                         std::size_t most) {
  std::vector<TraceDifference> list;
  struct Pair {
    std::size_t expected;
    std::size_t actual;
    SignalType type;
    double tolerance;
  };
  std::vector<Pair> pairs;
  std::map<int, double> tolerances;
  const SignalIndex wantedIndex(expected), index(actual);
  for (const Tolerance& given : options.tolerances) tolerances[wantedIndex.signalNamed(given.signal)] = given.value;
  for (std::size_t i = 0; i < expected.signals.size(); ++i) {
    const int other = index.indexOf(expected.signals[i]);
    if (other < 0) continue;
    const auto tolerance = tolerances.find(static_cast<int>(i));
    pairs.push_back({i, static_cast<std::size_t>(other), actual.signals[static_cast<std::size_t>(other)].type,
                     tolerance == tolerances.end() ? 0 : tolerance->second});
  }
  for (std::size_t e = 0; e < expected.rows.size(); ++e) {
    const TraceRow& row = expected.rows[e];
    const std::optional<std::size_t> match = matchingRow(expected, e, actual);
    for (const Pair& pair : pairs) {
      const std::optional<TraceNumber> wanted = row.values[pair.expected];
      if (!wanted) continue;
      TraceDifference difference{e, match, pair.expected, row.scan, row.timeUs, *wanted, std::nullopt};
      if (list.size() >= most) return list;
      if (!match) {
        list.push_back(difference);
        continue;
      }
      const std::size_t low = *match >= options.slack ? *match - options.slack : 0;
      const std::size_t high = std::min<std::size_t>(*match + options.slack, actual.rows.size() - 1);
      bool found = false;
      for (std::size_t a = low; a <= high && !found; ++a) {
        const std::optional<TraceNumber> seen = actual.rows[a].values[pair.actual];
        found = seen && agree(*wanted, *seen, pair.tolerance, pair.type);
      }
      if (found) continue;
      difference.actual = actual.rows[*match].values[pair.actual];
      difference.scan = actual.isByTime ? row.scan : actual.rows[*match].scan;
      if (!actual.isByTime) difference.timeUs = actual.rows[*match].timeUs;
      list.push_back(difference);
    }
  }
  return list;
}

}  // namespace rungproof
