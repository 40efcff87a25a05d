// Names and expressions.
#include "frontend/iec/iec_lowering.hpp"

namespace rungproof::iec {

namespace {

const Type& booleanType() { return *elementaryType("BOOL"); }
/// Whether a literal that is too large for a signed type gives its bits: 16#FFFF or 65535 for an INT.
bool isBitsOf(const Value& value, const Type& type) {
  if (type.kind != Kind::Integer || !type.isSigned) return false;
  if (type.isLong()) return value.isPattern && value.isHuge;
  const std::int64_t half = std::int64_t{1} << (type.width - 1);
  return !value.isHuge && !value.isReal && value.number >= half && value.number < 2 * half;
}
/// What gives the same bits of a place whether it is computed in these or in more.
bool isModular(const std::string& op) { return op == "+" || op == "-" || op == "*"; }
/// Whether TRUNC, whose result has the type of its place, is an operand of these sums and products.
bool hasTrunc(const Expr& expr) {
  if (expr.kind == ExprKind::Call) return expr.parts.size() == 1 && foldedName(expr.parts[0].name) == "TRUNC";
  return isModular(expr.text) &&
         std::ranges::any_of(expr.operands, [](const ExprPtr& inner) { return hasTrunc(*inner); });
}
bool isComparison(const std::string& op) {
  return op == "=" || op == "<>" || op == "<" || op == ">" || op == "<=" || op == ">=";
}

}  // namespace

/// The variable of a name in the scope; `owner` is the instance that has it, nullptr for a global one.
const Variable* Lowering::find(Scope& scope, const std::string& folded, BlockInstance*& owner) {
  owner = scope.self;
  if (scope.self != nullptr) {
    const auto own = scope.self->names.find(folded);
    if (own != scope.self->names.end()) return &own->second;
  }
  owner = nullptr;
  const auto global = globals_.find(folded);
  return global == globals_.end() ? nullptr : &global->second;
}

Reference Lowering::reference(Scope& scope, const Expr& path, bool mayBeMissing) {
  const PathPart& first = path.parts[0];
  const std::string folded = foldedName(first.name);
  Reference at;
  std::size_t next = 1;
  const auto inOut = scope.inOuts.find(folded);
  if (inOut != scope.inOuts.end()) {
    at = inOut->second;
  } else if (first.name.starts_with("%")) {
    VariableSyntax syntax;
    syntax.address = first.name;
    syntax.span = first.span;
    const char size = first.name.size() > 2 ? foldedName(first.name)[2] : '\0';
    at.type = elementaryType(size == 'B'   ? "BYTE"
                             : size == 'W' ? "WORD"
                             : size == 'D' ? "DWORD"
                             : size == 'L' ? "LWORD"
                                           : "BOOL");
    const auto offset = located(syntax, *at.type);
    if (!offset) refuse(first.span, fmt::format("{} is no address", excerpt(first.name)));
    at.offset = *offset;
  } else {
    BlockInstance* owner = nullptr;
    const Variable* variable = find(scope, folded, owner);
    if (variable == nullptr && path.parts.size() > 1) {  // GVL.Speed, Program.Output
      const auto program = std::ranges::find_if(programs_, [&](const BlockInstance* p) {
        return foldedName(p->path) == folded || foldedName(p->block->name) == folded;
      });
      const std::string second = foldedName(path.parts[1].name);
      if (program != programs_.end() && (*program)->names.contains(second)) {
        variable = &(*program)->names.at(second);
        owner = *program;
      } else if (program == programs_.end() && globals_.contains(second) &&
                 !types_.enumerator(path.parts[1].name, first.name)) {
        variable = &globals_.at(second);
      }
      if (variable != nullptr) next = 2;
    }
    if (variable == nullptr) {
      if (first.name.starts_with(resultPrefix))
        throw Refused{};  // of a box that could not be read, which is told there
      if (mayBeMissing) return at;
      refuse(first.span, fmt::format("there is no variable {}", excerpt(first.name)), Syntax::IecName);
    }
    at.type = variable->type;
    at.offset = variable->offset;
    at.constant = variable->constant;
    at.instance = variable->instance;
    at.declared = variable->declared;
    at.owner = owner;
    if (!variable->elements.empty()) {  // an array of blocks: the index has to be known
      const auto index = path.parts.size() > next && path.parts[next].kind == PathPart::Kind::Index &&
                                 path.parts[next].indices.size() == 1
                             ? types_.integer(*path.parts[next].indices[0])
                             : std::nullopt;
      if (!index || variable->type->bounds.size() != 1)
        refuse(path.span, "an instance in an array needs a constant index");
      const auto& [low, high] = variable->type->bounds[0];
      if (*index < low || *index > high) refuse(path.span, fmt::format("the array goes from {} to {}", low, high));
      at.instance = variable->elements[static_cast<std::size_t>(*index - low)];
      at.type = variable->type->element;
      ++next;
    }
  }
  for (; next < path.parts.size(); ++next) step(at, path.parts[next], path);
  if (!unmodelledPlaces_.empty() && isApartAt(at.offset))
    refuse(path.span, "an address that meets an array at another address is not modelled", Syntax::IecNotModelled);
  if (at.type != nullptr && at.type->kind == Kind::Unsupported)
    refuse(path.span, fmt::format("values of type {} are not modelled", at.type->name), Syntax::IecNotModelled);
  return at;
}

void Lowering::step(Reference& at, const PathPart& part, const Expr& path) {
  if (at.constant) refuse(part.span, "a constant has no parts");
  if (part.kind == PathPart::Kind::Index) return indexStep(at, part);
  if (at.type->kind == Kind::Unsupported)
    refuse(path.span, fmt::format("values of type {} are not modelled", at.type->name), Syntax::IecNotModelled);
  if (part.kind == PathPart::Kind::Bit) {
    if ((at.type->kind != Kind::BitString && at.type->kind != Kind::Integer) ||
        part.bit + part.bits > static_cast<std::uint32_t>(at.type->width))
      refuse(part.span, fmt::format("{} has no bit {}", at.type->name, part.bit + part.bits - 1));
    at.bit = part.bit;
    at.partType = elementaryType(part.bits == 1    ? "BOOL"
                                 : part.bits == 8  ? "BYTE"
                                 : part.bits == 16 ? "WORD"
                                                   : "DWORD");
    return;
  }
  const std::string folded = foldedName(part.name);
  if (at.instance != nullptr) {
    const auto member = at.instance->memberNamed(
        at.instance->block->isLibrary ? libraryInput(at.instance->block->name, folded) : folded);
    if (member == at.instance->names.end() && folded == "ENO" && at.instance->enabled) {
      at.owner = at.instance;
      at.type = elementaryType("BOOL");
      at.offset = *at.instance->enabled;
      at.instance = nullptr;
      return;
    }
    const bool isLeftOut = std::ranges::any_of(at.instance->block->actions, [&](const ActionSyntax& action) {
      return !action.isChart && foldedName(action.name) == folded;
    });
    if (member == at.instance->names.end() && isLeftOut)
      refuse(part.span,
             fmt::format("{} of {} from outside is not modelled", excerpt(part.name), at.instance->block->name),
             Syntax::IecNotModelled);
    if (member == at.instance->names.end())
      refuse(part.span, fmt::format("block {} has no variable {}", at.instance->block->name, excerpt(part.name)),
             Syntax::IecName);
    const Variable& variable = member->second;
    if (variable.declared != nullptr && variable.declared->section == Section::InOut)
      refuse(part.span,
             fmt::format("{} is an IN_OUT of {}: what it stands for is known in calls only; name that variable",
                         excerpt(part.name), at.instance->block->name),
             Syntax::IecNotModelled);
    if (!variable.elements.empty()) refuse(path.span, "an instance in an array of another block is not modelled");
    at.owner = at.instance;
    at.type = variable.type;
    at.offset = at.instance->placeFromOutside(member->first);
    at.constant = variable.constant;
    at.instance = variable.instance;
    at.declared = variable.declared;
    return;
  }
  if (at.type->kind != Kind::Struct) refuse(part.span, fmt::format("{} has no parts", at.type->name));
  const auto field =
      std::ranges::find_if(at.type->fields, [&](const Field& f) { return foldedName(f.name) == folded; });
  if (field == at.type->fields.end())
    refuse(part.span, fmt::format("{} has no part {}", at.type->name, excerpt(part.name)), Syntax::IecName);
  at.type = field->type;
  at.offset += field->offset;
}

void Lowering::indexStep(Reference& at, const PathPart& part) {
  if (at.type->kind != Kind::Array) refuse(part.span, fmt::format("{} is no array", at.type->name));
  if (part.indices.size() != at.type->bounds.size()) {
    refuse(part.span,
           fmt::format("the array has {} dimension{}", at.type->bounds.size(), at.type->bounds.size() == 1 ? "" : "s"));
  }
  std::uint32_t stride = at.type->bytes;
  for (std::size_t i = 0; i < part.indices.size(); ++i) {
    const auto& [low, high] = at.type->bounds[i];
    const auto count = static_cast<std::uint32_t>(high - low + 1);
    stride /= count;
    if (const auto index = types_.integer(*part.indices[i])) {
      if (*index < low || *index > high)
        refuse(part.indices[i]->span, fmt::format("index {} is outside of {}..{}", *index, low, high));
      at.offset += static_cast<std::uint32_t>(*index - low) * stride;
    } else {
      at.indices.push_back({part.indices[i].get(), low, count, stride});
    }
  }
  at.type = at.type->element;
}

const Type* Lowering::typeOf(Scope& scope, const Expr& expr) {
  switch (expr.kind) {
    case ExprKind::Text: return elementaryType("STRING");
    case ExprKind::Literal: {
      const auto known = types_.constant(expr);
      if (!known) return nullptr;
      return known->isReal && known->type == nullptr ? elementaryType("REAL") : known->type;
    }
    case ExprKind::Path: {
      const Reference at = reference(scope, expr, true);
      if (at.type == nullptr) {
        const auto item = types_.constant(expr);
        if (!item)
          refuse(expr.span, fmt::format("there is no variable {}", excerpt(expr.parts[0].name)), Syntax::IecName);
        return item->type;
      }
      if (at.constant && at.type == nullptr) return at.constant->type;
      return &at.valueType();
    }
    case ExprKind::Unary: return typeOf(scope, *expr.operands[0]);
    case ExprKind::Binary: {
      if (isComparison(expr.text)) return &booleanType();
      const Type *left = typeOf(scope, *expr.operands[0]), *right = typeOf(scope, *expr.operands[1]);
      if (left == nullptr && right == nullptr) return nullptr;
      if (expr.text == "**") {
        const Type* base = realTypeOf(scope, *expr.operands[0]);
        return base->isLong() ? base : realTypeOf(scope, *expr.operands[1]);
      }
      if (const Type* calendar = calendarResult(expr.text, left, right)) return calendar;
      if (const Type* time = durationOf(left, right)) return time;
      return common(left, right, nullptr, expr.span);
    }
    case ExprKind::Call: return resultOf(scope, expr);
  }
  return nullptr;
}

/// TIME or LTIME where one of the sides is a duration; otherwise nullptr.
const Type* Lowering::durationOf(const Type* left, const Type* right) {
  const Type* found = nullptr;
  for (const Type* side : {left, right}) {
    if (side != nullptr && side->kind == Kind::Time && (found == nullptr || side->isLong())) found = side;
  }
  return found;
}

/// The type in which both are computed.
const Type* Lowering::common(const Type* left, const Type* right, const Type* wanted, Span span) {
  if (left == nullptr && right == nullptr)
    return wanted != nullptr && wanted->isValue() && wanted->kind != Kind::Bool ? wanted : elementaryType("DINT");
  if (left == nullptr || right == nullptr) return left == nullptr ? right : left;
  if (left == right || left->name == right->name) return left;
  const auto isReal = [](const Type& t) { return t.kind == Kind::Real; };
  const bool isAnyLong = left->isLong() || right->isLong();
  if ((isReal(*left) && (isReal(*right) || right->isNumber())) || (isReal(*right) && left->isNumber()))
    return elementaryType(isAnyLong ? "LREAL" : "REAL");
  if (left->kind == Kind::Time && right->kind == Kind::Time) return elementaryType("LTIME");
  if (left->isNumber() && right->isNumber()) {
    if (left->kind == Kind::BitString && right->kind == Kind::BitString)
      return left->width >= right->width ? left : right;
    if (left->width == right->width && left->kind == Kind::BitString) return right;
    if (left->width == right->width && right->kind == Kind::BitString) return left;
    if (left->isSigned == right->isSigned) return left->width >= right->width ? left : right;
    const Type& signedOne = left->isSigned ? *left : *right;
    const Type& unsignedOne = left->isSigned ? *right : *left;
    if (signedOne.width > unsignedOne.width) return &signedOne;
    if (unsignedOne.width < 32) return elementaryType(unsignedOne.width == 8 ? "INT" : "DINT");
  }
  refuse(span, fmt::format("{} and {} do not go together", left->name, right->name));
}

const Type* Lowering::value(Scope& scope, const Expr& expr, const Type* wanted) {
  if (expr.kind != ExprKind::Path || expr.parts.size() == 1) {
    BlockInstance* owner = nullptr;
    const bool isVariable =
        expr.kind == ExprKind::Path && (scope.inOuts.contains(foldedName(expr.parts[0].name)) ||
                                        find(scope, foldedName(expr.parts[0].name), owner) != nullptr);
    if (const auto known = isVariable || expr.kind == ExprKind::Call ? std::nullopt : types_.constant(expr)) {
      const bool isLongReal = wanted != nullptr && wanted->kind == Kind::Real && wanted->isLong();
      const Type* type = known->isReal && known->type != nullptr  ? known->type
                         : known->isReal                          ? elementaryType(isLongReal ? "LREAL" : "REAL")
                         : known->type != nullptr                 ? known->type
                         : wanted != nullptr && wanted->isValue() ? wanted
                         : known->isHuge                          ? elementaryType("ULINT")
                         : known->number >= -32768 && known->number <= 32767               ? elementaryType("INT")
                         : known->number >= -2147483648LL && known->number <= 2147483647LL ? elementaryType("DINT")
                                                                                           : elementaryType("LINT");
      pushValue(*known, *type, expr.span);
      return type;
    }
  }
  switch (expr.kind) {
    case ExprKind::Text: refuse(expr.span, "a text is no value here");
    case ExprKind::Literal: {
      std::string reason;
      static_cast<void>(literalValue(expr, reason));
      refuse(expr.span, reason.empty() ? fmt::format("{} cannot be read", excerpt(expr.text)) : reason);
    }
    case ExprKind::Path: {
      const Reference at = reference(scope, expr, true);
      if (at.type == nullptr && !at.constant) {
        const auto item = types_.constant(expr);
        if (!item || item->type == nullptr)
          refuse(expr.span, fmt::format("there is no variable {}", excerpt(expr.parts[0].name)), Syntax::IecName);
        pushValue(*item, *item->type, expr.span);
        return item->type;
      }
      if (at.constant) {
        pushValue(*at.constant, *at.type, expr.span);
        return at.type;
      }
      if (!at.type->isValue()) refuse(expr.span, fmt::format("{} is no value here", at.type->name));
      readReference(scope, at);
      showValue(expr);
      return &at.valueType();
    }
    case ExprKind::Unary: return unary(scope, expr, wanted);
    case ExprKind::Binary: return binary(scope, expr, wanted);
    case ExprKind::Call: {
      const Type* result = call(scope, expr, wanted);
      showValue(expr);
      return result;
    }
  }
  return nullptr;
}

void Lowering::valueAs(Scope& scope, const Expr& expr, const Type& wanted) {
  if (!widenInBothWidths(scope, expr, wanted)) {
    const Type* type = value(scope, expr, &wanted);
    convertImplicitly(*type, wanted, expr.span);
    if (type == &wanted && expr.kind == ExprKind::Path) return;
  }
  if (!isSubrange(wanted)) return;
  const auto known = types_.integer(expr);
  if (!known || *known < wanted.low || *known > wanted.high) checkRange(scope, wanted, expr.span);
}

void Lowering::pushValue(const Value& value, const Type& wanted, Span span) {
  if (wanted.kind == Kind::Real) {
    const double real = value.isReal   ? value.real
                        : value.isHuge ? static_cast<double>(static_cast<std::uint64_t>(value.number))
                                       : static_cast<double>(value.number);
    if (value.isReal && !isWithinReal(real, wanted.width))
      refuse(span, fmt::format("the number is too large for {}", wanted.name));
    return constant(realPattern(real, wanted.width), wanted.width);
  }
  expectFits(value, wanted, span);
  if (isBitsOf(value, wanted)) return pushPattern(value, wanted, span);
  constant(value.number, wanted.width);
}

/// Refuses a constant that no variable of the type, which is not REAL, can hold.
void Lowering::expectFits(const Value& value, const Type& wanted, Span span) {
  if (value.isReal) refuse(span, fmt::format("a REAL number does not fit into {}", wanted.name));
  if (wanted.kind == Kind::Time && value.type == nullptr && value.number != 0)
    refuse(span, "a duration is written T#5s");
  if (wanted.kind == Kind::Date && value.type == nullptr && value.number != 0)
    refuse(span, fmt::format("a {} is written {}", wanted.name,
                             wanted.name.ends_with("TOD")    ? "TOD#12:30:00"
                             : wanted.name.ends_with("DATE") ? "D#2024-12-31"
                                                             : "DT#2024-12-31-12:30:00"));
  const bool isBoolean = wanted.kind == Kind::Bool;
  if (isBoolean && (value.number < 0 || value.number > 1)) refuse(span, fmt::format("{} is no BOOL", value.number));
  const bool fits = wanted.isLong()
                        ? (value.isHuge ? !wanted.isSigned : wanted.isSigned || value.number >= 0)
                        : !value.isHuge &&
                              value.number >= (wanted.isSigned ? -(std::int64_t{1} << (wanted.width - 1)) : 0) &&
                              value.number < (std::int64_t{1} << wanted.width);
  if (isBitsOf(value, wanted)) return;
  if (!fits && value.isHuge)
    refuse(span, fmt::format("{} does not fit into {}", static_cast<std::uint64_t>(value.number), wanted.name));
  if (!fits) refuse(span, fmt::format("{} does not fit into {}", value.number, wanted.name));
}

/// The number with these bits, which not all implementations take.
void Lowering::pushPattern(const Value& value, const Type& wanted, Span span) {
  tellPattern(value, wanted, span);
  emit("READING", {static_cast<std::int64_t>(Choice::IecHexLiteral), 0});
  constant(0, wanted.width);
  constant(value.number, wanted.width);
  emit("SEL", {wanted.width});
}

/// A note where a literal is taken by its bits; false: it is an ordinary number.
bool Lowering::tellPattern(const Value& value, const Type& type, Span span) {
  if (!isBitsOf(value, type)) return false;
  const auto bits = static_cast<std::uint64_t>(value.number);
  const std::int64_t number =
      type.isLong() ? value.number : value.number - (value.number >> (type.width - 1) << type.width);
  error(
      Syntax::IecSpelling, span,
      fmt::format("{} does not fit into {}: it is taken for the number with these bits, {}", bits, type.name, number));
  return true;
}

/// On the stack is a value for a variable of a subrange: outside of it the scan ends by one reading.
void Lowering::checkRange(Scope& scope, const Type& type, Span span) {
  if (scope.faultLabel >= 0) refuse(span, "a value for a subrange in __TRY is not modelled", Syntax::IecNotModelled);
  const std::uint32_t kept = allocate(type.bytes);
  const int sign = type.isSigned ? 1 : 0;
  store(type, kept);
  emit("READING", {static_cast<std::int64_t>(Choice::IecSubrange), 1});
  load(type, kept);
  constant(type.low, type.width);
  emit("LT", {type.width, sign});
  load(type, kept);
  constant(type.high, type.width);
  emit("GT", {type.width, sign});
  emit("OR", {1});
  emit("AND", {1});
  emit("FAULT");
  load(type, kept);
}

/// Where nothing is lost; a narrower or other type needs a function of conversion.
void Lowering::convertImplicitly(const Type& from, const Type& to, Span span) {
  if (&from == &to || from.name == to.name) return;
  const bool isWhole = from.isNumber() && to.isNumber();
  const bool fits =
      isWhole &&
      (from.width < to.width ? from.isSigned == to.isSigned || !from.isSigned || to.kind == Kind::BitString
                             : from.width == to.width && (from.isSigned == to.isSigned ||
                                                          from.kind == Kind::BitString || to.kind == Kind::BitString));
  if (fits) {
    if (from.width != to.width) emit("RESIZE", {from.width, to.width, from.isSigned ? 1 : 0});
    return;
  }
  const bool isLengthened = (from.kind == Kind::Real || from.kind == Kind::Time) && from.kind == to.kind && to.isLong();
  if (isLengthened || (from.kind == Kind::Integer && to.kind == Kind::Real)) return convert(from, to, false, span);
  if (from.kind == Kind::Enum && to.kind == Kind::Enum) refuse(span, fmt::format("{} is no {}", from.name, to.name));
  refuse(span, fmt::format("{} does not fit into {}: write {}_TO_{}", from.name, to.name, from.name, to.name));
}

const Type* Lowering::unary(Scope& scope, const Expr& expr, const Type* wanted) {
  const Expr& inner = *expr.operands[0];
  const Type* type = value(scope, inner, wanted);
  if (expr.text == "NOT") {
    const bool fits = type->kind == Kind::Bool || (expr.prefix.empty() && type->isNumber());
    if (!fits) refuse(expr.span, fmt::format("NOT of {}", type->name));
    emit("NOT", {type->width});
  } else if (type->kind == Kind::Real) {
    emit(type->isLong() ? "NEG.LREAL" : "NEG.REAL");
  } else {
    if (type->kind != Kind::Integer && type->kind != Kind::Time) refuse(expr.span, fmt::format("- of {}", type->name));
    emit("NEG", {type->width});
  }
  return type;
}

/// Whether it calls anything.
bool Lowering::calls(const Expr& expr) {
  if (expr.kind == ExprKind::Call) return true;
  for (const PathPart& part : expr.parts) {
    if (std::ranges::any_of(part.indices, [](const ExprPtr& index) { return calls(*index); })) return true;
  }
  return std::ranges::any_of(expr.operands, [](const ExprPtr& inner) { return calls(*inner); });
}

/// Whether computing it may end the scan, or has an effect.
bool Lowering::mayFault(const Expr& expr) const {
  if (expr.kind == ExprKind::Call) return foldedName(expr.parts[0].name) != "__READING";
  if (expr.kind == ExprKind::Binary && (expr.text == "/" || expr.text == "MOD")) return true;
  for (const PathPart& part : expr.parts) {
    for (const ExprPtr& index : part.indices) {
      if (index->kind != ExprKind::Literal) return true;
    }
  }
  return std::ranges::any_of(expr.operands, [&](const ExprPtr& inner) { return mayFault(*inner); });
}

/// The type of an operand; of TRUNC that of the place that takes the whole, where a DINT would not fit.
const Type* Lowering::operandType(Scope& scope, const Expr& operand, const Type* wanted) {
  const bool isNarrow = wanted != nullptr && wanted->kind == Kind::Integer && wanted->width < 32;
  if (!isNarrow || !hasTrunc(operand)) return typeOf(scope, operand);
  if (operand.kind == ExprKind::Call) return wanted;
  const Type* left = operandType(scope, *operand.operands.front(), wanted);
  const Type* right = operandType(scope, *operand.operands.back(), wanted);
  return common(left, right, wanted, operand.span);
}

const Type* Lowering::binary(Scope& scope, const Expr& expr, const Type* wanted) {
  const Expr &left = *expr.operands[0], &right = *expr.operands[1];
  const bool isCompare = isComparison(expr.text);
  const Type* place = isModular(expr.text) ? wanted : nullptr;
  const Type *leftType = operandType(scope, left, place), *rightType = operandType(scope, right, place);
  if (isCompare && (isText(leftType) || isText(rightType))) {
    compareTexts(scope, expr.text, left, right);
    return &booleanType();
  }
  if (calendarResult(expr.text, leftType, rightType) != nullptr)
    return calendarSum(scope, expr.text, left, right, expr.span);
  const auto isTime = [](const Type* t) { return t != nullptr && t->kind == Kind::Time; };
  if ((expr.text == "*" || expr.text == "/") && (isTime(leftType) || isTime(rightType)))
    return scaledDuration(scope, expr.text, left, right, expr.span);
  if (expr.text == "**") return power(scope, left, right);
  const Type* type = common(leftType, rightType, isCompare ? nullptr : wanted, expr.span);
  if (!type->isValue()) refuse(expr.span, fmt::format("{} is no value here", type->name));
  const bool isLazy = expr.text == "AND_THEN" || expr.text == "OR_ELSE";
  if (isLazy && type->kind != Kind::Bool) refuse(expr.span, fmt::format("{} of {}", expr.text, type->name));
  if (isLazy || (type->kind == Kind::Bool && (expr.text == "AND" || expr.text == "OR") && mayFault(right))) {
    logicWithFaults(scope, expr);
    return type;
  }
  if (!operateInBothWidths(scope, expr, *type, isCompare)) {
    valueAs(scope, left, *type);
    valueAs(scope, right, *type);
    operate(expr.text, *type, expr.span);
  }
  return isCompare ? &booleanType() : type;
}

/// Whether the right side is computed where the left one decides is open for AND and OR, and matters here; AND_THEN and
/// OR_ELSE never compute it there.
void Lowering::logicWithFaults(Scope& scope, const Expr& expr) {
  const Type& boolean = booleanType();
  const std::uint32_t decided = allocate(1);
  const int end = newLabel();
  valueAs(scope, *expr.operands[0], boolean);
  store(boolean, decided);
  const bool isLazy = expr.text == "AND_THEN" || expr.text == "OR_ELSE";
  const bool isAnd = expr.text.starts_with("AND");
  if (!isLazy) emit("READING", {static_cast<std::int64_t>(Choice::IecShortCircuit), 1});
  load(boolean, decided);
  if (isAnd) emit("NOT", {1});
  if (!isLazy) emit("AND", {1});
  emit("NOT", {1});
  jumpIfFalse(end);
  load(boolean, decided);
  valueAs(scope, *expr.operands[1], boolean);
  emit(isAnd ? "AND" : "OR", {1});
  store(boolean, decided);
  label(end);
  load(boolean, decided);
}

void Lowering::operate(const std::string& op, const Type& type, Span span) {
  static const std::map<std::string, std::string_view> names = {
      {"+", "ADD"},   {"-", "SUB"}, {"*", "MUL"}, {"/", "DIV"}, {"MOD", "MOD"}, {"AND", "AND"}, {"OR", "OR"},
      {"XOR", "XOR"}, {"=", "EQ"},  {"<>", "NE"}, {"<", "LT"},  {">", "GT"},    {"<=", "LE"},   {">=", "GE"}};
  const auto found = names.find(op);
  if (found == names.end()) refuse(span, fmt::format("{} is not modelled", op), Syntax::IecNotModelled);
  const std::string mnemonic(found->second);
  const bool isLogic = op == "AND" || op == "OR" || op == "XOR";
  const bool isArithmetic = op == "+" || op == "-" || op == "*" || op == "/" || op == "MOD";
  const bool isEquality = op == "=" || op == "<>";
  if (isLogic) {
    if (type.kind != Kind::Bool && !type.isNumber()) refuse(span, fmt::format("{} of {}", op, type.name));
    return emit(mnemonic, {type.width});
  }
  if (type.kind == Kind::Bool && !isEquality) {
    if (isArithmetic) refuse(span, fmt::format("{} of BOOL", op));
    return emit(mnemonic, {1, 0});
  }
  if (type.kind == Kind::Real) {
    if (op == "MOD") refuse(span, "MOD of REAL");
    return emit(mnemonic + (type.isLong() ? ".LREAL" : ".REAL"));
  }
  if (type.kind == Kind::Date && isArithmetic) refuse(span, fmt::format("{} of {}", op, type.name));
  if (!isArithmetic) return emit(mnemonic, {type.width, type.isSigned ? 1 : 0});
  if (op == "/" || op == "MOD") return emit(mnemonic, {type.width, type.isSigned ? 1 : 0});
  emit(mnemonic, {type.width});
}

}  // namespace rungproof::iec
