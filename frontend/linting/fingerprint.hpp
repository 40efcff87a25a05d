// A name for a finding that survives edits elsewhere in the file: rule, block, address, and the text of its line
// without spaces. Line and network numbers are left out, because inserting a network must not make old findings new.
// The baseline file and the SARIF report use it. Tested by tests/cli/baseline_test.cpp.
#pragma once

#include <string>
#include <vector>

#include "ir/finding.hpp"

namespace rungproof {

/// 16 hexadecimal digits.
std::string fingerprintOf(const Finding& finding, const SourceSet& sources);
/// Of texts that belong together.
std::string fingerprintOf(const std::vector<std::string>& parts);

}  // namespace rungproof
