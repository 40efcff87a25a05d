// NST007: a logic result that no statement asks before it is gone, most often because a call, a load or a transfer is
// taken for one that it decides. Tested by its examples and tests/rules/nesting_rules_test.cpp.
#include <fmt/format.h>

#include "analysis/flow/logic_string.hpp"
#include "analysis/flow/step7_blocks.hpp"
#include "analysis/rule.hpp"

namespace rungproof {

namespace {

/// The string that stands unasked in front of a statement: its last scan; nullptr: none, or paths differ.
struct UnaskedScan {
  const Instruction* scan = nullptr;
  const Instruction* behind = nullptr;  ///< the first load, transfer or call behind it

  bool join(const UnaskedScan& other) {
    if (scan == other.scan) return false;
    const bool changes = scan != nullptr;
    *this = {};
    return changes;
  }
};

bool isScan(StatementRole role) {
  return role == StatementRole::AndScan || role == StatementRole::OrScan || role == StatementRole::XorScan;
}
/// What makes the result meaningless: a call leaves another one, SET and CLR make their own.
bool ends(StatementRole role) {
  return role == StatementRole::Call || role == StatementRole::SetRlo || role == StatementRole::ClearRlo;
}
/// Statements that run whatever the result is.
bool isUnmoved(StatementRole role) {
  return role == StatementRole::Load || role == StatementRole::Transfer || role == StatementRole::Call;
}

void checkNst007(const Facts& facts, FindingSink& sink) {
  eachOwnBlock(facts, [&](std::uint32_t block, const Flow& flow) {
    const bool isOb = facts.program().pous[block].kind != PouKind::Subroutine;
    const auto apply = [](UnaskedScan& state, const FlowStep& step) {
      const Instruction& instruction = *step.instruction;
      const StatementRole role = statementRole(instruction);
      if (isScan(role) || role == StatementRole::Close)
        state = {&instruction, nullptr};
      else if (isUnmoved(role) && state.scan != nullptr && state.behind == nullptr && !ends(role))
        state.behind = &instruction;
      else if (usesRlo(role) || ends(role) || asksFirstCheck(role) || isComparison(role))
        state = {};
    };
    const std::vector<std::optional<UnaskedScan>> states = statesOf(flow, UnaskedScan{}, apply);
    const auto report = [&](const UnaskedScan& state, const Instruction* last) {
      const Instruction* culprit = state.behind != nullptr ? state.behind : last;
      Finding& finding = sink.report(
          state.scan->span,
          fmt::format("nothing asks the result of {}{}", Facts::text(*state.scan),
                      culprit == nullptr ? std::string() : fmt::format(": {} runs always", Facts::text(*culprit))));
      finding.help = "write JCN in front of what it shall decide, or CC instead of UC; or take the scan away";
    };
    for (std::uint32_t at = 0; at < flow.steps.size(); ++at) {
      if (!states[at] || states[at]->scan == nullptr) continue;
      const Instruction& instruction = *flow.steps[at].instruction;
      const StatementRole role = statementRole(instruction);
      if (ends(role)) report(*states[at], role == StatementRole::Call ? &instruction : nullptr);
    }
    const std::optional<UnaskedScan>& left = states.back();
    if (isOb && left && left->scan != nullptr) report(*left, nullptr);
  });
}

}  // namespace

extern constexpr Rule nst007_rlo_not_asked = {
    .id = "NST007",
    .title = "Logic result that nothing asks",
    .severity = Severity::Warning,
    .needs = Needs::Flow,
    .detects =
        "a scan whose result neither an assignment, an edge, a timer nor a conditional jump asks before CALL, UC, SET, "
        "CLR or the end of an organization block",
    .why = "CALL, UC, L and T run whatever the RLO is: what was meant as their condition has no effect",
    .manual = "002:246, 003:1292",
    .bad =
        "FUNCTION FC 1 : VOID\nBEGIN\nNETWORK\nSET;\nS Q 0.0;\nEND_FUNCTION\nORGANIZATION_BLOCK OB 1\nBEGIN\nNETWORK\n"
        "A I 0.0;\nCALL FC 1;\nEND_ORGANIZATION_BLOCK\n",
    .good =
        "FUNCTION FC 1 : VOID\nBEGIN\nNETWORK\nSET;\nS Q 0.0;\nEND_FUNCTION\nORGANIZATION_BLOCK OB 1\nBEGIN\nNETWORK\n"
        "A I 0.0;\nCC FC 1;\nEND_ORGANIZATION_BLOCK\n",
    .exampleCpu = "319-3",
    .falsePositives = "blocks that take the RLO of their caller by agreement",
    .dialects = dialect::S7300,
    .ofLists = true,
    .check = checkNst007,
};

}  // namespace rungproof
