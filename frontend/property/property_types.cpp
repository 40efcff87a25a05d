// Numbers are signed for words and double words, unsigned for bytes, as the S7-200 compares them (001:1425-1431).
#include "frontend/property/property_types.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace rungproof {

namespace {

/// The address that the node reads, now or a scan ago; nullptr if it is none.
ExprNode* addressBehind(Expr& expr, std::uint32_t node) {
  while (expr.nodes[node].op == ExprOp::Prev) node = expr.nodes[node].args[0];
  return expr.nodes[node].op == ExprOp::Address ? &expr.nodes[node] : nullptr;
}

/// Double words in the expression become REALs, and what is computed from them.
void makeReal(Expr& expr, std::uint32_t node) {
  ExprNode& n = expr.nodes[node];
  if (n.type != ExprType::Number) return;
  bool isReal = n.op == ExprOp::Address && n.width == 32;
  if (n.op == ExprOp::Prev || n.op == ExprOp::Negate || n.op == ExprOp::Add || n.op == ExprOp::Sub ||
      n.op == ExprOp::Mul) {
    for (const std::uint32_t arg : n.args) {
      makeReal(expr, arg);
      isReal = isReal || expr.nodes[arg].type == ExprType::Real;
    }
  }
  if (!isReal) return;
  n.type = ExprType::Real;
  n.width = 32;
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
  return static_cast<std::uint8_t>(width == 8 || operand.form == ConstantForm::Hex ? width + 1 : width);
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
  if (number.op != ExprOp::Constant || number.type != ExprType::Number || address == nullptr ||
      address->type != ExprType::Number)
    return;
  const int w = address->width;
  if (number.operand.form == ConstantForm::Hex && w >= 16 && number.value >> w == 0) {
    if ((number.value >> (w - 1) & 1) != 0) number.value -= std::int64_t{1} << w;
    number.width = signedWidth(number.value);
    return;
  }
  const bool isByte = w == 9;
  const std::int64_t lowest = isByte ? 0 : -(std::int64_t{1} << (w - 1));
  const std::int64_t highest = (std::int64_t{1} << (w - 1)) - 1;
  if (number.value >= lowest && number.value <= highest) return;
  remarks.push_back(fmt::format("{} is never {}: as the S7-200 compares it, it goes from {} to {}",
                                toString(address->operand), number.value, lowest, highest));
}

void asReals(Expr& expr, std::uint32_t left, std::uint32_t right) {
  if (expr.nodes[left].type != ExprType::Real && expr.nodes[right].type != ExprType::Real) return;
  makeReal(expr, left);
  makeReal(expr, right);
}

std::span<const std::string_view> propertyKeywords() {
  static constexpr std::array<std::string_view, 23> words = {
      "and",   "or",   "xor",    "implies", "always", "never", "leads",    "to",    "within",  "scan", "scans", "only",
      "after", "held", "unless", "prove",   "assume", "reach", "external", "pulse", "initial", "at",   "every"};
  return words;
}

bool isKeyword(std::string_view word) {
  return std::ranges::find(propertyKeywords(), word) != propertyKeywords().end();
}

}  // namespace rungproof
