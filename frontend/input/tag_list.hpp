// Tag lists of operator panels: name, address, type, access, comment, in columns that a heading names or in that order;
// separated by commas, semicolons or tabs; addresses as the S7-200 writes them or as a DB1 (VW100, V10.0, DB1.DBW100).
// Tested by tests/cli/tags_test.cpp.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "analysis/surroundings.hpp"
#include "frontend/files/encoding.hpp"
#include "ir/program.hpp"

namespace rungproof {

/// Reads a file into the program's sources and gives its tags. Rows without an address of this CPU family (headings,
/// tags of the panel itself) are passed over. A file that cannot be read is a finding of the program.
std::vector<PanelTag> readTagList(Program& program, const std::string& file, TextEncoding encoding);
/// The same for a text whose file is in the program's sources already.
std::vector<PanelTag> readTagText(const Program& program, std::uint32_t file);

/// The type that a panel's editor names so: "INT", "16-bit unsigned", "Float", "双字".
TagType tagTypeNamed(std::string_view text);

}  // namespace rungproof
