// Would SIMATIC Manager compile this source? The reader takes more than the editor of STEP 7 does: statements without
// semicolons, long names, blocks in any order. What the editor refuses is listed here for `check`, with its place.
// Lengths and order: general knowledge of STEP 7 V5. Tested by tests/step7/source_check_test.cpp.
#pragma once

#include <string_view>
#include <vector>

#include "frontend/step7/syntax.hpp"
#include "ir/s7300/declarations.hpp"

namespace rungproof::step7 {

/// Appends a row for each fault, in the order of the text; of one kind one for each network. A listing without block
/// heads is no source and has one row.
void checkSource(const SourceSyntax& source, std::string_view text, std::vector<s7300::SourceFault>& faults);

}  // namespace rungproof::step7
