// The loop of a server.
#include "frontend/rpc/rpc_server.hpp"

#include <vector>

namespace rungproof {

bool RpcServer::serve() {
  outliveReaders();
  while (!isStopped_ && hasReader_) {
    if (waiting_.empty()) {
      settle();
      if (isStopped_ || !hasReader_) break;
      if (waitForInput(-1) && !readMore()) break;
    } else {
      const RpcMessage message = std::move(waiting_.front());
      waiting_.pop_front();
      if (message.fault)
        refuse(message.id, message.fault->code, message.fault->message);
      else if (!message.method.empty())
        handle(message);
      // What has come meanwhile may cancel what waits.
      if (!isStopped_ && waitForInput(0)) readMore();
    }
  }
  running_.clear();
  return isStopped_;
}

/// Waits for input or the end of a job, which is handled at once. True: there is input.
bool RpcServer::waitForInput(int milliseconds) {
  std::vector<const Waitable*> watched = {&in_};
  for (const Running& running : running_) watched.push_back(&running.job->waitable());
  const std::vector<bool> ready = waitForAny(watched, milliseconds);
  std::size_t i = 1;
  std::list<Running> ended;
  for (auto running = running_.begin(); running != running_.end(); ++i) {
    const auto current = running++;
    if (ready[i] && current->job->take()) ended.splice(ended.end(), running_, current);
  }
  for (Running& running : ended) running.done(running.job->result());
  return ready[0];
}

bool RpcServer::readMore() {
  std::string piece;
  const ByteSource::Taken taken = in_.take(piece);
  if (taken == ByteSource::Taken::End) return false;
  stream_.append(piece);
  takeIn();
  return true;
}

void RpcServer::takeIn() {
  while (const std::optional<RawMessage> raw = stream_.next()) {
    RpcMessage message;
    if (raw->fault.empty())
      message = readMessage(raw->body);
    else
      message.fault = RpcFault{RpcCode::ParseError, raw->fault};
    if (!message.fault && message.method == cancelMethod())
      cancel(message);
    else
      waiting_.push_back(std::move(message));
  }
}

void RpcServer::cancel(const RpcMessage& notification) {
  const Json* const id = notification.params.find(cancelMember());
  if (id == nullptr) return;
  const std::string wanted = id->dump();
  const auto isMeant = [&](const std::optional<Json>& other) { return other && other->dump() == wanted; };
  const std::size_t removed =
      std::erase_if(waiting_, [&](const RpcMessage& m) { return m.isRequest() && isMeant(m.id); }) +
      std::erase_if(running_, [&](const Running& running) { return isMeant(running.id); });
  if (removed == 0) return;
  if (const std::optional<RpcFault> answer = cancelAnswer()) send(faultText(*id, *answer));
}

void RpcServer::begin(const Json& id, const JobRequest& work, std::function<void(std::optional<std::string>)> done) {
  auto job = std::make_unique<BackgroundJob>(work);
  if (!job->hasBegun()) return done(std::nullopt);
  running_.push_back({id, std::move(job), std::move(done)});
}

void RpcServer::send(const std::string& body) {
  const std::string text = framed(framing_, body);
  hasReader_ = hasReader_ && writeBytes(out_, text);
}

}  // namespace rungproof
