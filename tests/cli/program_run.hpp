// Runs the program in-process: arguments in, exit code and both outputs out.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace rungproof::test {

struct ProgramRun {
  int exit = -1;
  std::string out;
  std::string err;
};
ProgramRun run(const std::vector<std::string>& arguments);

/// An empty folder that is removed at the end.
class TemporaryFolder {
 public:
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  /// Writes a file and gives its path.
  std::string file(const std::string& name, const std::string& text) const;
  std::string path(const std::string& name) const { return (path_ / name).string(); }

 private:
  std::filesystem::path path_;
};

std::string contentOf(const std::string& path);
/// A MAIN block in the export form around the given network lines.
std::string mainBlock(const std::string& networks);

}  // namespace rungproof::test
