// Waits are cut where they are looked at; their pieces together are as long as the whole.
#include "analysis/testing/bench_rows.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

namespace rungproof {

namespace {

constexpr std::uint64_t longWaitUs = 2000000, marginUs = 600000;  ///< a wait until rest is longer than the time by this
constexpr std::uint64_t leastPieceUs = 100000;
constexpr std::uint64_t piecesOfWait = 5;

bool onlyWaits(const TestRow& row) {
  return row.wait.isTime() && std::ranges::none_of(row.sets, [](const auto& cell) { return cell.has_value(); });
}

}  // namespace

BenchRows::BenchRows(const Program& program, const TestSignals& signals, const SimulatorOptions& engine,
                     std::uint32_t shownUs)
    : program_(program), signals_(signals), engine_(engine), shownUs_(shownUs) {
  for (const TestInput& input : signals.inputs) columns_.sets.push_back({StimulusTarget::Memory, input.signal});
  columns_.expects = signals.outputs;
}

std::string BenchRows::stepText(const TraceSignal& signal, TraceNumber from, TraceNumber to, bool isAtPowerOn) {
  if (isAtPowerOn)
    return fmt::format("power on with {} {}", signalText(signal),
                       signal.type == SignalType::Bool ? "on" : "at " + numberText(to, signal.type));
  if (signal.type != SignalType::Bool)
    return fmt::format("set {} to {}", signalText(signal), numberText(to, signal.type));
  return (to > from ? "switch on " : "switch off ") + signalText(signal);
}

TestCase BenchRows::caseOf(const BenchTest& steps, Looks looks) const {
  TestCase test;
  std::vector<TraceNumber> values(signals_.inputs.size(), 0);
  for (const BenchStep& step : steps) {
    TestRow row;
    row.wait = step.wait;
    row.sets.resize(signals_.inputs.size());
    row.expects.resize(signals_.outputs.size());
    for (const auto& [input, value] : step.changes) {
      row.sets[input] = value;
      row.step += (row.step.empty() ? "" : ", ") +
                  stepText(signals_.inputs[input].signal, values[input], value, test.rows.empty());
      values[input] = value;
    }
    if (row.step.empty()) row.step = test.rows.empty() ? "power on, all inputs off" : "wait";
    const std::uint64_t whole = row.wait.timeUs;
    if (looks == Looks::Often && whole >= piecesOfWait * leastPieceUs) {
      const std::uint64_t piece = whole / piecesOfWait / leastPieceUs * leastPieceUs;
      row.wait.timeUs = whole - (piecesOfWait - 1) * piece;
      TestRow wait = row;
      wait.step = "wait";
      wait.wait.timeUs = piece;
      wait.sets.assign(signals_.inputs.size(), std::nullopt);
      test.rows.push_back(std::move(row));
      test.rows.insert(test.rows.end(), piecesOfWait - 1, wait);
      continue;
    }
    if (step.changes.empty() && whole >= longWaitUs && !test.rows.empty()) {
      TestRow early = row;
      early.wait.timeUs = (whole - marginUs) * 3 / 4 / leastPieceUs * leastPieceUs;
      row.wait.timeUs -= early.wait.timeUs;
      test.rows.push_back(std::move(early));
    }
    test.rows.push_back(std::move(row));
  }
  if (test.rows.empty()) return test;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (!test.rows.front().sets[i]) test.rows.front().sets[i] = 0;
  }
  return test;
}

TestPlayOptions BenchRows::atShown() const {
  TestPlayOptions play;
  play.engine = engine_;
  play.length = [us = shownUs_](std::uint64_t) { return us; };
  play.stopsAtFailure = false;
  return play;
}

void BenchRows::expectValues(TestCase& test) const {
  Simulator simulator(program_, engine_);
  TestPlayOptions play = atShown();
  const std::vector<StepTimes> times = stepTimesOf(test, play.length);
  std::size_t next = 0;
  play.afterScan = [&](const Simulator& now, std::size_t) {
    for (; next < times.size() && times[next].compares == now.scanCount(); ++next) {
      const std::vector<std::optional<TraceNumber>> values = sampleValues(now.store(), signals_.outputs);
      for (std::size_t i = 0; i < values.size(); ++i) {
        if (values[i]) test.rows[next].expects[i] = TestRange{*values[i], *values[i]};
      }
    }
  };
  playTest(simulator, columns_, test, play);
}

bool BenchRows::giveUpEarlyLooks(TestCase& test, const std::vector<std::set<std::size_t>>& failing) {
  std::vector<TestRow> kept;
  TestWait before{1, 0};  // of looks that were given up
  for (std::size_t i = 0; i < test.rows.size(); ++i) {
    TestRow& row = test.rows[i];
    const bool isEarly = i + 1 < test.rows.size() && onlyWaits(row) && onlyWaits(test.rows[i + 1]);
    const bool fails = !failing[i].empty() || (i + 1 < failing.size() && !failing[i + 1].empty());
    if (isEarly && fails && !before.isTime()) {
      before = row.wait;
      continue;
    }
    if (before.isTime()) row.wait.timeUs += before.timeUs;
    before = {1, 0};
    kept.push_back(std::move(row));
  }
  const bool hasGivenUp = kept.size() < test.rows.size();
  test.rows = std::move(kept);
  return hasGivenUp;
}

}  // namespace rungproof
