// IEC004: a local variable that is written and never read. Tested by its examples and tests/rules/iec_rules_test.cpp.
#include <fmt/format.h>

#include "analysis/flow/facts.hpp"
#include "analysis/flow/variable_uses.hpp"
#include "analysis/rule.hpp"

namespace rungproof {

namespace {

void checkIec004(const Facts& facts, FindingSink& sink) {
  const iec::VariableUses& uses = facts.variableUses();
  for (const iec::DeclaredVariable& row : uses.all()) {
    const iec::Section section = row.variable->section;
    const bool isLocal = row.block != nullptr && (section == iec::Section::Local || section == iec::Section::Temp);
    if (!isLocal || !row.variable->address.empty() || !row.isWritten() || row.isRead() || row.isCalled()) continue;
    if (uses.blockOf(*row.variable) != nullptr || uses.isAskedFor(*row.variable)) continue;
    Finding& finding =
        iec::reportOn(sink, row, row.variable->span, fmt::format("{} is written, but never read", row.variable->name));
    finding.related.push_back({row.uses.front().span, "it is written here"});
    finding.help = "remove it, or use its value; declare it VAR_OUTPUT if others read it";
  }
}

}  // namespace

extern constexpr Rule iec004_never_read = {
    .id = "IEC004",
    .title = "Variable written but never read",
    .severity = Severity::Note,
    .needs = Needs::Flow,
    .detects = "a local variable that statements write and none reads",
    .why = "its value is worked out for nothing, or the name is misspelt where it should be read",
    .bad =
        "PROGRAM Main\nVAR_INPUT Start : BOOL; END_VAR\nVAR Count : INT; END_VAR\nVAR_OUTPUT Run : BOOL; "
        "END_VAR\nCount := Count_Of(Start);\nRun := Start;\nEND_PROGRAM\nFUNCTION Count_Of : INT\nVAR_INPUT x : BOOL; "
        "END_VAR\nCount_Of := BOOL_TO_INT(x);\nEND_FUNCTION\n",
    .good =
        "PROGRAM Main\nVAR_INPUT Start : BOOL; END_VAR\nVAR Count : INT; END_VAR\nVAR_OUTPUT Run : BOOL; "
        "END_VAR\nCount := BOOL_TO_INT(Start);\nRun := Count > 0;\nEND_PROGRAM\n",
    .exampleCpu = "IEC-4K",
    .falsePositives = "a value that only a panel shows: declare it VAR_OUTPUT",
    .peers = "SA0033",
    .dialects = dialect::Iec,
    .surplus = true,
    .check = checkIec004,
};

}  // namespace rungproof
