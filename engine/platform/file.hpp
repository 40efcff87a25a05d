// Files where the standard library has no word for it: identity, owner and mode, whole replacement, a part that is held
// by its writer. Calls say why they failed in errno. Names are UTF-8. Tested by tests/platform.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>

namespace rungproof {

enum class FileKind : std::uint8_t { Regular, Folder, Other };

struct FileStatus {
  FileKind kind = FileKind::Other;
  std::pair<std::uint64_t, std::uint64_t> identity{};  ///< equal for two names of one file
  std::uint64_t size = 0;
  std::uint64_t names = 1;   ///< of this file: hard links
  std::int64_t changed = 0;  ///< when its bytes, mode or name last changed; ns since 1970
  bool isWritable = true;    ///< its mode lets somebody write
  bool isOurs = true;        ///< it belongs to the user of this process
  bool isOpenToAll = false;  ///< everybody may write
  std::uint32_t mode = 0;    ///< permissions, owner and group, for a file that takes its place
  std::uint32_t owner = 0, group = 0;

  bool isRegular() const { return kind == FileKind::Regular; }
  bool isFolder() const { return kind == FileKind::Folder; }
};
/// Of what a name leads to behind all links.
std::optional<FileStatus> fileStatus(const std::filesystem::path& name);
/// Of the entry itself, which may be a link.
std::optional<FileStatus> entryStatus(const std::filesystem::path& name);
std::optional<FileStatus> openStatus(int descriptor);
/// Whether this process may write it.
bool mayWrite(const std::filesystem::path& name);

// Descriptors of open files; negative: it could not be opened. Bytes are read and written as they are.
enum class Emptied : bool { No, Yes };
int openToRead(const std::filesystem::path& name);
int openToWrite(const std::filesystem::path& name, Emptied emptied);
/// A new file, which is held while it is open: isHeld(). Nothing may stand under that name.
enum class Readers : bool { Usual, OnlyUs };
int openNew(const std::filesystem::path& name, Readers readers);
/// At most so many bytes; 0: the end, negative: an error.
std::int64_t readBytes(int descriptor, char* to, std::size_t most);
bool closeFile(int descriptor);
/// Gives a new file owner, group and permissions of an old one.
bool makeLike(int descriptor, const FileStatus& old);

/// Puts one file in place of another, at once.
bool replaceFile(const std::filesystem::path& from, const std::filesystem::path& to);
/// Gives a file its name if nothing stands there; the old name may stay.
bool nameFile(const std::filesystem::path& from, const std::filesystem::path& to);
void removeFile(const std::filesystem::path& name);

std::int64_t processNumber();
/// Whether no process of this machine has that number.
bool isProcessGone(std::int64_t process);
/// Whether a regular file of this user is not held by whoever made it; false if that cannot be told.
bool isLeft(const std::filesystem::path& name);

/// std::strerror() for errno.
std::string reasonOf(int error);

}  // namespace rungproof
