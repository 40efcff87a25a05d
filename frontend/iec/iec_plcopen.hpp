// PLCopen TC6 XML to the syntax tree: types, blocks, variables, configurations, and bodies in ST, LD and FBD. Bodies in
// IL and SFC are not read yet.
#pragma once

#include "frontend/files/file_reader.hpp"
#include "ir/iec/syntax.hpp"

namespace rungproof::iec {

/// Whether a body of the file is written in ST.
bool hasStructuredText(std::string_view text);
void readPlcopenText(Program& program, const InputText& input, ProjectSyntax& project);

}  // namespace rungproof::iec
