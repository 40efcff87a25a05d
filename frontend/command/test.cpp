// `rungproof test`: runs test tables, measures what they and stimuli cover, writes tables and sheets.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "analysis/testing/kill.hpp"
#include "engine/platform/names.hpp"
#include "frontend/command.hpp"
#include "frontend/files/sha256.hpp"
#include "frontend/input/program_input.hpp"
#include "frontend/input/proof_input.hpp"
#include "frontend/logger/trace_import.hpp"
#include "frontend/simulation/run_report.hpp"
#include "frontend/simulation/scan_lengths.hpp"
#include "frontend/simulation/stimulus_reader.hpp"
#include "frontend/simulation/trace_file.hpp"
#include "frontend/testing/coverage_page.hpp"
#include "frontend/testing/generate.hpp"
#include "frontend/testing/recorded_table.hpp"
#include "frontend/testing/table_reader.hpp"
#include "frontend/testing/table_run.hpp"
#include "frontend/watch.hpp"

namespace rungproof {

namespace {

struct TestArguments {
  std::vector<std::string> files, tables, stimuli, properties;
  bool coverage = false, kill = false, together = false, watch = false;
  std::string generate, goal = "all", show, record, output = "-";
};

class TestRun {
 public:
  TestRun(const TestArguments& arguments, Context& context) : arguments_(arguments), context_(context) {}

  Exit run() {
    if (const auto failure = unusable()) return context_.fail(*failure);
    ProgramInput input = readInput(context_, arguments_.files, arguments_.properties);
    Report report = startReport("test", input.program, arguments_.files);
    const UnreadCode unread(input.program);
    if (unread.hinderRuns()) return refuse(report, input.program, unread);
    if (unread.isRefused()) {  // in what never runs
      printUnread(context_, "test", input.program, unread, arguments_.files);
      report.reasons.push_back({Exit::Failed, "a part that no test needs is refused"});
    }
    const Program program = unread.executable();
    std::erase_if(report.findings, [](const Finding& finding) { return finding.severity != Severity::Error; });
    if (program.main() == nullptr)
      return context_.fail(
          {"there is no main program to run", arguments_.files.front(), "give the file that holds the main program"});
    if (!arguments_.record.empty()) return record(program, input.properties);
    readTables(program);
    if (!failures_.empty()) return failAll(context_, failures_);

    TestReport tests;
    const CoverageMap map(program, context_.settings.choices());
    CoverageRecorder recorder(map);
    const bool measures = arguments_.coverage || !arguments_.stimuli.empty();
    TableRunOptions options = runOptions(program);
    if (measures) options.coverage = &recorder;
    if (!arguments_.generate.empty()) {
      TestTable made;
      if (!generateInto(tests, made, context_, map, input.properties, generateRequest(options, program, unread, report),
                        proverOptionsOf(context_.settings, {&program})))
        return Exit::Failed;
      tables_.push_back(std::move(made));
    }
    for (const TestTable& table : tables_) {
      for (TestResult& result : runTable(program, table, options)) tests.tests.push_back(std::move(result));
    }
    for (const Stimulus& stimulus : stimuli_) play(program, stimulus, options, recorder);
    if (measures) {
      if (!tests.coverage) tests.coverage = coverageOf(recorder);
      if (options.hasPage) tests.drawings = coverageDrawings(recorder);
    }
    if (arguments_.kill && tests.failed() == 0)
      tests.kills = kill(program, input.properties, options);
    else if (arguments_.kill)
      context_.err << "rungproof: no fault is planted: the program itself does not pass the tests\n";
    describe(report, program, options);
    report.tests = std::make_shared<const TestReport>(std::move(tests));
    return finish(context_, std::move(report));
  }

 private:
  std::optional<Failure> unusable() const {
    if (!arguments_.record.empty() && (!arguments_.tables.empty() || !arguments_.generate.empty()))
      return Failure{"--record writes a table and runs none", {}, "run the table that it has written"};
    if (!arguments_.tables.empty() || !arguments_.stimuli.empty() || !arguments_.generate.empty() ||
        !arguments_.record.empty())
      return std::nullopt;
    return Failure{
        "nothing is to be tested", {}, "give a table with --table, a stimulus with --stimulus, or --generate DIR"};
  }

  Exit refuse(Report& report, const Program& program, const UnreadCode& unread) {
    std::erase_if(report.findings, [](const Finding& finding) { return finding.severity != Severity::Error; });
    addUnread(report, program, unread);
    report.reasons.push_back({Exit::Failed, "the program is not run"});
    const std::string hindrance = unread.hindrance();
    context_.err << fmt::format("rungproof: the program is not tested: {}\n", !hindrance.empty() ? hindrance
                                                                              : !unread.texts().empty()
                                                                                  ? unread.texts().front()
                                                                                  : "a part of it is refused");
    finish(context_, std::move(report));
    return Exit::Failed;
  }

