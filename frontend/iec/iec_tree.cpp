// Pieces of the syntax tree that a reader makes itself.
#include "frontend/iec/iec_tree.hpp"

#include <fmt/format.h>

namespace rungproof::iec {

ExprPtr copyOf(const Expr& expr) {
  ExprPtr made = std::make_unique<Expr>();
  made->kind = expr.kind;
  made->span = expr.span;
  made->text = expr.text;
  made->prefix = expr.prefix;
  for (const PathPart& part : expr.parts) {
    PathPart& copy = made->parts.emplace_back();
    copy.kind = part.kind;
    copy.name = part.name;
    copy.bit = part.bit;
    copy.bits = part.bits;
    copy.span = part.span;
    for (const ExprPtr& index : part.indices) copy.indices.push_back(copyOf(*index));
  }
  for (const ExprPtr& operand : expr.operands) made->operands.push_back(copyOf(*operand));
  for (const Argument& argument : expr.arguments) made->arguments.push_back(copyOf(argument));
  return made;
}

Argument copyOf(const Argument& argument) {
  Argument made;
  made.name = argument.name;
  made.isOutput = argument.isOutput;
  made.isNegated = argument.isNegated;
  made.span = argument.span;
  if (argument.value != nullptr) made.value = copyOf(*argument.value);
  return made;
}

Statement copyOf(const Statement& statement) {
  Statement made;
  made.kind = statement.kind;
  made.span = statement.span;
  if (statement.target != nullptr) made.target = copyOf(*statement.target);
  if (statement.value != nullptr) made.value = copyOf(*statement.value);
  return made;
}

ExprPtr pathOf(std::initializer_list<std::string_view> names, Span span) {
  ExprPtr made = std::make_unique<Expr>();
  made->kind = ExprKind::Path;
  made->span = span;
  for (const std::string_view name : names)
    made->parts.push_back({PathPart::Kind::Name, std::string(name), {}, 0, 1, span});
  return made;
}

ExprPtr literalOf(std::string_view text, Span span, std::string_view prefix) {
  ExprPtr made = std::make_unique<Expr>();
  made->kind = ExprKind::Literal;
  made->text = text;
  made->prefix = prefix;
  made->span = span;
  return made;
}

ExprPtr textOf(std::string_view text, Span span) {
  ExprPtr made = literalOf(fmt::format("'{}'", text), span);
  made->kind = ExprKind::Text;
  return made;
}

ExprPtr binaryOf(std::string_view op, ExprPtr left, ExprPtr right) {
  ExprPtr made = std::make_unique<Expr>();
  made->kind = ExprKind::Binary;
  made->text = op;
  made->span = right->span;
  made->operands.push_back(std::move(left));
  made->operands.push_back(std::move(right));
  return made;
}

ExprPtr orOf(ExprPtr left, ExprPtr right) {
  if (left == nullptr) return right;
  return right == nullptr ? std::move(left) : binaryOf("OR", std::move(left), std::move(right));
}

ExprPtr andOf(ExprPtr left, ExprPtr right) {
  if (left == nullptr) return right;
  return right == nullptr ? std::move(left) : binaryOf("AND", std::move(left), std::move(right));
}

ExprPtr notOf(ExprPtr inner) {
  ExprPtr made = std::make_unique<Expr>();
  made->kind = ExprKind::Unary;
  made->text = "NOT";
  made->span = inner->span;
  made->operands.push_back(std::move(inner));
  return made;
}

ExprPtr callOf(std::initializer_list<std::string_view> names, Span span) {
  ExprPtr made = pathOf(names, span);
  made->kind = ExprKind::Call;
  return made;
}

void addArgument(Expr& call, ExprPtr value, std::string_view name) {
  Argument& made = call.arguments.emplace_back();
  made.name = name;
  made.span = value->span;
  made.value = std::move(value);
}

Statement assignmentOf(ExprPtr target, ExprPtr value, Span span) {
  Statement made;
  made.kind = StatementKind::Assign;
  made.span = span;
  made.target = std::move(target);
  made.value = std::move(value);
  return made;
}

Statement callStatementOf(ExprPtr call) {
  Statement made;
  made.kind = StatementKind::Call;
  made.span = call->span;
  made.target = std::move(call);
  return made;
}

Statement ifOf(ExprPtr condition, Statements body, Span span) {
  Statement made;
  made.kind = StatementKind::If;
  made.span = span;
  Branch& branch = made.branches.emplace_back();
  branch.condition = std::move(condition);
  branch.body = std::move(body);
  return made;
}

ExprPtr readingOf(std::string_view choice, std::string_view reading, Span span) {
  ExprPtr made = callOf({"__READING"}, span);
  addArgument(*made, textOf(choice, span));
  addArgument(*made, textOf(reading, span));
  return made;
}

}  // namespace rungproof::iec
