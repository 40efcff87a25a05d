// Functions: those of the standard, conversions, and the project's own.
#include "frontend/iec/iec_lowering.hpp"
#include "ir/domain.hpp"

namespace rungproof::iec {

namespace {

enum class FunctionKind : std::uint8_t {
  Operator,
  Compare,
  Shift,
  Select,
  Mux,
  Extreme,
  Limit,
  Absolute,
  RealFunction,
  LongFunction,  ///< of a REAL or LREAL, computed as LREAL
  Whole,         ///< of a REAL or LREAL, gives a DINT
  Power,
  ArcTan2,
  Scale,     ///< a duration by a number
  Calendar,  ///< sums and differences of dates
  Length,
  Find,
  Text,  ///< gives a text
  Move,
  Not
};

struct StandardFunction {
  FunctionKind call;
  std::string_view op;  ///< operator or mnemonic
  RealFunction function = RealFunction::Sqrt;
  LongRealOperation longFunction = LongRealOperation::Sqrt;
};

StandardFunction ofReal(RealFunction function, LongRealOperation same) {
  return {FunctionKind::RealFunction, "", function, same};
}

const std::map<std::string, StandardFunction>& standardFunctions() {
  static const std::map<std::string, StandardFunction> all = {
      {"ADD", {FunctionKind::Operator, "+"}},
      {"SUB", {FunctionKind::Operator, "-"}},
      {"MUL", {FunctionKind::Operator, "*"}},
      {"DIV", {FunctionKind::Operator, "/"}},
      {"MOD", {FunctionKind::Operator, "MOD"}},
      {"AND", {FunctionKind::Operator, "AND"}},
      {"OR", {FunctionKind::Operator, "OR"}},
      {"XOR", {FunctionKind::Operator, "XOR"}},
      {"NOT", {FunctionKind::Not, ""}},
      {"GT", {FunctionKind::Compare, ">"}},
      {"GE", {FunctionKind::Compare, ">="}},
      {"EQ", {FunctionKind::Compare, "="}},
      {"LE", {FunctionKind::Compare, "<="}},
      {"LT", {FunctionKind::Compare, "<"}},
      {"NE", {FunctionKind::Compare, "<>"}},
      {"SHL", {FunctionKind::Shift, "SHL"}},
      {"SHR", {FunctionKind::Shift, "SHR"}},
      {"ROL", {FunctionKind::Shift, "ROL"}},
      {"ROR", {FunctionKind::Shift, "ROR"}},
      {"SEL", {FunctionKind::Select, ""}},
      {"MUX", {FunctionKind::Mux, ""}},
      {"MAX", {FunctionKind::Extreme, "MAX"}},
      {"MIN", {FunctionKind::Extreme, "MIN"}},
      {"LIMIT", {FunctionKind::Limit, ""}},
      {"ABS", {FunctionKind::Absolute, ""}},
      {"MOVE", {FunctionKind::Move, ""}},
      {"SQRT", ofReal(RealFunction::Sqrt, LongRealOperation::Sqrt)},
      {"SIN", ofReal(RealFunction::Sin, LongRealOperation::Sin)},
      {"COS", ofReal(RealFunction::Cos, LongRealOperation::Cos)},
      {"TAN", ofReal(RealFunction::Tan, LongRealOperation::Tan)},
      {"LN", ofReal(RealFunction::Ln, LongRealOperation::Ln)},
      {"EXP", ofReal(RealFunction::Exp, LongRealOperation::Exp)},
      {"ASIN", ofReal(RealFunction::ArcSin, LongRealOperation::ArcSin)},
      {"ACOS", ofReal(RealFunction::ArcCos, LongRealOperation::ArcCos)},
      {"ATAN", ofReal(RealFunction::ArcTan, LongRealOperation::ArcTan)},
      {"LOG", {FunctionKind::LongFunction, "", {}, LongRealOperation::Log}},
      {"FLOOR", {FunctionKind::Whole, "", {}, LongRealOperation::Floor}},
      {"CEIL", {FunctionKind::Whole, "", {}, LongRealOperation::Ceil}},
      {"EXPT", {FunctionKind::Power, ""}},
      {"ATAN2", {FunctionKind::ArcTan2, ""}},
      {"ADD_TIME", {FunctionKind::Operator, "+"}},
      {"SUB_TIME", {FunctionKind::Operator, "-"}},
      {"ADD_LTIME", {FunctionKind::Operator, "+"}},
      {"SUB_LTIME", {FunctionKind::Operator, "-"}},
      {"MULTIME", {FunctionKind::Scale, "*"}},
      {"MUL_TIME", {FunctionKind::Scale, "*"}},
      {"DIVTIME", {FunctionKind::Scale, "/"}},
      {"DIV_TIME", {FunctionKind::Scale, "/"}},
      {"ADD_TOD_TIME", {FunctionKind::Calendar, "+"}},
      {"SUB_TOD_TIME", {FunctionKind::Calendar, "-"}},
      {"SUB_TOD_TOD", {FunctionKind::Calendar, "-"}},
      {"ADD_DT_TIME", {FunctionKind::Calendar, "+"}},
      {"SUB_DT_TIME", {FunctionKind::Calendar, "-"}},
      {"SUB_DT_DT", {FunctionKind::Calendar, "-"}},
      {"SUB_DATE_DATE", {FunctionKind::Calendar, "-"}},
      {"CONCAT_DATE_TOD", {FunctionKind::Calendar, "+"}},
      {"LEN", {FunctionKind::Length, ""}},
      {"FIND", {FunctionKind::Find, ""}},
      {"CONCAT", {FunctionKind::Text, ""}},
      {"LEFT", {FunctionKind::Text, ""}},
      {"RIGHT", {FunctionKind::Text, ""}},
      {"MID", {FunctionKind::Text, ""}},
      {"INSERT", {FunctionKind::Text, ""}},
      {"DELETE", {FunctionKind::Text, ""}},
      {"REPLACE", {FunctionKind::Text, ""}},
  };
  return all;
}

}  // namespace

bool isStandardFunction(const std::string& folded) {
  return standardFunctions().contains(folded) || conversionTarget(folded) != nullptr;
}

bool isPartialFunction(const std::string& folded) {
  const auto found = standardFunctions().find(folded);
  if (found == standardFunctions().end())
    return folded.starts_with("REAL_") || folded.starts_with("LREAL_") || folded.starts_with("TO_") ||
           folded.starts_with("TRUNC");
  switch (found->second.call) {
    case FunctionKind::RealFunction:
    case FunctionKind::LongFunction:
    case FunctionKind::Whole:
    case FunctionKind::Power:
    case FunctionKind::Text:
    case FunctionKind::Mux: return true;
    default: return false;
  }
}

bool isComparisonFunction(const std::string& folded) {
  const auto found = standardFunctions().find(folded);
  return found != standardFunctions().end() && found->second.call == FunctionKind::Compare;
}

/// The arguments in the order of the parameters, formal or not.
std::vector<const Expr*> Lowering::plainArguments(const Expr& expr,
                                                  std::initializer_list<std::string_view> names) const {
  std::vector<const Expr*> found;
  std::map<std::string, const Expr*> formal;
  for (const Argument& argument : expr.arguments) {
    if (argument.value == nullptr || argument.isOutput || foldedName(argument.name) == "EN") continue;
    if (argument.name.empty()) {
      found.push_back(argument.value.get());
    } else {
      formal[foldedName(argument.name)] = argument.value.get();
    }
  }
  if (formal.empty()) return found;
  for (const std::string_view name : names) {
    if (const auto at = formal.find(std::string(name)); at != formal.end()) found.push_back(at->second);
  }
  for (int i = 0; i < 64; ++i) {  // IN0, IN1 ... of those that take any number
    const std::string name = "IN" + std::to_string(i);
    if (std::ranges::find(names, name) == names.end() && formal.contains(name)) found.push_back(formal.at(name));
  }
  return found.size() == formal.size() ? found : std::vector<const Expr*>{};
}

const Type* Lowering::commonOf(Scope& scope, const std::vector<const Expr*>& values, const Type* wanted, Span span) {
  const Type* type = ownTypeOf(scope, values, span);
  return type != nullptr ? type : common(nullptr, nullptr, wanted, span);
}

/// nullptr: all of them are literals, which take any type.
const Type* Lowering::ownTypeOf(Scope& scope, const std::vector<const Expr*>& values, Span span) {
  const Type* type = nullptr;
  for (const Expr* one : values) {
    const Type* next = typeOf(scope, *one);
    if (type == nullptr || next == nullptr) {
      type = type == nullptr ? next : type;
    } else {
      type = common(type, next, nullptr, span);
    }
  }
  return type;
}

const Type* Lowering::resultOf(Scope& scope, const Expr& expr) {
  const std::string name = foldedName(expr.parts[0].name);
  if (BlockInstance* instance = contractOfMethod(scope, expr)) return resultOfMethod(*instance, expr).type;
  refuseMethod(scope, expr);
  if (const BlockInstance* own = functionNamed(name)) return own->names.at(name).type;
  return standardResult(scope, name, expr);
}

const Type* Lowering::standardResult(Scope& scope, const std::string& name, const Expr& expr) {
  if (name == "__READING") return elementaryType("BOOL");
  const auto found = standardFunctions().find(name);
  if (found == standardFunctions().end()) {
    if (const Type* target = conversionTarget(name)) return target;
    refuse(expr.span, fmt::format("there is no function and no instance {}", excerpt(expr.parts[0].name)),
           Syntax::IecName);
  }
  std::vector<const Expr*> values =
      plainArguments(expr, {"IN", "G", "K", "MN", "IN0", "IN1", "IN2", "MX", "N", "L", "P"});
  if (found->second.call == FunctionKind::Compare) return elementaryType("BOOL");
  if (values.empty()) refuse(expr.span, fmt::format("the arguments of {} do not fit", name));
  switch (found->second.call) {
    case FunctionKind::RealFunction:
    case FunctionKind::LongFunction: return realTypeOf(scope, *values[0]);
    case FunctionKind::Whole: return elementaryType("DINT");
    case FunctionKind::Power:
    case FunctionKind::ArcTan2:
      return values.size() == 2 && realTypeOf(scope, *values[1])->isLong() ? realTypeOf(scope, *values[1])
                                                                           : realTypeOf(scope, *values[0]);
    case FunctionKind::Length:
    case FunctionKind::Find: return elementaryType("INT");
    case FunctionKind::Text: return elementaryType("STRING");
    case FunctionKind::Scale:
    case FunctionKind::Calendar:
      if (values.size() != 2) refuse(expr.span, fmt::format("the arguments of {} do not fit", name));
      if (found->second.call == FunctionKind::Scale) return durationOf(typeOf(scope, *values[0]), nullptr);
      return calendarResult(found->second.op, typeOf(scope, *values[0]), typeOf(scope, *values[1]));
    default: break;
  }
  if (found->second.call == FunctionKind::Shift || found->second.call == FunctionKind::Absolute ||
      found->second.call == FunctionKind::Move || found->second.call == FunctionKind::Not)
    return typeOf(scope, *values[0]);
  if (found->second.call == FunctionKind::Select || found->second.call == FunctionKind::Mux)
    values.erase(values.begin());
  if (found->second.call == FunctionKind::Operator) {
    if (values.size() == 2) {
      const Type *left = typeOf(scope, *values[0]), *right = typeOf(scope, *values[1]);
      if (const Type* calendar = calendarResult(found->second.op, left, right)) return calendar;
      if (const Type* time = durationOf(left, right)) return time;
    }
  }
  return ownTypeOf(scope, values, expr.span);
}

const Type* Lowering::call(Scope& scope, const Expr& expr, const Type* wanted) {
  const std::string name = foldedName(expr.parts[0].name);
  if (BlockInstance* instance = contractOfMethod(scope, expr)) {
    const Variable& result = resultOfMethod(*instance, expr);
    callContract(scope, *instance, expr);
    readOutputs(scope, *instance, expr);
    load(*result.type, result.offset);
    return result.type;
  }
  refuseMethod(scope, expr);
  BlockInstance* own = functionNamed(name);
  if (const Argument* enable = enableOf(expr); enable != nullptr && &expr != enabledCall_)
    refuse(enable->span, "EN inside an expression, where it is not always TRUE, is not modelled: assign the result",
           Syntax::IecNotModelled);
  for (const Argument& argument : expr.arguments) {
    const std::string pin = foldedName(argument.name);
    if (argument.isOutput && pin != "ENO" && own == nullptr)
      refuse(argument.span, fmt::format("{} has no output {} that can be read", name, excerpt(argument.name)));
  }
  const Type* type = own != nullptr ? ownFunction(scope, *own, expr) : standardCall(scope, name, expr, wanted);
  tellEnabled(scope, name, expr);
  return type;
}

/// All arguments are computed before the first is stored: one of them may call the same function.
const Type* Lowering::ownFunction(Scope& scope, BlockInstance& function, const Expr& expr) {
  const Variable& result = runFunction(scope, function, expr);
  if (!result.type->isValue()) refuse(expr.span, fmt::format("{} is no value here", result.type->name));
  load(*result.type, result.offset);
  return result.type;
}

/// The variable that holds its result.
const Variable& Lowering::runFunction(Scope& scope, BlockInstance& function, const Expr& expr) {
  Scope inner;
  inner.self = &function;
  std::vector<const VariableSyntax*> inputs;
  for (const VariableSyntax& variable : function.block->variables) {
    if (variable.section == Section::Input || variable.section == Section::InOut) inputs.push_back(&variable);
  }
  std::vector<const Argument*> given(inputs.size(), nullptr);
  std::size_t position = 0;
  for (const Argument& argument : expr.arguments) {
    if (argument.isOutput) continue;
    if (foldedName(argument.name) == "EN") continue;
    std::size_t at = position;
    if (!argument.name.empty()) {
      at = 0;
      while (at < inputs.size() && foldedName(inputs[at]->name) != foldedName(argument.name)) ++at;
    } else {
      ++position;
    }
    if (at >= inputs.size()) refuse(argument.span, fmt::format("function {} has no such input", function.block->name));
    given[at] = &argument;
  }
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    const auto declared = function.names.find(foldedName(inputs[i]->name));
    if (declared == function.names.end()) throw Refused{};  // its declaration was not understood, which is told there
    const Variable& formal = declared->second;
    if (inputs[i]->section == Section::InOut) {
      if (given[i] == nullptr || given[i]->value->kind != ExprKind::Path) refuse(expr.span, "IN_OUT needs a variable");
      const Reference actual = reference(scope, *given[i]->value);
      if (!actual.indices.empty() || actual.bit || actual.constant)
        refuse(expr.span, "IN_OUT with a computed element is not modelled", Syntax::IecNotModelled);
      inner.inOuts[foldedName(inputs[i]->name)] = actual;
      continue;
    }
    if (!formal.type->isValue()) {
      Reference target;
      target.type = formal.type;
      target.offset = formal.offset;
      if (given[i] != nullptr) assignWhole(scope, target, *given[i]->value);
      continue;
    }
    if (given[i] != nullptr) {
      valueAs(scope, *given[i]->value, *formal.type);
    } else {
      std::optional<Value> usual;
      if (inputs[i]->initial != nullptr && inputs[i]->initial->value != nullptr)
        usual = types_.constant(*inputs[i]->initial->value);
      pushValue(usual.value_or(Value{formal.type, 0}), *formal.type, expr.span);
    }
  }
  for (std::size_t i = inputs.size(); i-- > 0;) {
    if (inputs[i]->section == Section::InOut) continue;
    const auto declared = function.names.find(foldedName(inputs[i]->name));
    if (declared == function.names.end()) throw Refused{};  // its declaration was not understood, which is told there
    const Variable& formal = declared->second;
    if (formal.type->isValue()) store(*formal.type, formal.offset);
  }
  runWithInOuts(scope, function, inner, expr.span);
  readOutputs(scope, function, expr);
  return function.names.at(foldedName(function.block->name));
}

