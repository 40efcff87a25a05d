// `rungproof prove`: declared properties and built-in checks, each with a verdict and its evidence.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <atomic>
#include <set>

#include "analysis/proof/proof_networks.hpp"
#include "analysis/proof/rule_answers.hpp"
#include "analysis/rule.hpp"
#include "analysis/selfcheck/self_check.hpp"
#include "analysis/unread/idle_blocks.hpp"
#include "engine/platform/interrupt.hpp"
#include "frontend/acceptance/record_of.hpp"
#include "frontend/command.hpp"
#include "frontend/explain/certificate_head.hpp"
#include "frontend/files/sha256.hpp"
#include "frontend/input/program_text.hpp"
#include "frontend/input/proof_input.hpp"
#include "frontend/input/protected_findings.hpp"
#include "frontend/result_cache.hpp"
#include "frontend/simulation/witness_drawing.hpp"
#include "frontend/simulation/witness_report.hpp"
#include "frontend/testing/table_reader.hpp"
#include "frontend/testing/witness_table.hpp"
#include "frontend/text/excerpt.hpp"
#include "frontend/watch.hpp"
#include "ir/iec/variables.hpp"

namespace rungproof {

namespace {

struct ProveArguments {
  std::vector<std::string> files;
  std::vector<std::string> properties;
  bool asDownloaded = false;
  std::vector<std::string> only;
  bool builtin = false;
  bool watch = false;
  bool selfCheck = false;
  std::string certificates;
  std::string traces, tables;
  std::string show;
  int width = 100;
  std::string shard;
};

constexpr double secondsForUndecided = 4;  ///< of the self-check, for a fault that a quick look leaves open
constexpr std::size_t scansInPage = 300;   // the last ones of a witness

std::atomic<bool> interrupted = false;  ///< leads to the report

/// The scans that matter as drawings for people, the last ones for a page that steps through them.
std::vector<ShownScan> drawnScans(const ProveArguments& arguments, const Program& program, const Choices& choices,
                                  const ProofResult& result, bool hasPage) {
  WitnessDrawingOptions options;
  options.form = arguments.show == "fbd" ? Form::Fbd : arguments.show == "stl" ? Form::Stl : Form::Ladder;
  options.lastScans = scansInPage;
  options.width = arguments.width;
  options.text = !arguments.show.empty();
  options.svg = hasPage;
  options.asRead = arguments.show.empty();
  return shownScans(program, choices, result, options);
}

bool wantsPage(const Context& context) {
  return std::ranges::any_of(context.outputs, [](const OutputRequest& output) { return output.name == "html"; });
}

PropertyResult rowOf(const Context& context, const ProveArguments& arguments, EvidenceNames& names,
                     const Program& program, const PropertySet& set, const Choices& choices,
                     const std::vector<std::string>& assumptions, const ProofResult& result) {
  const std::string stem = names.of(result.property.name);
  PropertyResult row;
  row.name = result.property.name;
  row.kind = result.builtin                                ? ResultKind::Builtin
             : result.property.kind == PropertyKind::Reach ? ResultKind::Reach
                                                           : ResultKind::Prove;
  row.verdict = result.outcome;
  row.method = result.method;
  row.depth = result.depth;
  row.seconds = result.seconds;
  row.statement = result.property.text;
  if (result.property.span.length > 0) row.span = result.property.span;
  row.notes = result.notes;
  const bool hasPage = wantsPage(context);
  if (hasPage && !result.witness) addEvidence(row, program, choices, result, nullptr);
  if (result.witness) {
    const Trace trace = traceOf(program, choices, *result.witness, signalsThatMatter(program, result), 100000, true);
    if (const std::string start = startText(program, choices, *result.witness); !start.empty())
      row.notes.push_back("memory at the start: " + start);
    row.run = tableOf(trace);
    row.notes.insert(row.notes.end(), row.run.begin(), row.run.end());
    const auto isOpen = [](const std::string& line) { return line.ends_with(" -") || line.find(" - ") != line.npos; };
    if (std::ranges::any_of(row.run, isOpen)) row.notes.emplace_back("'-': any value leads to the same");
    if (const Instruction* place = result.witness->place; place != nullptr) {
      row.notes.push_back(fmt::format("inside the last scan, in front of '{}' at {}", Facts::text(*place),
                                      placeText(*program.sources, place->span)));
    }
    if (hasPage) addEvidence(row, program, choices, result, &trace);
    if (!arguments.show.empty() || hasPage) row.scans = drawnScans(arguments, program, choices, result, hasPage);
    if (!arguments.traces.empty())
      row.trace = writeRun(context, arguments.traces, stem, program, choices, result, row.notes);
    if (!arguments.tables.empty()) {
      const Property* const broken = result.outcome == Outcome::Violated ? &result.property : nullptr;
      const TestTable table = witnessTable(program, set, choices, *result.witness, result.property.name, broken);
      const std::string name = evidenceFile(arguments.tables, stem + ".test.csv");
      if (context.write({"csv", name}, testTableText(table))) row.notes.push_back("test table: " + name);
    }
  }
  row.networks = networkList(result.networks);
  if (!result.certificate.empty()) {
    const std::string name = evidenceFile(arguments.certificates, stem + ".smt2");
    const std::string head = certificateHead(program, assumptions, result, stem + ".smt2", context.settings.root());
    if (context.write({"smt2", name}, head + result.certificate)) row.certificate = name;
    row.evidence.certificateSha256 = sha256(head + result.certificate);
    if (!row.certificate.empty()) row.notes.push_back(fmt::format("certificate: {}", name));
  }
  return row;
}

std::string_view fateName(FaultFate fate) {
  switch (fate) {
    case FaultFate::Noticed: return "noticed";
    case FaultFate::Unnoticed: return "unnoticed";
    case FaultFate::NoEffect: return "without effect";
    case FaultFate::Undecided: return "undecided";
  }
  return "undecided";
}

/// Plants faults and says which of them the properties notice.
std::vector<PlantedFault> plantFaults(const Context& context, const Program& program, const PropertySet& properties,
                                      const ProverOptions& options, const ProofRun& proof) {
  SelfCheckOptions check;
  check.prover = options;
  check.seconds = std::min(options.timeout, check.seconds);
  check.patience = std::min(options.timeout, secondsForUndecided);
  if (context.progress) {
    check.progress = [&](std::size_t done, std::size_t total) {
      context.err << fmt::format("\rself-check: {} of {}\x1B[K", done, total) << std::flush;
    };
  }
  const SelfCheck found = selfCheck(program, properties, proof.results, check);
  if (context.progress) context.err << "\r\x1B[K" << std::flush;
  if (found.untried > 0)
    context.err << fmt::format("rungproof: interrupted; {} of {} faults were not tried\n", found.untried,
                               found.untried + found.results.size());
  std::vector<PlantedFault> faults;
  for (const FaultResult& result : found.results) {
    const Pou& pou = program.pous[result.fault.pou];
    const Network& network = pou.networks[result.fault.network];
    const Span span = network.instructions[result.fault.instruction].span;
    const std::string text = isCodeHidden(program, pou) ? "not shown: know-how protected" : result.fault.text;
    faults.push_back({std::string(faultKindName(result.fault.kind)), text,
                      std::string(program.sources->file(span.file).name()), program.sources->position(span).line,
                      pou.name, network.number, std::string(fateName(result.fate)), result.noticedBy, result.where});
  }
  return faults;
}

/// Proves what is asked and puts it into the report. `program`: what of the text may be run.
void proveInto(Report& part, const Context& context, const Settings& settings, const ProveArguments& arguments,
               EvidenceNames& names, const Program& program, const PropertySet& properties, const UnreadCode& unread) {
  ProverOptions options = proverOptionsOf(settings, {&program});
  options.checks.builtin = arguments.builtin;
  // A certificate spells the program out.
  options.certificates = !arguments.certificates.empty() && !hasHiddenCode(program);
  options.unread = &unread;
  options.cancel = &interrupted;
  std::optional<InterruptFlag> interrupt;
  interrupt.emplace(interrupted, Interrupts::CtrlCAndEnd);
  const ProofRun proof =
      prove(program, properties, options, [&](const ProofResult& result, std::size_t done, std::size_t total) {
        if (context.progress)
          context.err << fmt::format("\rprove: {} of {}: {} {}{}{} in {:.1f} s\x1B[K", done, total,
                                     verdictText(result.outcome, result.depth), result.property.name,
                                     result.method.empty() ? "" : " by " + result.method,
                                     result.depth > 0 ? fmt::format(", depth {}", result.depth) : "", result.seconds)
                      << std::flush;
        return true;
      });
  if (context.progress) context.err << "\r\x1B[K" << std::flush;
  if (proof.isInterrupted) context.err << "rungproof: interrupted; what was not settled is UNKNOWN\n";
  std::vector<const ProofResult*> builtin;
  for (const ProofResult& result : proof.results) {
    part.properties.push_back(
        rowOf(context, arguments, names, program, properties, options.choices, proof.assumptions, result));
    part.properties.back().assumptions = result.assumptions;
    if (result.builtin) builtin.push_back(&result);
  }
  for (Finding& finding : findingsOf(builtin, Shown::Run)) part.findings.push_back(std::move(finding));
  if (arguments.selfCheck && dialectOf(program.target).memory.isOfVariables && outputVariables(program).empty()) {
    context.err << "rungproof: no faults are planted: the program has no output by which a fault could be seen\n";
  } else if (arguments.selfCheck && unread.empty() && properties.unread.empty()) {
    part.selfCheck = plantFaults(context, program, properties, options, proof);
  } else if (arguments.selfCheck) {
    context.err << "rungproof: no faults are planted: not all of the program and its properties could be read\n";
  }
  interrupt.reset();
  part.assumptions = proof.assumptions;
  part.techniques = proof.techniques;
  part.coverage.approximated.insert(part.coverage.approximated.end(), proof.approximations.begin(),
                                    proof.approximations.end());
  for (const Disagreement& disagreement : proof.disagreements) {
    context.err << fmt::format("rungproof: internal disagreement on '{}': {}\n", disagreement.name,
                               disagreement.explanation);
    for (const std::string& line : disagreement.traces.solver) context.err << "  solver: " << line << '\n';
    for (const std::string& line : disagreement.traces.engine) context.err << "  engine: " << line << '\n';
    part.defects.push_back(disagreement.name);
  }
}

/// "2/4" of --shard.
std::optional<ReportPart> partNamed(const std::string& text) {
  ReportPart part{0, 0};
  int end = 0;
  const bool isRead = std::sscanf(text.c_str(), "%5u/%5u%n", &part.part, &part.of, &end) == 2;
  const bool isGood = isRead && static_cast<std::size_t>(end) == text.size() && part.part >= 1 && part.part <= part.of;
  return isGood && part.of <= 10000 ? std::optional(part) : std::nullopt;
}

/// Leaves the properties of the other parts out. `count`: properties met so far, over all programs.
void keepPart(const ReportPart& part, PropertySet& set, std::size_t& count) {
  std::erase_if(set.properties,
                [&](const Property& property) { return property.isGoal() && count++ % part.of != part.part - 1; });
}

/// What of this command alone decides which verdicts there are: parts of one run have it in common.
void addOwnOptions(const ProveArguments& arguments, ProgramRecord& record) {
  const auto add = [&](const char* name, const std::string& value) {
    record.options.push_back({name, value, "command line"});
  };
  if (!arguments.only.empty()) add("only", fmt::format("{}", fmt::join(arguments.only, ", ")));
  if (arguments.builtin) add("builtin", "");
  if (arguments.selfCheck) add("self-check", "");
  if (arguments.asDownloaded) add("as-downloaded", "");
}

/// Whether another run with more time could say more.
bool isFinal(const Report& report) {
  return !interrupted && report.defects.empty() &&
         std::ranges::none_of(report.properties, [](const PropertyResult& property) {
           return property.verdict == Outcome::Unknown || property.verdict == Outcome::HoldsToBound;
         });
}

/// `isSettled` becomes whether the result is final.
Exit runAnew(const ProveArguments& given, Context& context, bool& isSettled) {
  ProveArguments arguments = given;
  const std::optional<ReportPart> whichPart = partNamed(given.shard);
  if (!given.shard.empty() && !whichPart)
    return context.fail(
        {fmt::format("'{}' is no value for --shard", given.shard), {}, "write the part and their number, such as 2/4"});
  if (whichPart && whichPart->part > 1) arguments.builtin = arguments.selfCheck = false;
  std::size_t count = 0;
  ReportMerger merger;
  EvidenceNames names;
  std::set<std::string> met;
  interrupted = false;
  const std::vector<std::vector<std::string>> programs = groupByProgram(context, arguments.files);
  for (const std::vector<std::string>& files : programs) {
    const Settings& settings = context.settingsOf(files);
    ProgramInput input = readInput(context, settings, files, arguments.properties);
    std::vector<std::string> leftOut = arguments.asDownloaded ? leaveOut(input.program) : std::vector<std::string>();
    met.merge(keepOnly(arguments.only, input.properties));
    leaveOutIdleBlocks(input.program, input.properties);
    const bool declaresGoals = std::ranges::any_of(input.properties.properties, &Property::isGoal);
    if (whichPart) keepPart(*whichPart, input.properties, count);
    Report part = startReport("prove", input.program, files);
    part.coverage.leftOut = std::move(leftOut);
    std::erase_if(part.findings, [](const Finding& finding) { return finding.severity != Severity::Error; });
    const UnreadCode unread(input.program, settings.choices());
    const bool hasProgramErrors =
        std::ranges::any_of(part.findings, [](const Finding& finding) { return !finding.rule.starts_with("PRP"); });
    if (hasProgramErrors || unread.isRefused())
      part.reasons.push_back({Exit::Failed, "a part of the program is refused"});
    addUnread(part, input.program, unread);
    if (unread.hinderRuns()) part.reasons.push_back({Exit::Undecided, "a part of the program was not read"});
    const Program program = unread.isWhole() ? Program{} : unread.executable();
    const bool hasMain = !unread.isWhole() || input.program.main() != nullptr;
    if (hasMain) {
      proveInto(part, context, settings, arguments, names, unread.isWhole() ? input.program : program, input.properties,
                unread);
    } else {  // nothing runs, and whatever is said of it holds
      print(context.err,
            {"there is no main program to prove", files.front(), "give the file that holds the main program"});
      part.reasons.push_back({Exit::Failed, "there is no main program"});
    }
    const auto isOfProperties = [](const Finding& finding) { return finding.rule.starts_with("PRP"); };
    if (hasMain && part.properties.empty() && !arguments.builtin &&
        std::ranges::any_of(part.findings, isOfProperties)) {
      context.err << "rungproof: no property could be read; the errors say which lines are meant\n";
    } else if (hasMain && part.properties.empty() && !arguments.builtin && !(whichPart && declaresGoals)) {
      context.err << fmt::format(
          "rungproof: no property is declared in {}; see 'rungproof prove --help', or give --builtin\n", files.front());
    }
    if (wantsPage(context))
      addRecord(part, settings, input, files, arguments.properties);
    else if (whichPart)
      part.programs.push_back(basisRecord(settings, input, files, arguments.properties));
    if (whichPart) addOwnOptions(given, part.programs.back());
    const PlaceIndex places(input.program);
    for (Finding& finding : part.findings) places.complete(finding);
    if (programs.size() > 1) {
      for (PropertyResult& property : part.properties) property.program = nameInProject(files.front(), settings.root());
    }
    merger.add(part);
  }
  std::vector<ExitReason> unmet;
  for (const std::string& pattern : arguments.only) {
    if (met.contains(pattern)) continue;
    print(context.err, noSuchProperty(pattern));
    unmet.push_back({Exit::Failed, fmt::format("'{}' was not checked", pattern)});
  }
  Report report = merger.take();
  report.reasons.insert(report.reasons.end(), unmet.begin(), unmet.end());
  report.part = whichPart;
  // Another part has them.
  const bool isEmptyPart = whichPart && count > 0;
  if (report.properties.empty() && report.reasons.empty() && !isEmptyPart)
    report.reasons.push_back({Exit::Failed, "nothing was checked"});
  isSettled = isFinal(report);
  return finish(context, std::move(report));
}

/// Everything that was asked for, in words.
std::string questionOf(const ProveArguments& arguments, const Context& context) {
  std::vector<std::string> parts = {"prove", arguments.show, std::to_string(arguments.width), arguments.shard};
  for (const bool flag : {arguments.asDownloaded, arguments.builtin, arguments.selfCheck, context.color})
    parts.push_back(flag ? "1" : "0");
  for (const std::vector<std::string>* list :
       {&arguments.files, &arguments.properties, &arguments.only, &context.given}) {
    parts.push_back(fmt::format("{}:", list->size()));
    parts.insert(parts.end(), list->begin(), list->end());
  }
  // A note that becomes a program keeps its name.
  for (const std::string& name : arguments.files) std::ranges::move(programTextsIn(name), std::back_inserter(parts));
  return fmt::format("{}", fmt::join(parts, "\n"));
}

/// Files that a run writes are not kept, and standard input is read once.
bool mayBeKept(const ProveArguments& arguments, const Context& context) {
  const auto isInput = [](const std::string& name) { return name == "-"; };
  const bool hasInput =
      std::ranges::any_of(arguments.files, isInput) || std::ranges::any_of(arguments.properties, isInput);
  const bool writesFiles = !arguments.certificates.empty() || !arguments.traces.empty() || !arguments.tables.empty() ||
                           std::ranges::any_of(context.outputs, [](const OutputRequest& o) { return !o.file.empty(); });
  return !hasInput && !writesFiles;
}

Exit runProve(const ProveArguments& arguments, Context& context) {
  const std::string folder(mayBeKept(arguments, context) ? context.settings.text(Opt::Cache) : "");
  bool isSettled = false;
  if (folder.empty()) return runAnew(arguments, context, isSettled);
  const ResultCache cache(folder, questionOf(arguments, context), arguments.files);
  return repeatOrRun(cache, context,
                     [&](Context& copied, bool& isFinal) { return runAnew(arguments, copied, isFinal); });
}

Action setUpProve(ArgumentTable& table) {
  auto arguments = std::make_shared<ProveArguments>();
  table.arguments("FILE", arguments->files, "programs, symbol tables and data blocks; '-' is standard input");
  table.option("--props", arguments->properties, "FILE", "property file; may be repeated");
  table.list("--only", arguments->only, "NAME", "prove these properties only; * and ? stand for any characters");
  table.flag("--builtin", arguments->builtin,
             "also the built-in checks: set/reset conflicts, operand ranges, timers, division, loops");
  table.flag(
      "--self-check", arguments->selfCheck,
      "plant faults one by one and list those that no property notices (the exit code stays that of the proofs)");
  table.flag("--as-downloaded", arguments->asDownloaded, asDownloadedHelp);
  table.option("--certificate", arguments->certificates, "DIR",
               "write the proof of each PROVED as SMT-LIB 2, for another solver to check");
  table.option("--tables", arguments->tables, "DIR",
               "write each witness as a test table: what was mended stays mended");
  table.option("--traces", arguments->traces, "DIR", "write each witness as CSV (also a stimulus), VCD and SVG");
  table.word("--show", arguments->show, {"ladder", "lad", "fbd", "stl"}, "ladder|fbd|stl",
             "draw the networks that matter, with the power flow of the first scan of each witness, of those in which "
             "something changes that is asked about, and of the last");
  table.number("--width", arguments->width, "N", "columns of these drawings; longer rungs are wrapped (100)", 40, 1000);
  table.option("--shard", arguments->shard, "K/N",
               "prove every N-th property, from the K-th on, for N machines; part 1 has the built-in checks and the "
               "self-check; 'rungproof merge' joins the reports");
  table.flag(watchOption, arguments->watch, watchHelp);
  return [arguments](Context& context) { return runProve(*arguments, context); };
}

}  // namespace

extern constexpr Command proveCommand = {
    .name = "prove",
    .usage = "FILE... [--props FILE]...",
    .summary = "prove declared properties, or show the run that breaks them",
    .details =
        "Properties stand in comments that begin with //@ or in property files, one statement a line:\n"
        "    assume NAME: EXPR                          holds in every scan\n"
        "    prove NAME: always EXPR                    invariant pattern; 'always' may be left out\n"
        "    prove NAME: never EXPR                     forbidden pattern\n"
        "    prove NAME: EXPR implies EXPR              implication pattern\n"
        "    prove NAME: prev(EXPR) implies EXPR        state change during a cycle\n"
        "    prove NAME: prev(A) and B implies C        state change between cycles\n"
        "    prove NAME: A only after B                 leads-to pattern: B in this or an earlier scan\n"
        "    prove NAME: A implies once(prev(B) and C)  leads-to with a trigger from B to C\n"
        "    prove NAME: A implies once(prev(B))        leads-to, earlier\n"
        "    prove NAME: A held 2s implies B            timed trigger\n"
        "    reach NAME: EXPR                           reachability pattern\n"
        "    reach NAME: EXPR and once(not EXPR)        repeatability: comes again after it was gone\n"
        "    prove NAME: A leads to B within 3 scans    or: within 500ms\n"
        "    prove NAME: A unless B                     once true, stays true until\n"
        "    at every instruction prove NAME: never A   inside the scan as well, not only where outputs are written\n"
        "    external VB100..VB199                      any value in any scan\n"
        "    initial retentive                          retentive memory starts with any value\n"
        "    reset dominant Q0.0, M0.1                  set and reset in one scan: the reset is meant to win (OUT003)\n"
        "    pulse I0.0 at most every 50ms              how fast an input may rise\n"
        "Operators, tightest first: *; + -; = <> < <= > >=; not; and; xor; or; implies. Functions: rises, falls,\n"
        "prev, once, since, held, first_scan. T37 is the bit of a timer, T37.value its current value.\n"
        "In the first scan there is no scan before: prev(E) is E there, rises(E) and falls(E) are false.\n"
        "\n"
        "Verdicts: PROVED, VIOLATED, REACHABLE, UNREACHABLE, HOLDS TO BOUND n, VACUOUS, UNKNOWN, NOT COVERED.\n"
        "Every VIOLATED and REACHABLE has been repeated by the reference engine.\n"
        "\n"
        "Examples:\n"
        "    rungproof prove press.awl\n"
        "    rungproof prove press.awl --props press.prop --scan-time 5ms..20ms --timeout 30s\n"
        "    rungproof prove press.awl --show ladder --format html=press.html\n"
        "    rungproof prove press.awl --self-check\n"
        "    rungproof prove press.awl --builtin --traces witnesses --certificate proofs\n",
    .shows = option_group::Reading | option_group::Running | option_group::Output | option_group::Configuration |
             option_group::Proving,
    .setup = setUpProve,
};

}  // namespace rungproof
