// Statements of STEP 7 sources: label, mnemonic, operand, parameter list of a call in both forms, the classic one in
// parentheses and the editor's listing with a parameter a line (002:2494-2495). Tested by tests/step7/parser_test.cpp.
#pragma once

#include "frontend/step7/operand_parser.hpp"

namespace rungproof::step7 {

/// Reads the statement at the cursor, which stands behind its semicolon or line end afterwards. What cannot be read
/// stands in Statement::fault.
Statement readStatement(Cursor& cursor, const Spelling7& spelling, std::vector<Span>& remarks);

}  // namespace rungproof::step7
