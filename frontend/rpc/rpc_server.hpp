// The loop of a server that speaks JSON-RPC over two file descriptors: reads what has come, hands on message by
// message, answers what is no message, and waits for background jobs at the same time. What a message means is for the
// class that derives from it: frontend/editor (Language Server Protocol) and frontend/assistant (Model Context
// Protocol). Tested by tests/editor/protocol_test.cpp and tests/assistant.
#pragma once

#include <deque>
#include <functional>
#include <list>
#include <memory>

#include "frontend/rpc/background_job.hpp"
#include "frontend/rpc/message_stream.hpp"
#include "frontend/rpc/rpc_message.hpp"

namespace rungproof {

class RpcServer {
 public:
  RpcServer(int in, int out, Framing framing) : in_(in), out_(out), framing_(framing), stream_(framing) {}
  virtual ~RpcServer() = default;
  RpcServer(const RpcServer&) = delete;
  RpcServer& operator=(const RpcServer&) = delete;

  /// Until stop(), the end of the input, or an output that nobody reads. False: nobody has called stop().
  bool serve();

 protected:
  /// A request, which must be answered, or a notification.
  virtual void handle(const RpcMessage& message) = 0;
  /// Everything that has come so far has been handled.
  virtual void settle() {}
  /// Name of the notification that cancels a request, and of the member of its parameters with the id.
  virtual std::string_view cancelMethod() const = 0;
  virtual std::string_view cancelMember() const = 0;
  /// How a cancelled request is answered; nothing: not at all.
  virtual std::optional<RpcFault> cancelAnswer() const { return std::nullopt; }

  void reply(const Json& id, Json result) { send(resultText(id, std::move(result))); }
  void refuse(const std::optional<Json>& id, RpcCode code, std::string message) {
    send(faultText(id, {code, std::move(message)}));
  }
  void notify(std::string_view method, Json params) { send(notificationText(method, std::move(params))); }
  void ask(std::string_view method, Json params) { send(requestText(++asked_, method, std::move(params))); }
  /// Works in a child process, then `done` here with its result. `id`: of the request that it answers.
  void begin(const Json& id, const JobRequest& work, std::function<void(std::optional<std::string>)> done);
  void stop() { isStopped_ = true; }

 private:
  struct Running {
    Json id;
    std::unique_ptr<BackgroundJob> job;
    std::function<void(std::optional<std::string>)> done;
  };
  void send(const std::string& body);
  bool readMore();
  void takeIn();
  void cancel(const RpcMessage& notification);
  bool waitForInput(int milliseconds);

  ByteSource in_;
  int out_;
  Framing framing_;
  MessageStream stream_;
  std::deque<RpcMessage> waiting_;
  std::list<Running> running_;
  std::uint64_t asked_ = 0;
  bool isStopped_ = false;
  bool hasReader_ = true;
};

}  // namespace rungproof
