// IEC012: REAL values that are compared with = or <>. Tested by its examples and tests/rules/iec_rules_test.cpp.
#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "analysis/flow/facts.hpp"
#include "analysis/flow/variable_uses.hpp"
#include "analysis/rule.hpp"

namespace rungproof {

namespace {

bool isRealLiteral(const iec::Expr& expr) {
  const bool isTyped = iec::foldedName(expr.prefix) == "REAL" || iec::foldedName(expr.prefix) == "LREAL";
  return expr.kind == iec::ExprKind::Literal &&
         (isTyped || (expr.prefix.empty() && expr.text.find('.') != std::string::npos));
}

/// Whether a value is a REAL: a variable, a literal, a sum or product with one, ABS and the like of one.
bool isRealValue(const iec::VariableUses& uses, const iec::BlockSyntax& block, const iec::Expr& expr) {
  const auto isReal = [&](const iec::ExprPtr& part) { return part != nullptr && isRealValue(uses, block, *part); };
  switch (expr.kind) {
    case iec::ExprKind::Literal: return isRealLiteral(expr);
    case iec::ExprKind::Path: {
      const std::string type = uses.elementaryTypeOf(block, expr);
      return type == "REAL" || type == "LREAL";
    }
    case iec::ExprKind::Unary: return expr.text == "-" && std::ranges::any_of(expr.operands, isReal);
    case iec::ExprKind::Binary:
      return (expr.text == "+" || expr.text == "-" || expr.text == "*" || expr.text == "/" || expr.text == "**") &&
             std::ranges::any_of(expr.operands, isReal);
    case iec::ExprKind::Call: {
      const std::string name = expr.parts.empty() ? "" : iec::foldedName(expr.parts[0].name);
      if (const iec::BlockSyntax* function = uses.blockNamed(name);
          function != nullptr && function->result != nullptr) {
        const std::string result = iec::foldedName(function->result->name);
        return result == "REAL" || result == "LREAL";
      }
      constexpr std::string_view ofReals[] = {"SQRT", "SIN", "COS", "TAN", "ASIN", "ACOS",
                                              "ATAN", "LN",  "LOG", "EXP", "EXPT"};
      return std::ranges::find(ofReals, name) != std::end(ofReals) || name.ends_with("_TO_REAL") ||
             name.ends_with("_TO_LREAL");
    }
    default: return false;
  }
}

/// Zero is met exactly where nothing was worked out: a value that was set to it.
bool isRealZero(const iec::Expr& expr) {
  return expr.kind == iec::ExprKind::Literal &&
         std::ranges::all_of(expr.text, [](char c) { return c == '0' || c == '.'; });
}

void checkIec012(const Facts& facts, FindingSink& sink) {
  const iec::VariableUses& uses = facts.variableUses();
  iec::eachOwnExpression(uses.project(), [&](const iec::BlockSyntax& block, const iec::Expr& expr) {
    if (expr.kind != iec::ExprKind::Binary || (expr.text != "=" && expr.text != "<>") || expr.operands.size() != 2)
      return;
    if (iec::isSame(*expr.operands[0], *expr.operands[1])) return;  // asks whether it is a number
    if (isRealZero(*expr.operands[0]) || isRealZero(*expr.operands[1])) return;
    if (!isRealValue(uses, block, *expr.operands[0]) && !isRealValue(uses, block, *expr.operands[1])) return;
    Finding& finding = sink.report(expr.span, fmt::format("REAL values are compared with {}", expr.text));
    finding.help = "compare the distance with a tolerance: ABS(a - b) < 0.01";
  });
}

}  // namespace

extern constexpr Rule iec012_real_compared = {
    .id = "IEC012",
    .title = "REAL compared for equality",
    .severity = Severity::Warning,
    .needs = Needs::Flow,
    .detects = "= or <> between REAL or LREAL values; a comparison with 0.0 excepted",
    .why = "a result is rounded: 0.1 + 0.2 is not 0.3, and the moment of equality is missed",
    .bad =
        "PROGRAM Main\nVAR_INPUT Level : REAL; END_VAR\nVAR_OUTPUT Full : BOOL; END_VAR\nFull := Level = "
        "80.0;\nEND_PROGRAM\n",
    .good =
        "PROGRAM Main\nVAR_INPUT Level : REAL; END_VAR\nVAR_OUTPUT Full : BOOL; END_VAR\nFull := Level >= "
        "80.0;\nEND_PROGRAM\n",
    .exampleCpu = "IEC-4K",
    .peers = "SA0054",
    .dialects = dialect::Iec,
    .check = checkIec012,
};

}  // namespace rungproof
