// From a name to its meaning and its uses, and the outline of a document. Tested by tests/editor/navigation_test.cpp.
#pragma once

#include "frontend/editor/cursor.hpp"

namespace rungproof {

/// Row of the symbol table, instructions that write an address, block of a call, label of a jump.
Json definitionsAt(const CheckedDocument& document, ClientPlace place);
/// All uses of the bits that are named there, or all calls and jumps. `withDeclaration`: the definition too.
Json referencesAt(const CheckedDocument& document, ClientPlace place, bool withDeclaration);
/// The uses in this document, each read or written.
Json highlightsAt(const CheckedDocument& document, ClientPlace place);
/// Blocks and networks of more than one line.
Json foldsOf(const CheckedDocument& document);
/// Blocks, in them networks with their titles, in them labels; symbols of a table.
Json outlineOf(const CheckedDocument& document);
/// Blocks, networks with a title, and symbols whose name contains the text in any case.
void addSymbols(const CheckedDocument& document, std::string_view text, Json& list);

}  // namespace rungproof
