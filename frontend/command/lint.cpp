// `rungproof lint`: every rule that needs no solver, over one or several programs.
#include <fmt/format.h>

#include <algorithm>

#include "analysis/read_errors.hpp"
#include "frontend/command.hpp"
#include "frontend/linting/baseline.hpp"
#include "frontend/linting/fix.hpp"
#include "frontend/linting/lint_run.hpp"
#include "frontend/watch.hpp"

namespace rungproof {

namespace {

struct LintState {
  std::vector<std::string> files;
  bool fix = false;
  bool diff = false;
  bool unsafeFixes = false;
  bool prove = false;
  std::string traces;
  bool watch = false;
};

/// A file that was not read at all: what would be fixed in it is not known.
bool isLostForFixes(const Finding& finding) { return finding.rule == "SYN001" || finding.rule == "SYN002"; }

Action setUpLint(ArgumentTable& table) {
  auto state = std::make_shared<LintState>();
  table.arguments("FILE", state->files,
                  "programs, symbol tables and data blocks; '-' is standard input; a folder stands for its programs");
  table.flag("--fix", state->fix,
             "write the safe fixes into the files, then report what is left; of standard input the fixed text goes to "
             "standard output and the report to standard error");
  table.flag(
      "--diff", state->diff,
      "show as a diff what --fix would change, and change nothing; 1: something would be, 2: not all could be read");
  table.flag("--unsafe-fixes", state->unsafeFixes,
             "with --fix and --diff: also the fixes that are guesses and may change what the program does");
  table.flag("--prove", state->prove,
             "also the rules that need the prover: candidates are confirmed by a replayed run, or dropped");
  table.option("--traces", state->traces, "DIR",
               "with --prove: write the run that confirms each finding as CSV (also a stimulus), VCD and SVG");
  table.flag(watchOption, state->watch, watchHelp);
  return [state](Context& context) {
    const std::vector<std::string> files = expandFolders(state->files, context.settings);
    if (files.empty())
      return context.fail({"every program is excluded", state->files.front(), "see 'exclude' of 'rungproof config'"});
    if (!state->traces.empty() && !state->prove)
      return context.fail({"--traces writes the runs that the prover finds", state->traces, "give --prove"});
    Report report = lintFiles(context, files, state->prove, state->traces);
    const FixLevel level = state->unsafeFixes ? FixLevel::Unsafe : FixLevel::Safe;
    const bool readsInput = std::ranges::find(files, "-") != files.end();
    if (state->diff) {
      bool isRead = report.reasons.empty();  // of rules that did not look
      for (const Finding& finding : report.findings) {
        if (!isReadError(finding)) continue;
        isRead = false;
        if (!isLostForFixes(finding)) {
          const Position at = report.sources->position(finding.span);
          const std::string place = fmt::format("{}:{}", report.sources->file(finding.span.file).name(), at.line);
          print(context.err, {finding.message, place, finding.help});
          continue;
        }
        print(context.err, {finding.message, report.sources->file(finding.span.file).name(), finding.help});
      }
      const std::size_t count = showFixes(context, report, level);
      return !isRead ? Exit::Failed : count > 0 ? Exit::Found : Exit::Clean;
    }
    if (state->fix) {
      const bool written = applyFixes(context, report, level, readsInput);
      report = lintFiles(context, files, state->prove, state->traces);
      if (readsInput) {
        Context beside{context.settings, context.in,     context.err, context.err, false,
                       context.progress, context.outputs};
        return written ? finish(beside, std::move(report)) : worse(Exit::Failed, finish(beside, std::move(report)));
      }
      if (!written) return worse(Exit::Failed, finish(context, std::move(report)));
    }
    if (auto failure = subtractBaseline(context.settings, report)) return context.fail(*failure);
    return finish(context, std::move(report));
  };
}

}  // namespace

extern constexpr Command lintCommand = {
    .name = "lint",
    .usage = "[--fix] [--diff] [--prove] FILE...",
    .summary = "check programs against the rules",
    .details =
        "Files without a main program (symbol tables, data blocks, libraries) belong to every program given.\n"
        "A finding is silenced by a comment with the rule and a reason, on its line, before the first\n"
        "instruction of its network, or in the head of its block; what stands between begin and end by one pair:\n"
        "    // rungproof: allow OUT001 the two networks exclude each other\n"
        "    // rungproof: begin OUT001 networks of the old machine\n"
        "    // rungproof: end\n"
        "\n"
        "Examples:\n"
        "    rungproof lint press.awl\n"
        "    rungproof lint --diff press.awl\n"
        "    rungproof lint --cpu 224 --select ADR,STK --format concise *.awl\n"
        "    rungproof lint --baseline known.json --format sarif=report.sarif --format human press.awl\n",
    .shows = option_group::Reading | option_group::Rules | option_group::Output | option_group::Configuration |
             option_group::Proving,
    .takesEachProgram = true,
    .setup = setUpLint,
};

}  // namespace rungproof
