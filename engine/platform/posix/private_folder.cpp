// Folders with the mode 0700.
#include "engine/platform/private_folder.hpp"

#include <stdlib.h>
#include <sys/random.h>
#include <sys/stat.h>

#include <cerrno>
#include <cstdlib>

#include "engine/platform/file.hpp"

namespace rungproof {

namespace fs = std::filesystem;

FolderState privateFolder(const fs::path& name) {
  if (::mkdir(name.c_str(), 0700) == 0) return FolderState::Private;
  if (errno != EEXIST) return FolderState::CannotBeMade;
  const std::optional<FileStatus> status = fileStatus(name);
  if (!status || !status->isFolder()) return FolderState::NoFolder;
  if (!status->isOurs) return FolderState::OfAnotherUser;
  return status->isOpenToAll ? FolderState::OpenToAll : FolderState::Private;
}

fs::path stateFolder() {
  const char* const state = std::getenv("XDG_STATE_HOME");
  const char* const home = std::getenv("HOME");
  if (state != nullptr && *state != '\0') return state;
  return home == nullptr || *home == '\0' ? fs::path() : fs::path(home) / ".local" / "state";
}

fs::path temporaryFolder() {
  std::string name = (fs::temp_directory_path() / "rungproof-XXXXXX").string();
  return ::mkdtemp(name.data()) == nullptr ? fs::path() : fs::path(name);
}

std::string randomBytes(std::size_t count) {
  std::string bytes(count, '\0');
  return ::getrandom(bytes.data(), count, 0) == static_cast<ssize_t>(count) ? bytes : std::string();
}

}  // namespace rungproof
