// Indentation, expressions and steps of a composite action.
#include "tests/ci/action_runner.hpp"

#include <fmt/format.h>
#include <sys/wait.h>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <functional>
#include <sstream>
#include <stdexcept>

namespace rungproof::test {

namespace {

namespace fs = std::filesystem;

/// A value of the file: a text, or a map or list of values with their keys ("" in lists).
struct Value {
  std::string text;
  std::vector<std::pair<std::string, Value>> members;

  const Value* find(const std::string& key) const {
    for (const auto& [name, value] : members) {
      if (name == key) return &value;
    }
    return nullptr;
  }
  std::string textOf(const std::string& key) const {
    const Value* const value = find(key);
    return value == nullptr ? std::string() : value->text;
  }
};

std::string stripped(std::string text) {
  const std::size_t first = text.find_first_not_of(' ');
  if (first == std::string::npos) return {};
  text = text.substr(first, text.find_last_not_of(' ') - first + 1);
  const bool isQuoted = text.size() > 1 && (text.front() == '"' || text.front() == '\'') && text.back() == text.front();
  return isQuoted ? text.substr(1, text.size() - 2) : text;
}

class YamlReader {
 public:
  explicit YamlReader(const std::string& yaml) {
    std::istringstream in(yaml);
    for (std::string line; std::getline(in, line);) lines_.push_back(line);
  }
  Value read() { return block(0); }

 private:
  static std::size_t indentOf(const std::string& line) { return std::min(line.find_first_not_of(' '), line.size()); }
  bool isEmpty(std::size_t i) const {
    const std::size_t first = lines_[i].find_first_not_of(' ');
    return first == std::string::npos || lines_[i][first] == '#';
  }
  void skipEmpty() {
    while (at_ < lines_.size() && isEmpty(at_)) ++at_;
  }

  Value block(std::size_t indent) {
    Value value;
    for (skipEmpty(); at_ < lines_.size() && indentOf(lines_[at_]) >= indent; skipEmpty()) {
      if (indentOf(lines_[at_]) > indent) throw std::runtime_error("unexpected indentation: " + lines_[at_]);
      std::string& line = lines_[at_];
      if (line.substr(indent, 2) == "- ") {
        line.replace(indent, 2, "  ");  // the item is a map that begins two further in
        value.members.emplace_back("", block(indent + 2));
        continue;
      }
      const std::size_t colon = line.find(':', indent);
      if (colon == std::string::npos) throw std::runtime_error("no key: " + line);
      const std::string key = line.substr(indent, colon - indent);
      const std::string rest = stripped(line.substr(colon + 1));
      ++at_;
      value.members.emplace_back(key, rest == "|"    ? blockText(indent)
                                      : rest.empty() ? nested(indent)
                                                     : Value{rest, {}});
    }
    return value;
  }
  Value nested(std::size_t indent) {
    skipEmpty();
    if (at_ >= lines_.size() || indentOf(lines_[at_]) <= indent) return {};
    return block(indentOf(lines_[at_]));
  }
  /// The lines that are further in, without their common indentation.
  Value blockText(std::size_t indent) {
    Value value;
    const std::size_t own = at_ < lines_.size() ? indentOf(lines_[at_]) : 0;
    for (; at_ < lines_.size() && (lines_[at_].empty() || indentOf(lines_[at_]) > indent); ++at_)
      value.text += (lines_[at_].empty() ? std::string() : lines_[at_].substr(own)) + "\n";
    return value;
  }

