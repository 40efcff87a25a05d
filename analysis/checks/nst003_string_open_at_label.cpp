// NST003: a logic string that goes on behind a label to which others jump: for them it begins there.
// Tested by its examples and tests/rules/nesting_rules_test.cpp.
#include <fmt/format.h>

#include "analysis/flow/logic_string.hpp"
#include "analysis/flow/step7_blocks.hpp"
#include "analysis/rule.hpp"

namespace rungproof {

namespace {

void checkNst003(const Facts& facts, FindingSink& sink) {
  eachReadStretch(facts, [&](std::uint32_t, const Flow& flow) {
    const LogicStates states = logicStates(flow);
    const Instruction* label = nullptr;
    for (std::uint32_t at = 0; at < flow.steps.size(); ++at) {
      const Instruction& instruction = *flow.steps[at].instruction;
      if (instruction.desc->control == Control::LabelMark) label = &instruction;
      const StatementRole role = statementRole(instruction);
      if (label == nullptr || !states[at] || states[at]->firstCheck != mayBeAny ||
          (!asksFirstCheck(role) && !usesRlo(role)))
        continue;
      Finding& finding = sink.report(
          instruction.span, fmt::format("the logic string before label {} goes on with {}, but whoever jumps there {}",
                                        label->operands[0].text, Facts::text(instruction),
                                        asksFirstCheck(role) ? "begins a new one" : "brings another RLO"));
      finding.related.push_back({label->span, "the label"});
      finding.help = "end the string with =, S or R before the label, or begin it behind the label";
      label = nullptr;
    }
  });
}

}  // namespace

extern constexpr Rule nst003_string_open_at_label = {
    .id = "NST003",
    .title = "Logic string left open at a label",
    .severity = Severity::Warning,
    .needs = Needs::Flow,
    .detects = "a label behind A, O, X or a comparison, whose string goes on behind it",
    .why =
        "conditional jumps end the logic string, so the same statements mean one thing after the jump and another "
        "without it",
    .manual = "003:1292",
    .bad =
        "ORGANIZATION_BLOCK OB 1\nBEGIN\nNETWORK\nA I 0.0;\nJC m;\nA I 0.1;\nm: A I 0.2;\n= Q 0.0;\n"
        "END_ORGANIZATION_BLOCK\n",
    .good =
        "ORGANIZATION_BLOCK OB 1\nBEGIN\nNETWORK\nA I 0.0;\nJC m;\nA I 0.1;\n= Q 0.1;\nm: A I 0.2;\n= Q 0.0;\n"
        "END_ORGANIZATION_BLOCK\n",
    .exampleCpu = "319-3",
    .dialects = dialect::S7300,
    .ofLists = true,
    .check = checkNst003,
};

}  // namespace rungproof
