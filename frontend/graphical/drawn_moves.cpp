// Numbers on their way: moves, widening and narrowing. A narrower number is widened with its sign (zero for unsigned
// types and bit strings); a result goes back to a narrower type by its low bytes, so that sums of SINT, USINT and UINT
// wrap as the standard's two's complement would.
#include <fmt/format.h>

#include <bit>

#include "frontend/graphical/drawn_lowering.hpp"
#include "frontend/stl/stl_lexer.hpp"

namespace rungproof {

namespace {

bool isInteger(IecType type) {
  return type != IecType::None && type != IecType::Bool && type != IecType::Real && type != IecType::String;
}

/// Whether a value of type `from` may be stored as it is: equal, or of equal width and none of them REAL or TIME
/// against a bit pattern.
bool isCompatible(IecType from, IecType to) {
  if (from == to) return true;
  return isInteger(from) && isInteger(to) && widthOf(from) == widthOf(to);
}

}  // namespace

Operand DrawnLowering::lowPart(Operand operand, Width width) {
  operand.offset += static_cast<std::uint32_t>(bytes(operand.width) - bytes(width));
  operand.width = width;
  return operand;
}

std::optional<Operand> DrawnLowering::widened(const DrawnValue& value, Arithmetic kind, Wire enable,
                                              const DrawnElement& element) {
  const auto wrong = [&]() -> std::optional<Operand> {
    sink_.operand(element, fmt::format("it calculates with {}, but gets {}",
                                       kind == Arithmetic::Real  ? "REAL"
                                       : kind == Arithmetic::Int ? "INT"
                                                                 : "DINT",
                                       iecTypeName(value.type)));
    return std::nullopt;
  };
  if (!value.isData()) {
    sink_.operand(element,
                  value.isPower() ? "it calculates with numbers, but gets power flow" : "an input is left open");
    return std::nullopt;
  }
  if (value.operand.kind == OperandKind::Constant) {
    Operand result = value.operand;
    const bool isReal = value.type == IecType::Real;
    if (kind == Arithmetic::Real) {
      if (!isReal)
        result = constant(static_cast<std::int64_t>(std::bit_cast<std::uint32_t>(static_cast<float>(result.value))),
                          ConstantForm::Real);
      return result;
    }
    if (isReal) return wrong();
    const IecType range = kind == Arithmetic::Int ? IecType::Int : IecType::Dint;
    if (!fits(result.value, range) && !isBitString(value.type)) {
      sink_.operand(element, fmt::format("constant {} does not fit {}", result.value, iecTypeName(range)));
      return std::nullopt;
    }
    return result;
  }
  if ((kind == Arithmetic::Real) != (value.type == IecType::Real)) return wrong();
  if (kind == Arithmetic::Real) return value.operand;
  const Width width = widthOf(value.type);
  Operand result = value.operand;
  if (width == Width::Byte) {
    const Operand word = temporary(IecType::Int);
    box("BTI", {result, word}, enable);
    if (value.type == IecType::Sint) {  // flips the sign bit and takes it away again: 0..255 to -128..127
      box("XORW", {constant(128), word}, enable);
      box("-I", {constant(128), word}, enable);
    }
    result = word;
  }
  if (kind == Arithmetic::Int) return width == Width::DWord ? wrong() : std::optional(result);
  if (width == Width::DWord) return result;
  const Operand wide = temporary(IecType::Dint);
  if (value.type == IecType::Uint || value.type == IecType::Word) {
    box("MOVD", {constant(0), wide}, enable);
    box("MOVW", {result, lowPart(wide, Width::Word)}, enable);
  } else {
    box("ITD", {result, wide}, enable);
  }
  return wide;
}

void DrawnLowering::moveTo(const VariablePlace& target, const DrawnValue& value, Wire enable,
                           const DrawnElement& element) {
  if (target.constant || target.copy != nullptr)
    return sink_.operand(element, "the result would go to something that cannot be written");
  if (value.kind == DrawnValue::Kind::Nothing) return;
  const auto mismatch = [&](std::string_view given) {
    sink_.operand(element, fmt::format("a result of type {} does not fit a variable of type {}", given,
                                       iecTypeName(target.type)));
  };
  if (value.isPower()) {
    if (target.type != IecType::Bool) return mismatch("BOOL");
    return assign(target.operand, value.wire);
  }
  if (target.type == IecType::Bool || target.type == IecType::String) return mismatch(iecTypeName(value.type));
  if (value.type == IecType::String) return mismatch("STRING");
  Operand source = value.operand;
  if (source.kind == OperandKind::Constant) {
    if (target.type == IecType::Real && value.type != IecType::Real) {
      if (value.type != IecType::None) return mismatch(iecTypeName(value.type));
      source = constant(static_cast<std::int64_t>(std::bit_cast<std::uint32_t>(static_cast<float>(source.value))),
                        ConstantForm::Real);
    } else if ((value.type == IecType::Real) != (target.type == IecType::Real)) {
      return mismatch(iecTypeName(value.type));
    } else if (target.type != IecType::Real && !fits(source.value, target.type)) {
      return sink_.operand(element, fmt::format("constant {} does not fit {}", source.value, iecTypeName(target.type)));
    }
  } else if (!isCompatible(value.type, target.type)) {
    const bool widens = isInteger(value.type) && isInteger(target.type) && widthOf(value.type) < widthOf(target.type);
    if (!widens) return mismatch(iecTypeName(value.type));
    const auto wide =
        widened(value, widthOf(target.type) == Width::DWord ? Arithmetic::DInt : Arithmetic::Int, enable, element);
    if (!wide) return;
    source = *wide;
  }
  box(moveOf(target.type), {source, target.operand}, enable);
}

}  // namespace rungproof