  /// Writes a trace as a table.
  Exit record(const Program& program, const PropertySet& set) {
    const TraceImport import = traceImportOf(context_.settings, failures_);
    Trace trace;
    if (const std::optional<std::string> text = readFile(context_, arguments_.record, failures_))
      trace = readTrace(arguments_.record, *text, program, failures_, "old", import);
    if (!failures_.empty()) return failAll(context_, failures_);
    const TestTable table = recordedTable(program, set, trace, "recorded");
    if (!table.expectsAnything())
      return context_.fail({"the trace holds no value of an output, so the table would compare nothing",
                            arguments_.record, "record the outputs of the program too"});
    return context_.write({"csv", arguments_.output}, testTableText(table)) ? Exit::Clean : Exit::Failed;
  }

  void readTables(const Program& program) {
    const TraceImport import = traceImportOf(context_.settings, failures_);
    for (const std::string& name : arguments_.tables) {
      if (const std::optional<std::string> text = readFile(context_, name, failures_))
        tables_.push_back(readTestTable(name, *text, program, import.separator, failures_));
    }
    for (const std::string& name : arguments_.stimuli) {
      if (const std::optional<std::string> text = readFile(context_, name, failures_))
        stimuli_.push_back(readStimulus(name, *text, program, failures_, "old", import));
    }
    std::string names;
    for (const std::string& name : arguments_.stimuli) names += (names.empty() ? "" : ", ") + name;
    if (failures_.empty() && !arguments_.stimuli.empty()) checkRenames(import, names, failures_);
  }

  TableRunOptions runOptions(const Program& program) const {
    TableRunOptions options;
    options.engine.retentive = context_.settings.retentive();
    options.engine.choices = context_.settings.choices();
    options.engine.phaseMs = context_.settings.phaseMs();
    options.engine.seed = static_cast<std::uint64_t>(std::stoull(std::string(context_.settings.text(Opt::Seed))));
    options.scanTime = scanTimeFor(context_.settings, program);
    options.hasPage = std::ranges::any_of(context_.outputs, [](const OutputRequest& o) { return o.name == "html"; });
    if (!arguments_.show.empty())
      options.shows = arguments_.show == "fbd" ? Form::Fbd : arguments_.show == "stl" ? Form::Stl : Form::Ladder;
    return options;
  }

  /// A stimulus until its last row.
  static void play(const Program& program, const Stimulus& stimulus, const TableRunOptions& options,
                   CoverageRecorder& recorder) {
    GivenValues givenValues(options.engine.choices);
    GivenValues* const given = stimulus.isWhole ? &givenValues : nullptr;
    Simulator simulator(program, given != nullptr ? wholeOptions(options.engine.choices) : options.engine, given);
    givenValues.setState(simulator.store());
    if (given != nullptr) beginWhole(simulator, stimulus, options.engine.choices);
    simulator.observe(&recorder);
    StimulusPlayer player(simulator, stimulus, given);
    const ScanLength length = scanLengthsOf(options.scanTime, options.engine.seed);
    const auto goesOn = [&] {
      if (stimulus.rows.empty() || !simulator.isRunning()) return false;
      const StimulusRow& last = stimulus.rows.back();
      return stimulus.isByTime ? simulator.timeUs() <= last.timeUs : simulator.scanCount() < last.scan;
    };
    while (goesOn()) {
      ScanRequest request = player.next();
      if (request.lengthUs == 0) request.lengthUs = length(simulator.scanCount() + 1);
      recorder.beginScan();
      simulator.scan(request);
    }
  }

  GenerateRequest generateRequest(const TableRunOptions& options, const Program& program, const UnreadCode& unread,
                                  const Report& report) const {
    using namespace std::chrono_literals;
    GenerateRequest request;
    request.directory = arguments_.generate;
    std::erase_if(request.measures,
                  [&](Measure measure) { return arguments_.goal != "all" && arguments_.goal != measureWord(measure); });
    request.changesTogether = arguments_.together;
    request.engine = options.engine;
    request.scanTime = scanTimeFor(context_.settings, program, {1ms, 100ms});
    request.shownTime = options.scanTime;
    request.title = pathName(std::filesystem::path(arguments_.files.front()).filename());
    std::string text;
    for (std::uint32_t i = 0; i < program.sources->size(); ++i) text += program.sources->file(i).text();
    request.hash = sha256(text);
    request.unread = &unread;
    request.read = report.coverage;
    return request;
  }

