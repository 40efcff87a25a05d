// inotify on folders, and signals as a file.
#include "engine/platform/folder_watch.hpp"

#include <sys/inotify.h>
#include <sys/signalfd.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <filesystem>
#include <map>
#include <optional>

#include "engine/platform/posix/held_signals.hpp"

namespace rungproof {

namespace {

constexpr std::uint32_t changes = IN_CLOSE_WRITE | IN_MOVED_TO | IN_MOVED_FROM | IN_DELETE;

/// The mask before the one watch that lives.
std::optional<sigset_t>& maskBefore() {
  static std::optional<sigset_t> mask;
  return mask;
}

}  // namespace

struct FolderWatch::State {
  std::map<int, std::string> folders;  ///< by watch
};

FolderWatch::FolderWatch() : state_(std::make_shared<State>()) { handle_ = ::inotify_init1(IN_CLOEXEC | IN_NONBLOCK); }

FolderWatch::~FolderWatch() { ::close(static_cast<int>(handle_)); }

void FolderWatch::add(const std::string& folder) {
  const int watch = ::inotify_add_watch(static_cast<int>(handle_), folder.c_str(), changes);
  if (watch >= 0) state_->folders[watch] = folder;
}

std::vector<std::string> FolderWatch::take() {
  std::vector<std::string> changed;
  alignas(inotify_event) std::array<char, 8192> events{};
  const ssize_t count = ::read(static_cast<int>(handle_), events.data(), events.size());
  for (ssize_t at = 0; at < count;) {
    const auto* const event = reinterpret_cast<const inotify_event*>(events.data() + at);
    at += static_cast<ssize_t>(sizeof(inotify_event)) + event->len;
    const auto folder = state_->folders.find(event->wd);
    if (event->len == 0 || folder == state_->folders.end()) continue;
    changed.push_back((std::filesystem::path(folder->second) / event->name).string());
  }
  return changed;
}

InterruptWatch::InterruptWatch() {
  sigset_t ends;
  ::sigemptyset(&ends);
  ::sigaddset(&ends, SIGINT);
  ::sigaddset(&ends, SIGTERM);
  ::sigprocmask(SIG_BLOCK, &ends, &maskBefore().emplace());
  handle_ = ::signalfd(-1, &ends, SFD_CLOEXEC);
}

InterruptWatch::~InterruptWatch() {
  ::close(static_cast<int>(handle_));
  releaseHeldSignals();
  maskBefore().reset();
}

int InterruptWatch::take() {
  signalfd_siginfo info{};
  const bool isWhole = ::read(static_cast<int>(handle_), &info, sizeof info) == sizeof info;
  return isWhole ? static_cast<int>(info.ssi_signo) : SIGTERM;
}

void releaseHeldSignals() {
  if (maskBefore()) ::sigprocmask(SIG_SETMASK, &*maskBefore(), nullptr);
}

}  // namespace rungproof
