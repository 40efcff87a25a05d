// From the arguments of a call to a command, and from what it prints to a result.
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <optional>

#include "engine/platform/names.hpp"
#include "engine/platform/private_folder.hpp"
#include "frontend/assistant/tool.hpp"
#include "frontend/files/disk_file.hpp"
#include "frontend/rpc/command_output.hpp"
#include "frontend/settings/options.hpp"

namespace rungproof {

namespace {

constexpr std::size_t longestText = 12000;  ///< bytes of an answer: the reader's attention is short
constexpr std::string_view inlineName = "program.awl";

struct NamedText {
  std::string name, text;
};

/// A call taken apart.
struct ToolCall {
  std::vector<std::string> options, behind;
  std::string path;
  std::vector<NamedText> texts;  ///< that stand for files
};

bool hasKind(const Json& value, ParameterKind kind) {
  switch (kind) {
    case ParameterKind::Text: return value.kind() == Json::Kind::Text;
    case ParameterKind::Number: return value.natural().has_value();
    case ParameterKind::Truth: return value.kind() == Json::Kind::Truth;
  }
  return false;
}

std::string_view wordFor(ParameterKind kind) {
  return kind == ParameterKind::Text     ? "a text"
         : kind == ParameterKind::Number ? "a whole number, not negative"
                                         : "true or false";
}

/// Adds one argument, or says why it is none.
std::string addArgument(const ToolParameter& parameter, const Json& value, ToolCall& call) {
  if (!hasKind(value, parameter.kind)) return fmt::format("'{}' must be {}", parameter.name, wordFor(parameter.kind));
  const std::vector<std::string_view> words = permittedWords(parameter.values);
  if (!words.empty() && std::ranges::find(words, value.text()) == words.end())
    return fmt::format("'{}' can be {}", parameter.name, fmt::join(words, ", "));
  switch (parameter.use) {
    case ParameterUse::Path: call.path = value.text(); break;
    case ParameterUse::Program: call.texts.push_back({std::string(inlineName), value.text()}); break;
    case ParameterUse::Argument: call.behind.push_back(value.text()); break;
    case ParameterUse::HeldFile: {
      const std::string_view option = parameter.option;
      call.options.emplace_back(option);
      call.texts.push_back({std::string(option.substr(option.find('=') + 1)), value.text()});
      break;
    }
    case ParameterUse::Option:
      if (parameter.kind == ParameterKind::Truth) {
        if (value.isTrue()) call.options.emplace_back(parameter.option);
      } else {
        const std::string text = parameter.kind == ParameterKind::Number ? value.dump() : value.text();
        call.options.push_back(fmt::format("{}={}", parameter.option, text));
      }
      break;
  }
  return {};
}

std::string readArguments(const Tool& tool, const Json& arguments, ToolCall& call) {
  std::vector<std::string_view> names;
  std::size_t known = 0;
  for (const ToolParameter& parameter : tool.parameters) {
    names.push_back(parameter.name);
    const Json* const value = arguments.find(parameter.name);
    if (value == nullptr) continue;
    ++known;
    if (std::string problem = addArgument(parameter, *value, call); !problem.empty()) return problem;
  }
  if (known < arguments.size()) return fmt::format("'{}' has only the arguments {}", tool.name, fmt::join(names, ", "));
  const bool hasText = arguments.find("program") != nullptr;
  if (tool.needsProgram && hasText == !call.path.empty())
    return hasText ? "give 'program' or 'path', not both"
                   : "give the program as text ('program') or as a file ('path')";
  if (!tool.needsProgram && call.behind.empty()) return "give 'topic'";
  return {};
}

/// A folder for what a command writes beside its text; gone when the object is. Nobody else can reach it: in a common
/// folder a link with the name of the file could lead to any file of the user.
class BesideFolder {
 public:
  BesideFolder() : name_(pathName(temporaryFolder())) {}
  ~BesideFolder() {
    std::error_code error;
    if (isThere()) std::filesystem::remove_all(name_, error);
  }
  BesideFolder(const BesideFolder&) = delete;
  BesideFolder& operator=(const BesideFolder&) = delete;

