// Calls of the system, whose errors become those of the C runtime.
#include "engine/platform/file.hpp"

#include <fcntl.h>
#include <io.h>
#include <windows.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

#include "engine/platform/windows/ownership.hpp"

namespace rungproof {

namespace {

namespace fs = std::filesystem;

constexpr DWORD anySharing = FILE_SHARE_READ | FILE_SHARE_WRITE | FILE_SHARE_DELETE;

int errorOf(DWORD error) {
  switch (error) {
    case ERROR_FILE_NOT_FOUND:
    case ERROR_PATH_NOT_FOUND:
    case ERROR_BAD_NETPATH:
    case ERROR_BAD_NET_NAME: return ENOENT;
    case ERROR_ACCESS_DENIED:
    case ERROR_SHARING_VIOLATION:
    case ERROR_LOCK_VIOLATION:
    case ERROR_WRITE_PROTECT: return EACCES;
    case ERROR_FILE_EXISTS:
    case ERROR_ALREADY_EXISTS: return EEXIST;
    case ERROR_DISK_FULL:
    case ERROR_HANDLE_DISK_FULL: return ENOSPC;
    case ERROR_TOO_MANY_OPEN_FILES: return EMFILE;
    case ERROR_FILENAME_EXCED_RANGE: return ENAMETOOLONG;
    case ERROR_NOT_READY: return ENXIO;
    default: return EINVAL;
  }
}

/// A handle, or nullptr with errno.
HANDLE opened(const fs::path& name, DWORD access, DWORD sharing, DWORD what, DWORD flags = 0) {
  const HANDLE handle = ::CreateFileW(name.c_str(), access, sharing, nullptr, what, flags, nullptr);
  if (handle != INVALID_HANDLE_VALUE) return handle;
  errno = errorOf(::GetLastError());
  return nullptr;
}

int descriptorOf(HANDLE handle, int flags) {
  if (handle == nullptr) return -1;
  const int descriptor = ::_open_osfhandle(reinterpret_cast<std::intptr_t>(handle), flags | _O_BINARY | _O_NOINHERIT);
  if (descriptor < 0) ::CloseHandle(handle);
  return descriptor;
}

/// ns since 1970; the system counts 100 ns since 1601.
std::int64_t momentOf(std::int64_t time) { return (time - 116'444'736'000'000'000LL) * 100; }

std::optional<FileStatus> statusOfHandle(HANDLE handle) {
  FileStatus result;
  if (::GetFileType(handle) != FILE_TYPE_DISK) return result;
  BY_HANDLE_FILE_INFORMATION info{};
  if (::GetFileInformationByHandle(handle, &info) == 0) {
    errno = errorOf(::GetLastError());
    return std::nullopt;
  }
  const auto both = [](DWORD high, DWORD low) { return std::uint64_t{high} << 32 | low; };
  const bool isFolder = (info.dwFileAttributes & FILE_ATTRIBUTE_DIRECTORY) != 0;
  result.kind = isFolder ? FileKind::Folder : FileKind::Regular;
  result.identity = {info.dwVolumeSerialNumber, both(info.nFileIndexHigh, info.nFileIndexLow)};
  result.size = both(info.nFileSizeHigh, info.nFileSizeLow);
  result.names = info.nNumberOfLinks;
  result.isWritable = isFolder || (info.dwFileAttributes & FILE_ATTRIBUTE_READONLY) == 0;
  FILE_BASIC_INFO times{};
  const bool hasTimes = ::GetFileInformationByHandleEx(handle, FileBasicInfo, &times, sizeof times) != 0;
  const auto written =
      static_cast<std::int64_t>(both(info.ftLastWriteTime.dwHighDateTime, info.ftLastWriteTime.dwLowDateTime));
  result.changed = momentOf(std::max(hasTimes ? times.ChangeTime.QuadPart : 0, written));
  const Ownership ownership = ownershipOf(handle);
  result.isOurs = ownership.isOurs;
  result.isOpenToAll = ownership.isOpenToAll;
  return result;
}

std::optional<FileStatus> statusNamed(const fs::path& name, DWORD flags) {
  flags |= FILE_FLAG_BACKUP_SEMANTICS;  // folders too
  HANDLE handle = opened(name, FILE_READ_ATTRIBUTES | READ_CONTROL, anySharing, OPEN_EXISTING, flags);
  if (handle == nullptr && errno == EACCES)
    handle = opened(name, FILE_READ_ATTRIBUTES, anySharing, OPEN_EXISTING, flags);
  if (handle == nullptr) return std::nullopt;
  const std::optional<FileStatus> status = statusOfHandle(handle);
  ::CloseHandle(handle);
  return status;
}

}  // namespace

std::optional<FileStatus> fileStatus(const fs::path& name) { return statusNamed(name, 0); }

std::optional<FileStatus> entryStatus(const fs::path& name) {
  const DWORD attributes = ::GetFileAttributesW(name.c_str());
  const bool isLink = attributes != INVALID_FILE_ATTRIBUTES && (attributes & FILE_ATTRIBUTE_REPARSE_POINT) != 0;
  std::optional<FileStatus> status = statusNamed(name, FILE_FLAG_OPEN_REPARSE_POINT);
  if (status && isLink) status->kind = FileKind::Other;
  return status;
}

std::optional<FileStatus> openStatus(int descriptor) {
  const std::intptr_t handle = ::_get_osfhandle(descriptor);
  if (handle == -1) return std::nullopt;
  return statusOfHandle(reinterpret_cast<HANDLE>(handle));
}

bool mayWrite(const fs::path& name) {
  const HANDLE handle = ::CreateFileW(name.c_str(), GENERIC_WRITE, anySharing, nullptr, OPEN_EXISTING, 0, nullptr);
  if (handle == INVALID_HANDLE_VALUE) return ::GetLastError() == ERROR_SHARING_VIOLATION;  // a moment later it may
  ::CloseHandle(handle);
  return true;
}

int openToRead(const fs::path& name) {
  const std::optional<FileStatus> status = fileStatus(name);
  if (status && status->isFolder()) {  // as elsewhere it can be opened, but its status says what it is
    return descriptorOf(opened(name, FILE_READ_ATTRIBUTES, anySharing, OPEN_EXISTING, FILE_FLAG_BACKUP_SEMANTICS),
                        _O_RDONLY);
  }
  return descriptorOf(opened(name, GENERIC_READ, anySharing, OPEN_EXISTING), _O_RDONLY);
}

int openToWrite(const fs::path& name, Emptied emptied) {
  const DWORD what = emptied == Emptied::Yes ? TRUNCATE_EXISTING : OPEN_EXISTING;
  return descriptorOf(opened(name, GENERIC_WRITE, anySharing, what), _O_WRONLY);
}

int openNew(const fs::path& name, Readers /*readers*/) {
  // Who may read it follows from its folder. Nobody else can open it to write: isLeft() sees that.
  return descriptorOf(opened(name, GENERIC_WRITE, FILE_SHARE_READ, CREATE_NEW), _O_WRONLY);
}

std::int64_t readBytes(int descriptor, char* to, std::size_t most) {
  constexpr std::size_t longest = std::size_t{1} << 30;
  return ::_read(descriptor, to, static_cast<unsigned>(std::min(most, longest)));
}

bool closeFile(int descriptor) { return ::_close(descriptor) == 0; }

bool makeLike(int /*descriptor*/, const FileStatus& /*old*/) { return true; }  // its folder says who may do what

bool replaceFile(const fs::path& from, const fs::path& to) {
  // Scanners and indexers hold a new file for a moment.
  constexpr int attempts = 20;
  constexpr DWORD pause = 25;  // ms
  for (int i = 0; i < attempts; ++i) {
    if (::MoveFileExW(from.c_str(), to.c_str(), MOVEFILE_REPLACE_EXISTING) != 0) return true;
    const DWORD error = ::GetLastError();
    errno = errorOf(error);
    if (error != ERROR_SHARING_VIOLATION && error != ERROR_ACCESS_DENIED) return false;
    ::Sleep(pause);
  }
  return false;
}

bool nameFile(const fs::path& from, const fs::path& to) {
  if (::MoveFileExW(from.c_str(), to.c_str(), 0) != 0) return true;
  errno = errorOf(::GetLastError());
  return false;
}

void removeFile(const fs::path& name) { ::DeleteFileW(name.c_str()); }

std::int64_t processNumber() { return ::GetCurrentProcessId(); }

bool isProcessGone(std::int64_t process) {
  if (process == processNumber()) return false;
  const HANDLE handle = ::OpenProcess(SYNCHRONIZE, FALSE, static_cast<DWORD>(process));
  if (handle == nullptr) return ::GetLastError() == ERROR_INVALID_PARAMETER;
  const bool hasEnded = ::WaitForSingleObject(handle, 0) == WAIT_OBJECT_0;
  ::CloseHandle(handle);
  return hasEnded;
}

bool isLeft(const fs::path& name) {
  const std::optional<FileStatus> status = entryStatus(name);
  if (!status || !status->isRegular() || !status->isOurs) return false;
  const HANDLE handle = opened(name, GENERIC_READ | GENERIC_WRITE, 0, OPEN_EXISTING);
  if (handle == nullptr) return false;
  ::CloseHandle(handle);
  return true;
}

std::string reasonOf(int error) { return std::strerror(error); }

}  // namespace rungproof
