// Recognising statement lists: whether a text is one, and in which spelling it is written.
// Tested by tests/reader/project_test.cpp and german_test.cpp.
#pragma once

#include "frontend/stl/operand_reader.hpp"

namespace rungproof {

/// What the beginning of a text looks like.
struct StlLikeness {
  bool hasHeading = false;  ///< ORGANIZATION_BLOCK, SUBROUTINE_BLOCK, INTERRUPT_BLOCK, DATA_BLOCK or SYMBOL_TABLE
  bool isMarkup = false;    ///< begins as XML or JSON
  int share = 0;            ///< per cent of its statement lines that begin with a mnemonic
};
StlLikeness stlLikeness(std::string_view text);

/// Whether the text writes E, A, Z and U rather than I, Q, C and A: counts the evidence of both.
Spelling detectSpelling(std::string_view text);

}  // namespace rungproof
