// Names without regard to case.
#include "frontend/s7project/project_files.hpp"

#include <algorithm>
#include <filesystem>

#include "engine/platform/names.hpp"
#include "frontend/files/disk_file.hpp"
#include "frontend/files/file_reader.hpp"
#include "frontend/s7project/archive.hpp"

namespace rungproof::s7project {

namespace {

/// ASCII letters small, separators /.
std::string foldedPath(std::string_view path) {
  std::string folded(path);
  for (char& c : folded) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    if (c == '\\') c = '/';
  }
  return folded;
}

}  // namespace

bool isProjectFileName(std::string_view name) { return endsInAny(name, {".s7p", ".s7l"}); }

void ProjectFiles::add(std::string_view relative, std::string where) {
  files_.emplace(foldedPath(relative), std::pair(std::string(relative), std::move(where)));
}

ProjectFiles ProjectFiles::inFolder(const std::string& projectFile) {
  namespace fs = std::filesystem;
  ProjectFiles files;
  const fs::path path(projectFile);
  files.projectFile_ = pathName(path.filename());
  const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
  std::error_code error;
  for (fs::recursive_directory_iterator entry(folder, fs::directory_options::skip_permission_denied, error), end;
       !error && entry != end; entry.increment(error)) {
    std::error_code unknown;
    if (entry->is_regular_file(unknown))
      files.add(entry->path().lexically_relative(folder).generic_string(), pathName(entry->path()));
  }
  return files;
}

ProjectFiles ProjectFiles::inArchive(const std::string& file, std::string& fault) {
  ProjectFiles files;
  InputBytes input = inputBytes(file, longestProgram);
  if (!input.bytes) {
    fault = input.problem;
    return files;
  }
  const auto archive = std::make_shared<Archive>(std::move(*input.bytes));
  fault = archive->fault();
  const auto project = std::ranges::find_if(archive->entries(),
                                            [](const Archive::Entry& entry) { return isProjectFileName(entry.name); });
  if (project == archive->entries().end()) {
    if (fault.empty()) fault = "no project of STEP 7 is in the archive";
    return files;
  }
  const std::size_t folder = project->name.rfind('/') == std::string::npos ? 0 : project->name.rfind('/') + 1;
  files.projectFile_ = project->name.substr(folder);
  const std::string prefix = project->name.substr(0, folder);
  for (std::size_t i = 0; i < archive->entries().size(); ++i) {
    const std::string& name = archive->entries()[i].name;
    if (name.starts_with(prefix) && !name.ends_with('/')) files.add(name.substr(folder), std::to_string(i));
  }
  files.archive_ = archive;
  return files;
}

std::optional<std::string> ProjectFiles::bytes(std::string_view path) const {
  const auto found = files_.find(foldedPath(path));
  if (found == files_.end()) return std::nullopt;
  const std::string& where = found->second.second;
  if (archive_ != nullptr) return archive_->contents(archive_->entries()[std::stoul(where)]);
  return inputBytes(where, longestProgram).bytes;
}

std::string ProjectFiles::spelling(std::string_view path) const {
  const auto found = files_.find(foldedPath(path));
  return found == files_.end() ? std::string(path) : found->second.first;
}

bool ProjectFiles::has(std::string_view path) const { return files_.contains(foldedPath(path)); }

std::vector<std::string> ProjectFiles::namesIn(std::string_view folder) const {
  const std::string prefix = foldedPath(folder) + "/";
  std::map<std::string, std::string> names;
  for (auto entry = files_.lower_bound(prefix); entry != files_.end() && entry->first.starts_with(prefix); ++entry) {
    const std::size_t end = entry->first.find('/', prefix.size());
    names.emplace(entry->first.substr(prefix.size(), end - prefix.size()),
                  entry->second.first.substr(prefix.size(), end - prefix.size()));
  }
  std::vector<std::string> spelled;
  for (const auto& [folded, name] : names) spelled.push_back(name);
  return spelled;
}

}  // namespace rungproof::s7project
