// `rungproof mcp`: the Model Context Protocol over two file descriptors, one message a line: greeting with the version
// that both know, the list of tools, and their calls. Tested by tests/assistant over real messages.
#pragma once

#include "frontend/command.hpp"
#include "frontend/rpc/rpc_server.hpp"

namespace rungproof {

class AssistantServer : public RpcServer {
 public:
  AssistantServer(const Context& context, int in, int out) : RpcServer(in, out, Framing::Lines), context_(context) {}
  /// Until the client closes the input: that is how it says goodbye.
  Exit run();

 private:
  void handle(const RpcMessage& message) override;
  std::string_view cancelMethod() const override { return "notifications/cancelled"; }
  std::string_view cancelMember() const override { return "requestId"; }

  void initialize(const RpcMessage& message);
  void listTools(const RpcMessage& message);
  void callTool(const RpcMessage& message);

  const Context& context_;
  bool isInitialized_ = false;
};

}  // namespace rungproof
