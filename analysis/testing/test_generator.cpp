// Search, ask, plan, expect, check.
#include "analysis/testing/test_generator.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <random>
#include <set>

#include "analysis/testing/bench_rows.hpp"
#include "analysis/testing/fault_tests.hpp"
#include "analysis/testing/robust_check.hpp"
#include "analysis/testing/rounded_steps.hpp"
#include "analysis/testing/test_plan.hpp"
#include "engine/testing/test_player.hpp"

namespace rungproof {

namespace {

constexpr double searchShare = 0.3, proofShare = 0.3, latestProof = 0.6;  ///< of the time
constexpr double exploreShare = 0.1, faultShare = 0.4, walkShare = 0.6;
constexpr std::uint64_t longStretchMs = 700;  ///< of a run of the prover, which a bench waits for
constexpr std::uint64_t sweepScans = 2 * RobustCheck::mostSkew + 2;  ///< contacts come to rest whatever the skews
constexpr std::size_t walkRounds = 8, walkCount = 15,
                      walkLength = 25;   ///< of each kind, on which planted faults may show
constexpr std::size_t longestRun = 200;  ///< of the prover, that is repeated as it was
constexpr double patience = 0.4;         ///< for the comparison with one planted fault
constexpr double timingShare = 0.05;     ///< of the steps

class Generator {
  using Clock = RobustCheck::Clock;

 public:
  Generator(const CoverageMap& map, const PropertySet& set, const GeneratorOptions& options)
      : map_(map),
        set_(set),
        options_(options),
        signals_(testSignalsOf(map.program(), set)),
        rows_(map.program(), signals_, options.engine, options.shownUs),
        check_(map.program(), rows_.columns(), {options.engine, options.lowUs, options.highUs, options.seed}),
        search_(map.program(), signals_, map, assumptionsOf(set), benchOptions(options)),
        seen_(map) {
    result_.table = rows_.columns();
  }

