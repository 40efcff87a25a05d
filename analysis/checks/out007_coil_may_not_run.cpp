// OUT007: a coil in code that is left out in some scans. One finding for each jump, step or block, at its first coil.
// Tested by its examples and tests/rules/output_rules_test.cpp.
#include <fmt/format.h>

#include "analysis/flow/skipped_code.hpp"
#include "analysis/rule.hpp"

namespace rungproof {

namespace {

bool isCoilOfMemory(const Instruction& instruction) {
  return isCoil(roleOf(instruction)) && !instruction.operands.empty() && instruction.operands[0].area != Area::L;
}

void checkOut007(const Facts& facts, FindingSink& sink) {
  for (const SkippedCode& coils : skippedCode(facts, isCoilOfMemory)) {
    const Operand& coil = coils.first->operands[0];
    const std::string more = coils.count == 1 ? std::string() : fmt::format(", with {} other coils", coils.count - 1);
    Finding& finding =
        sink.report(coils.first->span, fmt::format("{} keeps its last value while the coil is left out{}: {}",
                                                   facts.name(coil), more, causeText(facts, coils)));
    finding.address = toString(coil);
    if (coils.cause != nullptr) finding.related.push_back({coils.cause->span, "this decides whether the coil runs"});
    finding.help =
        "reset the bit where the code is left out, or drive it from code that always runs; what coils do in an "
        "inactive step is an open point of the manual";
  }
}

/// A jump or a return that never comes to pass.
constexpr Explanation out007Explained[] = {{"LOG001", Where::RelatedPlace, powerReaches}};

}  // namespace

extern constexpr Rule out007_coil_may_not_run = {
    .id = "OUT007",
    .title = "Coil in code that may not run",
    .severity = Severity::Note,
    .needs = Needs::Flow,
    .detects =
        "= inside a range that a jump may skip, in a subroutine called on a condition, behind a conditional return, or "
        "in an SCR segment",
    .why = "the bit freezes at its last value; what coils do in an inactive SCR segment is not in the manual text",
    .manual = "001:5782, 001:6735, 001:5830",
    .bad = "Network 1\nLD I0.0\nJMP 1\nNetwork 2\nLD I0.1\n= Q0.0\nNetwork 3\nLBL 1\n",
    .good = "Network 1\nLDN I0.0\nA I0.1\n= Q0.0\n",
    .falsePositives = "outputs that are meant to hold",
    .peers = "SA0022 (nearest)",
    .dialects = dialect::S7200,
    .check = checkOut007,
    .explainedBy = out007Explained,
};

}  // namespace rungproof
