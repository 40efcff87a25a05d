// Text sources inside a STEP 7 project need not agree with its blocks: where they do not, a note says so. The blocks
// run. Tested by tests/s7project/text_source_test.cpp.
#pragma once

#include <string>
#include <vector>

#include "frontend/s7project/s7_project.hpp"
#include "frontend/settings/options.hpp"
#include "ir/finding.hpp"
#include "ir/program.hpp"

namespace rungproof {

/// The same of one program of a project by its path.
std::vector<Finding> findUnlikeSources(const Program& program, const s7project::S7Project& project,
                                       const std::string& path, const Settings& settings);
/// Notes on blocks whose statements are other ones in a source of the project. The texts of the sources become sources
/// of the program. Nothing for files that are no program of a project.
std::vector<Finding> findUnlikeSources(const Program& program, const std::vector<std::string>& files,
                                       const Settings& settings);

}  // namespace rungproof
