// Durations and dates in sums, products and conversions; powers.
#include "frontend/iec/iec_lowering.hpp"

namespace rungproof::iec {

namespace {

bool isDate(const Type* type) { return type != nullptr && type->kind == Kind::Date; }
bool isDuration(const Type* type) { return type != nullptr && type->kind == Kind::Time; }
/// What a DATE, TOD or DT counts in a day.
std::int64_t perDay(const Type& type) {
  return type.isLong() ? 86'400'000'000'000 : type.name == "TOD" ? 86'400'000 : 86'400;
}

}  // namespace

/// The type of `left op right` where the left side is a date or a time of day; nullptr: it is none, or has no such
/// operation.
const Type* Lowering::calendarResult(std::string_view op, const Type* left, const Type* right) {
  if (!isDate(left)) return nullptr;
  if (op == "-" && isDate(right) && left->name == right->name) return elementaryType(left->isLong() ? "LTIME" : "TIME");
  const bool hasTime = !left->name.ends_with("DATE");
  if ((op == "+" || op == "-") && hasTime && isDuration(right) && (left->isLong() || !right->isLong())) return left;
  if (op == "+" && left->name == "DATE" && isDate(right) && right->name == "TOD") return elementaryType("DT");
  return nullptr;
}

const Type* Lowering::calendarSum(Scope& scope, const std::string& op, const Expr& left, const Expr& right, Span span) {
  const Type *leftType = typeOf(scope, left), *rightType = typeOf(scope, right);
  const Type* result = calendarResult(op, leftType, rightType);
  if (result == nullptr) refuse(span, "dates and durations do not go together in this way");
  valueAs(scope, left, *leftType);
  valueAs(scope, right, isDuration(rightType) && leftType->isLong() ? *elementaryType("LTIME") : *rightType);
  const bool countsSeconds = !leftType->isLong() && leftType->name != "TOD";
  if (countsSeconds && (isDuration(rightType) || result->name == "DT") && rightType->name != "DT") {
    constant(1000, 32);
    emit("DIV", {32, rightType->isSigned ? 1 : 0});
  }
  emit(op == "+" ? "ADD" : "SUB", {leftType->width});
  if (countsSeconds && isDuration(result)) {
    constant(1000, 32);
    emit("MUL", {32});
  }
  return result;
}

/// The part of a date and time, or a date as the begin of its day; long and short forms do not mix.
void Lowering::convertDate(const Type& from, const Type& to, Span span) {
  if (from.name == to.name) return;
  const bool fits = from.kind == Kind::Date && to.kind == Kind::Date && from.width == to.width;
  const bool takesDay = fits && from.name.ends_with("DT") && to.name.ends_with("DATE");
  const bool takesTime = fits && from.name.ends_with("DT") && to.name.ends_with("TOD");
  const bool isBegin = fits && from.name.ends_with("DATE") && to.name.ends_with("DT");
  if (!takesDay && !takesTime && !isBegin)
    refuse(span, fmt::format("{}_TO_{} is not modelled", from.name, to.name), Syntax::IecNotModelled);
  if (isBegin) return;
  const int w = from.width;
  if (takesTime) {
    constant(perDay(from), w);
    emit("MOD", {w, 0});
    if (w == 64) return;
    constant(1000, w);
    return emit("MUL", {w});
  }
  constant(perDay(from), w);
  emit("DIV", {w, 0});
  constant(perDay(from), w);
  emit("MUL", {w});
}

/// A duration times or by a number; of a REAL the result is rounded to what the duration counts.
const Type* Lowering::scaledDuration(Scope& scope, const std::string& op, const Expr& left, const Expr& right,
                                     Span span) {
  const Type *leftType = typeOf(scope, left), *rightType = typeOf(scope, right);
  const bool isSwapped = isDuration(rightType);
  if ((!isDuration(leftType) && !isSwapped) || (isSwapped && (op == "/" || isDuration(leftType))))
    refuse(span, "a duration is multiplied or divided by a number");
  const Type& time = isSwapped ? *rightType : *leftType;
  const Type* number = isSwapped ? leftType : rightType;
  const bool isReal = number != nullptr && number->kind == Kind::Real;
  if (number != nullptr && !isReal && number->kind != Kind::Integer)
    refuse(span, "a duration is multiplied or divided by a number");
  // A divisor that the bits of a duration cut or show as negative: it is divided with twice as many.
  const bool dividesByWhole = op == "/" && number != nullptr && !isReal;
  if (dividesByWhole && number->isLong() && !number->isSigned)
    refuse(span, fmt::format("a duration divided by {} is not modelled", number->name), Syntax::IecNotModelled);
  const bool isBroad =
      dividesByWhole && !time.isLong() && (number->isLong() || (!number->isSigned && number->width == time.width));
  const auto operand = [&](const Expr& side, bool isTime) {
    const Type* type = value(scope, side, isTime ? &time : isReal ? number : elementaryType("DINT"));
    if (isTime) convertImplicitly(*type, time, side.span);
    if (isBroad) {
      emit("RESIZE", {type->width, 64, type->isSigned ? 1 : 0});
    } else if (!isReal) {
      if (!isTime) emit("RESIZE", {type->width, time.width, type->isSigned ? 1 : 0});
    } else if (isTime) {
      emit("RESIZE", {time.width, 64, 1});
      emit("TO.LREAL", {64, 1});
    } else {
      convert(*type, *elementaryType("LREAL"), false, side.span);
    }
  };
  operand(left, !isSwapped);
  operand(right, isSwapped);
  if (isReal) {
    emit(op == "*" ? "MUL.LREAL" : "DIV.LREAL");
    emit("FROM.LREAL", {time.width, 1, 1});
  } else if (op == "*") {
    emit("MUL", {time.width});
  } else if (isBroad) {
    emit("DIV", {64, 1});
    emit("RESIZE", {64, time.width, 0});
  } else {
    emit("DIV", {time.width, 1});
  }
  return &time;
}

/// REAL or LREAL, in which a function of the value is computed.
const Type* Lowering::realTypeOf(Scope& scope, const Expr& expr) {
  const Type* type = typeOf(scope, expr);
  return type != nullptr && type->isLong() ? elementaryType("LREAL") : elementaryType("REAL");
}

/// Computed as LREAL. A REAL squared is a product, which is the same number and which proofs know.
const Type* Lowering::power(Scope& scope, const Expr& base, const Expr& exponent) {
  const Type* type = realTypeOf(scope, base)->isLong() ? realTypeOf(scope, base) : realTypeOf(scope, exponent);
  const auto known = types_.constant(exponent);
  if (known && (known->isReal ? known->real == 2 : known->number == 2) && !calls(base)) {
    valueAs(scope, base, *type);
    valueAs(scope, base, *type);
    emit(type->isLong() ? "MUL.LREAL" : "MUL.REAL");
    return type;
  }
  for (const Expr* one : {&base, &exponent}) valueAs(scope, *one, *elementaryType("LREAL"));
  emit("POW.LREAL");
  if (!type->isLong()) emit("LREAL.REAL");
  return type;
}

}  // namespace rungproof::iec
