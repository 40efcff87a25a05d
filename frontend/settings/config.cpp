// Reading of rungproof.toml with toml++. Every unknown key, wrong type and bad value is an error with its place: a
// setting that is silently ignored is worse than none. Tested by tests/golden/config and tests/cli/exit_test.cpp.
#include "frontend/settings/config.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "engine/platform/names.hpp"
#include "frontend/files/closest_word.hpp"
#include "frontend/files/disk_file.hpp"

#define TOML_EXCEPTIONS 0
#include <toml++/toml.h>

namespace rungproof {

namespace {

namespace fs = std::filesystem;

class Reader {
 public:
  Reader(const fs::path& file, std::string name, Settings& settings)
      : folder_(fs::absolute(file).parent_path()), name_(std::move(name)), settings_(settings) {}

  std::optional<Failure> read(const toml::table& root) {
    for (const auto& [key, node] : root) {
      std::optional<Failure> failure;
      if (key == "choices") {
        failure = readChoices(node);
      } else if (key == "rules") {
        failure = readRules(node);
      } else if (key == "per-file-ignores") {
        failure = readFileIgnores(node);
      } else if (key == "properties") {
        failure = readPropertyFiles(node);
      } else if (key == "inputs") {
        failure = readInputs(node);
      } else if (key == "extend") {
        continue;  // read before the rest
      } else {
        failure = readOption(key.str(), key.source(), node);
      }
      if (failure) return failure;
    }
    return std::nullopt;
  }

 private:
  std::string place(const toml::source_region& region) const {
    return fmt::format("{}:{}:{}", name_, region.begin.line, region.begin.column);
  }
  std::string origin(const toml::source_region& region) const { return fmt::format("{}:{}", name_, region.begin.line); }

  Failure at(const toml::source_region& region, Failure failure) const {
    failure.place = place(region);
    return failure;
  }

  std::optional<Failure> readOption(std::string_view key, const toml::source_region& region, const toml::node& node) {
    const OptionInfo* info = optionNamed(key);
    if (info == nullptr || !info->inConfig) return at(region, unknownKey(key, info != nullptr));
    if (info->arity == Arity::Flag) {
      const auto value = node.value_exact<bool>();
      if (!value) return at(node.source(), {fmt::format("'{}' must be true or false", key)});
      settings_.set(info->id, *value ? std::vector<std::string>{"true"} : std::vector<std::string>{}, origin(region));
      return std::nullopt;
    }
    std::vector<std::string> texts;
    if (auto failure = readTexts(*info, node, texts)) return failure;
    for (std::string& text : texts) {
      if (auto failure = checkValue(*info, text)) return at(node.source(), *failure);
      if (info->id == Opt::Cache) {
        if (auto failure = placeInside(text, "the folder", "--cache")) return at(node.source(), *failure);
      } else if (info->value == "FILE" || info->value == "DIR") {
        text = placed(text);
      }
      if (info->id != Opt::Format) continue;
      if (auto failure = placeOutput(text)) return at(node.source(), *failure);
    }
    settings_.set(info->id, texts, origin(region));
    return std::nullopt;
  }

  /// One text or a list of them; of `external` also a table whose keys say who writes.
  std::optional<Failure> readTexts(const OptionInfo& info, const toml::node& node,
                                   std::vector<std::string>& texts) const {
    if (const toml::table* table = node.as_table(); table != nullptr && info.id == Opt::External) {
      for (const auto& [who, ranges] : *table) {
        if (ranges.is_table()) return at(ranges.source(), {fmt::format("'{}' must be a list of ranges", who.str())});
        if (auto failure = readTexts(info, ranges, texts)) return failure;
      }
      return std::nullopt;
    }
    if (const toml::array* array = node.as_array(); array != nullptr && info.arity == Arity::List) {
      for (const toml::node& element : *array) {
        const auto text = textOf(element);
        if (!text) return at(element.source(), {fmt::format("'{}' must be a list of texts", info.name)});
        texts.push_back(*text);
      }
    } else if (const auto text = textOf(node)) {
      texts.push_back(*text);
    } else {
      return at(node.source(), {fmt::format("'{}' must be a text{}", info.name,
                                            info.arity == Arity::List ? " or a list of texts" : "")});
    }
    return std::nullopt;
  }

