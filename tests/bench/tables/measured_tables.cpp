// Generation and planted faults by the public command; replays by the player of the tables.
#include "tests/bench/tables/measured_tables.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <random>
#include <sstream>

#include "analysis/testing/test_signals.hpp"
#include "engine/coverage/coverage_goals.hpp"
#include "engine/testing/test_player.hpp"
#include "frontend/input/program_input.hpp"
#include "frontend/input/project.hpp"
#include "frontend/testing/table_reader.hpp"
#include "tests/bench/tables/text_mutant.hpp"
#include "tests/corpus/corpus_program.hpp"
#include "tests/machine_pace.hpp"
#include "tests/program_run.hpp"

namespace rungproof::tables {

namespace {

constexpr std::size_t mostOfRandom = 40;  ///< times the steps of the generated tests
constexpr std::size_t stepsOfRandomTest = 60;

SimulatorOptions engineOf(const std::filesystem::path& file) {
  SimulatorOptions engine;
  engine.choices = test::proverOptions(file).choices;
  return engine;
}

class Measurement {
 public:
  Measurement(const std::filesystem::path& file, const Questions& questions) : file_(file), questions_(questions) {
    for (const auto& [name, value] : test::optionsOf(file)) {
      if (name == "--scan-time") continue;  // tests hold for all scan times
      std::istringstream all(value);
      for (std::string one; std::getline(all, one, ',');) options_.insert(options_.end(), {name, one});
    }
  }

  std::optional<Figures> run(std::size_t most) {
    ReadOptions reading;
    for (std::size_t i = 0; i + 1 < options_.size(); i += 2) {
      if (options_[i] == "--dialect") reading.dialect = options_[i + 1];
      if (options_[i] == "--cpu") reading.target.cpu = *cpuNamed(options_[i + 1]);
    }
    program_ = readProgram(expandFolders({file_.string()}), reading);
    figures_.program =
        std::filesystem::relative(file_, std::filesystem::path(RUNGPROOF_SOURCE_DIR) / "corpus").string();
    const double begin = test::processorSeconds();
    const test::ProgramRun made = command({"--generate", folder_.path("t"), "--format", "json"});
    figures_.seconds = test::processorSeconds() - begin;
    if (made.exit == 2) return std::nullopt;
    const nlohmann::json report = nlohmann::json::parse(made.out);
    figures_.instructions = report["coverage"]["instructions"];
    if (figures_.instructions > most) return std::nullopt;
    for (const char* measure : {"networks", "contacts", "transitions", "mcdc"}) {
      const nlohmann::json& one = report["coverage"][measure];
      figures_.goals += one["total"].get<std::size_t>();
      figures_.open += one["open"].get<std::size_t>();
      for (const nlohmann::json& goal : one["goals"]) {
        if (goal["state"] == "open") figures_.openGoals.push_back(goal["goal"]);
      }
    }
    std::vector<Failure> failures;
    table_ = readTestTable("tests.csv", test::contentOf(folder_.path("t/tests.csv")), program_, 0, failures);
    countRows();
    replay();
    if (questions_.kills) plantFaults();
    if (questions_.textMutants > 0) plantInText();
    if (questions_.random) tryAtRandom(report["coverage"]);
    return figures_;
  }

 private:
  test::ProgramRun command(std::vector<std::string> more, const std::string& program = "") const {
    std::vector<std::string> arguments{"test", program.empty() ? file_.string() : program, "--isolated"};
    arguments.insert(arguments.end(), options_.begin(), options_.end());
    arguments.insert(arguments.end(), more.begin(), more.end());
    return test::run(arguments);
  }

  void countRows() {
    figures_.tests = table_.tests.size();
    for (const TestCase& test : table_.tests) {
      figures_.rows += test.rows.size();
      for (const TestRow& row : test.rows) {
        figures_.timingRows += row.note.starts_with("timing") ? 1 : 0;
        for (const auto& cell : row.expects) figures_.cells += cell ? 1 : 0;
      }
    }
  }

  /// Any scan time, any skews: what fails in a row without mark is a failure of the generator.
  void replay() {
    std::mt19937 random(1);
    for (std::size_t round = 0; round < questions_.replays; ++round) {
      const std::uint32_t us = 1000 + random() % 99001;
      for (const TestCase& test : table_.tests) {
        TestPlayOptions play;
        play.length = [us](std::uint64_t) { return us; };
        play.stopsAtFailure = false;
        for (std::size_t i = 0; i < test.rows.size(); ++i) play.skews.push_back(static_cast<int>(random() % 5) - 2);
        Simulator simulator(program_, engine_);
        for (const TestFailure& failure : playTest(simulator, table_, test, play).failures)
          figures_.failures += test.rows[failure.step].note.starts_with("timing") ? 0 : 1;
      }
    }
  }

