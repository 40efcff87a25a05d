// IEC010: a CASE over an enumeration that leaves values out and has no ELSE. Tested by its examples and
// tests/rules/iec_rules_test.cpp.
#include <fmt/format.h>

#include <set>

#include "analysis/flow/facts.hpp"
#include "analysis/flow/variable_uses.hpp"
#include "analysis/rule.hpp"

namespace rungproof {

namespace {

/// The enumeration that the selector has, or nullptr.
const iec::TypeSyntax* enumerationOf(const iec::VariableUses& uses, const iec::BlockSyntax& block,
                                     const iec::Expr& selector) {
  if (selector.kind != iec::ExprKind::Path || selector.parts.size() != 1) return nullptr;
  const iec::DeclaredVariable* row = uses.find(block, selector.parts[0].name);
  if (row == nullptr || row->variable->type == nullptr) return nullptr;
  const iec::TypeSyntax* type = uses.typeBehind(*row->variable->type);
  return type != nullptr && type->form == iec::TypeForm::Enum ? type : nullptr;
}

void checkIec010(const Facts& facts, FindingSink& sink) {
  const iec::VariableUses& uses = facts.variableUses();
  iec::eachOwnStatement(uses.project(), [&](const iec::BlockSyntax& block, const iec::Statement& one,
                                            const iec::Statements&, std::size_t) {
    if (one.kind != iec::StatementKind::Case || one.hasElse || one.value == nullptr) return;
    const iec::TypeSyntax* type = enumerationOf(uses, block, *one.value);
    if (type == nullptr) return;
    std::set<std::string> named;
    for (const iec::Branch& branch : one.branches) {
      for (const iec::CaseLabel& label : branch.labels) {
        // A range of enumerators, or a label that is no enumerator: not counted.
        const iec::Expr* low = label.high == nullptr ? label.low.get() : nullptr;
        if (low != nullptr && low->kind == iec::ExprKind::Path && !low->parts.empty())
          named.insert(iec::foldedName(low->parts.back().name));
        else if (low != nullptr && low->kind == iec::ExprKind::Literal && !low->prefix.empty())  // State#Idle
          named.insert(iec::foldedName(low->text));
        else
          return;
      }
    }
    std::string missing;
    for (const auto& [name, value] : type->items) {
      if (!named.contains(iec::foldedName(name))) missing += (missing.empty() ? "" : ", ") + name;
    }
    if (missing.empty()) return;
    Finding& finding = sink.report(one.value->span, fmt::format("the CASE does nothing for {}", missing));
    finding.help = "add what is missing, or an ELSE";
  });
}

}  // namespace

extern constexpr Rule iec010_case_leaves_out = {
    .id = "IEC010",
    .title = "CASE leaves out values of its enumeration",
    .severity = Severity::Warning,
    .needs = Needs::Flow,
    .detects = "a CASE without ELSE whose selector is an enumeration and whose labels do not name all of its values",
    .why = "in a state that is left out the machine does nothing, and a new state is easily forgotten",
    .bad =
        "TYPE State : (Idle, Filling, Draining); END_TYPE\nPROGRAM Main\nVAR_INPUT Start : BOOL; END_VAR\nVAR Now : "
        "State; END_VAR\nVAR_OUTPUT Valve : BOOL; END_VAR\nCASE Now OF\n  Idle: IF Start THEN Now := Filling; "
        "END_IF;\n  Filling: Valve := TRUE; Now := Draining;\nEND_CASE;\nEND_PROGRAM\n",
    .good =
        "TYPE State : (Idle, Filling, Draining); END_TYPE\nPROGRAM Main\nVAR_INPUT Start : BOOL; END_VAR\nVAR Now : "
        "State; END_VAR\nVAR_OUTPUT Valve : BOOL; END_VAR\nCASE Now OF\n  Idle: IF Start THEN Now := Filling; "
        "END_IF;\n  Filling: Valve := TRUE; Now := Draining;\n  Draining: Valve := FALSE; Now := "
        "Idle;\nEND_CASE;\nEND_PROGRAM\n",
    .exampleCpu = "IEC-4K",
    .peers = "SA0076",
    .dialects = dialect::Iec,
    .check = checkIec010,
};

}  // namespace rungproof
