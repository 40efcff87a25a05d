// CTL011: a LOOP that does not count down the number of its rounds.
// Tested by its examples and tests/rules/step7_control_rules_test.cpp.
#include <fmt/format.h>

#include "analysis/flow/statement_paths.hpp"
#include "analysis/flow/step7_blocks.hpp"
#include "analysis/rule.hpp"

namespace rungproof {

namespace {

/// The store of the count right behind the label, if there is one.
const Instruction* storeAtLabel(const Flow& flow, std::uint32_t label, std::uint32_t loop) {
  for (std::uint32_t at = label; at < loop; ++at) {
    const Instruction& instruction = *flow.steps[at].instruction;
    const StatementRole role = statementRole(instruction);
    if (role == StatementRole::Transfer && !instruction.operands.empty()) return &instruction;
    if (role != StatementRole::Nothing && instruction.desc->control != Control::LabelMark) return nullptr;
  }
  return nullptr;
}

bool isStoredBetween(const Flow& flow, std::uint32_t from, std::uint32_t until, const std::string& place) {
  for (std::uint32_t at = from; at < until; ++at) {
    const Instruction& instruction = *flow.steps[at].instruction;
    const bool isStore = statementRole(instruction) == StatementRole::Transfer && !instruction.operands.empty();
    if (isStore && toString(instruction.operands[0]) == place) return true;
    if (statementRole(instruction) == StatementRole::Call) return true;  // it may store there
  }
  return false;
}

/// Why the rounds of the loop are not counted; empty: they are, or it is not known.
std::string countFaultOf(const Flow& flow, std::uint32_t loop, std::uint32_t label) {
  bool keepsCount = true;
  for (std::uint32_t at = label; at < loop; ++at) {
    const Instruction& instruction = *flow.steps[at].instruction;
    const bool isMark = instruction.desc->control == Control::LabelMark;
    keepsCount = keepsCount && (isMark || keepsAccus(statementRole(instruction)));
  }
  if (keepsCount) return {};
  const Instruction* load = nullptr;
  for (std::uint32_t at = loop; at-- > label && load == nullptr;) {
    const Instruction& instruction = *flow.steps[at].instruction;
    if (statementRole(instruction) == StatementRole::Load) load = &instruction;
    if (load == nullptr && !keepsAccus(statementRole(instruction))) break;
  }
  const Instruction* store = storeAtLabel(flow, label, loop);
  if (load != nullptr && load->operands[0].kind == OperandKind::Constant)
    return fmt::format("{} gives it the same number in every round", Facts::text(*load));
  if (load != nullptr) {
    const std::string place = toString(load->operands[0]);
    return isStoredBetween(flow, label, loop, place)
               ? std::string()
               : fmt::format("nothing in the loop stores {}, which it counts down", place);
  }
  return store != nullptr ? fmt::format("the count that {} keeps is not loaded again", Facts::text(*store))
                          : std::string();
}

void checkCtl011(const Facts& facts, FindingSink& sink) {
  eachOwnBlock(facts, [&](std::uint32_t, const Flow& flow) {
    for (std::uint32_t at = 0; at < flow.steps.size(); ++at) {
      const FlowStep& step = flow.steps[at];
      if (statementRole(*step.instruction) != StatementRole::Loop || step.partner == noPartner || step.partner > at)
        continue;
      const std::string fault = countFaultOf(flow, at, step.partner);
      if (fault.empty()) continue;
      Finding& finding = sink.report(step.instruction->span, fmt::format("{} does not count its rounds: {}",
                                                                         Facts::text(*step.instruction), fault));
      finding.help = "keep the count: T #count behind the label, L #count in front of LOOP";
    }
  });
}

}  // namespace

extern constexpr Rule ctl011_loop_counter_lost = {
    .id = "CTL011",
    .title = "LOOP without its counter",
    .severity = Severity::Warning,
    .needs = Needs::Flow,
    .detects = "a loop that changes ACCU1 and does not load its stored count again in front of LOOP",
    .why = "LOOP counts down what stands in ACCU1: with another number the loop ends at random or never",
    .manual = "002:1783-1785, 002:2809",
    .bad =
        "ORGANIZATION_BLOCK OB 1\nBEGIN\nNETWORK\nL 5;\nm: T MW 12;\nL MW 14;\n+ 1;\nT MW 14;\nLOOP m;\n"
        "END_ORGANIZATION_BLOCK\n",
    .good =
        "ORGANIZATION_BLOCK OB 1\nBEGIN\nNETWORK\nL 5;\nm: T MW 12;\nL MW 14;\n+ 1;\nT MW 14;\nL MW 12;\nLOOP m;\n"
        "END_ORGANIZATION_BLOCK\n",
    .exampleCpu = "319-3",
    .dialects = dialect::S7300,
    .ofLists = true,
    .check = checkCtl011,
};

}  // namespace rungproof