  void plantFaults() {
    const test::ProgramRun killed = command({"--table", folder_.path("t/tests.csv"), "--kill", "--format", "json"});
    if (killed.exit == 2) return;
    const nlohmann::json report = nlohmann::json::parse(killed.out);
    if (!report.contains("kills")) return;
    for (const nlohmann::json& fault : report["kills"]["faults"]) {
      const std::string fate = fault["fate"];
      Faults& faults = figures_.planted;
      ++(fate == "noticed"          ? faults.noticed
         : fate == "unnoticed"      ? faults.unnoticed
         : fate == "without effect" ? faults.withoutEffect
                                    : faults.undecided);
      if (fate == "unnoticed")
        faults.missed.push_back(
            fmt::format("{}: {}", fault["kind"].get<std::string>(), fault["text"].get<std::string>()));
    }
  }

  void plantInText() {
    if (std::filesystem::is_directory(file_)) return;
    for (const TextMutant& mutant : textMutantsOf(test::contentOf(file_), questions_.textMutants, 1)) {
      const std::string changed = folder_.file("m" + file_.extension().string(), mutant.text);
      const test::ProgramRun tested = command({"--table", folder_.path("t/tests.csv"), "--format", "json"}, changed);
      Faults& faults = figures_.ofText;
      if (tested.exit == 2) continue;  // refused: nobody runs it
      if (tested.exit == 1) {
        ++faults.noticed;
        continue;
      }
      std::vector<std::string> arguments{"equiv", file_.string(), changed, "--isolated", "--timeout", "2s"};
      arguments.insert(arguments.end(), options_.begin(), options_.end());
      const int exit = test::run(arguments).exit;
      ++(exit == 0 ? faults.withoutEffect : exit == 1 ? faults.unnoticed : faults.undecided);
      if (exit == 1) faults.missed.push_back(mutant.what);
    }
  }

  static bool isCovered(const CoverageRecorder& recorder, const nlohmann::json& wanted) {
    std::map<Measure, std::size_t> covered;
    for (const CoverageItem& item : coverageItems(recorder)) covered[item.first.measure] += item.isCovered ? 1 : 0;
    return std::ranges::all_of(allMeasures, [&](Measure measure) {
      return covered[measure] >= wanted[std::string(measureWord(measure))]["covered"].get<std::size_t>();
    });
  }

  /// Tests that notice faults come behind those that cover.
  void countCoverageSteps(const CoverageMap& map, const nlohmann::json& wanted) {
    CoverageRecorder recorder(map);
    for (const TestCase& test : table_.tests) {
      if (isCovered(recorder, wanted)) return;
      figures_.coverageSteps += test.rows.size();
      TestPlayOptions play;
      play.stopsAtFailure = false;
      play.observer = &recorder;
      play.beforeScan = [&](std::uint64_t) { recorder.beginScan(); };
      Simulator simulator(program_, engine_);
      playTest(simulator, table_, test, play);
    }
  }

  /// Steps as somebody takes them who knows only the inputs, until as much is covered as the tests cover.
  void tryAtRandom(const nlohmann::json& wanted) {
    const TestSignals signals = testSignalsOf(program_, readProperties(program_, {}, lookupIn(program_)));
    const CoverageMap map(program_);
    countCoverageSteps(map, wanted);
    CoverageRecorder recorder(map);
    std::mt19937 random(1);
    const std::size_t most = mostOfRandom * figures_.coverageSteps;
    while (!isCovered(recorder, wanted) && figures_.randomSteps < most) {
      Simulator simulator(program_, engine_);
      simulator.observe(&recorder);
      for (std::size_t step = 0; step < stepsOfRandomTest && figures_.randomSteps < most; ++step) {
        if (isCovered(recorder, wanted)) break;
        ++figures_.randomSteps;
        if (!signals.inputs.empty()) {
          const TestInput& input = signals.inputs[random() % signals.inputs.size()];
          const double value = input.values[random() % input.values.size()];
          simulator.write(input.signal.operand, valueOf(value, input.signal.type, input.signal.width()));
        }
        // Mostly short, sometimes as long as timers take.
        const std::uint64_t scans = random() % 4 == 0 ? 100 + random() % 900 : 6;
        for (std::uint64_t i = 0; i < scans; ++i) {
          recorder.beginScan();
          simulator.scan({.lengthUs = 10000});
        }
      }
    }
    figures_.isRandomCut = !isCovered(recorder, wanted);
  }

  const std::filesystem::path file_;
  const SimulatorOptions engine_ = engineOf(file_);
  const Questions& questions_;
  std::vector<std::string> options_;
  test::TemporaryFolder folder_;
  Program program_;
  TestTable table_;
  Figures figures_;
};

}  // namespace

std::optional<Figures> measure(const std::filesystem::path& program, const Questions& questions, std::size_t most) {
  return Measurement(program, questions).run(most);
}

}  // namespace rungproof::tables
