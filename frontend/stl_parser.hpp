// Statement lists to blocks and networks: the ASCII export of STEP 7-Micro/WIN and of the SMART editor, lists with
// Network lines only, and the older dialect (MEND, SBR n, INT n, no networks). Recovers at every line: what cannot
// be read is reported and marks its network as incomplete. Linear in the length of the text.
// Tested by tests/reader/stl_parser_test.cpp, older_dialect_test.cpp, damage_test.cpp.
#pragma once

#include "frontend/file_reader.hpp"
#include "frontend/operand_reader.hpp"

namespace rungproof {

/// What the beginning of a text looks like.
struct StlLikeness {
  bool hasHeading = false;  ///< ORGANIZATION_BLOCK, SUBROUTINE_BLOCK, INTERRUPT_BLOCK or DATA_BLOCK
  bool isMarkup = false;    ///< begins as XML or JSON
  int share = 0;            ///< per cent of its statement lines that begin with a mnemonic
};
StlLikeness stlLikeness(std::string_view text);

/// Whether the text writes E, A, Z and U rather than I, Q, C and A: counts the evidence of both.
Spelling detectSpelling(std::string_view text);

void readStatementList(Program& program, const InputText& input, const ReadOptions& options);

}  // namespace rungproof
