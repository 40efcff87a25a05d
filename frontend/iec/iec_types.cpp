// Types: their names, their places, constants that declarations name.
#include "frontend/iec/iec_types.hpp"

#include <bit>
#include <limits>
#include <set>

namespace rungproof::iec {

namespace {

Type elementary(Kind kind, std::string_view name, int width, bool isSigned, std::int64_t low, std::int64_t high) {
  Type made;
  made.kind = kind;
  made.name = name;
  made.width = width;
  made.isSigned = isSigned;
  made.bytes = static_cast<std::uint32_t>((width + 7) / 8);
  made.low = low;
  made.high = high;
  return made;
}

/// Characters of a STRING without a length; implementations differ (80 is that of CODESYS).
constexpr std::int64_t usualTextLength = 80;

Type textType(std::int64_t length) {
  Type made = elementary(Kind::Text, "STRING", 0, false, 0, length);
  made.bytes = static_cast<std::uint32_t>(1 + length);
  return made;
}

const std::map<std::string_view, Type>& elementaryTypes() {
  static const std::map<std::string_view, Type> all = [] {
    std::map<std::string_view, Type> made;
    const auto of = [&](Kind kind, std::string_view name, int width, bool isSigned) {
      constexpr std::int64_t least = std::numeric_limits<std::int64_t>::min();
      const std::int64_t top = width < 64 ? std::int64_t{1} << (isSigned ? width - 1 : width) : 0;
      const std::int64_t low = !isSigned ? 0 : width < 64 ? -top : least;
      made.emplace(name, elementary(kind, name, width, isSigned, low, width < 64 ? top - 1 : isSigned ? ~least : -1));
    };
    const auto number = [&](std::string_view name, int width, bool isSigned) {
      of(Kind::Integer, name, width, isSigned);
    };
    made.emplace("BOOL", elementary(Kind::Bool, "BOOL", 1, false, 0, 1));
    number("SINT", 8, true);
    number("INT", 16, true);
    number("DINT", 32, true);
    number("USINT", 8, false);
    number("UINT", 16, false);
    number("UDINT", 32, false);
    number("LINT", 64, true);
    number("ULINT", 64, false);
    for (const auto& [name, width] : {std::pair{"BYTE", 8}, {"WORD", 16}, {"DWORD", 32}, {"LWORD", 64}})
      of(Kind::BitString, name, width, false);
    made.emplace("REAL", elementary(Kind::Real, "REAL", 32, true, 0, 0));
    made.emplace("LREAL", elementary(Kind::Real, "LREAL", 64, true, 0, 0));
    of(Kind::Time, "TIME", 32, true);
    of(Kind::Time, "LTIME", 64, true);
    for (const std::string_view name : {"DATE", "TOD", "DT"}) of(Kind::Date, name, 32, false);
    for (const std::string_view name : {"LDATE", "LTOD", "LDT"}) of(Kind::Date, name, 64, true);
    for (const auto& [name, same] : {std::pair{"TIME_OF_DAY", "TOD"},
                                     {"DATE_AND_TIME", "DT"},
                                     {"LTIME_OF_DAY", "LTOD"},
                                     {"LDATE_AND_TIME", "LDT"}})
      made.emplace(name, made.at(same));
    made.emplace("STRING", textType(usualTextLength));
    for (const std::string_view name :
         {"WSTRING", "CHAR", "WCHAR", "POINTER", "REF_TO", "REFERENCE", "ANY", "__SYSTEM.EXCEPTIONCODE"})
      made.emplace(name, elementary(Kind::Unsupported, name, 0, false, 0, 0));
    // Variables that a panel of Beremiz shows and sets have types of their own.
    static constexpr std::string_view panels[] = {"HMI_BOOL",  "HMI_SINT",   "HMI_INT",   "HMI_DINT",  "HMI_LINT",
                                                  "HMI_USINT", "HMI_UINT",   "HMI_UDINT", "HMI_ULINT", "HMI_REAL",
                                                  "HMI_LREAL", "HMI_STRING", "HMI_BYTE",  "HMI_WORD",  "HMI_DWORD"};
    for (const std::string_view name : panels) made.emplace(name, made.at(name.substr(panelPrefix.size())));
    return made;
  }();
  return all;
}

}  // namespace

const Type* elementaryType(std::string_view folded) {
  const auto found = elementaryTypes().find(folded);
  return found == elementaryTypes().end() ? nullptr : &found->second;
}

bool isSubrange(const Type& type) {
  const Type* base = type.kind == Kind::Integer && !type.isLong() ? elementaryType(type.name) : nullptr;
  return base != nullptr && (type.low > base->low || type.high < base->high);
}

std::optional<ValueLimits> limitsOf(const Type& type) {
  constexpr std::int64_t msOfDay = 86'400'000;
  ValueLimits limits;
  limits.width = type.width;
  limits.isSigned = type.isSigned;
  if (isSubrange(type)) {
    limits.runs = {{type.low, type.high}};
  } else if (type.kind == Kind::Date && type.name.ends_with("TOD")) {
    limits.runs = {{0, (type.isLong() ? msOfDay * 1'000'000 : msOfDay) - 1}};
  } else if (type.kind == Kind::Enum) {
    std::set<std::int64_t> values;
    for (const auto& [name, value] : type.items) values.insert(value);
    for (const std::int64_t value : values) {
      if (limits.runs.empty() || limits.runs.back().second + 1 != value)
        limits.runs.emplace_back(value, value);
      else
        limits.runs.back().second = value;
    }
  }
  if (limits.runs.empty()) return std::nullopt;
  return limits;
}

TypeTable::TypeTable(const ProjectSyntax& project, SyntaxSink& sink) : sink_(sink) {
  for (const BlockSyntax& block : project.blocks) blocks_.emplace(foldedName(block.name), &block);
  for (const NamedType& type : project.types) {
    if (!declared_.emplace(foldedName(type.name), &type).second)
      error(type.span, fmt::format("two types are named {}", excerpt(type.name)));
  }
  for (const NamedType& type : project.types) named(type.name, type.span);
}

void TypeTable::error(Span span, std::string message) { sink_.report(Syntax::IecType, span, std::move(message)); }

const Type* TypeTable::add(Type type) {
  types_.push_back(std::move(type));
  return &types_.back();
}

const Type* TypeTable::named(const std::string& name, Span span) {
  const std::string folded = foldedName(name);
  if (const Type* type = elementaryType(folded)) return type;
  if (const auto found = resolved_.find(folded); found != resolved_.end()) return found->second;
  if (const auto found = declared_.find(folded); found != declared_.end()) {
    if (std::ranges::find(open_, folded) != open_.end()) {
      error(span, fmt::format("type {} contains itself", excerpt(name)));
      return nullptr;
    }
    constexpr std::size_t deepest = 200;
    if (open_.size() >= deepest) {
      error(span, fmt::format("type {} stands in {} types that contain each other, more than are read", excerpt(name),
                              deepest));
      return resolved_[folded] = nullptr;
    }
    open_.push_back(folded);
    const Type* made = make(*found->second->type, found->second->name);
    open_.pop_back();
    if (made != nullptr && found->second->initial != nullptr) {
      Type copy = *made;
      copy.initial = found->second->initial.get();
      made = add(std::move(copy));
    }
    return resolved_[folded] = made;
  }
  if (const auto found = blocks_.find(folded); found != blocks_.end() && found->second->kind != BlockKind::Function) {
    Type type;
    type.kind = Kind::Block;
    type.name = found->second->name;
    type.block = found->second;
    return resolved_[folded] = add(std::move(type));
  }
  error(span, fmt::format("there is no type {}", excerpt(name)));
  return resolved_[folded] = nullptr;
}

const Type* TypeTable::addWhole(Type type, std::uint64_t bytes, Span span) {
  if (bytes > mostBytes) {
    error(span, fmt::format("the type has more than {} bytes", mostBytes));
    return nullptr;
  }
  type.bytes = static_cast<std::uint32_t>(bytes);
  return add(std::move(type));
}

const Type* TypeTable::resolve(const TypeSyntax& syntax) { return make(syntax, {}); }

const Type* TypeTable::make(const TypeSyntax& syntax, const std::string& name) {
  if (syntax.form == TypeForm::Enum) {
    const Type* base = syntax.name.empty() ? nullptr : elementaryType(foldedName(syntax.name));
    if (base == nullptr || !base->isNumber()) base = elementaryType("INT");
    if (base->isLong()) {
      error(syntax.span, fmt::format("an enumeration of {} values is not modelled", base->name));
      return nullptr;
    }
    Type type =
        elementary(Kind::Enum, name.empty() ? "enumeration" : name, base->width, base->isSigned, base->low, base->high);
    std::int64_t next = 0;
    for (const auto& [item, value] : syntax.items) {
      if (value != nullptr) next = integer(*value).value_or(next);
      if (next < base->low || next > base->high)
        error(syntax.span, fmt::format("{} does not fit into {}, the type of the enumeration", next, base->name));
      type.items.emplace_back(item, next++);
    }
    const Type* made = add(std::move(type));
    for (const auto& [item, value] : made->items) {
      items_[foldedName(item)] = Value{made, value};
      items_[foldedName(name) + "#" + foldedName(item)] = Value{made, value};
    }
    return made;
  }
  if (syntax.form == TypeForm::Array) {
    Type type;
    type.kind = Kind::Array;
    type.element = resolve(*syntax.element);
    if (type.element == nullptr) return nullptr;
    std::uint64_t count = 1;
    for (const auto& [low, high] : syntax.bounds) {
      const auto first = integer(*low), last = integer(*high);
      if (!first || !last || *last < *first) {
        error(syntax.span, "the bounds of the array are no constants in ascending order");
        return nullptr;
      }
      type.bounds.emplace_back(*first, *last);
      count *= static_cast<std::uint64_t>(*last - *first + 1);
      if (count > (1U << 20)) {
        error(syntax.span, "the array has more than a million elements");
        return nullptr;
      }
    }
    type.name = "ARRAY OF " + type.element->name;
    const std::uint64_t bytes = count * type.element->bytes;
    return addWhole(std::move(type), bytes, syntax.span);
  }
  if (syntax.form == TypeForm::Struct) {
    Type type;
    type.kind = Kind::Struct;
    type.name = name.empty() ? "STRUCT" : name;
    std::uint64_t bytes = 0;
    for (const VariableSyntax& field : syntax.fields) {
      const Type* of = resolve(*field.type);
      if (of == nullptr) return nullptr;
      type.fields.push_back({field.name, of, static_cast<std::uint32_t>(bytes), &field});
      bytes += std::max(of->bytes, 1U);  // what has no place here counts too, so that doubled types end
      if (bytes > mostBytes) break;
    }
    return addWhole(std::move(type), bytes, syntax.span);
  }
  const Type* base = named(syntax.name, syntax.span);
  if (base == nullptr || syntax.low == nullptr || base->kind == Kind::Unsupported) return base;
  if (base->kind == Kind::Text && syntax.high == nullptr) {
    const auto length = integer(*syntax.low);
    if (!length || *length < 1 || *length > mostTextLength) {
      error(syntax.span, fmt::format("a STRING has 1 to {} characters", mostTextLength));
      return nullptr;
    }
    return add(textType(*length));
  }
  const auto low = integer(*syntax.low), high = syntax.high != nullptr ? integer(*syntax.high) : std::nullopt;
  if (!low || !high || base->kind != Kind::Integer) {
    error(syntax.span, "a range needs a type of whole numbers and two constants");
    return base;
  }
  Type range = *base;
  range.low = *low;
  range.high = *high;
  return add(std::move(range));
}

std::optional<Value> TypeTable::enumerator(const std::string& name, const std::string& ofType) const {
  const auto found = items_.find(ofType.empty() ? foldedName(name) : foldedName(ofType) + "#" + foldedName(name));
  return found == items_.end() ? std::nullopt : std::optional(found->second);
}

namespace {
/// Whether a sum or product of constants is one of their numbers: both count the same. Of dates the result has another
/// type; of a duration there are multiples.
bool isOneUnit(const std::string& op, const Type* left, const Type* right) {
  const auto isOf = [](const Type* type, Kind kind) { return type != nullptr && type->kind == kind; };
  if (isOf(left, Kind::Date) || isOf(right, Kind::Date)) return false;
  const bool isTime = isOf(left, Kind::Time), isRightTime = isOf(right, Kind::Time);
  if (!isTime && !isRightTime) return true;
  return op == "*" ? isTime != isRightTime : isTime && isRightTime && left->width == right->width;
}
}  // namespace

std::optional<std::int64_t> TypeTable::integer(const Expr& expr) {
  const auto value = constant(expr);
  return value && !value->isReal ? std::optional(value->number) : std::nullopt;
}

std::optional<Value> TypeTable::constant(const Expr& expr) {
  if (expr.kind == ExprKind::Literal) {
    if (const auto item = expr.prefix.empty() ? std::nullopt : enumerator(expr.text, expr.prefix)) return item;
    std::string reason;
    return literalValue(expr, reason);
  }
  if (expr.kind == ExprKind::Path && expr.parts.size() == 1) {
    const auto found = constants.find(foldedName(expr.parts[0].name));
    if (found != constants.end()) return found->second;
    return enumerator(expr.parts[0].name);
  }
  if (expr.kind == ExprKind::Path && expr.parts.size() == 2 && expr.parts[1].kind == PathPart::Kind::Name)
    return enumerator(expr.parts[1].name, expr.parts[0].name);
  if (expr.kind == ExprKind::Unary && expr.text == "-") {
    auto inner = constant(*expr.operands[0]);
    if (!inner) return std::nullopt;
    if (inner->isReal) return realConstant(-inner->real, inner->type);
    constexpr std::int64_t least = std::numeric_limits<std::int64_t>::min();
    if (inner->isHuge && inner->number != least) return std::nullopt;
    inner->isHuge = false;
    if (inner->number != least) inner->number = -inner->number;
    return inner;
  }
  if (expr.kind == ExprKind::Binary) {
    const auto left = constant(*expr.operands[0]), right = constant(*expr.operands[1]);
    if (!left || !right || left->isReal || right->isReal || !isOneUnit(expr.text, left->type, right->type))
      return std::nullopt;
    const auto inRange = [](std::int64_t n) { return n > -(std::int64_t{1} << 40) && n < (std::int64_t{1} << 40); };
    if (!inRange(left->number) || !inRange(right->number)) return std::nullopt;
    Value made{left->type != nullptr ? left->type : right->type, 0};
    if (expr.text == "+")
      made.number = left->number + right->number;
    else if (expr.text == "-")
      made.number = left->number - right->number;
    else if (expr.text == "*" && std::abs(left->number) < (1 << 20) && std::abs(right->number) < (1 << 20))
      made.number = left->number * right->number;
    else
      return std::nullopt;
    return made;
  }
  return std::nullopt;
}

}  // namespace rungproof::iec
