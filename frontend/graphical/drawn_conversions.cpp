// Shifts, mathematics and conversions between types. Narrowing takes the low bytes; REAL to an integer rounds
// (001:3465), TRUNC cuts off.
#include <fmt/format.h>

#include "frontend/graphical/drawn_functions.hpp"

namespace rungproof {

bool DrawnFunctions::shift(std::string_view name, DrawnValue& result) {
  if (name != "SHL" && name != "SHR" && name != "ROL" && name != "ROR") return false;
  if (!readInputs(2, 2)) return true;
  if (!in_[0].isData() || !in_[1].isData() || in_[0].type == IecType::Real || in_[0].type == IecType::Time ||
      in_[0].type == IecType::String) {
    l_.sink_.operand(e_, "it shifts BYTE, WORD and DWORD by a number");
    return true;
  }
  const IecType type = in_[0].type == IecType::None ? commonType() : in_[0].type;
  const char width = widthOf(type) == Width::Byte ? 'B' : widthOf(type) == Width::Word ? 'W' : 'D';
  Operand count = in_[1].operand;
  if (count.kind == OperandKind::Constant) {
    if (!fits(count.value, IecType::Byte)) {
      l_.sink_.operand(e_, fmt::format("it cannot shift by {}", count.value));
      return true;
    }
  } else if (in_[1].type == IecType::Real || in_[1].type == IecType::String) {
    l_.sink_.operand(e_, "the number of places must be an integer");
    return true;
  } else {
    // More than a byte holds is more than any width: nothing is left of the value. Rotations begin anew with each
    // width.
    if (widthOf(in_[1].type) == Width::Word && name.front() == 'S') {
      const Operand places = l_.temporary(IecType::Int);
      move(count, places, IecType::Int, enable_);
      move(constant(255), places, IecType::Int, l_.compare("LDW>", places, constant(255), enable_));
      move(constant(255), places, IecType::Int, l_.compare("LDW<", places, constant(0), enable_));
      count = places;
    } else if (widthOf(in_[1].type) == Width::DWord && name.front() == 'S') {
      l_.sink_.operand(e_, "the number of places must be an INT or a BYTE");
      return true;
    }
    count = widthOf(in_[1].type) == Width::Byte ? count : l_.lowPart(count, Width::Byte);
  }
  result = moved(in_[0], type, enable_);
  l_.box(fmt::format("{}{}{}", name.substr(0, 1) == "S" ? 'S' : 'R', name.back(), width), {result.operand, count},
         enable_);
  return true;
}

bool DrawnFunctions::mathematics(std::string_view name, DrawnValue& result) {
  if (name == "ABS" || name == "NEG") {
    if (!readInputs(1, 1)) return true;
    const IecType type = commonType();
    if (type != IecType::Int && type != IecType::Dint && type != IecType::Real && type != IecType::Time) {
      l_.sink_.operand(e_, fmt::format("{} works on INT, DINT and REAL", name));
      return true;
    }
    const Arithmetic kind = type == IecType::Real  ? Arithmetic::Real
                            : type == IecType::Int ? Arithmetic::Int
                                                   : Arithmetic::DInt;
    const DrawnValue zero = l_.data(type == IecType::Real ? constant(0, ConstantForm::Real) : constant(0), type);
    if (name == "NEG") {
      result = moved(zero, type, enable_);
      sum('-', kind, in_[0].operand, result.operand, enable_);
      return true;
    }
    result = moved(in_[0], type, enable_);
    const Wire isNegative = related("<", in_[0], zero, enable_);
    move(zero.operand, result.operand, type, isNegative);
    sum('-', kind, in_[0].operand, result.operand, isNegative);
    return true;
  }
  if (name == "TRUNC" || name == "ROUND") {
    if (!readInputs(1, 1)) return true;
    const auto real = l_.widened(in_[0], Arithmetic::Real, enable_, e_);
    if (!real) return true;
    const Operand place = resultPlace(IecType::Dint);
    l_.box(name, {*real, place}, enable_);
    result = l_.data(place, IecType::Dint);
    return true;
  }
  if (name != "SQRT" && name != "LN" && name != "EXP" && name != "SIN" && name != "COS" && name != "TAN") return false;
  if (!readInputs(1, 1)) return true;
  const auto real = l_.widened(in_[0], Arithmetic::Real, enable_, e_);
  if (!real) return true;
  const Operand place = resultPlace(IecType::Real);
  l_.box(name, {*real, place}, enable_);
  result = l_.data(place, IecType::Real);
  return true;
}

DrawnValue DrawnFunctions::converted(const DrawnValue& value, IecType to) {
  const auto refuse = [&] {
    l_.sink_.operand(
        e_, fmt::format("{} cannot be converted to {} on the S7-200", iecTypeName(value.type), iecTypeName(to)));
    return DrawnValue{};
  };
  if (value.type == IecType::String || to == IecType::String) return refuse();
  if (value.isPower()) {
    if (to == IecType::Bool) return value;
    if (to == IecType::Real) return refuse();
    const DrawnValue result = moved(l_.data(constant(0), IecType::None), to, enable_);
    move(constant(1), result.operand, to, l_.gate(Shape::And, {enable_, value.wire}));
    return result;
  }
  if (to == IecType::Bool)
    return l_.power(related(
        "<>", value,
        l_.data(constant(0, value.type == IecType::Real ? ConstantForm::Real : ConstantForm::Decimal), value.type),
        l_.rail()));
  if (to == IecType::Real) {
    if (value.type == IecType::Real) return value;
    if (value.type == IecType::Udint || value.type == IecType::Dword) return refuse();
    const auto wide = l_.widened(value, Arithmetic::DInt, enable_, e_);
    if (!wide) return {};
    const Operand place = resultPlace(IecType::Real);
    l_.box("DTR", {*wide, place}, enable_);
    return l_.data(place, IecType::Real);
  }
  Operand whole = value.operand;
  IecType type = value.type;
  if (type == IecType::Real) {
    if (to == IecType::Time || to == IecType::Udint || to == IecType::Dword) return refuse();
    whole = l_.temporary(IecType::Dint);
    l_.box("ROUND", {value.operand, whole}, enable_);
    type = IecType::Dint;
  }
  if (whole.kind == OperandKind::Constant) return fits(whole.value, to) ? l_.data(whole, to) : refuse();
  if (widthOf(type) == widthOf(to)) return l_.data(whole, to);
  if (widthOf(type) > widthOf(to)) return l_.data(l_.lowPart(whole, widthOf(to)), to);
  const auto wide =
      l_.widened(l_.data(whole, type), widthOf(to) == Width::DWord ? Arithmetic::DInt : Arithmetic::Int, enable_, e_);
  return wide ? l_.data(*wide, to) : DrawnValue{};
}

bool DrawnFunctions::conversion(std::string_view name, DrawnValue& result) {
  const std::size_t at = name.starts_with("TO_") ? 0 : name.find("_TO_");
  if (at == std::string_view::npos) return false;
  const IecType to = iecTypeNamed(name.substr(at == 0 ? 3 : at + 4));
  if (to == IecType::None) return false;
  if (!readInputs(1, 1)) return true;
  const IecType from = at == 0 ? IecType::None : iecTypeNamed(name.substr(0, at));
  DrawnValue value = in_[0];
  if (value.type == IecType::None) value.type = from;
  if (from != IecType::None && value.type != from &&
      !(widthOf(from) == widthOf(value.type) && (from == IecType::Real) == (value.type == IecType::Real))) {
    l_.sink_.operand(e_, fmt::format("it converts {}, but gets {}", iecTypeName(from), iecTypeName(value.type)));
    return true;
  }
  if (from != IecType::None && value.isData()) value.type = from;
  result = converted(value, to);
  return true;
}

}  // namespace rungproof
