// `rungproof config`: the value of every option in this run and where it comes from, and the points that the manual
// leaves open with the chosen reading.
#include <fmt/core.h>

#include <map>

#include "analysis/rule.hpp"
#include "frontend/command.hpp"
#include "frontend/files/json.hpp"
#include "frontend/text/safe_text.hpp"

namespace rungproof {

namespace {

std::string listTextOfConfig(const std::vector<std::string>& items) {
  std::string text = "[";
  for (const std::string& item : items) text += (text.size() > 1 ? ", " : "") + tomlText(item);
  return text + "]";
}

std::string valueText(const OptionInfo& info, const Settings& settings) {
  if (info.arity == Arity::Flag) return settings.flag(info.id) ? "true" : "false";
  if (info.id == Opt::Edition) return tomlText(editionName(settings.target().edition));
  if (info.arity == Arity::One) return tomlText(settings.text(info.id));
  return listTextOfConfig(settings.list(info.id));
}

std::string_view chosen(const ChoiceInfo& info, const Settings& settings) {
  return info.values[settings.choices()[info.choice]];
}

struct ConfigLine {
  std::string text;
  std::string comment;
};

void appendLines(std::string& text, const std::vector<ConfigLine>& lines) {
  std::size_t width = 0;
  for (const ConfigLine& line : lines) width = std::max(width, line.text.size());
  for (const ConfigLine& line : lines) text += fmt::format("{:<{}}  # {}\n", line.text, width, lineText(line.comment));
}

/// TOML, so that it can be saved as rungproof.toml; origins are comments.
std::string configText(const Settings& settings) {
  std::vector<ConfigLine> options;
  for (const OptionInfo& info : optionTable()) {
    if (!info.inConfig) continue;
    const std::string line = fmt::format("{} = {}", info.name, valueText(info, settings));
    const bool unset = valueText(info, settings) == "\"\"" || valueText(info, settings) == "[]";
    options.push_back({(unset ? "# " : "") + line, settings.origin(info.id)});
  }
  std::vector<ConfigLine> choices;
  for (const ChoiceInfo& info : choiceTable) {
    choices.push_back(
        {fmt::format("{} = \"{}\"", info.key, chosen(info, settings)), settings.choiceOrigin(info.choice)});
  }
  if (!settings.inputs().empty())
    options.push_back({fmt::format("inputs = {}", listTextOfConfig(settings.inputs())), "configuration"});
  std::string text;
  appendLines(text, options);
  text += "\n# points that the manual leaves open, see 'rungproof explain choices'\n[choices]\n";
  appendLines(text, choices);
  std::map<std::string, std::string> rules;
  for (const auto& [key, value] : settings.ruleSettings()) {
    const std::size_t dot = key.find('.');
    rules[key.substr(0, dot)] += fmt::format("{} = {}\n", key.substr(dot + 1), value);
  }
  for (const auto& [id, severity] : settings.severities())
    rules[id] += fmt::format("severity = \"{}\"\n", severityName(severity));
  for (const auto& [id, lines] : rules) text += fmt::format("\n[rules.{}]\n{}", id, lines);
  if (!settings.fileIgnores().empty()) text += "\n[per-file-ignores]\n";
  for (const FileIgnore& ignore : settings.fileIgnores())
    text += fmt::format("{} = {}\n", tomlText(ignore.pattern), listTextOfConfig(ignore.codes));
  if (!settings.propertyFiles().empty())
    text += fmt::format("\n[properties]\nfiles = {}\n", listTextOfConfig(settings.propertyFiles()));
  return text;
}

std::string configJson(const Settings& settings) {
  Json json;
  for (const OptionInfo& info : optionTable()) {
    if (!info.inConfig) continue;
    Json value;
    if (info.arity == Arity::Flag) value = settings.flag(info.id);
    if (info.arity == Arity::One && !settings.text(info.id).empty()) value = settings.text(info.id);
    if (info.arity == Arity::List) value = settings.list(info.id);
    json["options"][std::string(info.name)] = {{"value", value}, {"origin", settings.origin(info.id)}};
  }
  for (const ChoiceInfo& info : choiceTable) {
    json["choices"][std::string(info.key)] = {
        {"value", chosen(info, settings)}, {"origin", settings.choiceOrigin(info.choice)}, {"manual", info.manual}};
  }
  json["rules"] = Json::object();
  for (const auto& [key, value] : settings.ruleSettings()) json["rules"][key] = value;
  for (const auto& [id, severity] : settings.severities()) json["rules"][id + ".severity"] = severityName(severity);
  json["inputs"] = settings.inputs();
  json["properties"] = {{"files", settings.propertyFiles()}};
  json["per-file-ignores"] = Json::object();
  for (const FileIgnore& ignore : settings.fileIgnores()) json["per-file-ignores"][ignore.pattern] = ignore.codes;
  return json.dump(2) + "\n";
}

/// JSON schema of rungproof.toml, for editors that complete and check TOML.
std::string configSchema() {
  Json properties;
  for (const OptionInfo& info : optionTable()) {
    if (!info.inConfig) continue;
    Json value = {{"type", info.arity == Arity::Flag ? "boolean" : "string"}};
    if (const auto words = permittedWords(info.value); !words.empty()) value = {{"enum", words}};
    if (info.arity == Arity::List) value = {{"type", Json::array({"array", "string"})}, {"items", value}};
    value["description"] = info.help;
    if (!info.initial.empty()) value["default"] = info.initial;
    properties[std::string(info.name)] = value;
  }
  Json choices;
  for (const ChoiceInfo& info : choiceTable) {
    Json words = Json::array();
    for (const std::string_view word : info.values) {
      if (!word.empty()) words.push_back(word);
    }
    choices[std::string(info.key)] = {
        {"enum", words}, {"default", info.values[0]}, {"description", fmt::format("{} ({})", info.why, info.manual)}};
  }
  Json rules = Json::object();
  for (const Rule* rule : allRules()) {
    for (const RuleOption& option : rule->options) {
      Json& of = rules[std::string(rule->id)];
      of["type"] = "object";
      of["additionalProperties"] = false;
      of["properties"][std::string(option.name)] = {{"type", "integer"},
                                                    {"minimum", option.low},
                                                    {"maximum", option.high},
                                                    {"default", option.initial},
                                                    {"description", option.meaning}};
    }
  }
  const Json texts = {{"type", "array"}, {"items", {{"type", "string"}}}};
  for (const Rule* rule : allRules()) {
    Json& of = rules[std::string(rule->id)];
    of["type"] = "object";
    of["additionalProperties"] = false;
    of["properties"]["severity"] = {{"enum", Json::array({"error", "warning", "note"})}};
  }
  properties["extend"] = {{"type", "string"}, {"description", "configuration file that this one builds on"}};
  properties["inputs"] = texts;
  properties["properties"] = {{"type", "object"}, {"additionalProperties", false}, {"properties", {{"files", texts}}}};
  properties["per-file-ignores"] = {{"type", "object"}, {"additionalProperties", texts}};
  properties["choices"] = {{"type", "object"}, {"additionalProperties", false}, {"properties", choices}};
  properties["rules"] = {{"type", "object"}, {"additionalProperties", false}, {"properties", rules}};
  const Json schema = {{"$schema", "https://json-schema.org/draft/2020-12/schema"},
                       {"title", "rungproof.toml"},
                       {"type", "object"},
                       {"additionalProperties", false},
                       {"properties", properties}};
  return schema.dump(2) + "\n";
}

std::string textIn(const std::string& form, const Settings& settings) {
  if (form == "json") return configJson(settings);
  return form == "schema" ? configSchema() : configText(settings);
}

Action setUpConfig(ArgumentTable& table) {
  auto files = std::make_shared<std::vector<std::string>>();
  table.arguments("FILE", *files, "files whose configuration is wanted; the current folder without", true);
  return [files](Context& context) {
    Exit exit = Exit::Clean;
    for (const OutputRequest& output : context.outputs) {
      if (!context.write(output, textIn(output.name, context.settings))) exit = Exit::Failed;
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
        "rungproof.toml beside FILE or above it, else from the defaults. --format schema prints the JSON\n"
        "schema of the file, for editors.\n",
    .shows = option_group::All,
    .formats = "text|json|schema",
    .setup = setUpConfig,
};

}  // namespace rungproof