  std::vector<PlantedFault> kill(const Program& program, const PropertySet& set, const TableRunOptions& options) const {
    KillOptions kill;
    kill.play.engine = options.engine;
    kill.play.length = scanLengthsOf(options.scanTime, options.engine.seed);
    kill.prover = proverOptionsOf(context_.settings, {&program});
    std::vector<PlantedFault> faults;
    for (const KillResult& result : killMutants(program, set, tables_, kill)) {
      const Fault& fault = result.mutant.fault;
      const Pou& pou = program.pous[fault.pou];
      const Network& network = pou.networks[fault.network];
      const Span span = network.instructions[fault.instruction].span;
      const std::string_view fate = result.fate == FaultFate::Noticed     ? "noticed"
                                    : result.fate == FaultFate::Unnoticed ? "unnoticed"
                                    : result.fate == FaultFate::NoEffect  ? "without effect"
                                                                          : "undecided";
      faults.push_back({result.mutant.kind, fault.text, std::string(program.sources->file(span.file).name()),
                        program.sources->position(span).line, pou.name, network.number, std::string(fate),
                        result.noticedBy, result.where});
    }
    return faults;
  }

  static void describe(Report& report, const Program& program, const TableRunOptions& options) {
    const auto ms = [](Duration duration) { return static_cast<double>(duration.count()) / 1000; };
    report.assumptions.push_back(fmt::format("CPU {}", cpuName(program.target.cpu)));
    report.assumptions.push_back(options.scanTime.low == options.scanTime.high
                                     ? fmt::format("scan time {:g} ms", ms(options.scanTime.low))
                                     : fmt::format("scan time {:g} ms to {:g} ms, drawn with --seed {}",
                                                   ms(options.scanTime.low), ms(options.scanTime.high),
                                                   options.engine.seed));
  }

  const TestArguments& arguments_;
  Context& context_;
  std::vector<TestTable> tables_;
  std::vector<Stimulus> stimuli_;
  std::vector<Failure> failures_;
};

Action setUpTest(ArgumentTable& table) {
  auto arguments = std::make_shared<TestArguments>();
  table.arguments("FILE", arguments->files, "programs, symbol tables and data blocks; '-' is standard input");
  table.option("--table", arguments->tables, "FILE", "test table (CSV); may be repeated");
  table.option("--stimulus", arguments->stimuli, "FILE",
               "trace whose coverage is measured (CSV, VCD); may be repeated");
  table.flag("--coverage", arguments->coverage, "measure networks, contacts, transitions and MC/DC pairs");
  table.word("--show", arguments->show, {"ladder", "fbd", "stl"}, "ladder|fbd|stl",
             "draw the networks behind a failing value, with the power flow of its scan");
  table.option("--generate", arguments->generate, "DIR",
               "write tests that cover the program into this folder: tests.csv, sheet.html and .md, "
               "coverage.html and .json");
  table.word("--goal", arguments->goal, {"networks", "contacts", "transitions", "mcdc", "all"},
             "networks|contacts|transitions|mcdc|all", "what generated tests are to cover [default: all]");
  table.flag("--together", arguments->together, "a generated step may change several inputs");
  table.flag("--kill", arguments->kill, "plant faults and say which of them the tests notice");
  table.option("--record", arguments->record, "TRACE", "write this trace (CSV, VCD) as a test table");
  table.option("-o,--output", arguments->output, "FILE", "with --record: the table; standard output");
  table.option("--props", arguments->properties, "FILE",
               "requirements that the sheet names, and assumptions; may be repeated");
  table.flag(watchOption, arguments->watch, watchHelp);
  return [arguments](Context& context) { return TestRun(*arguments, context).run(); };
}

}  // namespace

extern constexpr Command testCommand = {
    .name = "test",
    .usage = "FILE... [--table FILE]... [--coverage] [--generate DIR]",
    .summary = "run test tables, measure what they cover, write tests",
    .details =
        "A test table is a CSV file with the columns test (name; a new name begins with power-on), step (text),\n"
        "wait ('1 scan', '5 scans', '500ms'; one scan if empty), 'set ADDRESS' and 'expect ADDRESS', and note.\n"
        "A row sets the given inputs, lets the wait pass and compares at its end. Cells of 'expect' are a value,\n"
        "a range such as 100..200, or empty or x for any value; empty cells of 'set' keep the value.\n"
        "\n"
        "Generated tests change one input a step. Every value that they expect comes with scans of --scan-time\n"
        "(1ms..100ms) and with inputs up to two scans early or late; the sheet says how many values are proved and\n"
        "how many were tried only. What depends on the length of scans is not compared, or the step says 'timing' in "
        "the\n"
        "column note and with which scans the value comes. What cannot be covered is listed with its proof.\n"
        "\n"
        "Examples:\n"
        "    rungproof test press.awl --table press.test.csv\n"
        "    rungproof test press.awl --table press.test.csv --show ladder --format junit=tests.xml\n"
        "    rungproof test press.awl --table press.test.csv --coverage --format html=tests.html\n"
        "    rungproof test press.awl --generate acceptance --props press.prop\n"
        "    rungproof test press.awl --table acceptance/tests.csv --kill\n"
        "    rungproof test press.awl --record run.csv -o run.test.csv\n",
    .shows = option_group::Reading | option_group::Running | option_group::Traces | option_group::Output |
             option_group::Configuration,
    .setup = setUpTest,
};

}  // namespace rungproof
