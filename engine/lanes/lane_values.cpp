// The steps that make values, as vector instructions.
#include "engine/lanes/lane_emitter.hpp"
#include "engine/lanes/vector_forms.hpp"
#include "ir/check.hpp"

namespace rungproof::lanes {

using namespace asmjit;  // its Operand: by its full name
namespace Inst = x86::Inst;

namespace {

constexpr VectorForms greater = {Inst::kIdVpcmpgtb, Inst::kIdVpcmpgtw, Inst::kIdVpcmpgtd, Inst::kIdVpcmpgtq};

}  // namespace

Vec LaneEmitter::valueOf(const Step& s) {
  switch (s.op) {
    case CodeOp::And:
    case CodeOp::Or:
    case CodeOp::Xor:
    case CodeOp::Not:
    case CodeOp::SelectBit: return truth(s);
    case CodeOp::TestBit: return testBit(s);
    case CodeOp::FromBit: return made(s.a);
    case CodeOp::Equal:
    case CodeOp::Less:
    case CodeOp::LessSigned: return comparison(s);
    case CodeOp::AddOverflows:
    case CodeOp::SubOverflows: return overflow(s);
    case CodeOp::LoadBit: return loaded({layout_.slot(s.value), Rep::Truth});
    case CodeOp::LoadState:
    case CodeOp::LoadStateWord: return loaded(layout_.state(s.value));
    case CodeOp::LoadRegister: return loaded(*layout_.reg(s.value));
    case CodeOp::LoadMemory: return loadMemory(s);
    case CodeOp::LoadSlots: return loadSlots(s);
    case CodeOp::LoadAt: return loadAt(s);
    case CodeOp::LoadTicks: {
      const Ymm all = fresh();
      c_.vpbroadcastw(all, at(offsetof(LaneLayout::Head, ticks) + 4 * s.value, 2));
      return {Rep::Word, {all, all}};
    }
    case CodeOp::Select: return select(s);
    case CodeOp::Join: return joinOf(s);
    case CodeOp::Extract: {
      if (repFor(s.width) != Rep::Truth) return extract(s);
      Step bit = s;
      bit.op = CodeOp::TestBit;
      return testBit(bit);
    }
    case CodeOp::RealEqual:
    case CodeOp::RealLess:
    case CodeOp::RealLegal:
    case CodeOp::RealAdd:
    case CodeOp::RealSub:
    case CodeOp::RealMul:
    case CodeOp::RealDiv:
    case CodeOp::RealFromInt: return real(s);
    case CodeOp::BitAnd:
    case CodeOp::BitOr:
    case CodeOp::BitXor:
    case CodeOp::BitNot: return bitwise(s);
    default: {
      const Vec number = numberOf(s);
      return repFor(widthOf(s)) == Rep::Truth ? isOne(number) : number;
    }
  }
}

Vec LaneEmitter::numberOf(const Step& s) {
  switch (s.op) {
    case CodeOp::ShiftLeft:
    case CodeOp::ShiftRight: return shift(s);
    case CodeOp::Add:
    case CodeOp::Sub:
    case CodeOp::Mul:
    case CodeOp::Signed: return cut(arithmetic(s), s.width);
    default: return byTrace(s);
  }
}

Vec LaneEmitter::truth(const Step& s) {
  const auto bit = [&](ValueId id) { return use(id, Rep::Truth).piece[0]; };
  switch (s.op) {
    case CodeOp::And:
      if (flow_.isFolded[s.a]) return {Rep::Truth, {op(Inst::kIdVpandn, bit(code_.steps[s.a].a), bit(s.b))}};
      if (flow_.isFolded[s.b]) return {Rep::Truth, {op(Inst::kIdVpandn, bit(code_.steps[s.b].a), bit(s.a))}};
      return {Rep::Truth, {op(Inst::kIdVpand, bit(s.a), bit(s.b))}};
    case CodeOp::Or: return {Rep::Truth, {op(Inst::kIdVpor, bit(s.a), bit(s.b))}};
    case CodeOp::Xor: return {Rep::Truth, {op(Inst::kIdVpxor, bit(s.a), bit(s.b))}};
    case CodeOp::Not: return {Rep::Truth, {inverted(bit(s.a))}};
    default: return {Rep::Truth, {chosen(bit(s.a), bit(s.b), bit(s.c))}};
  }
}

/// Packing keeps signs.
Vec LaneEmitter::signOf(const Vec& number) {
  const Ymm sign = toTruth(number).piece[0];
  return {Rep::Truth, {op(Inst::kIdVpcmpgtb, constant(0, Rep::Truth).piece[0], sign)}};
}

Vec LaneEmitter::testBit(const Step& s) {
  const Vec a = made(s.a);
  if (a.rep == Rep::Truth) return s.value == 0 ? a : constant(0, Rep::Truth);
  if (static_cast<int>(s.value) >= bitsOf(a.rep)) return constant(0, Rep::Truth);
  if (a.rep != Rep::Quad && static_cast<int>(s.value) == bitsOf(a.rep) - 1) return signOf(a);
  const Mem own = constantRow(1ULL << s.value, a.rep);
  return toTruth(each(formOf(forms::equality, a.rep), each(Inst::kIdVpand, a, own), own));
}

Vec LaneEmitter::lessOf(const Step& s, Rep rep) {
  const auto isBelow = [&](const Vec& a, const Vec& b) { return toTruth(each(formOf(greater, rep), b, a)); };
  const Vec a = use(s.a, rep), b = use(s.b, rep);
  const std::uint64_t topBit = 1ULL << (bitsOf(rep) - 1);
  if (s.op == CodeOp::Less) {
    const bool fits = bitsNeeded(code_.steps[s.a]) < bitsOf(rep) && bitsNeeded(code_.steps[s.b]) < bitsOf(rep);
    if (fits) return isBelow(a, b);
    const Mem top = constantRow(topBit, rep);
    return isBelow(each(Inst::kIdVpxor, a, top), each(Inst::kIdVpxor, b, top));
  }
  if (s.width == bitsOf(rep)) return isBelow(a, b);
  // (x ^ sign) - sign continues the sign; without the subtraction numbers keep their order.
  const Mem sign = constantRow(1ULL << (s.width - 1), rep);
  return isBelow(each(Inst::kIdVpxor, a, sign), each(Inst::kIdVpxor, b, sign));
}

Vec LaneEmitter::comparison(const Step& s) {
  const int bits = std::max(bitsNeeded(code_.steps[s.a]), bitsNeeded(code_.steps[s.b]));
  if (s.op == CodeOp::Equal) {
    const Rep rep = numberFor(bits);
    return toTruth(each(formOf(forms::equality, rep), use(s.a, rep), use(s.b, rep)));
  }
  return lessOf(s, numberFor(std::max(bits, int{s.width})));
}

/// A sum of words that is not the one that stops at the ends overflows. Of double words it is one whose sign is none of
/// those of its parts, a difference where both parts differ in sign and it has not that of the first.
Vec LaneEmitter::overflow(const Step& s) {
  const bool isSum = s.op == CodeOp::AddOverflows;
  const Rep rep = repFor(s.width);
  const Vec a = use(s.a, rep), b = use(s.b, rep);
  const Vec result = each(formOf(isSum ? forms::addition : forms::subtraction, rep), a, b);
  if (rep == Rep::Word) {
    const Vec bounded = each(isSum ? Inst::kIdVpaddsw : Inst::kIdVpsubsw, a, b);
    return {Rep::Truth, {inverted(toTruth(each(Inst::kIdVpcmpeqw, result, bounded)).piece[0])}};
  }
  const Vec one = each(Inst::kIdVpxor, a, isSum ? result : b), other = each(Inst::kIdVpxor, isSum ? b : a, result);
  return signOf(each(Inst::kIdVpand, one, other));
}

Vec LaneEmitter::select(const Step& s) {
  const Rep rep = repFor(s.width);
  const Vec mask = use(s.a, rep, true), on = use(s.b, rep), off = use(s.c, rep);
  Vec to{rep};
  for (std::size_t i = 0; i < pieceCount(rep); ++i) to.piece[i] = chosen(mask.piece[i], on.piece[i], off.piece[i]);
  return to;
}

Vec LaneEmitter::bitwise(const Step& s) {
  const Rep rep = repFor(s.width);
  if (s.op == CodeOp::BitNot)
    return each(Inst::kIdVpxor, use(s.a, rep), constantRow(Concrete::mask(std::max(int{s.width}, 1)), rep));
  const InstId id = s.op == CodeOp::BitAnd ? Inst::kIdVpand : s.op == CodeOp::BitOr ? Inst::kIdVpor : Inst::kIdVpxor;
  return each(id, use(s.a, rep), use(s.b, rep));
}

Vec LaneEmitter::arithmetic(const Step& s) {
  const Rep rep = numberFor(s.width);
  const auto both = [&](InstId id, Rep as) { return each(id, use(s.a, as), use(s.b, as)); };
  switch (s.op) {
    case CodeOp::Add: return both(formOf(forms::addition, rep), rep);
    case CodeOp::Sub: return both(formOf(forms::subtraction, rep), rep);
    case CodeOp::Mul:
      if (rep == Rep::Quad) return byTrace(s);
      if (rep == Rep::Byte) return fit(both(Inst::kIdVpmullw, Rep::Word), rep, 8);
      return both(rep == Rep::Word ? Inst::kIdVpmullw : Inst::kIdVpmulld, rep);
    default: {  // CodeOp::Signed
      const Mem sign = constantRow(1ULL << (s.value - 1), rep);
      return each(formOf(forms::subtraction, rep), each(Inst::kIdVpxor, use(s.a, rep), sign), sign);
    }
  }
}

Vec LaneEmitter::joinOf(const Step& s) {
  const Rep own = repFor(widthOf(s));
  const Rep part = s.value == 8 ? Rep::Byte : Rep::Word;
  const bool isUnpacking = (own == Rep::Word && s.value == 8) || (own == Rep::Double && s.value == 16);
  if (isUnpacking) return together(use(s.a, part), use(s.b, part));
  const Rep rep = std::max(own, Rep::Word);
  Vec both = each(Inst::kIdVpor, shifted(use(s.a, rep), true, static_cast<std::uint32_t>(s.value)), use(s.b, rep));
  while (both.rep > own) both = narrowed(both, false);
  return both;
}

Vec LaneEmitter::real(const Step& s) {
  const Vec a = use(s.a, Rep::Double);
  if (s.op == CodeOp::RealLegal) {  // the exponent is not all ones
    const Mem exponent = constantRow(0x7F800000, Rep::Double);
    const Vec isSpecial = toTruth(each(Inst::kIdVpcmpeqd, each(Inst::kIdVpand, a, exponent), exponent));
    return {Rep::Truth, {inverted(isSpecial.piece[0])}};
  }
  if (s.op == CodeOp::RealFromInt) {
    Vec to{Rep::Double};
    for (std::size_t i = 0; i < pieceCount(Rep::Double); ++i) {
      to.piece[i] = fresh();
      c_.vcvtdq2ps(to.piece[i], a.piece[i]);
    }
    return to;
  }
  const Vec b = use(s.b, Rep::Double);
  const auto compared = [&](const Vec& x, const Vec& y, std::uint32_t how) {
    Vec mask{Rep::Double};
    for (std::size_t i = 0; i < pieceCount(Rep::Double); ++i) {
      mask.piece[i] = fresh();
      c_.vcmpps(mask.piece[i], x.piece[i], y.piece[i], imm(how));
    }
    return mask;
  };
  constexpr std::uint32_t equalOrdered = 0, lessOrdered = 0x11, unordered = 3;
  if (s.op == CodeOp::RealEqual) return toTruth(compared(a, b, equalOrdered));
  if (s.op == CodeOp::RealLess) return toTruth(compared(a, b, lessOrdered));
  const Vec result = each(s.op == CodeOp::RealAdd   ? Inst::kIdVaddps
                          : s.op == CodeOp::RealSub ? Inst::kIdVsubps
                          : s.op == CodeOp::RealMul ? Inst::kIdVmulps
                                                    : Inst::kIdVdivps,
                          a, b);
  const Vec isNan = compared(result, result, unordered), oneNan = constant(0x7FC00000, Rep::Double);
  Vec to{Rep::Double};
  for (std::size_t i = 0; i < pieceCount(Rep::Double); ++i)
    to.piece[i] = chosen(isNan.piece[i], oneNan.piece[i], result.piece[i]);
  return to;
}

}  // namespace rungproof::lanes
