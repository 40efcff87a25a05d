// IEC015: the counter of a FOR that its body writes. Tested by its examples and tests/rules/iec_rules_test.cpp.
#include <fmt/format.h>

#include "analysis/flow/facts.hpp"
#include "analysis/flow/variable_uses.hpp"
#include "analysis/rule.hpp"

namespace rungproof {

namespace {

void checkIec015(const Facts& facts, FindingSink& sink) {
  const iec::VariableUses& uses = facts.variableUses();
  const auto nameOf = [](const iec::Expr* path) {
    const bool isName = path != nullptr && path->kind == iec::ExprKind::Path && path->parts.size() == 1;
    return isName ? iec::foldedName(path->parts[0].name) : std::string();
  };
  iec::eachOwnStatement(
      uses.project(), [&](const iec::BlockSyntax&, const iec::Statement& loop, const iec::Statements&, std::size_t) {
        const std::string counter = loop.kind == iec::StatementKind::For ? nameOf(loop.target.get()) : "";
        if (counter.empty()) return;
        iec::eachStatement(loop.otherwise, [&](const iec::Statement& one, const iec::Statements&, std::size_t) {
          const bool writes = one.kind == iec::StatementKind::Assign || one.kind == iec::StatementKind::For;
          if (!writes || nameOf(one.target.get()) != counter) return;
          Finding& finding = sink.report(one.target->span,
                                         fmt::format("the loop writes its own counter {}", loop.target->parts[0].name));
          finding.address = loop.target->parts[0].name;
          finding.related.push_back({loop.target->span, "the counter of this loop"});
          finding.help = "leave the loop with EXIT, or use WHILE";
        });
      });
}

}  // namespace

extern constexpr Rule iec015_loop_counter_written = {
    .id = "IEC015",
    .title = "Counter of a FOR written in its loop",
    .severity = Severity::Warning,
    .needs = Needs::Text,
    .detects = "an assignment to the counter of a FOR inside of it, or an inner FOR with the same counter",
    .why = "the standard forbids it: some controllers go on from the new value, some for ever",
    .bad =
        "PROGRAM Main\nVAR i : INT; END_VAR\nVAR_OUTPUT n : INT; END_VAR\nFOR i := 1 TO 10 DO\n  n := n + 1;\n  IF n > "
        "5 THEN i := 10; END_IF;\nEND_FOR;\nEND_PROGRAM\n",
    .good =
        "PROGRAM Main\nVAR i : INT; END_VAR\nVAR_OUTPUT n : INT; END_VAR\nFOR i := 1 TO 10 DO\n  n := n + 1;\n  IF n > "
        "5 THEN EXIT; END_IF;\nEND_FOR;\nEND_PROGRAM\n",
    .exampleCpu = "IEC-4K",
    .peers = "SA0072",
    .dialects = dialect::Iec,
    .check = checkIec015,
};

}  // namespace rungproof
