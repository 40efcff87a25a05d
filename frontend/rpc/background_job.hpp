// Work beside the server, in a child process: it sees the texts that the server holds, may take as long as it likes and
// as much memory as it gets, and ends without a trace when it is cancelled. Tested through tests/editor/proof_test.cpp.
#pragma once

#include <sys/types.h>

#include <functional>
#include <optional>
#include <string>

namespace rungproof {

class BackgroundJob {
 public:
  /// Runs `work` in a child of this process, which must have no other thread.
  explicit BackgroundJob(const std::function<std::string()>& work);
  ~BackgroundJob();
  BackgroundJob(const BackgroundJob&) = delete;
  BackgroundJob& operator=(const BackgroundJob&) = delete;

  /// Where its result comes; readable when there is something to take. Negative: it could not be started.
  int descriptor() const { return descriptor_; }
  /// Takes what has come; true: it has ended.
  bool take();
  /// What `work` gave; nothing if it did not come to its end.
  std::optional<std::string> result() const { return hasEndedWell_ ? std::optional(text_) : std::nullopt; }

 private:
  pid_t child_ = -1;
  int descriptor_ = -1;
  std::string text_;
  bool hasEndedWell_ = false;
};

}  // namespace rungproof
