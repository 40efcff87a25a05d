// How the system spells names of files, and what this program is called by its linker. Tested by tests/platform.
#pragma once

#include <filesystem>
#include <string>

namespace rungproof {

/// Whether a name fits a pattern with * (also across folders), ? and [...], in which \ takes a sign as it is.
bool fitsShellPattern(const std::string& name, const std::string& pattern);

/// A path as the program has names: in UTF-8, with / between folders.
std::string pathName(const std::filesystem::path& path);
/// The same of a name that a user has given.
std::string plainName(const std::string& name);

/// The path part of a file URI as a name, "/a/b.awl" or "C:/a/b.awl"; and back.
std::string nameOfUriPath(std::string path);
std::string uriPathOfName(const std::string& name);

/// The identity that the linker gave this executable; empty if it gave none.
std::string buildId();

}  // namespace rungproof
