// A client of `rungproof mcp` that has said hello.
#pragma once

#include "tests/rpc_client.hpp"

namespace rungproof::test {

class AssistantSession : public RpcClient {
 public:
  explicit AssistantSession(const std::vector<std::string>& options = {}, const std::string& folder = {})
      : RpcClient(Framing::Lines, withMcp(options), folder) {
    hello_ = request("initialize", {{"protocolVersion", "2025-06-18"},
                                    {"capabilities", Json::object()},
                                    {"clientInfo", Json{{"name", "test"}, {"version", "1"}}}});
    notify("notifications/initialized", Json::object());
  }
  const Json& hello() const { return hello_; }
  Json call(const std::string& tool, Json arguments) {
    return at(request("tools/call", {{"name", tool}, {"arguments", std::move(arguments)}}), "result");
  }

 private:
  static std::vector<std::string> withMcp(std::vector<std::string> options) {
    options.insert(options.begin(), "mcp");
    return options;
  }
  Json hello_;
};

inline std::string toolText(const Json& result) { return textAt(result, "content/0/text"); }

}  // namespace rungproof::test
