// A child process and the pipe from it.
#include "frontend/rpc/background_job.hpp"

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <string_view>

namespace rungproof {

namespace {

/// The child's part: standard input and output belong to the server, so neither is touched.
[[noreturn]] void workAndEnd(const std::function<std::string()>& work, int pipe) {
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  const int nothing = ::open("/dev/null", O_RDWR | O_CLOEXEC);
  ::dup2(nothing, STDIN_FILENO);
  ::dup2(nothing, STDOUT_FILENO);
  const std::string text = work();
  std::string_view rest = text;
  while (!rest.empty()) {
    const ssize_t count = ::write(pipe, rest.data(), rest.size());
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) ::_exit(1);
    rest.remove_prefix(static_cast<std::size_t>(count));
  }
  ::_exit(0);
}

}  // namespace

BackgroundJob::BackgroundJob(const std::function<std::string()>& work) {
  std::array<int, 2> ends{};
  if (::pipe2(ends.data(), O_CLOEXEC) != 0) return;
  child_ = ::fork();
  if (child_ == 0) {
    ::close(ends[0]);
    workAndEnd(work, ends[1]);
  }
  ::close(ends[1]);
  if (child_ < 0) {
    ::close(ends[0]);
    return;
  }
  descriptor_ = ends[0];
}

BackgroundJob::~BackgroundJob() {
  if (descriptor_ >= 0) ::close(descriptor_);
  if (child_ <= 0) return;
  ::kill(child_, SIGKILL);
  ::waitpid(child_, nullptr, 0);
}

bool BackgroundJob::take() {
  std::array<char, 65536> piece{};
  const ssize_t count = ::read(descriptor_, piece.data(), piece.size());
  if (count < 0 && errno == EINTR) return false;
  if (count > 0) {
    text_.append(piece.data(), static_cast<std::size_t>(count));
    return false;
  }
  int status = 0;
  ::waitpid(child_, &status, 0);
  child_ = -1;
  hasEndedWell_ = WIFEXITED(status) && WEXITSTATUS(status) == 0;
  return true;
}

}  // namespace rungproof
