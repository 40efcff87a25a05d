// Lines of a VAR section: `NAME:TYPE; // comment`. Tested by tests/reader/table_test.cpp.
#pragma once

#include "frontend/stl/stl_lexer.hpp"
#include "frontend/stl/syntax_sink.hpp"

namespace rungproof {

/// Reads the declaration in text[begin, end) and appends its variables; reports what it cannot read. EN of a
/// subroutine is the power flow of the call and takes no local memory (001:2424, 001:6805): it is passed over.
void readDeclaration(std::string_view text, std::uint32_t begin, std::uint32_t end, VarSection section,
                     SyntaxSink& sink, std::vector<LocalVariable>& locals);

}  // namespace rungproof
