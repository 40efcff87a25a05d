// The standard functions of SCL: conversions, numbers, shifts, selections. A function that is not here is no function
// of SCL for the reader; those whose result no text at hand tells are not covered by name.
#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "frontend/step7/scl_lowering.hpp"
#include "frontend/stl/syntax_sink.hpp"
#include "ir/s7300/library.hpp"

namespace rungproof::step7 {

using s7300::ConstantKind;
using s7300::TypeKind;

namespace {

constexpr auto sclTypeNames = std::to_array<std::pair<std::string_view, TypeKind>>({{"BOOL", TypeKind::Bool},
                                                                                    {"BYTE", TypeKind::Byte},
                                                                                    {"CHAR", TypeKind::Char},
                                                                                    {"WORD", TypeKind::Word},
                                                                                    {"INT", TypeKind::Int},
                                                                                    {"DWORD", TypeKind::DWord},
                                                                                    {"DINT", TypeKind::DInt},
                                                                                    {"REAL", TypeKind::Real},
                                                                                    {"TIME", TypeKind::Time},
                                                                                    {"TOD", TypeKind::TimeOfDay},
                                                                                    {"DATE", TypeKind::Date},
                                                                                    {"S5TIME", TypeKind::S5Time}});

TypeKind typeOfName(std::string_view name) {
  const auto row = std::ranges::find(sclTypeNames, name, &std::pair<std::string_view, TypeKind>::first);
  return row == sclTypeNames.end() ? TypeKind::Unknown : row->second;
}

constexpr auto realFunctions =
    std::to_array<std::string_view>({"SQR", "SQRT", "EXP", "LN", "SIN", "COS", "TAN", "ASIN", "ACOS", "ATAN"});
constexpr auto knownElsewhere =
    std::to_array<std::string_view>({"EXPD",   "LOG",    "CONCAT",   "LEN",      "LEFT",           "RIGHT",  "MID",
                                     "INSERT", "DELETE", "REPLACE",  "FIND",     "STRING_TO_CHAR", "BLKMOV", "FILL",
                                     "PEEK",   "POKE",   "MOVE_BLK", "FILL_BLK", "SCALE_X",        "NORM_X"});

bool isOfOneSize(TypeKind kind, int bits) { return sclBits(kind) == bits; }

/// Whether the conversion takes the bits as they are, with zeros in front or without the first ones; an INT into 32
/// bits keeps its sign.
bool keepsBits(TypeKind from, TypeKind to) {
  using enum TypeKind;
  if (isSclBits(from) && (isSclBits(to) || to == Bool)) return true;
  constexpr std::pair<TypeKind, TypeKind> pairs[] = {
      {Int, Word},  {DInt, DWord},     {Byte, Int},  {Word, Int},  {Word, DInt}, {DWord, DInt},     {Byte, DInt},
      {DInt, Time}, {DInt, TimeOfDay}, {Time, DInt}, {DInt, Date}, {Date, DInt}, {TimeOfDay, DInt}, {Char, Byte},
      {Byte, Char}, {Char, Int},       {Int, Char},  {Int, Byte},  {DInt, Word}, {DInt, Byte}};
  return std::ranges::find(pairs, std::pair(from, to)) != std::end(pairs);
}

}  // namespace

const iec::Expr& SclLowering::input(const iec::Expr& expr, std::string_view name, std::size_t position) {
  std::size_t unnamed = 0;
  for (const iec::Argument& given : expr.arguments) {
    const bool isThis = given.name.empty() ? unnamed++ == position : iec::foldedName(given.name) == name;
    if (isThis && given.value != nullptr && !given.isOutput) return *given.value;
  }
  refuse(expr.span, fmt::format("{} needs a value for {}", written(expr.parts[0].span), name), Syntax::CallList);
}

/// Unknown: the name is that of no function.
SclValue SclLowering::standardFunction(const iec::Expr& expr, const std::string& name) {
  const auto takes = [&](std::size_t count) {
    if (expr.arguments.size() != count)
      refuse(expr.span, fmt::format("{} takes {} value{}", name, count, count == 1 ? "" : "s"), Syntax::CallList);
  };
  if (const std::size_t at = name.find("_TO_"); at != std::string::npos) {
    std::string from = name.substr(0, at), to = name.substr(at + 4);
    // WORD_BCD_TO_INT, BCD_TO_INT, INT_TO_BCD, INT_TO_BCD_WORD.
    const bool fromBcd = from == "BCD" || from.ends_with("_BCD"), toBcd = to == "BCD" || to.starts_with("BCD_");
    if (fromBcd) from = to == "DINT" ? "DWORD" : "WORD";
    if (toBcd) to = from == "DINT" ? "DWORD" : "WORD";
    const Kind source = typeOfName(from), target = typeOfName(to);
    if (source != Kind::Unknown && target != Kind::Unknown) {
      takes(1);
      return conversion(expr, source, target, fromBcd || toBcd);
    }
  }
  if (std::ranges::find(realFunctions, name) != realFunctions.end()) {
    takes(1);
    return realFunction(expr, name);
  }
  if (name == "ABS") {
    takes(1);
    return absoluteValue(expr);
  }
  if (name == "ROUND" || name == "TRUNC" || name == "CEIL" || name == "FLOOR") {
    takes(1);
    load(valueAs(input(expr, "IN", 0), Kind::Real));
    emit(name == "ROUND" ? "RND" : name == "TRUNC" ? "TRUNC" : name == "CEIL" ? "RND+" : "RND-");
    return inRegister(Kind::DInt, expr.span);
  }
  if (name == "SHL" || name == "SHR" || name == "ROL" || name == "ROR") {
    takes(2);
    return shift(expr, name);
  }
  if (name == "MIN" || name == "MAX") return extreme(expr, name == "MAX");
  if (name == "LIMIT") {
    takes(3);
    return limit(expr);
  }
  if (name == "SEL") {
    takes(3);
    return select(expr);
  }
  if (name == "MUX") return multiplex(expr);
  if (std::ranges::find(knownElsewhere, name) != knownElsewhere.end() && s7300::libraryBlockNamed(name) == nullptr)
    refuse(expr.span, fmt::format("the function {} is not covered", name));
  return inRegister(Kind::Unknown, expr.span);
}

SclValue SclLowering::conversion(const iec::Expr& expr, Kind from, Kind to, bool isBcd) {
  const iec::Expr& given = input(expr, "IN", 0);
  const SclValue in = valueAs(given, from);
  const auto done = [&] { return inRegister(to, expr.span); };
  if (isBcd) {
    load(in);
    const bool isWide = from == Kind::DInt || to == Kind::DInt;
    const bool intoNumber = to == Kind::Int || to == Kind::DInt;
    emit(intoNumber ? (isWide ? "BTD" : "BTI") : (isWide ? "DTB" : "ITB"));
    return done();
  }
  const int fromBits = sclBits(from), toBits = sclBits(to);
  if (from == Kind::Bool) {
    if (to != Kind::Byte && to != Kind::Word && to != Kind::DWord && to != Kind::Int && to != Kind::DInt)
      refuse(expr.span, fmt::format("the conversion {} is not covered", written(expr.parts[0].span)));
    const std::string isZero = freshLabel();
    scan(in);
    const Operand result = temporary(Kind::DInt);
    const auto put = [&](std::int64_t value) {
      Constant constant;
      constant.value = value;
      emit("L", sclConstant(constant, expr.span));
      emit("T", result);
    };
    // The loads leave the RLO as it is.
    put(0);
    emitJump("JCN", isZero);
    put(1);
    mark(isZero);
    emit("L", result);
    return done();
  }
  const bool isWholeFrom = from == Kind::Int || from == Kind::DInt, isWholeTo = to == Kind::Int || to == Kind::DInt;
  if (isWholeFrom && (isWholeTo || to == Kind::Real)) {
    load(in);
    if (from == Kind::Int && to != Kind::Int) emit("ITD");
    if (to == Kind::Real) emit("DTR");
    return done();  // of a DINT that is no INT the lower half
  }
  if (from == Kind::Real && isWholeTo) {
    load(in);
    emit("RND");
    return done();
  }
  if (!keepsBits(from, to))
    refuse(expr.span, fmt::format("the conversion {} is not covered", written(expr.parts[0].span)));
  load(in);
  if (to == Kind::Bool) {  // its last bit
    Constant one;
    one.kind = ConstantKind::DWord;
    one.value = 1;
    emit("AD", sclConstant(one, expr.span));
    Constant none;
    none.kind = ConstantKind::Long;
    emit("L", sclConstant(none, expr.span));
    emit("<>D");
    return done();
  }
  if (toBits >= fromBits && from != Kind::Int) return done();
  // A register may hold more than the value has bits: through a place of the size.
  SclValue cut = inTemporary(inRegister(isOfOneSize(to, 8)    ? Kind::Byte
                                        : isOfOneSize(to, 16) ? Kind::Word
                                                              : to,
                                        expr.span));
  cut.kind = to;
  return cut;
}

SclValue SclLowering::realFunction(const iec::Expr& expr, std::string_view mnemonic) {
  load(valueAs(input(expr, "IN", 0), Kind::Real));
  emit(mnemonic);
  return inRegister(Kind::Real, expr.span);
}

SclValue SclLowering::absoluteValue(const iec::Expr& expr) {
  SclValue in = value(input(expr, "IN", 0));
  if (in.isLiteral) in = as(in, in.kind, expr.span);
  if (in.kind == Kind::Real) {
    load(in);
    emit("ABS");
    return inRegister(Kind::Real, expr.span);
  }
  if (in.kind != Kind::Int && in.kind != Kind::DInt)
    refuse(expr.span, fmt::format("ABS takes a number, not {}", written(in.span)), Syntax::SclType);
  const bool isWide = in.kind == Kind::DInt;
  in = inTemporary(in);
  const std::string done = freshLabel();
  Constant zero;
  zero.kind = isWide ? ConstantKind::Long : ConstantKind::Integer;
  const Operand result = temporary(in.kind);
  load(in);
  emit("T", result);
  emit("L", sclConstant(zero, expr.span));
  emit(isWide ? "<D" : "<I");
  emitJump("JCN", done);
  load(in);
  emit(isWide ? "NEGD" : "NEGI");
  emit("T", result);
  mark(done);
  SclValue made = inRegister(in.kind, expr.span);
  made.isPlain = true;
  made.operand = result;
  return made;
}

SclValue SclLowering::shift(const iec::Expr& expr, const std::string& name) {
  const iec::Expr &first = input(expr, "IN", 0), &second = input(expr, "N", 1);
  SclValue in = heldBefore(value(first), second);
  const bool isWord = in.kind == Kind::Byte || in.kind == Kind::Word || in.kind == Kind::DWord;
  if (in.isLiteral || !isWord) refuse(first.span, fmt::format("{} takes BYTE, WORD and DWORD", name), Syntax::SclType);
  SclValue count = value(second);
  if (count.kind != Kind::Int) refuse(second.span, fmt::format("N of {} is an INT", name), Syntax::SclType);
  if (count.isLiteral) count = as(count, Kind::Int, second.span);
  if (!count.isPlain) count = inTemporary(count);
  if (!in.isPlain) in = inTemporary(in);
  const bool isLeft = name == "SHL" || name == "ROL";
  if (name == "ROL" || name == "ROR") return rotate(in, count, isLeft, expr.span);
  load(count);
  load(in);
  const bool isWide = in.kind == Kind::DWord;
  emit(isLeft ? (isWide ? "SLD" : "SLW") : (isWide ? "SRD" : "SRW"));
  if (in.kind == Kind::Byte && isLeft) return inTemporary(inRegister(Kind::Byte, expr.span));
  return inRegister(in.kind, expr.span);
}

/// A byte or word turns as the double word that repeats it.
SclValue SclLowering::rotate(SclValue in, SclValue count, bool isLeft, Span span) {
  const int bits = sclBits(in.kind);
  const Operand whole = temporary(Kind::DWord);
  load(in);
  if (bits == 32) emit("T", whole);
  for (int at = 0; bits < 32 && at < 32; at += bits) {
    Operand part = whole;
    part.size = sclSize(in.kind);
    part.number += static_cast<std::uint32_t>(at / 8);
    emit("T", part);
  }
  load(count);
  emit("L", whole);
  emit(isLeft ? "RLD" : "RRD");
  if (bits == 32) return inRegister(in.kind, span);
  SclValue made = inTemporary(inRegister(in.kind, span));
  return made;
}

SclLowering::Kind SclLowering::kindOfAll(const std::vector<SclValue>& values, Span span) {
  SclValue all = values.front();
  for (const SclValue& one : values) {
    all.kind = commonKind(all, one, span);
    all.isLiteral = all.isLiteral && one.isLiteral;
    all.isUntyped = all.isUntyped && one.isUntyped;
    if (!one.isLiteral && !one.isUntyped) all.operand = {};
  }
  return all.kind;
}

/// best := next where that is greater, or less.
void SclLowering::improve(const Operand& best, SclValue next, Kind kind, bool isMost, Span span) {
  next = as(next, kind, span);
  if (!next.isPlain) next = inTemporary(next);
  const std::string done = freshLabel();
  emit("L", best);
  load(next);
  emit((isMost ? "<" : ">") + std::string(kind == Kind::Int ? "I" : kind == Kind::Real ? "R" : "D"));
  emitJump("JCN", done);
  load(next);
  emit("T", best);
  mark(done);
}

/// MIN, MAX and MUX have IN1 to IN32 and IN0 to IN31.
constexpr std::size_t mostAlternatives = 32;

SclValue SclLowering::extreme(const iec::Expr& expr, bool isMost) {
  if (expr.arguments.size() > mostAlternatives)
    refuse(expr.span, fmt::format("{} takes at most {} values", isMost ? "MAX" : "MIN", mostAlternatives),
           Syntax::CallList);
  std::vector<SclValue> values;
  for (const iec::Argument& given : expr.arguments) {
    if (given.value == nullptr || given.isOutput) refuse(given.span, "a value is needed here", Syntax::SclText);
    const SclValue one = value(*given.value);
    const bool isConstant = one.isPlain && one.operand.form == OperandForm::Constant;
    values.push_back(isConstant ? one : inTemporary(one));
  }
  if (values.size() < 2)
    refuse(expr.span, fmt::format("{} takes two values or more", isMost ? "MAX" : "MIN"), Syntax::CallList);
  const Kind kind = kindOfAll(values, expr.span);
  const bool hasOrder = kind == Kind::Int || kind == Kind::DInt || kind == Kind::Real || kind == Kind::Time;
  if (!hasOrder) refuse(expr.span, "MIN, MAX and LIMIT take INT, DINT, REAL and TIME", Syntax::SclType);
  const Operand best = temporary(kind);
  load(as(values[0], kind, values[0].span));
  emit("T", best);
  for (std::size_t i = 1; i < values.size(); ++i) improve(best, values[i], kind, isMost, values[i].span);
  SclValue made = inRegister(kind, expr.span);
  made.isPlain = true;
  made.operand = best;
  return made;
}

/// MIN(MAX(IN, MN), MX).
SclValue SclLowering::limit(const iec::Expr& expr) {
  const SclValue least = alternative(expr, "MN", 0), in = alternative(expr, "IN", 1), most = alternative(expr, "MX", 2);
  const Kind kind = kindOfAll({least, in, most}, expr.span);
  if (kind != Kind::Int && kind != Kind::DInt && kind != Kind::Real && kind != Kind::Time)
    refuse(expr.span, "MIN, MAX and LIMIT take INT, DINT, REAL and TIME", Syntax::SclType);
  const Operand best = temporary(kind);
  load(as(in, kind, in.span));
  emit("T", best);
  improve(best, least, kind, true, least.span);
  improve(best, most, kind, false, most.span);
  const std::string isOrdered = freshLabel();  // else: not stated
  loadBoth(least, most, kind);
  emit(std::string(">") + (kind == Kind::Int ? "I" : kind == Kind::Real ? "R" : "D"));
  emitJump("JCN", isOrdered);
  leaveOpen(best, kind);
  mark(isOrdered);
  SclValue made = inRegister(kind, expr.span);
  made.isPlain = true;
  made.operand = best;
  return made;
}

/// A value of a call that takes one of several: it is computed before any of them is taken.
SclValue SclLowering::alternative(const iec::Expr& expr, std::string_view name, std::size_t position) {
  const SclValue one = value(input(expr, name, position));
  return one.isPlain && one.operand.form == OperandForm::Constant ? one : inTemporary(one);
}

/// What stands in temporary data and is written by take().
SclValue SclLowering::toBeTaken(Kind kind, Span span) {
  SclValue made = inRegister(kind, span);
  made.isPlain = true;
  made.operand = temporary(kind);
  return made;
}

void SclLowering::take(SclValue from, const SclValue& into) {
  from = as(from, into.kind, from.span);
  if (into.kind == Kind::Bool)
    scan(from);
  else
    load(from);
  store(into.operand, into.kind);
}

SclValue SclLowering::select(const iec::Expr& expr) {
  SclValue chooser = valueAs(input(expr, "G", 0), Kind::Bool);
  if (!chooser.isPlain) chooser = inTemporary(chooser);
  const std::vector<SclValue> values = {alternative(expr, "IN0", 1), alternative(expr, "IN1", 2)};
  const SclValue made = toBeTaken(kindOfAll(values, expr.span), expr.span);
  const std::string second = freshLabel(), done = freshLabel();
  scan(chooser);
  emitJump("JC", second);
  take(values[0], made);
  emitJump("JU", done);
  mark(second);
  take(values[1], made);
  mark(done);
  return made;
}

/// K beyond the values: what comes out is not stated. A hazard says it.
SclValue SclLowering::multiplex(const iec::Expr& expr) {
  if (expr.arguments.size() < 3) refuse(expr.span, "MUX takes a number and two values or more", Syntax::CallList);
  if (expr.arguments.size() > mostAlternatives + 1)
    refuse(expr.span, fmt::format("MUX takes at most {} values", mostAlternatives), Syntax::CallList);
  SclValue chooser = valueAs(input(expr, "K", 0), Kind::Int);
  if (!chooser.isPlain) chooser = inTemporary(chooser);
  std::vector<SclValue> values;
  for (std::size_t i = 0; i + 1 < expr.arguments.size(); ++i)
    values.push_back(alternative(expr, fmt::format("IN{}", i), i + 1));
  const SclValue made = toBeTaken(kindOfAll(values, expr.span), expr.span);
  const std::string done = freshLabel();
  checkRange(as(chooser, Kind::DInt, chooser.span), 0, static_cast<std::int64_t>(values.size()) - 1, expr.span);
  for (std::size_t i = 0; i < values.size(); ++i) {
    const std::string next = freshLabel();
    Constant constant;
    constant.value = static_cast<std::int64_t>(i);
    load(chooser);
    emit("L", sclConstant(constant, expr.span));
    emit("==I");
    emitJump("JCN", next);
    take(values[i], made);
    emitJump("JU", done);
    mark(next);
  }
  take(values.back(), made);
  leaveOpen(made.operand, made.kind);
  mark(done);
  return made;
}

}  // namespace rungproof::step7
