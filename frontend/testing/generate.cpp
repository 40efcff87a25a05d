// All texts are made first; then they are written, and what was written is taken back if one cannot be.
#include "frontend/testing/generate.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>

#include "analysis/encoding/asked_properties.hpp"
#include "analysis/witness/follower.hpp"
#include "analysis/witness/state_pool.hpp"
#include "engine/platform/names.hpp"
#include "engine/start_up.hpp"
#include "frontend/explain/certificate_head.hpp"
#include "frontend/simulation/scan_lengths.hpp"
#include "frontend/testing/coverage_page.hpp"
#include "frontend/testing/table_reader.hpp"
#include "frontend/testing/table_run.hpp"
#include "frontend/testing/test_output.hpp"
#include "frontend/testing/test_purpose.hpp"

namespace rungproof {

namespace {

struct FileToWrite {
  std::string name, form, text;
};

std::string_view whatNeverComes(const CoverageGoal& goal) {
  switch (goal.measure) {
    case Measure::Networks: return "no run lets power flow to a coil or box";
    case Measure::Contacts: return goal.value ? "its bit is never 1" : "its bit is never 0";
    case Measure::Transitions: return "it is never taken";
    case Measure::Mcdc: break;
  }
  if (goal.isOutcome) return goal.value ? "it never decides an outcome of 1" : "it never decides an outcome of 0";
  return goal.value ? "as 1 it never decides the outcome" : "as 0 it never decides the outcome";
}

/// What the prover said of what is missing. One goal that no run reaches is enough.
void settle(MeasureResult& measure, MissingGoal& missing, const std::map<CoverageGoal, GoalAnswer>& answers,
            std::vector<FileToWrite>& proofs) {
  missing.state = MissingGoal::State::Open;
  const std::string seen = missing.reason;
  std::vector<std::string> reasons;  // each once, of however many goals
  const auto add = [&](std::string reason) {
    if (std::ranges::find(reasons, reason) == reasons.end()) reasons.push_back(std::move(reason));
  };
  for (const CoverageGoal& goal : missing.open) {
    const auto answer = answers.find(goal);
    if (answer == answers.end()) {
      add("not proved either");
      continue;
    }
    const GoalAnswer& found = answer->second;
    if (found.outcome == Outcome::Unreachable) {
      missing.state = MissingGoal::State::Unreachable;
      missing.reason = fmt::format("proved impossible: {}{}{}", whatNeverComes(goal),
                                   found.restriction.empty() ? "" : ", " + found.restriction,
                                   found.method.empty() ? "" : " (" + found.method + ")");
      if (!found.certificate.empty()) {
        missing.certificate = fmt::format("proofs/goal_{}.smt2", proofs.size() + 1);
        proofs.push_back({missing.certificate, "smt2", found.certificate});
      }
      ++measure.unreachable;
      --measure.open;
      return;
    }
    if (found.outcome == Outcome::Reachable)
      add(fmt::format("the prover has a run, which no test of up to {} steps at the bench repeats", mostTestSteps));
    else
      add(fmt::format("open: {}", verdictText(found.outcome, 0)));
  }
  missing.reason = fmt::format("{}; {}", seen, fmt::join(reasons, "; "));
}

/// Whether a run meets what a requirement speaks of: its premise, or a change of what it reads.
class Exercise {
 public:
  explicit Exercise(const Property& property) : premise_(premiseOf(property)) {
    if (premise_) follower_.emplace(*premise_);
    for (const Operand* operand : addressesOf(property)) read_.push_back(*operand);
  }
  void scan(const Concrete::Store& state, const ReplayScan& scan, bool isFirst) {
    if (isMet_) return;
    if (follower_) {
      isMet_ = follower_->evaluate(domain_, state, scan, isFirst);
      return;
    }
    std::vector<std::uint64_t> now;
    for (const Operand& operand : read_) now.push_back(valueIn(state, operand));
    isMet_ = !isFirst && now != before_;
    before_ = std::move(now);
  }
  bool isMet() const { return isMet_; }

