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

}  // namespace rungproof
