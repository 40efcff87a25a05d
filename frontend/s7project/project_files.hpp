// The files of a STEP 7 project by their names in any case of letters: of a folder, or of the archive that STEP 7 makes
// of one. Tested by tests/s7project/archive_test.cpp.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace rungproof::s7project {

class Archive;

class ProjectFiles {
 public:
  /// The folder that holds the project file of that name.
  static ProjectFiles inFolder(const std::string& projectFile);
  /// The folder in the archive that holds a project file. `fault`: why there is none, or why nothing is read.
  static ProjectFiles inArchive(const std::string& file, std::string& fault);

  /// Name of the project file without its folder: "Plant.s7p".
  const std::string& projectFile() const { return projectFile_; }
  /// Whole contents; nothing: there is no such file. `path`: "hrs/S7RESOFF.DBF".
  std::optional<std::string> bytes(std::string_view path) const;
  /// The file's name as it is spelled there, or the path itself.
  std::string spelling(std::string_view path) const;
  bool has(std::string_view path) const;
  /// Names in a folder, as they are spelled: of folders without what lies in them.
  std::vector<std::string> namesIn(std::string_view folder) const;

 private:
  void add(std::string_view relative, std::string where);

  std::string projectFile_;
  std::map<std::string, std::pair<std::string, std::string>> files_;  ///< folded path: spelling, where its bytes are
  std::shared_ptr<const Archive> archive_;                            ///< nullptr: on the disk
};

/// Whether a file name ends like that of a project or library.
bool isProjectFileName(std::string_view name);

}  // namespace rungproof::s7project