 private:
  std::optional<Property> premise_;
  std::optional<Follower> follower_;
  StillOutside outside_;
  Concrete domain_{outside_};
  Operands read_;
  std::vector<std::uint64_t> before_;
  bool isMet_ = false;
};

/// Plays each test once more for what the sheet says of it.
void describeTests(TestSheet& sheet, CoverageRecorder& all, const PropertySet& set, const GenerateRequest& request) {
  const CoverageMap& map = all.map();
  for (const Property& property : set.properties) {
    if (property.isGoal()) sheet.requirements.push_back({property.name, property.text, {}});
  }
  sheet.purposes = purposesOf(sheet.table);
  for (const CoveragePlace& place : map.networks())
    sheet.links[map.placeText(place)] = "coverage.html#" + networkAnchor(place);
  for (const TestCase& test : sheet.table.tests) {
    CoverageRecorder recorder(map);
    std::vector<std::unique_ptr<Exercise>> exercises;
    for (const Property& property : set.properties) {
      if (property.isGoal()) exercises.push_back(std::make_unique<Exercise>(property));
    }
    Simulator simulator(map.program(), request.engine);
    TestPlayOptions play;
    play.engine = request.engine;
    play.length = scanLengthsOf(request.shownTime, request.engine.seed);
    play.stopsAtFailure = false;
    play.observer = &recorder;
    play.beforeScan = [&](std::uint64_t) { recorder.beginScan(); };
    play.afterScan = [&](const Simulator& now, std::size_t) {
      ReplayScan scan;
      scan.lengthMs = std::max<std::uint32_t>(now.lastScanUs() / 1000, 1);
      for (const std::unique_ptr<Exercise>& one : exercises) one->scan(now.store(), scan, now.scanCount() == 1);
    };
    playTest(simulator, sheet.table, test, play);
    std::vector<std::string>& networks = sheet.networks.emplace_back();
    for (std::size_t i = 0; i < map.networks().size(); ++i) {
      if (recorder.networkReached(i)) networks.push_back(map.placeText(map.networks()[i]));
    }
    for (std::size_t i = 0; i < exercises.size(); ++i) {
      if (exercises[i]->isMet()) sheet.requirements[i].tests.push_back(test.name);
    }
    all.add(recorder);
  }
}

/// A person waits for a time: finds the rows whose wait in scans may not become the time of so many of the longest
/// ones, as with shorter scans what they or rows behind them expect then does not come.
class ScanCounting {
 public:
  ScanCounting(const Program& program, const TestTable& table, const GeneratorOptions& options)
      : program_(program), table_(table), options_(options) {
    const std::uint32_t step = std::max<std::uint32_t>((options.highUs - options.lowUs) / mostLengths, 1000);
    for (std::uint32_t us = options.lowUs; us < options.highUs; us += step) lengths_.push_back(us);
    lengths_.push_back(options.highUs);
  }

  /// By row. What there is no time to try counts scans.
  std::vector<bool> rowsOf(const TestCase& test) {
    std::vector<bool> counts(test.rows.size(), false);
    TestCase timed = test;
    for (TestRow& row : timed.rows) {
      if (!row.wait.isTime()) row.wait = {1, row.wait.scans * options_.highUs};
      if (row.note.starts_with("timing")) row.expects.assign(row.expects.size(), std::nullopt);
    }
    // Each length must pass with the rows that are marked at last.
    for (std::size_t passed = 0, next = 0; passed < lengths_.size();) {
      if (scans_ > mostScansTried) {
        counts.assign(counts.size(), true);
        break;
      }
      const std::optional<std::size_t> failing = failingRow(timed, lengths_[next]);
      if (!failing) {
        ++passed;
        next = (next + 1) % lengths_.size();
        continue;
      }
      // The row itself counts scans, or the nearest one in front of it does.
      std::size_t row = *failing + 1;
      while (row > 0 && (test.rows[row - 1].wait.isTime() || counts[row - 1])) --row;
      if (row == 0) break;  // all waits up to there are those of the table
      counts[row - 1] = true;
      timed.rows[row - 1].wait = test.rows[row - 1].wait;
      passed = 0;
    }
    return counts;
  }

 private:
  static constexpr std::uint32_t mostLengths = 32;
  static constexpr std::uint64_t mostScansTried = 1'000'000;  ///< for all tests of a table

  std::optional<std::size_t> failingRow(const TestCase& test, std::uint32_t us) {
    TestPlayOptions play;
    play.engine = options_.engine;
    play.length = [us](std::uint64_t) { return us; };
    Simulator simulator(program_, options_.engine);
    const TestPlay played = playTest(simulator, table_, test, play);
    scans_ += played.scans;
    return played.failures.empty() ? std::nullopt : std::optional(played.failures.front().step);
  }

