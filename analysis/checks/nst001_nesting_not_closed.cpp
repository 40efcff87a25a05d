// NST001: parentheses of a logic string that are not closed, closed without being open, or nested too deep.
// Tested by its examples and tests/rules/nesting_rules_test.cpp.
#include <fmt/format.h>

#include "analysis/flow/logic_string.hpp"
#include "analysis/flow/step7_blocks.hpp"
#include "analysis/rule.hpp"

namespace rungproof {

namespace {

void reportOpen(const Facts& facts, FindingSink& sink, const Flow& flow, const LogicState& state,
                const Instruction* leaves) {
  const Instruction& open = *flow.steps[state.opened[state.depth - 1U]].instruction;
  Finding& finding = sink.report(
      open.span, leaves == nullptr ? fmt::format("{} is not closed before {} ends", Facts::text(open), flow.pou->name)
                                   : fmt::format("{} is still open where {} leaves {}", Facts::text(open),
                                                 Facts::text(*leaves), flow.pou->name));
  if (leaves != nullptr) finding.related.push_back({leaves->span, networkText(facts, leaves->id)});
  finding.help = "write the missing ) before the result is used";
}

void checkNst001(const Facts& facts, FindingSink& sink) {
  eachOwnBlock(facts, [&](std::uint32_t, const Flow& flow) {
    const LogicStates states = logicStates(flow);
    bool isLost = false;  // after a mismatch the depths that follow say nothing
    for (std::uint32_t at = 0; at < flow.steps.size() && !isLost; ++at) {
      if (!states[at]) continue;
      const LogicState& state = *states[at];
      const Instruction& instruction = *flow.steps[at].instruction;
      const StatementRole role = statementRole(instruction);
      if (state.depth == LogicState::unknownDepth) {
        Finding& finding = sink.report(
            instruction.span,
            fmt::format("{} is reached with different numbers of open parentheses", Facts::text(instruction)));
        finding.help = "close every ( before a jump and before a label";
        isLost = true;
      } else if (role == StatementRole::Close && state.depth == 0) {
        Finding& finding = sink.report(instruction.span, "this ) closes nothing");
        finding.help = "remove it, or write the A(, O( or X( that it belongs to";
        isLost = true;
      } else if (role == StatementRole::Open && state.depth == nestingLevels) {
        Finding& finding =
            sink.report(instruction.span, fmt::format("{} opens level {}; the nesting stack holds {}",
                                                      Facts::text(instruction), nestingLevels + 1, nestingLevels));
        finding.help = "keep a part of the logic in a temporary bit";
        isLost = true;
      } else if (role == StatementRole::End && state.depth > 0) {
        reportOpen(facts, sink, flow, state, &instruction);
        isLost = true;
      }
    }
    const std::optional<LogicState>& end = states.back();
    if (!isLost && end && end->depth != LogicState::unknownDepth && end->depth > 0)
      reportOpen(facts, sink, flow, *end, nullptr);
  });
}

}  // namespace

extern constexpr Rule nst001_nesting_not_closed = {
    .id = "NST001",
    .title = "Nesting not closed or too deep",
    .severity = Severity::Error,
    .needs = Needs::Text,
    .detects =
        "A(, O(, X( that no ) closes before the block ends, a ) without one, more than seven levels, a label reached "
        "with different numbers of them open",
    .why = "a level that stays open joins a later result with an old one; beyond the seventh the oldest is lost",
    .manual = "002:2707",
    .bad = "ORGANIZATION_BLOCK OB 1\nBEGIN\nNETWORK\nA(;\nO I 0.0;\nO I 0.1;\n= Q 0.0;\nEND_ORGANIZATION_BLOCK\n",
    .good = "ORGANIZATION_BLOCK OB 1\nBEGIN\nNETWORK\nA(;\nO I 0.0;\nO I 0.1;\n);\n= Q 0.0;\nEND_ORGANIZATION_BLOCK\n",
    .exampleCpu = "319-3",
    .dialects = dialect::S7300,
    .ofLists = true,
    .check = checkNst001,
};

}  // namespace rungproof
