// Statements in columns, one style for each family: S7-200 as the editor exports them (mnemonic from column 1, operands
// from column 8), S7-300/400 as STEP 7 writes sources (label, mnemonic from column 7, operand from column 13),
// structured text indented by its nesting. Only blanks change, and the case of mnemonics of an S7-200; what was not
// read as one statement on its line stays as it is. Tested by tests/editor/formatting_test.cpp over the corpus.
#pragma once

#include "frontend/editor/checked_document.hpp"

namespace rungproof {

struct FormatStyle {
  std::uint32_t tabSize = 4;  ///< of structured text: blanks for each level
};

/// Edits for the lines from `first` to `last`, counted from 0.
Json formattingEdits(const CheckedDocument& document, const FormatStyle& style, std::uint32_t first,
                     std::uint32_t last);

}  // namespace rungproof