  bool isThere() const { return !name_.empty(); }
  std::string file(std::string_view name) const { return fmt::format("{}/{}", name_, name); }
  std::string text(std::string_view name) const {
    std::ifstream stream(std::filesystem::path(file(name)), std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
  }

 private:
  std::string name_;
};

std::string shortened(std::string text, bool isStructured) {
  if (text.size() <= longestText) return text;
  text.resize(text.rfind('\n', longestText) + 1);
  return text + (isStructured ? "... cut; the structured content has everything\n"
                              : "... cut; ask for less, such as one network\n");
}

std::string runTool(const Tool& tool, const ToolCall& call, const std::vector<std::string>& given) {
  for (const NamedText& text : call.texts) holdText(text.name, {text.text, TextEncoding::Utf8});
  const BesideFolder beside;
  if (!beside.isThere()) return errorResult("no folder can be made in the folder of temporary files").dump();
  constexpr std::string_view structured = "result.json", trace = "trace.csv";
  std::vector<std::string> arguments = {std::string(tool.name), "--color=never"};
  arguments.insert(arguments.end(), given.begin(), given.end());
  arguments.insert(arguments.end(), call.options.begin(), call.options.end());
  arguments.push_back(fmt::format("--format={}", tool.textFormat));
  if (!tool.jsonFormat.empty())
    arguments.push_back(fmt::format("--format={}={}", tool.jsonFormat, beside.file(structured)));
  if (tool.name == "sim") arguments.push_back("--trace=" + beside.file(trace));
  arguments.emplace_back("--");
  if (tool.needsProgram) arguments.push_back(call.path.empty() ? std::string(inlineName) : call.path);
  arguments.insert(arguments.end(), call.behind.begin(), call.behind.end());
  const CommandOutput output = outputOf(arguments);

  std::optional<Json> json = Json::read(beside.text(structured));
  const std::string rows = beside.text(trace);
  if (json && !rows.empty()) (*json)["trace"] = rows;
  const bool isError = output.exit == 2;
  std::string text = output.out;
  if (!rows.empty()) text += rows;
  if (!output.err.empty()) text = output.err + text;
  Json result{
      {"content", Json::array({Json{{"type", "text"}, {"text", shortened(std::move(text), json.has_value())}}})},
      {"isError", isError}};
  if (json) {
    (*json)["exit_code"] = output.exit;
    result["structuredContent"] = std::move(*json);
  }
  return result.dump();
}

int runAskedTool(const std::string& request, const GiveBytes& give) {
  const std::optional<Json> asked = takeJobRequest(request);
  const Json* const name = asked ? asked->find("tool") : nullptr;
  const Json* const arguments = asked ? asked->find("arguments") : nullptr;
  const Json* const options = asked ? asked->find("given") : nullptr;
  const Tool* const tool = name == nullptr ? nullptr : toolNamed(name->text());
  if (tool == nullptr || arguments == nullptr || options == nullptr) return 1;
  ToolCall call;
  if (!readArguments(*tool, *arguments, call).empty()) return 1;
  std::vector<std::string> given;
  for (const Json& option : options->items()) given.push_back(option.text());
  return give(runTool(*tool, call, given)) ? 0 : 1;
}

}  // namespace

constinit const Worker toolWorker = {"tool", runAskedTool};

Json errorResult(std::string_view message) {
  return {{"content", Json::array({Json{{"type", "text"}, {"text", message}}})}, {"isError", true}};
}

std::variant<Json, JobRequest> callOf(const Tool& tool, const Json& arguments, const std::vector<std::string>& given) {
  ToolCall call;
  if (arguments.kind() != Json::Kind::Object && arguments.kind() != Json::Kind::Null)
    return errorResult("the arguments must be an object");
  if (const std::string problem = readArguments(tool, arguments, call); !problem.empty()) return errorResult(problem);
  if (const auto problem = call.path.empty() ? std::nullopt : confinedAgainst(call.path))
    return errorResult(fmt::format("'{}' is not read: {}", call.path, *problem));
  return JobRequest{&toolWorker, {{"tool", tool.name}, {"arguments", arguments}, {"given", given}}};
}

}  // namespace rungproof
