// `rungproof lint`: every rule that needs no solver, over one or several programs.
#include <fmt/format.h>

#include <algorithm>

#include "analysis/rule.hpp"
#include "frontend/command/command.hpp"
#include "frontend/lint_run.hpp"
#include "frontend/page/baseline.hpp"
#include "frontend/page/fix.hpp"

namespace rungproof {

namespace {

struct State {
  std::vector<std::string> files;
  bool fix = false;
  bool prove = false;
};

std::optional<Failure> subtractBaseline(const Settings& settings, const std::string& name, Report& report) {
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

/// The codes of --select that name no rule which runs without the prover.
std::vector<std::string> needingProver(const Settings& settings) {
  std::vector<std::string> result;
  for (const std::string& text : settings.list(Opt::Select)) {
    const auto isMeant = [&](const Rule* rule) { return text == "ALL" || rule->id.starts_with(text); };
    const auto asks = [&](const Rule* rule) { return isMeant(rule) && rule->ask.in != 0; };
    const auto looks = [&](const Rule* rule) { return isMeant(rule) && (rule->check != nullptr || rule->ask.in == 0); };
    if (std::ranges::any_of(allRules(), asks) && std::ranges::none_of(allRules(), looks)) result.push_back(text);
  }
  return result;
}

Action setup(ArgumentTable& table) {
  auto state = std::make_shared<State>();
  table.arguments("FILE", state->files,
                  "programs, symbol tables and data blocks; '-' is standard input; a folder stands for its programs");
  table.flag("--fix", state->fix, "write the safe fixes into the files, then report what is left");
  table.flag("--prove", state->prove,
             "also the rules that need the prover: candidates are confirmed by a replayed run, or dropped");
  return [state](Context& context) {
    const std::vector<std::string> files = expandFolders(state->files, context.settings);
    if (files.empty())
      return context.fail({"every program is excluded", state->files.front(), "see 'exclude' of 'rungproof config'"});
    Report report = lintFiles(context, files, state->prove);
    if (state->fix) {
      const bool written = applyFixes(context, report);
      report = lintFiles(context, files, state->prove);
      if (!written) return worse(Exit::Failed, finish(context, std::move(report)));
    }
    if (!state->prove) {
      for (const std::string& ids : needingProver(context.settings)) {
        print(context.err, {fmt::format("the rules that '{}' selects need the prover", ids), {}, "give --prove"});
        report.reasons.push_back({Exit::Failed, fmt::format("{} was not checked", ids)});
      }
    }
    if (context.settings.isSet(Opt::Baseline)) {
      if (auto failure = subtractBaseline(context.settings, std::string(context.settings.text(Opt::Baseline)), report))
        return context.fail(*failure);
    }
    return finish(context, std::move(report));
  };
}

}  // namespace

extern constexpr Command lintCommand = {
    .name = "lint",
    .usage = "[--fix] [--prove] FILE...",
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
        "    rungproof lint --cpu 224 --select ADR,STK --format concise *.awl\n"
        "    rungproof lint --baseline known.json --format sarif=report.sarif --format human press.awl\n",
    .shows = option_group::Reading | option_group::Rules | option_group::Output | option_group::Configuration |
             option_group::Proving,
    .setup = setup,
};

}  // namespace rungproof
