// POSIX calls.
#include "engine/platform/file.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>

namespace rungproof {

namespace {

namespace fs = std::filesystem;

FileStatus fileStatusOf(const struct stat& status) {
  FileStatus result;
  result.kind = S_ISREG(status.st_mode)   ? FileKind::Regular
                : S_ISDIR(status.st_mode) ? FileKind::Folder
                                          : FileKind::Other;
  result.identity = {status.st_dev, status.st_ino};
  result.size = static_cast<std::uint64_t>(status.st_size);
  result.names = status.st_nlink;
  result.changed = status.st_ctim.tv_sec * 1'000'000'000LL + status.st_ctim.tv_nsec;
  result.isWritable = (status.st_mode & 0222U) != 0;
  result.isOurs = status.st_uid == ::geteuid();
  result.isOpenToAll = (status.st_mode & S_IWOTH) != 0;
  result.mode = status.st_mode & 07777U;
  result.owner = status.st_uid;
  result.group = status.st_gid;
  return result;
}

}  // namespace

std::optional<FileStatus> fileStatus(const fs::path& name) {
  struct stat status {};
  return ::stat(name.c_str(), &status) == 0 ? std::optional(fileStatusOf(status)) : std::nullopt;
}

std::optional<FileStatus> entryStatus(const fs::path& name) {
  struct stat status {};
  return ::lstat(name.c_str(), &status) == 0 ? std::optional(fileStatusOf(status)) : std::nullopt;
}

std::optional<FileStatus> openStatus(int descriptor) {
  struct stat status {};
  return ::fstat(descriptor, &status) == 0 ? std::optional(fileStatusOf(status)) : std::nullopt;
}

bool mayWrite(const fs::path& name) { return ::access(name.c_str(), W_OK) == 0; }

int openToRead(const fs::path& name) { return ::open(name.c_str(), O_RDONLY | O_CLOEXEC); }

int openToWrite(const fs::path& name, Emptied emptied) {
  return ::open(name.c_str(), O_WRONLY | O_CLOEXEC | (emptied == Emptied::Yes ? O_TRUNC : 0));
}

int openNew(const fs::path& name, Readers readers) {
  const int file =
      ::open(name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, readers == Readers::OnlyUs ? 0600 : 0666);
  if (file >= 0) static_cast<void>(::flock(file, LOCK_EX | LOCK_NB));
  return file;
}

std::int64_t readBytes(int descriptor, char* to, std::size_t most) {
  while (true) {
    const ssize_t count = ::read(descriptor, to, most);
    if (count >= 0 || errno != EINTR) return count;
  }
}

bool closeFile(int descriptor) { return ::close(descriptor) == 0; }

bool makeLike(int descriptor, const FileStatus& old) {
  const bool isOwn = old.owner == ::geteuid() && old.group == ::getegid();
  return (isOwn || ::fchown(descriptor, old.owner, old.group) == 0) && ::fchmod(descriptor, old.mode) == 0;
}

bool replaceFile(const fs::path& from, const fs::path& to) { return ::rename(from.c_str(), to.c_str()) == 0; }

bool nameFile(const fs::path& from, const fs::path& to) { return ::link(from.c_str(), to.c_str()) == 0; }

void removeFile(const fs::path& name) { ::unlink(name.c_str()); }

std::int64_t processNumber() { return ::getpid(); }

bool isProcessGone(std::int64_t process) {
  return process != ::getpid() && ::kill(static_cast<pid_t>(process), 0) != 0 && errno == ESRCH;
}

bool isLeft(const fs::path& name) {
  const int file = ::open(name.c_str(), O_RDONLY | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK);
  if (file < 0) return false;
  const std::optional<FileStatus> status = openStatus(file);
  const bool isFree = status && status->isRegular() && status->isOurs && ::flock(file, LOCK_EX | LOCK_NB) == 0;
  ::close(file);
  return isFree;
}

std::string reasonOf(int error) { return std::strerror(error); }

}  // namespace rungproof
