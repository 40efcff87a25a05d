// IEC003: a variable that is read and that nothing ever writes. Tested by its examples and
// tests/rules/iec_rules_test.cpp.
#include <fmt/format.h>

#include "analysis/flow/facts.hpp"
#include "analysis/flow/variable_uses.hpp"
#include "analysis/rule.hpp"

namespace rungproof {

namespace {

/// Others write the pins, terminals and what is external; of a global variable nobody knows who writes it.
bool isOwn(const iec::DeclaredVariable& row) {
  const iec::Section section = row.variable->section;
  return row.block != nullptr && (section == iec::Section::Local || section == iec::Section::Temp) &&
         row.variable->address.empty() && !row.variable->isConstant;
}

void checkIec003(const Facts& facts, FindingSink& sink) {
  const iec::VariableUses& uses = facts.variableUses();
  for (const iec::DeclaredVariable& row : uses.all()) {
    if (!isOwn(row) || !row.isRead() || row.isWritten() || uses.blockOf(*row.variable) != nullptr) continue;
    if (row.isCalled()) continue;
    const bool isGiven = row.variable->initial != nullptr;
    Finding& finding =
        iec::reportOn(sink, row, row.variable->span, fmt::format("{} is read, but never written", row.variable->name));
    if (isGiven) finding.severity = Severity::Note;
    for (const iec::VariableUse& use : row.uses) {
      if (!use.reads) continue;
      finding.related.push_back({use.span, "it is read here"});
      break;
    }
    finding.help = isGiven ? "declare it in VAR CONSTANT if that is meant"
                           : "it keeps its initial value: write it, or declare it in VAR CONSTANT";
  }
}

}  // namespace

extern constexpr Rule iec003_never_written = {
    .id = "IEC003",
    .title = "Variable read but never written",
    .severity = Severity::Warning,
    .needs = Needs::Flow,
    .detects = "a local variable that statements read and none writes; a note if it has an initial value of its own",
    .why = "it keeps its initial value for ever, so that conditions on it never change",
    .bad =
        "PROGRAM Main\nVAR_INPUT Start : BOOL; END_VAR\nVAR Ready : BOOL; END_VAR\nVAR_OUTPUT Run : BOOL; END_VAR\nRun "
        ":= Start AND Ready;\nEND_PROGRAM\n",
    .good =
        "PROGRAM Main\nVAR_INPUT Start, Guard : BOOL; END_VAR\nVAR Ready : BOOL; END_VAR\nVAR_OUTPUT Run : BOOL; "
        "END_VAR\nReady := Guard;\nRun := Start AND Ready;\nEND_PROGRAM\n",
    .exampleCpu = "IEC-4K",
    .falsePositives = "a panel or another station that writes the variable by its name: declare it VAR_INPUT",
    .dialects = dialect::Iec,
    .check = checkIec003,
};

}  // namespace rungproof
