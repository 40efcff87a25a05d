// Statements: assignments, branches, loops, calls of function blocks.
#include "frontend/iec/iec_lowering.hpp"
#include "ir/iec/walk.hpp"

namespace rungproof::iec {

/// Instructions of a body that is written out keep the place of the call.
void Lowering::statements(Scope& scope, const Statements& list) {
  const Span outer = span_;
  for (const Statement& one : list) {
    if (scope.returnLabel < 0) span_ = one.span;
    statement(scope, one);
  }
  span_ = outer;
}

void Lowering::statement(Scope& scope, const Statement& s) {
  if (scope.faultLabel >= 0) guardFaults(scope, s);
  switch (s.kind) {
    case StatementKind::Assign: return assign(scope, s);
    case StatementKind::Call: return callStatement(scope, *s.target);
    case StatementKind::If: return branches(scope, s);
    case StatementKind::Case: return caseOf(scope, s);
    case StatementKind::For: return forLoop(scope, s);
    case StatementKind::While:
    case StatementKind::Repeat: {
      const int begin = newLabel(), test = newLabel(), end = newLabel();
      scope.loops.emplace_back(end, test);
      const bool testsFirst = s.kind == StatementKind::While;
      if (testsFirst) {
        label(test);
        valueAs(scope, *s.value, *elementaryType("BOOL"));
        jumpIfFalse(end);
        statements(scope, s.otherwise);
        jump(test);
      } else {
        label(begin);
        statements(scope, s.otherwise);
        label(test);
        valueAs(scope, *s.value, *elementaryType("BOOL"));
        jumpIfFalse(begin);
      }
      label(end);
      scope.loops.pop_back();
      return;
    }
    case StatementKind::Exit:
    case StatementKind::Continue:
      if (scope.loops.empty()) refuse(s.span, "EXIT and CONTINUE belong into a loop");
      return jump(s.kind == StatementKind::Exit ? scope.loops.back().first : scope.loops.back().second);
    case StatementKind::Return:
      if (scope.returnLabel >= 0) return jump(scope.returnLabel);
      return emit("RET");
    case StatementKind::Jump: return jumpStatement(scope, s);
    case StatementKind::Label: return label(labelNamed(scope, *s.target));
    case StatementKind::Try: return tryStatement(scope, s);
    case StatementKind::Line: listLabel(scope, *s.line); return listLine(scope, s);
    case StatementKind::Unread: loseResult(scope); throw Refused{};
  }
}

void Lowering::jumpStatement(Scope& scope, const Statement& s) {
  const int target = labelNamed(scope, *s.target);
  if (s.value == nullptr) return jump(target);
  valueAs(scope, *s.value, *elementaryType("BOOL"));
  emit("NOT", {1});
  jumpIfFalse(target);
}

/// The number of a label of the body.
int Lowering::labelNamed(Scope& scope, const Expr& name) {
  const std::string folded = foldedName(name.parts[0].name);
  const Statements& body = scope.action != nullptr ? scope.action->body : scope.self->block->body;
  const auto isMeant = [&](const Statement& one) {
    return one.kind == StatementKind::Label && foldedName(one.target->parts[0].name) == folded;
  };
  const auto count = std::ranges::count_if(body, isMeant);
  if (count != 1)
    refuse(name.span,
           fmt::format("there {} {}", count == 0 ? "is no label" : "are two labels", excerpt(name.parts[0].name)),
           Syntax::IecName);
  const auto [at, isNew] = scope.labels.emplace(folded, 0);
  if (isNew) at->second = newLabel();
  return at->second;
}

namespace {
bool isStandardTimer(const BlockInstance& instance) {
  return instance.block->isLibrary && instance.names.contains("STATE") && instance.names.contains("PT");
}

/// Whether another call of the same instance in these statements gives another PT.
bool givesOtherPreset(const Statements& body, const Expr& call, const Expr& preset) {
  const auto isSameInstance = [&](const Expr& other) {
    return std::ranges::equal(call.parts, other.parts, [](const PathPart& a, const PathPart& b) {
      return foldedName(a.name) == foldedName(b.name);
    });
  };
  return std::ranges::any_of(body, [&](const Statement& s) {
    const bool isOther =
        s.kind == StatementKind::Call && isSameInstance(*s.target) &&
        std::ranges::any_of(s.target->arguments, [&](const Argument& given) {
          return foldedName(given.name) == "PT" && given.value != nullptr && !isSame(*given.value, preset);
        });
    return isOther || givesOtherPreset(s.otherwise, call, preset) ||
           std::ranges::any_of(s.branches, [&](const Branch& b) { return givesOtherPreset(b.body, call, preset); });
  });
}
}  // namespace

void Lowering::assign(Scope& scope, const Statement& s) {
  if (s.target->kind != ExprKind::Path) refuse(s.target->span, "this is no variable");
  declareResult(scope, *s.target, [&] {
    const Type* own = typeOf(scope, *s.value);
    const Type* wanted = own == nullptr && s.last != nullptr ? typeOf(scope, *s.last) : own;
    return wanted != nullptr ? wanted : elementaryType("DINT");
  });
  const Reference target = reference(scope, *s.target);
  if (target.constant || (target.declared != nullptr && target.declared->isConstant))
    refuse(s.target->span, fmt::format("{} is a constant", excerpt(s.target->parts[0].name)));
  if (target.type->kind == Kind::Block) refuse(s.target->span, "an instance cannot be assigned");
  if (target.owner != nullptr && target.owner->block->name == "__STEP" && target.owner->block->isLibrary &&
      (scope.action == nullptr || !scope.action->isChart))
    refuse(s.target->span, fmt::format("{} is a step: only its chart writes it", excerpt(s.target->parts[0].name)));
  if (!target.type->isValue()) return assignWholeWhereEnabled(scope, target, *s.value);
  if (target.owner != nullptr && target.owner->block->isLibrary && scope.self != target.owner &&
      target.declared != nullptr && foldedName(target.declared->name) == "PT") {
    const auto preset = types_.integer(*s.value);
    target.owner->longestPreset = preset && target.owner->longestPreset
                                      ? std::optional(std::max(*target.owner->longestPreset, *preset))
                                      : std::nullopt;
  }
  if (const Argument* enable = enableOf(*s.value)) return assignWhereEnabled(scope, target, *s.value, *enable);
  prepareWrite(scope, target);
  valueAs(scope, *s.value, target.valueType());
  if (target.owner != nullptr && isStandardTimer(*target.owner) && scope.self != target.owner &&
      target.declared != nullptr && foldedName(target.declared->name) == "PT" && !target.owner->longestPreset)
    latchPreset(*target.owner, target.valueType());
  writeReference(scope, target);
  if (isDrawn_)
    shown_.push_back({s.target->span.offset, {}, true, static_cast<std::uint32_t>(network_->instructions.size() - 1)});
}

/// The variable for what a box of a drawing gives, where its first value is written.
void Lowering::declareResult(Scope& scope, const Expr& path, const std::function<const Type*()>& type) {
  const std::string& name = path.parts[0].name;
  if (path.parts.size() != 1 || !name.starts_with(resultPrefix)) return;
  const std::string folded = foldedName(name);
  if (scope.self->names.contains(folded)) return;
  Variable made;
  made.type = type();
  if (made.type->kind == Kind::Block || made.type->kind == Kind::Unsupported)
    refuse(path.span, fmt::format("values of type {} are not modelled", made.type->name), Syntax::IecNotModelled);
  made.offset = allocate(made.type->bytes);
  scope.self->names.emplace(folded, made);
}

/// Arrays, structures and texts: of a variable, or what a function gives.
void Lowering::assignWhole(Scope& scope, const Reference& target, const Expr& value) {
  if (target.type->kind == Kind::Text) return copyText(scope, text(scope, value), target, value.span);
  BlockInstance* function = value.kind == ExprKind::Call && value.parts.size() == 1
                                ? functionNamed(foldedName(value.parts[0].name))
                                : nullptr;
  if (value.kind != ExprKind::Path && function == nullptr)
    refuse(value.span, "only a variable of the same type can be assigned here");
  Reference source;
  if (function != nullptr) {
    const Variable& result = runFunction(scope, *function, value);
    source.type = result.type;
    source.offset = result.offset;
  } else {
    source = reference(scope, value);
  }
  const bool isSame = source.type == target.type ||
                      (source.type->name == target.type->name && source.type->kind == Kind::Struct) ||
                      (source.type->kind == Kind::Array && target.type->kind == Kind::Array &&
                       source.type->element == target.type->element && source.type->bounds == target.type->bounds);
  if (!isSame) refuse(value.span, fmt::format("{} is no {}", source.type->name, target.type->name));
  copy(scope, source, target);
}

void Lowering::branches(Scope& scope, const Statement& s) {
  const int end = newLabel();
  for (const Branch& branch : s.branches) {
    const int next = newLabel();
    valueAs(scope, *branch.condition, *elementaryType("BOOL"));
    jumpIfFalse(next);
    statements(scope, branch.body);
    if (&branch != &s.branches.back() || s.hasElse) jump(end);
    label(next);
  }
  statements(scope, s.otherwise);
  label(end);
}

/// The selector is computed once; the first label that fits wins.
void Lowering::caseOf(Scope& scope, const Statement& s) {
  const Type* type = elementaryType("DINT");
  if (!widenInBothWidths(scope, *s.value, *type)) type = value(scope, *s.value, nullptr);
  if (!type->isNumber())
    refuse(s.value->span, fmt::format("CASE needs a whole number or an enumeration, not {}", type->name));
  const std::uint32_t selector = allocate(type->bytes);
  store(*type, selector);
  const int end = newLabel();
  for (const Branch& branch : s.branches) {
    const int next = newLabel();
    bool isFirst = true;
    for (const CaseLabel& one : branch.labels) {
      caseLabel(one, *type, selector);
      if (!std::exchange(isFirst, false)) emit("OR", {1});
    }
    jumpIfFalse(next);
    statements(scope, branch.body);
    jump(end);
    label(next);
  }
  statements(scope, s.otherwise);
  label(end);
}

void Lowering::caseLabel(const CaseLabel& one, const Type& type, std::uint32_t selector) {
  const auto compare = [&](const Expr& expr, const char* op) {
    const auto known = types_.constant(expr);
    if (!known || known->isReal) refuse(expr.span, "a label of CASE is a constant");
    load(type, selector);
    pushValue(*known, type, expr.span);
    emit(op, {type.width, type.isSigned ? 1 : 0});
  };
  if (one.high == nullptr) return compare(*one.low, "EQ");
  compare(*one.low, "GE");
  compare(*one.high, "LE");
  emit("AND", {1});
}

/// Where what a limit or a step of FOR gives before the first pass is kept, if the body may change it; nothing: it is
/// the same in each pass.
std::optional<std::uint32_t> Lowering::keptBound(Scope& scope, const Statement& loop, const Expr* bound,
                                                 const Type& type) {
  if (bound == nullptr || types_.constant(*bound)) return std::nullopt;
  std::set<std::string> names;
  const auto collect = [&](const auto& self, const Expr& expr) -> void {
    if (!expr.parts.empty()) names.insert(foldedName(expr.parts[0].name));
    for (const ExprPtr& inner : expr.operands) self(self, *inner);
  };
  collect(collect, *bound);
  const auto changes = [&](const auto& self, const Statements& body) -> bool {
    return std::ranges::any_of(body, [&](const Statement& s) {
      const bool isTarget =
          s.target != nullptr && !s.target->parts.empty() && names.contains(foldedName(s.target->parts[0].name));
      const bool mayReach =
          s.kind == StatementKind::Call || s.kind == StatementKind::Line || (s.value != nullptr && calls(*s.value));
      return isTarget || mayReach || self(self, s.otherwise) ||
             std::ranges::any_of(s.branches, [&](const Branch& branch) { return self(self, branch.body); });
    });
  };
  if (!calls(*bound) && !changes(changes, loop.otherwise)) return std::nullopt;
  const std::uint32_t kept = allocate(static_cast<std::uint32_t>(type.width / 8));
  valueAs(scope, *bound, type);
  store(type, kept);
  return kept;
}

void Lowering::forLoop(Scope& scope, const Statement& s) {
  const Reference counter = reference(scope, *s.target);
  if (counter.type->kind != Kind::Integer || !counter.indices.empty() || counter.bit || counter.constant)
    refuse(s.target->span, "FOR counts in a variable of whole numbers");
  const Type& type = *counter.type;
  const int test = newLabel(), next = newLabel(), end = newLabel();
  valueAs(scope, *s.value, type);
  store(type, counter.offset);
  // A limit that is a sum is compared in more bits by one reading.
  const Type& compared = type.width < 32 && mayNeedMoreBits(scope, *s.last) ? *elementaryType("DINT") : type;
  const auto limit = keptBound(scope, s, s.last.get(), compared), step = keptBound(scope, s, s.by.get(), type);
  const auto bound = [&](const Expr& expr, const Type& as, const std::optional<std::uint32_t>& kept) {
    if (kept) emit("READING", {static_cast<std::int64_t>(Choice::IecForBounds), 1});
    valueAs(scope, expr, as);
    if (!kept) return;
    load(as, *kept);
    emit("SEL", {as.width});
  };
  const auto compare = [&](const char* op) {
    load(type, counter.offset);
    convertImplicitly(type, compared, s.target->span);
    bound(*s.last, compared, limit);
    emit(op, {compared.width, compared.isSigned ? 1 : 0});
  };
  label(test);
  const auto known = s.by != nullptr ? types_.integer(*s.by) : std::optional<std::int64_t>(1);
  if (known) {
    compare(*known > 0 ? "LE" : "GE");
  } else {
    bound(*s.by, type, step);
    constant(0, type.width);
    emit("GT", {type.width, type.isSigned ? 1 : 0});
    compare("GE");
    compare("LE");
    emit("SEL", {1});
  }
  jumpIfFalse(end);
  scope.loops.emplace_back(end, next);
  statements(scope, s.otherwise);
  scope.loops.pop_back();
  label(next);
  load(type, counter.offset);
  if (s.by != nullptr) {
    bound(*s.by, type, step);
  } else {
    constant(1, type.width);
  }
  emit("ADD", {type.width});
  store(type, counter.offset);
  jump(test);
  label(end);
}

/// On the stack is a new PT: a timer that runs keeps its own by the reading `latched`.
void Lowering::latchPreset(BlockInstance& timer, const Type& type) {
  const auto state = timer.names.find("STATE"), preset = timer.names.find("PT");
  emit("READING", {static_cast<std::int64_t>(Choice::IecTimerPreset), 1});
  load(*state->second.type, state->second.offset);
  constant(1, state->second.type->width);
  emit("EQ", {state->second.type->width, 0});
  emit("AND", {1});
  // SEL takes the condition from below both values.
  const std::uint32_t isKept = allocate(1);
  store(*elementaryType("BOOL"), isKept);
  const std::uint32_t given = allocate(static_cast<std::uint32_t>(type.width / 8));
  store(type, given);
  load(*elementaryType("BOOL"), isKept);
  load(type, given);
  load(type, preset->second.offset);
  emit("SEL", {type.width});
}

void Lowering::callStatement(Scope& scope, const Expr& call) {
  Expr path;
  path.kind = ExprKind::Path;
  path.span = call.span;
  BlockInstance* owner = nullptr;
  const std::string folded = foldedName(call.parts[0].name);
  if (scope.self != nullptr && call.parts.size() == 1 && call.arguments.empty()) {
    for (const ActionSyntax& action : scope.self->block->actions) {
      if (foldedName(action.name) == folded) return callAction(scope, action, call.span);
    }
  }
  const bool isVariable = scope.inOuts.contains(folded) || find(scope, folded, owner) != nullptr;
  if (isVariable) {
    for (const PathPart& part : call.parts) {
      PathPart& made = path.parts.emplace_back();
      made.kind = part.kind;
      made.name = part.name;
      made.bit = part.bit;
      made.bits = part.bits;
      made.span = part.span;
      for (const ExprPtr& index : part.indices) {
        const auto known = types_.integer(*index);
        if (!known) refuse(index->span, "an instance in an array needs a constant index");
        auto literal = std::make_unique<Expr>();
        literal->text = fmt::format("{}", *known);
        literal->span = index->span;
        if (*known < 0) {
          literal->text = fmt::format("{}", -*known);
          auto minus = std::make_unique<Expr>();
          minus->kind = ExprKind::Unary;
          minus->text = "-";
          minus->operands.push_back(std::move(literal));
          literal = std::move(minus);
        }
        made.indices.push_back(std::move(literal));
      }
    }
    if (BlockInstance* instance = contractOfMethod(scope, call)) {
      callContract(scope, *instance, call);
      return readOutputs(scope, *instance, call);
    }
    const Reference at = reference(scope, path);
    if (at.instance == nullptr) refuse(call.span, fmt::format("{} is no function block", excerpt(call.parts[0].name)));
    return callInstance(scope, *at.instance, call);
  }
  if (BlockInstance* function = call.parts.size() == 1 ? functionNamed(folded) : nullptr;
      function != nullptr && !function->names.at(folded).type->isValue()) {
    runFunction(scope, *function, call);
    return;
  }
  const Type* type = this->call(scope, call, nullptr);
  if (type != nullptr) {  // the result is not used
    const std::uint32_t unused = allocate(type->bytes);
    store(*type, unused);
  }
}

/// In a block with IN_OUT the action is written out, as the block itself is.
void Lowering::callAction(Scope& scope, const ActionSyntax& action, Span span) {
  if (openActions_.contains(&action)) refuse(span, fmt::format("the action {} calls itself", action.name));
  BlockInstance& self = *scope.self;
  if (!self.hasInOut) {
    const auto made = self.actions.find(foldedName(action.name));
    if (made == self.actions.end()) makeAction(self, action);
    return emit("CAL", {self.actions.at(foldedName(action.name))});
  }
  Scope inner;
  inner.self = &self;
  inner.inOuts = scope.inOuts;
  inner.caller = &scope;
  inner.action = &action;
  inner.returnLabel = newLabel();
  openActions_.insert(&action);
  try {
    beginList(inner, action.body);
    statements(inner, action.body);
    endList(inner);
  } catch (const Refused&) {
    openActions_.erase(&action);
    throw;
  }
  openActions_.erase(&action);
  label(inner.returnLabel);
}

/// Inputs, body, outputs; with EN only where it is TRUE.
void Lowering::callInstance(Scope& scope, BlockInstance& instance, const Expr& call) {
  if (scope.action != nullptr && scope.action->isCondition && !scope.action->mayCall)
    refuse(call.span,
           "a function block in such a condition of a transition is not modelled: whether it is called while its step "
           "is not active is open",
           Syntax::IecNotModelled);
  const Argument* enable = nullptr;
  const Argument* enabled = nullptr;
  for (const Argument& argument : call.arguments) {
    const std::string name = foldedName(argument.name);
    const bool isOwn = instance.names.contains(name);
    if (name == "EN" && !argument.isOutput && !isOwn) enable = &argument;
    if (name == "ENO" && argument.isOutput && !isOwn) enabled = &argument;
  }
  const Type& boolean = *elementaryType("BOOL");
  const auto tell = [&](bool isEnabled) {
    if (instance.enabled) {
      constant(isEnabled ? 1 : 0, 1);
      store(boolean, *instance.enabled);
    }
    if (enabled != nullptr && enabled->value != nullptr)
      writeEnabled(scope, *enabled, [&] { constant(isEnabled ? 1 : 0, 1); });
  };
  const int skip = newLabel(), end = newLabel();
  if (enable != nullptr) {
    valueAs(scope, *enable->value, boolean);
    jumpIfFalse(skip);
  }
  Scope inner;
  inner.self = &instance;
  if (instance.block->isContract) {
    callContract(scope, instance, call);
  } else {
    bindInputs(scope, instance, call, inner);
    runWithInOuts(scope, instance, inner, call.span);
  }
  readOutputs(scope, instance, call);
  tell(true);
  if (enable == nullptr) return;
  jump(end);
  label(skip);
  tell(false);
  label(end);
}

void Lowering::bindInputs(Scope& scope, BlockInstance& instance, const Expr& call, Scope& inner) {
  std::vector<const VariableSyntax*> inputs;
  for (const VariableSyntax& variable : instance.block->variables) {
    if (variable.section == Section::Input || variable.section == Section::InOut) inputs.push_back(&variable);
  }
  std::size_t position = 0;
  for (const Argument& argument : call.arguments) {
    if (argument.isOutput) continue;
    const std::string written = foldedName(argument.name);
    const std::string name = instance.block->isLibrary ? libraryInput(instance.block->name, written) : written;
    if (name == "EN" && !instance.names.contains(name)) continue;
    const VariableSyntax* formal = nullptr;
    if (name.empty()) {
      if (position < inputs.size()) formal = inputs[position++];
    } else {
      for (const VariableSyntax* input : inputs) {
        if (foldedName(input->name) == name) formal = input;
      }
    }
    if (formal == nullptr)
      refuse(argument.span,
             fmt::format("block {} has no input {}", instance.block->name,
                         argument.name.empty() ? std::string("more") : excerpt(argument.name)),
             Syntax::IecName);
    const auto declared = instance.names.find(foldedName(formal->name));
    if (declared == instance.names.end()) throw Refused{};  // its declaration was not understood, which is told there
    const Variable& variable = declared->second;
    if (formal->section == Section::InOut) {
      if (argument.value->kind != ExprKind::Path) refuse(argument.span, "IN_OUT needs a variable");
      const Reference actual = reference(scope, *argument.value);
      if (!actual.indices.empty() || actual.bit || actual.constant)
        refuse(argument.span, "IN_OUT with a computed element is not modelled", Syntax::IecNotModelled);
      if (actual.type != variable.type && actual.type->name != variable.type->name)
        refuse(argument.span, fmt::format("{} is no {}", actual.type->name, variable.type->name));
      inner.inOuts[foldedName(formal->name)] = actual;
      continue;
    }
    if (instance.block->isLibrary && foldedName(formal->name) == "PT") {
      const auto known = types_.constant(*argument.value);
      const bool isTime = known && known->type != nullptr && known->type->kind == Kind::Time;
      const auto preset = isTime ? std::optional(known->number) : std::nullopt;
      instance.longestPreset =
          preset && instance.longestPreset ? std::optional(std::max(*instance.longestPreset, *preset)) : std::nullopt;
    }
    if (!variable.type->isValue()) {
      Reference target;
      target.type = variable.type;
      target.offset = variable.offset;
      assignWhole(scope, target, *argument.value);
      continue;
    }
    const bool isPreset = instance.block->isLibrary && variable.type->kind == Kind::Time;
    const Type* given = isPreset ? typeOf(scope, *argument.value) : nullptr;
    if (given != nullptr && given->kind == Kind::Integer) {
      error(Syntax::IecSpelling, argument.span,
            fmt::format("{} of {} is a TIME; the number is taken as {}_TO_TIME takes it", formal->name,
                        instance.block->name, given->name));
      convert(*value(scope, *argument.value, given), *variable.type, false, argument.span);
    } else {
      valueAs(scope, *argument.value, *variable.type);
    }
    if (isPreset && foldedName(formal->name) == "PT" && isStandardTimer(instance) &&
        (!instance.longestPreset || givesOtherPreset(scope.self->block->body, call, *argument.value)))
      latchPreset(instance, *variable.type);
    store(*variable.type, instance.placeFromOutside(foldedName(formal->name)));
  }
  for (const VariableSyntax* input : inputs) {
    if (input->section == Section::InOut && !inner.inOuts.contains(foldedName(input->name)))
      refuse(call.span, fmt::format("IN_OUT {} of {} is not connected", input->name, instance.block->name));
  }
}

void Lowering::readOutputs(Scope& scope, BlockInstance& instance, const Expr& call) {
  for (const Argument& argument : call.arguments) {
    const std::string name = foldedName(argument.name);
    if (!argument.isOutput || argument.value == nullptr || (name == "ENO" && !instance.names.contains(name))) continue;
    const auto found = instance.memberNamed(name);
    if (found == instance.names.end())
      refuse(argument.span, fmt::format("block {} has no output {}", instance.block->name, excerpt(argument.name)),
             Syntax::IecName);
    if (argument.value->kind != ExprKind::Path) refuse(argument.span, "an output needs a variable");
    declareResult(scope, *argument.value, [&] { return found->second.type; });
    const Reference target = reference(scope, *argument.value);
    Reference source;
    source.type = found->second.type;
    source.offset = found->second.offset;
    if (!source.type->isValue()) {
      copy(scope, source, target);
      continue;
    }
    prepareWrite(scope, target);
    load(*source.type, source.offset);
    if (argument.isNegated) emit("NOT", {source.type->width});
    convertImplicitly(*source.type, target.valueType(), argument.span);
    if (isSubrange(target.valueType()) && source.type != &target.valueType())
      checkRange(scope, target.valueType(), argument.span);
    writeReference(scope, target);
  }
}

}  // namespace rungproof::iec
