// Walks over the syntax tree of IEC 61131-3 programs: statements, expressions, what a block consists of.
// Tested by tests/rules/iec_rules_test.cpp.
#pragma once

#include <functional>
#include <optional>

#include "ir/iec/syntax.hpp"

namespace rungproof::iec {

/// Calls visit(statement, list, index) for every statement, those inside others too; `list` holds it.
void eachStatement(const Statements& list,
                   const std::function<void(const Statement&, const Statements&, std::size_t)>& visit);
/// The same for the body of a block and its actions: `eachStatementOf` for all, `eachWrittenStatement` without what was
/// made of a chart.
void eachStatementOf(const BlockSyntax& block,
                     const std::function<void(const Statement&, const Statements&, std::size_t)>& visit);
void eachWrittenStatement(const BlockSyntax& block,
                          const std::function<void(const Statement&, const Statements&, std::size_t)>& visit);
/// Calls visit(statements) for the body of a block and for its actions, without what was made of a chart.
void eachBody(const BlockSyntax& block, const std::function<void(const Statements&)>& visit);
/// Whether a body is written in IL.
bool isList(const Statements& body);
/// Calls visit(expression) for every expression of a statement without those of the statements inside it.
void eachExpression(const Statement& statement, const std::function<void(const Expr&)>& visit);
/// The same for an expression and all its parts.
void eachPart(const Expr& expr, const std::function<void(const Expr&)>& visit);
/// Whether two expressions are written alike, spaces and case apart.
bool isSame(const Expr& a, const Expr& b);
/// A whole number as it is written: 5, -5, 1_000; nothing for 16#FF, typed numbers and everything else.
std::optional<std::int64_t> plainNumber(const Expr& expr);
/// Calls visit(block) for every block of the project's own that was read whole; visit(block, statement, list, index)
/// for every statement in it, and visit(block, expression) for every expression, without what was made of a chart.
void eachOwnBlock(const ProjectSyntax& project, const std::function<void(const BlockSyntax&)>& visit);
void eachOwnStatement(
    const ProjectSyntax& project,
    const std::function<void(const BlockSyntax&, const Statement&, const Statements&, std::size_t)>& visit);
void eachOwnExpression(const ProjectSyntax& project, const std::function<void(const BlockSyntax&, const Expr&)>& visit);

}  // namespace rungproof::iec
