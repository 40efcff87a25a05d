// Parts of a value: w.%X3, d.%B1, d.%W0 are cut out of it by shifts and masks; %X0 and %B0 are its least significant
// ones. To write a part is to load the whole, put the part in, and store the whole. Tested by tests/scl/slice_test.cpp.
#include <fmt/format.h>

#include "frontend/step7/scl_lowering.hpp"
#include "frontend/stl/syntax_sink.hpp"

namespace rungproof::step7 {

using s7300::ConstantKind;
using s7300::TypeKind;

namespace {

Operand sclMask(std::uint64_t bits, TypeKind whole, Span span) {
  Constant made;
  made.kind = whole == TypeKind::DWord ? ConstantKind::DWord : ConstantKind::Word;
  made.value = static_cast<std::int64_t>(bits);
  return sclConstant(made, span);
}

}  // namespace

/// What the part is: BOOL, BYTE or WORD.
SclLowering::Kind SclLowering::kindOfSlice(const Spot& spot, Kind whole) {
  const iec::PathPart& part = *spot.slice;
  const auto bits = static_cast<std::uint32_t>(sclBits(whole));
  if (!isSclBits(whole) || part.bits >= bits || part.bit + part.bits > bits)
    refuse(part.span, fmt::format("a value of {} bits has no part {}", bits, written(part.span)), Syntax::SclType);
  return part.bits == 1 ? Kind::Bool : part.bits == 8 ? Kind::Byte : Kind::Word;
}

SclValue SclLowering::slice(const Spot& spot, SclValue whole) {
  const Kind kind = kindOfSlice(spot, whole.kind);
  const iec::PathPart& part = *spot.slice;
  const std::string wide = whole.kind == Kind::DWord ? "D" : "W";
  load(whole);
  if (kind != Kind::Bool && part.bit > 0) {
    Constant count;
    count.value = part.bit;
    emit("SR" + wide, sclConstant(count, span_));
  }
  const std::uint64_t ones = (std::uint64_t{1} << part.bits) - 1;
  emit("A" + wide, sclMask(kind == Kind::Bool ? ones << part.bit : ones, whole.kind, span_));
  if (kind != Kind::Bool) return inRegister(kind, part.span);
  emit("L", sclMask(0, whole.kind, span_));
  emit(wide == "D" ? "<>D" : "<>I");
  return inRegister(kind, part.span);
}

void SclLowering::storeSlice(const Spot& spot, Kind whole, const iec::Expr& given) {
  const Kind kind = kindOfSlice(spot, whole);
  const iec::PathPart& part = *spot.slice;
  const SclValue held = inTemporary(valueAs(given, kind));
  const std::string wide = whole == Kind::DWord ? "D" : "W";
  const std::uint64_t placed = ((std::uint64_t{1} << part.bits) - 1) << part.bit;
  const std::uint64_t all = (std::uint64_t{1} << sclBits(whole)) - 1;
  SclValue rest = inRegister(whole, part.span);
  emit("L", spot.indices.empty() ? spot.operand : pointTo(spot, whole, part.span));
  emit("A" + wide, sclMask(all & ~placed, whole, span_));
  rest = inTemporary(rest);
  if (kind == Kind::Bool) {
    const std::string isOff = freshLabel();
    emit("A", held.operand);
    emitJump("JCN", isOff);
    emit("L", rest.operand);
    emit("O" + wide, sclMask(placed, whole, span_));
    emit("T", rest.operand);
    mark(isOff);
    return store(spot, rest, part.span);
  }
  emit("L", held.operand);
  if (part.bit > 0) {
    Constant count;
    count.value = part.bit;
    emit("SL" + wide, sclConstant(count, span_));
  }
  emit("L", rest.operand);
  emit("O" + wide);
  store(spot, inRegister(whole, part.span), part.span);
}

}  // namespace rungproof::step7
