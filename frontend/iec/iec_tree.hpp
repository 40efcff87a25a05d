// Pieces of the syntax tree that a reader makes itself: where it writes out what a list or a chart means.
#pragma once

#include <initializer_list>

#include "ir/iec/syntax.hpp"

namespace rungproof::iec {

ExprPtr copyOf(const Expr& expr);
Argument copyOf(const Argument& argument);
/// Of an assignment or a call.
Statement copyOf(const Statement& statement);
/// A variable, or a part of one: `a.b`.
ExprPtr pathOf(std::initializer_list<std::string_view> names, Span span);
/// TRUE, FALSE, T#5s as `T` and `5s`.
ExprPtr literalOf(std::string_view text, Span span, std::string_view prefix = {});
ExprPtr textOf(std::string_view text, Span span);
ExprPtr binaryOf(std::string_view op, ExprPtr left, ExprPtr right);
/// Of two sides, either of which may be missing.
ExprPtr orOf(ExprPtr left, ExprPtr right);
ExprPtr andOf(ExprPtr left, ExprPtr right);
ExprPtr notOf(ExprPtr inner);
ExprPtr callOf(std::initializer_list<std::string_view> names, Span span);
void addArgument(Expr& call, ExprPtr value, std::string_view name = {});
Statement assignmentOf(ExprPtr target, ExprPtr value, Span span);
Statement callStatementOf(ExprPtr call);
/// IF condition THEN body END_IF.
Statement ifOf(ExprPtr condition, Statements body, Span span);
/// TRUE where a reading of an open point is in force.
ExprPtr readingOf(std::string_view choice, std::string_view reading, Span span);

}  // namespace rungproof::iec