  std::vector<std::string> lines_;
  std::size_t at_ = 0;
};

std::map<std::string, std::string> textsOf(const Value* value) {
  std::map<std::string, std::string> texts;
  if (value == nullptr) return texts;
  for (const auto& [key, member] : value->members) texts[key] = member.text;
  return texts;
}

/// "${{ inputs.files }}" by its value; what is unknown ends the test.
std::string replaced(const std::string& text, const std::map<std::string, std::string>& values) {
  std::string result;
  std::size_t at = 0;
  for (;;) {
    const std::size_t begin = text.find("${{", at);
    if (begin == std::string::npos) return result + text.substr(at);
    const std::size_t end = text.find("}}", begin);
    const std::string name = stripped(text.substr(begin + 3, end - begin - 3));
    const auto value = values.find(name);
    if (value == values.end()) throw std::runtime_error("unknown expression " + name);
    result += text.substr(at, begin - at) + value->second;
    at = end + 2;
  }
}

/// "inputs.upload == 'true' && inputs.sarif != ''"
bool holds(const std::string& condition, const std::map<std::string, std::string>& values) {
  if (condition.empty()) return true;
  std::size_t at = 0;
  while (at < condition.size()) {
    const std::size_t end = std::min(condition.find("&&", at), condition.size());
    const std::string part = condition.substr(at, end - at);
    const bool isEqual = part.find("==") != std::string::npos;
    const std::size_t sign = part.find(isEqual ? "==" : "!=");
    if (sign == std::string::npos) throw std::runtime_error("unknown condition " + part);
    const auto value = values.find(stripped(part.substr(0, sign)));
    if (value == values.end()) throw std::runtime_error("unknown name in " + part);
    if ((value->second == stripped(part.substr(sign + 2))) != isEqual) return false;
    at = end + 2;
  }
  return true;
}

std::string contentOfFile(const fs::path& path) {
  std::ifstream in(path);
  return {std::istreambuf_iterator<char>(in), {}};
}

}  // namespace

Action actionOf(const std::string& yaml) {
  const Value root = YamlReader(yaml).read();
  Action action;
  if (const Value* const inputs = root.find("inputs")) {
    for (const auto& [name, input] : inputs->members) action.defaults[name] = input.textOf("default");
  }
  if (const Value* const outputs = root.find("outputs")) {
    for (const auto& [name, output] : outputs->members) action.outputs[name] = output.textOf("value");
  }
  const Value* const runs = root.find("runs");
  if (runs == nullptr || runs->textOf("using") != "composite" || runs->find("steps") == nullptr)
    throw std::runtime_error("no composite action");
  for (const auto& [key, step] : runs->find("steps")->members)
    action.steps.push_back({step.textOf("name"), step.textOf("id"), step.textOf("uses"), step.textOf("if"),
                            step.textOf("run"), textsOf(step.find("env")), textsOf(step.find("with"))});
  return action;
}

ActionRun runAction(const Action& action, const std::map<std::string, std::string>& inputs,
                    const std::string& actionFolder, const std::string& workspace) {
  std::map<std::string, std::string> values{{"runner.os", "Linux"}, {"runner.arch", "X64"}};
  for (const auto& [name, value] : action.defaults) values["inputs." + name] = value;
  for (const auto& [name, value] : inputs) {
    if (!action.defaults.contains(name)) throw std::runtime_error("the action has no input " + name);
    values["inputs." + name] = value;
  }
  ActionRun result{.exit = 0, .failedStep = {}, .log = {}, .outputs = {}, .used = {}};
  const fs::path scratch = fs::path(workspace) / ".runner";
  fs::create_directories(scratch);
  for (const ActionStep& step : action.steps) {
    if (result.exit != 0 || !holds(step.condition, values)) continue;
    if (!step.uses.empty()) {
      std::string line = step.uses;
      for (const auto& [key, value] : step.with) line += fmt::format(" {}={}", key, replaced(value, values));
      result.used.push_back(line);
      continue;
    }
    const fs::path script = scratch / "step.sh", output = scratch / "output", log = scratch / "log";
    std::ofstream(output).close();
    std::ofstream text(script);
    text << fmt::format("export GITHUB_OUTPUT='{}' GITHUB_ACTION_PATH='{}'\ncd '{}'\n", output.string(), actionFolder,
                        workspace);
    for (const auto& [key, value] : step.environment)
      text << fmt::format("export {}='{}'\n", key, replaced(value, values));
    text << "set -eo pipefail\n" << replaced(step.run, values);
    text.close();
    const int status =
        std::system(fmt::format("bash --noprofile --norc '{}' >'{}' 2>&1", script.string(), log.string()).c_str());
    result.log += contentOfFile(log);
    std::istringstream lines(contentOfFile(output));
    for (std::string line; std::getline(lines, line);) {
      const std::size_t sign = line.find('=');
      if (sign != std::string::npos)
        values[fmt::format("steps.{}.outputs.{}", step.id, line.substr(0, sign))] = line.substr(sign + 1);
    }
    result.exit = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    if (result.exit != 0) result.failedStep = step.name;
  }
  for (const auto& [name, expression] : action.outputs) result.outputs[name] = replaced(expression, values);
  return result;
}

}  // namespace rungproof::test
