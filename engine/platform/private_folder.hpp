// Places that belong to one user: a folder for what is kept, one for what is kept between runs, one for a moment; and
// bytes that nobody can guess. Tested by tests/platform and tests/cli/result_cache_test.cpp.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

namespace rungproof {

enum class FolderState : std::uint8_t { Private, CannotBeMade, NoFolder, OfAnotherUser, OpenToAll };
/// Makes a folder that only its user may enter, if nothing stands there; says what stands there otherwise. errno tells
/// why it cannot be made.
FolderState privateFolder(const std::filesystem::path& name);

/// Where this user's programs keep their state; empty if there is no such place.
std::filesystem::path stateFolder();

/// A new folder among the temporary files, which nobody else can reach; empty if none can be made.
std::filesystem::path temporaryFolder();

/// Empty if the system has none.
std::string randomBytes(std::size_t count);

}  // namespace rungproof
