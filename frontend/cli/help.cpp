// Help texts, from the table of common options, the commands and the rows they declare.
// Every page is pinned by tests/golden/help.
#include "frontend/cli/help.hpp"

#include <fmt/ranges.h>

#include "frontend/cli/cli.hpp"
#include "frontend/text/columns.hpp"

namespace rungproof {

namespace {

constexpr std::size_t helpColumn = 30;

std::string commonHelp(const OptionInfo& info) {
  std::string text(info.help);
  if (info.arity == Arity::List && info.id != Opt::Format) text += " (may be repeated)";
  if (!info.initial.empty()) text += fmt::format(" [default: {}]", info.initial);
  return text;
}

TextRow commonRow(const OptionInfo& info) {
  std::string left = "--" + std::string(info.name);
  if (info.id == Opt::Quiet) left = "-q, " + left;
  if (!info.value.empty()) left += " " + std::string(info.value);
  return {left, commonHelp(info)};
}

TextRow formatRow(const Command& command) {
  return {"--format NAME[=FILE]",
          fmt::format("form of the output: {}; with FILE written there; may be repeated [default: {}]",
                      fmt::join(formatsOf(command), ", "), formatsOf(command).front())};
}

TextRow ownRow(const Argument& row) {
  std::string left(row.names);
  if (const std::size_t comma = left.find(','); comma != std::string::npos) left.insert(comma + 1, " ");
  if (!row.value.empty()) left += fmt::format(" {}", row.value);
  return {left, std::string(row.help)};
}

struct GroupTitle {
  OptionGroups group;
  std::string_view title;
};
constexpr std::array groupTitles = {GroupTitle{option_group::Reading, "Reading"},
                                    GroupTitle{option_group::Running, "Running and proving"},
                                    GroupTitle{option_group::Proving, "The prover's work"},
                                    GroupTitle{option_group::Rules, "Rules"},
                                    GroupTitle{option_group::Traces, "Files of loggers, oscilloscopes and simulators"},
                                    GroupTitle{option_group::Output, "Output"},
                                    GroupTitle{option_group::Configuration, "Configuration"}};

}  // namespace

std::vector<HelpSection> helpSections(const Command& command, const ArgumentTable& table) {
  HelpSection arguments{"Arguments", {}}, options{"Options", {}};
  for (const Argument& row : table.rows()) (row.isOption() ? options : arguments).rows.push_back(ownRow(row));
  options.rows.push_back({"-h, --help", "this text"});
  std::vector<HelpSection> sections;
  if (!arguments.rows.empty()) sections.push_back(std::move(arguments));
  sections.push_back(std::move(options));
  for (const GroupTitle& group : groupTitles) {
    if ((command.shows & group.group) == 0) continue;
    HelpSection& section = sections.emplace_back(HelpSection{std::string(group.title), {}});
    for (const OptionInfo& info : optionTable()) {
      if (info.group == group.group)
        section.rows.push_back(info.id == Opt::Format ? formatRow(command) : commonRow(info));
    }
  }
  return sections;
}

std::vector<TextRow> exitCodeRows() {
  return {{"0", "no finding at or above --fail-level, every property proved, traces agree"},
          {"1", "findings, violated properties, differing traces"},
          {"2", "could not do the job: usage, unreadable or unparsable input, bad configuration, nothing to check"},
          {"3", "nothing found, but something undecided"}};
}

std::string programHelp() {
  std::string text =
      "rungproof - checks, runs and proves programs of S7-200, S7-300/400 and IEC 61131-3\n\n"
      "Usage: rungproof COMMAND [OPTIONS] FILE...\n\nCommands:\n";
  std::vector<TextRow> rows;
  for (const Command* command : allCommands())
    rows.push_back({std::string(command->name), std::string(command->summary)});
  appendRows(text, rows, 16);
  text += "\nOptions:\n";
  appendRows(text, {{"-h, --help", "this text, or the help of a command"}, {"-V, --version", "version of the program"}},
             helpColumn);
  text += "\nExit codes:\n";
  for (const TextRow& row : exitCodeRows()) text += fmt::format("  {}  {}\n", row.left, row.right);
  text += "\n'rungproof COMMAND --help' shows the options of a command, 'rungproof explain CODE' a rule.\n";
  return text;
}

std::string commandHelp(const Command& command, const ArgumentTable& table) {
  std::string text = fmt::format("rungproof {} - {}\n\nUsage: rungproof {} [OPTIONS]{}{}\n", command.name,
                                 command.summary, command.name, command.usage.empty() ? "" : " ", command.usage);
  if (!command.details.empty()) text += fmt::format("\n{}", command.details);

  for (const HelpSection& section : helpSections(command, table)) {
    text += fmt::format("\n{}:\n", section.title);
    appendRows(text, section.rows, helpColumn);
  }
  return text;
}

}  // namespace rungproof
