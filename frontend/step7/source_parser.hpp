// STEP 7 sources and listings to their syntax tree: blocks in any order, heads with their attributes in any order,
// declarations, data, networks. Recovers at statements, declarations and blocks. Linear in the length of the text.
// Tested by tests/step7/parser_test.cpp, malformed_test.cpp.
#pragma once

#include "frontend/step7/declaration_parser.hpp"
#include "frontend/step7/syntax.hpp"

namespace rungproof::step7 {

/// Reads one text. Mistakes of frames and declarations are reported; those of statements stand in the statements.
SourceSyntax readSource(std::string_view text, const Spelling7& spelling, SyntaxSink& sink);

}  // namespace rungproof::step7
