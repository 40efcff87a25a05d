// PLCopen TC6 XML to the syntax tree: types, blocks, variables, configurations, and bodies in ST, IL, LD, FBD
// and SFC.
#pragma once

#include "frontend/files/file_reader.hpp"
#include "ir/iec/syntax.hpp"

namespace rungproof::iec {

/// Whether a body of the file is written in ST or SFC, which no S7-200 has.
bool hasBodyOfThisFamily(std::string_view text);
void readPlcopenText(Program& program, const InputText& input, ProjectSyntax& project);

}  // namespace rungproof::iec
