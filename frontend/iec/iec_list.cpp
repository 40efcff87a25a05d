// IL: each line becomes the expression that ST would have, and its value is held in a hidden variable, the current
// result. There is one such variable for each type and depth of parentheses, so that a jump finds the result where the
// label looks for it.
#include "frontend/iec/iec_lowering.hpp"
#include "frontend/iec/iec_tree.hpp"

namespace rungproof::iec {

/// Where the lines of a body stand.
struct Lowering::ListState {
  /// A result: held in a variable, or a number that takes any type.
  struct Result {
    std::string variable;
    const Type* type = nullptr;
    const Expr* number = nullptr;
    bool isLost = false;   ///< a line made it that was not lowered
    bool isMixed = false;  ///< of different types on the ways that lead here

    bool isNone() const { return variable.empty() && number == nullptr; }
  };
  struct Open {
    std::string op;
    bool isNegated;
    Result before;
    Span span;
  };
  struct Mark {
    std::string name;  ///< as written
    int number = 0;
    bool isPassed = false, isArrived = false;
    bool isUsed = false;  ///< what is current there is read behind it
    Result arrived;
  };

  Result current;
  std::vector<Open> open;
  std::map<std::string, Mark> marks;
  bool isReachable = true;
  std::string since;             ///< the label whose result is still the current one
  std::vector<ExprPtr> choices;  ///< numbers without a type that are no literals
  std::map<std::pair<int, const Type*>, std::string> held;
};

namespace {

constexpr std::size_t mostChosen = 64;  ///< inputs of MUX and its number, as FunctionKind::Mux has them

/// The operator of an expression; nothing for what is no operator of two sides.
std::string_view operatorOfList(const std::string& name) {
  static const std::map<std::string, std::string_view> all = {
      {"AND", "AND"}, {"OR", "OR"}, {"XOR", "XOR"}, {"ADD", "+"}, {"SUB", "-"}, {"MUL", "*"}, {"DIV", "/"},
      {"MOD", "MOD"}, {"GT", ">"},  {"GE", ">="},   {"EQ", "="},  {"NE", "<>"}, {"LE", "<="}, {"LT", "<"}};
  const auto found = all.find(name);
  return found == all.end() ? std::string_view{} : found->second;
}

bool changesResult(const ListLine& line) {
  return line.op != "ST" && line.op != "S" && line.op != "R" && line.op != "CAL" && line.op != "JMP" &&
         line.op != "RET";
}

/// What may have no type of its own although it is no literal: SEL and MUX of numbers, and what is computed of that. A
/// quotient is computed in its own line, because it can be a fault.
bool mayTakeAnyType(const Expr& expr) {
  if (expr.kind == ExprKind::Binary) return expr.text != "/" && expr.text != "MOD";
  if (expr.kind != ExprKind::Call || expr.parts.size() != 1 || expr.arguments.size() > mostChosen) return false;
  const std::string name = foldedName(expr.parts[0].name);
  return (name == "SEL" || name == "MUX") &&
         std::ranges::none_of(expr.arguments, [](const Argument& one) { return one.isOutput || one.value == nullptr; });
}

}  // namespace

/// Labels of the whole body: a jump may lead forward.
void Lowering::beginList(Scope& scope, const Statements& body) {
  scope.list = nullptr;
  if (std::ranges::none_of(body, [](const Statement& s) { return s.kind == StatementKind::Line; })) return;
  scope.list = std::make_shared<ListState>();
  for (const Statement& s : body) {
    if (s.kind != StatementKind::Line || s.line->label.empty()) continue;
    const auto [at, isNew] = scope.list->marks.emplace(foldedName(s.line->label), ListState::Mark{});
    at->second.name = s.line->label;
    at->second.number = newLabel();
    if (!isNew) error(Syntax::IecName, s.span, fmt::format("two lines have the label {}", excerpt(s.line->label)));
  }
}

void Lowering::endList(Scope& scope) {
  if (scope.list == nullptr) return;
  for (const ListState::Open& open : scope.list->open)
    error(Syntax::IecText, open.span, fmt::format("the parenthesis of {} is not closed", open.op));
}

ExprPtr Lowering::currentResult(Scope& scope, Span span) {
  ListState& list = *scope.list;
  if (!list.since.empty()) list.marks.at(list.since).isUsed = true;
  if (list.current.isLost) throw Refused{};
  if (list.current.isMixed) refuse(span, "the current result has different types on the ways that lead here");
  if (list.current.isNone()) refuse(span, "there is no current result here, which LD would load");
  if (list.current.number != nullptr) return copyOf(*list.current.number);
  return pathOf({list.current.variable}, span);
}

/// Computes a value into the hidden variable of its type.
ExprPtr Lowering::heldValue(Scope& scope, const Expr& expr, int depth) {
  ListState& list = *scope.list;
  const Type* type = value(scope, expr, nullptr);
  std::string& name = list.held[{depth, type}];
  if (name.empty()) {
    name = fmt::format("__LIST_{}", scope.self->names.size());
    Variable made;
    made.type = type;
    made.offset = allocate(type->bytes);
    scope.self->names.emplace(name, made);
  }
  store(*type, scope.self->names.at(name).offset);
  return pathOf({name}, expr.span);
}

/// Such numbers take the type of what the result goes into, as a literal does: they are computed there, and what they
/// choose by is asked now. What MUX does about a wrong number happens here.
const Expr* Lowering::heldChoice(Scope& scope, const Expr& expr) {
  ListState& list = *scope.list;
  ExprPtr& made = list.choices.emplace_back(copyOf(expr));
  if (made->kind != ExprKind::Call) return made.get();
  for (std::size_t i = 0; i < made->arguments.size(); ++i) {
    ExprPtr& argument = made->arguments[i].value;
    const int place = -2 - static_cast<int>(list.choices.size() * mostChosen + i);
    if (typeOf(scope, *argument) != nullptr) argument = heldValue(scope, *argument, place);
  }
  if (foldedName(made->parts[0].name) == "MUX") heldValue(scope, *made, -1);
  return made.get();
}

/// Makes the value the current result.
void Lowering::loadResult(Scope& scope, const Expr& expr) {
  ListState& list = *scope.list;
  list.since.clear();
  list.current = {};
  if (expr.kind == ExprKind::Literal && typeOf(scope, expr) == nullptr) {
    list.current.number = &expr;
    return;
  }
  if (mayTakeAnyType(expr) && typeOf(scope, expr) == nullptr) {
    list.current.number = heldChoice(scope, expr);
    return;
  }
  const int depth = static_cast<int>(list.open.size());
  const ExprPtr held = heldValue(scope, expr, depth);
  list.current.variable = held->parts[0].name;
  list.current.type = scope.self->names.at(list.current.variable).type;
}

/// Both sides of an operator are computed in any case: there is no short circuit.
void Lowering::combineResult(Scope& scope, const std::string& op, ExprPtr left, ExprPtr right, Span span) {
  if ((op == "AND" || op == "OR") && mayFault(*right)) right = heldValue(scope, *right, -1);
  const ExprPtr whole = binaryOf(operatorOfList(op), std::move(left), std::move(right));
  whole->span = span;
  loadResult(scope, *whole);
}

/// The result arrives at a label by a jump, or from the line before it.
void Lowering::carryResult(Scope& scope, const std::string& label, Span span) {
  ListState& list = *scope.list;
  ListState::Mark& mark = list.marks.at(label);
  if (!list.since.empty()) list.marks.at(list.since).isUsed = true;  // by whatever reads it behind this label
  if (list.current.number != nullptr) {
    const ExprPtr number = copyOf(*list.current.number);
    const ExprPtr held = heldValue(scope, *number, 0);
    list.current = {};
    list.current.variable = held->parts[0].name;
    list.current.type = scope.self->names.at(list.current.variable).type;
  }
  const bool isSame = mark.arrived.variable == list.current.variable;
  if (mark.isPassed) {
    if (mark.isUsed && (!isSame || list.current.isLost)) {
      if (list.current.isLost) throw Refused{};
      refuse(span, fmt::format("the current result has another type at the label {}", excerpt(mark.name)));
    }
  } else if (!mark.isArrived) {
    mark.arrived = list.current;
  } else {
    mark.arrived.isLost = mark.arrived.isLost || list.current.isLost;
    mark.arrived.isMixed = mark.arrived.isMixed || list.current.isMixed || !isSame;
  }
  mark.isArrived = true;
}

void Lowering::listLabel(Scope& scope, const ListLine& line) {
  if (line.label.empty()) return;
  ListState& list = *scope.list;
  if (!list.open.empty()) {
    const Span span = list.open.back().span;
    list.open.clear();
    refuse(span, "a label stands within parentheses");
  }
  const std::string folded = foldedName(line.label);
  ListState::Mark& mark = list.marks.at(folded);
  if (list.isReachable) carryResult(scope, folded, span_);
  list.isReachable = true;
  list.current = mark.arrived;
  list.since = folded;
  mark.isPassed = true;
  label(mark.number);
}

void Lowering::listLine(Scope& scope, const Statement& s) {
  if (s.line->op.empty()) return;
  try {
    listOperation(scope, s);
  } catch (const Refused&) {
    if (changesResult(*s.line)) loseResult(scope);
    throw;
  }
}

/// What a line made that was not lowered is not known.
void Lowering::loseResult(Scope& scope) {
  if (scope.list == nullptr) return;
  scope.list->current = {};
  scope.list->current.isLost = true;
  scope.list->since.clear();
}

void Lowering::listOperation(Scope& scope, const Statement& s) {
  ListState& list = *scope.list;
  const ListLine& line = *s.line;
  const auto operand = [&] {
    ExprPtr made = copyOf(*line.operands[0].value);
    return line.isNegated ? notOf(std::move(made)) : std::move(made);
  };
  if (line.op == ")") {
    if (list.open.empty()) refuse(s.span, "this parenthesis closes nothing");
    ExprPtr right;
    bool isLost = false;
    try {
      right = currentResult(scope, s.span);
    } catch (const Refused&) {
      isLost = true;
    }
    const ListState::Open open = std::move(list.open.back());
    list.open.pop_back();
    list.current = open.before;
    if (isLost) throw Refused{};
    if (open.isNegated) right = notOf(std::move(right));
    ExprPtr left = currentResult(scope, s.span);
    return combineResult(scope, open.op, std::move(left), std::move(right), s.span);
  }
  if (line.opens) {
    if (!list.current.isLost) static_cast<void>(currentResult(scope, line.opSpan));
    list.open.push_back({line.op, line.isNegated, list.current, s.span});
    list.current = {};
    list.since.clear();
    if (!line.operands.empty()) loadResult(scope, *line.operands[0].value);
    return;
  }
  if (line.op == "JMP" || line.op == "RET") return listJump(scope, s);
  if (line.op == "CAL") return listCall(scope, s);
  if (line.op == "LD") {
    if (!line.isNegated) return loadResult(scope, *line.operands[0].value);
    return loadResult(scope, *operand());
  }
  if (line.op == "NOT") return loadResult(scope, *notOf(currentResult(scope, line.opSpan)));
  if (line.op == "ST") {
    ExprPtr result = currentResult(scope, line.opSpan);
    if (line.isNegated) result = notOf(std::move(result));
    return assign(scope, assignmentOf(copyOf(*line.operands[0].value), std::move(result), s.span));
  }
  const bool isInput = line.operands.size() == 1 && isInstanceNamed(scope, *line.operands[0].value);
  if ((line.op == "S" || line.op == "R") && !isInput) {
    const int end = newLabel();
    jumpUnlessResult(scope, false, line.opSpan, end);
    assign(scope,
           assignmentOf(copyOf(*line.operands[0].value), literalOf(line.op == "S" ? "TRUE" : "FALSE", s.span), s.span));
    return label(end);
  }
  if (operatorOfList(line.op).empty() || line.hasNames || line.operands.size() > 1 || isInput)
    return listFunction(scope, s);
  ExprPtr left = currentResult(scope, line.opSpan);
  combineResult(scope, line.op, std::move(left), operand(), s.span);
}

/// The result is a BOOL; the jump goes where it is FALSE, with N where it is TRUE.
void Lowering::jumpUnlessResult(Scope& scope, bool isNegated, Span span, int label) {
  ExprPtr result = currentResult(scope, span);
  if (isNegated) result = notOf(std::move(result));
  valueAs(scope, *result, *elementaryType("BOOL"));
  jumpIfFalse(label);
}

/// JMP and RET; without C in any case.
void Lowering::listJump(Scope& scope, const Statement& s) {
  ListState& list = *scope.list;
  const ListLine& line = *s.line;
  if (!list.open.empty()) refuse(line.opSpan, fmt::format("{} stands within parentheses", line.op));
  const bool isConditional = line.isConditional || line.isNegated;
  int target = -1;
  if (line.op == "JMP") {
    const Expr& name = *line.operands[0].value;
    const std::string folded = foldedName(name.parts[0].name);
    const auto mark = list.marks.find(folded);
    if (mark == list.marks.end() || name.parts.size() != 1)
      refuse(name.span, fmt::format("there is no label {}", excerpt(name.parts[0].name)), Syntax::IecName);
    target = mark->second.number;
    carryResult(scope, folded, line.opSpan);
  }
  const int next = newLabel();
  if (isConditional) jumpUnlessResult(scope, line.isNegated, line.opSpan, next);
  if (line.op == "RET" && scope.returnLabel < 0)
    emit("RET");
  else
    jump(line.op == "RET" ? scope.returnLabel : target);
  label(next);
  if (!isConditional) list.isReachable = false;
}

void Lowering::listCall(Scope& scope, const Statement& s) {
  const ListLine& line = *s.line;
  const Expr& call = *line.operands[0].value;
  if (!isInstanceNamed(scope, call))
    refuse(call.span, fmt::format("{} is no instance of a function block", excerpt(call.parts[0].name)),
           Syntax::IecName);
  const int end = newLabel();
  if (line.isConditional || line.isNegated) jumpUnlessResult(scope, line.isNegated, line.opSpan, end);
  callStatement(scope, call);
  label(end);
}

/// A function with the current result as its first input, or an input of a function block: `CLK Edge` is Edge(CLK :=).
void Lowering::listFunction(Scope& scope, const Statement& s) {
  const ListLine& line = *s.line;
  if (line.operands.size() == 1 && !line.hasNames && isInstanceNamed(scope, *line.operands[0].value)) {
    const ExprPtr call = copyOf(*line.operands[0].value);
    call->kind = ExprKind::Call;
    addArgument(*call, currentResult(scope, line.opSpan), line.op);
    call->arguments[0].span = line.opSpan;
    return callStatement(scope, *call);
  }
  const ExprPtr call = callOf({line.op}, s.span);
  if (!line.hasNames) addArgument(*call, currentResult(scope, line.opSpan));
  for (const Argument& operand : line.operands) call->arguments.push_back(copyOf(operand));
  loadResult(scope, *call);
}

bool Lowering::isInstanceNamed(Scope& scope, const Expr& expr) {
  if (expr.kind != ExprKind::Path && expr.kind != ExprKind::Call) return false;
  const ExprPtr path = copyOf(expr);
  path->kind = ExprKind::Path;
  const std::size_t before = program_.findings.size();
  try {
    return reference(scope, *path, true).instance != nullptr;
  } catch (const Refused&) {
    program_.findings.resize(before);
    return false;
  }
}

/// All that a line may write which was not lowered.
std::optional<Operands> Lowering::writtenByLine(Scope& scope, const Statement& one) {
  const ListLine& line = *one.line;
  if (line.op == "ST" || line.op == "S" || line.op == "R") return placesOf(scope, *line.operands[0].value);
  const bool isOperator = line.op == "LD" || line.op == "NOT" || line.op == ")" || !operatorOfList(line.op).empty();
  return isOperator || line.op.empty() ? std::optional<Operands>(std::in_place) : std::nullopt;
}

}  // namespace rungproof::iec
