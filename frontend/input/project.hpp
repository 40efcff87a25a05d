// From files to a program: reads, converts, recognises, parses, resolves. Several files make one program: main text,
// symbol tables, data blocks, libraries. Tested by tests/reader/project_test.cpp.
#pragma once

#include <string>
#include <vector>

#include "analysis/read_errors.hpp"
#include "frontend/files/read_options.hpp"
#include "ir/program.hpp"

namespace rungproof {

/// Reads all files into one program. `-` is standard input. Whatever cannot be read becomes a finding.
Program readProgram(const std::vector<std::string>& files, const ReadOptions& options = {});
/// The same for a text in memory (bytes in any encoding); `name` decides where the content does not.
Program readText(std::string name, std::string text, const ReadOptions& options = {});

}  // namespace rungproof
