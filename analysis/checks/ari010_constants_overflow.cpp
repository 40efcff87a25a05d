// ARI010: two constants whose result does not fit. Tested by its examples and
// tests/rules/step7_number_rules_test.cpp.
#include <fmt/format.h>

#include "analysis/flow/statement_paths.hpp"
#include "analysis/flow/step7_blocks.hpp"
#include "analysis/rule.hpp"
#include "ir/s7300/statement_detail.hpp"

namespace rungproof {

namespace {

/// The whole number that the load puts into ACCU1, of that many bits.
std::optional<std::int64_t> wholeConstant(const Instruction* load, int bits) {
  if (load == nullptr || load->operands.empty() || load->operands[0].kind != OperandKind::Constant) return {};
  const Operand& operand = load->operands[0];
  if (operand.form == ConstantForm::Real) return {};
  const auto value = static_cast<std::uint64_t>(operand.value);
  return bits == 16 ? static_cast<std::int16_t>(value) : static_cast<std::int64_t>(static_cast<std::int32_t>(value));
}

/// A product of words fills ACCU1, and a double word takes all of it.
bool isProductKeptWhole(const Flow& flow, std::uint32_t at, bool isProduct) {
  if (!isProduct || at + 1 == flow.steps.size()) return false;
  const Instruction& next = *flow.steps[at + 1].instruction;
  return statementRole(next) == StatementRole::Transfer && !next.operands.empty() &&
         next.operands[0].width == Width::DWord;
}

void checkAri010(const Facts& facts, FindingSink& sink) {
  eachReadStretch(facts, [&](std::uint32_t, const Flow& flow) {
    for (std::uint32_t at = 0; at < flow.steps.size(); ++at) {
      const Instruction& instruction = *flow.steps[at].instruction;
      const auto shape = resultOf(instruction, 0, 0);
      if (!shape) continue;
      const LoadsBefore loads = loadsBefore(flow, at);
      const bool isStep = statementRole(instruction) == StatementRole::IntegerStep;
      const std::optional<std::int64_t> first = wholeConstant(isStep ? loads.accu1 : loads.accu2, shape->bits);
      const std::optional<std::int64_t> second =
          isStep ? wholeConstant(&instruction, shape->bits) : wholeConstant(loads.accu1, shape->bits);
      if (!first || !second) continue;
      const WholeResult result = *resultOf(instruction, *first, *second);
      if (result.fits() || isProductKeptWhole(flow, at, result.bits == 16 && result.value == *first * *second))
        continue;
      Finding& finding = sink.report(
          instruction.span, fmt::format("{} makes {} of {} and {}, more than {} bits hold", Facts::text(instruction),
                                        result.value, *first, *second, result.bits));
      finding.help = result.bits == 16 ? "calculate with 32 bits: L#..., +D, *D" : "calculate with REAL";
    }
  });
}

}  // namespace

extern constexpr Rule ari010_constants_overflow = {
    .id = "ARI010",
    .title = "Constants whose result does not fit",
    .severity = Severity::Warning,
    .needs = Needs::Flow,
    .detects = "a sum, difference or product of two constants that leaves the 16 or 32 bits of its statement",
    .why = "the result wraps: 30000 + 10000 is -25536 in 16 bits, in every scan",
    .manual = "002:1951-1978, 003:1016-1043",
    .bad = "ORGANIZATION_BLOCK OB 1\nBEGIN\nNETWORK\nL 30000;\nL 10000;\n+I;\nT MW 0;\nEND_ORGANIZATION_BLOCK\n",
    .good = "ORGANIZATION_BLOCK OB 1\nBEGIN\nNETWORK\nL L#30000;\nL L#10000;\n+D;\nT MD 0;\nEND_ORGANIZATION_BLOCK\n",
    .exampleCpu = "319-3",
    .dialects = dialect::S7300,
    .check = checkAri010,
};

}  // namespace rungproof
