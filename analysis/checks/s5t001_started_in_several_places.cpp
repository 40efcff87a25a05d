// S5T001: one timer or counter that a scan may start, count or set at several places.
// Tested by its examples and tests/rules/step7_timer_rules_test.cpp.
#include <fmt/format.h>

#include <map>

#include "analysis/flow/statement_paths.hpp"
#include "analysis/flow/step7_blocks.hpp"
#include "analysis/rule.hpp"

namespace rungproof {

namespace {

/// Instructions that share one memory of the RLO: all starts of a timer, those of one kind of a counter.
struct RloUser {
  Area area;
  std::uint32_t number;
  StatementRole role;
  auto operator<=>(const RloUser&) const = default;
};

void checkS5t001(const Facts& facts, FindingSink& sink) {
  std::map<RloUser, std::vector<const Instruction*>> users;
  eachOwnBlock(facts, [&](std::uint32_t block, const Flow& flow) {
    if (facts.calls().isStartUpOnly(block)) return;
    for (const FlowStep& step : flow.steps) {
      const Instruction& instruction = *step.instruction;
      const StatementRole role = statementRole(instruction);
      if (!remembersRlo(role) || instruction.operands.empty() || !facts.execution().at(instruction.id).isReachable)
        continue;
      const Operand& element = instruction.operands[0];
      if (element.kind == OperandKind::Direct) users[{element.area, element.offset, role}].push_back(&instruction);
    }
  });
  for (const auto& [user, list] : users) {
    const Instruction& last = *list.back();
    const Instruction* other = nullptr;
    for (std::size_t i = 0; i + 1 < list.size() && other == nullptr; ++i) {
      if (mayRunInOneScan(facts, list[i]->id, last.id)) other = list[i];
    }
    const std::uint32_t block = facts.blockOf(last.id);
    if (other == nullptr && !mayRunTwice(facts, block)) continue;
    const std::string element = facts.name(last.operands[0]);
    Finding& finding = sink.report(
        last.span, other != nullptr
                       ? fmt::format("{} is worked by {} statements that a scan may run both", element, list.size())
                       : fmt::format("{} is worked in {}, which may run several times in a scan", element,
                                     facts.program().pous[block].name));
    finding.address = toString(last.operands[0]);
    for (const Instruction* each : list) {
      if (each != &last && finding.related.size() < 8)
        finding.related.push_back({each->span, networkText(facts, each->id)});
    }
    finding.help = "join the conditions in front of one statement, or take an element for each";
  }
}

}  // namespace

extern constexpr Rule s5t001_started_in_several_places = {
    .id = "S5T001",
    .title = "Timer or counter worked in several places",
    .severity = Severity::Warning,
    .needs = Needs::Flow,
    .detects =
        "two start instructions of one timer, or two CU, CD or S of one counter, that one scan may run; or one in a "
        "block that runs several times in a scan",
    .why =
        "the element remembers one RLO: the second statement compares its own with that of the first, so it starts "
        "in every scan or never",
    .manual = "002:2869-2880",
    .bad =
        "ORGANIZATION_BLOCK OB 1\nBEGIN\nNETWORK\nA I 0.0;\nL S5T#1S;\nSD T 1;\nNETWORK\nA I 0.1;\nL S5T#2S;\nSD T 1;\n"
        "NETWORK\nA T 1;\n= Q 0.0;\nEND_ORGANIZATION_BLOCK\n",
    .good =
        "ORGANIZATION_BLOCK OB 1\nBEGIN\nNETWORK\nA I 0.0;\nO I 0.1;\nL S5T#1S;\nSD T 1;\nNETWORK\nA T 1;\n= Q 0.0;\n"
        "END_ORGANIZATION_BLOCK\n",
    .exampleCpu = "319-3",
    .falsePositives = "steps of a chain that exclude each other by their conditions",
    .dialects = dialect::S7300,
    .check = checkS5t001,
};

}  // namespace rungproof
