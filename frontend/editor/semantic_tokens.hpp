// What each word of a document is, for clients that colour by meaning: mnemonics of any family, addresses, symbols,
// local variables, labels, constants. Tested by tests/editor/semantic_tokens_test.cpp.
#pragma once

#include "frontend/editor/checked_document.hpp"

namespace rungproof {

/// Names of the kinds, in the order of the numbers that semanticTokensOf() writes.
Json semanticLegend();
/// {"data": [line, character, length, kind, 0, ...]}, each place relative to the one before, in UTF-16 units.
Json semanticTokensOf(const CheckedDocument& document);

}  // namespace rungproof
