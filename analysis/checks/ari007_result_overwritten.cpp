// ARI007: two operations in a row on ACCU2 and ACCU1, of which the second takes the first one's operand again instead
// of an earlier result. Tested by its examples and tests/rules/step7_carried_rules_test.cpp.
#include <fmt/format.h>

#include "analysis/flow/statement_paths.hpp"
#include "analysis/flow/step7_blocks.hpp"
#include "analysis/rule.hpp"

namespace rungproof {

namespace {

bool joinsAccumulators(const Instruction& instruction) {
  const StatementRole role = statementRole(instruction);
  return role == StatementRole::IntegerMath || role == StatementRole::RealMath;
}

/// Whether a statement of the block moves accumulators by itself: it knows what it does.
bool movesAccumulators(const Flow& flow) {
  for (const FlowStep& step : flow.steps) {
    if (statementRole(*step.instruction) == StatementRole::MoveAccus) return true;
  }
  return false;
}

void checkAri007(const Facts& facts, FindingSink& sink) {
  eachOwnBlock(facts, [&](std::uint32_t, const Flow& flow) {
    if (movesAccumulators(flow)) return;
    const Instruction* first = nullptr;  // an operation with nothing but loads of accumulators to come behind it
    int loads = 0;                       // in a row before `first`
    int loadsSoFar = 0;
    bool isEarlierResult = false, firstHasResultBelow = false;
    for (const FlowStep& step : flow.steps) {
      const Instruction& instruction = *step.instruction;
      const StatementRole role = statementRole(instruction);
      if (role == StatementRole::Nothing) continue;
      if (joinsAccumulators(instruction)) {
        if (first != nullptr && loads >= 2 && firstHasResultBelow) {
          Finding& finding = sink.report(
              instruction.span, fmt::format("{} takes the operand of {} again: the result before the two loads is lost",
                                            Facts::text(instruction), Facts::text(*first)));
          finding.related.push_back({first->span, "the operation before it"});
          finding.help = "keep the first result in a temporary variable and load it again";
        }
        first = &instruction;
        loads = loadsSoFar;
        firstHasResultBelow = isEarlierResult;
        isEarlierResult = true;
        loadsSoFar = 0;
        continue;
      }
      first = nullptr;
      if (role == StatementRole::Load) {
        ++loadsSoFar;
      } else if (instruction.desc->control != Control::None || role == StatementRole::Transfer || isComparison(role)) {
        isEarlierResult = false;  // used up, or another way comes in
        loadsSoFar = 0;
      }
    }
  });
}

}  // namespace

extern constexpr Rule ari007_result_overwritten = {
    .id = "ARI007",
    .title = "Result pushed out of the accumulators",
    .severity = Severity::Warning,
    .needs = Needs::Text,
    .detects =
        "L, L, operation, operation behind an earlier result that nothing stored: the two loads have pushed it out of "
        "ACCU2; blocks with TAK, PUSH, POP, ENT or LEAVE are left out",
    .why =
        "two accumulators hold two values: the second operation joins the new result with its own first operand "
        "again, with four accumulators with whatever ACCU3 holds",
    .manual = "002:1444-1476",
    .bad =
        "ORGANIZATION_BLOCK OB 1\nBEGIN\nNETWORK\nL MW 0;\nL MW 2;\n+I;\nL MW 4;\nL MW 6;\n-I;\n*I;\nT MD 8;\n"
        "END_ORGANIZATION_BLOCK\n",
    .good =
        "ORGANIZATION_BLOCK OB 1\nBEGIN\nNETWORK\nL MW 4;\nL MW 6;\n-I;\nT MW 12;\nL MW 0;\nL MW 2;\n+I;\nL MW 12;\n"
        "*I;\nT MD 8;\nEND_ORGANIZATION_BLOCK\n",
    .exampleCpu = "319-3",
    .dialects = dialect::S7300,
    .check = checkAri007,
};

}  // namespace rungproof
