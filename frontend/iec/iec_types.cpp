// Types and literals.
#include "frontend/iec/iec_types.hpp"

#include <bit>
#include <charconv>
#include <cstdlib>

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

const std::map<std::string_view, Type>& elementaryTypes() {
  static const std::map<std::string_view, Type> all = [] {
    std::map<std::string_view, Type> made;
    const auto number = [&](std::string_view name, int width, bool isSigned) {
      const std::int64_t top = std::int64_t{1} << (isSigned ? width - 1 : width);
      made.emplace(name, elementary(Kind::Integer, name, width, isSigned, isSigned ? -top : 0, top - 1));
    };
    made.emplace("BOOL", elementary(Kind::Bool, "BOOL", 1, false, 0, 1));
    number("SINT", 8, true);
    number("INT", 16, true);
    number("DINT", 32, true);
    number("USINT", 8, false);
    number("UINT", 16, false);
    number("UDINT", 32, false);
    for (const auto& [name, width] : {std::pair{"BYTE", 8}, {"WORD", 16}, {"DWORD", 32}})
      made.emplace(name, elementary(Kind::BitString, name, width, false, 0, (std::int64_t{1} << width) - 1));
    made.emplace("REAL", elementary(Kind::Real, "REAL", 32, true, 0, 0));
    made.emplace("TIME", elementary(Kind::Time, "TIME", 32, true, -2147483648LL, 2147483647LL));
    for (const std::string_view name : {"LINT",          "ULINT",
                                        "LWORD",         "LREAL",
                                        "LTIME",         "DATE",
                                        "LDATE",         "TIME_OF_DAY",
                                        "TOD",           "LTOD",
                                        "DATE_AND_TIME", "DT",
                                        "LDT",           "STRING",
                                        "WSTRING",       "CHAR",
                                        "WCHAR",         "POINTER",
                                        "REF_TO",        "REFERENCE",
                                        "ANY",           "__SYSTEM.EXCEPTIONCODE"})
      made.emplace(name, elementary(Kind::Unsupported, name, 0, false, 0, 0));
    return made;
  }();
  return all;
}

/// Digits of a number in some base, without underscores.
std::optional<std::int64_t> digitsOf(std::string_view text, int base) {
  std::string digits;
  for (const char c : text) {
    if (c != '_') digits += c;
  }
  std::uint64_t value = 0;
  const auto result = std::from_chars(digits.data(), digits.data() + digits.size(), value, base);
  if (digits.empty() || result.ec != std::errc() || result.ptr != digits.data() + digits.size() || value > 0xFFFFFFFFU)
    return std::nullopt;
  return static_cast<std::int64_t>(value);
}

std::optional<std::int64_t> integerOf(std::string_view text) {
  const bool isNegative = text.starts_with("-");
  if (isNegative || text.starts_with("+")) text.remove_prefix(1);
  const std::size_t mark = text.find('#');
  int base = 10;
  if (mark != std::string_view::npos) {
    std::from_chars(text.data(), text.data() + mark, base);
    if (base != 2 && base != 8 && base != 16) return std::nullopt;
    text.remove_prefix(mark + 1);
  }
  const auto value = digitsOf(text, base);
  return value && isNegative ? std::optional(-*value) : value;
}

bool isRealText(std::string_view text) {
  return text.find('#') == std::string_view::npos &&
         (text.find('.') != std::string_view::npos || text.find_first_of("eE") != std::string_view::npos);
}

Value realValue(std::string_view text, const Type* type) {
  std::string digits;
  for (const char c : text) {
    if (c != '_') digits += c;
  }
  Value made;
  made.type = type;
  made.isReal = true;
  made.real = std::strtod(digits.c_str(), nullptr);
  made.number = static_cast<std::int64_t>(std::bit_cast<std::uint32_t>(std::strtof(digits.c_str(), nullptr)));
  return made;
}

}  // namespace

const Type* elementaryType(std::string_view folded) {
  const auto found = elementaryTypes().find(folded);
  return found == elementaryTypes().end() ? nullptr : &found->second;
}

std::optional<Value> literalValue(const Expr& literal, std::string& reason) {
  const std::string& text = literal.text;
  if (literal.prefix.empty()) {
    const std::string word = foldedName(text);
    if (word == "TRUE" || word == "FALSE") return Value{elementaryType("BOOL"), word == "TRUE" ? 1 : 0};
    if (isRealText(text)) return realValue(text, nullptr);
    if (const auto value = integerOf(text)) return Value{nullptr, *value};
    reason = fmt::format("{} does not fit into 32 bits", excerpt(text));
    return std::nullopt;
  }
  if (literal.prefix == "T" || literal.prefix == "TIME") {
    if (const auto ms = millisecondsOf(text)) return Value{elementaryType("TIME"), *ms};
    reason = fmt::format("{}#{} is no duration of whole milliseconds up to 24 days", literal.prefix, excerpt(text));
    return std::nullopt;
  }
  const Type* type = elementaryType(literal.prefix);
  if (type == nullptr || type->kind == Kind::Unsupported) {
    reason = fmt::format("{}# is not modelled", excerpt(literal.prefix));
    return std::nullopt;
  }
  if (type->kind == Kind::Real) return realValue(text, type);
  const std::string word = foldedName(text);
  if (type->kind == Kind::Bool && (word == "TRUE" || word == "FALSE")) return Value{type, word == "TRUE" ? 1 : 0};
  const auto value = integerOf(text);
  const bool isPattern = text.find('#') != std::string::npos;
  const std::int64_t top = std::int64_t{1} << type->width;
  if (value && *value >= type->low && *value <= type->high) return Value{type, *value};
  if (value && isPattern && *value < top) return Value{type, *value - top};
  reason = fmt::format("{} does not fit into {}", excerpt(text), type->name);
  return std::nullopt;
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

const Type* TypeTable::resolve(const TypeSyntax& syntax) { return make(syntax, {}); }

const Type* TypeTable::make(const TypeSyntax& syntax, const std::string& name) {
  if (syntax.form == TypeForm::Enum) {
    Type type = elementary(Kind::Enum, name.empty() ? "enumeration" : name, 16, true, -32768, 32767);
    std::int64_t next = 0;
    for (const auto& [item, value] : syntax.items) {
      if (value != nullptr) next = integer(*value).value_or(next);
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
    type.bytes = static_cast<std::uint32_t>(count * type.element->bytes);
    type.name = "ARRAY OF " + type.element->name;
    return add(std::move(type));
  }
  if (syntax.form == TypeForm::Struct) {
    Type type;
    type.kind = Kind::Struct;
    type.name = name.empty() ? "STRUCT" : name;
    for (const VariableSyntax& field : syntax.fields) {
      const Type* of = resolve(*field.type);
      if (of == nullptr) return nullptr;
      type.fields.push_back({field.name, of, type.bytes, &field});
      type.bytes += of->bytes;
    }
    return add(std::move(type));
  }
  const Type* base = named(syntax.name, syntax.span);
  if (base == nullptr || syntax.low == nullptr || base->kind == Kind::Unsupported) return base;
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
    if (inner->isReal) {
      inner->real = -inner->real;
      inner->number = static_cast<std::int64_t>(static_cast<std::uint32_t>(inner->number) ^ 0x80000000U);
    } else {
      inner->number = -inner->number;
    }
    return inner;
  }
  if (expr.kind == ExprKind::Binary) {
    const auto left = constant(*expr.operands[0]), right = constant(*expr.operands[1]);
    if (!left || !right || left->isReal || right->isReal) return std::nullopt;
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
