// Sums, products and differences of whole numbers of less than 32 bits, before they are compared, divided or widened:
// the standard computes them in their declared type; implementations that translate to C compute them in 32 bits
// (`iec-intermediate`). Both are written out where they can differ, and the reading selects.
#include "frontend/iec/iec_lowering.hpp"

namespace rungproof::iec {

namespace {

bool isNarrowNumber(const Type* type) { return type != nullptr && type->kind == Kind::Integer && type->width < 32; }
bool addsUp(const std::string& op) { return op == "+" || op == "-" || op == "*"; }
bool isQuotient(const std::string& op) { return op == "/" || op == "MOD"; }

}  // namespace

/// Whether a value on the way may need more bits than its type has.
bool Lowering::mayNeedMoreBits(Scope& scope, const Expr& expr) {
  const bool isSum = expr.kind == ExprKind::Binary && addsUp(expr.text);
  const bool isOperation = isSum || (expr.kind == ExprKind::Binary && isQuotient(expr.text)) ||
                           (expr.kind == ExprKind::Unary && expr.text == "-");
  if (!isOperation || types_.constant(expr)) return false;
  if (isSum && isNarrowNumber(typeOf(scope, expr))) return true;
  return std::ranges::any_of(expr.operands, [&](const ExprPtr& inner) { return mayNeedMoreBits(scope, *inner); });
}

/// Whether it can be written out twice: nothing has an effect, and both copies divide by the same.
bool Lowering::canBeRepeated(Scope& scope, const Expr& expr) {
  if (calls(expr)) return false;
  if (expr.kind == ExprKind::Binary && isQuotient(expr.text) && mayNeedMoreBits(scope, *expr.operands[1])) return false;
  return std::ranges::all_of(expr.operands, [&](const ExprPtr& inner) { return canBeRepeated(scope, *inner); });
}

/// The value in 32 bits, each operation in 32 bits.
void Lowering::valueInCsWidth(Scope& scope, const Expr& expr) {
  const Type& wide = *elementaryType("DINT");
  const bool isNarrow = expr.kind != ExprKind::Literal && !types_.constant(expr) && isNarrowNumber(typeOf(scope, expr));
  if (isNarrow && expr.kind == ExprKind::Binary && (addsUp(expr.text) || isQuotient(expr.text))) {
    valueInCsWidth(scope, *expr.operands[0]);
    valueInCsWidth(scope, *expr.operands[1]);
    return operate(expr.text, wide, expr.span);
  }
  if (isNarrow && expr.kind == ExprKind::Unary && expr.text == "-") {
    valueInCsWidth(scope, *expr.operands[0]);
    return emit("NEG", {wide.width});
  }
  convertImplicitly(*value(scope, expr, &wide), wide, expr.span);
}

/// Writes an operation out under both readings of `iec-intermediate`; false: they cannot differ, nothing is written.
bool Lowering::operateInBothWidths(Scope& scope, const Expr& expr, const Type& type, bool isCompare) {
  const Expr &left = *expr.operands[0], &right = *expr.operands[1];
  if (writesBothWidths_ || !isNarrowNumber(&type) || (!isCompare && !isQuotient(expr.text))) return false;
  if (!mayNeedMoreBits(scope, left) && !mayNeedMoreBits(scope, right)) return false;
  if (!canBeRepeated(scope, expr)) return false;
  writesBothWidths_ = true;
  emit("READING", {static_cast<std::int64_t>(Choice::IecIntermediate), 1});
  valueAs(scope, left, type);
  valueAs(scope, right, type);
  operate(expr.text, type, expr.span);
  const Type& wide = *elementaryType("DINT");
  valueInCsWidth(scope, left);
  valueInCsWidth(scope, right);
  operate(expr.text, wide, expr.span);
  if (!isCompare) emit("RESIZE", {wide.width, type.width, 1});
  emit("SEL", {isCompare ? 1 : type.width});
  writesBothWidths_ = false;
  return true;
}

/// The same of a value that a wider number takes.
bool Lowering::widenInBothWidths(Scope& scope, const Expr& expr, const Type& wanted) {
  if (writesBothWidths_ || (wanted.kind != Kind::Integer && wanted.kind != Kind::Real)) return false;
  if (!mayNeedMoreBits(scope, expr) || !canBeRepeated(scope, expr)) return false;
  const Type* own = typeOf(scope, expr);
  if (!isNarrowNumber(own) || (wanted.kind == Kind::Integer && wanted.width <= own->width)) return false;
  writesBothWidths_ = true;
  emit("READING", {static_cast<std::int64_t>(Choice::IecIntermediate), 1});
  convertImplicitly(*value(scope, expr, nullptr), wanted, expr.span);
  valueInCsWidth(scope, expr);
  const Type& wide = *elementaryType("DINT");
  if (wanted.kind == Kind::Real)
    convert(wide, wanted, false, expr.span);
  else if (wanted.width != wide.width)
    emit("RESIZE", {wide.width, wanted.width, 1});
  emit("SEL", {wanted.width});
  writesBothWidths_ = false;
  return true;
}

}  // namespace rungproof::iec
