// `rungproof lsp`: the Language Server Protocol 3.17 over two file descriptors. Holds the documents, checks them when
// everything that was typed has arrived, and leads each request to its part (checked_document.hpp lists them). Tested
// by tests/editor over real messages.
#pragma once

#include <map>
#include <memory>
#include <set>
#include <variant>

#include "frontend/command.hpp"
#include "frontend/editor/document.hpp"
#include "frontend/editor/proof.hpp"
#include "frontend/rpc/rpc_server.hpp"

namespace rungproof {

class EditorServer : public RpcServer {
 public:
  EditorServer(const Context& context, int in, int out) : RpcServer(in, out, Framing::Headers), context_(context) {}
  /// The exit code that the protocol asks for: 0 after shutdown, otherwise 1.
  Exit run();

 private:
  using Answer = std::variant<Json, RpcFault>;
  struct Open {
    Document document;
    std::unique_ptr<const CheckedDocument> checked;  ///< null: stale
    bool isPublished = false;                        ///< the diagnostics are those of `checked`
    ProofVerdicts verdicts;
  };
  struct Request {
    std::string_view method;
    Answer (EditorServer::*answer)(const RpcMessage& message);
  };
  struct Notification {
    std::string_view method;
    void (EditorServer::*take)(const Json& params);
  };

  void handle(const RpcMessage& message) override;
  void settle() override;
  std::string_view cancelMethod() const override { return "$/cancelRequest"; }
  std::string_view cancelMember() const override { return "id"; }
  std::optional<RpcFault> cancelAnswer() const override {
    return RpcFault{RpcCode::RequestCancelled, "the request was cancelled"};
  }

  static std::span<const Request> requests();
  static std::span<const Notification> notifications();

  Answer initialize(const RpcMessage& message);
  Answer shutdown(const RpcMessage& message);
  Answer hover(const RpcMessage& message);
  Answer definition(const RpcMessage& message);
  Answer references(const RpcMessage& message);
  Answer documentSymbol(const RpcMessage& message);
  Answer workspaceSymbol(const RpcMessage& message);
  Answer completion(const RpcMessage& message);
  Answer codeAction(const RpcMessage& message);
  Answer codeLens(const RpcMessage& message);
  Answer inlayHint(const RpcMessage& message);
  Answer network(const RpcMessage& message);
  void executeCommand(const RpcMessage& message);
  void startProof(const RpcMessage& message, Open& open, const std::string& name);
  void finishProof(const std::string& uri, const std::string& name, const ProofVerdict& verdict);

  void didOpen(const Json& params);
  void didChange(const Json& params);
  void didSave(const Json& params);
  void didClose(const Json& params);
  void filesChanged(const Json& params);

  Open* openOf(const Json& params);
  Answer pictureAt(Open& open, ClientPlace place, std::string_view form);
  const CheckedDocument& checked(Open& open);
  void publish(Open& open);
  void makeStale(Open& open);
  void makeAllStale();

  const Context& context_;
  std::map<std::string, Open> open_;
  std::string folder_ = ".";
  bool isInitialized_ = false, isShutDown_ = false, refreshesLenses_ = false;
};

}  // namespace rungproof
