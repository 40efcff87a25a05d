// Expressions of SCL. What stands in an accumulator when the next operand is computed is put into temporary data
// before. Of AND and OR both sides are computed, which nobody can tell: a call on the second side is refused.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>

#include "frontend/step7/operand_parser.hpp"
#include "frontend/step7/scl_lowering.hpp"
#include "frontend/stl/syntax_sink.hpp"

namespace rungproof::step7 {

using s7300::ConstantKind;
using s7300::TypeKind;

namespace {

/// What a constant of STEP 7 is in SCL; Unknown: nothing that an expression takes.
TypeKind kindOfConstant(const Constant& constant) {
  switch (constant.kind) {
    case ConstantKind::Integer:
      return constant.value >= -32768 && constant.value <= 32767 ? TypeKind::Int : TypeKind::DInt;
    case ConstantKind::Hex:
    case ConstantKind::Binary: return constant.value <= 32767 ? TypeKind::Int : TypeKind::DInt;
    case ConstantKind::Long: return TypeKind::DInt;
    case ConstantKind::Byte: return TypeKind::Byte;
    case ConstantKind::Word: return TypeKind::Word;
    case ConstantKind::DWord: return TypeKind::DWord;
    case ConstantKind::Real: return TypeKind::Real;
    case ConstantKind::S5Time: return TypeKind::S5Time;
    case ConstantKind::Time: return TypeKind::Time;
    case ConstantKind::Date: return TypeKind::Date;
    case ConstantKind::TimeOfDay: return TypeKind::TimeOfDay;
    case ConstantKind::Count: return TypeKind::Word;
    case ConstantKind::Boolean: return TypeKind::Bool;
    case ConstantKind::Text: return constant.text.size() == 1 ? TypeKind::Char : TypeKind::Unknown;
    default: return TypeKind::Unknown;
  }
}

/// INT#5, WORD#16#FF, BOOL#TRUE: the type in front of a number.
std::optional<TypeKind> typeInFront(std::string_view prefix) {
  constexpr std::array<std::pair<std::string_view, TypeKind>, 7> rows = {{{"INT", TypeKind::Int},
                                                                          {"DINT", TypeKind::DInt},
                                                                          {"REAL", TypeKind::Real},
                                                                          {"BYTE", TypeKind::Byte},
                                                                          {"WORD", TypeKind::Word},
                                                                          {"DWORD", TypeKind::DWord},
                                                                          {"BOOL", TypeKind::Bool}}};
  const auto row = std::ranges::find(rows, prefix, &std::pair<std::string_view, TypeKind>::first);
  return row == rows.end() ? std::nullopt : std::optional(row->second);
}

bool isSclNumber(TypeKind kind) { return kind == TypeKind::Int || kind == TypeKind::DInt || kind == TypeKind::Real; }

/// 5, 1_000, 1.5, 2e3.
std::optional<Constant> sclNumeral(std::string_view written) {
  std::string text;
  for (const char c : written) {
    if (c != '_') text += c;
  }
  Constant made;
  const char *const begin = text.data(), *const end = begin + text.size();
  if (text.find_first_of(".eE") != std::string::npos) {
    float number = 0;
    const auto [stop, error] = std::from_chars(begin, end, number);
    if (error != std::errc() || stop != end) return std::nullopt;
    made.kind = ConstantKind::Real;
    made.value = std::bit_cast<std::uint32_t>(number);
    return made;
  }
  const auto [stop, error] = std::from_chars(begin, end, made.value);
  if (error != std::errc() || stop != end || made.value > 4294967295LL) return std::nullopt;
  return made;
}

}  // namespace

SclValue SclLowering::literal(const iec::Expr& expr) {
  const auto made = [&](Constant constant, bool isLiteral) {
    SclValue value;
    value.kind = kindOfConstant(constant);
    if (value.kind == Kind::Unknown)
      refuse(expr.span, fmt::format("{} has no place in an expression", written(expr.span)));
    value.isPlain = true;
    value.isLiteral = isLiteral;
    value.operand = sclConstant(std::move(constant), expr.span);
    value.span = expr.span;
    return value;
  };
  const bool isTruth =
      expr.text.size() >= 4 && (iec::foldedName(expr.text) == "TRUE" || iec::foldedName(expr.text) == "FALSE");
  if (isTruth && (expr.prefix.empty() || expr.prefix == "BOOL")) {
    Constant constant;
    constant.kind = ConstantKind::Boolean;
    constant.value = iec::foldedName(expr.text) == "TRUE" ? 1 : 0;
    return made(constant, false);
  }
  if (expr.kind == iec::ExprKind::Literal && expr.prefix.empty() && expr.text.find('#') == std::string::npos) {
    const std::optional<Constant> number = sclNumeral(expr.text);
    if (!number) refuse(expr.span, fmt::format("{} is no number", written(expr.span)), Syntax::SclText);
    return made(*number, number->kind == ConstantKind::Integer);
  }
  const std::optional<TypeKind> typed = typeInFront(expr.prefix);
  const std::string text =
      typed ? expr.text : std::string(reports_.program().sources->file(expr.span.file).text(expr.span));
  std::optional<Constant> constant;
  if (typed) constant = sclNumeral(text);
  if (!constant) {
    Cursor cursor(text, expr.span.file);
    ConstantOutcome outcome = readConstant(cursor, MnemonicSet::International, TextEncoding::Utf8);
    if (!outcome.constant || !cursor.atEnd())
      refuse(expr.span, outcome.fault.empty() ? fmt::format("{} is no constant", written(expr.span)) : outcome.fault,
             Syntax::SclText);
    constant = std::move(outcome.constant);
  }
  const bool isOfNoType = constant->kind == ConstantKind::Integer || constant->kind == ConstantKind::Hex ||
                          constant->kind == ConstantKind::Binary;
  const SclValue value = made(std::move(*constant), isOfNoType);
  return typed ? as(value, *typed, expr.span) : value;
}

bool SclLowering::calls(const iec::Expr& expr) {
  const auto inIndices = [](const iec::PathPart& part) {
    return std::ranges::any_of(part.indices, [](const iec::ExprPtr& index) { return calls(*index); });
  };
  return expr.kind == iec::ExprKind::Call || std::ranges::any_of(expr.parts, inIndices) ||
         std::ranges::any_of(expr.operands, [](const iec::ExprPtr& inner) { return calls(*inner); });
}

SclValue SclLowering::value(const iec::Expr& expr) {
  const Span before = std::exchange(span_, expr.span);
  SclValue made = [&] {
    switch (expr.kind) {
      case iec::ExprKind::Literal:
      case iec::ExprKind::Text: return literal(expr);
      case iec::ExprKind::Path: return path(expr);
      case iec::ExprKind::Unary: return unary(expr);
      case iec::ExprKind::Binary: return binary(expr);
      case iec::ExprKind::Call: break;
    }
    return call(expr, false);
  }();
  made.span = expr.span;
  span_ = before;
  return made;
}

SclValue SclLowering::valueAs(const iec::Expr& expr, Kind kind) {
  const SclValue given = value(expr);
  const Span before = std::exchange(span_, expr.span);
  SclValue made = as(given, kind, expr.span);
  span_ = before;
  return made;
}

namespace {

/// Whether its value needs no register.
bool isSclLeaf(const iec::Expr& expr) {
  if (expr.kind == iec::ExprKind::Literal || expr.kind == iec::ExprKind::Text) return true;
  return expr.kind == iec::ExprKind::Path && std::ranges::none_of(expr.parts, [](const iec::PathPart& part) {
           return part.kind == iec::PathPart::Kind::Index || part.isSlice;
         });
}

bool isSclConstant(const SclValue& value) { return value.isPlain && value.operand.form == OperandForm::Constant; }

}  // namespace

/// A value that the next expression must not change any more: it stands in a register, or a call may write it.
SclValue SclLowering::heldBefore(SclValue value, const iec::Expr& next) {
  const bool isLost = value.isPlain ? calls(next) && !isSclConstant(value) : !isSclLeaf(next);
  return isLost ? inTemporary(value) : value;
}

void SclLowering::loadBoth(SclValue left, SclValue right, Kind kind) {
  left.isLiteral = left.isLiteral && left.isPlain;
  if (!right.isPlain) {  // in ACCU1: aside, then both in their order
    right = inTemporary(as(right, kind, right.span));
    left = as(left, kind, left.span);
    load(left);
    load(right);
    return;
  }
  left = as(left, kind, left.span);
  load(left);
  right = as(right, kind, right.span);
  load(right);
}

SclValue SclLowering::binary(const iec::Expr& expr) {
  const std::string& op = expr.text;
  if (op == "AND" || op == "OR" || op == "XOR") return logic(expr);
  if (op == "=" || op == "<>" || op == "<" || op == ">" || op == "<=" || op == ">=") return compare(expr);
  if (op == "+" || op == "-" || op == "*" || op == "/" || op == "MOD") return arithmetic(expr);
  refuse(expr.span, fmt::format("the operator {} is not modelled", op));
}

/// AND, OR, XOR with a truth value that is known.
SclValue SclLowering::withConstant(const std::string& op, bool isTrue, SclValue other) {
  if (op == "XOR") return isTrue ? negated(other) : other;
  if ((op == "AND") == isTrue) return other;
  if (!other.isPlain) inTemporary(other);  // ends its logic string
  Constant constant;
  constant.kind = ConstantKind::Boolean;
  constant.value = op == "OR" ? 1 : 0;
  SclValue made = inRegister(Kind::Bool, other.span);
  made.isPlain = true;
  made.operand = sclConstant(constant, other.span);
  return made;
}

SclValue SclLowering::negated(SclValue value) {
  if (value.isPlain)
    value.isNegated = !value.isNegated;
  else
    emit("NOT");
  return value;
}

SclValue SclLowering::joined(const std::string& op, SclValue left, SclValue right, Span span) {
  const auto truth = [](const SclValue& value) { return (value.operand.constant.value != 0) != value.isNegated; };
  if (isSclConstant(right)) return withConstant(op, truth(right), left);
  if (isSclConstant(left)) return withConstant(op, truth(left), right);
  if (!right.isPlain) std::swap(left, right);  // the RLO holds at most one of them: it goes first
  scan(left);
  const char letter = op == "AND" ? 'A' : op == "OR" ? 'O' : 'X';
  emit(std::string(1, letter) + (right.isNegated ? "N" : ""), right.operand);
  return inRegister(Kind::Bool, span);
}

SclValue SclLowering::logic(const iec::Expr& expr) {
  const iec::Expr &first = *expr.operands[0], &second = *expr.operands[1];
  const SclValue left = heldBefore(value(first), second);
  if (left.kind != Kind::Bool && !(left.isLiteral && literalAs(left, Kind::Bool)))
    return words(expr.text, expr, left, second);
  const int before = effects_;
  const SclValue right = value(second);
  if (effects_ != before && expr.text != "XOR")
    refuse(second.span,
           fmt::format("whether {} computes its second side where the first decides is not stated: compute "
                       "it before",
                       expr.text));
  if (left.isLiteral && right.kind != Kind::Bool) return wordsOf(expr.text, expr, left, right);
  return joined(expr.text, as(left, Kind::Bool, first.span), as(right, Kind::Bool, second.span), expr.span);
}

/// AND, OR, XOR of bytes, words and double words.
SclValue SclLowering::words(const std::string& op, const iec::Expr& expr, SclValue left, const iec::Expr& second) {
  return wordsOf(op, expr, left, value(second));
}

SclValue SclLowering::wordsOf(const std::string& op, const iec::Expr& expr, SclValue left, SclValue right) {
  const Kind kind = commonKind(left, right, expr.span);
  if (!isSclBits(kind)) refuse(expr.span, fmt::format("{} takes BOOL, BYTE, WORD and DWORD", op), Syntax::SclType);
  loadBoth(left, right, kind);
  emit((op == "AND" ? "A" : op == "OR" ? "O" : "XO") + std::string(kind == Kind::DWord ? "D" : "W"));
  return inRegister(kind, expr.span);
}

SclValue SclLowering::compare(const iec::Expr& expr) {
  const iec::Expr &first = *expr.operands[0], &second = *expr.operands[1];
  SclValue left = value(first);
  const std::string& op = expr.text;
  const bool asksEqual = op == "=" || op == "<>";
  left = heldBefore(left, second);
  const SclValue right = value(second);
  if (left.kind == Kind::Bool || right.kind == Kind::Bool) {
    if (!asksEqual) refuse(expr.span, fmt::format("BOOL has no order: {} does not compare it", op), Syntax::SclType);
    const SclValue differs =
        joined("XOR", as(left, Kind::Bool, first.span), as(right, Kind::Bool, second.span), expr.span);
    return op == "=" ? negated(differs) : differs;
  }
  if (left.isUntyped && right.isLiteral && !asksEqual)
    refuse(first.span,
           fmt::format("{} is an address: write WORD_TO_INT or DWORD_TO_DINT around it", written(first.span)),
           Syntax::SclType);
  if (right.isUntyped && left.isLiteral && !asksEqual)
    refuse(second.span,
           fmt::format("{} is an address: write WORD_TO_INT or DWORD_TO_DINT around it", written(second.span)),
           Syntax::SclType);
  const Kind kind = commonKind(left, right, expr.span);
  const bool isUnsigned =
      kind == Kind::Byte || kind == Kind::Word || kind == Kind::Char || kind == Kind::Date || kind == Kind::TimeOfDay;
  if (!asksEqual && (kind == Kind::DWord || kind == Kind::S5Time))
    refuse(expr.span,
           fmt::format("the order of values of type {} is not modelled", kind == Kind::DWord ? "DWORD" : "S5TIME"));
  loadBoth(left, right, kind);
  const bool isWide = sclBits(kind) == 32 || isUnsigned;  // zeros stand in front of what is shorter
  emit((op == "=" ? "==" : op) + std::string(kind == Kind::Real ? "R" : isWide ? "D" : "I"));
  return inRegister(Kind::Bool, expr.span);
}

SclValue SclLowering::arithmetic(const iec::Expr& expr) {
  const iec::Expr &first = *expr.operands[0], &second = *expr.operands[1];
  const std::string& op = expr.text;
  SclValue left = value(first);
  left = heldBefore(left, second);
  SclValue right = value(second);
  const auto isTime = [](const SclValue& value) { return value.kind == Kind::Time; };
  const auto isWhole = [](const SclValue& value) { return value.kind == Kind::Int || value.kind == Kind::DInt; };
  Kind kind = Kind::Time;
  const bool isSum = (op == "+" || op == "-") && isTime(left) && isTime(right);
  const bool isScaled = (op == "*" || op == "/") && isTime(left) && isWhole(right);
  if (isScaled) {
    left.kind = Kind::DInt;  // its milliseconds
    loadBoth(left, right.isLiteral ? *literalAs(right, Kind::DInt) : right, Kind::DInt);
    emit(op + "D");
    return inRegister(Kind::Time, expr.span);
  }
  if (!isSum) {
    for (const auto& [value, operand] : {std::pair{&left, &first}, {&right, &second}}) {
      if (isSclNumber(value->kind)) continue;
      refuse(operand->span,
             value->isUntyped ? fmt::format("{} is an address, no number: write WORD_TO_INT or DWORD_TO_DINT around it",
                                            written(operand->span))
                              : fmt::format("{} cannot be computed with {}", written(operand->span), op),
             Syntax::SclType);
    }
    kind = commonKind(left, right, expr.span);
  }
  if (op == "MOD") {
    if (kind == Kind::Real) refuse(expr.span, "MOD takes INT and DINT", Syntax::SclType);
    loadBoth(left, right, Kind::DInt);
    emit("MOD");
    return inRegister(kind, expr.span);  // the remainder of two INT is an INT
  }
  loadBoth(left, right, kind);
  emit(op + (kind == Kind::Int ? "I" : kind == Kind::Real ? "R" : "D"));
  return inRegister(kind, expr.span);
}

SclValue SclLowering::unary(const iec::Expr& expr) {
  const iec::Expr& inner = *expr.operands[0];
  SclValue made = value(inner);
  if (expr.text == "NOT") {
    if (made.kind == Kind::Bool) return negated(made);
    if (made.isLiteral || !isSclBits(made.kind))
      refuse(expr.span, "NOT takes BOOL, BYTE, WORD and DWORD", Syntax::SclType);
    load(made);
    emit(made.kind == Kind::DWord ? "INVD" : "INVI");
    if (made.kind == Kind::Byte) {
      Constant mask;
      mask.kind = ConstantKind::Word;
      mask.value = 0xFF;
      emit("AW", sclConstant(mask, expr.span));
    }
    return inRegister(made.kind, expr.span);
  }
  if (isSclConstant(made)) {
    Constant& constant = made.operand.constant;
    const bool isNumberOfText = constant.kind == ConstantKind::Integer || constant.kind == ConstantKind::Long;
    if (constant.kind == ConstantKind::Real) constant.value ^= 0x80000000;
    if (isNumberOfText || constant.kind == ConstantKind::Time) constant.value = -constant.value;
    if (isNumberOfText || constant.kind == ConstantKind::Real || constant.kind == ConstantKind::Time) {
      const bool isLiteral = made.isLiteral;
      made.kind = kindOfConstant(constant);
      made.isLiteral = isLiteral;
      return made;
    }
  }
  if (!isSclNumber(made.kind) && made.kind != Kind::Time)
    refuse(expr.span, fmt::format("{} has no sign", written(inner.span)), Syntax::SclType);
  load(made);
  emit(made.kind == Kind::Int ? "NEGI" : made.kind == Kind::Real ? "NEGR" : "NEGD");
  return inRegister(made.kind, expr.span);
}

}  // namespace rungproof::step7
