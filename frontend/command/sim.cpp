// `rungproof sim`: runs a program on the reference engine with a stimulus, writes traces, compares with an expected
// one.
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <deque>
#include <functional>
#include <memory>
#include <ostream>
#include <utility>

#include "analysis/unread/run_until_unread.hpp"
#include "engine/stimulus.hpp"
#include "frontend/command.hpp"
#include "frontend/input/program_input.hpp"
#include "frontend/input/protected_findings.hpp"
#include "frontend/logger/trace_import.hpp"
#include "frontend/simulation/comparison.hpp"
#include "frontend/simulation/expected_lanes.hpp"
#include "frontend/simulation/first_values.hpp"
#include "frontend/simulation/run_limits.hpp"
#include "frontend/simulation/run_report.hpp"
#include "frontend/simulation/scan_drawings.hpp"
#include "frontend/simulation/scan_lengths.hpp"
#include "frontend/simulation/stimulus_column.hpp"
#include "frontend/simulation/stimulus_reader.hpp"
#include "frontend/simulation/trace_file.hpp"
#include "frontend/simulation/unread_watch.hpp"
#include "frontend/trace_format.hpp"
#include "ir/s7300/library_contract.hpp"

namespace rungproof {

namespace {

constexpr std::uint64_t scansByDefault = 100;

struct SimArguments {
  std::vector<std::string> files;
  std::string stimulus;
  std::string expect;
  std::vector<std::string> traces;
  std::vector<std::string> signals;
  std::vector<std::string> tolerances;
  std::vector<std::string> values;
  bool asDownloaded = false;
  unsigned slack = 0;
  std::uint64_t scans = 0;
  std::string duration;
  std::string side = "old";
  std::string names = "address";
  std::string engine = "auto";

  EngineKind engineKind() const {
    return engine == "reference"  ? EngineKind::Reference
           : engine == "compiled" ? EngineKind::Compiled
                                  : EngineKind::Auto;
  }
  SignalNames signalNames() const {
    return names == "symbol" ? SignalNames::Symbol : names == "both" ? SignalNames::Both : SignalNames::Address;
  }
};

/// What the arguments and files ask for, ready to run.
struct Job {
  Stimulus stimulus;
  std::optional<Trace> expected;
  CompareOptions compare;
  std::vector<TraceSignal> signals;
  std::uint64_t scans = 0;       ///< run at least so many scans
  std::uint64_t durationUs = 0;  ///< and until a scan has begun at this time or later
  ScanTime scanTime{};
  bool keepsTrace = true;               ///< somebody looks at the trace afterwards
  std::optional<std::string> stream{};  ///< file to which rows go while the run goes on; "-": standard output
  bool isSparse = false;                ///< only the scans at expected moments are looked at, and those around them
  std::uint64_t memory = 0;             ///< bytes that the trace may take
  UnreadWatch* unread = nullptr;        ///< where the run may come to what was not read

  /// Scans before and behind one that is looked at.
  std::size_t around() const { return compare.slack + scansAround; }
  /// Rows of a trace of so many scans that are kept at most.
  std::uint64_t keptRows(std::uint64_t scans) const {
    return isSparse ? std::min<std::uint64_t>(scans, (expected->rows.size() + 1) * (2 * around() + 1)) : scans;
  }
};

/// Keeps the rows of a run that a comparison by time looks at: the scans in which expected moments fall, with those
/// around them, and the last ones.
class RowsAtMoments {
 public:
  RowsAtMoments(const Trace& expected, std::size_t around, std::vector<TraceRow>& kept)
      : moments_(expected.rows), isSampled_(expected.isSampled), around_(around), kept_(kept) {}
  ~RowsAtMoments() { keepWaiting(); }
  RowsAtMoments(const RowsAtMoments&) = delete;
  RowsAtMoments& operator=(const RowsAtMoments&) = delete;

  void add(TraceRow row) {
    bool isLookedAt = false;
    const auto isPast = [&](std::uint64_t us) { return isSampled_ ? us < row.timeUs : us <= row.timeUs; };
    for (; next_ < moments_.size() && isPast(moments_[next_].timeUs); ++next_) isLookedAt = true;
    if (isLookedAt) {
      keepWaiting();
      left_ = around_ + 1;
    }
    if (left_ > 0) {
      --left_;
      kept_.push_back(std::move(row));
      return;
    }
    waiting_.push_back(std::move(row));
    if (waiting_.size() > around_) waiting_.pop_front();
  }