  /// A configuration comes with a project, and a project must not write elsewhere: what is written is taken from the
  /// configuration's folder and must lie in it, links followed.
  std::optional<Failure> placeInside(std::string& name, std::string_view what, std::string_view option) const {
    std::error_code error;
    const fs::path target = behindLinks(folder_ / name), home = fs::weakly_canonical(folder_, error);
    const auto [end, rest] = std::mismatch(home.begin(), home.end(), target.begin(), target.end());
    if (error || end != home.end() || rest == target.end())
      return Failure{fmt::format("{} '{}' lies outside the folder of this configuration", what, name),
                     {},
                     fmt::format("name one in it, or give {} on the command line", option)};
    const fs::path nearer = fs::proximate(target, error);
    name = pathName(error || nearer.empty() ? target : nearer);
    return std::nullopt;
  }

  /// The file of NAME=FILE.
  std::optional<Failure> placeOutput(std::string& format) const {
    const std::size_t sign = format.find('=');
    if (sign == std::string::npos || sign + 1 == format.size()) return std::nullopt;
    std::string file = format.substr(sign + 1);
    if (auto failure = placeInside(file, "the output file", "--format")) return failure;
    format = format.substr(0, sign + 1) + file;
    return std::nullopt;
  }

  std::optional<Failure> readChoices(const toml::node& node) {
    const toml::table* table = node.as_table();
    if (table == nullptr) return at(node.source(), {"'choices' must be a table"});
    for (const auto& [key, value] : *table) {
      const auto text = textOf(value);
      if (!text) return at(value.source(), {fmt::format("'{}' must be a text", key.str())});
      if (auto failure = settings_.setChoice(key.str(), *text, origin(key.source()))) return at(key.source(), *failure);
    }
    return std::nullopt;
  }

  std::optional<Failure> readRules(const toml::node& node) {
    const toml::table* rules = node.as_table();
    if (rules == nullptr)
      return at(node.source(), {"'rules' must hold one table for each rule, such as [rules.STY002]"});
    for (const auto& [id, value] : *rules) {
      const toml::table* table = value.as_table();
      if (table == nullptr) return at(value.source(), {fmt::format("'rules.{}' must be a table", id.str())});
      for (const auto& [key, number] : *table) {
        if (key == "severity") {
          const auto word = number.value_exact<std::string>();
          if (!word) return at(number.source(), {"'severity' must be a text: error, warning or note"});
          if (auto failure = settings_.setSeverity(id.str(), *word)) return at(number.source(), *failure);
          continue;
        }
        const auto integer = number.value_exact<std::int64_t>();
        if (!integer) return at(number.source(), {fmt::format("'{}' must be a whole number", key.str())});
        if (auto failure = settings_.setRuleOption(id.str(), key.str(), *integer)) return at(key.source(), *failure);
      }
    }
    return std::nullopt;
  }

  std::optional<Failure> readInputs(const toml::node& node) {
    auto names = textsOf(node);
    if (!names) return at(node.source(), {"'inputs' must be a list of files and folders"});
    for (std::string& name : *names) name = placed(name);
    settings_.setInputs(std::move(*names));
    return std::nullopt;
  }

  std::optional<Failure> readFileIgnores(const toml::node& node) {
    const toml::table* table = node.as_table();
    if (table == nullptr)
      return at(node.source(), {"'per-file-ignores' must hold a list of codes for each pattern of names"});
    for (const auto& [pattern, value] : *table) {
      auto codes = textsOf(value);
      if (!codes) return at(value.source(), {fmt::format("'{}' must be a list of codes", pattern.str())});
      if (auto failure = settings_.addFileIgnore({std::string(pattern.str()), std::move(*codes)}))
        return at(value.source(), *failure);
    }
    return std::nullopt;
  }

  std::optional<Failure> readPropertyFiles(const toml::node& node) {
    const toml::table* table = node.as_table();
    if (table == nullptr) return at(node.source(), {"'properties' must be a table", {}, "files = [\"press.prop\"]"});
    for (const auto& [key, value] : *table) {
      const auto files = textsOf(value);
      if (key != "files" || !files)
        return at(value.source(), {fmt::format("'{}' is nothing that [properties] has", key.str()),
                                   {},
                                   "it has files, a list of property files"});
      for (const std::string& file : *files) settings_.addPropertyFile(placed(file));
    }
    return std::nullopt;
  }

  /// A file of the project, by its place from the current folder.
  std::string placed(const std::string& file) const {
    if (fs::path(file).is_absolute()) return file;
    std::error_code error;
    const fs::path nearer = fs::proximate(folder_ / file, error);
    return error || nearer.empty() ? pathName(folder_ / file) : pathName(nearer);
  }

  static std::optional<std::vector<std::string>> textsOf(const toml::node& node) {
    if (const auto text = textOf(node)) return std::vector{*text};
    const toml::array* array = node.as_array();
    if (array == nullptr) return std::nullopt;
    std::vector<std::string> texts;
    for (const toml::node& element : *array) {
      const auto text = textOf(element);
      if (!text) return std::nullopt;
      texts.push_back(*text);
    }
    return texts;
  }

