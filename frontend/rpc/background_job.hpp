// Work beside the server, in a child process: it sees the texts that the server holds, may take as long as it likes and
// as much memory as it gets, and ends without a trace when it is cancelled. Tested through tests/editor/proof_test.cpp.
#pragma once

#include <optional>
#include <string>

#include "engine/platform/child_process.hpp"
#include "frontend/files/json.hpp"

namespace rungproof {

/// A worker, and what it is asked.
struct JobRequest {
  const Worker* worker;
  Json asked;
};
/// Of a worker: the texts that the server holds and the folder that it may read count here too; then what was asked.
/// Nothing if the request is damaged.
std::optional<Json> takeJobRequest(const std::string& request);

class BackgroundJob {
 public:
  /// This process must have no other thread.
  explicit BackgroundJob(const JobRequest& request);

  bool hasBegun() const { return child_.hasBegun(); }
  /// Where its result comes; ready when there is something to take.
  const Waitable& waitable() { return child_.output(); }
  /// Takes what has come; true: it has ended.
  bool take();
  /// What the worker gave; nothing if it did not come to its end.
  std::optional<std::string> result() const { return hasEndedWell_ ? std::optional(text_) : std::nullopt; }

 private:
  ChildProcess child_;
  std::string text_;
  bool hasEndedWell_ = false;
};

}  // namespace rungproof
