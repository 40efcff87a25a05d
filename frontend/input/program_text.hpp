// Files whose ending says nothing of what is in them: a program, a table, a trace or a note. Tested by
// tests/cli/program_text_test.cpp.
#pragma once

#include <string>
#include <vector>

namespace rungproof {

/// Whether the ending is one that programs and tables share with traces and notes: .txt, .csv and their kind.
bool hasSharedEnding(const std::string& name);

/// Whether such a file is a program: it has the heading of a block, or is little else than statements. Tables, traces
/// and notes are none. Only what begins like a program is read as a whole.
bool isProgramText(const std::string& name);

/// All of them in and below a folder, sorted; nothing of a file.
std::vector<std::string> programTextsIn(const std::string& folder);

}  // namespace rungproof
