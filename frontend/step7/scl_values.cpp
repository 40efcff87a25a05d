// Values on their way: what SCL converts by itself, loads, temporary data, statements that are written.
#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>

#include "frontend/step7/scl_lowering.hpp"
#include "frontend/stl/syntax_sink.hpp"
#include "ir/s7300/index_check.hpp"
#include "ir/s7300/isa.hpp"
#include "ir/s7300/status_effect.hpp"

namespace rungproof::step7 {

using s7300::ConstantKind;
using s7300::TypeKind;

namespace {

bool isSclInteger(TypeKind kind) { return kind == TypeKind::Int || kind == TypeKind::DInt; }

/// Whether SCL widens the one into the other by itself.
bool widens(TypeKind from, TypeKind to) {
  if (from == to) return true;
  if (from == TypeKind::Int) return to == TypeKind::DInt || to == TypeKind::Real;
  if (from == TypeKind::DInt) return to == TypeKind::Real;
  if (from == TypeKind::Byte) return to == TypeKind::Word || to == TypeKind::DWord;
  return from == TypeKind::Word && to == TypeKind::DWord;
}

std::string sclTypeName(TypeKind kind) {
  s7300::Type type;
  type.kind = kind;
  return s7300::toString(type);
}

}  // namespace

int sclBits(TypeKind kind) {
  switch (kind) {
    case TypeKind::Bool: return 1;
    case TypeKind::Byte:
    case TypeKind::Char: return 8;
    case TypeKind::Word:
    case TypeKind::Int:
    case TypeKind::S5Time:
    case TypeKind::Date: return 16;
    case TypeKind::DWord:
    case TypeKind::DInt:
    case TypeKind::Real:
    case TypeKind::Time:
    case TypeKind::TimeOfDay: return 32;
    default: return 0;
  }
}

Size sclSize(TypeKind kind) {
  switch (sclBits(kind)) {
    case 1: return Size::Bit;
    case 8: return Size::Byte;
    case 16: return Size::Word;
    default: return Size::DWord;
  }
}

Operand sclConstant(Constant constant, Span span) {
  Operand operand;
  operand.form = OperandForm::Constant;
  constant.span = span;
  operand.constant = std::move(constant);
  operand.span = span;
  return operand;
}

void SclLowering::refuse(Span span, std::string message, Syntax code) {
  const char* const help = code == Syntax::BodyNotCovered
                               ? "write it in another way; until then nothing that this block does is proved"
                               : "";
  reports_.report(code, span, std::move(message), scope_.name, network_ != nullptr ? network_->number : 0, help);
  throw Refused{};
}

std::string SclLowering::written(Span span) const {
  return excerpt(reports_.program().sources->file(span.file).text(span));
}

void SclLowering::emit(std::string_view mnemonic, const Operand& operand) {
  Statement made;
  made.mnemonic = {std::string(mnemonic), span_};
  made.operand = operand;
  if (made.operand.form != OperandForm::None) made.operand.span = operand.span.length > 0 ? operand.span : span_;
  made.span = span_;
  network_->statements.push_back(std::move(made));
  constexpr std::size_t os = 4;  // in the order of the status word
  const Desc* desc = s7300Instructions().named(mnemonic);
  mayOverflow_ = mayOverflow_ || (desc != nullptr && s7300::statusEffect(*desc)[os] == 'x');
}

/// What the place holds from here on no text tells: any value in proofs; a run keeps it.
void SclLowering::leaveOpen(const Operand& place, Kind kind) {
  emit(kind == Kind::Bool ? "A" : "L", place);
  emit(openValue);
  emit(kind == Kind::Bool ? "=" : "T", place);
}

void SclLowering::emitJump(std::string_view mnemonic, const std::string& label) {
  Operand operand;
  operand.form = OperandForm::Word;
  operand.name = label;
  operand.span = span_;
  emit(mnemonic, operand);
}

void SclLowering::mark(const std::string& label) {
  Statement made;
  made.label = {label, {span_.file, span_.offset, 0}};
  made.span = made.label.span;
  network_->statements.push_back(std::move(made));
}

/// Words of a program begin with a letter.
std::string SclLowering::freshLabel() { return std::to_string(++labels_); }

Operand SclLowering::temporary(Kind kind) {
  const auto bits = static_cast<std::uint32_t>(sclBits(kind));
  const std::uint32_t unit = bits == 1 ? 1 : bits == 8 ? 8 : 16;
  next_ = (next_ + unit - 1) / unit * unit;
  Operand operand;
  operand.form = OperandForm::Address;
  operand.place = Place::L;
  operand.size = sclSize(kind);
  operand.isBehindDeclared = true;
  operand.number = next_ / 8;
  operand.bit = static_cast<std::uint8_t>(next_ % 8);
  operand.span = span_;
  next_ += bits;
  top_ = std::max(top_, next_);
  return operand;
}

SclValue SclLowering::inRegister(Kind kind, Span span) const {
  SclValue made;
  made.kind = kind;
  made.span = span;
  return made;
}

void SclLowering::load(const SclValue& value) {
  if (value.isPlain) emit("L", value.operand);
}

/// Leaves the value in the RLO, at the beginning of a logic string.
void SclLowering::scan(const SclValue& value) {
  if (!value.isPlain) return;
  if (value.operand.form == OperandForm::Constant)
    emit((value.operand.constant.value != 0) != value.isNegated ? "SET" : "CLR");
  else
    emit(value.isNegated ? "AN" : "A", value.operand);
}

void SclLowering::store(const Operand& place, Kind kind) { emit(kind == Kind::Bool ? "=" : "T", place); }

SclValue SclLowering::inTemporary(const SclValue& value) {
  SclValue made = value;
  if (value.kind == Kind::Bool)
    scan(value);
  else
    load(value);
  made.operand = temporary(value.kind);
  made.isPlain = true;
  made.isNegated = made.isLiteral = made.isUntyped = false;
  store(made.operand, value.kind);
  return made;
}

std::optional<SclValue> SclLowering::literalAs(const SclValue& value, Kind kind) const {
  if (!value.isPlain || value.operand.form != OperandForm::Constant) return std::nullopt;
  const Constant& given = value.operand.constant;
  const bool isWhole = given.kind == ConstantKind::Integer || given.kind == ConstantKind::Long ||
                       given.kind == ConstantKind::Hex || given.kind == ConstantKind::Binary;
  SclValue made = value;
  Constant& constant = made.operand.constant;
  made.kind = kind;
  made.isLiteral = false;
  const auto fits = [&](std::int64_t low, std::int64_t high, ConstantKind as) -> std::optional<SclValue> {
    if (given.value < low || given.value > high) return std::nullopt;
    constant.kind = as;
    return made;
  };
  if (value.isLiteral && isWhole) {
    switch (kind) {
      case Kind::Int: return fits(-32768, 32767, ConstantKind::Integer);
      case Kind::DInt: return fits(-2147483648LL, 2147483647LL, ConstantKind::Long);
      case Kind::Byte: return fits(0, 0xFF, ConstantKind::Byte);
      case Kind::Word: return fits(0, 0xFFFF, ConstantKind::Word);
      case Kind::DWord: return fits(0, 0xFFFFFFFFLL, ConstantKind::DWord);
      case Kind::Bool: return fits(0, 1, ConstantKind::Boolean);
      case Kind::Real:
        constant.kind = ConstantKind::Real;
        constant.value = std::bit_cast<std::uint32_t>(static_cast<float>(given.value));
        return made;
      default: return std::nullopt;
    }
  }
  if (value.kind == kind) return value;
  if (value.kind == Kind::Int && kind == Kind::DInt) {
    constant.kind = ConstantKind::Long;
    return made;
  }
  if (isSclInteger(value.kind) && kind == Kind::Real) {
    constant.kind = ConstantKind::Real;
    constant.value = std::bit_cast<std::uint32_t>(static_cast<float>(given.value));
    return made;
  }
  if (isSclBits(value.kind) && isSclBits(kind) && widens(value.kind, kind)) {
    constant.kind = kind == Kind::Word ? ConstantKind::Word : ConstantKind::DWord;
    return made;
  }
  return std::nullopt;
}

SclValue SclLowering::as(SclValue value, Kind kind, Span span) {
  if (value.isLiteral) {
    if (const std::optional<SclValue> made = literalAs(value, kind)) return *made;
    refuse(span, fmt::format("{} is no {}", written(value.span), sclTypeName(kind)), Syntax::SclType);
  }
  if (value.kind == kind) return value;
  if (value.isUntyped && sclBits(value.kind) == sclBits(kind)) {
    value.kind = kind;
    return value;
  }
  if (!widens(value.kind, kind))
    refuse(
        span,
        fmt::format("{} is {}, and {} is needed here", written(value.span), sclTypeName(value.kind), sclTypeName(kind)),
        Syntax::SclType);
  if (const std::optional<SclValue> made = literalAs(value, kind)) return *made;
  load(value);
  if (value.kind == Kind::Int) emit("ITD");
  if (kind == Kind::Real) emit("DTR");
  SclValue made = inRegister(kind, value.span);
  return made;  // bytes and words are loaded with zeros in front of them
}

/// The type in which two values meet.
SclLowering::Kind SclLowering::commonKind(const SclValue& left, const SclValue& right, Span span) {
  if (left.isLiteral && right.isLiteral) {
    const auto isReal = [](const SclValue& value) { return value.kind == Kind::Real; };
    if (isReal(left) || isReal(right)) return Kind::Real;
    return left.kind == Kind::DInt || right.kind == Kind::DInt ? Kind::DInt : Kind::Int;
  }
  if (left.isLiteral || right.isLiteral) {
    const SclValue& number = left.isLiteral ? left : right;
    const Kind typed = (left.isLiteral ? right : left).kind;
    if (literalAs(number, typed)) return typed;
    if (typed == Kind::Int && literalAs(number, Kind::DInt)) return Kind::DInt;  // 40000 beside an INT
    refuse(span, fmt::format("{} is no {}", written(number.span), sclTypeName(typed)), Syntax::SclType);
  }
  if (widens(left.kind, right.kind)) return right.kind;
  if (widens(right.kind, left.kind)) return left.kind;
  const bool isSameWidth = sclBits(left.kind) == sclBits(right.kind);
  if (left.isUntyped && isSameWidth) return right.kind;
  if (right.isUntyped && isSameWidth) return left.kind;
  refuse(span, fmt::format("{} and {} do not go together", sclTypeName(left.kind), sclTypeName(right.kind)),
         Syntax::SclType);
}

}  // namespace rungproof::step7
