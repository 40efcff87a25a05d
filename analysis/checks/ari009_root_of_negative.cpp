// ARI009: SQRT or LN of what may be below 0. Tested by its examples and tests/rules/step7_number_rules_test.cpp.
#include <fmt/format.h>

#include "analysis/flow/statement_paths.hpp"
#include "analysis/flow/step7_blocks.hpp"
#include "analysis/rule.hpp"
#include "ir/s7300/statement_detail.hpp"

namespace rungproof {

namespace {

/// What has made ACCU1, right in front of the step along the text.
const Instruction* makerOfAccu1(const Flow& flow, std::uint32_t at) {
  while (at-- > 0) {
    const Instruction& instruction = *flow.steps[at].instruction;
    if (!keepsAccus(statementRole(instruction))) return &instruction;
  }
  return nullptr;
}

bool isNegativeConstant(const Instruction& load) {
  const bool isConstant = statementRole(load) == StatementRole::Load && !load.operands.empty() &&
                          load.operands[0].kind == OperandKind::Constant;
  return isConstant && load.operands[0].form == ConstantForm::Real && (load.operands[0].value & 0x80000000) != 0;
}

void checkAri009(const Facts& facts, FindingSink& sink) {
  eachReadStretch(facts, [&](std::uint32_t, const Flow& flow) {
    for (std::uint32_t at = 0; at < flow.steps.size(); ++at) {
      const Instruction& instruction = *flow.steps[at].instruction;
      if (!wantsNoNegative(instruction)) continue;
      const Instruction* maker = makerOfAccu1(flow, at);
      if (maker == nullptr || !(givesEitherSign(*maker) || isNegativeConstant(*maker))) continue;
      if (asksOverflowBehind(flow, at)) continue;
      Finding& finding = sink.report(instruction.span, fmt::format("{} takes what {} gives, which may be below 0",
                                                                   Facts::text(instruction), Facts::text(*maker)));
      finding.related.push_back({maker->span, "this makes the number"});
      finding.help = "take ABS of it, compare it with 0.0 before, or ask OV behind it (JO)";
    }
  });
}

}  // namespace

extern constexpr Rule ari009_root_of_negative = {
    .id = "ARI009",
    .title = "Root or logarithm of what may be negative",
    .severity = Severity::Warning,
    .needs = Needs::Flow,
    .detects =
        "SQRT or LN right behind -R, NEGR, SIN, COS, TAN or LN, or of a negative constant, with neither ABS between "
        "nor a question for OV behind it",
    .why = "below 0 neither has a result: what is left is no number, and everything calculated with it is none either",
    .manual = "002:1951-1978",
    .bad = "ORGANIZATION_BLOCK OB 1\nBEGIN\nNETWORK\nL MD 0;\nL MD 4;\n-R;\nSQRT;\nT MD 8;\nEND_ORGANIZATION_BLOCK\n",
    .good =
        "ORGANIZATION_BLOCK OB 1\nBEGIN\nNETWORK\nL MD 0;\nL MD 4;\n-R;\nABS;\nSQRT;\nT MD 8;\n"
        "END_ORGANIZATION_BLOCK\n",
    .exampleCpu = "319-3",
    .falsePositives = "differences that other parts of the program keep above 0",
    .dialects = dialect::S7300,
    .check = checkAri009,
};

}  // namespace rungproof
