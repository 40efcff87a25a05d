// IEC002: a variable that no statement reads, writes or calls. Tested by its examples and
// tests/rules/iec_rules_test.cpp.
#include <fmt/format.h>

#include "analysis/flow/facts.hpp"
#include "analysis/flow/variable_uses.hpp"
#include "analysis/rule.hpp"

namespace rungproof {

namespace {

std::string_view kindOf(const iec::DeclaredVariable& row) {
  if (row.block == nullptr) return "global variable";
  switch (row.variable->section) {
    case iec::Section::Input: return "input";
    case iec::Section::Output: return "output";
    case iec::Section::InOut: return "in-out parameter";
    case iec::Section::External: return "external variable";
    default: return row.variable->isConstant ? "constant" : "variable";
  }
}

void checkIec002(const Facts& facts, FindingSink& sink) {
  const iec::VariableUses& uses = facts.variableUses();
  for (const iec::DeclaredVariable& row : uses.all()) {
    // Terminals are declared as they are wired; what a program offers is for others.
    const bool isOffered =
        row.block != nullptr && row.block->kind == iec::BlockKind::Program &&
        (row.variable->section == iec::Section::Input || row.variable->section == iec::Section::Output);
    if (!row.uses.empty() || !row.variable->address.empty() || isOffered || uses.isAskedFor(*row.variable)) continue;
    Finding& finding = iec::reportOn(sink, row, row.variable->span,
                                     fmt::format("{} {} is never used", kindOf(row), row.variable->name));
    finding.help = "remove the declaration, or use it";
  }
}

}  // namespace

extern constexpr Rule iec002_unused_variable = {
    .id = "IEC002",
    .title = "Variable never used",
    .severity = Severity::Note,
    .needs = Needs::Flow,
    .detects =
        "a declared variable that no statement reads, writes or calls; terminals and the pins of programs excepted",
    .why = "it is a leftover, or its name is misspelt where it should be used",
    .bad =
        "PROGRAM Main\nVAR_INPUT Start : BOOL; END_VAR\nVAR Count : INT; END_VAR\nVAR_OUTPUT Run : BOOL; END_VAR\nRun "
        ":= Start;\nEND_PROGRAM\n",
    .good =
        "PROGRAM Main\nVAR_INPUT Start : BOOL; END_VAR\nVAR_OUTPUT Run : BOOL; END_VAR\nRun := Start;\nEND_PROGRAM\n",
    .exampleCpu = "IEC-4K",
    .peers = "SA0033",
    .dialects = dialect::Iec,
    .surplus = true,
    .check = checkIec002,
};

}  // namespace rungproof
