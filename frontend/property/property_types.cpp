// Numbers are signed for words and double words, unsigned for bytes, as the S7-200 compares them (001:1425-1431).
#include "frontend/property/property_types.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>

namespace rungproof {

namespace {

/// The address that the node reads, now or a scan ago; nullptr if it is none.
ExprNode* addressBehind(Expr& expr, std::uint32_t node) {
  while (expr.nodes[node].op == ExprOp::Prev) node = expr.nodes[node].args[0];
  return expr.nodes[node].op == ExprOp::Address ? &expr.nodes[node] : nullptr;
}

/// Double words in the expression become REALs, and what is computed from them, unless the program uses them as whole
/// numbers. A variable of IEC 61131-3 is what it is declared as.
void makeReal(Expr& expr, std::uint32_t node, std::vector<std::string>& remarks) {
  ExprNode& n = expr.nodes[node];
  if (n.type != ExprType::Number) return;
  bool isReal = n.op == ExprOp::Address && n.width == 32 && n.operand.form == ConstantForm::Decimal && !n.isWhole;
  if (isReal)
    remarks.push_back(fmt::format("{} is read as a REAL, like the number beside it: the program does not tell its type",
                                  toString(n.operand)));
  if (n.op == ExprOp::Prev || n.op == ExprOp::Negate || n.op == ExprOp::Add || n.op == ExprOp::Sub ||
      n.op == ExprOp::Mul) {
    for (const std::uint32_t arg : n.args) {
      makeReal(expr, arg, remarks);
      isReal = isReal || expr.nodes[arg].type == ExprType::Real;
    }
  }
  if (!isReal) return;
  n.type = ExprType::Real;
  n.width = 32;
}

bool isComputed(const ExprNode& n) {
  return n.type == ExprType::Number &&
         (n.op == ExprOp::Negate || n.op == ExprOp::Add || n.op == ExprOp::Sub || n.op == ExprOp::Mul);
}

/// Whether the pattern would be negative in 16 or 32 bits.
bool hasHighestBit(std::int64_t pattern) {
  for (const int w : {16, 32}) {
    if (pattern >> w == 0) return (pattern >> (w - 1) & 1) != 0;
  }
  return false;
}

/// Memory that the program uses as a REAL: beside it a pattern gives the bits.
bool isPlaceOfReal(const ExprNode& n) {
  return n.type == ExprType::Real && n.width == 32 && n.operand.form == ConstantForm::Decimal;
}

bool isLongReal(const ExprNode& n) { return n.type == ExprType::Real && n.width == 64; }

/// Beside an LREAL constants are ones of 64 bits, and what is computed from them.
void lengthen(Expr& expr, std::uint32_t node) {
  ExprNode& n = expr.nodes[node];
  if (n.type != ExprType::Real || n.width == 64 || n.op == ExprOp::Address || n.op == ExprOp::Prev) return;
  n.width = 64;
  if (n.op == ExprOp::Constant) n.value = n.operand.value;
  for (const std::uint32_t arg : n.args) lengthen(expr, arg);
}

}  // namespace

std::uint8_t signedWidth(std::int64_t value) {
  int width = 1;
  while (width < 64 && (value >> (width - 1)) != 0 && (value >> (width - 1)) != -1) ++width;
  return static_cast<std::uint8_t>(width);
}

std::uint8_t signedWidth(const Operand& operand) {
  const int width = numberBits(operand);
  if (operand.form == ConstantForm::SignedDecimal) return static_cast<std::uint8_t>(width);
  if (operand.form == ConstantForm::Real) return static_cast<std::uint8_t>(width);
  return static_cast<std::uint8_t>(std::min(64, width == 8 || operand.form == ConstantForm::Hex ? width + 1 : width));
}

bool isTimerBit(const ExprNode& node) {
  return node.op == ExprOp::Address && node.type == ExprType::Truth && (hasBitAndWord(node.operand.area));
}

bool comparesTruth(const Expr& expr, ExprOp op, std::uint32_t left, std::uint32_t right) {
  const ExprNode &a = expr.nodes[left], &b = expr.nodes[right];
  if (a.type == ExprType::Truth && b.type == ExprType::Truth) return true;
  const auto isTruthConstant = [&](const ExprNode& node) {
    return node.op == ExprOp::Constant && node.type == ExprType::Number && (node.value == 0 || node.value == 1) &&
           (op == ExprOp::Equal || op == ExprOp::NotEqual);
  };
  if (isTimerBit(a)) return isTruthConstant(b);
  if (isTimerBit(b)) return isTruthConstant(a);
  return a.type == ExprType::Truth || b.type == ExprType::Truth;
}

void fitConstant(Expr& expr, std::uint32_t constant, std::uint32_t other, std::vector<std::string>& remarks) {
  ExprNode& number = expr.nodes[constant];
  const ExprNode* address = addressBehind(expr, other);
  if (number.op != ExprOp::Constant || number.type != ExprType::Number) return;
  const bool isPattern = number.operand.form == ConstantForm::Hex;
  if (address == nullptr && isPattern && isComputed(expr.nodes[other]) && hasHighestBit(number.value))
    remarks.push_back(fmt::format("beside a sum or product a pattern is a number: 16#{0:X} is {0}", number.value));
  if (address != nullptr && isPattern && isPlaceOfReal(*address) && number.value >> 32 == 0) {
    number.type = ExprType::Real;
    number.width = 32;
    const auto single = std::bit_cast<float>(static_cast<std::uint32_t>(number.value));
    number.operand.value = std::bit_cast<std::int64_t>(static_cast<double>(single));
    number.operand.form = ConstantForm::Real;
    return;
  }
  if (address == nullptr || address->type != ExprType::Number) return;
  const int w = address->width;
  if (w >= 64) {  // beside a number with a sign a pattern has one too
    const bool hasSign = address->operand.form != ConstantForm::Hex;
    if (isPattern && hasSign) number.operand.form = ConstantForm::SignedDecimal;
    return;
  }
  const bool isSigned = w == 8 || w == 16 || w == 32;
  if (isPattern && isSigned && number.value >> w == 0) {
    if ((number.value >> (w - 1) & 1) != 0) number.value -= std::int64_t{1} << w;
    number.width = signedWidth(number.value);
    return;
  }
  const bool isByte = w == 9;
  const std::int64_t lowest = isByte ? 0 : -(std::int64_t{1} << (w - 1));
  const std::int64_t highest = (std::int64_t{1} << (w - 1)) - 1;
  if (number.value >= lowest && number.value <= highest) return;
  const bool isDeclared = address->operand.form != ConstantForm::Decimal;  // a variable of IEC 61131-3
  remarks.push_back(
      fmt::format("{} is never {}: {}it goes from {} to {}",
                  isDeclared ? std::string(std::string_view(address->operand.text)) : toString(address->operand),
                  number.value, isDeclared ? "" : "as comparisons take it, ", lowest, highest));
}

void asReals(Expr& expr, std::uint32_t left, std::uint32_t right, std::vector<std::string>& remarks) {
  if (expr.nodes[left].type != ExprType::Real && expr.nodes[right].type != ExprType::Real) return;
  makeReal(expr, left, remarks);
  makeReal(expr, right, remarks);
  if (!isLongReal(expr.nodes[left]) && !isLongReal(expr.nodes[right])) return;
  lengthen(expr, left);
  lengthen(expr, right);
}

ExprNode arithmeticNode(const Expr& expr, ExprOp op, std::uint32_t left, std::uint32_t right, Span at) {
  const ExprNode &a = expr.nodes[left], &b = expr.nodes[right];
  ExprNode made{.op = op, .type = ExprType::Number, .args = {left, right}, .span = at};
  int width = std::min(64, op == ExprOp::Mul ? a.width + b.width : std::max(a.width, b.width) + 1);
  if (a.type == ExprType::Real || b.type == ExprType::Real) {
    made.type = ExprType::Real;
    width = isLongReal(a) || isLongReal(b) ? 64 : 32;
  }
  made.width = static_cast<std::uint8_t>(width);
  return made;
}

std::span<const std::string_view> propertyKeywords() {
  static constexpr std::array<std::string_view, 25> words = {
      "and",      "or",    "xor",     "implies", "always", "never",  "leads",   "to",     "within",
      "scan",     "scans", "only",    "after",   "held",   "unless", "prove",   "assume", "reach",
      "external", "pulse", "initial", "at",      "every",  "reset",  "dominant"};
  return words;
}

bool isKeyword(std::string_view word) {
  return std::ranges::find(propertyKeywords(), word) != propertyKeywords().end();
}

}  // namespace rungproof
