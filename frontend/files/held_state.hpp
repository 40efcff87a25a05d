// What of disk_file.hpp a process beside this one needs to read the same. Tested through tests/editor/proof_test.cpp.
#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "frontend/files/disk_file.hpp"

namespace rungproof {

/// All texts that stand for files, by a name under which they can be held again.
const std::map<std::string, HeldText>& allHeldTexts();
/// The folder that confineInputs() was given, behind all links; empty: everything may be read.
const std::filesystem::path& inputsConfinedTo();

}  // namespace rungproof
