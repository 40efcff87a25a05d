// Reads and writes through platform/file.hpp.
#include "frontend/files/disk_file.hpp"

#include <fmt/core.h>

#include <cerrno>
#include <charconv>
#include <map>
#include <mutex>
#include <set>
#include <utility>

#include "engine/platform/console.hpp"
#include "engine/platform/file.hpp"
#include "engine/platform/names.hpp"
#include "engine/platform/waitable.hpp"
#include "frontend/files/held_state.hpp"
#include "frontend/files/part_file.hpp"

namespace rungproof {

namespace {

namespace fs = std::filesystem;

constexpr int mostLinks = 40;  ///< behind each other, as the system counts them

/// What this run has read.
class Inputs {
 public:
  void add(const FileStatus& status) {
    const std::lock_guard lock(mutex_);
    read_.insert(status.identity);
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
  bool contains(const FileStatus& status) {
    const std::lock_guard lock(mutex_);
    return read_.contains(status.identity);
  }

 private:
  std::mutex mutex_;
  std::set<decltype(FileStatus::identity)> read_;
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
  return error ? name : pathName(place);
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
    const std::int64_t count = readBytes(file, piece.data(), piece.size());
    if (count < 0) return {std::nullopt, reasonOf(errno)};
    if (count == 0) return {std::move(bytes)};
    if (bytes.size() + static_cast<std::size_t>(count) > most) return {std::nullopt, tooLong(most)};
    bytes.append(piece.data(), static_cast<std::size_t>(count));
  }
}

InputBytes bytesFromDisk(const std::string& name, std::size_t most) {
  const int file = openToRead(name);
  if (file < 0) return {std::nullopt, reasonOf(errno)};
  const std::optional<FileStatus> status = openStatus(file);
  InputBytes result;
  if (!status)
    result.problem = reasonOf(errno);
  else if (status->isFolder())
    result.problem = "it is a folder";
  else if (status->isRegular() && status->size > most)
    result.problem = tooLong(most);
  else
    result = bytesFrom(file, most);
  closeFile(file);
  if (!status || status->kind == FileKind::Other) givenOnce()[name] = result;
  return result;
}

/// A name that ends in ".PID.part", without that; and the process.
std::optional<std::pair<std::string_view, std::int64_t>> splitPart(std::string_view name) {
  constexpr std::string_view ending = ".part";
  if (!name.ends_with(ending)) return std::nullopt;
  name.remove_suffix(ending.size());
  const std::size_t point = name.rfind('.');
  std::int32_t process = 0;
  if (point == std::string_view::npos) return std::nullopt;
  const auto [end, error] = std::from_chars(name.data() + point + 1, name.data() + name.size(), process);
  if (error != std::errc() || end != name.data() + name.size() || process <= 0) return std::nullopt;
  return std::pair(name.substr(0, point), std::int64_t{process});
}

/// Whether the process that wrote it is gone: no process here has its number, and nobody holds the file.
bool isStale(const fs::path& part, std::int64_t process) { return isProcessGone(process) && isLeft(part); }

Failure failureOf(const std::string& name, const std::string& reason, std::string help = {}) {
  return {fmt::format("'{}' cannot be written: {}", name, reason), {}, std::move(help)};
}

/// Everything that `text` gives; errno tells why not, 0: it gave up.
bool writeAll(int file, const PiecewiseText& text) {
  bool isTaken = true;
  const bool isWhole = text([&](std::string_view piece) { return isTaken = writeBytes(file, piece); });
  if (isTaken && !isWhole) errno = 0;
  return isTaken && isWhole;
}

/// Why writeAll() did not; without a message where the text gave up: whoever gives it knows why.
Failure failureOf(const std::string& name, int reason) {
  return reason == 0 ? Failure{} : failureOf(name, reasonOf(reason));
}

/// Into what stands there, without replacing it. A pipe without a reader is an error, not the end of the program.
std::optional<Failure> writeDirectly(const std::string& name, const PiecewiseText& text) {
  const int file = openToWrite(name, Emptied::No);
  if (file < 0) return failureOf(name, reasonOf(errno));
  const OutlivedReaders guard;
  const bool isWritten = writeAll(file, text);
  const int reason = errno;
  if (closeFile(file) && isWritten) return std::nullopt;
  return failureOf(name, isWritten ? errno : reason);
}

/// Gives a file its bytes anew; errno tells why not.
bool fill(const std::string& name, const PiecewiseText& text) {
  const int file = openToWrite(name, Emptied::Yes);
  if (file < 0) return false;
  const bool isWritten = writeAll(file, text);
  const int reason = errno;
  const bool isClosed = closeFile(file);
  if (!isWritten) errno = reason;
  return isClosed && isWritten;
}

/// Into a regular file that must stay the same file. What cannot be written whole is taken back.
std::optional<Failure> writeInto(const std::string& name, const PiecewiseText& text) {
  const InputBytes old = bytesFromDisk(name, longestInput);
  if (fill(name, text)) return std::nullopt;
  const int reason = errno;
  const bool isRestored = old.bytes && fill(name, [&](const TakePiece& take) { return take(*old.bytes); });
  Failure failure = failureOf(name, reason);
  if (!isRestored && !failure.message.empty()) failure.help = "what stood in it is lost";
  return failure;
}

/// Whether nothing may be made in the folder.
bool isForbidden(int reason) { return reason == EACCES || reason == EPERM || reason == EROFS; }

/// Beside the target, then in its place. `old`: what stands there now, or nullptr.
std::optional<Failure> replaceWhole(const std::string& name, const fs::path& target, const PiecewiseText& text,
                                    const FileStatus* old) {
  removeStaleParts(target.parent_path(), pathName(target.filename()));
  {
    PartFile part(target, Readers::Usual);
    if (!part.isOpen() && (old == nullptr || !isForbidden(errno))) return failureOf(name, reasonOf(errno));
    if (part.isOpen() && (old == nullptr || makeLike(part.descriptor(), *old))) {
      if (writeAll(part.descriptor(), text) && part.replaceTarget()) return std::nullopt;
      return failureOf(name, errno);
    }
  }
  return writeInto(pathName(target), text);  // it may be written, and not be replaced by one like it
}

}  // namespace

void noteInput(const std::string& name) {
  inputs().add(name);
  const std::optional<FileStatus> status = fileStatus(name);
  if (status && status->isRegular()) inputs().add(*status);
}

std::vector<std::string> inputNames() { return inputs().names(); }

const std::string& standardInput() {
  static const std::string nothing;
  if (!givenOnce().contains(standardName))
    givenOnce()[standardName] = bytesFrom(static_cast<int>(Stream::In), longestInput);
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

const fs::path& inputsConfinedTo() { return confinement(); }

std::optional<std::string> confinedAgainst(const std::string& name) {
  const fs::path& home = confinement();
  if (home.empty()) return std::nullopt;
  std::error_code error;
  const fs::path place = fs::weakly_canonical(fs::absolute(name), error);
  const fs::path inside = place.lexically_relative(home);
  if (!error && !inside.empty() && *inside.begin() != "..") return std::nullopt;
  return fmt::format("it lies outside '{}', the folder that tools may read (--root)", pathName(home));
}

void removeStaleParts(const fs::path& folder, std::string_view name) {
  std::error_code error;
  const fs::path place = folder.empty() ? fs::path(".") : folder;
  for (fs::directory_iterator entry(place, error), end; !error && entry != end; entry.increment(error)) {
    const std::string part = pathName(entry->path().filename());
    const auto split = splitPart(part);
    if (split && (name.empty() || split->first == name) && isStale(entry->path(), split->second))
      removeFile(entry->path());
  }
}

void holdText(const std::string& name, HeldText text) { heldTexts()[heldKey(name)] = std::move(text); }

void releaseText(const std::string& name) { heldTexts().erase(heldKey(name)); }

bool holdsTexts() { return !heldTexts().empty(); }

const std::map<std::string, HeldText>& allHeldTexts() { return heldTexts(); }

const HeldText* heldText(const std::string& name) {
  if (heldTexts().empty()) return nullptr;
  const auto found = heldTexts().find(heldKey(name));
  return found == heldTexts().end() ? nullptr : &found->second;
}

InputBytes inputBytes(const std::string& name, std::size_t most) {
  if (const HeldText* held = heldText(name)) return {held->text};
  if (const auto given = givenOnce().find(name); given != givenOnce().end()) return given->second;
  if (name == standardName) return givenOnce()[name] = bytesFrom(static_cast<int>(Stream::In), most);
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
  if (root.empty()) return plainName(name);
  std::error_code error;
  const fs::path place = fs::weakly_canonical(name, error), home = fs::weakly_canonical(root, error);
  const fs::path inside = place.lexically_relative(home);
  return error || inside.empty() || *inside.begin() == ".." ? plainName(name) : inside.generic_string();
}

bool fitsPattern(const std::string& name, const std::string& pattern) {
  return fitsShellPattern(name, pattern.ends_with('/') ? pattern + "*" : pattern);
}

std::string pathInProject(const std::string& name, const fs::path& root) {
  std::error_code error;
  return !root.empty() && fs::exists(root / name, error) ? pathName(root / name) : name;
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
  const std::optional<FileStatus> old = fileStatus(name);
  if (!old) {
    if (errno != ENOENT) return failureOf(name, reasonOf(errno));
    const fs::path target = behindLinks(name);
    if (target.empty()) return failureOf(name, reasonOf(ELOOP));
    return replaceWhole(name, target, text, nullptr);
  }
  if (old->isFolder()) return failureOf(name, "it is a folder", "give the name of a file");
  if (!old->isRegular()) return writeDirectly(name, text);
  if (input == InputFile::Refuse && inputs().contains(*old))
    return failureOf(name, "it has been read as input", "give the output another name");
  if (!old->isWritable || !mayWrite(name))
    return failureOf(name, "it is write-protected", "permit writing first, or give the output another name");
  for (const int stream : {static_cast<int>(Stream::Out), static_cast<int>(Stream::Err)}) {
    const std::optional<FileStatus> open = openStatus(stream);
    if (open && open->identity == old->identity)  // /dev/stdout, led into a file
      return writeAll(stream, text) ? std::nullopt : std::optional(failureOf(name, errno));
  }
  if (old->names > 1) return writeInto(name, text);  // all its names stay the same file
  const fs::path target = behindLinks(name);
  return target.empty() ? failureOf(name, reasonOf(ELOOP)) : replaceWhole(name, target, text, &*old);
}

}  // namespace rungproof
