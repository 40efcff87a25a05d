// IEC006: a value that is overwritten before anything can read it: two coils of one variable. Tested by its examples
// and tests/rules/iec_rules_test.cpp.
#include <fmt/format.h>

#include <map>

#include "analysis/flow/facts.hpp"
#include "analysis/flow/variable_uses.hpp"
#include "analysis/rule.hpp"

namespace rungproof {

namespace {

/// Finds, in each list of statements, whole values that a later statement of the list overwrites in every case.
class OverwrittenValues {
 public:
  OverwrittenValues(const iec::VariableUses& uses, const iec::BlockSyntax& block, FindingSink& sink)
      : uses_(uses), block_(block), sink_(sink) {}

  void list(const iec::Statements& statements) {
    std::map<const iec::DeclaredVariable*, Span> waiting;
    for (const iec::Statement& one : statements) {
      for (const iec::Branch& branch : one.branches) list(branch.body);
      list(one.otherwise);
      statement(one, waiting);
    }
  }

 private:
  using Waiting = std::map<const iec::DeclaredVariable*, Span>;

  void statement(const iec::Statement& one, Waiting& waiting) {
    const bool isAssignment = one.kind == iec::StatementKind::Assign && one.target != nullptr &&
                              one.target->kind == iec::ExprKind::Path && one.target->parts.size() == 1;
    const bool leaves = forgetRead(one, waiting, isAssignment);
    if (isAssignment) {
      const iec::DeclaredVariable* row = uses_.find(block_, one.target->parts[0].name);
      if (row == nullptr) return;
      const auto [entry, isFirst] = waiting.emplace(row, one.target->span);
      if (isFirst) return;
      report(*row, entry->second, one.target->span);
      entry->second = one.target->span;
      return;
    }
    // Where a branch can leave the list, what it has written may stay.
    if (leaves) return;
    // What a branch has written is lost too if the statement behind it writes in every case.
    iec::eachStatement(one.otherwise,
                       [&](const iec::Statement& inner, const iec::Statements&, std::size_t) { wait(inner, waiting); });
    for (const iec::Branch& branch : one.branches)
      iec::eachStatement(
          branch.body, [&](const iec::Statement& inner, const iec::Statements&, std::size_t) { wait(inner, waiting); });
  }

  void wait(const iec::Statement& inner, Waiting& waiting) {
    if (inner.kind != iec::StatementKind::Assign || inner.target == nullptr || inner.target->parts.size() != 1) return;
    if (const iec::DeclaredVariable* row = uses_.find(block_, inner.target->parts[0].name)) {
      if (!isReadInside_.contains(row)) waiting.insert_or_assign(row, inner.target->span);
    }
  }

  /// Leaves out what the statement may read, and everything where it can leave the list or call what reads others.
  /// Whether it can leave the list.
  bool forgetRead(const iec::Statement& one, Waiting& waiting, bool isAssignment) {
    isReadInside_.clear();
    bool leaves = false;
    const auto read = [&](const iec::Expr& expr) {
      if (expr.kind == iec::ExprKind::Call) forgetGlobals(waiting);
      if (expr.kind != iec::ExprKind::Path && expr.kind != iec::ExprKind::Call) return;
      if (expr.parts.empty() || (isAssignment && &expr == one.target.get())) return;
      if (const iec::DeclaredVariable* row = uses_.find(block_, expr.parts[0].name)) {
        waiting.erase(row);
        isReadInside_.emplace(row, Span{});
      }
    };
    const auto look = [&](const iec::Statement& inner) {
      using enum iec::StatementKind;
      leaves = leaves || inner.kind == Return || inner.kind == Exit || inner.kind == Continue || inner.kind == Unread;
      const bool isPlain = inner.kind == Assign && inner.target != nullptr && inner.target->parts.size() == 1;
      if (!isPlain) return iec::eachExpression(inner, read);
      if (inner.value != nullptr) iec::eachPart(*inner.value, read);
    };
    look(one);
    for (const iec::Branch& branch : one.branches)
      iec::eachStatement(branch.body,
                         [&](const iec::Statement& inner, const iec::Statements&, std::size_t) { look(inner); });
    iec::eachStatement(one.otherwise,
                       [&](const iec::Statement& inner, const iec::Statements&, std::size_t) { look(inner); });
    if (leaves) waiting.clear();
    return leaves;
  }

  static void forgetGlobals(Waiting& waiting) {
    std::erase_if(waiting, [](const auto& entry) {
      const iec::Section section = entry.first->variable->section;
      return section == iec::Section::Global || section == iec::Section::External || section == iec::Section::InOut;
    });
  }

  void report(const iec::DeclaredVariable& row, Span first, Span second) {
    Finding& finding =
        sink_.report(first, fmt::format("the value of {} is overwritten before anything reads it", row.variable->name));
    finding.address = row.variable->name;
    finding.related.push_back({second, "it is overwritten here"});
    finding.help = "the last assignment wins: put the conditions together with OR";
  }

  const iec::VariableUses& uses_;
  const iec::BlockSyntax& block_;
  FindingSink& sink_;
  std::map<const iec::DeclaredVariable*, Span> isReadInside_;  ///< by the statement at hand
};

void checkIec006(const Facts& facts, FindingSink& sink) {
  const iec::VariableUses& uses = facts.variableUses();
  iec::eachOwnBlock(uses.project(), [&](const iec::BlockSyntax& block) {
    iec::eachBody(block, [&](const iec::Statements& body) { OverwrittenValues(uses, block, sink).list(body); });
  });
}

}  // namespace

extern constexpr Rule iec006_value_overwritten = {
    .id = "IEC006",
    .title = "Value overwritten before it is read",
    .severity = Severity::Warning,
    .needs = Needs::Flow,
    .detects =
        "an assignment, or a coil, whose value another assignment of the same list overwrites in every case before a "
        "statement reads it",
    .why = "the first assignment does nothing: of two coils of one variable only the last one works",
    .bad =
        "PROGRAM Main\nVAR_INPUT Hand, Auto : BOOL; END_VAR\nVAR_OUTPUT Motor : BOOL; END_VAR\nMotor := Hand;\nMotor "
        ":= Auto;\nEND_PROGRAM\n",
    .good =
        "PROGRAM Main\nVAR_INPUT Hand, Auto : BOOL; END_VAR\nVAR_OUTPUT Motor : BOOL; END_VAR\nMotor := Hand OR "
        "Auto;\nEND_PROGRAM\n",
    .exampleCpu = "IEC-4K",
    .peers = "SA0004 (nearest)",
    .dialects = dialect::Iec,
    .check = checkIec006,
};

}  // namespace rungproof
