// Runs in child processes, inotify on the folders of what they have read, signals as a file.
#include "frontend/watch.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <sys/inotify.h>
#include <sys/prctl.h>
#include <sys/signalfd.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <filesystem>
#include <map>
#include <optional>
#include <ostream>
#include <set>

#include "frontend/files/disk_file.hpp"
#include "frontend/files/file_reader.hpp"

namespace rungproof {

namespace {

namespace fs = std::filesystem;

constexpr int quietMs = 50;  ///< editors write in several steps: so long nothing may happen before the next run
constexpr std::uint32_t changes = IN_CLOSE_WRITE | IN_MOVED_TO | IN_MOVED_FROM | IN_DELETE;

class Watcher {
 public:
  Watcher(const WatchedRuns& runs, std::ostream& out, std::ostream& err) : runs_(runs), out_(out), err_(err) {
    sigset_t ends;
    ::sigemptyset(&ends);
    ::sigaddset(&ends, SIGINT);
    ::sigaddset(&ends, SIGTERM);
    ::sigprocmask(SIG_BLOCK, &ends, &before_);
    signals_ = ::signalfd(-1, &ends, SFD_CLOEXEC);
    inotify_ = ::inotify_init1(IN_CLOEXEC | IN_NONBLOCK);
    for (const std::string& name : runs.given) add(name);
  }
  ~Watcher() {
    ::close(signals_);
    ::close(inotify_);
    ::sigprocmask(SIG_SETMASK, &before_, nullptr);
  }
  Watcher(const Watcher&) = delete;
  Watcher& operator=(const Watcher&) = delete;

  int watch() {
    while (!hasEnded_) {
      runOnce();
      if (hasEnded_) break;
      err_ << fmt::format("rungproof: watching {} file{}; Ctrl-C ends\n", files_.size(), files_.size() == 1 ? "" : "s")
           << std::flush;
      waitForChange();
    }
    return exit_;
  }

 private:
  /// A file, by its folder, because editors put a new file in its place; a folder for what appears in it.
  void add(const std::string& name) {
    std::error_code error;
    const fs::path place = fs::absolute(name, error).lexically_normal();
    const bool isFolder = fs::is_directory(place, error);
    if (isFolder) folders_.insert(place.string());
    if (!isFolder) files_.insert(place.string());
    const std::string folder = isFolder ? place.string() : place.parent_path().string();
    const int watch = ::inotify_add_watch(inotify_, folder.c_str(), changes);
    if (watch >= 0) watched_[watch] = folder;
  }

  /// The child's part: what it has read goes into the pipe.
  [[noreturn]] void work(int pipe) {
    ::prctl(PR_SET_PDEATHSIG, SIGTERM);
    ::setpgid(0, 0);  // Ctrl-C comes through the parent, once
    ::sigprocmask(SIG_SETMASK, &before_, nullptr);
    const int exit = runs_.run();
    out_.flush();
    err_.flush();
    std::string names;
    for (const std::string& name : inputNames()) names += name + '\n';
    for (std::size_t done = 0; done < names.size();) {
      const ssize_t count = ::write(pipe, names.data() + done, names.size() - done);
      if (count <= 0) break;
      done += static_cast<std::size_t>(count);
    }
    ::_exit(exit);
  }

  void runOnce() {
    if (runs_.clears) out_ << "\x1B[2J\x1B[H";
    out_.flush();
    err_.flush();
    std::array<int, 2> ends{};
    if (::pipe2(ends.data(), O_CLOEXEC) != 0) return;
    const pid_t child = ::fork();
    if (child == 0) {
      ::close(ends[0]);
      work(ends[1]);
    }
    ::close(ends[1]);
    std::string names;
    while (true) {
      std::array<pollfd, 2> watched = {{{ends[0], POLLIN, 0}, {signals_, POLLIN, 0}}};
      if (::poll(watched.data(), watched.size(), -1) < 0 && errno != EINTR) break;
      if (watched[1].revents != 0) ::kill(child, takeSignal());
      if (watched[0].revents == 0) continue;
      std::array<char, 4096> piece{};
      const ssize_t count = ::read(ends[0], piece.data(), piece.size());
      if (count <= 0) break;
      names.append(piece.data(), static_cast<std::size_t>(count));
    }
    ::close(ends[0]);
    int status = 0;
    ::waitpid(child, &status, 0);
    if (WIFEXITED(status)) exit_ = WEXITSTATUS(status);
    for (std::size_t begin = 0; begin < names.size();) {
      const std::size_t end = names.find('\n', begin);
      add(names.substr(begin, end - begin));
      begin = end + 1;
    }
  }

  int takeSignal() {
    signalfd_siginfo info{};
    if (::read(signals_, &info, sizeof info) != sizeof info) return SIGTERM;
    hasEnded_ = true;
    return static_cast<int>(info.ssi_signo);
  }

  void waitForChange() {
    std::string changed;
    while (!hasEnded_) {
      std::array<pollfd, 2> watched = {{{inotify_, POLLIN, 0}, {signals_, POLLIN, 0}}};
      const int count = ::poll(watched.data(), watched.size(), changed.empty() ? -1 : quietMs);
      if (count == 0) break;
      if (watched[1].revents != 0) takeSignal();
      if (watched[0].revents != 0) takeEvents(changed);
    }
    if (!hasEnded_) err_ << fmt::format("rungproof: {} has changed\n", changed) << std::flush;
  }

  void takeEvents(std::string& changed) {
    alignas(inotify_event) std::array<char, 8192> events{};
    const ssize_t count = ::read(inotify_, events.data(), events.size());
    for (ssize_t at = 0; at < count;) {
      const auto* const event = reinterpret_cast<const inotify_event*>(events.data() + at);
      at += static_cast<ssize_t>(sizeof(inotify_event)) + event->len;
      const auto folder = watched_.find(event->wd);
      if (event->len == 0 || folder == watched_.end()) continue;
      const std::string name = (fs::path(folder->second) / event->name).string();
      if (matters(name)) changed = name;
    }
  }

  /// What was read, a configuration that has come, and programs in a folder that was given.
  bool matters(const std::string& name) const {
    if (files_.contains(name) || fs::path(name).filename() == "rungproof.toml") return true;
    return endsInAny(name, {".awl", ".stl", ".xml"}) && std::ranges::any_of(folders_, [&](const std::string& folder) {
             return name.starts_with(folder.ends_with('/') ? folder : folder + "/");
           });
  }

  const WatchedRuns& runs_;
  std::ostream &out_, &err_;
  sigset_t before_{};
  int signals_ = -1, inotify_ = -1;
  std::map<int, std::string> watched_;
  std::set<std::string> files_, folders_;
  int exit_ = static_cast<int>(Exit::Failed);
  bool hasEnded_ = false;
};

}  // namespace

int watchRuns(const WatchedRuns& runs, std::ostream& out, std::ostream& err) { return Watcher(runs, out, err).watch(); }

}  // namespace rungproof
