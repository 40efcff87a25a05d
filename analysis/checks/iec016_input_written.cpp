// IEC016: a block that writes its own input. Tested by its examples and tests/rules/iec_rules_test.cpp.
#include <fmt/format.h>

#include "analysis/flow/facts.hpp"
#include "analysis/flow/variable_uses.hpp"
#include "analysis/rule.hpp"

namespace rungproof {

namespace {

void checkIec016(const Facts& facts, FindingSink& sink) {
  const iec::VariableUses& uses = facts.variableUses();
  for (const iec::DeclaredVariable& row : uses.all()) {
    const std::string& address = row.variable->address;
    const bool isTerminal = address.size() > 1 && (address[1] == 'I' || address[1] == 'i');
    const bool isInput = row.variable->section == iec::Section::Input;
    if (!isInput && !isTerminal) continue;
    for (const iec::VariableUse& use : row.uses) {
      if (!use.writes || (isInput && use.block != row.block)) continue;
      Finding& finding =
          iec::reportOn(sink, row, use.span, fmt::format("{} is an input, and is written here", row.variable->name));
      finding.related.push_back({row.variable->span, "it is declared here"});
      finding.help = "work on a variable of its own";
    }
  }
}

}  // namespace

extern constexpr Rule iec016_input_written = {
    .id = "IEC016",
    .title = "Input written",
    .severity = Severity::Warning,
    .needs = Needs::Flow,
    .detects = "an assignment to an input of the own block, or to a variable at an input address",
    .why =
        "the next call, or the next reading of the terminals, overwrites it, and until then the program works with a "
        "value that nobody gave",
    .bad =
        "PROGRAM Main\nVAR_INPUT Start : BOOL; END_VAR\nVAR_OUTPUT Run : BOOL; END_VAR\nRun := Start;\nStart := "
        "FALSE;\nEND_PROGRAM\n",
    .good =
        "PROGRAM Main\nVAR_INPUT Start : BOOL; END_VAR\nVAR_OUTPUT Run : BOOL; END_VAR\nRun := Start;\nEND_PROGRAM\n",
    .exampleCpu = "IEC-4K",
    .peers = "SA0037",
    .dialects = dialect::Iec,
    .check = checkIec016,
};

}  // namespace rungproof
