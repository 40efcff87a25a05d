// A plant of 20 blocks of every kind.
#pragma once

#include <string>
#include <vector>

#include "tests/program_run.hpp"
#include "tests/s7project/block_compiler.hpp"
#include "tests/s7project/project_writer.hpp"

namespace rungproof::test {

/// Two OBs, six FCs, three FBs, seven DBs, two UDTs.
std::string plantSource();
/// Compiled; FC 3 is know-how protected.
ProjectPart plantPart();
/// Old versions of the blocks: three of each, with another output in OB1.
std::vector<mc7::StoredBlock> oldVersions(const std::vector<mc7::StoredBlock>& blocks);

/// Writes the files below the folder; gives the path of the project file.
std::string writeFiles(const TemporaryFolder& folder, const std::map<std::string, std::string>& files);

}  // namespace rungproof::test
