// TIM010: = or <> on the value of a timer or counter. Comparison with 0 (at rest) is sound. A counter moves by one at
// each execution and stands in between, so for counters it is only a note; fast counters run on between two scans.
// Tested by its examples and tests/rules/timer_rules_test.cpp.
#include <fmt/format.h>

#include <algorithm>

#include "analysis/flow/facts.hpp"
#include "analysis/rule.hpp"

namespace rungproof {

namespace {

bool isEquality(const Desc& desc) {
  return desc.execution == Execution::Compare &&
         (desc.relation == Relation::Equal || desc.relation == Relation::NotEqual);
}

void checkTim010(const Facts& facts, FindingSink& sink) {
  for (const InstructionPlace& place : facts.placesOf(isEquality)) {
    const Instruction& instruction = *place.instruction;
    if (!isEquality(*instruction.desc)) continue;
    const bool isWithZero = std::any_of(instruction.operands.begin(), instruction.operands.end(), [](const Operand& o) {
      return o.kind == OperandKind::Constant && o.value == 0;
    });
    if (isWithZero) continue;
    for (const Operand& o : instruction.operands) {
      if (o.kind != OperandKind::Direct || (!hasBitAndWord(o.area) && o.area != Area::HC)) continue;
      const std::string_view what = o.area == Area::T ? "timer" : o.area == Area::C ? "counter" : "fast counter";
      Finding& finding =
          sink.report(instruction.span, fmt::format("{} compares the running value of {} {} for equality",
                                                    Facts::text(instruction), what, facts.name(o)));
      if (o.area == Area::C) finding.severity = Severity::Note;
      finding.address = toString(o);
      finding.help = "use >= or <=; the value may pass the number between two scans (001:6607-6611)";
      break;
    }
  }
}

}  // namespace

extern constexpr Rule tim010_equality_on_running_value = {
    .id = "TIM010",
    .title = "Equality on a running value",
    .severity = Severity::Warning,
    .needs = Needs::Text,
    .detects = "a comparison = or <> on the value of a timer, counter or fast counter, other than with 0",
    .why = "the value may jump over the number between two scans",
    .manual = "001:6607-6611",
    .bad = "Network 1\nLD I0.0\nTON T33, +100\nNetwork 2\nLDW= T33, +40\n= Q0.0\n",
    .good = "Network 1\nLD I0.0\nTON T33, +100\nNetwork 2\nLDW>= T33, +40\n= Q0.0\n",
    .falsePositives = "a counter whose box runs in every scan moves by one at a time: reported as a note",
    .peers = "CP28; Frama-PLC E2.1",
    .dialects = dialect::S7200,
    .check = checkTim010,
};

}  // namespace rungproof
