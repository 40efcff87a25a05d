// Folders below the user's profile, which nobody else may enter.
#include "engine/platform/private_folder.hpp"

#include <fmt/format.h>
#include <windows.h>
// behind windows.h
#include <bcrypt.h>

#include <cerrno>
#include <cwchar>

#include "engine/platform/file.hpp"

namespace rungproof {

namespace fs = std::filesystem;

FolderState privateFolder(const fs::path& name) {
  if (::CreateDirectoryW(name.c_str(), nullptr) == 0) {
    const DWORD error = ::GetLastError();
    if (error != ERROR_ALREADY_EXISTS) {
      errno = error == ERROR_ACCESS_DENIED ? EACCES : ENOENT;
      return FolderState::CannotBeMade;
    }
  }
  const std::optional<FileStatus> status = fileStatus(name);  // of a new one as well: its folder says who may write
  if (!status || !status->isFolder()) return FolderState::NoFolder;
  if (!status->isOurs) return FolderState::OfAnotherUser;
  return status->isOpenToAll ? FolderState::OpenToAll : FolderState::Private;
}

fs::path stateFolder() {
  const wchar_t* const local = ::_wgetenv(L"LOCALAPPDATA");
  return local == nullptr || *local == L'\0' ? fs::path() : fs::path(local);
}

fs::path temporaryFolder() {
  constexpr int attempts = 8;
  std::error_code error;
  const fs::path common = fs::temp_directory_path(error);
  for (int i = 0; i < attempts && !error; ++i) {
    std::string name = "rungproof-";
    for (const char c : randomBytes(8)) name += fmt::format("{:02x}", static_cast<unsigned char>(c));
    if (::CreateDirectoryW((common / name).c_str(), nullptr) != 0) return common / name;
  }
  return {};
}

std::string randomBytes(std::size_t count) {
  std::string bytes(count, '\0');
  const NTSTATUS status = ::BCryptGenRandom(nullptr, reinterpret_cast<unsigned char*>(bytes.data()),
                                            static_cast<ULONG>(count), BCRYPT_USE_SYSTEM_PREFERRED_RNG);
  return status == 0 ? bytes : std::string();
}

}  // namespace rungproof
