// `rungproof baseline`: writes the findings of today into a file, so that `lint --baseline` reports only new ones.

#include "frontend/linting/baseline.hpp"

#include <fmt/format.h>

#include "analysis/read_errors.hpp"
#include "frontend/command.hpp"
#include "frontend/linting/lint_run.hpp"
#include "frontend/text/safe_text.hpp"

namespace rungproof {

namespace {

struct BaselineState {
  std::vector<std::string> files;
  std::string output;
  std::string show;
  std::string prune;
};

std::string tableOf(const Baseline& baseline) {
  std::string text;
  std::size_t findings = 0;
  for (const BaselineEntry& entry : baseline.entries) {
    findings += entry.count;
    text += fmt::format("{}: {}{}: {}\n", entry.file, entry.rule,
                        entry.count > 1 ? fmt::format(", {} places", entry.count) : "", entry.message);
  }
  return text + fmt::format("{} finding{} in {} entr{}\n", findings, findings == 1 ? "" : "s", baseline.entries.size(),
                            baseline.entries.size() == 1 ? "y" : "ies");
}

Action setUpBaseline(ArgumentTable& table) {
  auto state = std::make_shared<BaselineState>();
  table.arguments("FILE", state->files, "programs, symbol tables and data blocks; '-' is standard input", true);
  table.option("-o,--output", state->output, "FILE", "file to write; standard output without");
  table.option("--show", state->show, "BASELINE", "print what the baseline file lists");
  table.option("--prune", state->prune, "BASELINE", "remove the entries that no finding of FILE matches any more");
  return [state](Context& context) {
    if (!state->show.empty()) {
      Baseline known;
      std::string text;
      if (auto failure = readBaselineFile(state->show, known, text)) return context.fail(*failure);
      context.out << visibleText(tableOf(known));
      return Exit::Clean;
    }
    if (state->files.empty()) state->files = context.settings.inputs();
    if (state->files.empty())
      return context.fail({"FILE is required", {}, "usage: rungproof baseline FILE... [-o FILE]"});
    if (auto failure = folderFailure(state->files)) return context.fail(*failure);
    const std::vector<std::string> files = expandFolders(state->files, context.settings);
    if (files.empty())
      return context.fail({"every program is excluded", state->files.front(), "see 'exclude' of 'rungproof config'"});
    Report report = lintFiles(context, files);
    if (!report.reasons.empty()) return Exit::Failed;  // not all was checked, and it has been said
    std::erase_if(report.findings, [&](const Finding& finding) { return finding.severity < context.settings.level(); });
    for (const Finding& finding : report.findings) {
      if (isReadError(finding))
        return context.fail(
            {"the program could not be read: " + finding.message, {}, "'rungproof lint' shows the places"});
    }
    if (state->prune.empty())
      return context.write({"json", state->output}, toJson(baselineOf(report))) ? Exit::Clean : Exit::Failed;
    Baseline known;
    std::string text;
    if (auto failure = readBaselineFile(state->prune, known, text)) return context.fail(*failure);
    const Baseline pruned = prunedBaseline(known, report);
    const std::string& target = state->output.empty() ? state->prune : state->output;
    if (!context.write({"json", target}, toJson(pruned), InputFile::Replace)) return Exit::Failed;
    if (!context.settings.flag(Opt::Quiet))
      context.err << fmt::format("rungproof: {} of {} entries are left in {}\n", pruned.entries.size(),
                                 known.entries.size(), target);
    return Exit::Clean;
  };
}

}  // namespace

extern constexpr Command baselineCommand = {
    .name = "baseline",
    .usage = "FILE... [-o FILE] [--prune BASELINE] | --show BASELINE",
    .summary = "write, prune or show the file of known findings",
    .details =
        "Entries hold the rule, the block, the address and the text of the line, but no line numbers: a\n"
        "baseline survives edits elsewhere. Entries that no finding matches any more are reported as SUP003.\n"
        "\n"
        "Example:\n"
        "    rungproof baseline press.awl -o known.json\n"
        "    rungproof baseline --prune known.json press.awl\n"
        "    rungproof baseline --show known.json\n"
        "    rungproof lint --baseline known.json press.awl\n",
    .shows = option_group::Reading | option_group::Rules | option_group::Configuration,
    .formats = "json",
    .takesEachProgram = true,
    .setup = setUpBaseline,
};

}  // namespace rungproof
