// EN and ENO of functions. Those of instances: iec_statements.cpp.
#include "frontend/iec/iec_lowering.hpp"

namespace rungproof::iec {

/// ENO => x: TRUE, but for a division by 0. Of other functions that can fail ENO has any value: what they take for an
/// error is not the same everywhere.
void Lowering::tellEnabled(Scope& scope, const std::string& name, const Expr& expr) {
  for (const Argument& argument : expr.arguments) {
    if (!argument.isOutput || foldedName(argument.name) != "ENO" || argument.value == nullptr) continue;
    const bool isStandard = functionNamed(name) == nullptr;
    if (isStandard && isPartialFunction(name)) {
      writeEnabled(scope, argument, [&] {
        const std::uint32_t any = allocate(1);
        emitPlace("ANY", *elementaryType("BOOL"), any);
        load(*elementaryType("BOOL"), any);
      });
      continue;
    }
    const std::vector<const Expr*> values = plainArguments(expr, {"IN1", "IN2"});
    const Type* type = isStandard && (name == "DIV" || name == "MOD") && values.size() == 2
                           ? ownTypeOf(scope, values, expr.span)
                           : nullptr;
    writeEnabled(scope, argument, [&] {
      if (type == nullptr || !type->isNumber()) return constant(1, 1);
      valueAs(scope, *values[1], *type);
      constant(0, type->width);
      emit("NE", {type->width, 0});
    });
  }
}

/// The truth value that `push` leaves on the stack goes to ENO => x, or inverted to NOT ENO => x.
void Lowering::writeEnabled(Scope& scope, const Argument& argument, const std::function<void()>& push) {
  const Reference target = reference(scope, *argument.value);
  if (target.valueType().kind != Kind::Bool) refuse(argument.span, "ENO needs a BOOL variable");
  prepareWrite(scope, target);
  push();
  if (argument.isNegated) emit("NOT", {1});
  writeReference(scope, target);
}

/// The EN of a call of a function; nullptr: none, or always TRUE.
const Argument* Lowering::enableOf(const Expr& expr) {
  if (expr.kind != ExprKind::Call) return nullptr;
  for (const Argument& argument : expr.arguments) {
    if (argument.isOutput || foldedName(argument.name) != "EN" || argument.value == nullptr) continue;
    const std::optional<Value> known = types_.constant(*argument.value);
    return known && known->number == 1 ? nullptr : &argument;
  }
  return nullptr;
}

/// x := F(EN := c, ...): without power flow x keeps its value, or gets 0 by the other reading, and ENO is FALSE.
void Lowering::assignWhereEnabled(Scope& scope, const Reference& target, const Expr& call, const Argument& enable) {
  const Type& type = target.valueType();
  const int skip = newLabel(), kept = newLabel(), end = newLabel();
  valueAs(scope, *enable.value, *elementaryType("BOOL"));
  jumpIfFalse(skip);
  const Expr* const outer = std::exchange(enabledCall_, &call);
  prepareWrite(scope, target);
  valueAs(scope, call, type);
  writeReference(scope, target);
  enabledCall_ = outer;
  jump(end);
  label(skip);
  emit("READING", {static_cast<std::int64_t>(Choice::IecEnFalseResult), 1});
  jumpIfFalse(kept);
  prepareWrite(scope, target);
  constant(0, type.width);
  writeReference(scope, target);
  label(kept);
  for (const Argument& argument : call.arguments) {
    if (argument.isOutput && foldedName(argument.name) == "ENO" && argument.value != nullptr)
      writeEnabled(scope, argument, [&] { constant(0, 1); });
  }
  label(end);
}

/// Of texts, which are empty by the other reading. What an array or a structure is by it is not modelled.
void Lowering::assignWholeWhereEnabled(Scope& scope, const Reference& target, const Expr& value) {
  const Argument* enable = enableOf(value);
  if (enable == nullptr) return assignWhole(scope, target, value);
  if (target.type->kind != Kind::Text || !target.indices.empty())
    refuse(enable->span, fmt::format("EN of a function that gives {} is not modelled", target.type->name),
           Syntax::IecNotModelled);
  const int skip = newLabel(), end = newLabel();
  valueAs(scope, *enable->value, *elementaryType("BOOL"));
  jumpIfFalse(skip);
  assignWhole(scope, target, value);
  jump(end);
  label(skip);
  emit("READING", {static_cast<std::int64_t>(Choice::IecEnFalseResult), 1});
  jumpIfFalse(end);
  constant(0, 8);
  store(*elementaryType("USINT"), target.offset);
  label(end);
}

}  // namespace rungproof::iec
