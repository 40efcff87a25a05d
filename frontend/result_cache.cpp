// Entries are files of their own, named by the hash of the question.
#include "frontend/result_cache.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <new>
#include <ostream>
#include <streambuf>

#include "engine/platform/file.hpp"
#include "engine/platform/names.hpp"
#include "engine/platform/private_folder.hpp"
#include "engine/platform/waitable.hpp"
#include "frontend/files/disk_file.hpp"
#include "frontend/files/part_file.hpp"
#include "frontend/files/sha256.hpp"
#include "frontend/settings/config.hpp"

namespace rungproof {

namespace {

namespace fs = std::filesystem;

constexpr std::string_view entryForm = "rungproof result 1";
constexpr std::string_view absent = "absent";
constexpr std::size_t keyBytes = 32;

std::optional<std::string> bytesOf(const fs::path& name) {
  std::error_code error;
  if (!fs::is_regular_file(name, error)) return std::nullopt;
  std::ifstream stream(name, std::ios::binary);
  std::string bytes{std::istreambuf_iterator<char>(stream), {}};
  return stream.good() || stream.eof() ? std::optional(std::move(bytes)) : std::nullopt;
}

/// Whether the bytes of an input can be looked at again: what came through a pipe is gone.
bool isRepeatable(const std::string& name) {
  std::error_code error;
  const fs::file_status status = fs::status(name, error);
  return !fs::exists(status) || fs::is_regular_file(status) || fs::is_directory(status);
}

/// Why results are not kept in a folder: others could put files into it, or links. Empty: it is this user's, made if it
/// was not there.
std::string folderProblem(const std::string& name) {
  std::error_code error;
  if (fs::path(name).has_parent_path()) fs::create_directories(fs::path(name).parent_path(), error);
  switch (privateFolder(name)) {
    case FolderState::Private: break;
    case FolderState::CannotBeMade: return fmt::format("'{}' cannot be made: {}", name, reasonOf(errno));
    case FolderState::NoFolder: return fmt::format("'{}' is no folder", name);
    case FolderState::OfAnotherUser: return fmt::format("the folder '{}' belongs to another user", name);
    case FolderState::OpenToAll: return fmt::format("everybody may write into the folder '{}'", name);
  }
  return {};
}

/// Into the folder itself, never to where a link in it leads.
void writeEntry(const std::string& file, std::string_view text) {
  removeStaleParts(fs::path(file).parent_path(), {});
  removeFile(partOf(file));  // of a process that had our number and was ended
  PartFile part(file, Readers::OnlyUs);
  if (part.isOpen() && writeBytes(part.descriptor(), text)) part.replaceTarget();
}

/// The bytes of an entry: a file of this user, no link.
std::optional<std::string> entryBytes(const std::string& file) {
  const std::optional<FileStatus> status = entryStatus(file);
  return status && status->isRegular() && status->isOurs ? bytesOf(file) : std::nullopt;
}

/// The key of this user, made when it is first asked for; empty if there is no place for it.
std::string userKey() {
  const fs::path state = stateFolder();
  if (state.empty()) return {};
  const fs::path folder = state / "rungproof";
  const fs::path file = folder / "result-key";
  if (const auto key = bytesOf(file)) return key->size() == keyBytes ? *key : std::string();
  std::error_code error;
  fs::create_directories(folder, error);
  std::string key = randomBytes(keyBytes);
  if (key.empty()) return {};
  {
    PartFile part(file, Readers::OnlyUs);
    if (!part.isOpen()) return {};
    const bool isWritten = writeBytes(part.descriptor(), key);
    if (part.close() && isWritten && nameFile(part.name(), file)) return key;
  }
  const auto other = bytesOf(file);  // of a run at the same time
  return other && other->size() == keyBytes ? *other : std::string();
}

std::string signatureOf(const std::string& key, std::string_view body) {
  return sha256(key + sha256(key + std::string(body)));
}

std::string fingerprint(const std::string& name) {
  const std::optional<std::string> bytes = bytesOf(name);
  return bytes ? sha256(*bytes) : std::string(absent);
}

/// Whether the file may have changed since that moment; times of files come from a clock that ticks every few ms.
bool mayHaveChangedSince(const std::string& name, std::int64_t moment) {
  constexpr std::int64_t tick = 20'000'000;  // ns
  const std::optional<FileStatus> status = fileStatus(name);
  return status && status->changed > moment - tick;
}

/// Names below a folder, and the configuration that counts there: whatever comes or goes is another question.
std::string surroundingsOf(const std::string& given) {
  std::error_code error;
  const fs::path place(given);
  const bool isFolder = fs::is_directory(place, error);
  std::string text = given + '\n' + pathName(findConfig(isFolder ? place : place.parent_path())) + '\n';
  if (!isFolder) return text;
  std::vector<std::string> names;
  for (fs::recursive_directory_iterator entry(place, fs::directory_options::skip_permission_denied, error), end;
       !error && entry != end; entry.increment(error))
    names.push_back(pathName(entry->path()));
  std::ranges::sort(names);
  for (const std::string& name : names) text += name + '\n';
  return text;
}

/// Takes the parts of an entry one after the other.
class EntryParts {
 public:
  explicit EntryParts(std::string_view text) : rest_(text) {}
  bool isWhole() const { return isWhole_; }
  std::string_view line() {
    const std::size_t end = rest_.find('\n');
    if (end == std::string_view::npos) {
      isWhole_ = false;
      return {};
    }
    const std::string_view result = rest_.substr(0, end);
    rest_.remove_prefix(end + 1);
    return result;
  }
  std::size_t number() {
    const std::string_view digits = line();
    std::size_t value = 0;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    if (error != std::errc() || end != digits.data() + digits.size()) isWhole_ = false;
    return value;
  }
  std::string text() {
    const std::size_t length = number();
    if (!isWhole_ || length > rest_.size()) {
      isWhole_ = false;
      return {};
    }
    std::string result(rest_.substr(0, length));
    rest_.remove_prefix(length);
    return result;
  }
  std::string_view rest() const { return rest_; }

