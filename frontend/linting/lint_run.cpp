// One lint run.
#include "frontend/linting/lint_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <exception>
#include <iterator>
#include <optional>
#include <thread>

#include "analysis/lint/lint.hpp"
#include "analysis/lint/suppress.hpp"
#include "analysis/proof/rule_answers.hpp"
#include "analysis/unread/idle_blocks.hpp"
#include "frontend/input/proof_input.hpp"
#include "frontend/input/protected_findings.hpp"
#include "frontend/input/text_sources.hpp"
#include "frontend/linting/baseline.hpp"
#include "frontend/linting/rule_scope.hpp"
#include "frontend/settings/code_list.hpp"
#include "frontend/simulation/witness_report.hpp"
#include "frontend/stl/syntax_message.hpp"

namespace rungproof {

namespace {

void applySeverities(const Settings& settings, Report& report) {
  for (Finding& finding : report.findings) {
    const auto wanted = settings.severities().find(finding.rule);
    if (wanted != settings.severities().end() && !isReadError(finding)) finding.severity = wanted->second;
  }
}

/// What files are not to be reported for; errors of the readers stay.
void ignoreInFiles(const Settings& settings, Report& report) {
  std::erase_if(report.findings, [&](const Finding& finding) {
    if (isReadError(finding)) return false;
    return std::ranges::any_of(settings.fileIgnores(), [&](const FileIgnore& ignore) {
      const auto isMeant = [&](const std::string& code) { return code == "ALL" || finding.rule.starts_with(code); };
      return std::ranges::any_of(ignore.codes, isMeant) &&
             fitsPattern(report.sources->file(finding.span.file).name(), ignore.pattern);
    });
  });
}

/// Of --traces: the rule and what it asked make the name of a file.
RunWriter runWriter(const Context& context, const Settings& settings, EvidenceNames& names, const std::string& folder) {
  if (folder.empty()) return {};
  return [&, folder](const Program& program, const ProofResult& result) {
    const Rule* rule = result.builtin ? result.builtin->rule : ruleOf(result);
    std::vector<std::string> notes;  // of a very long run the last scans are there; its first row says which
    return writeRun(context, folder, names.of(fmt::format("{} {}", rule->id, result.property.name)), program,
                    settings.choices(), result, notes);
  };
}

/// The programs one after the other, or several at once where each needs a processor only: the prover has threads and a
/// limit of memory of its own. The reports have the order of the programs.
/// `linted`: becomes what they are.
std::vector<Report> lintSideBySide(const Context& context, const std::vector<std::vector<std::string>>& programs,
                                   bool prove, EvidenceNames& names, const std::string& traces,
                                   std::vector<LintedProgram>& linted) {
  for (const std::vector<std::string>& files : programs) linted.push_back({&context.settingsOf(files), {}});
  std::vector<Report> reports(programs.size());
  std::vector<std::exception_ptr> failures(programs.size());
  std::atomic<std::size_t> next = 0;
  const auto work = [&] {
    for (std::size_t i = next++; i < programs.size(); i = next++) {
      try {
        const Settings& settings = *linted[i].settings;
        const ProgramInput input = readInput(context, settings, programs[i]);
        linted[i].target = input.program.target;
        reports[i] = lintProgram(settings, input, programs[i], prove, runWriter(context, settings, names, traces));
      } catch (...) {
        failures[i] = std::current_exception();
      }
    }
  };
  const std::int64_t processors = std::max(1U, std::thread::hardware_concurrency());
  const std::int64_t jobs = prove ? 1 : context.settings.number(Opt::Jobs, processors);
  std::vector<std::thread> threads;
  for (std::int64_t i = 1; i < std::min<std::int64_t>(jobs, std::ssize(programs)); ++i) threads.emplace_back(work);
  work();
  for (std::thread& thread : threads) thread.join();
  for (const std::exception_ptr& failure : failures) {
    if (failure) std::rethrow_exception(failure);
  }
  return reports;
}

/// For proofs: the program without data blocks that nothing opens, if there are any. Rules look at instances among them
/// only, and at those of panel words.
std::optional<ProgramInput> withoutIdleBlocks(const ProgramInput& input) {
  if (!dialectOf(input.program.target).memory.hasDataBlocks) return std::nullopt;
  NamedBlocks named;
  named.addText(input.program);
  named.addQuestions(input.properties);
  for (const PanelTag& tag : input.surroundings.tags) named.add(tag.address);
  const auto isIdle = [&](const DataBlock& block) { return block.instanceOf == 0 && !named.mayOpen(block.number); };
  if (std::ranges::none_of(input.program.dataBlocks, isIdle)) return std::nullopt;
  ProgramInput smaller = input;
  std::erase_if(smaller.program.dataBlocks, isIdle);
  return smaller;
}

}  // namespace

bool isSelected(const Settings& settings, std::string_view id) {
  const RuleSelection selection(settings.list(Opt::Select), settings.list(Opt::Ignore));
  const auto code = codeNamed(id);
  return !code || selection.includes(id, code->onByDefault);
}

Report lintProgram(const Settings& settings, const ProgramInput& given, const std::vector<std::string>& files,
                   bool prove, const RunWriter& writeRun) {
  const std::optional<ProgramInput> smaller = prove ? withoutIdleBlocks(given) : std::nullopt;
  const ProgramInput& input = smaller ? *smaller : given;
  const Program& program = input.program;
  const RuleSelection selection(settings.list(Opt::Select), settings.list(Opt::Ignore));
  Report report = startReport("lint", program, files);

  const auto isSelected = [&](std::string_view id) { return rungproof::isSelected(settings, id); };
  // Errors of the readers cannot be ignored: what was not read was not checked.
  std::erase_if(report.findings,
                [&](const Finding& finding) { return !isReadError(finding) && !isSelected(finding.rule); });
  if (isSelected(syntaxMessage(Syntax::SourceUnlike).id))
    std::ranges::move(findUnlikeSources(program, files, settings), std::back_inserter(report.findings));
  std::vector<Finding> found =
      runRules(program, input.properties.externals, input.surroundings, selection, settings.ruleSettings());
  found.insert(found.begin(), std::make_move_iterator(report.findings.begin()),
               std::make_move_iterator(report.findings.end()));
  report.findings = std::move(found);
  if (prove) {
    const UnreadCode unread(program, settings.choices());
    ProverOptions options = lintProverOptionsOf(settings, program);
    options.unread = &unread;
    options.explains = options.explains || writeRun;  // runs of rules are kept
    OpenQuestions open;
    if (unread.isWhole())
      open = settleBySolver(input, options, isSelected, report.findings, writeRun);
    else if (!unread.isUnlimited())
      open = settleBySolver({unread.executable(), input.properties}, options, isSelected, report.findings, writeRun);
    report.coverage.leftOut = std::move(open.lines);
    report.assumptions.insert(report.assumptions.end(), open.assumptions.begin(), open.assumptions.end());
    report.coverage.open = open.count;
    report.techniques = open.techniques;
    report.defects = std::move(open.defects);
  }
  const PlaceIndex places(program);
  for (Finding& finding : report.findings) places.complete(finding);
  hideProtected(program, report.findings);
  applySeverities(settings, report);
  ignoreInFiles(settings, report);

  if (!settings.flag(Opt::NoSuppress)) {
    const KnownRules known{[](std::string_view id) { return codeNamed(id).has_value(); },
                           [&](std::string_view id) {
                             const Rule* rule = ruleNamed(id);
                             return isSelected(id) && (rule == nullptr || rule->check != nullptr);
                           }};
    report.suppressed = applySuppressions(program, known, report.findings);
    std::erase_if(report.findings,
                  [&](const Finding& finding) { return finding.rule.starts_with("SUP") && !isSelected(finding.rule); });
  }
  return report;
}

Report lintFiles(const Context& context, const std::vector<std::string>& files, bool prove, const std::string& traces) {
  EvidenceNames names;
  std::vector<LintedProgram> linted;
  std::vector<Report> parts = lintSideBySide(context, groupByProgram(context, files), prove, names, traces, linted);
  Report report;
  if (parts.size() == 1) {
    report = std::move(parts.front());
  } else {
    ReportMerger merger;
    for (const Report& part : parts) merger.add(part);
    report = merger.take();
  }
  for (const Failure& idle : idleRules(linted, prove)) {
    print(context.err, {idle.message, {}, idle.help});
    report.reasons.push_back(
        {Exit::Failed, idle.place.empty() ? "nothing was checked" : fmt::format("{} was not checked", idle.place)});
  }
  for (const std::string& defect : report.defects) context.err << fmt::format("rungproof: {}\n", defect);
  sortFindings(report);
  return report;
}

std::optional<Failure> subtractBaseline(const Settings& settings, Report& report) {
  if (!settings.isSet(Opt::Baseline)) return std::nullopt;
  const std::string name(settings.text(Opt::Baseline));
  Baseline baseline;
  std::string text;
  if (auto failure = readBaselineFile(name, baseline, text)) return failure;
  // The baseline becomes a source of the report, so that stale entries have a place.
  auto sources = std::make_shared<SourceSet>();
  for (std::uint32_t i = 0; i < report.sources->size(); ++i)
    sources->add(report.sources->file(i).name(), std::string(report.sources->file(i).text()));
  const std::uint32_t file = sources->add(name, text);
  report.sources = sources;
  applyBaseline(
      baseline, file, [&](std::string_view id) { return isSelected(settings, id); }, report);
  return std::nullopt;
}

}  // namespace rungproof