  const Program& program_;
  const TestTable& table_;
  const GeneratorOptions& options_;
  std::vector<std::uint32_t> lengths_;
  std::uint64_t scans_ = 0;
};

/// What memory holds where each test begins, if some of it is kept without power.
std::string memoryText(const Program& program, const GeneratorOptions& options) {
  if (retentiveRanges(program, options.engine.retentive).empty() && program.retained.empty()) return {};
  return dialectOf(program.target).memory.isOfVariables
             ? "Each test begins with every variable at its initial value. RETAIN variables keep theirs without power: "
               "reset them to their initial values before each test."
             : "Each test begins with memory, timers and counters at zero, and data blocks with their initial values. "
               "Retentive ones keep their values without power: clear them before each test.";
}

/// What the expected values rest on.
std::vector<std::string> basisOf(const GeneratedTests& made, const Program& program, const PropertySet& set,
                                 const GeneratorOptions& options) {
  const double low = static_cast<double>(options.lowUs) / 1000, high = static_cast<double>(options.highUs) / 1000;
  std::vector<std::string> lines;
  if (std::string memory = memoryText(program, options); !memory.empty()) lines.push_back(std::move(memory));
  for (const Property& property : set.properties) {
    if (!property.isGoal()) lines.push_back(fmt::format("The surroundings keep to: {}", property.text));
  }
  if (made.provedCells > 0)
    lines.push_back(fmt::format(
        "{} values to be seen are proved for scans of every whole number of milliseconds from {:g} to {:g} ms, all "
        "equally long, with inputs up to two scans early or late: every such run was made (time bases begin with "
        "power-on).",
        made.provedCells, low, high));
  if (made.checkedCells > 0)
    lines.push_back(fmt::format("{} values to be seen are not proved: not every such run was made, or could be.",
                                made.checkedCells));
  lines.push_back(fmt::format(
      "All were tried with scans of fractions of a millisecond, of changing lengths and with other phases of the "
      "timers' time bases too, {} runs in all.",
      made.plays));
  if (made.silentRows > 0)
    lines.push_back(
        fmt::format("{} steps name outputs that are not compared, as the length of scans decides when they "
                    "change.",
                    made.silentRows));
  if (made.timingRows > 0)
    lines.push_back(fmt::format(
        "Steps with the remark 'timing': {}. What they name depends on the length of scans; {} such values are to be "
        "seen with the scans that the remark names.",
        made.timingRows, made.timedCells));
  if (made.triedRows > 0)
    lines.push_back(fmt::format(
        "{} steps with the remark 'timing: tried' are not proved: devices of the CPU (fast counters, pulses, "
        "ports, network, clock) have a part in their runs, and a run cannot go on from the middle.",
        made.triedRows));
  return lines;
}

bool writeEach(const Context& context, const std::string& directory, const std::vector<FileToWrite>& files,
               std::vector<std::string>& written) {
  namespace fs = std::filesystem;
  std::error_code error;  // a folder that cannot be made shows when a file is written
  for (const FileToWrite& file : files) {
    const fs::path path = fs::path(directory) / file.name;
    fs::create_directories(path.parent_path(), error);
    if (context.write({file.form, pathName(path)}, file.text)) {
      written.push_back(pathName(path));
      continue;
    }
    for (const std::string& name : written) fs::remove(name, error);
    written.clear();
    return false;
  }
  return true;
}

}  // namespace

bool generateInto(TestReport& report, TestTable& table, const Context& context, const CoverageMap& map,
                  const PropertySet& set, const GenerateRequest& request, const ProverOptions& prover) {
  GeneratorOptions options;
  options.engine = request.engine;
  options.lowUs = static_cast<std::uint32_t>(request.scanTime.low.count());
  options.highUs = static_cast<std::uint32_t>(request.scanTime.high.count());
  options.shownUs = static_cast<std::uint32_t>(request.shownTime.low.count());
  options.measures = request.measures;
  options.changesTogether = request.changesTogether;
  options.seed = request.engine.seed;
  options.prover = prover;
  options.prover.certificates = true;
  options.prover.unread = request.unread;
  if (const auto timeout = context.settings.isSet(Opt::Timeout) ? context.settings.timeout() : std::nullopt)
    options.seconds = static_cast<double>(timeout->count()) / 1e6;
  GeneratedTests made = generateTests(map, set, options);

  std::vector<FileToWrite> proofs;
  TestSheet sheet;
  sheet.title = request.title;
  sheet.hash = request.hash;
  sheet.table = made.table;
  const auto addSignal = [&](const TraceSignal& signal) {
    const Symbol* const symbol = map.program().symbolOf(signal.operand);
    sheet.signals.push_back({signal.symbol, signal.name, symbol == nullptr ? "" : symbol->comment});
  };
  for (const StimulusColumn& column : made.table.sets) addSignal(column.signal);
  for (const TraceSignal& signal : made.table.expects) addSignal(signal);
  CoverageRecorder all(map);
  describeTests(sheet, all, set, request);
  report.coverage = coverageOf(all);
  for (auto& [name, measure] : report.coverage->measures) {
    for (MissingGoal& missing : measure.missing) settle(measure, missing, made.answers, proofs);
  }
  report.asked = request.measures;
  sheet.coverage = *report.coverage;
  sheet.basis = basisOf(made, map.program(), set, options);
  sheet.lowMs = static_cast<double>(options.lowUs) / 1000;
  sheet.highMs = static_cast<double>(options.highUs) / 1000;
  ScanCounting counting(map.program(), made.table, options);
  for (const TestCase& test : made.table.tests) sheet.countsScans.push_back(counting.rowsOf(test));
  made.table.file = pathName(std::filesystem::path(request.directory) / "tests.csv");

  Json coverage = {{"instructions", request.read.instructions},
                   {"understood", request.read.understood},
                   {"approximated", request.read.approximated}};
  addMeasures(coverage, *report.coverage);
  std::vector<FileToWrite> files{
      {"tests.csv", "csv", testTableText(made.table)},
      {"sheet.html", "html", sheetHtml(sheet)},
      {"sheet.md", "markdown", sheetMarkdown(sheet)},
      {"sheet/sheet.csv", "csv", sheetCsv(sheet)},
      {"coverage.html", "html", coveragePage(*report.coverage, coverageDrawings(all), request.title)},
      {"coverage.json", "json", coverage.dump(2) + "\n"}};
  files.insert(files.end(), proofs.begin(), proofs.end());
  table = std::move(made.table);
  return writeEach(context, request.directory, files, report.written);
}

}  // namespace rungproof
