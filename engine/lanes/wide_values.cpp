// The steps that make values.
#include <bit>

#include "engine/lanes/wide_emitter.hpp"
#include "ir/check.hpp"

namespace rungproof::lanes {

using namespace asmjit;  // its Operand: by its full name
namespace Inst = x86::Inst;

namespace {

/// One instruction in its forms for bytes, words, double and quad words.
using WideForms = std::array<InstId, 4>;
constexpr WideForms wideAddition = {Inst::kIdVpaddb, Inst::kIdVpaddw, Inst::kIdVpaddd, Inst::kIdVpaddq};
constexpr WideForms wideSubtraction = {Inst::kIdVpsubb, Inst::kIdVpsubw, Inst::kIdVpsubd, Inst::kIdVpsubq};
constexpr WideForms wideSignedOrder = {Inst::kIdVpcmpb, Inst::kIdVpcmpw, Inst::kIdVpcmpd, Inst::kIdVpcmpq};
constexpr WideForms wideUnsignedOrder = {Inst::kIdVpcmpub, Inst::kIdVpcmpuw, Inst::kIdVpcmpud, Inst::kIdVpcmpuq};
constexpr WideForms wideBitTest = {Inst::kIdVptestmb, Inst::kIdVptestmw, Inst::kIdVptestmd, Inst::kIdVptestmq};
constexpr WideForms wideSigns = {Inst::kIdVpmovb2m, Inst::kIdVpmovw2m, Inst::kIdVpmovd2m, Inst::kIdVpmovq2m};
constexpr WideForms wideBlend = {Inst::kIdVpblendmb, Inst::kIdVpblendmw, Inst::kIdVpblendmd, Inst::kIdVpblendmq};
constexpr std::uint32_t askEqual = 0, askLess = 1, askNotEqual = 4, askGreater = 6;

InstId wideForm(const WideForms& forms, Rep rep) { return forms[static_cast<std::size_t>(rep) - 1]; }
int bitsOfOperand(const Step& s) {
  return s.op == CodeOp::Constant ? std::max(1, static_cast<int>(std::bit_width(s.value))) : widthOf(s);
}
Rep asNumber(Rep rep) { return std::max(rep, Rep::Byte); }
std::uint64_t wholeKey(ValueId id, Rep rep) { return std::uint64_t{id} << 3 | static_cast<std::uint64_t>(rep); }
std::uint64_t sumKey(CodeOp op, ValueId a, ValueId b) {
  return std::uint64_t{a} << 33 | std::uint64_t{b} << 1 | (op == CodeOp::Add ? 1 : 0);
}

}  // namespace

void WideEmitter::value(ValueId id) {
  const Step& s = code_.steps[id];
  if (s.op == CodeOp::False || s.op == CodeOp::True || s.op == CodeOp::Constant) return;
  if (flow_.isPatched[id]) return;
  const bool isKept = flow_.keptAt.contains(id);
  if (repFor(widthOf(s)) == Rep::Truth) {
    if (s.op == CodeOp::LoadBit && !isKept) {
      slotOf_[id] = layout_.slot(s.value);
      readAt_.emplace(layout_.slot(s.value), id);
      return;
    }
    const Gp made = truthOf(s);
    if (made.isValid()) holdTruth(id, made);
  } else if (flow_.isCommon[id]) {
    holdScalar(id, scalarOf(s));
  } else {
    const Number made = numberOf(s);
    CHECK(made.rep == repFor(widthOf(s)), "a value in a form that is not its own");
    if (made.piece[0].isMem() && (s.op == CodeOp::LoadMemory || s.op == CodeOp::LoadRegister))
      readAt_.emplace(static_cast<std::size_t>(made.piece[0].as<Mem>().offset()), id);
    holdNumber(id, made);
    if (s.op == CodeOp::Add || s.op == CodeOp::Sub) sums_[sumKey(s.op, s.a, s.b)] = id;
  }
  if (isKept) keep(id);
}

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
      return joined(Inst::kIdAnd);
    case CodeOp::Or: return joined(Inst::kIdOr);
    case CodeOp::Xor: return joined(Inst::kIdXor);
    case CodeOp::Not: {
      const Gp to = writable(s.a);
      c_.not_(to);
      return to;
    }
    case CodeOp::SelectBit: {  // ((b ^ c) & a) ^ c
      const Gp to = freshGp();
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
      return truthFrom(compared(wideForm(wideUnsignedOrder, wide.rep), wide, constant(1, wide.rep), askEqual),
                       wide.rep);
    }
  }
}

