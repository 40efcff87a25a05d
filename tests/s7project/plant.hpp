// A plant of 20 blocks of every kind, and runs of the program over it.
#pragma once

#include <sstream>
#include <string>
#include <vector>

#include "frontend/cli/cli.hpp"
#include "tests/s7project/block_compiler.hpp"
#include "tests/s7project/project_writer.hpp"
#include "tests/temporary_folder.hpp"

namespace rungproof::test {

/// Two OBs, six FCs, three FBs, seven DBs, two UDTs.
std::string plantSource();
/// Compiled; FC 3 is know-how protected.
ProjectPart plantPart();
/// Old versions of the blocks: three of each, with another output in OB1.
std::vector<mc7::StoredBlock> oldVersions(const std::vector<mc7::StoredBlock>& blocks);

/// Writes the files below the folder; gives the path of the project file.
std::string writeFiles(const TemporaryFolder& folder, const std::map<std::string, std::string>& files);

struct Run {
  int exit = -1;
  std::string out, err;
  bool says(std::string_view text) const {
    return out.find(text) != std::string::npos || err.find(text) != std::string::npos;
  }
};
Run runWith(const std::vector<std::string>& arguments);

}  // namespace rungproof::test
