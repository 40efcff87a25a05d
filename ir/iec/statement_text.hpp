// Statements of IEC 61131-3 written out as structured text: what a drawing says, for those who want to read it so.
// Tested by tests/iec/picture_test.cpp.
#pragma once

#include <string>
#include <vector>

#include "ir/iec/syntax.hpp"

namespace rungproof::iec {

/// With the parentheses that its reading needs.
std::string expressionText(const Expr& expr);
/// One line for each row of text, two columns further in for each level.
std::vector<std::string> statementLines(const Statement& statement);
/// The statements of the circuit that was drawn at that place; empty: there is none.
std::vector<std::string> circuitLines(const ProjectSyntax& project, Span place);

}  // namespace rungproof::iec
