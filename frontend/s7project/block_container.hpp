// The blocks of one container of a project: BAUSTEIN.DBF names them, SUBBLK.DBF holds their parts.
// Tested by tests/s7project/project_test.cpp.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "frontend/mc7/stored_block.hpp"
#include "frontend/s7project/project_files.hpp"

namespace rungproof::s7project {

struct BlockContainer {
  std::vector<mc7::StoredBlock> blocks;
  std::size_t variableTables = 0;
  std::vector<std::string> faults;
  std::vector<std::string> losses;  ///< faults by which blocks may be missing
};

/// `text`: bytes of the project's code page as UTF-8.
BlockContainer readBlockContainer(const ProjectFiles& files, const std::string& folder,
                                  const std::function<std::string(std::string_view)>& text);

}  // namespace rungproof::s7project
