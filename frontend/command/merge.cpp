// `rungproof merge`: the reports of a run that several machines shared, as one.
#include <fmt/format.h>

#include "frontend/command.hpp"
#include "frontend/files/disk_file.hpp"
#include "frontend/merging/report_parts.hpp"

namespace rungproof {

namespace {

struct MergeArguments {
  std::vector<std::string> files;
  std::string output;
};

Exit runMerge(const MergeArguments& arguments, Context& context) {
  std::vector<PartFile> parts;
  for (const std::string& name : arguments.files) {
    const auto& [content, problem] = inputBytes(name, longestProgram);
    if (!content)
      return context.fail({fmt::format("cannot read '{}': {}", name, problem), {}, "give the reports of all parts"});
    parts.push_back({name, *content});
  }
  JoinResult joined = joinParts(parts);
  if (const Failure* failure = std::get_if<Failure>(&joined)) return context.fail(*failure);
  const JoinedReport& report = std::get<JoinedReport>(joined);
  if (!context.write({"", arguments.output}, report.text)) return Exit::Failed;
  return report.exit;
}

Action setUpMerge(ArgumentTable& table) {
  auto arguments = std::make_shared<MergeArguments>();
  table.arguments("PART", arguments->files, "reports of all parts in one form: JSON, SARIF or JUnit");
  table.option("-o,--output", arguments->output, "FILE", "write the joined report there instead of standard output");
  return [arguments](Context& context) { return runMerge(*arguments, context); };
}

}  // namespace

extern constexpr Command mergeCommand = {
    .name = "merge",
    .usage = "PART... [-o FILE]",
    .summary = "join the reports of a run that several machines shared",
    .details =
        "Each machine asks its part of the properties and writes a report. All parts have to be there, each once:\n"
        "otherwise something was not asked, and the exit code is 2. The joined report has the form of the parts. The\n"
        "exit code is the worst of theirs.\n"
        "\n"
        "Examples:\n"
        "    rungproof prove . --shard 1/4 --format json=part1.json\n"
        "    rungproof merge part1.json part2.json part3.json part4.json -o proofs.json\n",
    .shows = option_group::Output,
    .needsNoConfig = true,
    .formats = "text",
    .setup = setUpMerge,
};

}  // namespace rungproof
