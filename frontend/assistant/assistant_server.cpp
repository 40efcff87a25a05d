// Messages of the Model Context Protocol.
#include "frontend/assistant/assistant_server.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "frontend/assistant/tool.hpp"
#include "frontend/cli/cli.hpp"

namespace rungproof {

namespace {

/// Newest first.
constexpr std::array<std::string_view, 2> protocolVersions = {"2025-06-18", "2024-11-05"};

constexpr std::string_view instructions =
    "Oracle for PLC programs: Siemens S7-200, S7-200 SMART and S7-300/400 (STL, SCL, LAD, FBD), IEC 61131-3 (ST, IL, "
    "SFC). lint and check say what is wrong with a program; prove decides a property for "
    "every run or shows a run that breaks it; sim runs it with a stimulus. UNKNOWN, HOLDS TO BOUND and NOT COVERED are "
    "no proofs. structuredContent.exit_code: 0 good, 1 findings or violations, 2 not done, 3 undecided.";

}  // namespace

Exit AssistantServer::run() {
  serve();
  return Exit::Clean;
}

void AssistantServer::handle(const RpcMessage& message) {
  if (!message.isRequest()) return;
  if (message.method == "ping") return reply(*message.id, Json::object());
  if (message.method == "initialize") return initialize(message);
  if (!isInitialized_) return refuse(message.id, RpcCode::NotInitialized, "the first request is 'initialize'");
  if (message.method == "tools/list") return listTools(message);
  if (message.method == "tools/call") return callTool(message);
  refuse(message.id, RpcCode::MethodNotFound, fmt::format("there is no method '{}'", message.method));
}

void AssistantServer::initialize(const RpcMessage& message) {
  const Json* const wanted = message.params.find("protocolVersion");
  if (wanted == nullptr || wanted->kind() != Json::Kind::Text)
    return refuse(message.id, RpcCode::InvalidParams, "'protocolVersion' must be a text");
  isInitialized_ = true;
  const bool isKnown = std::ranges::find(protocolVersions, wanted->text()) != protocolVersions.end();
  reply(*message.id, {{"protocolVersion", isKnown ? std::string_view(wanted->text()) : protocolVersions.front()},
                      {"capabilities", Json{{"tools", Json{{"listChanged", false}}}}},
                      {"serverInfo", Json{{"name", "rungproof"}, {"version", programVersion()}}},
                      {"instructions", instructions}});
}

void AssistantServer::listTools(const RpcMessage& message) {
  Json tools = Json::array();
  for (const Tool& tool : allTools()) tools.push_back(toolJson(tool));
  reply(*message.id, {{"tools", std::move(tools)}});
}

void AssistantServer::callTool(const RpcMessage& message) {
  const Json* const name = message.params.find("name");
  const Tool* const tool = name == nullptr ? nullptr : toolNamed(name->text());
  if (tool == nullptr)
    return refuse(message.id, RpcCode::InvalidParams,
                  fmt::format("there is no tool '{}'", name == nullptr ? std::string() : name->text()));
  const Json* const arguments = message.params.find("arguments");
  const auto call = callOf(*tool, arguments == nullptr ? Json(nullptr) : *arguments, context_.given);
  if (const Json* result = std::get_if<Json>(&call)) return reply(*message.id, *result);
  const Json id = *message.id;
  begin(id, std::get<JobRequest>(call), [this, id](const std::optional<std::string>& text) {
    const std::optional<Json> result = text ? Json::read(*text) : std::nullopt;
    reply(id, result ? *result : errorResult("the run ended before it had a result"));
  });
}

}  // namespace rungproof
