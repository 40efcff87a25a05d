// Fills the comparison of a report.
#include "frontend/simulation/comparison.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "frontend/files/closest_word.hpp"

namespace rungproof {

namespace {

constexpr std::size_t columnsAround = 8;

std::string cellText(const std::optional<TraceNumber>& value, const TraceSignal& signal) {
  return value ? numberText(*value, signal.type) : "";
}

/// The differing signal first, then those beside it.
std::vector<std::size_t> columnsShown(const Trace& expected, std::size_t differing) {
  std::vector<std::size_t> columns = {differing};
  for (std::size_t i = 0; i < expected.signals.size() && columns.size() < columnsAround; ++i) {
    if (i != differing) columns.push_back(i);
  }
  return columns;
}

}  // namespace

Comparison comparisonOf(const Trace& expected, const Trace& actual, const std::optional<TraceDifference>& difference) {
  Comparison result;
  if (!difference) return result;
  result.equal = false;
  result.scan = static_cast<int>(difference->scan);
  result.timeMs = static_cast<double>(difference->timeUs) / 1000;
  result.signal = expected.signals[difference->expectedSignal].name;
  result.expected = difference->expected;
  result.hasEnded = !difference->actual.has_value();
  result.actual = difference->actual.value_or(std::numeric_limits<TraceNumber>::quiet_NaN());
  const std::vector<std::size_t> columns = columnsShown(expected, difference->expectedSignal);
  for (const std::size_t i : columns) result.signals.push_back(expected.signals[i].name);
  if (actual.rows.empty()) return result;
  const SignalIndex index(actual);
  const std::size_t middle = difference->actualRow.value_or(actual.rows.size() - 1);
  const std::size_t first = middle >= scansAround ? middle - scansAround : 0;
  const std::size_t last = std::min(middle + scansAround, actual.rows.size() - 1);
  for (std::size_t a = first; a <= last; ++a) {
    ComparedScan scan;
    scan.scan = static_cast<int>(actual.rows[a].scan);
    scan.timeMs = static_cast<double>(actual.rows[a].timeUs) / 1000;
    std::size_t wanted = 0;
    while (wanted < expected.rows.size() && matchingRow(expected, wanted, actual) != std::optional(a)) ++wanted;
    for (const std::size_t i : columns) {
      const int other = index.indexOf(expected.signals[i]);
      const TraceSignal& signal = other < 0 ? expected.signals[i] : actual.signals[static_cast<std::size_t>(other)];
      scan.expected.push_back(wanted == expected.rows.size() ? "" : cellText(expected.rows[wanted].values[i], signal));
      scan.actual.push_back(other < 0 ? "" : cellText(actual.rows[a].values[static_cast<std::size_t>(other)], signal));
    }
    result.around.push_back(std::move(scan));
  }
  return result;
}

bool expectsAnything(const Trace& expected) {
  return std::ranges::any_of(expected.rows, [](const TraceRow& row) {
    return std::ranges::any_of(row.values, [](const std::optional<TraceNumber>& value) { return value.has_value(); });
  });
}

Failure expectsNothing(const std::string& name) {
  return {"the expected trace holds no value, so nothing is compared", name,
          "give a column for each signal and the values that it must have"};
}

std::optional<Tolerance> toleranceIn(const std::string& text, const Trace& expected, Failure& failure) {
  const std::size_t equals = text.rfind('=');
  std::size_t used = 0;
  double value = -1;
  try {
    if (equals != std::string::npos) value = std::stod(text.substr(equals + 1), &used);
  } catch (const std::exception&) {
    value = -1;
  }
  if (equals == std::string::npos || equals == 0 || used != text.size() - equals - 1 || !(value >= 0)) {
    failure = {fmt::format("'{}' is no tolerance", text),
               {},
               "write --tolerance SIGNAL=VALUE with a value of 0 or more, such as VW10=2"};
    return std::nullopt;
  }
  const std::string name = text.substr(0, equals);
  if (expected.signalNamed(name) < 0) {
    std::vector<std::string> names;
    for (const TraceSignal& signal : expected.signals) names.push_back(signal.name);
    const std::string_view meant = closest(name, names);
    failure = {fmt::format("--tolerance names '{}', which is no column of the expected trace", name),
               {},
               meant.empty() ? "" : fmt::format("did you mean '{}'?", meant)};
    return std::nullopt;
  }
  return Tolerance{name, value};
}

}  // namespace rungproof
