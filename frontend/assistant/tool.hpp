// The tools that `rungproof mcp` offers to an assistant: each is one command of the program, with a program given as
// text or as a path. One row of the table says all about a tool: its schema, its arguments and its command come from
// it. Tested by tests/assistant/tool_test.cpp.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "frontend/files/json.hpp"
#include "frontend/rpc/background_job.hpp"

namespace rungproof {

enum class ParameterKind : std::uint8_t { Text, Number, Truth };

/// What a parameter becomes on the command line.
enum class ParameterUse : std::uint8_t {
  Path,      ///< the program's file or folder
  Program,   ///< the program's text
  Option,    ///< --name=VALUE, or --name alone if true
  HeldFile,  ///< --name=FILE, where the value is the text of the file
  Argument   ///< stands behind the program
};

struct ToolParameter {
  std::string_view name;
  ParameterKind kind;
  ParameterUse use;
  std::string_view option;  ///< with its dashes; for a held file the name of the file behind '='
  std::string_view description;
  std::string_view values = {};  ///< "a|b": nothing else is permitted
};

struct Tool {
  std::string_view name;  ///< also of the command
  std::string_view title;
  std::string_view description;
  std::string_view textFormat;  ///< form of the text that people and assistants read
  std::string_view jsonFormat;  ///< form of the structured content; empty: it has none
  std::span<const ToolParameter> parameters;
  bool needsProgram = true;
};

std::span<const Tool> allTools();
const Tool* toolNamed(std::string_view name);
/// As tools/list has it.
Json toolJson(const Tool& tool);

/// The result of tools/call: content, structuredContent, isError.
Json errorResult(std::string_view message);

/// A call as a background job, which gives the result as text. Or the result itself, if the arguments are wrong.
/// `given`: options of the server's command line.
std::variant<Json, JobRequest> callOf(const Tool& tool, const Json& arguments, const std::vector<std::string>& given);
/// Makes such a call.
extern const Worker toolWorker;

}  // namespace rungproof