  GeneratedTests run() {
    const auto isDone = [&] {
      if (search_.recorder().news() == lastNews_) return isAllSeen_;
      lastNews_ = search_.recorder().news();
      return isAllSeen_ = openGoals(search_.recorder(), options_.measures).empty();
    };
    search_.search(isDone);
    if (!isDone()) ask();
    writeTests();
    repeatRuns();
    for (TestCase& test : result_.table.tests) giveUpWhatVaries(test);
    if (options_.measures.contains(Measure::Mcdc)) noticeFaults();
    checkAll();
    for (std::size_t i = 0; i < result_.table.tests.size(); ++i)
      result_.table.tests[i].name = fmt::format("T{:02}", i + 1);
    result_.plays = check_.runs();
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
  /// "assuming 'lim'": what answers of the prover rest on; empty: nothing is assumed.
  std::string assumedText() const {
    std::vector<std::string> names;
    for (const Property* assumption : assumptionsOf(set_))
      names.push_back("'" + (assumption->name.empty() ? assumption->text : assumption->name) + "'");
    return names.empty() ? "" : fmt::format("assuming {}", fmt::join(names, ", "));
  }
  static BenchOptions benchOptions(const GeneratorOptions& options) {
    BenchOptions bench;
    bench.engine = options.engine;
    bench.longestUs = options.highUs;
    bench.shortUs = std::max(options.lowUs, options.highUs / 10);
    bench.seconds = options.seconds * searchShare;
    return bench;
  }

  /// What the search has not covered: is there a run at all? Runs become steps at the bench.
  void ask() {
    ProverOptions options = options_.prover;
    // Runs may show half of a pair, whose other half is a goal of its own.
    for (;;) {
      std::vector<CoverageGoal> goals = openGoals(search_.recorder(), options_.measures);
      std::erase_if(goals, [&](const CoverageGoal& goal) { return !asked_.insert(goal).second; });
      if (goals.empty() || !limitProofs(options)) break;
      for (auto& [goal, answer] : askGoals(map_, set_, goals, options)) {
        if (answer.outcome == Outcome::Reachable && answer.witness) followRun(goal, *answer.witness);
        answer.restriction = assumedText();
        result_.answers[goal] = std::move(answer);
      }
    }
    if (!options_.changesTogether && limitProofs(options)) askWithOneChange(options);
  }

  /// What proofs may take now, on all their threads; false: their time is over.
  bool limitProofs(ProverOptions& options) const {
    const double spent = std::chrono::duration<double>(Clock::now() - begin_).count();
    const double left = std::min(options_.seconds * proofShare, options_.seconds * latestProof - spent);
    options.total = left / std::max<double>(options_.prover.jobs, 1);
    options.timeout = std::min(options_.prover.timeout, options.total);
    return left > 0;
  }

  void followRun(const CoverageGoal& goal, const Witness& witness) {
    for (const std::uint64_t scans : {6U, 1U}) {
      for (const bool risesFirst : {true, false}) {
        const BenchTest steps = stepsOf(witness.scans, risesFirst, scans);
        if (steps.size() > mostTestSteps) continue;
        for (const BenchTest& easy : roundedSteps(steps, signals_)) {
          search_.follow(easy);
          const std::vector<CoverageGoal> open = openGoals(search_.recorder(), options_.measures);
          if (std::ranges::find(open, goal) == open.end()) return;
        }
        if (search_.follow(steps)) return;
      }
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
      if (const std::string assumed = assumedText(); !assumed.empty()) answer.restriction += ", " + assumed;
      result_.answers[goal] = std::move(answer);
    }
  }

  /// A run of the prover as steps at the bench; of inputs that change in one scan those that rise come first or last.
  BenchTest stepsOf(const std::vector<ReplayScan>& run, bool risesFirst, std::uint64_t scans) const {
    Concrete::Store image(map_.plan());
    std::vector<TraceNumber> values(signals_.inputs.size(), 0);
    BenchTest steps;
    std::uint64_t restMs = 0;
    for (const ReplayScan& scan : run) {
      for (const PresetValue& preset : scan.inputs) {
        const Operand& o = preset.operand;
        image.save(o.area, o.offset * 8 + (o.width == Width::Bit ? o.bit : 0U), bits(o.width), preset.value, true);
      }
      std::vector<std::pair<std::size_t, TraceNumber>> changes;
      for (std::size_t i = 0; i < values.size(); ++i) {
        const TraceNumber now = sampleValues(image, {signals_.inputs[i].signal}).front().value_or(0);
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

  /// Runs of the prover that no bench with long scans repeats are tried with the shown ones, as they are.
  void repeatRuns() {
    for (const auto& [goal, answer] : result_.answers) {
      if (answer.outcome != Outcome::Reachable || !answer.witness || answer.witness->scans.size() > longestRun)
        continue;
      const auto isStillOpen = [&] {
        const std::vector<CoverageGoal> open = openGoals(seen_, options_.measures);
        return std::ranges::find(open, goal) != open.end();
      };
      for (const std::int64_t moreMs : {0, 50, -50, 100, -100}) {
        const BenchTest steps = runOf(answer.witness->scans, moreMs);
        for (const BenchTest& easy : roundedSteps(steps, signals_)) {
          if (isStillOpen()) addIfUseful(easy);
        }
        if (isStillOpen()) addIfUseful(steps);
      }
    }
  }

  /// A run as it was, with its last stretch that much longer.
  BenchTest runOf(const std::vector<ReplayScan>& run, std::int64_t moreMs) const {
    BenchTest steps;
    std::uint64_t restMs = 0;
    const auto wait = [&](std::int64_t more) {
      const std::int64_t ms = static_cast<std::int64_t>(restMs) + more;
      if (!steps.empty() && ms > 0) steps.push_back({{}, {1, static_cast<std::uint64_t>(ms) * 1000}});
      restMs = 0;
    };
    std::vector<ReplayScan> soFar;
    std::size_t known = 0;
    for (const ReplayScan& scan : run) {
      soFar.emplace_back().inputs = scan.inputs;
      const BenchTest changes = stepsOf(soFar, true, 1);
      const std::size_t count = changes.front().changes.empty() ? 0 : changes.size();
      if (count > known) {
        wait(0);
        steps.insert(steps.end(), changes.begin() + static_cast<std::ptrdiff_t>(known), changes.end());
      } else if (steps.empty()) {
        steps.push_back({{}, {1, 0}});
      }
      known = count;
      restMs += std::uint64_t{scan.lengthMs} * scan.repeats;
    }
    wait(moreMs);
    return steps;
  }

  void addIfUseful(const BenchTest& steps) {
    TestCase test = rows_.caseOf(steps);
    if (test.rows.empty()) return;
    const std::size_t before = seen_.news();
    playObserved(test, seen_);
    if (seen_.news() == before) return;
    rows_.expectValues(test);
    result_.table.tests.push_back(std::move(test));
  }

  void playObserved(const TestCase& test, CoverageRecorder& recorder) const {
    Simulator simulator(map_.program(), options_.engine);
    TestPlayOptions play = rows_.atShown();
    play.observer = &recorder;
    play.beforeScan = [&](std::uint64_t) { recorder.beginScan(); };
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
      std::vector<TraceNumber> values = signals_.inputs[number].values;
      std::ranges::sort(values);
      for (std::size_t on = 0; on <= signals_.inputs.size(); ++on) {
        const bool isPlain = on == signals_.inputs.size();
        if (!isPlain && !isSwitch(on)) continue;
        BenchTest steps = {{{}, rest}};
        if (!isPlain) steps.push_back({{{on, 1.0}}, rest});
        for (const TraceNumber value : values) steps.push_back({{{number, value}}, rest});
        for (auto value = values.rbegin(); value != values.rend(); ++value) steps.push_back({{{number, *value}}, rest});
        sweeps.push_back(std::move(steps));
      }
    }
    return sweeps;
  }

  /// Faults that the tests do not notice so far: is there a way through what the search has seen on which they show?
  void noticeFaults() {
    const Clock::time_point end = in(faultShare);
    FaultTests faults(map_.program(), rows_, check_, options_.engine);
    faults.forget(result_.table.tests);
    if (!faults.isDone()) search_.explore(in(exploreShare));
    const auto isOver = [&] { return faults.isDone() || Clock::now() > end; };
    const auto offer = [&](const BenchTest& steps, Looks looks) {
      if (isOver()) return;
      TestCase test = rows_.caseOf(steps, looks);
      if (test.rows.empty()) return;
      rows_.expectValues(test);
      faults.offer(std::move(test));
    };
    for (const BenchTest& steps : limitSweeps()) offer(steps, Looks::Middle);
    std::uint64_t seed = options_.seed;
    const Clock::time_point begin = Clock::now();
    const Clock::time_point endOfWalks =
        begin + std::chrono::duration_cast<Clock::duration>(walkShare * std::max(end - begin, Clock::duration{}));
    for (std::size_t round = 0; round < walkRounds && Clock::now() < endOfWalks; ++round) {
      for (const Pace pace : {Pace::Quick, Pace::Mixed, Pace::Timed, Pace::Settled}) {
        if (pace == Pace::Timed && !dependsOnTime(map_.program())) continue;
        for (const Looks looks : {Looks::Middle, Looks::Often}) {
          for (const BenchTest& steps : walks(search_, ++seed, walkCount, walkLength, pace)) {
            if (Clock::now() < endOfWalks) offer(steps, looks);
          }
        }
      }
    }
    followDifferences(faults, offer, isOver);
    for (TestCase& test : faults.takeRobust()) result_.table.tests.push_back(std::move(test));
    const std::string scans = fmt::format("{:g} ms", static_cast<double>(options_.shownUs) / 1000);
    std::size_t steps = 0;
    for (const TestCase& test : result_.table.tests) steps += test.rows.size();
    for (TestCase& test : faults.takeTimed(steps, timingShare, scans)) {
      ++result_.timingRows;
      result_.table.tests.push_back(std::move(test));
    }
  }

  /// What the prover finds out about faults that no walk has shown: nothing changes, or a run on which something does.
  template <class Offer, class IsOver>
  void followDifferences(FaultTests& faults, const Offer& offer, const IsOver& isOver) {
    ProverOptions prover = options_.prover;
    prover.timeout = patience;
    for (std::size_t i = 0; i < faults.open().size() && !isOver();) {
      const FaultTests::OpenFault* const fault = faults.open()[i].get();
      const Equivalence found = compareWithFault(map_.program(), fault->program, set_, prover);
      if (found.equality == Equality::Equal) {
        faults.remove(i);
        continue;
      }
      if (found.run) {
        for (const std::uint64_t scans : {1U, 6U}) {
          for (const bool risesFirst : {true, false}) {
            BenchTest steps = stepsOf(found.run->before, risesFirst, scans);
            if (steps.size() > mostTestSteps) continue;
            steps.push_back({{}, {1, 0}});
            steps.push_back({{}, {sweepScans, 0}});
            for (BenchStep& step : steps) {
              if (step.wait.scans == 0 && !step.wait.isTime()) step.wait = {1, found.run->milliseconds * 1000};
            }
            const auto isOpen = [&] { return i < faults.open().size() && faults.open()[i].get() == fault; };
            for (const BenchTest& easy : roundedSteps(steps, signals_)) {
              if (isOpen()) offer(easy, Looks::Often);
            }
            if (isOpen() && canBeSet(steps, signals_)) offer(steps, Looks::Often);
          }
        }
      }
      if (i < faults.open().size() && faults.open()[i].get() == fault) ++i;
    }
  }

  /// How much a test covers alone.
  std::size_t coveredBy(const TestCase& test) const {
    CoverageRecorder recorder(map_);
    playObserved(test, recorder);
    return recorder.news();
  }

  /// A first look at a test of coverage: values that do not come everywhere are not expected.
  void giveUpWhatVaries(TestCase& test) {
    RobustCells cells = check_.quick(test);
    TestCase simpler = test;
    if (BenchRows::giveUpEarlyLooks(simpler, cells.failing) && coveredBy(simpler) >= coveredBy(test)) {
      test = std::move(simpler);
      rows_.expectValues(test);
      cells = check_.quick(test);
    }
    giveUp(test, cells);
  }

  /// Takes out what does not come everywhere; cells of steps that say `timing` stay.
  void giveUp(TestCase& test, const RobustCells& cells) const {
    for (std::size_t row = 0; row < test.rows.size(); ++row) {
      if (isTimed(test.rows[row])) continue;
      for (const std::size_t output : cells.failing[row]) test.rows[row].expects[output].reset();
    }
  }
  static bool isTimed(const TestRow& row) { return row.note.starts_with("timing"); }

  /// The whole check of every test in the time that is left; then steps say what is not compared.
  void checkAll() {
    const Clock::time_point end =
        begin_ + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(options_.seconds));
    std::size_t left = result_.table.tests.size();
    for (TestCase& test : result_.table.tests) {
      const Clock::time_point now = Clock::now();
      const Clock::time_point mine = now + std::max(end - now, Clock::duration{}) / static_cast<int>(left--);
      const RobustCells cells = check_.full(test, mine);
      giveUp(test, cells);
      for (std::size_t row = 0; row < test.rows.size(); ++row) {
        std::vector<std::string> names;
        std::size_t expected = 0;
        for (std::size_t i = 0; i < signals_.outputs.size(); ++i) {
          if (test.rows[row].expects[i])
            ++expected;
          else
            names.push_back(signals_.outputs[i].name);
        }
        const std::size_t ofTime = isTimed(test.rows[row]) ? cells.failing[row].size() : 0;
        result_.timedCells += ofTime;
        (cells.isProved ? result_.provedCells : result_.checkedCells) += expected - ofTime;
        if (cells.stops.contains(row) && !isTimed(test.rows[row])) {
          test.rows[row].note = "timing: the CPU stops where inputs come late or scans have another length";
          ++result_.timingRows;
        }
        tellDigits(test.rows[row]);
        if (isTimed(test.rows[row])) continue;
        if (!names.empty()) {
          addNote(test.rows[row], fmt::format("{} not compared: when it changes depends on the length of scans",
                                              fmt::join(names, ", ")));
          ++result_.silentRows;
        }
        if (check_.onlyTries() && expected > 0) {
          std::string& note = test.rows[row].note;
          note =
              "timing: tried, not proved, as devices of the CPU have a part in it" + (note.empty() ? "" : "; " + note);
          ++result_.triedRows;
        }
      }
    }
  }

  static void addNote(TestRow& row, const std::string& text) { row.note += (row.note.empty() ? "" : "; ") + text; }

  /// A number that nobody can set is said to be one.
  void tellDigits(TestRow& row) const {
    for (std::size_t i = 0; i < row.sets.size(); ++i) {
      const TraceSignal& signal = signals_.inputs[i].signal;
      if (row.sets[i] && signal.isReal() && digitsOf(*row.sets[i], signal) > easyDigits)
        addNote(row, fmt::format("{} counts with all its digits", signalText(signal)));
    }
  }

  Clock::time_point in(double share) const {
    return Clock::now() + std::chrono::duration_cast<Clock::duration>(
                              std::chrono::duration<double>(std::max(options_.seconds * share, 0.0)));
  }

  const CoverageMap& map_;
  const PropertySet& set_;
  const GeneratorOptions options_;
  const Clock::time_point begin_ = Clock::now();
  const TestSignals signals_;
  const BenchRows rows_;
  RobustCheck check_;
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