x86::Gp WideEmitter::testBit(const Step& s) {
  const Step& of = code_.steps[s.a];
  if (of.op == CodeOp::Constant || isScalar(s.a)) return scalarTruth(s);
  if (repFor(widthOf(of)) == Rep::Truth) return s.value == 0 ? copied(truth(s.a)) : truth(0);
  const Number a = made(s.a);
  if (static_cast<int>(s.value) >= bitsOf(a.rep)) return truth(0);
  const bool isSign = static_cast<int>(s.value) == bitsOf(a.rep) - 1;
  const Number own = isSign ? a : constant(1ULL << s.value, a.rep);
  Masks masks;
  for (std::size_t i = 0; i < pieceCount(a.rep); ++i) {
    masks[i] = freshMask();
    if (isSign)
      c_.emit(wideForm(wideSigns, a.rep), masks[i], inRegister(a.piece[i]));
    else
      c_.emit(wideForm(wideBitTest, a.rep), masks[i], inRegister(a.piece[i]), own.piece[i]);
  }
  return truthFrom(masks, a.rep);
}

x86::Gp WideEmitter::comparison(const Step& s) {
  if (flow_.isCommon[step_]) return scalarTruth(s);
  int bits = std::max(bitsOfOperand(code_.steps[s.a]), bitsOfOperand(code_.steps[s.b]));
  if (s.op != CodeOp::Equal) bits = std::max(bits, int{s.width});
  const Rep rep = asNumber(repFor(bits));
  Number a = number(s.a, rep), b = number(s.b, rep);
  if (s.op == CodeOp::LessSigned && s.width != bitsOf(rep)) {
    const Number sign = constant(1ULL << (s.width - 1), rep);  // what is negative comes before what is not
    a = each(Inst::kIdVpxorq, a, sign);
    b = each(Inst::kIdVpxorq, b, sign);
  }
  const WideForms& forms = s.op == CodeOp::LessSigned && s.width == bitsOf(rep) ? wideSignedOrder : wideUnsignedOrder;
  const bool isTurned = a.piece[0].isMem() && !b.piece[0].isMem();
  const std::uint32_t how = s.op == CodeOp::Equal ? askEqual : isTurned ? askGreater : askLess;
  const Masks masks = compared(wideForm(forms, rep), isTurned ? b : a, isTurned ? a : b, how);
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
  holdMasks(step_, a.rep, compared(wideForm(wideSignedOrder, a.rep), a, limit, added > 0 ? askGreater : askLess));
  return {};
}

