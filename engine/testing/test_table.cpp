// Cells and steps as a table and a sheet write them.
#include "engine/testing/test_table.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace rungproof {

std::string signalText(const TraceSignal& signal) {
  const bool hasSymbol = !signal.symbol.empty() && signal.symbol != signal.name;
  return hasSymbol ? fmt::format("{} ({})", signal.symbol, signal.name) : signal.name;
}

std::string waitText(const TestWait& wait) {
  if (!wait.isTime()) return fmt::format("{} scan{}", wait.scans, wait.scans == 1 ? "" : "s");
  if (wait.timeUs % 1000 == 0) return fmt::format("{}ms", wait.timeUs / 1000);
  return fmt::format("{}ms", static_cast<double>(wait.timeUs) / 1000);
}

std::string rangeText(const TestRange& range, SignalType type) {
  const std::string low = numberText(range.low, type);
  return range.low == range.high || range.isNone() ? low : low + ".." + numberText(range.high, type);
}

bool TestTable::expectsAnything() const {
  const auto hasValue = [](const TestRow& row) {
    return std::ranges::any_of(row.expects, [](const auto& cell) { return cell.has_value(); });
  };
  return std::ranges::any_of(tests, [&](const TestCase& test) { return std::ranges::any_of(test.rows, hasValue); });
}

}  // namespace rungproof
