// __TRY, __CATCH, __FINALLY, an extension of CODESYS: a whole number divided by 0 in what is tried ends it there, and
// the statements behind __CATCH run. Other faults of a controller (an index outside its array, a REAL division) are not
// modelled inside of it. Whether a division by 0 is a fault at all is a reading (Choice::IecDivZero, IecModZero).
#include <algorithm>

#include "frontend/iec/iec_lowering.hpp"
#include "ir/iec/walk.hpp"

namespace rungproof::iec {

namespace {

bool isDivision(const Expr& expr) {
  if (expr.kind == ExprKind::Binary) return expr.text == "/" || expr.text == "MOD";
  if (expr.kind != ExprKind::Call || expr.parts.size() != 1) return false;
  const std::string name = foldedName(expr.parts[0].name);
  return name == "DIV" || name == "MOD";
}

bool divides(const Expr& expr) {
  bool found = false;
  eachPart(expr, [&](const Expr& part) { found = found || isDivision(part); });
  return found;
}

/// Whether the second operand of an AND or OR divides, which may not be computed at all.
bool dividesBehindLogic(const Expr& expr) {
  bool found = false;
  eachPart(expr, [&](const Expr& part) {
    const bool isLogic = part.kind == ExprKind::Binary && (part.text.starts_with("AND") || part.text == "&" ||
                                                           part.text.starts_with("OR") || part.text == "XOR");
    for (std::size_t i = 1; isLogic && i < part.operands.size(); ++i) found = found || divides(*part.operands[i]);
  });
  return found;
}

bool leaves(const Statements& list) {
  bool found = false;
  eachStatement(list, [&](const Statement& one, const Statements&, std::size_t) {
    using enum StatementKind;
    found = found || one.kind == Return || one.kind == Exit || one.kind == Continue;
  });
  return found;
}

}  // namespace

void Lowering::tryStatement(Scope& scope, const Statement& s) {
  const Branch &caught = s.branches[0], &last = s.branches[1];
  if (!last.body.empty() && (leaves(s.otherwise) || leaves(caught.body)))
    refuse(s.span, "RETURN, EXIT and CONTINUE in front of __FINALLY are not modelled", Syntax::IecNotModelled);
  const int fault = newLabel(), end = newLabel();
  const int outer = std::exchange(scope.faultLabel, fault);
  statements(scope, s.otherwise);
  scope.faultLabel = outer;
  jump(end);
  label(fault);
  statements(scope, caught.body);
  label(end);
  statements(scope, last.body);
}

/// In front of a statement that is tried: leaves what is tried where one of its divisions meets 0.
void Lowering::guardFaults(Scope& scope, const Statement& s) {
  const auto guard = [&](const ExprPtr& expr) {
    if (expr == nullptr) return;
    // A function that writes what a divisor reads would do so between the guard and the division.
    bool callsOwn = false;
    eachPart(*expr, [&](const Expr& part) {
      callsOwn = callsOwn || (part.kind == ExprKind::Call && &part != s.target.get() && !part.parts.empty() &&
                              blocks_.contains(foldedName(part.parts[0].name)));
    });
    if (callsOwn && divides(*expr))
      refuse(expr->span, "a division beside a call of a function in __TRY is not modelled", Syntax::IecNotModelled);
    guardDivisions(scope, *expr);
  };
  const auto mayNotDivide = [&](const Expr* expr) {
    if (expr != nullptr && mayFault(*expr))
      refuse(expr->span, "what may fault in such a condition of __TRY is not modelled", Syntax::IecNotModelled);
  };
  switch (s.kind) {
    case StatementKind::Assign:
    case StatementKind::Call: guard(s.value); return guard(s.target);
    case StatementKind::If:
      guard(s.branches[0].condition);
      for (std::size_t i = 1; i < s.branches.size(); ++i) mayNotDivide(s.branches[i].condition.get());
      return;
    case StatementKind::Case: return guard(s.value);
    case StatementKind::For:
    case StatementKind::While:
    case StatementKind::Repeat:
      for (const ExprPtr* part : {&s.value, &s.last, &s.by}) mayNotDivide(part->get());
      return;
    default: return;
  }
}

/// Divisors from the inside out, as they are computed.
void Lowering::guardDivisions(Scope& scope, const Expr& expr) {
  if (dividesBehindLogic(expr))
    refuse(expr.span, "a division behind AND or OR in __TRY is not modelled", Syntax::IecNotModelled);
  for (const PathPart& part : expr.parts) {
    for (const ExprPtr& index : part.indices) {
      if (!types_.integer(*index))
        refuse(index->span, "a computed index in __TRY is not modelled", Syntax::IecNotModelled);
    }
  }
  for (const ExprPtr& operand : expr.operands) guardDivisions(scope, *operand);
  for (const Argument& argument : expr.arguments) {
    if (argument.value != nullptr && !argument.isOutput) guardDivisions(scope, *argument.value);
  }
  if (const Argument* enable = enableOf(expr); enable != nullptr && divides(expr))
    refuse(enable->span, "a division with EN in __TRY is not modelled", Syntax::IecNotModelled);
  if (expr.kind == ExprKind::Call && !isDivision(expr)) return guardCall(scope, expr);
  if (!isDivision(expr)) return;
  const bool isCall = expr.kind == ExprKind::Call;
  const std::vector<const Expr*> values =
      isCall ? plainArguments(expr, {"IN1", "IN2"})
             : std::vector<const Expr*>{expr.operands[0].get(), expr.operands[1].get()};
  if (values.size() != 2) return;  // the lowering of the division says so
  const Type* type = ownTypeOf(scope, values, expr.span);
  if (type == nullptr) type = elementaryType("DINT");
  if (!type->isNumber()) refuse(expr.span, "a REAL division in __TRY is not modelled", Syntax::IecNotModelled);
  const bool isRemainder = isCall ? foldedName(expr.parts[0].name) == "MOD" : expr.text == "MOD";
  const Choice choice = isRemainder ? Choice::IecModZero : Choice::IecDivZero;
  const auto& readings = choiceInfo(choice).values;
  const auto fault = std::ranges::find(readings, "fault") - readings.begin();
  emit("READING", {static_cast<std::int64_t>(choice), fault});
  valueAs(scope, *values[1], *type);
  constant(0, type->width);
  emit("EQ", {type->width, 0});
  emit("AND", {1});
  emit("NOT", {1});
  jumpIfFalse(scope.faultLabel);
}

/// A call whose body may fault would leave it in the middle.
void Lowering::guardCall(Scope& scope, const Expr& call) {
  BlockInstance* owner = nullptr;
  const std::string name = foldedName(call.parts[0].name);
  const BlockSyntax* body = nullptr;
  if (const Variable* variable = find(scope, name, owner); variable != nullptr && variable->instance != nullptr)
    body = variable->instance->block;
  else if (const auto block = blocks_.find(name); block != blocks_.end())
    body = block->second;
  if (body == nullptr || body->isLibrary) return;
  bool faults = false;
  eachStatementOf(*body, [&](const Statement& one, const Statements&, std::size_t) {
    faults = faults || one.kind == StatementKind::Line;
    eachExpression(one, [&](const Expr& expr) { faults = faults || mayFault(expr); });
  });
  if (faults) refuse(call.span, "a call in __TRY whose body may fault is not modelled", Syntax::IecNotModelled);
}

}  // namespace rungproof::iec
