// State layout and real functions of the concrete domain.
#include "engine/concrete.hpp"

namespace rungproof {

Concrete::Store::Store(const Plan& plan) {
  const Target& target = plan.program->target;
  for (int a = 0; a < areaCount; ++a) {
    const Area area = static_cast<Area>(a);
    const bool inRegisters = addressedByNumber(area);
    areas_[static_cast<std::size_t>(a)].assign(inRegisters        ? 0
                                               : area == Area::L  ? plan.localBytes
                                               : area == Area::DB ? plan.blocks->size()
                                                                  : areaSize(target, area),
                                               0);
  }
  std::uint32_t next = 0;
  for (const RegInfo& info : regTable) {
    first_[static_cast<std::size_t>(info.reg)] = next;
    next += registerCount(info, plan);  // of terminals too, so that they can be counted
  }
  first_.back() = next;
  registers_.assign(next, 0);
  blocks_ = plan.blocks;
}

Concrete::Bits Concrete::rfunction(std::uint64_t f, Bits a) const {
  const float x = real(a);
  switch (static_cast<RealFunction>(f)) {
    case RealFunction::Sqrt: return pattern(std::sqrt(x));
    case RealFunction::Sin: return pattern(std::sin(x));
    case RealFunction::Cos: return pattern(std::cos(x));
    case RealFunction::Tan: return pattern(std::tan(x));
    case RealFunction::Ln: return pattern(std::log(x));
    case RealFunction::Exp: return pattern(std::exp(x));
    case RealFunction::ArcSin: return pattern(std::asin(x));
    case RealFunction::ArcCos: return pattern(std::acos(x));
    case RealFunction::ArcTan: return pattern(std::atan(x));
  }
  return 0;
}

Concrete::Bits Concrete::rtoInt(Bits a, bool round) const {
  const double x = real(a);
  if (!(std::abs(x) < 9.0e18)) return x < 0 ? Bits{1} << 63 : mask(63);
  return static_cast<Bits>(static_cast<std::int64_t>(round ? std::round(x) : std::trunc(x)));
}

Concrete::Bits Concrete::longReal(std::uint64_t which, Bits a, Bits b, int width) const {
  const double x = longReal(a), y = longReal(b);
  const auto ofWhole = [&](auto number) {
    return width == 32 ? pattern(static_cast<float>(number)) : longPattern(static_cast<double>(number));
  };
  switch (static_cast<LongRealOperation>(which)) {
    case LongRealOperation::Add: return longPattern(x + y);
    case LongRealOperation::Sub: return longPattern(x - y);
    case LongRealOperation::Mul: return longPattern(x * y);
    case LongRealOperation::Div: return longPattern(x / y);
    case LongRealOperation::Power: return longPattern(std::pow(x, y));
    case LongRealOperation::ArcTan2: return longPattern(std::atan2(x, y));
    case LongRealOperation::Sqrt: return longPattern(std::sqrt(x));
    case LongRealOperation::Sin: return longPattern(std::sin(x));
    case LongRealOperation::Cos: return longPattern(std::cos(x));
    case LongRealOperation::Tan: return longPattern(std::tan(x));
    case LongRealOperation::Ln: return longPattern(std::log(x));
    case LongRealOperation::Log: return longPattern(std::log10(x));
    case LongRealOperation::Exp: return longPattern(std::exp(x));
    case LongRealOperation::ArcSin: return longPattern(std::asin(x));
    case LongRealOperation::ArcCos: return longPattern(std::acos(x));
    case LongRealOperation::ArcTan: return longPattern(std::atan(x));
    case LongRealOperation::Truncate: return longPattern(std::trunc(x));
    case LongRealOperation::RoundEven: return longPattern(std::nearbyint(x));
    case LongRealOperation::RoundAway: return longPattern(std::round(x));
    case LongRealOperation::Floor: return longPattern(std::floor(x));
    case LongRealOperation::Ceil: return longPattern(std::ceil(x));
    case LongRealOperation::FromReal: return longPattern(real(a));
    case LongRealOperation::ToReal: return pattern(static_cast<float>(x));
    case LongRealOperation::FromSigned: return ofWhole(static_cast<std::int64_t>(a));
    case LongRealOperation::FromUnsigned: return ofWhole(a);
    case LongRealOperation::ToSigned:
      if (!(std::abs(x) < 0x1p63)) return x < 0 ? Bits{1} << 63 : mask(63);
      return static_cast<Bits>(static_cast<std::int64_t>(x));
    case LongRealOperation::ToUnsigned:
      if (!(x > 0)) return 0;
      return x < 0x1p64 ? static_cast<Bits>(x) : mask(64);
  }
  return 0;
}

}  // namespace rungproof
