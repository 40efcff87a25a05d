// Numbers of 64 bits without a sign in properties: a value above 2^63 - 1 has the pattern of a negative one.
// Tested by tests/iec/long_types_test.cpp.
#pragma once

#include "analysis/property.hpp"

namespace rungproof {

/// The form of a constant above 2^63 - 1 that is written in decimals: an amount beside any number. A pattern (Hex) has
/// a sign beside a number with one.
inline constexpr ConstantForm amountForm = ConstantForm::Typed;

/// Whether all 64 bits of this number are its amount: ULINT, LWORD, what prev() tells of them, and a constant above
/// 2^63 - 1.
inline bool isUnsigned64(const Expr& expr, const ExprNode& node) {
  if (node.op == ExprOp::Prev) return isUnsigned64(expr, expr.nodes[node.args[0]]);
  if (node.type != ExprType::Number || node.width != 64) return false;
  const ConstantForm form = node.operand.form;
  if (node.op == ExprOp::Constant) return node.value < 0 && (form == ConstantForm::Hex || form == amountForm);
  return form == ConstantForm::Hex && node.op == ExprOp::Address && numberBits(node.operand) == 64;
}

}  // namespace rungproof
