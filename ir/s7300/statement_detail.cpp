// By mnemonic.
#include "ir/s7300/statement_detail.hpp"

#include <algorithm>
#include <array>
#include <string_view>

namespace rungproof {

bool jumpsOnOne(const Instruction& jump) {
  const std::string_view name = jump.desc->stl;
  return name == "JC" || name == "JCB" || name == "JBI";
}

bool setsBit(const Instruction& instruction) {
  return statementRole(instruction) == StatementRole::Latch && instruction.desc->stl == "S";
}

bool startsOnDelay(const Instruction& instruction) {
  return statementRole(instruction) == StatementRole::StartTimer && instruction.desc->stl == "SD";
}

bool findsRise(const Instruction& edge) { return edge.desc->stl == "FP"; }

Relation relationOf(const Instruction& comparison) {
  const std::string_view name = comparison.desc->stl;
  if (name.starts_with("==")) return Relation::Equal;
  if (name.starts_with("<>")) return Relation::NotEqual;
  if (name.starts_with("<=")) return Relation::LessEqual;
  if (name.starts_with(">=")) return Relation::GreaterEqual;
  return name.starts_with("<") ? Relation::Less : Relation::Greater;
}

int comparedBits(const Instruction& comparison) { return comparison.desc->stl.ends_with('I') ? 16 : 32; }

bool comparesReals(const Instruction& instruction) {
  return isComparison(statementRole(instruction)) && instruction.desc->stl.ends_with('R');
}

bool wantsNoNegative(const Instruction& instruction) {
  const std::string_view name = instruction.desc->stl;
  return name == "SQRT" || name == "LN";
}

bool givesEitherSign(const Instruction& instruction) {
  static constexpr std::array<std::string_view, 6> names = {"-R", "NEGR", "SIN", "COS", "TAN", "LN"};
  return std::ranges::find(names, instruction.desc->stl) != names.end();
}

std::optional<NumberStep> numberStep(const Instruction& instruction) {
  struct Row {
    std::string_view name;
    NumberStep step;
  };
  constexpr NumberStep toReal{false, true}, toWhole{true, false}, ofReals{true, true}, ofWhole{false, false};
  static constexpr std::array<Row, 20> rows = {
      {{"DTR", toReal},  {"RND", toWhole},  {"RND+", toWhole}, {"RND-", toWhole}, {"TRUNC", toWhole},
       {"ITD", ofWhole}, {"NEGI", ofWhole}, {"NEGD", ofWhole}, {"ABS", ofReals},  {"NEGR", ofReals},
       {"SQR", ofReals}, {"SQRT", ofReals}, {"EXP", ofReals},  {"LN", ofReals},   {"SIN", ofReals},
       {"COS", ofReals}, {"TAN", ofReals},  {"ASIN", ofReals}, {"ACOS", ofReals}, {"ATAN", ofReals}}};
  const auto found = std::ranges::find(rows, instruction.desc->stl, &Row::name);
  return found == rows.end() ? std::nullopt : std::optional(found->step);
}

std::optional<WholeResult> resultOf(const Instruction& instruction, std::int64_t first, std::int64_t second) {
  const std::string_view name = instruction.desc->stl;
  if (name == "+") {  // + 5, + L#5
    const std::string_view written = instruction.operands.empty() ? "" : std::string_view(instruction.operands[0].text);
    return WholeResult{first + second, written.starts_with("L#") ? 32 : 16};
  }
  const bool isWhole = name.size() == 2 && (name[1] == 'I' || name[1] == 'D');
  if (statementRole(instruction) != StatementRole::IntegerMath || !isWhole) return std::nullopt;
  const int bits = name[1] == 'I' ? 16 : 32;
  switch (name[0]) {
    case '+': return WholeResult{first + second, bits};
    case '-': return WholeResult{first - second, bits};
    case '*': return WholeResult{first * second, bits};
    default: return std::nullopt;
  }
}

}  // namespace rungproof
