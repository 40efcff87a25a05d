// Numbers of 64 bits without a sign in properties: a value above 2^63 - 1 has the pattern of a negative one.
// Tested by tests/iec/long_types_test.cpp.
#pragma once

#include "analysis/property.hpp"

namespace rungproof {

/// Whether all 64 bits of this number are its amount: ULINT, LWORD, what prev() tells of them, and a constant above
/// 2^63 - 1, whose form is Hex however it is written.
inline bool isUnsigned64(const Expr& expr, const ExprNode& node) {
  if (node.op == ExprOp::Prev) return isUnsigned64(expr, expr.nodes[node.args[0]]);
  if (node.type != ExprType::Number || node.width != 64 || node.operand.form != ConstantForm::Hex) return false;
  return node.op == ExprOp::Constant ? node.value < 0 : node.op == ExprOp::Address && numberBits(node.operand) == 64;
}

}  // namespace rungproof
