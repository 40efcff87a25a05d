// CTL008: a LOOP whose count may be 0, which makes 65,536 rounds.
// Tested by its examples and tests/rules/step7_control_rules_test.cpp.
#include <fmt/format.h>

#include "analysis/flow/statement_paths.hpp"
#include "analysis/flow/step7_blocks.hpp"
#include "analysis/rule.hpp"

namespace rungproof {

namespace {

enum class CountStart : std::uint8_t { Known, MayBeZero, Zero };

/// Where the count comes from that stands in ACCU1 at the label, looking back along the text. A conditional jump
/// between it and the label is taken for the question whether it is 0.
CountStart countAt(const Flow& flow, std::uint32_t label, const Instruction*& source) {
  for (std::uint32_t at = label; at-- > 0;) {
    const Instruction& instruction = *flow.steps[at].instruction;
    switch (statementRole(instruction)) {
      case StatementRole::JumpByRlo:
      case StatementRole::JumpKeepingRlo:
      case StatementRole::JumpByResult:
      case StatementRole::EndByRlo: return CountStart::Known;
      case StatementRole::Load: {
        source = &instruction;
        const Operand& value = instruction.operands[0];
        if (value.kind != OperandKind::Constant) return CountStart::MayBeZero;
        return (value.value & 0xFFFF) == 0 ? CountStart::Zero : CountStart::Known;
      }
      case StatementRole::Transfer:
      case StatementRole::Nothing:
      case StatementRole::OpenBlock:
      case StatementRole::LoadAr1:
      case StatementRole::LoadAr2:
      case StatementRole::Assign:
      case StatementRole::AndScan:
      case StatementRole::OrScan:
      case StatementRole::SetRlo:
      case StatementRole::ClearRlo: break;
      case StatementRole::IntegerStep:
      case StatementRole::IntegerMath: source = &instruction; return CountStart::MayBeZero;
      default: return CountStart::Known;
    }
    if (instruction.desc->control == Control::LabelMark) return CountStart::Known;
  }
  return CountStart::Known;
}

void checkCtl008(const Facts& facts, FindingSink& sink) {
  eachReadStretch(facts, [&](std::uint32_t, const Flow& flow) {
    for (const FlowStep& step : flow.steps) {
      const Instruction& instruction = *step.instruction;
      if (statementRole(instruction) != StatementRole::Loop || step.partner == noPartner) continue;
      const Instruction* source = nullptr;
      const CountStart start = countAt(flow, step.partner, source);
      if (start == CountStart::Known || source == nullptr) continue;
      if (start == CountStart::MayBeZero && statementRole(*source) == StatementRole::Load &&
          isComparedBefore(flow, step.partner, source->operands[0]))
        continue;
      Finding& finding =
          sink.report(instruction.span,
                      start == CountStart::Zero
                          ? fmt::format("{} begins with the count 0 and makes 65,536 rounds", Facts::text(instruction))
                          : fmt::format("{} makes 65,536 rounds if the count of {} is 0", Facts::text(instruction),
                                        Facts::text(*source)));
      finding.related.push_back({source->span, "the count"});
      finding.help = "test the count before the loop and jump over it where it is 0";
    }
  });
}

}  // namespace

extern constexpr Rule ctl008_loop_count = {
    .id = "CTL008",
    .title = "LOOP with a count that may be 0",
    .severity = Severity::Warning,
    .needs = Needs::Flow,
    .detects = "a loop whose count is loaded from memory or computed, and not tested before the first round",
    .why = "LOOP counts down first and asks then: 0 becomes 65535, and the scan outlasts its monitoring time",
    .manual = "002:1783-1785, 002:2809",
    .bad =
        "ORGANIZATION_BLOCK OB 1\nBEGIN\nNETWORK\nL MW 10;\nm: T MW 12;\nL MW 14;\n+ 1;\nT MW 14;\nL MW 12;\n"
        "LOOP m;\nEND_ORGANIZATION_BLOCK\n",
    .good =
        "ORGANIZATION_BLOCK OB 1\nBEGIN\nNETWORK\nL MW 10;\nL 0;\n==I;\nJC e;\nL MW 10;\nm: T MW 12;\nL MW 14;\n"
        "+ 1;\nT MW 14;\nL MW 12;\nLOOP m;\ne: NOP 0;\nEND_ORGANIZATION_BLOCK\n",
    .exampleCpu = "319-3",
    .falsePositives = "counts that are never 0 because of other parts of the program",
    .dialects = dialect::S7300,
    .check = checkCtl008,
};

}  // namespace rungproof
