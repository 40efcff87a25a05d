// `rungproof config`: the value of every option in this run and where it comes from, and the points that the manual
// leaves open with the chosen reading.
#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "frontend/command/command.hpp"

namespace rungproof {

namespace {

std::string valueText(const OptionInfo& info, const Settings& settings) {
  if (info.arity == Arity::Flag) return settings.flag(info.id) ? "true" : "false";
  if (info.arity == Arity::One && settings.text(info.id).empty()) return "\"\"";
  if (info.arity == Arity::One) return fmt::format("\"{}\"", settings.text(info.id));
  std::string text = "[";
  for (const std::string& item : settings.list(info.id)) text += fmt::format("{}\"{}\"", text.size() > 1 ? ", " : "", item);
  return text + "]";
}

std::string_view chosen(const ChoiceInfo& info, const Settings& settings) { return info.values[settings.choices()[info.choice]]; }

/// TOML, so that it can be saved as rungproof.toml; origins are comments.
std::string configText(const Settings& settings) {
  std::string text;
  for (const OptionInfo& info : optionTable()) {
    if (!info.inConfig) continue;
    const std::string line = fmt::format("{} = {}", info.name, valueText(info, settings));
    const bool unset = valueText(info, settings) == "\"\"" || valueText(info, settings) == "[]";
    text += fmt::format("{:<30} # {}\n", (unset ? "# " : "") + line, settings.origin(info.id));
  }
  text += "\n[choices]                      # points that the manual leaves open\n";
  for (const ChoiceInfo& info : choiceTable) {
    text += fmt::format("{:<30} # {}\n", fmt::format("{} = \"{}\"", info.key, chosen(info, settings)), settings.choiceOrigin(info.choice));
  }
  return text;
}

std::string configJson(const Settings& settings) {
  nlohmann::ordered_json json;
  for (const OptionInfo& info : optionTable()) {
    if (!info.inConfig) continue;
    nlohmann::ordered_json value;
    if (info.arity == Arity::Flag) value = settings.flag(info.id);
    if (info.arity == Arity::One && !settings.text(info.id).empty()) value = settings.text(info.id);
    if (info.arity == Arity::List) value = settings.list(info.id);
    json["options"][std::string(info.name)] = {{"value", value}, {"origin", settings.origin(info.id)}};
  }
  for (const ChoiceInfo& info : choiceTable) {
    json["choices"][std::string(info.key)] = {
        {"value", chosen(info, settings)}, {"origin", settings.choiceOrigin(info.choice)}, {"manual", info.manual}};
  }
  json["rules"] = nlohmann::ordered_json::object();
  for (const auto& [key, value] : settings.ruleSettings()) json["rules"][key] = value;
  return json.dump(2) + "\n";
}

Action setup(CLI::App& app) {
  auto files = std::make_shared<std::vector<std::string>>();
  app.add_option("FILE", *files, "files whose configuration is wanted; the current folder without");
  return [files](Context& context) {
    Exit exit = Exit::Clean;
    for (const OutputRequest& output : context.outputs) {
      const std::string text = output.name == "json" ? configJson(context.settings) : configText(context.settings);
      if (!context.write(output, text)) exit = Exit::Failed;
    }
    return exit;
  };
}

}  // namespace

extern constexpr Command configCommand = {
    .name = "config",
    .usage = "[FILE]...",
    .summary = "show the resolved configuration and where each value comes from",
    .details =
        "The text is a complete rungproof.toml. Values come from the command line, else from the nearest\n"
        "rungproof.toml beside FILE or above it, else from the defaults.\n",
    .shows = option_group::All,
    .formats = "text|json",
    .setup = setup,
};

}  // namespace rungproof
