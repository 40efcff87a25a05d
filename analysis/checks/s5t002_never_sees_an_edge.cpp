// S5T002: a start of a timer, or CU, CD, S of a counter, that only ever sees RLO 1, or only 0.
// Tested by its examples and tests/rules/step7_timer_rules_test.cpp.
#include <fmt/format.h>

#include <map>

#include "analysis/flow/logic_string.hpp"
#include "analysis/flow/step7_blocks.hpp"
#include "analysis/rule.hpp"

namespace rungproof {

namespace {

struct ElementUse {
  std::vector<const Instruction*> starts;
  BitValues seen = 0;  ///< by all of them
  bool isFreed = false;
};

void checkS5t002(const Facts& facts, FindingSink& sink) {
  std::map<std::tuple<Area, std::uint32_t, StatementRole>, ElementUse> uses;
  std::map<std::pair<Area, std::uint32_t>, bool> freed;
  bool isHidden = facts.hasHiddenCode();
  eachOwnBlock(facts, [&](std::uint32_t block, const Flow& flow) {
    const bool isStartUp = facts.calls().isStartUpOnly(block);
    const LogicStates states = logicStates(flow);
    for (std::uint32_t at = 0; at < flow.steps.size(); ++at) {
      const Instruction& instruction = *flow.steps[at].instruction;
      const StatementRole role = statementRole(instruction);
      const bool frees = role == StatementRole::FreeTimer || role == StatementRole::FreeCounter;
      if ((!remembersRlo(role) && !frees) || instruction.operands.empty() || !states[at]) continue;
      const Operand& element = instruction.operands[0];
      if (element.kind != OperandKind::Direct) {
        isHidden = isHidden || element.reach == nullptr || element.reach->way != Way::Parameter;
        continue;
      }
      if (frees) {
        freed[{element.area, element.offset}] = true;
        continue;
      }
      ElementUse& use = uses[{element.area, element.offset, role}];
      use.starts.push_back(&instruction);
      use.seen |= states[at]->rlo;
      use.isFreed = use.isFreed || isStartUp;  // runs once at each start, with the memory at 0
    }
  });
  if (isHidden) return;
  for (const auto& [key, use] : uses) {
    const auto& [area, number, role] = key;
    if (use.seen == mayBeAny || use.isFreed || freed.contains({area, number})) continue;
    const Instruction& first = *use.starts.front();
    Finding& finding = sink.report(
        first.span,
        use.seen == mayBe1
            ? fmt::format("{} sees RLO 1 whenever it runs, so it acts once and not again", Facts::text(first))
            : fmt::format("{} sees RLO 0 whenever it runs, so it never acts", Facts::text(first)));
    finding.address = toString(first.operands[0]);
    finding.help = use.seen == mayBe1
                       ? "let it run with the RLO of its condition, also where that is 0: no jump over it"
                       : "write the condition in front of it";
  }
}

}  // namespace

extern constexpr Rule s5t002_never_sees_an_edge = {
    .id = "S5T002",
    .title = "Timer or counter never sees an edge",
    .severity = Severity::Warning,
    .needs = Needs::Flow,
    .detects =
        "a start of a timer, or CU, CD, S of a counter, that stands behind JC, JCN or SET and so sees only RLO 1; one "
        "that sees only RLO 0",
    .why = "these statements act on a change of their own RLO; where the 0 is jumped over there is no second change",
    .manual = "002:2869-2880",
    .bad =
        "ORGANIZATION_BLOCK OB 1\nBEGIN\nNETWORK\nA I 0.0;\nJCN m;\nL S5T#1S;\nSE T 1;\nm: A T 1;\n= Q 0.0;\n"
        "END_ORGANIZATION_BLOCK\n",
    .good =
        "ORGANIZATION_BLOCK OB 1\nBEGIN\nNETWORK\nA I 0.0;\nL S5T#1S;\nSE T 1;\nA T 1;\n= Q 0.0;\n"
        "END_ORGANIZATION_BLOCK\n",
    .exampleCpu = "319-3",
    .dialects = dialect::S7300,
    .check = checkS5t002,
};

}  // namespace rungproof
