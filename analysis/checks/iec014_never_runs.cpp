// IEC014: statements that can never run. Tested by its examples and tests/rules/iec_rules_test.cpp.
#include <fmt/format.h>

#include "analysis/flow/facts.hpp"
#include "analysis/flow/variable_uses.hpp"
#include "analysis/rule.hpp"

namespace rungproof {

namespace {

bool isLiteral(const iec::Expr* expr, std::string_view value) {
  if (expr == nullptr) return false;
  const bool isName =
      expr->kind == iec::ExprKind::Path && expr->parts.size() == 1 && iec::foldedName(expr->parts[0].name) == value;
  return isName || (expr->kind == iec::ExprKind::Literal && iec::foldedName(expr->text) == value);
}

void checkIec014(const Facts& facts, FindingSink& sink) {
  const iec::VariableUses& uses = facts.variableUses();
  const auto report = [&](Span span, std::string message) {
    sink.report(span, std::move(message)).help = "remove the statements, or the condition in front of them";
  };
  iec::eachOwnStatement(uses.project(), [&](const iec::BlockSyntax&, const iec::Statement& one,
                                            const iec::Statements& list, std::size_t index) {
    using enum iec::StatementKind;
    const bool leaves = one.kind == Return || one.kind == Exit || one.kind == Continue;
    if (leaves && index + 1 < list.size())
      report(list[index + 1].span, "this never runs: the statement in front of it leaves the list");
    if (one.kind == If) {
      bool isTaken = false;
      for (const iec::Branch& branch : one.branches) {
        if (isTaken && branch.condition != nullptr)
          report(branch.condition->span, "this branch is never taken: the one in front of it always is");
        if (isLiteral(branch.condition.get(), "FALSE"))
          report(branch.condition->span, "this branch is never taken: its condition is FALSE");
        isTaken = isTaken || isLiteral(branch.condition.get(), "TRUE");
      }
      if (isTaken && !one.otherwise.empty())
        report(one.otherwise.front().span, "this never runs: a branch in front of it is always taken");
    }
    if (one.kind == While && isLiteral(one.value.get(), "FALSE"))
      report(one.value->span, "the loop never runs: its condition is FALSE");
  });
}

}  // namespace

extern constexpr Rule iec014_never_runs = {
    .id = "IEC014",
    .title = "Statement never runs",
    .severity = Severity::Warning,
    .needs = Needs::Text,
    .detects =
        "statements behind RETURN, EXIT or CONTINUE in the same list; branches and loops whose condition is FALSE; "
        "branches behind one whose condition is TRUE",
    .why = "they look like a part of the program and do nothing",
    .bad =
        "PROGRAM Main\nVAR_INPUT a : BOOL; END_VAR\nVAR_OUTPUT q : BOOL; END_VAR\nIF a THEN\n  RETURN;\n  q := "
        "TRUE;\nEND_IF;\nq := FALSE;\nEND_PROGRAM\n",
    .good =
        "PROGRAM Main\nVAR_INPUT a : BOOL; END_VAR\nVAR_OUTPUT q : BOOL; END_VAR\nIF a THEN\n  q := TRUE;\n  "
        "RETURN;\nEND_IF;\nq := FALSE;\nEND_PROGRAM\n",
    .exampleCpu = "IEC-4K",
    .peers = "SA0001",
    .dialects = dialect::Iec,
    .surplus = true,
    .check = checkIec014,
};

}  // namespace rungproof
