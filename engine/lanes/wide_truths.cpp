// The steps that make truth values.
#include "engine/lanes/vector_forms.hpp"
#include "engine/lanes/wide_emitter.hpp"

namespace rungproof::lanes {

using namespace asmjit;  // its Operand: by its full name
namespace Inst = x86::Inst;

namespace {

constexpr VectorForms signedOrder = {Inst::kIdVpcmpb, Inst::kIdVpcmpw, Inst::kIdVpcmpd, Inst::kIdVpcmpq};
constexpr VectorForms unsignedOrder = {Inst::kIdVpcmpub, Inst::kIdVpcmpuw, Inst::kIdVpcmpud, Inst::kIdVpcmpuq};
constexpr VectorForms signs = {Inst::kIdVpmovb2m, Inst::kIdVpmovw2m, Inst::kIdVpmovd2m, Inst::kIdVpmovq2m};
constexpr std::uint32_t askEqual = 0, askLess = 1, askLessOrEqual = 2, askNotEqual = 4, askNotLess = 5, askGreater = 6;

}  // namespace

/// No register: it is held as masks.
x86::Gp WideEmitter::truthOf(const Step& s) {
  const auto joined = [&](InstId id) {
    const Gp to = writable(s.a);
    c_.emit(id, to, truthSource(s.b));
    return to;
  };
  const auto andNot = [&](ValueId negated, ValueId other) {
    const Gp to = freshGp();
    c_.emit(Inst::kIdAndn, to, truth(negated), truthSource(other));
    return to;
  };
  switch (s.op) {
    case CodeOp::And:
      if (flow_.isFolded[s.a]) return andNot(code_.steps[s.a].a, s.b);
      if (flow_.isFolded[s.b]) return andNot(code_.steps[s.b].a, s.a);
      if (flow_.isFit[s.a]) return andNot(s.a, s.b);
      if (flow_.isFit[s.b]) return andNot(s.b, s.a);
      return joined(Inst::kIdAnd);
    case CodeOp::Or: return joined(Inst::kIdOr);
    case CodeOp::Xor: return joined(Inst::kIdXor);
    case CodeOp::Not: {
      const Gp to = writable(s.a);
      c_.not_(to);
      return to;
    }
    case CodeOp::SelectBit: {
      const Gp to = freshGp();
      if (const auto taken = flow_.takenAt.find(step_); taken != flow_.takenAt.end()) {  // ab | -ac
        c_.emit(Inst::kIdAndn, to, truth(s.a), truthSource(s.c));
        c_.emit(Inst::kIdOr, to, truthSource(taken->second));
        return to;
      }
      // ((b ^ c) & a) ^ c
      const asmjit::Operand off = truthSource(s.c);
      c_.emit(Inst::kIdMov, to, truthSource(s.b));
      c_.emit(Inst::kIdXor, to, off);
      c_.emit(Inst::kIdAnd, to, truthSource(s.a));
      c_.emit(Inst::kIdXor, to, off);
      return to;
    }
    case CodeOp::FromBit: return copied(truth(s.a));
    case CodeOp::TestBit: return testBit(s);
    case CodeOp::Equal:
    case CodeOp::Less:
    case CodeOp::LessSigned: return comparison(s);
    case CodeOp::AddOverflows:
    case CodeOp::SubOverflows: return overflow(s);
    case CodeOp::RealEqual:
    case CodeOp::RealLess:
    case CodeOp::RealLegal: return realTruth(s);
    case CodeOp::LoadBit:
    case CodeOp::LoadState:
    case CodeOp::LoadStateWord:
    case CodeOp::LoadRegister: {
      const Gp to = freshGp();
      const std::size_t offset = s.op == CodeOp::LoadBit        ? layout_.slot(s.value)
                                 : s.op == CodeOp::LoadRegister ? layout_.reg(s.value)->at
                                                                : layout_.state(s.value).at;
      c_.mov(to, at(offset, wideTruthBytes));
      return to;
    }
    case CodeOp::Extract: {
      Step bit = s;
      bit.op = CodeOp::TestBit;
      return testBit(bit);
    }
    default: {  // a number of one bit
      const Number wide = numberOf(s);
      return truthFrom(compared(formOf(unsignedOrder, wide.rep), wide, constant(1, wide.rep), askEqual), wide.rep);
    }
  }
}

x86::Gp WideEmitter::testBit(const Step& s) {
  const Step& of = code_.steps[s.a];
  if (of.op == CodeOp::Constant || isScalar(s.a)) return scalarTruth(s);
  if (repFor(widthOf(of)) == Rep::Truth) return s.value == 0 ? copied(truth(s.a)) : truth(0);
  const Number a = made(s.a);
  if (static_cast<int>(s.value) >= bitsOf(a.rep)) return truth(0);
  if (static_cast<int>(s.value) != bitsOf(a.rep) - 1)
    return truthFrom(tested(a, constant(1ULL << s.value, a.rep)), a.rep);
  Masks masks;
  for (std::size_t i = 0; i < pieceCount(a.rep); ++i) {
    masks[i] = freshMask();
    c_.emit(formOf(signs, a.rep), masks[i], inRegister(a.piece[i]));
  }
  return truthFrom(masks, a.rep);
}

x86::Gp WideEmitter::comparison(const Step& s) {
  if (flow_.isCommon[step_]) return scalarTruth(s);
  int bits = std::max(bitsNeeded(code_.steps[s.a]), bitsNeeded(code_.steps[s.b]));
  if (s.op != CodeOp::Equal) bits = std::max(bits, int{s.width});
  const Rep rep = numberFor(bits);
  Number a = use(s.a, rep), b = use(s.b, rep);
  if (s.op == CodeOp::LessSigned && s.width != bitsOf(rep)) {
    const Number sign = constant(1ULL << (s.width - 1), rep);  // what is negative comes before what is not
    a = each(Inst::kIdVpxorq, a, sign);
    b = each(Inst::kIdVpxorq, b, sign);
  }
  const VectorForms& order = s.op == CodeOp::LessSigned && s.width == bitsOf(rep) ? signedOrder : unsignedOrder;
  const bool isTurned = a.piece[0].isMem() && !b.piece[0].isMem();
  const std::uint32_t how = s.op == CodeOp::Equal ? askEqual : isTurned ? askGreater : askLess;
  const Masks masks = compared(formOf(order, rep), isTurned ? b : a, isTurned ? a : b, how);
  holdMasks(step_, rep, masks);
  return {};
}

/// With one constant part, a sum overflows where the other is beyond a bound.
x86::Gp WideEmitter::overflowByConstant(const Step& s, const Number& a, std::uint64_t constantPart) {
  const std::int64_t least = -(std::int64_t{1} << (s.width - 1)), most = -least - 1;
  const std::int64_t part = static_cast<std::int64_t>(constantPart << (64 - s.width)) >> (64 - s.width);
  const std::int64_t added = s.op == CodeOp::AddOverflows ? part : -part;
  if (added == 0) return truth(0);
  const std::int64_t bound = added > 0 ? most - added : least - added;
  const Number limit = constant(static_cast<std::uint64_t>(bound) & Concrete::mask(s.width), a.rep);
  const std::uint32_t beyond = added > 0 ? askGreater : askLess, within = added > 0 ? askLessOrEqual : askNotLess;
  holdMasks(step_, a.rep, compared(formOf(signedOrder, a.rep), a, limit, flow_.isFit[step_] ? within : beyond));
  return {};
}

/// A sum of words that is not the one that stops at the ends overflows. Of double words it is one whose sign is none of
/// those of its parts, a difference where both parts differ in sign and it has not that of the first.
x86::Gp WideEmitter::overflow(const Step& s) {
  if (flow_.isCommon[step_]) return scalarTruth(s);
  const bool isSum = s.op == CodeOp::AddOverflows;
  const Rep rep = repFor(s.width);
  const Step &left = code_.steps[s.a], &right = code_.steps[s.b];
  if (right.op == CodeOp::Constant) return overflowByConstant(s, use(s.a, rep), right.value);
  if (isSum && left.op == CodeOp::Constant) return overflowByConstant(s, use(s.b, rep), left.value);
  const Number a = use(s.a, rep), b = use(s.b, rep);
  const auto known = sums_.find(sumOf(isSum ? CodeOp::Add : CodeOp::Sub, s.a, s.b));
  const bool isKnown = known != sums_.end() && numbers_.contains(keyOf(known->second, rep));
  const Number result =
      isKnown ? use(known->second, rep) : each(formOf(isSum ? forms::addition : forms::subtraction, rep), a, b);
  if (rep == Rep::Word) {
    const Number bounded = each(isSum ? Inst::kIdVpaddsw : Inst::kIdVpsubsw, a, b);
    holdMasks(step_, rep, compared(Inst::kIdVpcmpw, result, bounded, askNotEqual));
    return {};
  }
  Masks masks;
  for (std::size_t i = 0; i < pieceCount(rep); ++i) {
    // By bits of result, a and b: (r ^ a) & (r ^ b), or (a ^ b) & (r ^ a).
    constexpr std::uint32_t ofSum = 0x18, ofDifference = 0x24;
    const Zmm sign = freshZmm();
    c_.vmovdqa64(sign, inRegister(result.piece[i]));
    c_.emit(Inst::kIdVpternlogd, sign, inRegister(a.piece[i]), b.piece[i], imm(isSum ? ofSum : ofDifference));
    masks[i] = freshMask();
    c_.vpmovd2m(masks[i], sign);
  }
  holdMasks(step_, rep, masks);
  return {};
}

x86::Gp WideEmitter::realTruth(const Step& s) {
  constexpr std::uint32_t equalOrdered = 0, lessOrdered = 0x11;
  const Number a = use(s.a, Rep::Double);
  if (s.op == CodeOp::RealLegal) {  // the exponent is not all ones
    const Number exponent = constant(0x7F800000, Rep::Double);
    const Number own = each(Inst::kIdVpandq, a, exponent);
    return truthFrom(compared(Inst::kIdVpcmpd, own, exponent, askNotEqual), Rep::Double);
  }
  const Number b = use(s.b, Rep::Double);
  return truthFrom(compared(Inst::kIdVcmpps, a, b, s.op == CodeOp::RealEqual ? equalOrdered : lessOrdered),
                   Rep::Double);
}

}  // namespace rungproof::lanes
