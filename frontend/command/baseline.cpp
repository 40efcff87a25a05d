// `rungproof baseline`: writes the findings of today into a file, so that `lint --baseline` reports only new ones.

#include "frontend/page/baseline.hpp"

#include "analysis/read_errors.hpp"
#include "frontend/command/command.hpp"
#include "frontend/lint_run.hpp"

namespace rungproof {

namespace {

struct State {
  std::vector<std::string> files;
  std::string output;
};

Action setup(ArgumentTable& table) {
  auto state = std::make_shared<State>();
  table.arguments("FILE", state->files, "programs, symbol tables and data blocks; '-' is standard input");
  table.option("-o,--output", state->output, "FILE", "file to write; standard output without");
  return [state](Context& context) {
    const std::vector<std::string> files = expandFolders(state->files);
    if (files.empty())
      return context.fail({"the folder holds no program", state->files.front(), "programs end in .awl, .stl or .xml"});
    Report report = lintFiles(context, files);
    std::erase_if(report.findings, [&](const Finding& finding) { return finding.severity < context.settings.level(); });
    for (const Finding& finding : report.findings) {
      if (isReadError(finding))
        return context.fail(
            {"the program could not be read: " + finding.message, {}, "'rungproof lint' shows the places"});
    }
    return context.write({"json", state->output}, toJson(baselineOf(report))) ? Exit::Clean : Exit::Failed;
  };
}

}  // namespace

extern constexpr Command baselineCommand = {
    .name = "baseline",
    .usage = "FILE... [-o FILE]",
    .summary = "write the present findings to a baseline file",
    .details =
        "Entries hold the rule, the block, the address and the text of the line, but no line numbers: a\n"
        "baseline survives edits elsewhere. Entries that no finding matches any more are reported as SUP003.\n"
        "\n"
        "Example:\n"
        "    rungproof baseline press.awl -o known.json\n"
        "    rungproof lint --baseline known.json press.awl\n",
    .shows = option_group::Reading | option_group::Rules | option_group::Configuration,
    .formats = "json",
    .setup = setup,
};

}  // namespace rungproof
