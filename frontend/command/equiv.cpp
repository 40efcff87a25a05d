// `rungproof equiv`: do two versions of a program drive the same outputs?
#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <filesystem>
#include <set>

#include "analysis/equivalence/equivalence.hpp"
#include "analysis/equivalence/output_name.hpp"
#include "engine/platform/interrupt.hpp"
#include "engine/platform/names.hpp"
#include "frontend/command.hpp"
#include "frontend/explain/certificate_head.hpp"
#include "frontend/input/proof_input.hpp"
#include "frontend/sides/block_comparison.hpp"
#include "frontend/sides/difference_report.hpp"
#include "frontend/sides/sides.hpp"
#include "frontend/simulation/trace_file.hpp"
#include "frontend/simulation/witness_report.hpp"
#include "frontend/stl/syntax_message.hpp"
#include "frontend/testing/table_reader.hpp"

namespace rungproof {

namespace {

struct EquivArguments {
  SideArguments sides;
  std::string inputs = "free";
  std::string interrupts = "between";
  std::uint32_t latency = 0;
  std::string settle;
  std::string trace, table;
  std::string certificates;
  std::string show = "ladder";
};

std::atomic<bool> equivInterrupted = false;

std::string_view equalityName(Equality equality) {
  switch (equality) {
    case Equality::Equal: return "EQUAL";
    case Equality::Different: return "DIFFERENT";
    case Equality::Unknown: return "UNKNOWN";
  }
  return "UNKNOWN";
}

/// Errors of reading of one side, as the beginning of the report.
Report partOf(const ProgramInput& input, const UnreadCode& unread, const std::vector<std::string>& files,
              const std::vector<std::string>& leftOut) {
  Report part = startReport("equiv", input.program, files);
  part.coverage.leftOut = leftOut;
  std::erase_if(part.findings, [](const Finding& finding) { return finding.severity != Severity::Error; });
  addUnread(part, input.program, unread);
  const PlaceIndex places(input.program);
  for (Finding& finding : part.findings) places.complete(finding);
  return part;
}

Comparison comparisonOf(const Equivalence& found, const Program& before) {
  Comparison comparison;
  comparison.equal = found.equality == Equality::Equal;
  comparison.verdict = equalityName(found.equality);
  comparison.method = found.method;
  comparison.seconds = found.seconds;
  comparison.notes = found.notes;
  if (!found.certificates.empty())
    comparison.notes.push_back(fmt::format("{} certificates", found.certificates.size()));
  for (const std::string& name : found.uncertified) comparison.notes.push_back("no certificate in time for: " + name);
  if (found.equality == Equality::Unknown) {
    if (found.depth > 0)
      comparison.notes.insert(comparison.notes.begin(),
                              fmt::format("no difference in the first {} scans", found.depth));
    std::string open;
    std::set<std::string> named;
    for (const ObservedVerdict& output : found.outputs) {
      const std::string name = outputName(before, output.before, output.name);
      if (output.equality == Equality::Unknown && named.insert(name).second) open += (open.empty() ? "" : ", ") + name;
    }
    if (!open.empty()) comparison.notes.push_back("undecided: " + open);
  }
  return comparison;
}

/// One file for the memory that corresponds, on which the others rest, and one for each output.
bool writeCertificates(const Context& context, const std::string& directory, const Sides& sides,
                       const Equivalence& found) {
  std::error_code error;  // a folder that cannot be made shows when the file is written
  std::filesystem::create_directories(directory, error);
  bool isWritten = true;
  for (const auto& [name, text] : found.certificates) {
    const bool isMemory = name == found.certificates.front().first;
    const bool isRequest = name.starts_with("request"), isDecisions = name.starts_with("decisions_");
    const std::string file = name + ".smt2";
    CertifiedStatement statement{"comparison",
                                 isMemory      ? "memory of both programs that corresponds"
                                 : isRequest   ? "both programs ask the same of a device: " + name
                                 : isDecisions ? "decisions that led the encoding of one program: " + name
                                               : name + " is equal",
                                 {sides.runBefore.get(), sides.runAfter.get()},
                                 found.assumptions,
                                 {},
                                 context.settings.root()};
    statement.notes.push_back(
        isMemory ? "from equal pairs of memory every scan leads to equal ones; the other files rest on it"
        : isDecisions
            ? "known conditions, targets of pointers, effects of interrupt routines; the other files rest on it"
            : "rests on memory.smt2");
    isWritten = context.write({"smt2", pathName(std::filesystem::path(directory) / file)},
                              certificateHead(statement, file) + text) &&
                isWritten;
  }
  return isWritten;
}

/// Whether the settings that tell how a program is read and run are those of the other.
bool hasSameSettings(const Context& context) {
  constexpr std::array ofOneProgram = {Opt::Mnemonics, Opt::Encoding, Opt::Symbols,      Opt::Tags,
                                       Opt::Exclude,   Opt::Program,  Opt::StdinFilename};
  for (std::size_t i = 0; i < static_cast<std::size_t>(Opt::count); ++i) {
    const auto id = static_cast<Opt>(i);
    if (std::ranges::find(ofOneProgram, id) != ofOneProgram.end()) continue;
    if (context.side(ProgramSide::Old).list(id) != context.side(ProgramSide::New).list(id)) return false;
  }
  return true;
}

/// The same bytes that begin with the same values do the same on the same CPU, also where the tool does not know what
/// they do. Certificates are asked of the prover.
bool isDecidedByBlocks(const Context& context, const EquivArguments& arguments, const Sides& sides,
                       const Report& report) {
  const auto isLoss = [](const Finding& finding) { return finding.rule == syntaxMessage(Syntax::ProjectLost).id; };
  return areSameBlocks(report.blocks, arguments.sides.values == "old") && arguments.certificates.empty() &&
         arguments.latency == 0 && sides.pairs.empty() && arguments.sides.with.empty() &&
         std::ranges::none_of(report.findings, isLoss) && hasSameSettings(context);
}

/// What the verdict means for the blocks that differ.
void noteBlocks(Report& report, bool ignoresValues) {
  const auto count = [&](BlockLikeness likeness) {
    return std::ranges::count(report.blocks, likeness, &ComparedBlock::likeness);
  };
  std::vector<std::string>& notes = report.comparison->notes;
  if (report.comparison->equal && count(BlockLikeness::Changed) > 0)
    notes.emplace_back("what differs in the changed blocks changes no output");
  if (count(BlockLikeness::OtherValues) == 0) return;
  notes.emplace_back(ignoresValues ? "both begin with the values that the data blocks have in OLD"
                                   : "each begins with the values of its own data blocks; --values old compares from "
                                     "those of OLD");
}

Exit runEquiv(const EquivArguments& arguments, Context& context) {
  std::vector<Failure> failures;
  const std::optional<Duration> settle = arguments.settle.empty() ? Duration{} : durationNamed(arguments.settle);
  if (!settle) failures.push_back({fmt::format("'{}' is no time", arguments.settle), {}, "write --settle 100ms"});
  if (!arguments.trace.empty()) {
    if (auto failure = checkTraceName(arguments.trace)) failures.push_back(*failure);
  }
  const Sides sides = readSides(context, arguments.sides, failures);
  if (!failures.empty()) return failAll(context, failures);
  ReportMerger merger;
  merger.add(partOf(sides.before, *sides.unreadBefore, sides.filesBefore, sides.leftOutBefore));
  merger.add(partOf(sides.after, *sides.unreadAfter, sides.filesAfter, sides.leftOutAfter));
  Report report = merger.take();
  report.blocks = sides.blocks;
  if (isDecidedByBlocks(context, arguments, sides, report)) {
    report.comparison.emplace();
    report.comparison->verdict = equalityName(Equality::Equal);
    report.comparison->method = "the same machine code";
    report.findings.clear();
    report.coverage.approximated.clear();  // nothing was run
    return finish(context, std::move(report));
  }
  if (sides.unreadBefore->isRefused() || sides.unreadAfter->isRefused() || !report.findings.empty()) {
    report.reasons.push_back({Exit::Failed, "a part of a program is refused"});
    // What never runs decides no output: the verdict stands beside its findings.
    const auto isOfRun = [](const Finding& finding) { return !isProgramReadError(finding) && !finding.refused; };
    if (sides.unreadBefore->hinderRuns() || sides.unreadAfter->hinderRuns() ||
        std::ranges::any_of(report.findings, isOfRun))
      return finish(context, std::move(report));
  }

  EquivalenceOptions options;
  options.prover = proverOptionsOf(context.settings, {&sides.before.program, &sides.after.program});
  options.prover.certificates = !arguments.certificates.empty();
  options.prover.cancel = &equivInterrupted;
  options.pairs = sides.pairs;
  options.observed = sides.observed;
  options.assumptions = sides.assumptions;
  options.steadyInputs = arguments.inputs == "steady";
  options.interruptsInside = arguments.interrupts == "anywhere";
  options.latency = arguments.latency;
  options.settleMs = static_cast<std::uint32_t>(settle->count() / 1000);
  equivInterrupted = false;
  std::optional<InterruptFlag> interrupt;
  interrupt.emplace(equivInterrupted, Interrupts::CtrlC);
  Equivalence found = compareBehaviour(sides.oldSide(), sides.newSide(), options);
  interrupt.reset();
  if (found.equality == Equality::Equal && std::ranges::all_of(found.outputs, &ObservedVerdict::isRun)) {
    found.equality = Equality::Unknown;
    found.notes.emplace_back("neither program writes an output: name memory to be compared with --observe");
  }

  report.comparison = comparisonOf(found, *sides.runBefore);
  noteBlocks(report, arguments.sides.values == "old");
  report.assumptions = found.assumptions;
  std::vector<std::string>& approximated = report.coverage.approximated;  // of both programs, which may share files
  approximated.insert(approximated.end(), found.approximations.begin(), found.approximations.end());
  for (auto text = approximated.begin(); text != approximated.end();)
    text = std::find(approximated.begin(), text, *text) != text ? approximated.erase(text) : text + 1;
  bool isFailed = false;
  for (const Disagreement& disagreement : found.disagreements) {
    context.err << fmt::format("rungproof: internal disagreement on '{}': {}\n", disagreement.name,
                               disagreement.explanation);
    report.defects.push_back(disagreement.name);
  }
  if (found.run) {
    const DifferenceReport difference(sides, options, *found.run);
    difference.describe(*report.comparison, arguments.show);
    if (!arguments.trace.empty() && !writeTrace(context, arguments.trace, difference.trace(), "outputs differ"))
      isFailed = true;
    if (!arguments.trace.empty()) report.comparison->trace = arguments.trace;
  }
  if (found.run && !arguments.table.empty()) {
    const TestTable table = DifferenceReport(sides, options, *found.run).table();
    if (!context.write({"csv", arguments.table}, testTableText(table))) isFailed = true;
  }
  if (options.prover.certificates && !writeCertificates(context, arguments.certificates, sides, found)) isFailed = true;
  if (!found.certificates.empty()) report.comparison->certificate = arguments.certificates;
  const Exit exit = finish(context, std::move(report));
  return isFailed ? Exit::Failed : exit;
}

Action setUpEquiv(ArgumentTable& table) {
  auto arguments = std::make_shared<EquivArguments>();
  arguments->sides.declare(table);
  table.word("--inputs", arguments->inputs, {"free", "steady"}, "free|steady",
             "steady: immediate reads give what the process image has");
  table.word("--interrupts", arguments->interrupts, {"between", "anywhere"}, "between|anywhere",
             "anywhere: events may come anywhere in a scan, not only between scans");
  table.option("--settle", arguments->settle, "TIME", "outputs may differ for less than that without a break");
  table.number("--latency", arguments->latency, "N", "NEW's outputs come N scans later", 0, 1000);
  table.option("--trace", arguments->trace, "FILE", "write the run that differs: inputs and the outputs of both");
  table.option("--table", arguments->table, "FILE",
               "write that run as a test table: its inputs, and the outputs of OLD, which NEW does not pass");
  table.option("--certificate", arguments->certificates, "DIR",
               "write the proofs of EQUAL as SMT-LIB 2, for another solver to check");
  table.word("--show", arguments->show, {"ladder", "lad", "fbd", "stl", "none"}, "ladder|fbd|stl|none",
             "how the networks that drive a differing output are drawn");
  return [arguments](Context& context) { return runEquiv(*arguments, context); };
}

}  // namespace

extern constexpr Command equivCommand = {
    .name = "equiv",
    .usage = "OLD NEW [--map FILE]",
    .summary = "prove that two versions of a program drive the same outputs, or show the scan where they differ",
    .details =
        "Both programs get the same inputs and the same scan times, each keeps its own memory, and every bit of Q and\n"
        "AQ that either can write is compared at the end of every scan, from the first one on. A bit that only one\n"
        "program can write is compared with 0. Options about reading may be given for one side: --cpu new:224.\n"
        "\n"
        "An immediate read may differ from the process image, so LDI in place of LD is a difference, unless --inputs\n"
        "steady holds the inputs for the whole scan. What the manual leaves undefined is each program's own. A "
        "program\n"
        "that stops while the other runs is a difference.\n"
        "\n"
        "Of a STEP 7 project and blocks read out of a CPU, blocks are matched by number first: which are the same\n"
        "byte by byte, which have other values, which networks differ, and which only one program has. Where all are\n"
        "the same, nothing has to be proved. Blocks out of a CPU run with the hardware configuration of the project.\n"
        "\n"
        "Verdicts: EQUAL (exit code 0), DIFFERENT (1), with a run that the reference engine has made on both "
        "programs,\n"
        "UNKNOWN (3).\n"
        "\n"
        "Examples:\n"
        "    rungproof equiv press.awl press_tidied.awl\n"
        "    rungproof equiv old/ new/ --map moved.map --observe Q0.0,QB4\n"
        "    rungproof equiv Plant.s7p upload/ --values old\n"
        "    rungproof equiv press.awl press.xml --with new:tags.sdf --trace difference.csv\n",
    .shows = option_group::Reading | option_group::Running | option_group::Output | option_group::Configuration,
    .comparesTwo = true,
    .setup = setUpEquiv,
};

}  // namespace rungproof
