// Each walk is built on the one below it.
#include "ir/iec/walk.hpp"

#include <algorithm>
#include <charconv>

namespace rungproof::iec {

void eachStatement(const Statements& list,
                   const std::function<void(const Statement&, const Statements&, std::size_t)>& visit) {
  for (std::size_t i = 0; i < list.size(); ++i) {
    visit(list[i], list, i);
    for (const Branch& branch : list[i].branches) eachStatement(branch.body, visit);
    eachStatement(list[i].otherwise, visit);
  }
}

void eachStatementOf(const BlockSyntax& block,
                     const std::function<void(const Statement&, const Statements&, std::size_t)>& visit) {
  eachStatement(block.body, visit);
  for (const ActionSyntax& action : block.actions) eachStatement(action.body, visit);
}

void eachWrittenStatement(const BlockSyntax& block,
                          const std::function<void(const Statement&, const Statements&, std::size_t)>& visit) {
  eachBody(block, [&](const Statements& body) { eachStatement(body, visit); });
}

void eachBody(const BlockSyntax& block, const std::function<void(const Statements&)>& visit) {
  const auto isMade = [](const Statement& one) { return !one.picture.empty(); };
  if (std::ranges::none_of(block.body, isMade)) visit(block.body);
  for (const ActionSyntax& action : block.actions) {
    if (!action.isChart && !action.isCondition) visit(action.body);
  }
}

bool isList(const Statements& body) {
  return std::ranges::any_of(body, [](const Statement& one) { return one.kind == StatementKind::Line; });
}

void eachPart(const Expr& expr, const std::function<void(const Expr&)>& visit) {
  visit(expr);
  for (const ExprPtr& operand : expr.operands) {
    if (operand != nullptr) eachPart(*operand, visit);
  }
  for (const Argument& argument : expr.arguments) {
    if (argument.value != nullptr) eachPart(*argument.value, visit);
  }
  for (const PathPart& part : expr.parts) {
    for (const ExprPtr& index : part.indices) {
      if (index != nullptr) eachPart(*index, visit);
    }
  }
}

void eachExpression(const Statement& statement, const std::function<void(const Expr&)>& visit) {
  for (const ExprPtr* part : {&statement.target, &statement.value, &statement.last, &statement.by}) {
    if (*part != nullptr) eachPart(**part, visit);
  }
  if (statement.line != nullptr) {
    for (const Argument& operand : statement.line->operands) {
      if (operand.value != nullptr) eachPart(*operand.value, visit);
    }
  }
  for (const Branch& branch : statement.branches) {
    if (branch.condition != nullptr) eachPart(*branch.condition, visit);
    for (const CaseLabel& label : branch.labels) {
      if (label.low != nullptr) eachPart(*label.low, visit);
      if (label.high != nullptr) eachPart(*label.high, visit);
    }
  }
}

bool isSame(const Expr& a, const Expr& b) {
  const auto both = [](const ExprPtr& x, const ExprPtr& y) {
    return (x == nullptr) == (y == nullptr) && (x == nullptr || isSame(*x, *y));
  };
  const auto samePart = [&](const PathPart& x, const PathPart& y) {
    return x.kind == y.kind && x.bit == y.bit && x.bits == y.bits && foldedName(x.name) == foldedName(y.name) &&
           std::ranges::equal(x.indices, y.indices, both);
  };
  const auto sameArgument = [&](const Argument& x, const Argument& y) {
    return foldedName(x.name) == foldedName(y.name) && x.isOutput == y.isOutput && both(x.value, y.value);
  };
  return a.kind == b.kind && foldedName(a.text) == foldedName(b.text) && foldedName(a.prefix) == foldedName(b.prefix) &&
         std::ranges::equal(a.parts, b.parts, samePart) && std::ranges::equal(a.operands, b.operands, both) &&
         std::ranges::equal(a.arguments, b.arguments, sameArgument);
}

void eachOwnBlock(const ProjectSyntax& project, const std::function<void(const BlockSyntax&)>& visit) {
  for (const BlockSyntax& block : project.blocks) {
    bool isRead = !block.isLibrary && block.isWhole && block.unread.empty();
    if (isRead) {
      eachStatementOf(block, [&](const Statement& one, const Statements&, std::size_t) {
        isRead = isRead && one.kind != StatementKind::Unread;
      });
    }
    if (isRead) visit(block);
  }
}

void eachOwnStatement(
    const ProjectSyntax& project,
    const std::function<void(const BlockSyntax&, const Statement&, const Statements&, std::size_t)>& visit) {
  eachOwnBlock(project, [&](const BlockSyntax& block) {
    eachWrittenStatement(block, [&](const Statement& one, const Statements& list, std::size_t index) {
      visit(block, one, list, index);
    });
  });
}

void eachOwnExpression(const ProjectSyntax& project,
                       const std::function<void(const BlockSyntax&, const Expr&)>& visit) {
  eachOwnStatement(project, [&](const BlockSyntax& block, const Statement& one, const Statements&, std::size_t) {
    eachExpression(one, [&](const Expr& expr) { visit(block, expr); });
  });
}

std::optional<std::int64_t> plainNumber(const Expr& expr) {
  if (expr.kind == ExprKind::Unary && expr.text == "-" && expr.operands.size() == 1) {
    const std::optional<std::int64_t> positive = plainNumber(*expr.operands[0]);
    return positive ? std::optional(-*positive) : std::nullopt;
  }
  if (expr.kind != ExprKind::Literal || !expr.prefix.empty()) return std::nullopt;
  std::string digits;
  for (const char c : expr.text) {
    if (c != '_') digits += c;
  }
  std::int64_t value = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  if (error != std::errc{} || end != digits.data() + digits.size()) return std::nullopt;
  return value;
}

}  // namespace rungproof::iec
