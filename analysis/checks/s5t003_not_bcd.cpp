// S5T003: a value for a timer, a counter or BTI whose digits are no BCD, or that is written as another number.
// Tested by its examples and tests/rules/step7_timer_rules_test.cpp.
#include <fmt/format.h>

#include <algorithm>

#include "analysis/flow/declared_value.hpp"
#include "analysis/flow/statement_paths.hpp"
#include "analysis/flow/step7_blocks.hpp"
#include "analysis/rule.hpp"

namespace rungproof {

namespace {

bool readsBcd(StatementRole role) {
  return role == StatementRole::StartTimer || role == StatementRole::SetCounter || role == StatementRole::FromBcd;
}

/// The statement that made ACCU1, looking back along the text without passing a label or a jump; nullptr: not known.
const Instruction* makerOfAccu(const Flow& flow, std::uint32_t at) {
  while (at-- > 0) {
    const Instruction& instruction = *flow.steps[at].instruction;
    const StatementRole role = statementRole(instruction);
    if (role == StatementRole::Load || role == StatementRole::IntegerStep || role == StatementRole::IntegerMath)
      return &instruction;
    if (!keepsAccus(role)) return nullptr;
  }
  return nullptr;
}

bool isDecimal(std::string_view text) {
  return !text.empty() && std::ranges::all_of(text, [](char c) { return c >= '0' && c <= '9'; });
}

/// What is wrong with the constant, or empty.
std::string faultOf(const Operand& constant, StatementRole role) {
  const auto value = static_cast<std::uint32_t>(constant.value);
  const int digits = role == StatementRole::FromBcd ? 7 : 3;
  for (int i = 0; i < digits; ++i) {
    if ((value >> (4 * i) & 15U) > 9)
      return fmt::format("{} is 16#{:04X}, which has a digit above 9", constant.text, value);
  }
  const bool isBinary = isDecimal(constant.text) && value > 9 && role != StatementRole::FromBcd;
  if (!isBinary) return {};
  return fmt::format("{} is 16#{:04X}, which counts as {:x}{}", constant.text, value, value & 0xFFFU,
                     role == StatementRole::StartTimer ? " units" : "");
}

/// Declared INT, DINT or REAL: a parameter, a variable or a member of a data block.
bool isDeclaredNumber(const Facts& facts, const Flow& flow, const Operand& operand) {
  const s7300::TypeKind type = declaredTypeOf(facts, flow, operand);
  return type == s7300::TypeKind::Int || type == s7300::TypeKind::DInt || type == s7300::TypeKind::Real;
}

void checkS5t003(const Facts& facts, FindingSink& sink) {
  eachReadStretch(facts, [&](std::uint32_t, const Flow& flow) {
    for (std::uint32_t at = 0; at < flow.steps.size(); ++at) {
      const Instruction& instruction = *flow.steps[at].instruction;
      const StatementRole role = statementRole(instruction);
      if (!readsBcd(role)) continue;
      const Instruction* maker = makerOfAccu(flow, at);
      if (maker == nullptr) continue;
      const StatementRole made = statementRole(*maker);
      const bool isConstant =
          made == StatementRole::Load && !maker->operands.empty() && maker->operands[0].kind == OperandKind::Constant;
      const bool isComputed = made == StatementRole::IntegerMath || made == StatementRole::IntegerStep;
      const bool isNumber = made == StatementRole::Load && role != StatementRole::FromBcd &&
                            isDeclaredNumber(facts, flow, maker->operands[0]);
      const std::string fault = isConstant   ? faultOf(maker->operands[0], role)
                                : isComputed ? fmt::format("{} leaves a binary number in ACCU1", Facts::text(*maker))
                                : isNumber   ? fmt::format("{} is declared as a number", toString(maker->operands[0]))
                                             : std::string();
      if (fault.empty()) continue;
      Finding& finding = sink.report(maker->span, fmt::format("{}: {} takes BCD", fault, Facts::text(instruction)));
      finding.related.push_back({instruction.span, "where it is taken"});
      finding.help = role == StatementRole::StartTimer ? "write S5T#... or W#16#... with the base and three digits"
                     : isComputed || isNumber          ? "convert it with ITB before"
                                                       : "write C#... or W#16#... with decimal digits";
    }
  });
}

}  // namespace

extern constexpr Rule s5t003_not_bcd = {
    .id = "S5T003",
    .title = "Value for a timer or counter is no BCD",
    .severity = Severity::Warning,
    .needs = Needs::Flow,
    .detects =
        "a constant with a digit above 9, a decimal number, a computed one or one declared as INT in ACCU1 where a "
        "timer is started, a counter set, or BTI converts",
    .why = "a digit above 9 is a synchronous error: OB121 or STOP; a binary number gives another time or count",
    .manual = "002:1286, 003:1000-1043",
    .bad =
        "ORGANIZATION_BLOCK OB 1\nBEGIN\nNETWORK\nA I 0.0;\nL W#16#00FA;\nSD T 1;\nA T 1;\n= Q 0.0;\n"
        "END_ORGANIZATION_BLOCK\n",
    .good =
        "ORGANIZATION_BLOCK OB 1\nBEGIN\nNETWORK\nA I 0.0;\nL S5T#2S500MS;\nSD T 1;\nA T 1;\n= Q 0.0;\n"
        "END_ORGANIZATION_BLOCK\n",
    .exampleCpu = "319-3",
    .dialects = dialect::S7300,
    .check = checkS5t003,
};

}  // namespace rungproof
