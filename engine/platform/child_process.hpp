// A process beside this one that does one piece of work: it may take as long as it likes and as much memory as it gets,
// and ends without a trace. Where the system can, it is a copy of this process; elsewhere it is this program, started
// again, which gets the request through a pipe. So the request holds all that the work needs. Tested by tests/platform.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "engine/platform/waitable.hpp"

namespace rungproof {

/// Sends bytes to the parent; false: it no longer listens.
using GiveBytes = std::function<bool(std::string_view)>;

struct Worker {
  std::string_view name;  ///< differs from those of all others
  /// Its exit code, from 0 to 255.
  int (*work)(const std::string& request, const GiveBytes& give);
};

enum class ChildKind : std::uint8_t {
  Check,  ///< it leaves Ctrl-C to its parent
  Job,    ///< standard input and output are its parent's: it reads and writes nothing there; it ends with its parent
  Run     ///< it prints where its parent prints; Ctrl-C reaches it through interrupt() alone
};

class ChildProcess {
 public:
  /// `memory`: bytes that it may take, 0 for no limit. A Job and a Run are begun by a process with one thread.
  ChildProcess(const Worker& worker, const std::string& request, ChildKind kind, std::uint64_t memory = 0);
  /// Ends it, if it has not ended.
  ~ChildProcess();
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;

  bool hasBegun() const { return output_ != nullptr; }
  /// What it gives, up to its end.
  ByteSource& output() { return *output_; }
  /// Waits for its end. Its exit code; nothing if it was ended from outside.
  std::optional<int> wait();
  /// Hands on an interrupt that InterruptWatch has given.
  void interrupt(int which);

 private:
  std::intptr_t process_ = -1;
  std::intptr_t fate_ = -1;  ///< where the system binds the child's end to ours by an object
  std::unique_ptr<ByteSource> output_;
};

/// Of main(): the exit code of this process if it was started as a worker.
std::optional<int> workerExit(const std::vector<std::string>& arguments, std::span<const Worker* const> workers);

}  // namespace rungproof
