// Runs in child processes; the folders of what they have read are watched.
#include "frontend/watch.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <optional>
#include <ostream>
#include <set>

#include "engine/platform/folder_watch.hpp"
#include "engine/platform/names.hpp"
#include "frontend/files/file_reader.hpp"

namespace rungproof {

namespace {

namespace fs = std::filesystem;

constexpr int quietMs = 50;  ///< editors write in several steps: so long nothing may happen before the next run

class Watcher {
 public:
  Watcher(const WatchedRuns& runs, std::ostream& out, std::ostream& err) : runs_(runs), out_(out), err_(err) {
    for (const std::string& name : runs.given) add(name);
  }

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
    if (isFolder) folders_.insert(pathName(place));
    if (!isFolder) files_.insert(pathName(place));
    changes_.add(isFolder ? pathName(place) : pathName(place.parent_path()));
  }

  void runOnce() {
    if (runs_.clears) out_ << "\x1B[2J\x1B[H";
    out_.flush();
    err_.flush();
    std::string names;
    ChildProcess child(*runs_.worker, runs_.request, ChildKind::Run);
    if (!child.hasBegun()) return;
    const std::array<const Waitable*, 2> waited = {&child.output(), &interrupts_};
    while (true) {
      const std::vector<bool> ready = waitForAny(waited, -1);
      if (ready[1]) child.interrupt(takeInterrupt());
      if (ready[0] && child.output().take(names) == ByteSource::Taken::End) break;
    }
    if (const std::optional<int> exit = child.wait()) exit_ = *exit;
    for (std::size_t begin = 0; begin < names.size();) {
      const std::size_t end = names.find('\n', begin);
      add(names.substr(begin, end - begin));
      begin = end + 1;
    }
  }

  int takeInterrupt() {
    hasEnded_ = true;
    return interrupts_.take();
  }

  void waitForChange() {
    std::string changed;
    const std::array<const Waitable*, 2> waited = {&changes_, &interrupts_};
    while (!hasEnded_) {
      const std::vector<bool> ready = waitForAny(waited, changed.empty() ? -1 : quietMs);
      if (!ready[0] && !ready[1] && !changed.empty()) break;
      if (ready[1]) takeInterrupt();
      if (!ready[0]) continue;
      for (const std::string& name : changes_.take()) {
        if (matters(name)) changed = name;
      }
    }
    if (!hasEnded_) err_ << fmt::format("rungproof: {} has changed\n", changed) << std::flush;
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
  InterruptWatch interrupts_;
  FolderWatch changes_;
  std::set<std::string> files_, folders_;
  int exit_ = static_cast<int>(Exit::Failed);
  bool hasEnded_ = false;
};

}  // namespace

int watchRuns(const WatchedRuns& runs, std::ostream& out, std::ostream& err) { return Watcher(runs, out, err).watch(); }

}  // namespace rungproof
