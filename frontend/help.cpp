// Help texts, from the table of common options, the commands and what they declared on their app.
// Every page is pinned by tests/golden/help.
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>

#include "frontend/cli.hpp"
#include "frontend/columns.hpp"

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

TextRow ownRow(const CLI::Option& option) {
  std::string left = option.get_positional() && option.get_lnames().empty() ? option.get_single_name() : option.get_name();
  for (std::size_t comma = left.find(','); comma != std::string::npos; comma = left.find(',', comma + 2)) left.insert(comma + 1, " ");
  const bool takesValue = option.get_items_expected_max() != 0 && !option.get_positional();
  const std::string value = option.get_type_name();
  if (takesValue) left += " " + (value.empty() || value == "TEXT" ? std::string("VALUE") : value);
  std::string right = option.get_description();
  if (!option.get_default_str().empty()) right += fmt::format(" [default: {}]", option.get_default_str());
  return {left, right};
}

struct GroupTitle {
  OptionGroups group;
  std::string_view title;
};
constexpr std::array groupTitles = {GroupTitle{option_group::Reading, "Reading"}, GroupTitle{option_group::Running, "Running and proving"},
                                    GroupTitle{option_group::Rules, "Rules"}, GroupTitle{option_group::Output, "Output"},
                                    GroupTitle{option_group::Configuration, "Configuration"}};

}  // namespace

std::string programHelp() {
  std::string text =
      "rungproof - checks, runs and proves S7-200 and S7-300/400 programs\n\n"
      "Usage: rungproof COMMAND [OPTIONS] FILE...\n\nCommands:\n";
  std::vector<TextRow> rows;
  for (const Command* command : allCommands()) rows.push_back({std::string(command->name), std::string(command->summary)});
  appendRows(text, rows, 16);
  text += "\nOptions:\n";
  appendRows(text, {{"-h, --help", "this text, or the help of a command"}, {"-V, --version", "version of the program"}}, helpColumn);
  text +=
      "\nExit codes:\n"
      "  0  nothing at or above the level, every property proved, traces agree\n"
      "  1  findings, violated properties, differing traces\n"
      "  2  could not do the job: usage, unreadable or unparsable input, bad configuration\n"
      "  3  nothing found, but something undecided\n"
      "\n'rungproof COMMAND --help' shows the options of a command, 'rungproof explain CODE' a rule.\n";
  return text;
}

std::string commandHelp(const Command& command, const CLI::App& app) {
  std::string text = fmt::format("rungproof {} - {}\n\nUsage: rungproof {} [OPTIONS]{}{}\n", command.name, command.summary, command.name,
                                 command.usage.empty() ? "" : " ", command.usage);
  if (!command.details.empty()) text += fmt::format("\n{}", command.details);

  std::vector<TextRow> arguments;
  std::vector<TextRow> options;
  for (const CLI::Option* option : app.get_options()) {
    const bool isCommon = !option->get_lnames().empty() && optionNamed(option->get_lnames().front()) != nullptr;
    if (isCommon && option->get_lnames().front() != "format") continue;
    if (isCommon || option->get_group().empty() || option->check_lname("help")) continue;
    (option->get_positional() ? arguments : options).push_back(ownRow(*option));
  }
  options.push_back({"-h, --help", "this text"});
  if (!arguments.empty()) {
    text += "\nArguments:\n";
    appendRows(text, arguments, helpColumn);
  }
  text += "\nOptions:\n";
  appendRows(text, options, helpColumn);
  for (const GroupTitle& group : groupTitles) {
    if ((command.shows & group.group) == 0) continue;
    std::vector<TextRow> rows;
    for (const OptionInfo& info : optionTable()) {
      if (info.group != group.group) continue;
      rows.push_back(info.id == Opt::Format ? formatRow(command) : commonRow(info));
    }
    text += fmt::format("\n{}:\n", group.title);
    appendRows(text, rows, helpColumn);
  }
  return text;
}

}  // namespace rungproof
