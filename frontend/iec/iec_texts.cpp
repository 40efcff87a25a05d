// Texts (STRING): literals, variables, functions that give one. A text that an expression gives lies at a place of its
// own, from where it is copied or compared.
#include <cctype>
#include <charconv>

#include "frontend/iec/iec_lowering.hpp"
#include "frontend/iec/iec_tree.hpp"

namespace rungproof::iec {

bool isText(const Type* type) { return type != nullptr && type->kind == Kind::Text; }

namespace {

/// 'a$'b$$ $L$N$P$R$T$41' without its marks; nothing if a sign behind $ means nothing.
std::optional<std::string> charactersOf(std::string_view literal) {
  if (literal.size() < 2 || literal.front() != '\'') return std::nullopt;
  literal = literal.substr(1, literal.size() - 2);
  std::string characters;
  for (std::size_t i = 0; i < literal.size(); ++i) {
    if (literal[i] != '$') {
      characters += literal[i];
      continue;
    }
    if (++i >= literal.size()) return std::nullopt;
    static constexpr std::pair<char, char> signs[] = {{'$', '$'},  {'\'', '\''}, {'L', '\n'}, {'N', '\n'},
                                                      {'P', '\f'}, {'R', '\r'},  {'T', '\t'}};
    const char sign = static_cast<char>(std::toupper(static_cast<unsigned char>(literal[i])));
    const auto row = std::ranges::find(signs, sign, &std::pair<char, char>::first);
    if (row != std::end(signs)) {
      characters += row->second;
      continue;
    }
    unsigned code = 0;
    const char* const first = literal.data() + i;
    if (i + 1 >= literal.size() || std::from_chars(first, first + 2, code, 16).ptr != first + 2) return std::nullopt;
    characters += static_cast<char>(code);
    ++i;
  }
  return characters;
}

}  // namespace

void Lowering::emitTexts(std::string_view mnemonic, std::initializer_list<TextAt> texts) {
  emit(mnemonic);
  for (const TextAt& text : texts) {
    Operand place = direct(Area::V, Width::Byte, text.offset);
    place.span = span_;
    last().operands.push_back(std::move(place));
    last().operands.push_back(rungproof::constant(text.bytes));
  }
}

Lowering::TextAt Lowering::freshText(std::uint32_t bytes) { return {allocate(bytes), bytes}; }

void Lowering::writeTextInitial(std::uint32_t offset, std::uint32_t bytes, const Expr& literal) {
  const auto characters = literal.kind == ExprKind::Text ? charactersOf(literal.text) : std::nullopt;
  if (!characters) refuse(literal.span, fmt::format("{} is no text of a STRING", excerpt(literal.text)));
  const std::size_t length = std::min<std::size_t>(characters->size(), bytes - 1);
  initial_[offset] = static_cast<std::uint8_t>(length);
  for (std::size_t i = 0; i < length; ++i) initial_[offset + 1 + i] = static_cast<std::uint8_t>((*characters)[i]);
}

namespace {

/// INT_TO_STRING(x) and its kin as a call of the library function that writes the digits, BOOL_TO_STRING as a choice of
/// two texts; nullptr for a type whose texts differ between implementations. `from`: in front of _TO_, may be empty.
ExprPtr textOfWhole(const Type& source, const std::string& from, const Expr& value) {
  if (source.kind == Kind::Bool) {
    ExprPtr made = callOf({"SEL"}, value.span);
    addArgument(*made, copyOf(value));
    for (const char* const word : {"'FALSE'", "'TRUE'"}) {
      ExprPtr text = literalOf(word, value.span);
      text->kind = ExprKind::Text;
      addArgument(*made, std::move(text));
    }
    return made;
  }
  if (source.kind != Kind::Integer || source.isLong()) return nullptr;
  const std::string widest = source.isSigned ? "DINT" : "UDINT";
  ExprPtr number = copyOf(value);
  if (!from.empty() && from != widest) {
    number = callOf({from + "_TO_" + widest}, value.span);
    addArgument(*number, copyOf(value));
  }
  ExprPtr made = callOf({source.isSigned ? "__SIGNED_TEXT" : "__UNSIGNED_TEXT"}, value.span);
  addArgument(*made, std::move(number));
  return made;
}

}  // namespace

/// The place of the value of an expression that is a text.
Lowering::TextAt Lowering::text(Scope& scope, const Expr& expr) {
  if (expr.kind == ExprKind::Text) {
    const auto [at, isNew] = literalTexts_.emplace(expr.text, TextAt{});
    if (isNew) {
      const auto characters = charactersOf(expr.text);
      if (!characters || characters->size() > mostTextLength) {
        literalTexts_.erase(at);
        refuse(expr.span, fmt::format("{} is no text of a STRING", excerpt(expr.text)));
      }
      at->second = freshText(static_cast<std::uint32_t>(characters->size()) + 1);
      writeTextInitial(at->second.offset, at->second.bytes, expr);
    }
    return at->second;
  }
  if (expr.kind == ExprKind::Path) {
    const Reference at = reference(scope, expr);
    if (!isText(at.type)) refuse(expr.span, fmt::format("{} is no text", at.type != nullptr ? at.type->name : "this"));
    if (!at.indices.empty())
      refuse(expr.span, "a text in an array with a computed index is not modelled", Syntax::IecNotModelled);
    return {at.offset, at.type->bytes};
  }
  if (expr.kind != ExprKind::Call || expr.parts.size() != 1) refuse(expr.span, "a text is needed here");
  const std::string name = foldedName(expr.parts[0].name);
  if (BlockInstance* function = functionNamed(name)) {
    const Variable& result = runFunction(scope, *function, expr);
    if (!isText(result.type)) refuse(expr.span, fmt::format("{} gives no text", excerpt(expr.parts[0].name)));
    const TextAt kept = freshText(result.type->bytes);  // the next call overwrites the result
    emitTexts("COPY.TEXT", {{result.offset, result.type->bytes}, kept});
    return kept;
  }
  return textFunction(scope, name, expr);
}

void Lowering::copyText(Scope& scope, const TextAt& from, const Reference& to, Span span) {
  static_cast<void>(scope);
  if (!to.indices.empty())
    refuse(span, "a text in an array with a computed index is not modelled", Syntax::IecNotModelled);
  emitTexts("COPY.TEXT", {from, {to.offset, to.type->bytes}});
  for (std::uint32_t i = 0; i < to.type->bytes; ++i) noteWritten(to.offset + i);
}

void Lowering::compareTexts(Scope& scope, const std::string& op, const Expr& left, const Expr& right) {
  const TextAt x = text(scope, left), y = text(scope, right);
  const bool isEquality = op == "=" || op == "<>", isSwapped = op == ">" || op == "<=";
  emitTexts(isEquality ? "EQ.TEXT" : "LT.TEXT", {isSwapped ? y : x, isSwapped ? x : y});
  if (op == "<>" || op == "<=" || op == ">=") emit("NOT", {1});
}

/// SEL, CONCAT, LEFT, RIGHT, MID, INSERT, DELETE, REPLACE: put together of joining and cutting.
Lowering::TextAt Lowering::textFunction(Scope& scope, const std::string& name, const Expr& expr) {
  const std::vector<const Expr*> values = plainArguments(expr, {"IN", "IN1", "IN2", "L", "P"});
  const auto need = [&](std::size_t least, std::size_t most) {
    if (values.size() < least || values.size() > most)
      refuse(expr.span, fmt::format("the arguments of {} do not fit", name));
  };
  const Type& whole = *elementaryType("DINT");
  const auto number = [&](const Expr& of) {  // kept, because it is needed twice
    const std::uint32_t at = allocate(4);
    const Type* type = value(scope, of, &whole);
    if (!type->isNumber()) refuse(of.span, fmt::format("{} does not fit into DINT", type->name));
    emit("RESIZE", {type->width, 32, type->isSigned ? 1 : 0});
    store(whole, at);
    return at;
  };
  /// As many characters as `count` pushes, from the place that `position` pushes.
  const auto cut = [&](const TextAt& from, auto&& count, auto&& position) {
    const TextAt made = freshText(from.bytes);
    count();
    position();
    emitTexts("MID.TEXT", {from, made});
    return made;
  };
  const auto join = [&](const TextAt& left, const TextAt& right) {
    const TextAt made = freshText(std::min<std::uint32_t>(left.bytes + right.bytes - 1, mostTextLength + 1));
    emitTexts("CONCAT.TEXT", {left, right, made});
    return made;
  };
  const auto all = [&] { constant(mostTextLength, 32); };
  const auto first = [&] { constant(1, 32); };
  const auto sum = [&](std::uint32_t place, std::int64_t more) {
    load(whole, place);
    constant(more, 32);
    emit("ADD", {32});
  };
  if (name == "SEL") {
    const std::vector<const Expr*> chosen = plainArguments(expr, {"G", "IN0", "IN1"});
    if (chosen.size() != 3) refuse(expr.span, "the arguments of SEL do not fit");
    const TextAt zero = text(scope, *chosen[1]), one = text(scope, *chosen[2]);
    const TextAt made = freshText(std::max(zero.bytes, one.bytes));
    const int end = newLabel();
    emitTexts("COPY.TEXT", {zero, made});
    valueAs(scope, *chosen[0], *elementaryType("BOOL"));
    jumpIfFalse(end);
    emitTexts("COPY.TEXT", {one, made});
    label(end);
    return made;
  }
  if (name == "CONCAT") {
    need(2, 64);
    TextAt made = text(scope, *values[0]);
    for (std::size_t i = 1; i < values.size(); ++i) made = join(made, text(scope, *values[i]));
    return made;
  }
  if (name == "LEFT" || name == "RIGHT") {
    need(2, 2);
    const TextAt from = text(scope, *values[0]);
    const std::uint32_t count = number(*values[1]);
    if (name == "LEFT")
      return cut(
          from, [&] { load(whole, count); }, first);
    return cut(
        from, [&] { load(whole, count); }, [&] {  // from 1 on where it has no more
          emitTexts("LEN.TEXT", {from});
          emit("RESIZE", {16, 32, 0});
          load(whole, count);
          emit("SUB", {32});
          constant(0, 32);
          emit("MAX", {32, 1});
          constant(1, 32);
          emit("ADD", {32});
        });
  }
  if (name == "MID") {
    need(3, 3);
    const TextAt from = text(scope, *values[0]);
    const std::uint32_t count = number(*values[1]), position = number(*values[2]);
    return cut(
        from, [&] { load(whole, count); }, [&] { load(whole, position); });
  }
  if (name == "INSERT") {
    need(3, 3);
    const TextAt from = text(scope, *values[0]), what = text(scope, *values[1]);
    const std::uint32_t position = number(*values[2]);
    const TextAt front = cut(
        from, [&] { load(whole, position); }, first);
    const TextAt rest = cut(from, all, [&] { sum(position, 1); });
    return join(join(front, what), rest);
  }
  if (name == "DELETE" || name == "REPLACE") {
    const bool replaces = name == "REPLACE";
    need(replaces ? 4 : 3, replaces ? 4 : 3);
    const TextAt from = text(scope, *values[0]);
    const TextAt what = replaces ? text(scope, *values[1]) : TextAt{};
    const std::uint32_t count = number(*values[replaces ? 2 : 1]), position = number(*values[replaces ? 3 : 2]);
    const TextAt front = cut(
        from, [&] { sum(position, -1); }, first);
    const TextAt rest = cut(from, all, [&] {
      load(whole, position);
      load(whole, count);
      emit("ADD", {32});
    });
    return join(replaces ? join(front, what) : front, rest);
  }
  if (isText(conversionTarget(name))) {
    need(1, 1);
    const std::string from = name.starts_with("TO_") ? std::string() : name.substr(0, name.find("_TO_"));
    const Type* source = from.empty() ? typeOf(scope, *values[0]) : elementaryType(from);
    const ExprPtr made = source != nullptr ? textOfWhole(*source, from, *values[0]) : nullptr;
    if (made != nullptr) return text(scope, *made);
  }
  if (conversionTarget(name) != nullptr || isStandardFunction(name))
    refuse(expr.span, fmt::format("{}: texts that it makes are not modelled", name), Syntax::IecNotModelled);
  refuse(expr.span, fmt::format("there is no function and no instance {}", excerpt(expr.parts[0].name)),
         Syntax::IecName);
}

}  // namespace rungproof::iec
