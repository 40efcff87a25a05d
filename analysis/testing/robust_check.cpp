// A level of the enumeration is the border in front of a step: the states there, by the scan at which its inputs act.
#include "analysis/testing/robust_check.hpp"

#include <algorithm>

#include "analysis/testing/test_signals.hpp"

namespace rungproof {

namespace {

constexpr std::size_t mostStates = 60;  ///< at a border
constexpr std::size_t randomPlays = 12, alwaysTried = 4;
constexpr std::uint32_t msUs = 1000, phases = 100;         // ms of the slowest time base
constexpr std::chrono::milliseconds longestOfLength{800};  ///< for one length; then some skews are tried
constexpr std::uint64_t scansBetweenLooks = 4096;

/// The end of a scan, from which a run can go on.
struct Border {
  int late = 0;  ///< scans by which the inputs of the step act late
  Concrete::Store state;
  Simulator::Moment moment;
};

/// RUN begins with a tick of the 1 ms clock.
Simulator::Moment momentOf(const Simulator& simulator) {
  const std::uint64_t us = simulator.timeUs();
  return {simulator.scanCount(), us, us / msUs, static_cast<std::uint32_t>(us % msUs * 100)};
}

/// Events wait at the end of a scan only where the program has locked them out: a tick of the clock serves all others.
bool mayHoldEvents(const Concrete::Store& state) {
  if (state.get(Reg::InterruptsEnabled, 0) != 0) return false;
  for (std::uint32_t event = 0; event < state.count(Reg::EventRoutine); ++event) {
    if (state.get(Reg::EventRoutine, event) != 0) return true;
  }
  return false;
}

bool setsSomething(const TestRow& row) {
  return std::ranges::any_of(row.sets, [](const auto& cell) { return cell.has_value(); });
}

std::uint64_t scansOf(const TestWait& wait, std::uint32_t us) {
  return std::max<std::uint64_t>(wait.isTime() ? (wait.timeUs + us - 1) / us : wait.scans, 1);
}

}  // namespace

RobustCheck::RobustCheck(const Program& program, TestTable columns, const RobustOptions& options)
    : program_(program),
      columns_(std::move(columns)),
      options_(options),
      replays_(hasDevices(program)),
      random_(options.seed) {}

void RobustCheck::compare(const TestRow& row, const Concrete::Store& state, std::set<std::size_t>& failing) const {
  const std::vector<std::optional<TraceNumber>> values = sampleValues(state, columns_.expects);
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (row.expects[i] && !(values[i] && row.expects[i]->holds(*values[i]))) failing.insert(i);
  }
}

/// False: there are too many states, an interrupt waits, the CPU has stopped, or it takes too long.
bool RobustCheck::enumerate(const TestCase& test, std::uint32_t us, RobustCells& cells) {
  Simulator simulator(program_, options_.engine);
  bool isWhole = true;
  const Clock::time_point latest = Clock::now() + longestOfLength;
  std::uint64_t scansMade = 0;
  std::vector<Border> level;
  for (int late = 0; late <= mostSkew; ++late) {
    if (late > 0) simulator.scan({.lengthUs = us});
    if (mayHoldEvents(simulator.store())) return false;
    level.push_back({late, simulator.store(), momentOf(simulator)});
  }
  std::uint64_t start = 1;  // scan from which the step lasts
  for (std::size_t i = 0; i < test.rows.size(); ++i) {
    const TestRow& row = test.rows[i];
    const std::uint64_t next = start + scansOf(row.wait, us);
    const bool isLast = i + 1 == test.rows.size();
    std::vector<Border> after;
    for (const Border& border : level) {
      const std::uint64_t acts = start + static_cast<std::uint64_t>(border.late + mostSkew) - mostSkew;
      simulator.goOnFrom(border.state, border.moment);
      applyRow(simulator, columns_, row);
      const std::uint64_t own = std::max(next - 1, acts);  // the scan at whose end the row is compared
      const std::uint64_t last = isLast ? own : next - 1 + mostSkew;
      std::set<std::size_t> failing;  // so far
      for (std::uint64_t scan = acts; scan <= last; ++scan) {
        simulator.scan({.lengthUs = us});
        if (!simulator.isRunning()) {
          cells.stops.insert(i);
          return false;
        }
        if (++scansMade % scansBetweenLooks == 0 && Clock::now() > latest) return false;
        const std::int64_t late = static_cast<std::int64_t>(scan + 1) - static_cast<std::int64_t>(next);
        const bool isBorder = !isLast && late >= -mostSkew;
        // With inputs that act early, the row is compared in front of them.
        if (scan == own || (isBorder && scan < own)) compare(row, simulator.store(), failing);
        if (!isBorder) continue;
        if (mayHoldEvents(simulator.store())) return false;
        const bool isKnown = std::ranges::any_of(after, [&](const Border& b) {
          return b.late == late && b.moment.timeUs == simulator.timeUs() && b.state == simulator.store();
        });
        if (isKnown) continue;
        if (after.size() == mostStates)
          isWhole = false;
        else
          after.push_back({static_cast<int>(late), simulator.store(), momentOf(simulator)});
      }
      cells.failing[i].insert(failing.begin(), failing.end());
    }
    level = std::move(after);
    start = next;
  }
  ++runs_;
  return isWhole;
}