 private:
  void keepWaiting() {
    std::ranges::move(waiting_, std::back_inserter(kept_));
    waiting_.clear();
  }

  const std::vector<TraceRow>& moments_;
  const bool isSampled_;
  std::size_t around_, next_ = 0, left_ = 0;
  std::deque<TraceRow> waiting_;  ///< the last ones, in case that the next is looked at
  std::vector<TraceRow>& kept_;
};

class Preparation {
 public:
  Preparation(const SimArguments& arguments, const Context& context, const Program& program)
      : arguments_(arguments), context_(context), program_(program) {}

  Job job() {
    Job job;
    readFiles(job);
    chooseSignals(job);
    chooseLength(job);
    setFirst(job.stimulus, arguments_.values, program_, failures);
    job.scanTime = scanTimeFor(context_.settings, program_);
    for (const std::string& name : arguments_.traces) {
      if (auto failure = checkTraceName(name)) failures.push_back(*failure);
    }
    job.stream = streamed(job);
    job.keepsTrace = !job.stream && (!arguments_.traces.empty() || job.expected || isResult());
    job.isSparse = job.expected && job.expected->isByTime && arguments_.traces.empty() &&
                   std::ranges::is_sorted(job.expected->rows, {}, &TraceRow::timeUs);
    job.memory = context_.settings.memory().value_or(mostTraceBytes);
    if (failures.empty()) checkLength(job);
    return job;
  }

  /// Nothing else was asked for: the trace itself is the result.
  bool isResult() const {
    return arguments_.traces.empty() && arguments_.expect.empty() && context_.outputs.size() == 1 &&
           context_.outputs[0].file.empty() && context_.outputs[0].name == "human";
  }

  std::vector<Failure> failures;

 private:
  /// One trace that nobody else looks at needs no memory, where its form takes row by row.
  std::optional<std::string> streamed(const Job& job) const {
    if (job.expected || arguments_.traces.size() > 1) return std::nullopt;
    if (arguments_.traces.empty()) return isResult() ? std::optional<std::string>("-") : std::nullopt;
    const TraceFormat* format = traceFormatFor(arguments_.traces.front());
    return format != nullptr && format->appendRow != nullptr ? std::optional(arguments_.traces.front()) : std::nullopt;
  }

  /// What is too long even with the longest scans need not be begun.
  void checkLength(const Job& job) {
    auto longest = static_cast<std::uint64_t>(job.scanTime.high.count());
    for (const StimulusRow& row : job.stimulus.rows) longest = std::max<std::uint64_t>(longest, row.scanUs.value_or(0));
    const std::uint64_t scans = std::max(job.scans, job.durationUs / longest);
    auto failure = refusedRun(scans, 0, job.memory);
    if (!failure) failure = refusedRun(job.keptRows(scans), job.keepsTrace ? job.signals.size() : 0, job.memory);
    if (!failure) return;
    failure->place = !arguments_.stimulus.empty() ? arguments_.stimulus : arguments_.expect;
    failures.push_back(*failure);
  }

  void readFiles(Job& job) {
    const TraceImport import = traceImportOf(context_.settings, failures);
    readFiles(job, import);
    const std::string both = arguments_.stimulus.empty() ? arguments_.expect : arguments_.stimulus;
    if (failures.empty()) checkRenames(import, both, failures);
  }

  void readFiles(Job& job, const TraceImport& import) {
    if (!arguments_.stimulus.empty()) {
      const std::optional<std::string> text = readFile(context_, arguments_.stimulus, failures);
      if (text) job.stimulus = readStimulus(arguments_.stimulus, *text, program_, failures, arguments_.side, import);
    }
    if (arguments_.expect.empty()) {
      if (!arguments_.tolerances.empty() || arguments_.slack != 0)
        failures.push_back({"--tolerance and --slack belong to --expect"});
      return;
    }
    const std::optional<std::string> text = readFile(context_, arguments_.expect, failures);
    if (!text) return;
    job.expected = readTrace(arguments_.expect, *text, program_, failures, arguments_.side, import);
    if (failures.empty() && !expectsAnything(*job.expected)) failures.push_back(expectsNothing(arguments_.expect));
    job.compare.slack = arguments_.slack;
    for (const std::string& given : arguments_.tolerances) {
      Failure failure;
      if (const std::optional<Tolerance> tolerance = toleranceIn(given, *job.expected, failure)) {
        job.compare.tolerances.push_back(*tolerance);
      } else {
        failures.push_back(failure);
      }
    }
  }