 private:
  std::string_view rest_;
  bool isWhole_ = true;
};

/// Gives everything on to a stream and keeps a copy.
class CopyingBuffer final : public std::streambuf {
 public:
  explicit CopyingBuffer(std::ostream& stream) : stream_(stream) {}
  const std::string& copy() const { return copy_; }

 private:
  int overflow(int c) override {
    if (c == traits_type::eof()) return 0;
    const char letter = static_cast<char>(c);
    return xsputn(&letter, 1) == 1 ? c : traits_type::eof();
  }
  std::streamsize xsputn(const char* text, std::streamsize count) override {
    copy_.append(text, static_cast<std::size_t>(count));
    return stream_.write(text, count) ? count : 0;
  }
  int sync() override { return stream_.flush() ? 0 : -1; }

  std::ostream& stream_;
  std::string copy_;
};

void append(std::string& body, std::string_view text) { body += fmt::format("{}\n{}", text.size(), text); }

}  // namespace

ResultCache::ResultCache(std::string folder, std::string question, const std::vector<std::string>& given) {
  if (folder.empty() || holdsTexts()) return;
  const auto now = std::chrono::system_clock::now().time_since_epoch();
  begin_ = std::chrono::duration_cast<std::chrono::nanoseconds>(now).count();
  const std::string build = buildId();
  key_ = userKey();
  std::error_code error;
  const fs::path here = fs::current_path(error);
  if (build.empty() || key_.empty() || error) return;
  question_ = build + '\n' + pathName(here) + '\n' + std::move(question) + '\n';
  for (const std::string& name : given) question_ += surroundingsOf(name);
  problem_ = folderProblem(folder);
  if (problem_.empty()) file_ = pathName(fs::path(folder) / sha256(question_));
}

std::optional<KeptResult> ResultCache::find() const {
  if (file_.empty()) return std::nullopt;
  const std::optional<std::string> entry = entryBytes(file_);
  if (!entry) return std::nullopt;
  EntryParts parts(*entry);
  if (parts.line() != entryForm) return std::nullopt;
  const std::string_view signature = parts.line();
  if (!parts.isWhole() || signature != signatureOf(key_, parts.rest())) return std::nullopt;
  if (parts.text() != question_) return std::nullopt;
  for (std::size_t left = parts.number(); left > 0 && parts.isWhole(); --left) {
    const std::string print(parts.line()), name = parts.text();
    if (print != fingerprint(name)) return std::nullopt;
  }
  KeptResult result;
  result.exit = static_cast<Exit>(parts.number());
  result.out = parts.text();
  result.err = parts.text();
  return parts.isWhole() && parts.rest().empty() ? std::optional(std::move(result)) : std::nullopt;
}

void ResultCache::keep(const KeptResult& result) const {
  if (file_.empty()) return;
  const std::vector<std::string> inputs = inputNames();
  if (!std::ranges::all_of(inputs, isRepeatable)) return;
  if (std::ranges::any_of(inputs, [&](const std::string& name) { return mayHaveChangedSince(name, begin_); })) return;
  std::string body;
  append(body, question_);
  body += fmt::format("{}\n", inputs.size());
  for (const std::string& name : inputs) {
    body += fingerprint(name) + '\n';
    append(body, name);
  }
  body += fmt::format("{}\n", static_cast<int>(result.exit));
  append(body, result.out);
  append(body, result.err);
  // A cache that cannot be written is none: the result has been printed.
  writeEntry(file_, fmt::format("{}\n{}\n{}", entryForm, signatureOf(key_, body), body));
}

std::string withoutProgress(std::string_view text) {
  constexpr std::string_view endOfLine = "\x1B[K";
  std::string result;
  while (true) {
    const std::size_t begin = text.find('\r');
    result += text.substr(0, begin);
    if (begin == std::string_view::npos) return result;
    const std::size_t end = text.find(endOfLine, begin);
    if (end == std::string_view::npos) return result;
    text.remove_prefix(end + endOfLine.size());
  }
}

Exit repeatOrRun(const ResultCache& cache, Context& context, const KeptWork& work) {
  if (const std::optional<KeptResult> kept = cache.find()) {
    context.out << kept->out;
    context.err << kept->err;
    return kept->exit;
  }
  if (!cache.problem().empty()) context.err << fmt::format("rungproof: results are not kept: {}\n", cache.problem());
  CopyingBuffer outCopy(context.out), errCopy(context.err);
  std::ostream out(&outCopy), err(&errCopy);
  Context copied{context.settings, context.in, out, err, context.color, context.progress, context.outputs};
  copied.settingsNear = context.settingsNear;
  copied.readSettings = context.readSettings;
  copied.given = context.given;
  copied.outIsTerminal = context.outIsTerminal;
  bool isFinal = false;
  const Exit exit = work(copied, isFinal);
  context.hasLostOutput = copied.hasLostOutput;
  if ((!out && context.out) || (!err && context.err)) throw std::bad_alloc();  // a copy grew no more, and text is lost
  const bool isDone = exit == Exit::Clean || exit == Exit::Found;
  if (isDone && isFinal && !copied.hasLostOutput) cache.keep({outCopy.copy(), withoutProgress(errCopy.copy()), exit});
  return exit;
}

}  // namespace rungproof
