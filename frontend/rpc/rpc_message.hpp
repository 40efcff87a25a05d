// One message of JSON-RPC 2.0, read and written. Tested by tests/editor/rpc_message_test.cpp.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "frontend/files/json.hpp"

namespace rungproof {

/// Codes of errors, of JSON-RPC and of the Language Server Protocol.
enum class RpcCode : int {
  ParseError = -32700,
  InvalidRequest = -32600,
  MethodNotFound = -32601,
  InvalidParams = -32602,
  InternalError = -32603,
  NotInitialized = -32002,
  RequestCancelled = -32800,
  RequestFailed = -32803
};

struct RpcFault {
  RpcCode code;
  std::string message;
};

struct RpcMessage {
  std::optional<Json> id;  ///< of a request; a notification has none
  std::string method;      ///< empty: the answer to a request of ours
  Json params;
  std::optional<RpcFault> fault;  ///< why it is no message; then `id` is what of it could be read

  bool isRequest() const { return id.has_value() && !method.empty(); }
};

/// Deepest nesting of arrays and objects that is read.
inline constexpr int deepestMessage = 100;

RpcMessage readMessage(const std::string& text);

std::string resultText(const Json& id, Json result);
std::string faultText(const std::optional<Json>& id, const RpcFault& fault);
std::string notificationText(std::string_view method, Json params);
std::string requestText(std::uint64_t id, std::string_view method, Json params);

}  // namespace rungproof
