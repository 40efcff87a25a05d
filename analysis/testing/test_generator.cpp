// Search, ask, plan, expect, check.
#include "analysis/testing/test_generator.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <random>
#include <set>

#include "analysis/testing/kill.hpp"
#include "analysis/testing/test_plan.hpp"
#include "engine/testing/test_player.hpp"

namespace rungproof {

namespace {

constexpr double searchShare = 0.4, proofShare = 0.25;  ///< of the time; proofs may come twice
constexpr std::uint64_t longStretchMs = 700;            ///< of a run of the prover, which a bench waits for
constexpr double faultShare = 0.15, checkShare = 0.4;
constexpr int mostSkew = 2;
constexpr std::uint64_t sweepScans = 2 * mostSkew + 2;            ///< contacts come to rest whatever the skews
constexpr std::uint64_t longWaitUs = 2000000, marginUs = 600000;  ///< a wait until rest is longer than the time by this
constexpr std::size_t walkCount = 400, walkLength = 30;           ///< on which planted faults may show
constexpr std::size_t randomPlays = 12;

/// Memory as presets of a run leave it, to read whole inputs from.
class PresetImage {
 public:
  void write(const PresetValue& preset) {
    const Operand& o = preset.operand;
    if (o.width == Width::Bit) {
      std::uint8_t& byte = bytes_[{o.area, o.offset}];
      const auto mask = static_cast<std::uint8_t>(1U << o.bit);
      byte = static_cast<std::uint8_t>(preset.value != 0 ? byte | mask : byte & ~mask);
      return;
    }
    const int count = bytes(o.width);
    for (int i = 0; i < count; ++i)
      bytes_[{o.area, o.offset + static_cast<std::uint32_t>(i)}] =
          static_cast<std::uint8_t>(preset.value >> (8 * (count - 1 - i)));
  }
  double read(const TraceSignal& signal) const {
    const Operand& o = signal.operand;
    std::uint64_t value = 0;
    const int count = o.width == Width::Bit ? 1 : bytes(o.width);
    for (int i = 0; i < count; ++i) {
      const auto byte = bytes_.find({o.area, o.offset + static_cast<std::uint32_t>(i)});
      value = value << 8 | (byte == bytes_.end() ? 0 : byte->second);
    }
    if (o.width == Width::Bit) value = value >> o.bit & 1;
    return numberOf(value, signal.type, signal.width());
  }

 private:
  std::map<std::pair<Area, std::uint32_t>, std::uint8_t> bytes_;
};

class Generator {
 public:
  Generator(const CoverageMap& map, const PropertySet& set, const GeneratorOptions& options)
      : map_(map),
        set_(set),
        options_(options),
        signals_(testSignalsOf(map.program(), set)),
        search_(map.program(), signals_, map, assumptionsOf(set), benchOptions(options)),
        seen_(map) {}

  GeneratedTests run() {
    layOutColumns();
    const auto isDone = [&] {
      if (search_.recorder().news() == lastNews_) return isAllSeen_;
      lastNews_ = search_.recorder().news();
      return isAllSeen_ = openGoals(search_.recorder(), options_.measures).empty();
    };
    search_.search(isDone);
    if (!isDone()) ask();
    writeTests();
    for (TestCase& test : result_.table.tests) expectValues(test);
    noticeFaults();
    check();
    return std::move(result_);
  }

 private:
  static std::vector<const Property*> assumptionsOf(const PropertySet& set) {
    std::vector<const Property*> assumptions;
    for (const Property& property : set.properties) {
      if (!property.isGoal()) assumptions.push_back(&property);
    }
    return assumptions;
  }
  static BenchOptions benchOptions(const GeneratorOptions& options) {
    BenchOptions bench;
    bench.engine = options.engine;
    bench.longestUs = options.highUs;
    bench.shortUs = std::max(options.lowUs, options.highUs / 10);
    bench.seconds = options.seconds * searchShare;
    return bench;
  }

  void layOutColumns() {
    for (const TestInput& input : signals_.inputs) result_.table.sets.push_back({StimulusTarget::Memory, input.signal});
    result_.table.expects = signals_.outputs;
  }

