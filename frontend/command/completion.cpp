// `rungproof completion SHELL`: a completion script for bash, zsh or fish, made from the commands, what they declare
// and the option table, so that it is never behind.
#include <fmt/ranges.h>

#include "frontend/cli/cli.hpp"
#include "frontend/command.hpp"
#include "frontend/settings/code_list.hpp"

namespace rungproof {

namespace {

/// An option as completion sees it.
struct Completed {
  std::string name;  ///< "--cpu"
  std::string help;
  std::vector<std::string_view> words;  ///< values to offer
  bool takesValue = false;
};

/// Rules and their groups, as --select takes them.
std::vector<std::string_view> codeWords() {
  std::vector<std::string_view> words = {"ALL"};
  for (const RuleGroup& group : ruleGroups()) words.push_back(group.prefix);
  for (const Code& code : allCodes()) words.push_back(code.id);
  return words;
}

std::vector<Completed> optionsOf(const Command& command) {
  ArgumentTable table;
  const Action action = command.setup(table);
  std::vector<Completed> options = {{"--help", "help of the command", {}}};
  for (const Argument& row : table.rows()) {
    if (row.isOption())
      options.push_back({std::string(row.longName()), std::string(row.help), permittedWords(row.value), !row.isFlag()});
  }
  for (const OptionInfo& info : optionTable()) {
    const bool isOfRules = info.id == Opt::Select || info.id == Opt::Ignore;
    options.push_back({"--" + std::string(info.name), std::string(info.help),
                       info.id == Opt::Format ? formatsOf(command)
                       : isOfRules            ? codeWords()
                                              : permittedWords(info.value),
                       info.arity != Arity::Flag});
  }
  return options;
}

std::vector<std::string_view> ruleWords() {
  std::vector<std::string_view> words = {"hazards", "choices"};
  for (const Code& code : allCodes()) words.push_back(code.id);
  return words;
}

/// Words that the first argument of a command can be, where it is no file.
std::vector<std::string_view> argumentWords(const Command& command) {
  if (command.name == "explain") return ruleWords();
  if (command.name == "completion") return {"bash", "zsh", "fish"};
  return {};
}

/// Text inside single quotes of a shell.
std::string shellQuoted(std::string_view text) {
  std::string result;
  for (const char c : text) result += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return result;
}

std::string bashScript() {
  std::string cases;
  std::vector<std::string_view> names;
  for (const Command* command : allCommands()) {
    names.push_back(command->name);
    std::vector<std::string> words;
    std::string values;
    for (const Completed& option : optionsOf(*command)) {
      words.push_back(option.name);
      if (!option.words.empty())
        values += fmt::format("        {}) words='{}' ;;\n", option.name, fmt::join(option.words, " "));
    }
    cases += fmt::format("    {})\n      case \"$before\" in\n{}        *) words='{}{}{}' ;;\n      esac ;;\n",
                         command->name, values, fmt::join(words, " "), argumentWords(*command).empty() ? "" : " ",
                         fmt::join(argumentWords(*command), " "));
  }
  return fmt::format(
      "# bash completion for rungproof: source it, or put it into a folder of bash-completion.\n"
      "_rungproof() {{\n"
      "  local current=\"${{COMP_WORDS[COMP_CWORD]}}\" before=\"${{COMP_WORDS[COMP_CWORD-1]}}\" words=''\n"
      "  if [ \"$COMP_CWORD\" -eq 1 ]; then\n"
      "    COMPREPLY=($(compgen -W '{} --help --version' -- \"$current\"))\n"
      "    return\n"
      "  fi\n"
      "  case \"${{COMP_WORDS[1]}}\" in\n{}"
      "  esac\n"
      "  COMPREPLY=($(compgen -W \"$words\" -- \"$current\"))\n"
      "}}\n"
      "complete -o default -F _rungproof rungproof\n",
      fmt::join(names, " "), cases);
}

std::string zshScript() {
  std::string commands;
  std::string cases;
  for (const Command* command : allCommands()) {
    commands += fmt::format("    '{}:{}'\n", command->name, shellQuoted(command->summary));
    cases += fmt::format("    {})\n      _arguments \\\n", command->name);
    for (const Completed& option : optionsOf(*command)) {
      std::string help;
      for (const char c : option.help) help += c == '[' || c == ']' ? std::string("\\") + c : std::string(1, c);
      const std::string value = !option.takesValue     ? ""
                                : option.words.empty() ? ":value:_files"
                                                       : fmt::format(":value:({})", fmt::join(option.words, " "));
      cases += fmt::format("        '{}[{}]{}' \\\n", option.name, shellQuoted(help), value);
    }
    const auto words = argumentWords(*command);
    cases += words.empty() ? std::string("        '*:file:_files' ;;\n")
                           : fmt::format("        '1:word:({})' ;;\n", fmt::join(words, " "));
  }
  return fmt::format(
      "#compdef rungproof\n"
      "_rungproof() {{\n"
      "  local -a commands=(\n{}  )\n"
      "  if (( CURRENT == 2 )); then\n"
      "    _describe 'command' commands\n"
      "    return\n"
      "  fi\n"
      "  local command=$words[2]\n"
      "  shift words\n"
      "  (( CURRENT-- ))\n"
      "  case $command in\n{}"
      "  esac\n"
      "}}\n"
      "# as a file in a folder of completions, or evaluated\n"
      "if [ \"$funcstack[1]\" = _rungproof ]; then _rungproof \"$@\"; else compdef _rungproof rungproof; fi\n",
      commands, cases);
}

std::string fishScript() {
  std::string text = "# fish completion for rungproof: save as completions/rungproof.fish.\ncomplete -c rungproof -f\n";
  for (const Command* command : allCommands()) {
    text += fmt::format("complete -c rungproof -n __fish_use_subcommand -a {} -d '{}'\n", command->name,
                        shellQuoted(command->summary));
    const std::string condition =
        fmt::format("complete -c rungproof -n '__fish_seen_subcommand_from {}'", command->name);
    for (const Completed& option : optionsOf(*command)) {
      text += fmt::format("{} -l {} -d '{}'", condition, option.name.substr(2), shellQuoted(option.help));
      if (option.takesValue)
        text += option.words.empty() ? std::string(" -r -F") : fmt::format(" -x -a '{}'", fmt::join(option.words, " "));
      text += '\n';
    }
    const auto words = argumentWords(*command);
    text += words.empty() ? condition + " -F\n" : fmt::format("{} -a '{}'\n", condition, fmt::join(words, " "));
  }
  return text;
}

Action setUpCompletion(ArgumentTable& table) {
  auto shell = std::make_shared<std::string>();
  table.argument("SHELL", *shell, "bash, zsh or fish");
  return [shell](Context& context) {
    const bool known = *shell == "bash" || *shell == "zsh" || *shell == "fish";
    if (!known)
      return context.fail({fmt::format("there is no completion for '{}'", *shell), {}, "it can be bash, zsh or fish"});
    context.out << (*shell == "bash" ? bashScript() : *shell == "zsh" ? zshScript() : fishScript());
    return Exit::Clean;
  };
}

}  // namespace

extern constexpr Command completionCommand = {
    .name = "completion",
    .usage = "SHELL",
    .summary = "print a completion script for bash, zsh or fish",
    .details = "To use it now: eval \"$(rungproof completion bash)\"\n",
    .shows = 0,
    .needsNoConfig = true,
    .formats = "text",
    .setup = setUpCompletion,
};

}  // namespace rungproof