void RobustCheck::play(const TestCase& test, ScanLength length, std::vector<int> skews, RobustCells& cells,
                       std::uint32_t phaseMs) {
  TestPlayOptions options;
  options.engine = options_.engine;
  options.engine.phaseMs = (options.engine.phaseMs + phaseMs) % phases;
  options.length = std::move(length);
  options.skews = std::move(skews);
  options.stopsAtFailure = false;
  Simulator simulator(program_, options.engine);
  ++runs_;
  for (const TestFailure& failure : playTest(simulator, columns_, test, options).failures) {
    if (failure.signal)
      cells.failing[failure.step].insert(*failure.signal);
    else
      cells.stops.insert(failure.step);
  }
}

/// Skews where they cannot be enumerated: none, all early, all late, and in turns by the rows that set something.
void RobustCheck::playSkews(const TestCase& test, std::uint32_t us, RobustCells& cells) {
  const ScanLength length = [us](std::uint64_t) { return us; };
  const std::size_t count = test.rows.size();
  for (const auto& [even, odd] : {std::pair(0, 0), std::pair(-mostSkew, -mostSkew), std::pair(mostSkew, mostSkew),
                                  std::pair(mostSkew, -mostSkew), std::pair(-mostSkew, mostSkew)}) {
    std::vector<int> skews;
    for (std::size_t i = 0, turn = 0; i < count; ++i)
      skews.push_back((setsSomething(test.rows[i]) ? turn++ : turn) % 2 == 0 ? even : odd);
    play(test, length, std::move(skews), cells);
  }
}

/// The longest and the shortest way from one input to the next: early up to a row and late behind it, and the reverse.
void RobustCheck::playTurns(const TestCase& test, std::uint32_t us, RobustCells& cells, Clock::time_point end) {
  const ScanLength length = [us](std::uint64_t) { return us; };
  for (std::size_t turn = 1; turn < test.rows.size(); ++turn) {
    if (!setsSomething(test.rows[turn]) && turn + 1 < test.rows.size()) continue;
    for (const int first : {-mostSkew, mostSkew}) {
      if (Clock::now() > end) return;
      std::vector<int> skews(test.rows.size(), -first);
      std::fill_n(skews.begin(), turn, first);
      play(test, length, std::move(skews), cells);
    }
  }
}

void RobustCheck::tryLength(const TestCase& test, std::uint32_t us, RobustCells& cells, bool& isWhole) {
  const bool isEnumerated = !replays_ && enumerate(test, us, cells);
  isWhole = isWhole && isEnumerated;
  if (!isEnumerated) playSkews(test, us, cells);
}

RobustCells RobustCheck::quick(const TestCase& test) {
  RobustCells cells;
  cells.failing.resize(test.rows.size());
  bool isWhole = true;
  std::set<std::uint32_t> lengths{options_.lowUs, options_.highUs};
  for (const std::uint32_t us : {1999U, 10000U, 37000U, 64000U}) {
    if (us > options_.lowUs && us < options_.highUs) lengths.insert(us);
  }
  for (const std::uint32_t us : lengths) tryLength(test, us, cells, isWhole);
  return cells;
}

RobustCells RobustCheck::full(const TestCase& test, Clock::time_point end) {
  RobustCells cells;
  cells.failing.resize(test.rows.size());
  bool isWhole = true, isOver = false;
  // Clocks of IEC 61131-3 do not count fractions of a millisecond.
  std::vector<std::uint32_t> lengths{options_.lowUs, options_.highUs};
  for (const std::uint32_t us : {1999U, 2377U, 3999U, 5682U, 12500U, 33333U, 64500U, 99900U}) {
    if (us > options_.lowUs && us < options_.highUs) lengths.push_back(us);
  }
  bool ofFractions = true;
  std::size_t tried = 0;
  for (const std::uint32_t us : lengths) {
    if (tried++ < alwaysTried || Clock::now() < end) tryLength(test, us, cells, ofFractions);
  }
  if (replays_) {
    for (const std::uint32_t us : {options_.highUs, options_.lowUs, 90000U, 88000U}) {
      if (us < options_.lowUs || us > options_.highUs) continue;
      tryLength(test, us, cells, ofFractions);
      playTurns(test, us, cells, end);
    }
  }
  const auto drawn = [&] {
    std::vector<int> skews;
    for (std::size_t i = 0; i < test.rows.size(); ++i)
      skews.push_back(static_cast<int>(random_() % (2 * mostSkew + 1)) - mostSkew);
    return skews;
  };
  for (std::size_t i = 0; i < randomPlays; ++i)
    play(test, drawnScanLengths(options_.lowUs, options_.highUs, 1, random_()), drawn(), cells,
         static_cast<std::uint32_t>(random_() % phases));
  // From the middle outwards in large steps, so that what was tried when time is over is spread over the range.
  const std::uint32_t first = (options_.lowUs + msUs - 1) / msUs, last = options_.highUs / msUs;
  constexpr std::uint32_t stride = 7;
  for (std::uint32_t from = first; from < first + stride && !isOver; ++from) {
    for (std::uint32_t ms = from; ms <= last && !isOver; ms += stride) {
      isOver = Clock::now() > end;
      if (!isOver) tryLength(test, ms * msUs, cells, isWhole);
    }
  }
  cells.isProved = isWhole && !isOver && !replays_ && first <= last;
  return cells;
}

}  // namespace rungproof