  /// Numbers may be written without quotes: cpu = 224.
  static std::optional<std::string> textOf(const toml::node& node) {
    if (const auto text = node.value_exact<std::string>()) return text;
    if (const auto number = node.value_exact<std::int64_t>()) return std::to_string(*number);
    return std::nullopt;
  }

  static Failure unknownKey(std::string_view key, bool commandLineOnly) {
    if (commandLineOnly) return {fmt::format("'{}' can only be given on the command line", key)};
    std::vector<std::string_view> keys = {"choices", "rules", "extend", "inputs", "per-file-ignores", "properties"};
    for (const OptionInfo& info : optionTable()) {
      if (info.inConfig) keys.push_back(info.name);
    }
    const std::string_view meant = closest(key, keys);
    return {fmt::format("unknown key '{}'", key),
            {},
            meant.empty() ? "'rungproof config' lists the keys" : fmt::format("did you mean '{}'?", meant)};
  }

  const fs::path folder_;
  std::string name_;
  Settings& settings_;
};

}  // namespace

fs::path findConfig(const fs::path& folder) {
  std::error_code error;
  fs::path current = fs::absolute(folder, error).lexically_normal();
  while (!current.empty()) {
    const fs::path candidate = current / "rungproof.toml";
    if (fs::is_regular_file(candidate, error)) return candidate;
    if (current == current.parent_path()) break;
    current = current.parent_path();
  }
  return {};
}

namespace {

constexpr int mostBases = 8;
constexpr std::size_t mostKeyParts = 200;

/// Line of a key with too many parts, 0 if there is none: tables inside each other are freed by recursion.
std::size_t lineOfDeepKey(std::string_view text) {
  std::size_t line = 1, points = 0;
  char quote = '\0';
  bool isComment = false;
  for (const char c : text) {
    if (c == '\n') {
      ++line;
      points = 0;
      quote = '\0';
      isComment = false;
    } else if (isComment || (quote != '\0' && c != quote)) {
      continue;
    } else if (c == '"' || c == '\'') {
      quote = quote == '\0' ? c : '\0';
    } else if (c == '#') {
      isComment = true;
    } else if (c == '.' && ++points > mostKeyParts) {
      return line;
    }
  }
  return 0;
}

/// The configuration that this one builds on, if it names one.
std::optional<Failure> readBase(const toml::table& root, const fs::path& file, const std::string& name,
                                Settings& settings, int depth);

std::optional<Failure> readLayer(const fs::path& file, Settings& settings, int depth) {
  std::error_code error;
  const fs::path nearer = fs::proximate(file, error);
  const std::string name = error || nearer.empty() ? pathName(file) : pathName(nearer);
  // The configuration itself may lie above the folder that tools may read; what it names may not.
  if (auto problem = depth > 0 ? confinedAgainst(pathName(file)) : std::nullopt)
    return Failure{"the configuration file cannot be read: " + *problem, name};
  const std::optional<std::string> text = bytesOfConfiguration(pathName(file));
  if (!text) return Failure{"the configuration file cannot be read", name};
  if (const std::size_t line = lineOfDeepKey(*text); line > 0)
    return Failure{fmt::format("a key has more than {} parts", mostKeyParts), fmt::format("{}:{}", name, line)};
  const toml::parse_result result = toml::parse(*text);
  if (!result) {
    const toml::parse_error& fault = result.error();
    return Failure{std::string(fault.description()),
                   fmt::format("{}:{}:{}", name, fault.source().begin.line, fault.source().begin.column)};
  }
  if (auto failure = readBase(result.table(), file, name, settings, depth)) return failure;
  settings.setRoot(fs::absolute(file, error).parent_path());
  return Reader(file, name, settings).read(result.table());
}

std::optional<Failure> readBase(const toml::table& root, const fs::path& file, const std::string& name,
                                Settings& settings, int depth) {
  const toml::node* node = root.get("extend");
  if (node == nullptr) return std::nullopt;
  const std::string place = fmt::format("{}:{}:{}", name, node->source().begin.line, node->source().begin.column);
  const auto base = node->value_exact<std::string>();
  if (!base) return Failure{"'extend' must be a text: the configuration file that this one builds on", place};
  if (depth >= mostBases) return Failure{"configurations extend each other without end", place};
  return readLayer(fs::absolute(file).parent_path() / *base, settings, depth + 1);
}

}  // namespace

std::optional<Failure> readConfig(const fs::path& file, Settings& settings) { return readLayer(file, settings, 0); }

}  // namespace rungproof
