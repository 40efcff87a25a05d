// POSIX calls where the standard library has no word for mode, owner and identity of a file.
#include "frontend/files/disk_file.hpp"

#include <fcntl.h>
#include <fmt/core.h>
#include <fnmatch.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <charconv>
#include <csignal>
#include <cstring>
#include <map>
#include <mutex>
#include <set>
#include <utility>

namespace rungproof {

namespace {

namespace fs = std::filesystem;

constexpr int mostLinks = 40;  ///< behind each other, as the system counts them

using Identity = std::pair<dev_t, ino_t>;
Identity identityOf(const struct stat& status) { return {status.st_dev, status.st_ino}; }

/// What this run has read.
class Inputs {
 public:
  void add(const struct stat& status) {
    const std::lock_guard lock(mutex_);
    read_.insert(identityOf(status));
  }
  void add(const std::string& name) {
    const std::lock_guard lock(mutex_);
    names_.insert(name);
  }
  std::vector<std::string> names() {
    const std::lock_guard lock(mutex_);
    return {names_.begin(), names_.end()};
  }
  void clear() {
    const std::lock_guard lock(mutex_);
    read_.clear();
    names_.clear();
  }
  bool contains(const struct stat& status) {
    const std::lock_guard lock(mutex_);
    return read_.contains(identityOf(status));
  }