  void chooseSignals(Job& job) {
    if (arguments_.signals.empty())
      job.signals = touchedSignals(hasHiddenCode(program_) ? withoutHiddenCode(program_) : program_);
    for (const std::string& name : arguments_.signals) {
      Failure failure;
      if (const std::optional<TraceSignal> signal = signalNamed(program_, name, failure)) {
        job.signals.push_back(signalOf(program_, signal->operand));
      } else {
        failures.push_back(failure);
      }
    }
    if (!job.expected) return;
    Trace known;
    known.signals = job.signals;
    const SignalIndex index(known);
    for (const TraceSignal& signal : job.expected->signals) {
      if (index.indexOf(signal) < 0) job.signals.push_back(signalOf(program_, signal.operand));
    }
  }

  void chooseLength(Job& job) {
    const bool isGiven = arguments_.scans != 0 || !arguments_.duration.empty();
    job.scans = arguments_.scans;
    if (!arguments_.duration.empty()) {
      const std::optional<Duration> duration = durationNamed(arguments_.duration);
      if (!duration || duration->count() <= 0) {
        failures.push_back({fmt::format("'{}' is no duration", arguments_.duration),
                            {},
                            "write a number with its unit, such as 30s or 500ms"});
        return;
      }
      job.durationUs = static_cast<std::uint64_t>(duration->count());
    }
    if (isGiven) return;
    if (arguments_.stimulus.empty() && arguments_.expect.empty()) job.scans = scansByDefault;
    const auto reach = [&](bool isByTime, std::uint64_t scan, std::uint64_t timeUs) {
      if (isByTime) job.durationUs = std::max(job.durationUs, timeUs);
      if (!isByTime) job.scans = std::max(job.scans, scan);
    };
    if (!job.stimulus.rows.empty())  // the scan that begins then
      reach(job.stimulus.isByTime, job.stimulus.rows.back().scan, job.stimulus.rows.back().timeUs + 1);
    if (job.expected && !job.expected->rows.empty()) {  // the scan that ends then; at 0 the first one begins
      const TraceRow& last = job.expected->rows.back();
      reach(job.expected->isByTime, last.scan,
            job.expected->isSampled ? last.timeUs + 1 : std::max<std::uint64_t>(last.timeUs, 1));
    }
  }

  const SimArguments& arguments_;
  const Context& context_;
  const Program& program_;
};

/// Shows on a terminal how far the run is.
class Progress {
 public:
  explicit Progress(const Context& context) : context_(context) {}
  void show(std::uint64_t scan, std::uint64_t timeUs) {
    if (!context_.progress || scan % 1024 != 0) return;
    const auto now = std::chrono::steady_clock::now();
    if (now - last_ < std::chrono::milliseconds(200)) return;
    last_ = now;
    isShown_ = true;
    context_.err << fmt::format("\rsim: scan {}, {:.1f} s", scan, static_cast<double>(timeUs) / 1e6) << std::flush;
  }
  void clear() {
    if (isShown_) context_.err << "\r\x1B[K" << std::flush;
  }

