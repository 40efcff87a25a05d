// From our rows to CLI11's options and back.
#include "frontend/cli/argument_parser.hpp"

#include <fmt/ranges.h>

#include <CLI/CLI.hpp>

#include "frontend/files/closest_word.hpp"
#include "ir/check.hpp"

namespace rungproof {

namespace {

/// An option of CLI11 that keeps its texts for us.
CLI::Option* declareValue(CLI::App& app, const std::string& names, bool repeatable) {
  CLI::Option* option = app.add_option(names, [](const CLI::results_t&) { return true; });
  option->expected(1)->allow_extra_args(false);
  option->multi_option_policy(repeatable ? CLI::MultiOptionPolicy::TakeAll : CLI::MultiOptionPolicy::TakeLast);
  return option;
}

CLI::Option* declare(CLI::App& app, const Argument& row) {
  const std::string names(row.names);
  if (row.isFlag()) return app.add_flag(names);
  CLI::Option* option = declareValue(app, names, row.repeatable);
  if (!row.isOption() && row.repeatable) option->expected(1, CLI::detail::expected_max_vector_size)->allow_extra_args();
  return option->required(row.required && !row.isInputs());
}

CLI::Option* declare(CLI::App& app, const OptionInfo& info, bool hasSides) {
  const std::string name = "--" + std::string(info.name);
  CHECK(app.get_option_no_throw(name) == nullptr, "a command declares a common option");
  if (info.arity == Arity::Flag) return app.add_flag(info.id == Opt::Quiet ? "-q," + name : name);
  return declareValue(app, name, info.arity == Arity::List || (hasSides && (info.group & option_group::Reading) != 0));
}

std::vector<std::string> optionNames(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::Option* option : app.get_options()) {
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  }
  return names;
}

/// The parts between commas; a comma in quotation marks belongs to a name.
std::vector<std::string> quotedParts(const std::vector<std::string>& texts) {
  std::vector<std::string> parts;
  for (const std::string& text : texts) {
    parts.emplace_back();
    bool isQuoted = false;
    for (const char c : text) {
      if (c == '"') isQuoted = !isQuoted;
      if (c == ',' && !isQuoted)
        parts.emplace_back();
      else
        parts.back() += c;
    }
  }
  if (parts.size() > 1) std::erase(parts, std::string());
  return parts;
}

/// What CLI11 says of wrong arguments, in our words.
Failure usageFailure(const CLI::ParseError& error, const CLI::App& app, const Command& command) {
  const std::string seeHelp = fmt::format("see 'rungproof {} --help'", command.name);
  if (dynamic_cast<const CLI::ExtrasError*>(&error) != nullptr) {
    const std::vector<std::string> rest = app.remaining();
    const std::string first = rest.empty() ? std::string() : rest.front();
    if (!first.starts_with("-"))
      return {fmt::format("unexpected argument '{}' for 'rungproof {}'", first, command.name), {}, seeHelp};
    const std::string name = first.substr(0, first.find('='));
    const std::vector<std::string> names = optionNames(app);
    const std::string_view meant = closest(name, names);
    return {fmt::format("unknown option '{}' for 'rungproof {}'", name, command.name),
            {},
            meant.empty() ? seeHelp : fmt::format("did you mean '{}'? {}", meant, seeHelp)};
  }
  if (dynamic_cast<const CLI::RequiredError*>(&error) != nullptr) {
    return {error.what(), {}, fmt::format("usage: rungproof {} {}", command.name, command.usage)};
  }
  if (dynamic_cast<const CLI::ArgumentMismatch*>(&error) != nullptr) {
    const std::string what = error.what();
    return {fmt::format("{} needs a value", what.substr(0, what.find(':'))), {}, seeHelp};
  }
  return {error.what(), {}, seeHelp};
}

}  // namespace

const ParsedLine::CommonOption* ParsedLine::option(Opt id) const {
  for (const CommonOption& option : options) {
    if (option.info->id == id) return &option;
  }
  return nullptr;
}

ParsedLine parseArguments(const Command& command, const ArgumentTable& table, std::vector<std::string> words) {
  CLI::App app(std::string(command.summary), std::string(command.name));
  std::vector<CLI::Option*> own, common;
  for (const Argument& row : table.rows()) own.push_back(declare(app, row));
  for (const OptionInfo& info : optionTable()) common.push_back(declare(app, info, command.comparesTwo));

  ParsedLine line;
  try {
    std::reverse(words.begin(), words.end());  // CLI11 takes them from the back
    app.parse(std::move(words));
  } catch (const CLI::CallForHelp&) {
    line.helpWanted = true;
    return line;
  } catch (const CLI::ParseError& error) {
    line.failure = usageFailure(error, app, command);
    return line;
  }
  for (std::size_t i = 0; i < own.size(); ++i) {
    const Argument& row = table.rows()[i];
    if (own[i]->count() == 0 && row.isInputs()) line.lacking = &row;
    if (own[i]->count() == 0) continue;
    const std::vector<std::string> texts = row.splits ? quotedParts(own[i]->results()) : own[i]->results();
    if (!row.isOption()) line.arguments.insert(line.arguments.end(), texts.begin(), texts.end());
    if (row.isInputs()) line.inputs = texts;
    line.failure = row.take(texts);
    if (line.failure) return line;
  }
  for (std::size_t i = 0; i < common.size(); ++i) {
    const OptionInfo& info = optionTable()[i];
    if (common[i]->count() > 0)
      line.options.push_back({&info, info.arity == Arity::Flag ? std::vector<std::string>() : common[i]->results()});
  }
  return line;
}

}  // namespace rungproof
