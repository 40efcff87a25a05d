// Conversions between the elementary types: INT_TO_REAL, TO_REAL, TRUNC, BCD_TO_UINT ...
#include "frontend/iec/iec_lowering.hpp"

namespace rungproof::iec {

namespace {

/// The type of a name behind _TO_, with _BCD or without.
const Type* typeNamed(std::string_view name) { return elementaryType(name); }

struct ConversionName {
  const Type* from = nullptr;  ///< nullptr: that of the argument
  const Type* to = nullptr;    ///< nullptr: the name is no conversion
  bool cuts = false;           ///< towards zero
  bool fromBcd = false, toBcd = false;
};

/// INT_TO_REAL, TO_REAL, TRUNC, REAL_TRUNC_INT, BCD_TO_INT, WORD_BCD_TO_UINT, INT_TO_BCD, UINT_TO_BCD_WORD.
ConversionName conversionOf(std::string_view name) {
  ConversionName found;
  if (name == "TRUNC") return {.to = typeNamed("DINT"), .cuts = true};
  if (const std::size_t at = name.find("_TRUNC_"); at != std::string_view::npos)
    return {.from = typeNamed(name.substr(0, at)), .to = typeNamed(name.substr(at + 7)), .cuts = true};
  if (name.starts_with("TRUNC_")) return {.to = typeNamed(name.substr(6)), .cuts = true};
  if (name.starts_with("TO_")) return {.to = typeNamed(name.substr(3))};
  const std::size_t at = name.find("_TO_");
  if (at == std::string_view::npos) return found;
  std::string_view before = name.substr(0, at), behind = name.substr(at + 4);
  if (before == "BCD" || before.ends_with("_BCD")) {
    found.fromBcd = true;
    before.remove_suffix(before == "BCD" ? 3 : 4);
  } else if (behind == "BCD" || behind.starts_with("BCD_")) {
    found.toBcd = true;
    behind.remove_prefix(behind == "BCD" ? 3 : 4);
  }
  found.from = typeNamed(before);
  if (found.from == nullptr && !(found.fromBcd && before.empty())) return {};
  found.to = typeNamed(behind);
  if (found.toBcd && behind.empty() && found.from->isNumber())
    found.to = typeNamed(found.from->width == 8 ? "BYTE" : found.from->width == 16 ? "WORD" : "DWORD");
  return found;
}

bool isUnmodelled(const Type& type) { return type.kind == Kind::Unsupported || type.kind == Kind::Text; }

}  // namespace

const Type* conversionTarget(const std::string& name) { return conversionOf(name).to; }

const Type* Lowering::conversion(Scope& scope, const std::string& name, const Expr& expr) {
  const ConversionName row = conversionOf(name);
  if (row.to == nullptr)
    refuse(expr.span, fmt::format("there is no function and no instance {}", excerpt(expr.parts[0].name)),
           Syntax::IecName);
  for (const Type* type : {row.to, row.from}) {
    if (type != nullptr && isUnmodelled(*type))
      refuse(expr.span, fmt::format("{}: conversions of {} are not modelled", name, type->name),
             Syntax::IecNotModelled);
  }
  const std::vector<const Expr*> values = plainArguments(expr, {"IN"});
  if (values.size() != 1) refuse(expr.span, fmt::format("the arguments of {} do not fit", name));
  const Type* source = value(scope, *values[0], row.from);
  if (row.from != nullptr && row.from != source) {
    convertImplicitly(*source, *row.from, expr.span);
    source = row.from;
  }
  if (row.fromBcd || row.toBcd) {
    if (!source->isNumber() || !row.to->isNumber() || source->isLong() || row.to->isLong())
      refuse(expr.span, fmt::format("{} is not modelled", name), Syntax::IecNotModelled);
    emit("RESIZE", {source->width, 32, source->isSigned ? 1 : 0});
    row.fromBcd ? fromBcd() : toBcd();
    emit("RESIZE", {32, row.to->width, 0});
  } else {
    convert(*source, *row.to, row.cuts, expr.span);
  }
  return row.to;
}

/// Eight digits of 4 bits; what is no digit counts as the number that it is.
void Lowering::fromBcd() {
  const Type& whole = *elementaryType("UDINT");
  const std::uint32_t code = allocate(4);
  store(whole, code);
  constant(0, 32);
  for (int shift = 28; shift >= 0; shift -= 4) {
    constant(10, 32);
    emit("MUL", {32});
    load(whole, code);
    constant(shift, 32);
    emit("SHR", {32});
    constant(15, 32);
    emit("AND", {32});
    emit("ADD", {32});
  }
}

void Lowering::toBcd() {
  const Type& whole = *elementaryType("UDINT");
  const std::uint32_t number = allocate(4);
  store(whole, number);
  constant(0, 32);
  std::int64_t unit = 1;
  for (int shift = 0; shift < 32; shift += 4, unit *= 10) {
    load(whole, number);
    constant(unit, 32);
    emit("DIV", {32, 0});
    constant(10, 32);
    emit("MOD", {32, 0});
    constant(shift, 32);
    emit("SHL", {32});
    emit("OR", {32});
  }
}

void Lowering::convert(const Type& from, const Type& to, bool cuts, Span span) {
  if (from.kind == Kind::Date || to.kind == Kind::Date) return convertDate(from, to, span);
  if (from.kind == Kind::Time && to.kind == Kind::Time) {
    if (from.width == to.width) return;
    constexpr std::int64_t nanoseconds = 1'000'000;
    if (to.isLong()) emit("RESIZE", {32, 64, 1});
    constant(nanoseconds, 64);
    if (to.isLong()) return emit("MUL", {64});
    emit("DIV", {64, 1});
    return emit("RESIZE", {64, 32, 1});
  }
  if (from.kind == Kind::Time) return fromDuration(from, to, span);
  if (to.kind == Kind::Time) return toDuration(from, to, span);
  if (from.kind == Kind::Real) {
    if (to.kind == Kind::Real) {
      if (from.width != to.width) emit(to.isLong() ? "REAL.LREAL" : "LREAL.REAL");
      return;
    }
    if (to.kind == Kind::Bool) {
      pushValue(realConstant(0, nullptr), from, span);
      return emit(from.isLong() ? "NE.LREAL" : "NE.REAL");
    }
    if (to.isLong() && !from.isLong()) emit("REAL.LREAL");
    return emit(to.isLong() || from.isLong() ? "FROM.LREAL" : "FROM.REAL",
                {to.width, to.isSigned ? 1 : 0, cuts ? 0 : 1});
  }
  if (to.kind == Kind::Real) {
    const bool isLong = to.isLong() || from.isLong();
    emit("RESIZE", {from.width, isLong ? 64 : 32, from.isSigned ? 1 : 0});
    if (!isLong) return emit("TO.REAL", {from.width == 32 && !from.isSigned ? 0 : 1});
    return emit("TO.LREAL", {to.width, from.isLong() && !from.isSigned ? 0 : 1});
  }
  if (to.kind == Kind::Bool && from.kind != Kind::Bool) return toBool(from);
  emit("RESIZE", {from.width, to.width, from.isSigned ? 1 : 0});
}

/// Of a bit string its lowest bit by one reading; of a number whether it is not 0.
void Lowering::toBool(const Type& from) {
  if (from.kind != Kind::BitString) {
    constant(0, from.width);
    return emit("NE", {from.width, 0});
  }
  const std::uint32_t bits = allocate(from.bytes);
  store(from, bits);
  emit("READING", {static_cast<std::int64_t>(Choice::IecToBool), 1});
  load(from, bits);
  constant(0, from.width);
  emit("NE", {from.width, 0});
  load(from, bits);
  emit("RESIZE", {from.width, 1, 0});
  emit("SEL", {1});
}

/// Of a TIME: milliseconds or seconds, by the reading in force; of an LTIME nanoseconds.
void Lowering::fromDuration(const Type& from, const Type& to, Span span) {
  if (from.isLong()) {
    if (!to.isNumber() || !to.isLong())
      refuse(span, fmt::format("LTIME_TO_{} is not modelled", to.name), Syntax::IecNotModelled);
    return;
  }
  const Type& whole = *elementaryType("DINT");
  const std::uint32_t duration = allocate(4);
  store(from, duration);
  emit("READING", {static_cast<std::int64_t>(Choice::IecTimeNumber), 1});
  load(from, duration);
  convert(whole, to, false, span);
  load(from, duration);
  if (to.kind == Kind::Real) {
    convert(whole, to, false, span);
    pushValue(realConstant(1000, nullptr), to, span);
    emit(to.isLong() ? "DIV.LREAL" : "DIV.REAL");
  } else {
    constant(1000, 32);
    emit("DIV", {32, 1});
    convert(whole, to, false, span);
  }
  emit("SEL", {to.width});
}

void Lowering::toDuration(const Type& from, const Type& to, Span span) {
  if (to.isLong()) {
    if (!from.isNumber() || !from.isLong())
      refuse(span, fmt::format("{}_TO_LTIME is not modelled", from.name), Syntax::IecNotModelled);
    return;
  }
  const bool isReal = from.kind == Kind::Real;
  const std::uint32_t number = allocate(from.isLong() ? 8 : 4);
  if (!isReal) emit("RESIZE", {from.width, 32, from.isSigned ? 1 : 0});
  const Type& kept = isReal ? from : to;
  store(kept, number);
  emit("READING", {static_cast<std::int64_t>(Choice::IecTimeNumber), 1});
  load(kept, number);
  load(kept, number);
  if (isReal) {
    pushValue(realConstant(1000, nullptr), from, span);
    emit(from.isLong() ? "MUL.LREAL" : "MUL.REAL");
  } else {
    constant(1000, 32);
    emit("MUL", {32});
  }
  emit("SEL", {kept.width});
  if (isReal) emit(from.isLong() ? "FROM.LREAL" : "FROM.REAL", {32, 1, 1});
}

}  // namespace rungproof::iec
