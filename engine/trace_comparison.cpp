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

std::optional<std::size_t> matchingRow(const Trace& expected, const TraceRow& row, const Trace& actual) {
  const std::vector<TraceRow>& rows = actual.rows;
  if (rows.empty()) return std::nullopt;
  if (!expected.isByTime && !actual.isByTime) {
    const auto found = std::lower_bound(rows.begin(), rows.end(), row.scan,
                                        [](const TraceRow& r, std::uint64_t scan) { return r.scan < scan; });
    if (found == rows.end() || found->scan != row.scan) return std::nullopt;
    return static_cast<std::size_t>(found - rows.begin());
  }
  if (!expected.isByTime) return std::nullopt;
  if (actual.isByTime) {  // the value holds until the next row
    const auto later = std::upper_bound(rows.begin(), rows.end(), row.timeUs,
                                        [](std::uint64_t time, const TraceRow& r) { return time < r.timeUs; });
    if (later == rows.begin() || (later == rows.end() && rows.back().timeUs < row.timeUs)) return std::nullopt;
    return static_cast<std::size_t>(later - rows.begin()) - 1;
  }
  const auto found = std::upper_bound(rows.begin(), rows.end(), row.timeUs,
                                      [](std::uint64_t time, const TraceRow& r) { return time < r.timeUs; });
  if (found != rows.end()) {
    const auto index = static_cast<std::size_t>(found - rows.begin());
    return startOf(actual, index) <= row.timeUs ? std::optional<std::size_t>(index) : std::nullopt;
  }
  if (rows.back().timeUs == row.timeUs) return rows.size() - 1;
  return std::nullopt;
}

Trace keyedByTime(Trace expected) {
  if (expected.isByTime) return expected;
  std::vector<std::uint64_t> starts;
  for (std::size_t i = 0; i < expected.rows.size(); ++i) starts.push_back(startOf(expected, i));
  for (std::size_t i = 0; i < starts.size(); ++i) expected.rows[i].timeUs = starts[i];
  expected.isByTime = true;
  return expected;
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
    const std::optional<std::size_t> match = matchingRow(expected, row, actual);
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
