// TIM010: = or <> on the value of a timer or counter. Comparison with 0 (at rest) is sound. A counter moves by one at
// each execution and stands in between, so for counters it is only a note; fast counters run on between two scans.
// Tested by its examples, tests/rules/timer_rules_test.cpp and tests/rules/step7_timer_rules_test.cpp.
#include <fmt/format.h>

#include <algorithm>

#include "analysis/flow/facts.hpp"
#include "analysis/flow/statement_paths.hpp"
#include "analysis/flow/step7_blocks.hpp"
#include "analysis/rule.hpp"

namespace rungproof {

namespace {

bool isEquality(const Desc& desc) {
  return desc.execution == Execution::Compare &&
         (desc.relation == Relation::Equal || desc.relation == Relation::NotEqual);
}

/// Tells of the comparison if the operand is the value of a timer, counter or fast counter.
bool tellsOf(const Facts& facts, const Instruction& comparison, const Operand& o, FindingSink& sink) {
  if (o.kind != OperandKind::Direct || (!hasBitAndWord(o.area) && o.area != Area::HC)) return false;
  const std::string_view what = o.area == Area::T ? "timer" : o.area == Area::C ? "counter" : "fast counter";
  Finding& finding = sink.report(comparison.span, fmt::format("{} compares the running value of {} {} for equality",
                                                              Facts::text(comparison), what, facts.name(o)));
  if (o.area == Area::C) finding.severity = Severity::Note;
  finding.address = toString(o);
  finding.help = facts.form() == StatementForm::Accumulators
                     ? "use >=I or <=I; the value may pass the number between two scans (003:1020)"
                     : "use >= or <=; the value may pass the number between two scans (001:6607-6611)";
  return true;
}

bool isZero(const Operand& o) { return o.kind == OperandKind::Constant && o.value == 0; }

/// S7-300/400: L or LC of the element in front of ==I, <>I, ==D or <>D.
void checkLoads(const Facts& facts, FindingSink& sink) {
  eachOwnBlock(facts, [&](std::uint32_t, const Flow& flow) {
    for (std::uint32_t at = 0; at < flow.steps.size(); ++at) {
      const Instruction& comparison = *flow.steps[at].instruction;
      if (!comparesForEquality(comparison)) continue;
      const LoadsBefore loads = loadsBefore(flow, at);
      if (loads.accu1 == nullptr || loads.accu2 == nullptr) continue;
      const Operand& first = loads.accu2->operands[0];
      const Operand& second = loads.accu1->operands[0];
      if (isZero(first) || isZero(second)) continue;
      if (!tellsOf(facts, comparison, first, sink)) tellsOf(facts, comparison, second, sink);
    }
  });
}

void checkTim010(const Facts& facts, FindingSink& sink) {
  if (facts.form() == StatementForm::Accumulators) return checkLoads(facts, sink);
  for (const InstructionPlace& place : facts.placesOf(isEquality)) {
    const Instruction& instruction = *place.instruction;
    if (!isEquality(*instruction.desc)) continue;
    if (std::ranges::any_of(instruction.operands, isZero)) continue;
    for (const Operand& o : instruction.operands) {
      if (tellsOf(facts, instruction, o, sink)) break;
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
    .manual = "001:6607-6611, 003:1020",
    .bad = "Network 1\nLD I0.0\nTON T33, +100\nNetwork 2\nLDW= T33, +40\n= Q0.0\n",
    .good = "Network 1\nLD I0.0\nTON T33, +100\nNetwork 2\nLDW>= T33, +40\n= Q0.0\n",
    .falsePositives = "a counter whose box runs in every scan moves by one at a time: reported as a note",
    .peers = "CP28; Frama-PLC E2.1",
    .check = checkTim010,
};

}  // namespace rungproof