/// MIN(MAX(IN, MN), MX); by the other reading MN where IN is not above it, which is the same unless MN is above MX.
void Lowering::limit(Scope& scope, const std::vector<const Expr*>& values, const Type& type,
                     const std::function<void(std::string_view)>& extreme) {
  const auto low = types_.constant(*values[0]), high = types_.constant(*values[2]);
  const bool isOrdered = low && high && !low->isReal && !high->isReal && low->number <= high->number;
  const auto clamp = [&] {
    valueAs(scope, *values[1], type);
    valueAs(scope, *values[0], type);
    extreme("MAX");
    valueAs(scope, *values[2], type);
    extreme("MIN");
  };
  if (isOrdered) return clamp();
  emit("READING", {static_cast<std::int64_t>(Choice::IecLimitCrossed), 1});
  clamp();
  valueAs(scope, *values[1], type);
  valueAs(scope, *values[2], type);
  extreme("MIN");
  valueAs(scope, *values[0], type);
  extreme("MAX");
  emit("SEL", {type.width});
}

/// MUX: what a K gives that selects no input is a reading.
const Type* Lowering::multiplexer(Scope& scope, const std::vector<const Expr*>& values, const Type* wanted, Span span) {
  const std::vector<const Expr*> inputs(values.begin() + 1, values.end());
  const Type* type = commonOf(scope, inputs, wanted, span);
  const Type* number = value(scope, *values[0], elementaryType("DINT"));
  if (!number->isNumber()) refuse(values[0]->span, "K of MUX is a whole number");
  const std::uint32_t selector = allocate(number->bytes), result = allocate(type->bytes);
  store(*number, selector);
  const auto known = types_.integer(*values[0]);
  const bool mayMiss = !known || *known < 0 || *known >= static_cast<std::int64_t>(inputs.size());
  const auto reads = [&](std::int64_t reading) {
    emit("READING", {static_cast<std::int64_t>(Choice::IecMuxRange), reading});
  };
  const auto misses = [&] {
    load(*number, selector);
    constant(0, number->width);
    emit("LT", {number->width, number->isSigned ? 1 : 0});
    load(*number, selector);
    constant(static_cast<std::int64_t>(inputs.size()), number->width);
    emit("GE", {number->width, number->isSigned ? 1 : 0});
    emit("OR", {1});
  };
  if (mayMiss) {
    reads(1);
    misses();
    emit("AND", {1});
    emit("FAULT");
  }
  constant(0, type->width);
  store(*type, result);
  const std::uint32_t last = mayMiss ? allocate(type->bytes) : result;
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    const bool isKept = mayMiss && i + 1 == inputs.size();
    if (isKept) {
      valueAs(scope, *inputs[i], *type);
      store(*type, last);
    }
    load(*number, selector);
    constant(static_cast<std::int64_t>(i), number->width);
    emit("EQ", {number->width, 0});
    load(*type, result);
    isKept ? load(*type, last) : valueAs(scope, *inputs[i], *type);
    emit("SEL", {type->width});
    store(*type, result);
  }
  if (mayMiss) {
    reads(2);
    misses();
    emit("AND", {1});
    load(*type, result);
    load(*type, last);
    emit("SEL", {type->width});
    store(*type, result);
  }
  load(*type, result);
  return type;
}