 private:
  const Context& context_;
  std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
  bool isShown_ = false;
};

/// After each scan; false: the run ends here.
using AfterScan = std::function<bool()>;

/// The failure of a run that turns out too long.
std::optional<Failure> play(Simulator& simulator, GivenValues* given, const Job& job, std::uint64_t seed,
                            const Context& context, const AfterScan& afterScan) {
  StimulusPlayer player(simulator, job.stimulus, given);
  const ScanLength length = scanLengthsOf(job.scanTime, seed);
  Progress progress(context);
  std::optional<Failure> failure;
  while (simulator.scanCount() < job.scans || simulator.timeUs() < job.durationUs) {
    failure =
        refusedRun(simulator.scanCount() + 1, job.keepsTrace && !job.isSparse ? job.signals.size() : 0, job.memory);
    if (failure) break;
    ScanRequest request = player.next();
    if (request.lengthUs == 0) request.lengthUs = length(simulator.scanCount() + 1);
    simulator.scan(request);
    if (job.unread != nullptr && job.unread->isReached()) break;
    if (!afterScan()) break;
    progress.show(simulator.scanCount(), simulator.timeUs());
    if (!simulator.isRunning() && !job.expected) break;
  }
  progress.clear();
  return failure;
}

/// `drawings`: networks to be drawn for every scan, or nullptr.
std::optional<Failure> record(Simulator& simulator, GivenValues* given, const Job& job, std::uint64_t seed,
                              const Context& context, ScanDrawings* drawings, Trace& trace) {
  trace.signals = job.signals;
  if (drawings != nullptr && job.unread != nullptr)
    job.unread->showTo(&drawings->recorder());
  else if (drawings != nullptr)
    simulator.observe(&drawings->recorder());
  std::optional<RowsAtMoments> sparse;
  if (job.isSparse) sparse.emplace(*job.expected, job.around(), trace.rows);
  return play(simulator, given, job, seed, context, [&] {
    if (sparse)
      sparse->add(sampleRow(simulator, trace.signals));
    else if (job.keepsTrace)
      trace.rows.push_back(sampleRow(simulator, trace.signals));
    if (drawings != nullptr) drawings->add();
    return true;
  });
}

/// Writes the trace while the run goes on. False: it could not be written, or the run was too long; the reason is said.
bool stream(Simulator& simulator, GivenValues* given, const Job& job, std::uint64_t seed, const Context& context,
            SignalNames names) {
  constexpr std::size_t piece = 1 << 16;  // bytes
  const TraceFormat& format = *traceFormatFor(*job.stream);
  Trace head;
  head.signals = job.signals;
  head = named(std::move(head), names);
  std::optional<Failure> failure;
  const bool isWritten = context.write({std::string(format.ending), *job.stream}, [&](const TakePiece& take) {
    std::string text;
    TraceRow row;
    bool isTaken = true;
    format.appendHead(head, text);
    failure = play(simulator, given, job, seed, context, [&] {
      sampleRow(simulator, head.signals, row);
      format.appendRow(head, row, text);
      if (text.size() < piece) return true;
      isTaken = take(text);
      text.clear();
      return isTaken;
    });
    return isTaken && !failure && take(text);
  });
  if (failure) context.fail(*failure);
  return isWritten;
}

/// Takes the columns out of which nobody knows what they hold; those that were asked for are failures.
void leaveOutUnknown(Job& job, const RunUntilUnread& run, bool isAsked, std::vector<Failure>& failures) {
  std::erase_if(job.signals, [&](const TraceSignal& signal) {
    const std::string reason = run.unknownAt(signal.operand);
    const bool isExpected = job.expected && job.expected->indexOf(signal) >= 0;
    if (!reason.empty() && (isAsked || isExpected))
      failures.push_back({fmt::format("{} has no known value", toString(signal.operand)), {}, reason});
    return !reason.empty();
  });
}

/// Blocks of the system whose outputs no run computes.
void addNotComputed(Report& report, const Program& program) {
  for (const Pou& pou : program.pous) {
    if (s7300::isContractOnly(pou))
      report.coverage.approximated.push_back(
          fmt::format("what {} gives is not computed: its outputs are 0, and BR is 1", pou.name));
  }
}

Exit runSim(const SimArguments& arguments, Context& context) {
  Program text = readFiles(context, arguments.files);
  std::vector<std::string> leftOut = arguments.asDownloaded ? leaveOut(text) : std::vector<std::string>();
  Report report = startReport("sim", text, arguments.files);
  report.coverage.leftOut = std::move(leftOut);
  const UnreadCode unread(text);
  const RunUntilUnread untilUnread(unread);
  if (!untilUnread.hindrance().empty()) {
    // A run of the rest would be the run of another program.
    std::erase_if(report.findings, [](const Finding& finding) { return finding.severity != Severity::Error; });
    addUnread(report, text, unread);
    report.reasons.push_back({Exit::Failed, "the program is not run"});
    context.err << fmt::format("rungproof: the program is not run: {}\n", untilUnread.hindrance());
    finish(context, std::move(report));
    return Exit::Failed;
  }
  const Program& program = untilUnread.program();
  // The run does without it, but not everything could be read.
  if (unread.isRefused()) {
    printUnread(context, "sim", text, unread, arguments.files);
    report.reasons.push_back({Exit::Failed, "a part that this run does not need is refused"});
  }
  report.findings.clear();  // warnings of the readers are lint's
  if (program.main() == nullptr)
    return context.fail(
        {"there is no main program to run", arguments.files.front(), "give the file that holds the main program"});

  Preparation preparation(arguments, context, program);
  Job job = preparation.job();
  leaveOutUnknown(job, untilUnread, !arguments.signals.empty(), preparation.failures);
  if (!preparation.failures.empty()) return failAll(context, preparation.failures);

  SimulatorOptions options;
  options.retentive = context.settings.retentive();
  options.choices = context.settings.choices();
  options.phaseMs = context.settings.phaseMs();
  options.engine = arguments.engineKind();
  options.seed = static_cast<std::uint64_t>(std::stoull(std::string(context.settings.text(Opt::Seed))));
  GivenValues givenValues(options.choices);
  GivenValues* const given = job.stimulus.isWhole ? &givenValues : nullptr;
  Simulator simulator(program, given != nullptr ? wholeOptions(options.choices) : options, given);
  givenValues.setState(simulator.store());
  if (given != nullptr) beginWhole(simulator, job.stimulus, options.choices);
  UnreadWatch watch(untilUnread.ends());
  if (untilUnread.mayEnd()) {
    job.unread = &watch;
    simulator.observe(&watch);
  }
  const auto isPage = [](const std::string& name) { return name.ends_with(".html"); };
  std::optional<ScanDrawings> drawings;
  if (std::ranges::any_of(arguments.traces, isPage)) drawings.emplace(program);
  Trace trace;
  if (job.stream) {
    if (!stream(simulator, given, job, options.seed, context, arguments.signalNames())) return Exit::Failed;
  } else if (auto failure =
                 record(simulator, given, job, options.seed, context, drawings ? &*drawings : nullptr, trace))
    return context.fail(*failure);
  const TraceDrawings drawn = drawings ? drawings->take() : TraceDrawings{};

  const std::vector<std::string> keptTraces = job.stream ? std::vector<std::string>() : arguments.traces;
  for (const std::string& name : keptTraces) {
    const std::string& title = program.sources->file(0).name();
    const bool isDrawn = job.expected && (isPage(name) || name.ends_with(".svg"));
    TraceBeside shown = isDrawn ? besideExpected(*job.expected, trace, job.compare) : TraceBeside{};
    const bool isRenamed = !isDrawn && arguments.signalNames() != SignalNames::Address;
    if (isRenamed) shown.trace = named(trace, arguments.signalNames());
    const Trace& written = isDrawn || isRenamed ? shown.trace : trace;
    if (!(isPage(name) ? writePage(context, name, written, title, drawn, shown.lanes)
                       : writeTrace(context, name, written, title)))
      return Exit::Failed;
  }
  describeRun(report, simulator, job.scanTime, !watch.isReached());  // behind the end nothing is the program's
  if (given == nullptr) addNotComputed(report, program);
  if (given != nullptr && given->unused() > 0)
    context.err << fmt::format(
        "rungproof: the run did not ask for {} values of column 'given': the program, its CPU or "
        "its choices are not those of the witness\n",
        given->unused());
  const bool isTold = !watch.isReached() && !context.settings.flag(Opt::Quiet);
  if (const std::string text = stopText(simulator); !text.empty() && isTold)
    context.err << fmt::format("rungproof: {} in scan {}\n", text, simulator.scanCount());
  if (watch.isReached()) {
    const std::string end = fmt::format("the run ends in scan {}, in {}", simulator.scanCount(), watch.reached());
    context.err << fmt::format("rungproof: {}\n", end);
    report.reasons.push_back({Exit::Failed, end});
  }
  if (job.expected) {
    report.failLevel = Severity::Error;  // a warning is said beside the comparison
    report.comparison = comparisonOf(*job.expected, trace, firstDifference(*job.expected, trace, job.compare));
  }
  if (!preparation.isResult()) return finish(context, std::move(report));
  // Nothing else was asked for: the trace itself is the result, and what there is to say goes beside it.
  if (!job.stream && !writeTrace(context, "-", named(std::move(trace), arguments.signalNames()), ""))
    return Exit::Failed;
  if (report.findings.empty() && report.coverage.leftOut.empty() && report.coverage.approximated.empty())
    return unread.isRefused() || watch.isReached() ? Exit::Failed : Exit::Clean;
  Context beside{context.settings, context.in, context.err, context.err, false, context.progress, context.outputs};
  return finish(beside, std::move(report));
}

Action setUpSim(ArgumentTable& table) {
  auto arguments = std::make_shared<SimArguments>();
  table.arguments("FILE", arguments->files, "programs, symbol tables and data blocks; '-' is standard input");
  table.option("--stimulus", arguments->stimulus, "FILE", "what the inputs do, scan by scan or by time (CSV, VCD)");
  table.option(
      "--set", arguments->values, "ADDRESS=VALUE",
      "what an input or memory holds from the first scan on, until a stimulus says otherwise; may be repeated");
  table.option("--expect", arguments->expect, "FILE", "the trace as it should be (CSV, VCD)");
  table.option("--trace", arguments->traces, "FILE",
               "write the trace: .csv .vcd .json .svg .html, or '-'; may be repeated");
  table.list("--signals", arguments->signals, "LIST", "addresses or symbols to trace; all that the program touches");
  table.word("--names", arguments->names, {"address", "symbol", "both"}, "address|symbol|both",
             "what columns of written traces are called [default: address]");
  table.word("--engine", arguments->engine, {"auto", "reference", "compiled"}, "auto|reference|compiled",
             "what runs the program; machine code does the same, faster [default: auto]");
  table.number("--scans", arguments->scans, "N", "run so many scans; until stimulus and expected trace end, or 100", 1,
               static_cast<std::int64_t>(mostScans));
  table.option("--duration", arguments->duration, "TIME", "run for this time, such as 30s");
  table.option("--tolerance", arguments->tolerances, "SIGNAL=VALUE", "how far a value may be off; may be repeated");
  table.number("--slack", arguments->slack, "N", "scans by which a value may come earlier or later");
  table.flag("--as-downloaded", arguments->asDownloaded, asDownloadedHelp);
  table.word("--side", arguments->side, {"old", "new"}, "old|new",
             "which program this is in a trace that 'rungproof equiv' wrote of two");
  return [arguments](Context& context) { return runSim(*arguments, context); };
}

}  // namespace

extern constexpr Command simCommand = {
    .name = "sim",
    .usage = "FILE... [--stimulus FILE] [--expect FILE] [--trace FILE]...",
    .summary = "run a program on the reference engine",
    .details =
        "The first column of a stimulus or an expected trace is 'scan' (from 1) or 'time_ms'; the others are\n"
        "addresses, symbols, or T37.value for a current value. An empty cell keeps the last value, in an\n"
        "expected trace it matches anything. Column 'scan_ms' gives the length of scans, column 'event' fires\n"
        "interrupt events: 10 at the start of the scan, 10@17 in front of the instruction in line 17, 3x10@17\n"
        "three at once (then none but those and timed ones come in the whole run), column 'device' gives what\n"
        "ports and other devices write: VB101=83 SMB86=2, as far as a request of the program asked for it (then\n"
        "they do nothing else). Expected values are compared with the values at the end of the scan, or of the\n"
        "scan in which the time falls: the one that ends then, or ends next (of a logger's file the one that begins\n"
        "then). A stimulus at a time acts in the first scan that begins then or later. A written CSV trace is a\n"
        "stimulus as well. In a trace that 'rungproof equiv' wrote, columns such as old.Q0.0, new.Q0.0 and new.event\n"
        "belong to one of the programs: --side says which one this is.\n"
        "A witness of 'rungproof prove --traces' has the columns 'given' and 'start': all that the surroundings did\n"
        "and that no address tells, so that the run is repeated exactly ('rungproof guide', chapter on daily work).\n"
        "Then only columns of inputs set anything beside them.\n"
        "CLOCK.tick, CLOCK.second and CLOCK.minute say how many ms the time bases of the timers, SM0.5 and\n"
        "SM0.4 are into their periods.\n"
        "Files of loggers, oscilloscopes and simulators are read too: with another first column --time-column and\n"
        "--time-unit say what the time is; dates count from the first row. VCD values that are x or z are open.\n"
        "A page (.html, .svg) shows the expected curve below the actual one.\n"
        "\n"
        "Examples:\n"
        "    rungproof sim press.awl --stimulus start.csv --expect start.expected.csv\n"
        "    rungproof sim press.awl --stimulus start.csv --trace start.vcd --trace start.html\n"
        "    rungproof sim press.awl --set I0.0=1 --set VW100=250 --scans 20 --trace -\n"
        "    rungproof sim press.awl --expect logger.csv --time-column Zeit --time-unit s --rename Pumpe=Q0.1\n"
        "    rungproof sim press.awl --duration 10s --scan-time 5ms --signals I0.0,Q0.0,T37.value --trace -\n",
    .shows = option_group::Reading | option_group::Running | option_group::Traces | option_group::Output |
             option_group::Configuration,
    .setup = setUpSim,
};

}  // namespace rungproof
