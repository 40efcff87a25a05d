// IEC007: an instance of a block whose outputs are used and that nothing calls. Tested by its examples and
// tests/rules/iec_rules_test.cpp.
#include <fmt/format.h>

#include "analysis/flow/facts.hpp"
#include "analysis/flow/variable_uses.hpp"
#include "analysis/rule.hpp"

namespace rungproof {

namespace {

void checkIec007(const Facts& facts, FindingSink& sink) {
  const iec::VariableUses& uses = facts.variableUses();
  for (const iec::DeclaredVariable& row : uses.all()) {
    const iec::BlockSyntax* of = uses.blockOf(*row.variable);
    const bool isGiven =
        row.variable->section == iec::Section::InOut || row.variable->section == iec::Section::External;
    if (of == nullptr || isGiven || row.uses.empty() || row.isCalled()) continue;
    // Given to another block as a whole, which may call it.
    bool isHandedOn = false;
    for (const iec::VariableUse& use : row.uses) isHandedOn = isHandedOn || use.isWhole;
    if (isHandedOn) continue;
    Finding& finding =
        iec::reportOn(sink, row, row.variable->span,
                      fmt::format("{}, an instance of {}, is never called", row.variable->name, of->name));
    finding.related.push_back({row.uses.front().span, "it is used here"});
    finding.help = fmt::format("call it in every scan: {}(...);", row.variable->name);
  }
}

}  // namespace

extern constexpr Rule iec007_instance_not_called = {
    .id = "IEC007",
    .title = "Instance never called",
    .severity = Severity::Warning,
    .needs = Needs::Flow,
    .detects = "an instance of a function block whose pins are used although nothing calls it",
    .why = "its outputs keep their initial values: a timer never elapses, an edge is never seen",
    .bad =
        "PROGRAM Main\nVAR_INPUT Start : BOOL; END_VAR\nVAR Delay : TON; END_VAR\nVAR_OUTPUT Run : BOOL; END_VAR\nRun "
        ":= Start AND Delay.Q;\nEND_PROGRAM\n",
    .good =
        "PROGRAM Main\nVAR_INPUT Start : BOOL; END_VAR\nVAR Delay : TON; END_VAR\nVAR_OUTPUT Run : BOOL; "
        "END_VAR\nDelay(IN := Start, PT := T#5s);\nRun := Start AND Delay.Q;\nEND_PROGRAM\n",
    .exampleCpu = "IEC-4K",
    .dialects = dialect::Iec,
    .check = checkIec007,
};

}  // namespace rungproof
