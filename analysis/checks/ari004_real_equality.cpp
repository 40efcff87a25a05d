// ARI004: = or <> between REAL values. Tested by its examples.
#include <fmt/format.h>

#include "analysis/flow/facts.hpp"
#include "analysis/rule.hpp"
#include "ir/s7300/statement_role.hpp"

namespace rungproof {

namespace {

void checkAri004(const Facts& facts, FindingSink& sink) {
  const bool isAny = facts.form() == StatementForm::Accumulators;  // the role of a statement says it
  const auto mayCompare = [&](const Desc& desc) { return isAny || desc.execution == Execution::Compare; };
  for (const InstructionPlace& place : facts.placesOf(mayCompare)) {
    const Instruction& instruction = *place.instruction;
    const Desc& desc = *instruction.desc;
    if (statementRole(instruction) == StatementRole::CompareRealEqual) {
      Finding& finding = sink.report(instruction.span, fmt::format("{} compares real numbers for equality", desc.stl));
      finding.help = "results are rounded to about six digits; compare with a lower and an upper limit";
      continue;
    }
    if (desc.execution != Execution::Compare || desc.operandCount == 0 || desc.operands[0].type != Type::Real) continue;
    if (desc.relation != Relation::Equal && desc.relation != Relation::NotEqual) continue;
    Finding& finding =
        sink.report(instruction.span, fmt::format("{} compares real numbers for equality", Facts::text(instruction)));
    finding.help = "results are rounded to about six digits (001:1401); compare with a lower and an upper limit";
  }
}

}  // namespace

extern constexpr Rule ari004_real_equality = {
    .id = "ARI004",
    .title = "REAL compared for equality",
    .severity = Severity::Warning,
    .needs = Needs::Text,
    .detects = "= or <> between real numbers",
    .why = "results are rounded, so two ways to the same value may differ in the last digit",
    .manual = "001:1401-1410",
    .bad = "Network 1\nLDR= VD0, 1.5\n= Q0.0\n",
    .good = "Network 1\nLDR>= VD0, 1.49\nAR<= VD0, 1.51\n= Q0.0\n",
    .falsePositives = "comparison with a value that was moved, not computed",
    .peers = "SA0054; CP8; iec-checker CP8; Frama-PLC E2.1",
    .standsAlone = true,
    .check = checkAri004,
};

}  // namespace rungproof
