// IEC013: an operator with the same expression on both sides. Tested by its examples and
// tests/rules/iec_rules_test.cpp.
#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <string_view>

#include "analysis/flow/facts.hpp"
#include "analysis/flow/variable_uses.hpp"
#include "analysis/rule.hpp"

namespace rungproof {

namespace {

/// x <> x is true of what is no number (NaN).
bool isRealPlace(const iec::VariableUses& uses, const iec::BlockSyntax& block, const iec::Expr& expr) {
  const std::string type = uses.elementaryTypeOf(block, expr);
  return type == "REAL" || type == "LREAL";
}

void checkIec013(const Facts& facts, FindingSink& sink) {
  const iec::VariableUses& uses = facts.variableUses();
  constexpr std::string_view operators[] = {"=", "<>", "<", "<=", ">", ">=", "AND", "&", "OR", "XOR", "-", "/", "MOD"};
  iec::eachOwnExpression(uses.project(), [&](const iec::BlockSyntax& block, const iec::Expr& expr) {
    if (expr.kind != iec::ExprKind::Binary || expr.operands.size() != 2) return;
    if (std::ranges::find(operators, expr.text) == std::end(operators)) return;
    const iec::Expr &left = *expr.operands[0], &right = *expr.operands[1];
    // The last operand of a chain a AND b AND b stands beside the one before it.
    const bool isChain = left.kind == iec::ExprKind::Binary && left.text == expr.text && left.operands.size() == 2 &&
                         (expr.text == "AND" || expr.text == "OR" || expr.text == "&");
    const bool isTwice = iec::isSame(left, right) || (isChain && iec::isSame(*left.operands[1], right));
    const bool isNumber = left.kind == iec::ExprKind::Literal;
    const bool asksForNumber = (expr.text == "=" || expr.text == "<>") && isRealPlace(uses, block, left);
    if (!isTwice || isNumber || asksForNumber) return;
    Finding& finding = sink.report(expr.span, fmt::format("both sides of {} are the same", expr.text));
    finding.help = "one of them is probably meant to be another variable";
  });
}

}  // namespace

extern constexpr Rule iec013_same_on_both_sides = {
    .id = "IEC013",
    .title = "Same expression on both sides",
    .severity = Severity::Warning,
    .needs = Needs::Text,
    .detects = "a comparison, AND, OR, XOR, a difference, a quotient or MOD with the same expression on both sides",
    .why = "the result is known beforehand; mostly a name was copied and not changed",
    .bad =
        "PROGRAM Main\nVAR_INPUT a, b : BOOL; END_VAR\nVAR_OUTPUT q : BOOL; END_VAR\nq := a AND b AND "
        "b;\nEND_PROGRAM\n",
    .good =
        "PROGRAM Main\nVAR_INPUT a, b, c : BOOL; END_VAR\nVAR_OUTPUT q : BOOL; END_VAR\nq := a AND b AND "
        "c;\nEND_PROGRAM\n",
    .exampleCpu = "IEC-4K",
    .dialects = dialect::Iec,
    .check = checkIec013,
};

}  // namespace rungproof
