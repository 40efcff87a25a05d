// IEC018: a BOOL that statements only ever make TRUE, or only FALSE. Tested by its examples and
// tests/rules/iec_rules_test.cpp.
#include <fmt/format.h>

#include <optional>

#include "analysis/flow/facts.hpp"
#include "analysis/flow/variable_uses.hpp"
#include "analysis/rule.hpp"

namespace rungproof {

namespace {

std::optional<bool> literalBool(const iec::Expr* expr) {
  if (expr == nullptr) return std::nullopt;
  const bool isName = expr->kind == iec::ExprKind::Path && expr->parts.size() == 1;
  if (!isName && expr->kind != iec::ExprKind::Literal) return std::nullopt;
  const std::string text = iec::foldedName(isName ? expr->parts[0].name : expr->text);
  if (text == "TRUE" || text == "1") return true;
  if (text == "FALSE" || text == "0") return false;
  return std::nullopt;
}

void checkIec018(const Facts& facts, FindingSink& sink) {
  const iec::VariableUses& uses = facts.variableUses();
  for (const iec::DeclaredVariable& row : uses.all()) {
    const iec::VariableSyntax& variable = *row.variable;
    const bool isBool = variable.type != nullptr && variable.type->form == iec::TypeForm::Named &&
                        iec::foldedName(variable.type->name) == "BOOL";
    const bool isOwn = variable.section == iec::Section::Local || variable.section == iec::Section::Output ||
                       variable.section == iec::Section::Global;
    if (!isBool || !isOwn || !row.isWritten()) continue;
    std::optional<bool> only;
    bool isMixed = false;
    Span first{};
    for (const iec::VariableUse& use : row.uses) {
      if (!use.writes) continue;
      const std::optional<bool> value = literalBool(use.value);
      if (!only) first = use.span;
      isMixed = isMixed || !value || (only && *only != *value);
      only = value;
    }
    if (isMixed || !only) continue;
    Finding& finding = sink.report(first, *only ? fmt::format("{} is made TRUE and never FALSE again", variable.name)
                                                : fmt::format("{} is only ever made FALSE", variable.name));
    finding.address = variable.name;
    if (row.block != nullptr) finding.pou = row.block->name;
    finding.related.push_back({variable.span, "it is declared here"});
    finding.help = *only ? "reset it where its cause ends" : "set it somewhere, or remove it";
  }
}

}  // namespace

extern constexpr Rule iec018_one_value_only = {
    .id = "IEC018",
    .title = "Latch with one hand",
    .severity = Severity::Warning,
    .needs = Needs::Flow,
    .detects = "a BOOL variable whose assignments all give TRUE, or all give FALSE",
    .why = "once set it stays set until the controller restarts, or it never becomes TRUE at all",
    .bad =
        "PROGRAM Main\nVAR_INPUT Trip : BOOL; END_VAR\nVAR_OUTPUT Alarm : BOOL; END_VAR\nIF Trip THEN Alarm := TRUE; "
        "END_IF;\nEND_PROGRAM\n",
    .good =
        "PROGRAM Main\nVAR_INPUT Trip, Ack : BOOL; END_VAR\nVAR_OUTPUT Alarm : BOOL; END_VAR\nIF Trip THEN Alarm := "
        "TRUE; END_IF;\nIF Ack THEN Alarm := FALSE; END_IF;\nEND_PROGRAM\n",
    .exampleCpu = "IEC-4K",
    .falsePositives = "a bit that marks the end of the first scan, or that a panel resets: silence the line",
    .dialects = dialect::Iec,
    .check = checkIec018,
};

}  // namespace rungproof