 private:
  std::mutex mutex_;
  std::set<Identity> read_;
  std::set<std::string> names_;
};

Inputs& inputs() {
  static Inputs all;
  return all;
}

std::map<std::string, HeldText>& heldTexts() {
  static std::map<std::string, HeldText> all;
  return all;
}

/// One file has one key, whatever the spelling of its path.
std::string heldKey(const std::string& name) {
  std::error_code error;
  const fs::path place = fs::weakly_canonical(fs::absolute(name), error);
  return error ? name : place.string();
}

/// What came on standard input and from pipes, once it has been asked for.
std::map<std::string, InputBytes>& givenOnce() {
  static std::map<std::string, InputBytes> all;
  return all;
}

constexpr const char* standardName = "-";

fs::path& confinement() {
  static fs::path folder;
  return folder;
}

std::string tooLong(std::size_t most) { return fmt::format("it has more than {} MiB", most >> 20); }

/// Everything up to the end, or up to one byte too many.
InputBytes bytesFrom(int file, std::size_t most) {
  std::string bytes;
  std::vector<char> piece(std::size_t{1} << 16);
  while (true) {
    const ssize_t count = ::read(file, piece.data(), piece.size());
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) return {std::nullopt, std::strerror(errno)};
    if (count == 0) return {std::move(bytes)};
    if (bytes.size() + static_cast<std::size_t>(count) > most) return {std::nullopt, tooLong(most)};
    bytes.append(piece.data(), static_cast<std::size_t>(count));
  }
}

InputBytes bytesFromDisk(const std::string& name, std::size_t most) {
  const int file = ::open(name.c_str(), O_RDONLY | O_CLOEXEC);
  if (file < 0) return {std::nullopt, std::strerror(errno)};
  struct stat status {};
  InputBytes result;
  if (::fstat(file, &status) != 0)
    result.problem = std::strerror(errno);
  else if (S_ISDIR(status.st_mode))
    result.problem = "it is a folder";
  else if (S_ISREG(status.st_mode) && static_cast<std::size_t>(status.st_size) > most)
    result.problem = tooLong(most);
  else
    result = bytesFrom(file, most);
  ::close(file);
  if (!S_ISREG(status.st_mode) && !S_ISDIR(status.st_mode)) givenOnce()[name] = result;
  return result;
}

/// A name that ends in ".PID.part", without that; and the process.
std::optional<std::pair<std::string_view, pid_t>> splitPart(std::string_view name) {
  constexpr std::string_view ending = ".part";
  if (!name.ends_with(ending)) return std::nullopt;
  name.remove_suffix(ending.size());
  const std::size_t point = name.rfind('.');
  pid_t process = 0;
  if (point == std::string_view::npos) return std::nullopt;
  const auto [end, error] = std::from_chars(name.data() + point + 1, name.data() + name.size(), process);
  if (error != std::errc() || end != name.data() + name.size() || process <= 0) return std::nullopt;
  return std::pair(name.substr(0, point), process);
}

/// Whether the process that wrote it is gone: no process here has its number, and nobody holds the file.
bool isStale(const fs::path& part, pid_t process) {
  if (process == ::getpid() || ::kill(process, 0) == 0 || errno != ESRCH) return false;
  const int file = ::open(part.c_str(), O_RDONLY | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK);
  if (file < 0) return false;
  struct stat status {};
  const bool isOurs = ::fstat(file, &status) == 0 && S_ISREG(status.st_mode) && status.st_uid == ::geteuid();
  const bool isFree = isOurs && ::flock(file, LOCK_EX | LOCK_NB) == 0;
  ::close(file);
  return isFree;
}

Failure failureOf(const std::string& name, const char* reason, std::string help = {}) {
  return {fmt::format("'{}' cannot be written: {}", name, reason), {}, std::move(help)};
}

/// All bytes, also where the system takes them in pieces; errno tells why not.
bool writePiece(int file, std::string_view text) {
  while (!text.empty()) {
    const ssize_t count = ::write(file, text.data(), text.size());
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return false;
    text.remove_prefix(static_cast<std::size_t>(count));
  }
  return true;
}

/// Everything that `text` gives; errno tells why not, 0: it gave up.
bool writeAll(int file, const PiecewiseText& text) {
  bool isTaken = true;
  const bool isWhole = text([&](std::string_view piece) { return isTaken = writePiece(file, piece); });
  if (isTaken && !isWhole) errno = 0;
  return isTaken && isWhole;
}

/// Why writeAll() did not; without a message where the text gave up: whoever gives it knows why.
Failure failureOf(const std::string& name, int reason) {
  return reason == 0 ? Failure{} : failureOf(name, std::strerror(reason));
}

/// Into what stands there, without replacing it. A pipe without a reader is an error, not the end of the program.
std::optional<Failure> writeDirectly(const std::string& name, const PiecewiseText& text, bool isRegular) {
  const int file = ::open(name.c_str(), O_WRONLY | O_CLOEXEC | (isRegular ? O_TRUNC : 0));
  if (file < 0) return failureOf(name, std::strerror(errno));
  const auto before = std::signal(SIGPIPE, SIG_IGN);
  const bool isWritten = writeAll(file, text);
  const int reason = errno;
  std::signal(SIGPIPE, before);
  if (::close(file) == 0 && isWritten) return std::nullopt;
  return failureOf(name, isWritten ? errno : reason);
}

/// Beside the target, then in its place. `old`: what stands there now, or nullptr.
std::optional<Failure> replaceWhole(const std::string& name, const fs::path& target, const PiecewiseText& text,
                                    const struct stat* old) {
  removeStaleParts(target.parent_path(), target.filename().string());
  const std::string part = partOf(target.string());
  const int file = ::open(part.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
  if (file >= 0) static_cast<void>(::flock(file, LOCK_EX | LOCK_NB));  // somebody writes: removeStaleParts() sees it
  if (file < 0) {
    // A folder in which nothing may be made can still hold a file that may be written.
    if (old != nullptr) return writeDirectly(target.string(), text, true);
    return failureOf(name, std::strerror(errno));
  }
  bool isDone = true;
  if (old != nullptr) {
    const bool isOwn = old->st_uid == ::geteuid() && old->st_gid == ::getegid();
    isDone = (isOwn || ::fchown(file, old->st_uid, old->st_gid) == 0) && ::fchmod(file, old->st_mode & 07777U) == 0;
    if (!isDone) {
      ::close(file);
      ::unlink(part.c_str());
      return writeDirectly(target.string(), text, true);
    }
  }
  isDone = writeAll(file, text);
  int reason = isDone ? 0 : errno;
  if (::close(file) != 0 && isDone) {
    isDone = false;
    reason = errno;
  }
  if (isDone && ::rename(part.c_str(), target.c_str()) != 0) {
    isDone = false;
    reason = errno;
  }
  if (isDone) return std::nullopt;
  ::unlink(part.c_str());
  return failureOf(name, reason);
}

}  // namespace

void noteInput(const std::string& name) {
  inputs().add(name);
  struct stat status {};
  if (::stat(name.c_str(), &status) == 0 && S_ISREG(status.st_mode)) inputs().add(status);
}

std::vector<std::string> inputNames() { return inputs().names(); }

const std::string& standardInput() {
  static const std::string nothing;
  if (!givenOnce().contains(standardName)) givenOnce()[standardName] = bytesFrom(STDIN_FILENO, longestInput);
  const InputBytes& given = givenOnce()[standardName];
  return given.bytes ? *given.bytes : nothing;
}

void replaceStandardInput(std::string text) { givenOnce()[standardName] = {std::move(text)}; }

void forgetInputs() {
  inputs().clear();
  givenOnce().clear();
}

void confineInputs(const fs::path& folder) {
  std::error_code error;
  confinement() = folder.empty() ? folder : fs::weakly_canonical(fs::absolute(folder), error);
}

std::optional<std::string> confinedAgainst(const std::string& name) {
  const fs::path& home = confinement();
  if (home.empty()) return std::nullopt;
  std::error_code error;
  const fs::path place = fs::weakly_canonical(fs::absolute(name), error);
  const fs::path inside = place.lexically_relative(home);
  if (!error && !inside.empty() && *inside.begin() != "..") return std::nullopt;
  return fmt::format("it lies outside '{}', the folder that tools may read (--root)", home.string());
}

void removeStaleParts(const fs::path& folder, std::string_view name) {
  std::error_code error;
  const fs::path place = folder.empty() ? fs::path(".") : folder;
  for (fs::directory_iterator entry(place, error), end; !error && entry != end; entry.increment(error)) {
    const std::string part = entry->path().filename().string();
    const auto split = splitPart(part);
    if (split && (name.empty() || split->first == name) && isStale(entry->path(), split->second))
      ::unlink(entry->path().c_str());
  }
}

std::string partOf(const std::string& target) { return target + fmt::format(".{}.part", ::getpid()); }

void holdText(const std::string& name, HeldText text) { heldTexts()[heldKey(name)] = std::move(text); }

void releaseText(const std::string& name) { heldTexts().erase(heldKey(name)); }

bool holdsTexts() { return !heldTexts().empty(); }

const HeldText* heldText(const std::string& name) {
  if (heldTexts().empty()) return nullptr;
  const auto found = heldTexts().find(heldKey(name));
  return found == heldTexts().end() ? nullptr : &found->second;
}

InputBytes inputBytes(const std::string& name, std::size_t most) {
  if (const HeldText* held = heldText(name)) return {held->text};
  if (const auto given = givenOnce().find(name); given != givenOnce().end()) return given->second;
  if (name == standardName) return givenOnce()[name] = bytesFrom(STDIN_FILENO, most);
  if (auto problem = confinedAgainst(name)) return {std::nullopt, *std::move(problem)};
  noteInput(name);
  return bytesFromDisk(name, most);
}

std::optional<std::string> bytesOfInput(const std::string& name) { return inputBytes(name).bytes; }

std::optional<std::string> bytesOfConfiguration(const std::string& name) {
  if (const HeldText* held = heldText(name)) return held->text;
  noteInput(name);
  return bytesFromDisk(name, longestInput).bytes;
}

std::string nameInProject(const std::string& name, const fs::path& root) {
  if (root.empty()) return name;
  std::error_code error;
  const fs::path place = fs::weakly_canonical(name, error), home = fs::weakly_canonical(root, error);
  const fs::path inside = place.lexically_relative(home);
  return error || inside.empty() || *inside.begin() == ".." ? name : inside.generic_string();
}

bool fitsPattern(const std::string& name, const std::string& pattern) {
  return fnmatch((pattern.ends_with('/') ? pattern + "*" : pattern).c_str(), name.c_str(), 0) == 0;
}

std::string pathInProject(const std::string& name, const fs::path& root) {
  std::error_code error;
  return !root.empty() && fs::exists(root / name, error) ? (root / name).string() : name;
}

fs::path behindLinks(const fs::path& name) {
  std::error_code error;
  fs::path place = name;
  for (int i = 0; i < mostLinks; ++i) {
    if (!fs::is_symlink(fs::symlink_status(place, error))) return fs::weakly_canonical(place, error);
    const fs::path next = fs::read_symlink(place, error);
    if (error) return {};
    place = next.is_absolute() ? next : place.parent_path() / next;
  }
  return {};
}

std::optional<Failure> writeOutputFile(const std::string& name, std::string_view text, InputFile input) {
  return writeOutputFile(
      name, [text](const TakePiece& take) { return take(text); }, input);
}

std::optional<Failure> writeOutputFile(const std::string& name, const PiecewiseText& text, InputFile input) {
  struct stat old {};
  if (::stat(name.c_str(), &old) != 0) {
    if (errno != ENOENT) return failureOf(name, std::strerror(errno));
    const fs::path target = behindLinks(name);
    if (target.empty()) return failureOf(name, std::strerror(ELOOP));
    return replaceWhole(name, target, text, nullptr);
  }
  if (S_ISDIR(old.st_mode)) return failureOf(name, "it is a folder", "give the name of a file");
  if (!S_ISREG(old.st_mode)) return writeDirectly(name, text, false);
  if (input == InputFile::Refuse && inputs().contains(old))
    return failureOf(name, "it has been read as input", "give the output another name");
  if ((old.st_mode & 0222U) == 0 || ::access(name.c_str(), W_OK) != 0)
    return failureOf(name, "it is write-protected", "permit writing first, or give the output another name");
  for (const int stream : {STDOUT_FILENO, STDERR_FILENO}) {
    struct stat open {};
    if (::fstat(stream, &open) == 0 && identityOf(open) == identityOf(old))  // /dev/stdout, led into a file
      return writeAll(stream, text) ? std::nullopt : std::optional(failureOf(name, errno));
  }
  if (old.st_nlink > 1) return writeDirectly(name, text, true);  // all its names stay the same file
  const fs::path target = behindLinks(name);
  return target.empty() ? failureOf(name, std::strerror(ELOOP)) : replaceWhole(name, target, text, &old);
}

}  // namespace rungproof