  /// What the search has not covered: is there a run at all? Runs become steps at the bench.
  void ask() {
    ProverOptions options = options_.prover;
    options.total = options_.seconds * proofShare;
    options.timeout = std::min(options.timeout, options.total);
    // Runs may show half of a pair, whose other half is a goal of its own.
    for (;;) {
      std::vector<CoverageGoal> goals = openGoals(search_.recorder(), options_.measures);
      std::erase_if(goals, [&](const CoverageGoal& goal) { return !asked_.insert(goal).second; });
      if (goals.empty()) break;
      for (auto& [goal, answer] : askGoals(map_, set_, goals, options)) {
        if (answer.outcome == Outcome::Reachable && answer.witness) followRun(*answer.witness);
        result_.answers[goal] = std::move(answer);
      }
    }
    if (!options_.changesTogether) askWithOneChange(options);
  }

  void followRun(const Witness& witness) {
    for (const std::uint64_t scans : {6U, 1U}) {
      if (search_.follow(stepsOf(witness, true, scans)) || search_.follow(stepsOf(witness, false, scans))) return;
    }
  }

  /// A goal that needs two inputs at once is out of reach of tests that change one a step.
  void askWithOneChange(const ProverOptions& options) {
    const std::vector<CoverageGoal> still = openGoals(search_.recorder(), options_.measures);
    std::vector<CoverageGoal> goals;
    for (const CoverageGoal& goal : still) {
      const auto answer = result_.answers.find(goal);
      if (answer != result_.answers.end() && answer->second.outcome == Outcome::Reachable) goals.push_back(goal);
    }
    Operands bits;
    for (const TestInput& input : signals_.inputs) {
      if (input.signal.type == SignalType::Bool) bits.push_back(input.signal.operand);
    }
    if (goals.empty() || bits.size() < 2) return;
    PropertySet bench = set_;
    bench.properties.push_back(oneChangeAScan(bits));
    for (auto& [goal, answer] : askGoals(map_, bench, goals, options)) {
      if (answer.outcome != Outcome::Unreachable) continue;
      answer.restriction = "as long as one input changes a scan";
      result_.answers[goal] = std::move(answer);
    }
  }

  std::vector<BenchStep> stepsOf(const Witness& witness, bool risesFirst, std::uint64_t scans) const {
    PresetImage image;
    std::vector<double> values(signals_.inputs.size(), 0);
    std::vector<BenchStep> steps;
    std::uint64_t restMs = 0;
    for (const ReplayScan& scan : witness.scans) {
      for (const PresetValue& preset : scan.inputs) image.write(preset);
      std::vector<std::pair<std::size_t, double>> changes;
      for (std::size_t i = 0; i < values.size(); ++i) {
        const double now = image.read(signals_.inputs[i].signal);
        if (now == values[i]) continue;
        changes.emplace_back(i, now);
        values[i] = now;
      }
      if (!changes.empty() && restMs >= longStretchMs) steps.push_back({{}, BenchSearch::untilRest});
      restMs = changes.empty() ? restMs : 0;
      std::ranges::stable_sort(changes, [&](const auto& a, const auto& b) {
        return risesFirst ? a.second > b.second : a.second < b.second;
      });
      if (options_.changesTogether && !changes.empty()) {
        steps.push_back({changes, {scans, 0}});
      } else {
        for (const auto& change : changes) steps.push_back({{change}, {scans, 0}});
      }
      restMs += std::uint64_t{scan.lengthMs} * scan.repeats;
    }
    if (steps.empty()) steps.push_back({{}, {scans, 0}});
    if (restMs >= longStretchMs) steps.push_back({{}, BenchSearch::untilRest});
    return steps;
  }

  /// Tests that cover all that the search has seen; what their merging has lost gets tests of its own.
  void writeTests() {
    for (const BenchTest& test : plannedTests(search_)) addIfUseful(test);
    for (const BenchSearch::Edge& edge : search_.edges()) {
      if (openGoals(seen_, options_.measures).size() <= openGoals(search_.recorder(), options_.measures).size()) break;
      if (edge.isUseful) addIfUseful(wayTo(search_, edge));
    }
  }