const Type* Lowering::standardCall(Scope& scope, const std::string& name, const Expr& expr, const Type* wanted) {
  const Type& boolean = *elementaryType("BOOL");
  if (name == "__READING") {
    std::vector<std::string> texts;
    for (const Argument& argument : expr.arguments) {
      const bool isText = argument.value != nullptr && argument.value->kind == ExprKind::Text;
      if (isText && argument.value->text.size() > 1)
        texts.push_back(argument.value->text.substr(1, argument.value->text.size() - 2));
    }
    Choices known;
    if (texts.size() != 2 || !known.set(texts[0], texts[1]))
      refuse(expr.span, "__READING takes the name of a choice and one of its readings");
    for (const ChoiceInfo& info : choiceTable) {
      if (info.choice == Choice::IecTimerDone && known.isChosen(info.choice) && !mayChangePreset(*scope.self)) {
        constant(0, 1);
        return &boolean;
      }
      if (known.isChosen(info.choice)) emit("READING", {static_cast<std::int64_t>(info.choice), known[info.choice]});
    }
    return &boolean;
  }
  const auto found = standardFunctions().find(name);
  if (found == standardFunctions().end()) {
    // TRUNC has any type of whole numbers: that of the place that takes it.
    const bool isOverloaded = name == "TRUNC" && wanted != nullptr && wanted->kind == Kind::Integer;
    return conversion(scope, isOverloaded ? fmt::format("TRUNC_{}", wanted->name) : name, expr);
  }
  const StandardFunction& row = found->second;
  std::vector<const Expr*> values =
      plainArguments(expr, {"IN", "G", "K", "MN", "IN0", "IN1", "IN2", "MX", "N", "L", "P"});
  if (row.call == FunctionKind::Limit) values = plainArguments(expr, {"MN", "IN", "MX"});
  const auto need = [&](std::size_t least, std::size_t most) {
    if (values.size() < least || values.size() > most)
      refuse(expr.span, fmt::format("the arguments of {} do not fit", name));
  };
  const auto isTimeValue = [&](const Expr* one) {
    const Type* type = typeOf(scope, *one);
    return type != nullptr && type->kind == Kind::Time;
  };
  switch (row.call) {
    case FunctionKind::Not: {
      need(1, 1);
      const Type* type = value(scope, *values[0], wanted);
      emit("NOT", {type->width});
      return type;
    }
    case FunctionKind::Move: need(1, 1); return value(scope, *values[0], wanted);
    case FunctionKind::Operator: {
      need(2, 64);
      if ((row.op == "*" || row.op == "/") && values.size() == 2 && (isTimeValue(values[0]) || isTimeValue(values[1])))
        return scaledDuration(scope, std::string(row.op), *values[0], *values[1], expr.span);
      if (values.size() == 2 && calendarResult(row.op, typeOf(scope, *values[0]), typeOf(scope, *values[1])) != nullptr)
        return calendarSum(scope, std::string(row.op), *values[0], *values[1], expr.span);
      const Type* type = commonOf(scope, values, wanted, expr.span);
      valueAs(scope, *values[0], *type);
      for (std::size_t i = 1; i < values.size(); ++i) {
        valueAs(scope, *values[i], *type);
        operate(std::string(row.op), *type, expr.span);
      }
      return type;
    }
    case FunctionKind::Compare: {
      need(2, 64);
      if (isText(typeOf(scope, *values[0]))) {
        for (std::size_t i = 0; i + 1 < values.size(); ++i) {
          compareTexts(scope, std::string(row.op), *values[i], *values[i + 1]);
          if (i > 0) emit("AND", {1});
        }
        return &boolean;
      }
      const Type* type = commonOf(scope, values, nullptr, expr.span);
      for (std::size_t i = 0; i + 1 < values.size(); ++i) {
        valueAs(scope, *values[i], *type);
        valueAs(scope, *values[i + 1], *type);
        operate(std::string(row.op), *type, expr.span);
        if (i > 0) emit("AND", {1});
      }
      return &boolean;
    }
    case FunctionKind::Shift: {
      need(2, 2);
      const Type* type = value(scope, *values[0], wanted);
      if (!type->isNumber()) refuse(expr.span, fmt::format("{} of {}", name, type->name));
      const Type* count = value(scope, *values[1], elementaryType("DINT"));
      if (!count->isNumber()) refuse(expr.span, fmt::format("a count of type {}", count->name));
      emit("RESIZE", {count->width, 32, count->isSigned ? 1 : 0});
      emit(type->isSigned && row.op == "SHR" ? "SAR" : row.op, {type->width});
      return type;
    }
    case FunctionKind::Select: {
      need(3, 3);
      valueAs(scope, *values[0], boolean);
      const Type* type = commonOf(scope, {values[1], values[2]}, wanted, expr.span);
      valueAs(scope, *values[1], *type);
      valueAs(scope, *values[2], *type);
      emit("SEL", {type->width});
      return type;
    }
    case FunctionKind::Mux: need(3, 64); return multiplexer(scope, values, wanted, expr.span);
    case FunctionKind::Extreme:
    case FunctionKind::Limit: {
      if (row.call == FunctionKind::Limit) need(3, 3);
      need(2, 64);
      const Type* type = commonOf(scope, values, wanted, expr.span);
      const auto extreme = [&](std::string_view op) {
        if (type->kind == Kind::Real) return emit(fmt::format("{}{}", op, type->isLong() ? ".LREAL" : ".REAL"));
        emit(op, {type->width, type->isSigned ? 1 : 0});
      };
      if (row.call == FunctionKind::Limit) {
        limit(scope, values, *type, extreme);
        return type;
      }
      valueAs(scope, *values[0], *type);
      for (std::size_t i = 1; i < values.size(); ++i) {
        valueAs(scope, *values[i], *type);
        extreme(row.op);
      }
      return type;
    }
    case FunctionKind::Absolute: {
      need(1, 1);
      const Type* type = value(scope, *values[0], wanted);
      if (type->kind == Kind::Real) {
        emit(type->isLong() ? "ABS.LREAL" : "ABS.REAL");
      } else if (type->isSigned) {
        emit("ABS", {type->width});
      }
      return type;
    }
    case FunctionKind::RealFunction: {
      need(1, 1);
      const Type* type = realTypeOf(scope, *values[0]);
      valueAs(scope, *values[0], *type);
      emit(type->isLong() ? "FUNC.LREAL" : "FUNC.REAL",
           {type->isLong() ? static_cast<std::int64_t>(row.longFunction) : static_cast<std::int64_t>(row.function)});
      return type;
    }
    case FunctionKind::LongFunction:
    case FunctionKind::Whole: {
      need(1, 1);
      const Type* type = realTypeOf(scope, *values[0]);
      valueAs(scope, *values[0], *elementaryType("LREAL"));
      emit("FUNC.LREAL", {static_cast<std::int64_t>(row.longFunction)});
      if (row.call == FunctionKind::Whole) {
        emit("FROM.LREAL", {32, 1, 0});
        return elementaryType("DINT");
      }
      if (!type->isLong()) emit("LREAL.REAL");
      return type;
    }
    case FunctionKind::Power: need(2, 2); return power(scope, *values[0], *values[1]);
    case FunctionKind::ArcTan2: {
      need(2, 2);
      const Type* type = standardResult(scope, name, expr);
      for (const Expr* one : values) valueAs(scope, *one, *elementaryType("LREAL"));
      emit("ATAN2.LREAL");
      if (!type->isLong()) emit("LREAL.REAL");
      return type;
    }
    case FunctionKind::Scale:
      need(2, 2);
      return scaledDuration(scope, std::string(row.op), *values[0], *values[1], expr.span);
    case FunctionKind::Calendar:
      need(2, 2);
      return calendarSum(scope, std::string(row.op), *values[0], *values[1], expr.span);
    case FunctionKind::Length: {
      need(1, 1);
      const TextAt at = text(scope, *values[0]);
      emitTexts("LEN.TEXT", {at});
      return elementaryType("INT");
    }
    case FunctionKind::Find: {
      need(2, 2);
      const TextAt whole = text(scope, *values[0]), what = text(scope, *values[1]);
      emitTexts("FIND.TEXT", {whole, what});
      return elementaryType("INT");
    }
    case FunctionKind::Text: refuse(expr.span, fmt::format("the text of {} is no value here", name));
  }
  return nullptr;
}

}  // namespace rungproof::iec
