// IEC019: a function or function block that nobody calls. Tested by its examples and tests/rules/iec_rules_test.cpp.
#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "analysis/flow/facts.hpp"
#include "analysis/flow/variable_uses.hpp"
#include "analysis/rule.hpp"

namespace rungproof {

namespace {

void checkIec019(const Facts& facts, FindingSink& sink) {
  const iec::VariableUses& uses = facts.variableUses();
  // A project without a program is a library.
  const auto isProgram = [](const iec::BlockSyntax& block) { return block.kind == iec::BlockKind::Program; };
  if (std::ranges::none_of(uses.project().blocks, isProgram)) return;
  if (std::ranges::any_of(uses.project().blocks,
                          [](const iec::BlockSyntax& block) { return !block.isWhole || !block.unread.empty(); }))
    return;
  std::set<std::string> used;
  const auto ofType = [&](const iec::TypeSyntax* type) {
    while (type != nullptr) {
      used.insert(iec::foldedName(type->name));
      for (const iec::VariableSyntax& field : type->fields) {
        if (field.type != nullptr) used.insert(iec::foldedName(field.type->name));
      }
      type = type->element.get();
    }
  };
  for (const iec::NamedType& type : uses.project().types) ofType(type.type.get());
  for (const iec::VariableSyntax& global : uses.project().globals) ofType(global.type.get());
  for (const iec::BlockSyntax& block : uses.project().blocks) {
    for (const iec::VariableSyntax& variable : block.variables) ofType(variable.type.get());
    iec::eachStatementOf(block, [&](const iec::Statement& one, const iec::Statements&, std::size_t) {
      iec::eachExpression(one, [&](const iec::Expr& expr) {
        if (expr.kind == iec::ExprKind::Call && !expr.parts.empty() &&
            iec::foldedName(expr.parts[0].name) != iec::foldedName(block.name))
          used.insert(iec::foldedName(expr.parts[0].name));
      });
    });
  }
  iec::eachOwnBlock(uses.project(), [&](const iec::BlockSyntax& block) {
    if (block.kind == iec::BlockKind::Program || used.contains(iec::foldedName(block.name))) return;
    Finding& finding = sink.report(
        block.span, fmt::format("{} {} is never used",
                                block.kind == iec::BlockKind::Function ? "function" : "function block", block.name));
    finding.address = block.name;
    finding.help = "remove it, or call it";
  });
}

}  // namespace

extern constexpr Rule iec019_block_never_used = {
    .id = "IEC019",
    .title = "Function or function block never used",
    .severity = Severity::Note,
    .needs = Needs::Flow,
    .detects = "a function that nobody calls, a function block without an instance, in a project that has a program",
    .why = "it is a leftover, or the call of it was forgotten",
    .bad =
        "PROGRAM Main\nVAR_INPUT a : BOOL; END_VAR\nVAR_OUTPUT q : BOOL; END_VAR\nq := a;\nEND_PROGRAM\nFUNCTION "
        "Inverse : BOOL\nVAR_INPUT x : BOOL; END_VAR\nInverse := NOT x;\nEND_FUNCTION\n",
    .good =
        "PROGRAM Main\nVAR_INPUT a : BOOL; END_VAR\nVAR_OUTPUT q : BOOL; END_VAR\nq := "
        "Inverse(a);\nEND_PROGRAM\nFUNCTION Inverse : BOOL\nVAR_INPUT x : BOOL; END_VAR\nInverse := NOT "
        "x;\nEND_FUNCTION\n",
    .exampleCpu = "IEC-4K",
    .dialects = dialect::Iec,
    .surplus = true,
    .check = checkIec019,
};

}  // namespace rungproof
