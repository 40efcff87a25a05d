// A copy of this process by fork(), and the pipe from it.
#include "engine/platform/child_process.hpp"

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <exception>

#include "engine/platform/posix/held_signals.hpp"

namespace rungproof {

namespace {

constexpr int brokenOff = 1;  ///< exit code of a worker that threw or whose parent does not listen

/// The address sanitizer reserves more memory than any limit allows.
#ifdef __SANITIZE_ADDRESS__
constexpr bool reservesMuch = true;
#else
constexpr bool reservesMuch = false;
#endif

void settleIn(ChildKind kind, std::uint64_t memory) {
  if (memory > 0 && !reservesMuch) {
    const rlimit limit{memory, memory};
    ::setrlimit(RLIMIT_DATA, &limit);
  }
  switch (kind) {
    case ChildKind::Check: std::signal(SIGINT, SIG_IGN); break;  // the parent decides what an interruption means
    case ChildKind::Job: {
      ::prctl(PR_SET_PDEATHSIG, SIGKILL);
      const int nothing = ::open("/dev/null", O_RDWR | O_CLOEXEC);
      ::dup2(nothing, STDIN_FILENO);
      ::dup2(nothing, STDOUT_FILENO);
      break;
    }
    case ChildKind::Run:
      ::prctl(PR_SET_PDEATHSIG, SIGTERM);
      ::setpgid(0, 0);  // Ctrl-C comes through the parent, once
      releaseHeldSignals();
      break;
  }
}

/// The child's whole life.
[[noreturn]] void workAndEnd(const Worker& worker, const std::string& request, int pipe) {
  int exit = brokenOff;
  std::set_terminate([] { ::_exit(brokenOff); });
  try {
    exit = worker.work(request, [pipe](std::string_view bytes) { return writeBytes(pipe, bytes); });
  } catch (...) {
    exit = brokenOff;
  }
  ::_exit(exit);
}

}  // namespace

ChildProcess::ChildProcess(const Worker& worker, const std::string& request, ChildKind kind, std::uint64_t memory) {
  std::array<int, 2> ends{};
  if (::pipe2(ends.data(), O_CLOEXEC) != 0) return;
  const pid_t child = ::fork();
  if (child == 0) {
    ::close(ends[0]);
    settleIn(kind, memory);
    workAndEnd(worker, request, ends[1]);
  }
  ::close(ends[1]);
  if (child < 0) {
    ::close(ends[0]);
    return;
  }
  process_ = child;
  output_ = std::make_unique<ByteSource>(ends[0], ByteSource::Closing::Yes);
}

ChildProcess::~ChildProcess() {
  output_.reset();
  if (process_ <= 0) return;
  ::kill(static_cast<pid_t>(process_), SIGKILL);
  ::waitpid(static_cast<pid_t>(process_), nullptr, 0);
}

std::optional<int> ChildProcess::wait() {
  if (process_ <= 0) return std::nullopt;
  int status = 0;
  pid_t ended = 0;
  do ended = ::waitpid(static_cast<pid_t>(process_), &status, 0);
  while (ended < 0 && errno == EINTR);
  process_ = -1;
  return ended > 0 && WIFEXITED(status) ? std::optional<int>(WEXITSTATUS(status)) : std::nullopt;
}

void ChildProcess::interrupt(int which) {
  if (process_ > 0) ::kill(static_cast<pid_t>(process_), which);
}

std::optional<int> workerExit(const std::vector<std::string>& /*arguments*/,
                              std::span<const Worker* const> /*workers*/) {
  return std::nullopt;  // a copy of a process needs no start
}

}  // namespace rungproof