/// A sum of words that is not the one that stops at the ends overflows. Of double words it is one whose sign is none of
/// those of its parts, a difference where both parts differ in sign and it has not that of the first.
x86::Gp WideEmitter::overflow(const Step& s) {
  if (flow_.isCommon[step_]) return scalarTruth(s);
  const bool isSum = s.op == CodeOp::AddOverflows;
  const Rep rep = repFor(s.width);
  const Step &left = code_.steps[s.a], &right = code_.steps[s.b];
  if (right.op == CodeOp::Constant) return overflowByConstant(s, number(s.a, rep), right.value);
  if (isSum && left.op == CodeOp::Constant) return overflowByConstant(s, number(s.b, rep), left.value);
  const Number a = number(s.a, rep), b = number(s.b, rep);
  const auto known = sums_.find(sumKey(isSum ? CodeOp::Add : CodeOp::Sub, s.a, s.b));
  const bool isKnown = known != sums_.end() && numbers_.contains(wholeKey(known->second, rep));
  const Number result =
      isKnown ? number(known->second, rep) : each(wideForm(isSum ? wideAddition : wideSubtraction, rep), a, b);
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

WideEmitter::Number WideEmitter::numberOf(const Step& s) {
  switch (s.op) {
    case CodeOp::LoadStateWord: {
      const Row row = layout_.state(s.value);
      Number value = loaded(row);
      for (std::size_t i = 0; i < pieceCount(row.rep); ++i) value.piece[i] = inRegister(value.piece[i]);
      while (value.rep > repFor(s.width)) value = narrowed(value);
      return value;
    }
    case CodeOp::LoadRegister: return loaded(*layout_.reg(s.value));
    case CodeOp::LoadMemory: return loadMemory(s);
    case CodeOp::LoadSlots: return loadSlots(s);
    case CodeOp::LoadAt: return loadAt(s);
    case CodeOp::Select: return select(s);
    case CodeOp::ShiftLeft:
    case CodeOp::ShiftRight: return shift(s);
    case CodeOp::Extract: return extract(s);
    case CodeOp::Join: return join(s);
    case CodeOp::DivideUnsigned:
    case CodeOp::RemainderUnsigned:
    case CodeOp::DivideSigned:
    case CodeOp::RemainderSigned:
    case CodeOp::RealFunction:
    case CodeOp::RealToInt: return byTrace(s);
    case CodeOp::RealAdd:
    case CodeOp::RealSub:
    case CodeOp::RealMul:
    case CodeOp::RealDiv:
    case CodeOp::RealFromInt: return real(s);
    default: return arithmetic(s);
  }
}

WideEmitter::Number WideEmitter::arithmetic(const Step& s) {
  const Rep rep = asNumber(repFor(s.width));
  const auto both = [&](InstId id, bool isFree) {
    const Number a = number(s.a, rep), b = number(s.b, rep);
    return isFree && a.piece[0].isMem() && !b.piece[0].isMem() ? each(id, b, a) : each(id, a, b);
  };
  switch (s.op) {
    case CodeOp::Add: return cut(both(wideForm(wideAddition, rep), true), s.width);
    case CodeOp::Sub: return cut(both(wideForm(wideSubtraction, rep), false), s.width);
    case CodeOp::Mul:
      if (rep == Rep::Byte)
        return cut(narrowed(each(Inst::kIdVpmullw, number(s.a, Rep::Word), number(s.b, Rep::Word))), s.width);
      return cut(both(rep == Rep::Word     ? Inst::kIdVpmullw
                      : rep == Rep::Double ? Inst::kIdVpmulld
                                           : Inst::kIdVpmullq,
                      true),
                 s.width);
    case CodeOp::BitAnd: return both(Inst::kIdVpandq, true);
    case CodeOp::BitOr: return both(Inst::kIdVporq, true);
    case CodeOp::BitXor: return both(Inst::kIdVpxorq, true);
    case CodeOp::BitNot: return each(Inst::kIdVpxorq, number(s.a, rep), constant(Concrete::mask(s.width), rep));
    case CodeOp::Signed: {
      const Number sign = constant(1ULL << (s.value - 1), rep);
      return cut(each(wideForm(wideSubtraction, rep), each(Inst::kIdVpxorq, number(s.a, rep), sign), sign), s.width);
    }
    default: CHECK(false, "no operation on words");
  }
  return {};
}

WideEmitter::Number WideEmitter::select(const Step& s) {
  const Rep rep = asNumber(repFor(s.width));
  const Number on = number(s.b, rep), off = number(s.c, rep);
  const Masks masks = masksOf(s.a, rep);
  Number to{rep};
  for (std::size_t i = 0; i < pieceCount(rep); ++i) {
    const Zmm chosen = freshZmm(), other = inRegister(off.piece[i]);
    c_.k(masks[i]).emit(wideForm(wideBlend, rep), chosen, other, on.piece[i]);
    to.piece[i] = chosen;
  }
  return to;
}

WideEmitter::Number WideEmitter::shift(const Step& s) {
  const bool isLeft = s.op == CodeOp::ShiftLeft;
  const Rep own = asNumber(repFor(s.width));
  const Step& count = code_.steps[s.b];
  const bool isConstant = count.op == CodeOp::Constant;
  if (isConstant && count.value >= s.width) return constant(0, own);
  const Rep rep = std::max(own, isConstant ? Rep::Word : std::max(Rep::Double, repFor(widthOf(count))));
  Number result{rep};
  if (isConstant) {
    result = shifted(number(s.a, rep), isLeft, static_cast<std::uint32_t>(count.value));
  } else {
    const InstId id = rep == Rep::Quad ? (isLeft ? Inst::kIdVpsllvq : Inst::kIdVpsrlvq)
                                       : (isLeft ? Inst::kIdVpsllvd : Inst::kIdVpsrlvd);
    result = each(id, number(s.a, rep), number(s.b, rep));
  }
  result = cut(result, s.width);
  while (result.rep > own) result = narrowed(result);
  return result;
}

WideEmitter::Number WideEmitter::extract(const Step& s) {
  const Rep own = repFor(s.width), from = repFor(widthOf(code_.steps[s.a]));
  if (static_cast<int>(s.value) >= bitsOf(std::max(from, Rep::Word))) return constant(0, own);
  Number value = number(s.a, std::max(from, s.value == 0 ? own : std::max(own, Rep::Word)));
  if (s.value != 0) value = shifted(value, false, static_cast<std::uint32_t>(s.value));
  while (value.rep > own) value = narrowed(value);
  return cut(value, s.width);
}

WideEmitter::Number WideEmitter::join(const Step& s) {
  const Rep own = repFor(widthOf(s));
  const Rep rep = std::max(own, Rep::Word);
  const Step& above = code_.steps[s.a];
  if (flow_.isPatched[s.a]) {  // the low part of a number anew
    constexpr std::uint32_t firstOrBoth = 0xF8;
    const Number low = number(s.b, rep), whole = number(above.a, rep);
    const Number keeps = constant(Concrete::mask(bitsOf(rep)) & ~Concrete::mask(static_cast<int>(s.value)), rep);
    Number to{rep};
    for (std::size_t i = 0; i < pieceCount(rep); ++i) {
      const Zmm patched = freshZmm();
      c_.emit(Inst::kIdVmovdqa64, patched, low.piece[i]);
      c_.emit(Inst::kIdVpternlogq, patched, inRegister(whole.piece[i]), keeps.piece[i], imm(firstOrBoth));
      to.piece[i] = patched;
    }
    return to;
  }
  const Number high = shifted(number(s.a, rep), true, static_cast<std::uint32_t>(s.value));
  Number both = each(Inst::kIdVporq, high, number(s.b, rep));
  while (both.rep > own) both = narrowed(both);
  return both;
}

x86::Gp WideEmitter::realTruth(const Step& s) {
  constexpr std::uint32_t equalOrdered = 0, lessOrdered = 0x11;
  const Number a = number(s.a, Rep::Double);
  if (s.op == CodeOp::RealLegal) {  // the exponent is not all ones
    const Number exponent = constant(0x7F800000, Rep::Double);
    const Number own = each(Inst::kIdVpandq, a, exponent);
    return truthFrom(compared(Inst::kIdVpcmpd, own, exponent, askNotEqual), Rep::Double);
  }
  const Number b = number(s.b, Rep::Double);
  return truthFrom(compared(Inst::kIdVcmpps, a, b, s.op == CodeOp::RealEqual ? equalOrdered : lessOrdered),
                   Rep::Double);
}

WideEmitter::Number WideEmitter::real(const Step& s) {
  constexpr std::uint32_t unordered = 3;
  const Number a = number(s.a, Rep::Double);
  Number to{Rep::Double};
  if (s.op == CodeOp::RealFromInt) {
    for (std::size_t i = 0; i < pieceCount(Rep::Double); ++i) {
      const Zmm real = freshZmm();
      c_.vcvtdq2ps(real, inRegister(a.piece[i]));
      to.piece[i] = real;
    }
    return to;
  }
  const InstId id = s.op == CodeOp::RealAdd   ? Inst::kIdVaddps
                    : s.op == CodeOp::RealSub ? Inst::kIdVsubps
                    : s.op == CodeOp::RealMul ? Inst::kIdVmulps
                                              : Inst::kIdVdivps;
  const Number result = each(id, a, number(s.b, Rep::Double)), oneNan = constant(0x7FC00000, Rep::Double);
  const Masks isNan = compared(Inst::kIdVcmpps, result, result, unordered);
  for (std::size_t i = 0; i < pieceCount(Rep::Double); ++i) {
    const Zmm chosen = freshZmm(), other = inRegister(result.piece[i]);
    c_.k(isNan[i]).emit(Inst::kIdVpblendmd, chosen, other, oneNan.piece[i]);
    to.piece[i] = chosen;
  }
  return to;
}

WideEmitter::Number WideEmitter::byTrace(const Step& s) {
  const bool isBinary = compiled::operandCount(s.op) == 2;
  const int bits =
      std::max({bitsOfOperand(code_.steps[s.a]), isBinary ? bitsOfOperand(code_.steps[s.b]) : 1, widthOf(s)});
  const Rep rep = asNumber(repFor(bits)), own = asNumber(repFor(widthOf(s)));
  const auto give = [&](std::size_t operand, ValueId id) {
    const Number given = number(id, rep);
    for (std::size_t i = 0; i < pieceCount(rep); ++i)
      c_.vmovdqa64(at(layout_.scratch(operand) + wideBytes * i), inRegister(given.piece[i]));
  };
  beforeCall();
  give(0, s.a);
  if (isBinary) give(1, s.b);
  callByTrace(byTrace_.emplace_back(StepByTrace{s, {}}), rep);
  Number result = loaded({layout_.scratch(2), rep});
  for (std::size_t i = 0; i < pieceCount(rep); ++i) result.piece[i] = inRegister(result.piece[i]);
  while (result.rep > own) result = narrowed(result);
  return result;
}

}  // namespace rungproof::lanes
