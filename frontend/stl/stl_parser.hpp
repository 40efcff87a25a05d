// Statement lists to blocks and networks: the ASCII export of STEP 7-Micro/WIN and of the SMART editor, lists with
// Network lines only, and the older dialect (MEND, SBR n, INT n, no networks). Recovers at every line: what cannot
// be read is reported and marks its network as incomplete. Linear in the length of the text.
// Tested by tests/reader/stl_parser_test.cpp, older_dialect_test.cpp, damage_test.cpp.
#pragma once

#include "frontend/files/file_reader.hpp"

namespace rungproof {

/// Reads one statement list into the program.
void readStatementList(Program& program, const InputText& input, const ReadOptions& options);

}  // namespace rungproof