  void addIfUseful(const BenchTest& steps) {
    TestCase test = caseOf(steps);
    if (test.rows.empty()) return;
    const std::size_t before = seen_.news();
    Simulator simulator(map_.program(), options_.engine);
    TestPlayOptions play = atShown();
    play.observer = &seen_;
    play.beforeScan = [&](std::uint64_t) { seen_.beginScan(); };
    playTest(simulator, result_.table, test, play);
    if (seen_.news() != before) add(std::move(test));
  }

  void add(TestCase test) {
    test.name = fmt::format("T{:02}", result_.table.tests.size() + 1);
    result_.table.tests.push_back(std::move(test));
  }

  /// The rows of a test. A long wait is looked at once before its end, when nothing has come yet.
  TestCase caseOf(const BenchTest& steps) const {
    TestCase test;
    std::vector<double> values(signals_.inputs.size(), 0);
    for (const BenchStep& step : steps) {
      TestRow row;
      row.wait = step.wait;
      row.sets.resize(signals_.inputs.size());
      row.expects.resize(signals_.outputs.size());
      for (const auto& [input, value] : step.changes) {
        row.sets[input] = value;
        row.step += (row.step.empty() ? "" : ", ") + stepText(signals_.inputs[input].signal, values[input], value);
        values[input] = value;
      }
      if (row.step.empty()) row.step = test.rows.empty() ? "power on, all inputs off" : "wait";
      const bool isLong = step.changes.empty() && row.wait.timeUs >= longWaitUs && !test.rows.empty();
      if (isLong) {
        TestRow early = row;
        early.wait.timeUs = (row.wait.timeUs - marginUs) * 3 / 4 / 100000 * 100000;
        row.wait.timeUs -= early.wait.timeUs - marginUs / 2;
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

  static std::string stepText(const TraceSignal& signal, double from, double to) {
    if (signal.type != SignalType::Bool)
      return fmt::format("set {} to {}", signalText(signal), numberText(to, signal.type));
    return (to > from ? "switch on " : "switch off ") + signalText(signal);
  }

  void expectValues(TestCase& test) const {
    Simulator simulator(map_.program(), options_.engine);
    TestPlayOptions play = atShown();
    const std::vector<StepTimes> times = stepTimesOf(test, play.length);
    std::size_t next = 0;
    play.afterScan = [&](const Simulator& now, std::size_t) {
      for (; next < times.size() && times[next].compares == now.scanCount(); ++next) {
        const std::vector<std::optional<double>> values = sampleValues(now.store(), signals_.outputs);
        for (std::size_t i = 0; i < values.size(); ++i) {
          if (values[i]) test.rows[next].expects[i] = TestRange{*values[i], *values[i]};
        }
      }
    };
    playTest(simulator, result_.table, test, play);
  }

  /// Numbers through the limits that the program compares with, one below and one above, up and down; with all switches
  /// off, and with each of them on.
  std::vector<BenchTest> limitSweeps() const {
    std::vector<BenchTest> sweeps;
    const auto isSwitch = [&](std::size_t i) { return signals_.inputs[i].signal.type == SignalType::Bool; };
    const TestWait rest{sweepScans, 0};
    for (std::size_t number = 0; number < signals_.inputs.size(); ++number) {
      if (isSwitch(number)) continue;
      std::vector<double> values = signals_.inputs[number].values;
      std::ranges::sort(values);
      for (std::size_t on = 0; on <= signals_.inputs.size(); ++on) {
        const bool isPlain = on == signals_.inputs.size();
        if (!isPlain && !isSwitch(on)) continue;
        BenchTest steps = {{{}, rest}};
        if (!isPlain) steps.push_back({{{on, 1.0}}, rest});
        for (const double value : values) steps.push_back({{{number, value}}, rest});
        for (auto value = values.rbegin(); value != values.rend(); ++value) steps.push_back({{{number, *value}}, rest});
        sweeps.push_back(std::move(steps));
      }
    }
    return sweeps;
  }

  /// Faults that the tests do not notice so far: is there a way through what the search has seen on which they show?
  void noticeFaults() {
    const auto end = BenchSearch::Clock::now() + std::chrono::duration_cast<BenchSearch::Clock::duration>(
                                                     std::chrono::duration<double>(options_.seconds * faultShare));
    std::vector<TestCase> candidates;
    for (const BenchTest& steps : limitSweeps()) candidates.push_back(caseOf(steps));
    for (const BenchTest& steps : walks(search_, options_.seed, walkCount, walkLength))
      candidates.push_back(caseOf(steps));
    for (std::size_t i = 0; i < candidates.size(); ++i) {
      if (BenchSearch::Clock::now() > end) candidates.resize(i);
      if (i < candidates.size()) expectValues(candidates[i]);
    }
    TestPlayOptions play = atShown();
    play.stopsAtFailure = true;
    const auto noticedAt = [&](const Program& mutant, const TestCase& test) -> std::optional<std::size_t> {
      Simulator simulator(mutant, options_.engine);
      const TestPlay played = playTest(simulator, result_.table, test, play);
      return played.failures.empty() ? std::nullopt : std::optional(played.failures.front().step);
    };
    for (const Mutant& mutant : mutantsOf(map_.program())) {
      if (BenchSearch::Clock::now() > end) return;
      Program changed = planted(map_.program(), mutant.fault);
      changed.number();
      const bool isNoticed = std::ranges::any_of(
          result_.table.tests, [&](const TestCase& test) { return noticedAt(changed, test).has_value(); });
      for (std::size_t i = 0; !isNoticed && i < candidates.size() && BenchSearch::Clock::now() < end; ++i) {
        const std::optional<std::size_t> step = noticedAt(changed, candidates[i]);
        if (!step) continue;
        TestCase test = candidates[i];
        test.rows.resize(*step + 1);
        add(std::move(test));
        break;
      }
    }
  }

  TestPlayOptions atShown() const {
    return at([us = options_.shownUs](std::uint64_t) { return us; });
  }
  TestPlayOptions at(ScanLength length, std::vector<int> skews = {}) const {
    TestPlayOptions play;
    play.engine = options_.engine;
    play.length = std::move(length);
    play.skews = std::move(skews);
    play.stopsAtFailure = false;
    return play;
  }

  /// Lengths of scans at which everything is checked: both ends, fractions of a millisecond, which clocks of IEC
  /// 61131-3 do not count, and, as long as there is time, others between.
  static constexpr std::size_t alwaysChecked = 4;
  std::vector<std::uint32_t> lengths() const {
    std::vector<std::uint32_t> all{options_.lowUs, options_.highUs};
    for (const std::uint32_t us : {1999U, 10000U, 37000U, 2377U, 5682U, 64000U, 20000U, 3999U, 12500U, 50000U, 99000U,
                                   2000U, 33333U, 7000U, 75000U, 3000U, 13000U, 5000U, 90000U}) {
      if (us > options_.lowUs && us < options_.highUs) all.push_back(us);
    }
    if (options_.lowUs == options_.highUs) all.pop_back();
    return all;
  }

  using FailingCells = std::vector<std::set<std::size_t>>;  ///< outputs by row

  /// What is expected and does not come in some run of the test.
  FailingCells failingCells(const TestCase& test, std::mt19937_64& random, BenchSearch::Clock::time_point end) {
    FailingCells failing(test.rows.size());
    const auto playWith = [&](ScanLength length, std::vector<int> skews) {
      Simulator simulator(map_.program(), options_.engine);
      ++result_.plays;
      for (const TestFailure& failure :
           playTest(simulator, result_.table, test, at(std::move(length), std::move(skews))).failures) {
        if (failure.signal) failing[failure.step].insert(*failure.signal);
      }
    };
    const std::size_t count = test.rows.size();
    const auto alternating = [&](int first) {
      std::vector<int> skews;
      for (std::size_t i = 0; i < count; ++i) skews.push_back(i % 2 == 0 ? first : -first);
      return skews;
    };
    const auto drawn = [&] {
      std::vector<int> skews;
      for (std::size_t i = 0; i < count; ++i) skews.push_back(static_cast<int>(random() % 5) - mostSkew);
      return skews;
    };
    std::size_t checked = 0;
    for (const std::uint32_t us : lengths()) {
      if (++checked > alwaysChecked && BenchSearch::Clock::now() > end) break;
      const ScanLength length = [us](std::uint64_t) { return us; };
      playWith(length, {});
      playWith(length, std::vector<int>(count, -mostSkew));
      playWith(length, std::vector<int>(count, mostSkew));
      playWith(length, alternating(mostSkew));
      playWith(length, alternating(-mostSkew));
      playWith(length, drawn());
    }
    for (std::size_t i = 0; i < randomPlays; ++i)
      playWith(drawnScanLengths(options_.lowUs, options_.highUs, 1, random()), drawn());
    return failing;
  }

  static bool onlyWaits(const TestRow& row) {
    return row.wait.isTime() && std::ranges::none_of(row.sets, [](const auto& cell) { return cell.has_value(); });
  }

  /// A look before the end of a wait that does not hold everywhere is given up. Whether there was one.
  static bool giveUpEarlyLooks(TestCase& test, const FailingCells& failing) {
    std::vector<TestRow> kept;
    TestWait before{1, 0};  // of looks that were given up
    for (std::size_t i = 0; i < test.rows.size(); ++i) {
      TestRow& row = test.rows[i];
      const bool isEarly = i + 1 < test.rows.size() && onlyWaits(row) && onlyWaits(test.rows[i + 1]);
      const bool fails = !failing[i].empty() || (i + 1 < failing.size() && !failing[i + 1].empty());
      if (isEarly && fails && !before.isTime()) {
        before = row.wait;
        before.timeUs -= marginUs / 2;
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

  /// How much a test covers alone.
  std::size_t coveredBy(const TestCase& test) const {
    CoverageRecorder recorder(map_);
    Simulator simulator(map_.program(), options_.engine);
    TestPlayOptions play = atShown();
    play.observer = &recorder;
    play.beforeScan = [&](std::uint64_t) { recorder.beginScan(); };
    playTest(simulator, result_.table, test, play);
    return recorder.news();
  }

  void check() {
    std::mt19937_64 random(options_.seed);
    const double share =
        options_.seconds * checkShare / static_cast<double>(std::max<std::size_t>(result_.table.tests.size(), 1));
    for (TestCase& test : result_.table.tests) {
      const auto end = BenchSearch::Clock::now() +
                       std::chrono::duration_cast<BenchSearch::Clock::duration>(std::chrono::duration<double>(share));
      FailingCells failing = failingCells(test, random, end);
      TestCase simpler = test;
      if (giveUpEarlyLooks(simpler, failing) && coveredBy(simpler) >= coveredBy(test)) {
        test = std::move(simpler);
        expectValues(test);
        failing = failingCells(test, random, end);
      }
      for (std::size_t row = 0; row < test.rows.size(); ++row) {
        if (failing[row].empty()) continue;
        std::string names;
        for (const std::size_t output : failing[row]) {
          test.rows[row].expects[output].reset();
          names += (names.empty() ? "" : ", ") + signals_.outputs[output].name;
        }
        test.rows[row].note = fmt::format("timing: {} depends on the length of scans and is not compared", names);
        ++result_.timingRows;
      }
    }
  }

  const CoverageMap& map_;
  const PropertySet& set_;
  const GeneratorOptions options_;
  const TestSignals signals_;
  BenchSearch search_;
  CoverageRecorder seen_;  ///< by the tests written
  std::set<CoverageGoal> asked_;
  std::size_t lastNews_ = 0;
  bool isAllSeen_ = false;
  GeneratedTests result_;
};

}  // namespace

GeneratedTests generateTests(const CoverageMap& map, const PropertySet& set, const GeneratorOptions& options) {
  return Generator(map, set, options).run();
}

}  // namespace rungproof
