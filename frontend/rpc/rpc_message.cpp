// Messages of JSON-RPC 2.0.
#include "frontend/rpc/rpc_message.hpp"

#include <fmt/format.h>

namespace rungproof {

namespace {

/// Whether brackets outside of texts nest deeper than a message may.
bool isTooDeep(std::string_view text) {
  int depth = 0;
  bool isQuoted = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (isQuoted && c == '\\') {
      ++i;
    } else if (c == '"') {
      isQuoted = !isQuoted;
    } else if (!isQuoted && (c == '[' || c == '{')) {
      if (++depth > deepestMessage) return true;
    } else if (!isQuoted && (c == ']' || c == '}')) {
      --depth;
    }
  }
  return false;
}

bool mayBeId(const Json& json) {
  return json.kind() == Json::Kind::Text || json.kind() == Json::Kind::Natural || json.kind() == Json::Kind::Whole;
}

RpcMessage faultyMessage(RpcCode code, std::string message, std::optional<Json> id = {}) {
  RpcMessage result;
  result.id = std::move(id);
  result.fault = RpcFault{code, std::move(message)};
  return result;
}

}  // namespace

RpcMessage readMessage(const std::string& text) {
  if (isTooDeep(text)) return faultyMessage(RpcCode::ParseError, "the message is nested too deeply");
  const std::optional<Json> json = Json::read(text);
  if (!json) return faultyMessage(RpcCode::ParseError, "the message is not JSON");
  if (json->kind() != Json::Kind::Object) return faultyMessage(RpcCode::InvalidRequest, "a message is one object");
  RpcMessage message;
  const Json* const id = json->find("id");
  if (id != nullptr && !mayBeId(*id) && json->find("method") != nullptr)
    return faultyMessage(RpcCode::InvalidRequest, "an id is a number or a text");
  if (id != nullptr && mayBeId(*id)) message.id = *id;
  const Json* const version = json->find("jsonrpc");
  if (version == nullptr || version->text() != "2.0")
    return faultyMessage(RpcCode::InvalidRequest, "'jsonrpc' must be \"2.0\"", message.id);
  const Json* const method = json->find("method");
  if (method == nullptr && (json->find("result") != nullptr || json->find("error") != nullptr)) return message;
  if (method == nullptr || method->text().empty())
    return faultyMessage(RpcCode::InvalidRequest, "'method' must be a text", message.id);
  message.method = method->text();
  if (const Json* const params = json->find("params")) message.params = *params;
  if (message.params.kind() != Json::Kind::Object && message.params.kind() != Json::Kind::Array &&
      message.params.kind() != Json::Kind::Null)
    return faultyMessage(RpcCode::InvalidRequest, "'params' must be an object", message.id);
  return message;
}

std::string resultText(const Json& id, Json result) {
  return Json{{"jsonrpc", "2.0"}, {"id", id}, {"result", std::move(result)}}.dump();
}

std::string faultText(const std::optional<Json>& id, const RpcFault& fault) {
  return Json{{"jsonrpc", "2.0"},
              {"id", id.value_or(nullptr)},
              {"error", Json{{"code", static_cast<int>(fault.code)}, {"message", fault.message}}}}
      .dump();
}

std::string notificationText(std::string_view method, Json params) {
  return Json{{"jsonrpc", "2.0"}, {"method", method}, {"params", std::move(params)}}.dump();
}

std::string requestText(std::uint64_t id, std::string_view method, Json params) {
  Json json{{"jsonrpc", "2.0"}, {"id", id}, {"method", method}};
  if (params.kind() != Json::Kind::Null) json["params"] = std::move(params);
  return json.dump();
}

}  // namespace rungproof
