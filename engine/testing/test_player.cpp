// The times of all steps are laid out first; then the scans are made one after the other.
#include "engine/testing/test_player.hpp"

#include <algorithm>

namespace rungproof {

std::vector<StepTimes> stepTimesOf(const TestCase& test, const ScanLength& length, const std::vector<int>& skews) {
  std::vector<std::uint64_t> starts{1};
  for (const TestRow& row : test.rows) {
    std::uint64_t scans = row.wait.scans;
    if (row.wait.isTime()) {
      scans = 0;
      for (std::uint64_t passed = 0; passed < row.wait.timeUs; ++scans) passed += length(starts.back() + scans);
    }
    starts.push_back(starts.back() + std::max<std::uint64_t>(scans, 1));
  }
  std::vector<StepTimes> times(test.rows.size());
  std::uint64_t earliest = 1;
  for (std::size_t i = 0; i < times.size(); ++i) {
    const std::int64_t skewed = static_cast<std::int64_t>(starts[i]) + (i < skews.size() ? skews[i] : 0);
    times[i].acts = std::max(earliest, static_cast<std::uint64_t>(std::max<std::int64_t>(skewed, 1)));
    earliest = times[i].acts + 1;
  }
  for (std::size_t i = 0; i < times.size(); ++i) {
    times[i].compares = std::max(starts[i + 1] - 1, times[i].acts);
    if (i + 1 < times.size()) times[i].compares = std::min(times[i].compares, times[i + 1].acts - 1);
  }
  return times;
}

void applyRow(Simulator& simulator, const TestTable& table, const TestRow& row) {
  for (std::size_t i = 0; i < table.sets.size(); ++i) {
    if (!row.sets[i]) continue;
    const StimulusColumn& column = table.sets[i];
    actOn(simulator, column, valueOf(*row.sets[i], column.signal.type, column.signal.width()));
  }
}

TestPlay playTest(Simulator& simulator, const TestTable& table, const TestCase& test, const TestPlayOptions& options) {
  TestPlay play;
  const std::vector<StepTimes> times = stepTimesOf(test, options.length, options.skews);
  if (options.observer != nullptr) simulator.observe(options.observer);
  const auto isOver = [&] { return options.stopsAtFailure && !play.failures.empty(); };
  std::size_t next = 0, compared = 0;
  bool hasStopped = false;
  while (compared < times.size() && !isOver()) {
    const std::uint64_t scan = simulator.scanCount() + 1;
    for (; next < times.size() && times[next].acts == scan; ++next) applyRow(simulator, table, test.rows[next]);
    if (options.beforeScan) options.beforeScan(scan);
    simulator.scan({.lengthUs = options.length(scan)});
    if (options.afterScan) options.afterScan(simulator, compared);
    const auto failureAt = [&] {
      return TestFailure{compared, std::nullopt, 0, simulator.scanCount(), simulator.timeUs()};
    };
    if (simulator.errors().fatal() != nullptr && !std::exchange(hasStopped, true)) {
      play.failures.push_back(failureAt());
      if (isOver()) break;
    }
    for (; compared < times.size() && times[compared].compares == scan; ++compared) {
      const std::vector<std::optional<TraceNumber>> values = sampleValues(simulator.store(), table.expects);
      for (std::size_t i = 0; i < table.expects.size() && !isOver(); ++i) {
        const std::optional<TestRange>& expected = test.rows[compared].expects[i];
        if (!expected || (values[i] && expected->holds(*values[i]))) continue;
        TestFailure failure = failureAt();
        failure.signal = i;
        failure.actual = values[i].value_or(0);
        play.failures.push_back(failure);
      }
      if (isOver()) break;
    }
  }
  play.scans = simulator.scanCount();
  play.timeUs = simulator.timeUs();
  return play;
}

}  // namespace rungproof
