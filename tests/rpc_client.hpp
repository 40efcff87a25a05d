// The other end of a server that speaks JSON-RPC: starts the executable under test as a child process, sends real
// messages through a pipe and reads what comes back. Nothing waits longer than `patience`.
#pragma once

#include <fcntl.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <deque>
#include <string>
#include <vector>

#include "frontend/files/json.hpp"
#include "frontend/rpc/message_stream.hpp"

namespace rungproof::test {

/// The member at "result/items/0/label"; null if there is none.
inline Json at(const Json& json, const std::string& path) {
  const Json* here = &json;
  for (std::size_t begin = 0; begin <= path.size();) {
    const std::size_t end = std::min(path.find('/', begin), path.size());
    const std::string key = path.substr(begin, end - begin);
    if (here->kind() == Json::Kind::Array) {
      const std::size_t index = std::stoul(key);
      if (index >= here->size()) return nullptr;
      here = &here->items()[index];
    } else {
      here = here->find(key);
      if (here == nullptr) return nullptr;
    }
    begin = end + 1;
  }
  return *here;
}
inline std::string textAt(const Json& json, const std::string& path) { return at(json, path).text(); }
/// A number as JSON writes it.
inline std::string numberAt(const Json& json, const std::string& path) { return at(json, path).dump(); }

class RpcClient {
 public:
  static constexpr int patience = 60000;  ///< ms

  RpcClient(Framing framing, const std::vector<std::string>& arguments, const std::string& folder = {})
      : framing_(framing), stream_(framing) {
    int in[2], out[2];
    if (::pipe2(in, O_CLOEXEC) != 0 || ::pipe2(out, O_CLOEXEC) != 0) std::abort();
    std::signal(SIGPIPE, SIG_IGN);
    child_ = ::fork();
    if (child_ == 0) {
      ::dup2(in[0], STDIN_FILENO);
      ::dup2(out[1], STDOUT_FILENO);
      if (!folder.empty() && ::chdir(folder.c_str()) != 0) ::_exit(126);
      std::vector<char*> argv = {const_cast<char*>("rungproof")};
      for (const std::string& argument : arguments) argv.push_back(const_cast<char*>(argument.c_str()));
      argv.push_back(nullptr);
      ::execv(RUNGPROOF_BINARY_DIR "/rungproof", argv.data());
      ::_exit(127);
    }
    ::close(in[0]);
    ::close(out[1]);
    to_ = in[1];
    from_ = out[0];
  }
  ~RpcClient() { end(); }
  RpcClient(const RpcClient&) = delete;
  RpcClient& operator=(const RpcClient&) = delete;

  void sendBytes(const std::string& bytes) {
    for (std::size_t done = 0; done < bytes.size();) {
      const ssize_t count = ::write(to_, bytes.data() + done, bytes.size() - done);
      if (count <= 0) return;
      done += static_cast<std::size_t>(count);
    }
  }
  void send(const Json& message) { sendBytes(framed(framing_, message.dump())); }
  void notify(const std::string& method, Json params) {
    send({{"jsonrpc", "2.0"}, {"method", method}, {"params", std::move(params)}});
  }
  int begin(const std::string& method, Json params) {
    send({{"jsonrpc", "2.0"}, {"id", ++id_}, {"method", method}, {"params", std::move(params)}});
    return id_;
  }
  /// The answer to a request; what comes before it is kept for notification().
  Json request(const std::string& method, Json params) { return answer(begin(method, std::move(params))); }
  Json answer(int id) {
    while (true) {
      Json message = receive();
      if (message.kind() == Json::Kind::Null) return message;
      if (at(message, "id").dump() == std::to_string(id) && at(message, "method").text().empty()) return message;
      kept_.push_back(std::move(message));
    }
  }
  /// The next message of that method, kept or still to come.
  Json notification(const std::string& method) {
    for (std::size_t i = 0; i < kept_.size(); ++i) {
      if (textAt(kept_[i], "method") != method) continue;
      Json message = kept_[i];
      kept_.erase(kept_.begin() + static_cast<std::ptrdiff_t>(i));
      return message;
    }
    while (true) {
      Json message = receive();
      if (message.kind() == Json::Kind::Null || textAt(message, "method") == method) return message;
      kept_.push_back(std::move(message));
    }
  }
  /// The next message; null, and a failed test, if none comes.
  Json receive() {
    while (true) {
      if (const std::optional<RawMessage> raw = stream_.next()) {
        EXPECT_EQ(raw->fault, "");
        const std::optional<Json> json = Json::read(raw->body);
        EXPECT_TRUE(json.has_value()) << raw->body;
        return json.value_or(nullptr);
      }
      pollfd watched{from_, POLLIN, 0};
      char piece[65536];
      const ssize_t count = ::poll(&watched, 1, patience) > 0 ? ::read(from_, piece, sizeof piece) : 0;
      if (count <= 0) {
        ADD_FAILURE() << "the server says nothing more";
        return nullptr;
      }
      stream_.append({piece, static_cast<std::size_t>(count)});
    }
  }
  /// Closes the server's input and waits for its end. The exit code, or 128 + signal.
  int end() {
    if (child_ <= 0) return exit_;
    ::close(to_);
    int status = 0;
    for (int waited = 0; ::waitpid(child_, &status, WNOHANG) == 0; waited += 10) {
      if (waited >= patience) ::kill(child_, SIGKILL);
      ::usleep(10000);
    }
    ::close(from_);
    child_ = -1;
    exit_ = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    return exit_;
  }

 private:
  Framing framing_;
  MessageStream stream_;
  pid_t child_ = -1;
  int to_ = -1, from_ = -1, id_ = 0, exit_ = -1;
  std::deque<Json> kept_;
};

}  // namespace rungproof::test
