// From the tree to text.
#include "ir/iec/statement_text.hpp"

#include <fmt/format.h>

#include <array>
#include <string_view>
#include <utility>

namespace rungproof::iec {

namespace {

/// Tighter operators have a higher rank; those of one rank read from left to right.
int rankOf(const Expr& expr) {
  static constexpr std::array<std::pair<std::string_view, int>, 16> ranks = {{{"OR", 1},
                                                                              {"XOR", 2},
                                                                              {"AND", 3},
                                                                              {"&", 3},
                                                                              {"=", 4},
                                                                              {"<>", 4},
                                                                              {"<", 5},
                                                                              {">", 5},
                                                                              {"<=", 5},
                                                                              {">=", 5},
                                                                              {"+", 6},
                                                                              {"-", 6},
                                                                              {"*", 7},
                                                                              {"/", 7},
                                                                              {"MOD", 7},
                                                                              {"**", 8}}};
  if (expr.kind == ExprKind::Unary) return 9;
  if (expr.kind != ExprKind::Binary) return 10;
  for (const auto& [text, rank] : ranks) {
    if (text == expr.text) return rank;
  }
  return 0;
}

std::string inner(const Expr& expr, int least) {
  const std::string text = expressionText(expr);
  return rankOf(expr) < least ? "(" + text + ")" : text;
}

std::string pathText(const std::vector<PathPart>& parts) {
  std::string text;
  for (const PathPart& part : parts) {
    switch (part.kind) {
      case PathPart::Kind::Name: text += (text.empty() ? "" : ".") + part.name; break;
      case PathPart::Kind::Index: {
        std::string indices;
        for (const ExprPtr& index : part.indices) indices += (indices.empty() ? "" : ", ") + expressionText(*index);
        text += "[" + indices + "]";
        break;
      }
      default: text += fmt::format(".{}", part.bit); break;
    }
  }
  return text;
}

std::string argumentsText(const std::vector<Argument>& arguments) {
  std::string text;
  for (const Argument& argument : arguments) {
    if (!text.empty()) text += ", ";
    if (!argument.name.empty())
      text += fmt::format("{}{} {} ", argument.isNegated ? "NOT " : "", argument.name, argument.isOutput ? "=>" : ":=");
    if (argument.value != nullptr) text += expressionText(*argument.value);
  }
  return text;
}

void addBody(const Statements& body, std::vector<std::string>& lines) {
  for (const Statement& one : body) {
    for (std::string& line : statementLines(one)) lines.push_back("  " + std::move(line));
  }
}

}  // namespace

std::string expressionText(const Expr& expr) {
  switch (expr.kind) {
    case ExprKind::Literal: return (expr.prefix.empty() ? "" : expr.prefix + "#") + expr.text;
    case ExprKind::Text: return expr.text;
    case ExprKind::Path: return pathText(expr.parts);
    case ExprKind::Unary: return expr.text + (expr.text == "-" ? "" : " ") + inner(*expr.operands.at(0), 9);
    case ExprKind::Binary: {
      const int rank = rankOf(expr);
      return fmt::format("{} {} {}", inner(*expr.operands.at(0), rank), expr.text,
                         inner(*expr.operands.at(1), rank + 1));
    }
    case ExprKind::Call: return pathText(expr.parts) + "(" + argumentsText(expr.arguments) + ")";
  }
  return {};
}

std::vector<std::string> statementLines(const Statement& statement) {
  std::vector<std::string> lines;
  switch (statement.kind) {
    case StatementKind::Assign:
      lines.push_back(expressionText(*statement.target) + " := " + expressionText(*statement.value) + ";");
      break;
    case StatementKind::Call: lines.push_back(expressionText(*statement.target) + ";"); break;
    case StatementKind::Return: lines.emplace_back("RETURN;"); break;
    case StatementKind::Label: lines.push_back(expressionText(*statement.target) + ":"); break;
    case StatementKind::Jump:
      lines.push_back((statement.value == nullptr ? "" : "IF " + expressionText(*statement.value) + " THEN ") + "JMP " +
                      expressionText(*statement.target) + ";" + (statement.value == nullptr ? "" : " END_IF;"));
      break;
    case StatementKind::If:
      for (const Branch& branch : statement.branches) {
        lines.push_back(fmt::format("{} {} THEN", lines.empty() ? "IF" : "ELSIF", expressionText(*branch.condition)));
        addBody(branch.body, lines);
      }
      if (statement.hasElse) lines.emplace_back("ELSE");
      addBody(statement.otherwise, lines);
      lines.emplace_back("END_IF;");
      break;
    default: lines.emplace_back("(* not read *);"); break;
  }
  return lines;
}

std::vector<std::string> circuitLines(const ProjectSyntax& project, Span place) {
  for (const BlockSyntax& block : project.blocks) {
    for (std::size_t i = 0; i < block.body.size(); ++i) {
      const Statement& first = block.body[i];
      if (first.drawn == nullptr || !(first.drawn->span == place)) continue;
      std::vector<std::string> lines;
      for (std::size_t k = i; k < block.body.size() && block.body[k].circuit == first.circuit; ++k) {
        for (std::string& line : statementLines(block.body[k])) lines.push_back(std::move(line));
      }
      return lines;
    }
  }
  return {};
}

}  // namespace rungproof::iec
