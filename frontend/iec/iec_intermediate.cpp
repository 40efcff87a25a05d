// Sums, products and differences of whole numbers of less than 32 bits, before they are compared, divided or widened:
// the standard computes them in their declared type; implementations that translate to C compute them in 32 bits
// (`iec-intermediate`). Here they are computed in 32 bits, and by the reading `declared` each result is cut to its
// type.
#include "frontend/iec/iec_lowering.hpp"

namespace rungproof::iec {

namespace {

bool isNarrowNumber(const Type* type) { return type != nullptr && type->kind == Kind::Integer && type->width < 32; }
bool addsUp(const std::string& op) { return op == "+" || op == "-" || op == "*"; }
bool isQuotient(const std::string& op) { return op == "/" || op == "MOD"; }
bool isSign(const Expr& expr) { return expr.kind == ExprKind::Unary && expr.text == "-"; }

}  // namespace

/// Whether a value on the way may need more bits than its type has.
bool Lowering::mayNeedMoreBits(Scope& scope, const Expr& expr) {
  const bool isSum = isSign(expr) || (expr.kind == ExprKind::Binary && addsUp(expr.text));
  const bool isOperation = isSum || (expr.kind == ExprKind::Binary && isQuotient(expr.text));
  if (!isOperation || types_.constant(expr)) return false;
  if (isSum && isNarrowNumber(typeOf(scope, expr))) return true;
  return std::ranges::any_of(expr.operands, [&](const ExprPtr& inner) { return mayNeedMoreBits(scope, *inner); });
}

/// A number of less than 32 bits as DINT, by the reading that is in force. Each part is computed once.
void Lowering::valueInBothWidths(Scope& scope, const Expr& expr) {
  const Type& wide = *elementaryType("DINT");
  const bool isConstant = expr.kind == ExprKind::Literal || types_.constant(expr).has_value();
  const Type* own = isConstant ? &wide : typeOf(scope, expr);
  const bool isBinary = expr.kind == ExprKind::Binary && (addsUp(expr.text) || isQuotient(expr.text));
  if (isConstant || !isNarrowNumber(own) || (!isBinary && !isSign(expr)))
    return convertImplicitly(*value(scope, expr, own), wide, expr.span);
  for (const ExprPtr& operand : expr.operands) valueInBothWidths(scope, *operand);
  if (isBinary)
    operate(expr.text, wide, expr.span);
  else
    emit("NEG", {wide.width});
  const std::uint32_t whole = allocate(static_cast<std::uint32_t>(wide.width / 8));
  store(wide, whole);
  emit("READING", {static_cast<std::int64_t>(Choice::IecIntermediate), 1});
  load(wide, whole);
  emit("RESIZE", {wide.width, own->width, 1});
  emit("RESIZE", {own->width, wide.width, own->isSigned ? 1 : 0});
  load(wide, whole);
  emit("SEL", {wide.width});
}

/// A comparison, quotient or remainder whose operands may need more bits; false: they do not, nothing is written.
bool Lowering::operateInBothWidths(Scope& scope, const Expr& expr, const Type& type, bool isCompare) {
  if (!isNarrowNumber(&type) || (!isCompare && !isQuotient(expr.text))) return false;
  const Expr &left = *expr.operands[0], &right = *expr.operands[1];
  if (!mayNeedMoreBits(scope, left) && !mayNeedMoreBits(scope, right)) return false;
  const Type& wide = *elementaryType("DINT");
  valueInBothWidths(scope, left);
  valueInBothWidths(scope, right);
  operate(expr.text, wide, expr.span);
  if (!isCompare) emit("RESIZE", {wide.width, type.width, 1});
  return true;
}

/// The same of a value that a wider number takes.
bool Lowering::widenInBothWidths(Scope& scope, const Expr& expr, const Type& wanted) {
  if ((wanted.kind != Kind::Integer && wanted.kind != Kind::Real) || !mayNeedMoreBits(scope, expr)) return false;
  const Type* own = typeOf(scope, expr);
  if (!isNarrowNumber(own) || (wanted.kind == Kind::Integer && wanted.width <= own->width)) return false;
  const Type& wide = *elementaryType("DINT");
  valueInBothWidths(scope, expr);
  if (wanted.kind == Kind::Real)
    convert(wide, wanted, false, expr.span);
  else if (wanted.width != wide.width)
    emit("RESIZE", {wide.width, wanted.width, 1});
  return true;
}

}  // namespace rungproof::iec
