// The steps that make numbers.
#include "engine/lanes/vector_forms.hpp"
#include "engine/lanes/wide_emitter.hpp"
#include "ir/check.hpp"

namespace rungproof::lanes {

using namespace asmjit;  // its Operand: by its full name
namespace Inst = x86::Inst;

namespace {
constexpr VectorForms blend = {Inst::kIdVpblendmb, Inst::kIdVpblendmw, Inst::kIdVpblendmd, Inst::kIdVpblendmq};
}  // namespace

void WideEmitter::value(ValueId id) {
  const Step& s = code_.steps[id];
  if (s.op == CodeOp::False || s.op == CodeOp::True || s.op == CodeOp::Constant) return;
  if (flow_.isPatched[id] || flow_.isDeferred[id]) return;
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
    if (s.op == CodeOp::Add || s.op == CodeOp::Sub) sums_[sumOf(s.op, s.a, s.b)] = id;
  }
  if (isKept) keep(id);
}

WideNumber WideEmitter::numberOf(const Step& s) {
  switch (s.op) {
    case CodeOp::LoadStateWord: {
      const Row row = layout_.state(s.value);
      return fit(copyOf(row), std::min(row.rep, repFor(s.width)), bitsOf(row.rep));
    }
    case CodeOp::LoadRegister: return loaded(*layout_.reg(s.value));
    case CodeOp::LoadMemory: return loadMemory(s);
    case CodeOp::LoadSlots: return loadSlots(s);
    case CodeOp::LoadAt: return loadAt(s);
    case CodeOp::Select: return select(s);
    case CodeOp::ShiftLeft:
    case CodeOp::ShiftRight: return shift(s);
    case CodeOp::Extract: return extract(s);
    case CodeOp::Join: return joinOf(s);
    case CodeOp::RealAdd:
    case CodeOp::RealSub:
    case CodeOp::RealMul:
    case CodeOp::RealDiv:
    case CodeOp::RealFromInt: return real(s);
    case CodeOp::Add:
    case CodeOp::Sub:
    case CodeOp::Mul:
    case CodeOp::BitAnd:
    case CodeOp::BitOr:
    case CodeOp::BitXor:
    case CodeOp::BitNot:
    case CodeOp::Signed: return arithmetic(s);
    default: return byTrace(s);
  }
}

WideNumber WideEmitter::arithmetic(const Step& s) {
  const Rep rep = numberFor(s.width);
  const auto both = [&](InstId id, bool isFree) {
    const Number a = use(s.a, rep), b = use(s.b, rep);
    return isFree && a.piece[0].isMem() && !b.piece[0].isMem() ? each(id, b, a) : each(id, a, b);
  };
  switch (s.op) {
    case CodeOp::Add: return cut(both(formOf(forms::addition, rep), true), s.width);
    case CodeOp::Sub: return cut(both(formOf(forms::subtraction, rep), false), s.width);
    case CodeOp::Mul:
      if (rep == Rep::Byte)
        return cut(narrowed(each(Inst::kIdVpmullw, use(s.a, Rep::Word), use(s.b, Rep::Word))), s.width);
      return cut(both(rep == Rep::Word     ? Inst::kIdVpmullw
                      : rep == Rep::Double ? Inst::kIdVpmulld
                                           : Inst::kIdVpmullq,
                      true),
                 s.width);
    case CodeOp::BitAnd: return both(Inst::kIdVpandq, true);
    case CodeOp::BitOr: return both(Inst::kIdVporq, true);
    case CodeOp::BitXor: return both(Inst::kIdVpxorq, true);
    case CodeOp::BitNot: return each(Inst::kIdVpxorq, use(s.a, rep), constant(Concrete::mask(s.width), rep));
    default: {  // CodeOp::Signed
      const Number sign = constant(1ULL << (s.value - 1), rep);
      return cut(each(formOf(forms::subtraction, rep), each(Inst::kIdVpxorq, use(s.a, rep), sign), sign), s.width);
    }
  }
}

/// A sum where it does not overflow.
WideNumber WideEmitter::sumUnlessOverflow(const Step& s, const Step& sum) {
  const Rep rep = numberFor(s.width);
  const Number other = use(s.b, rep), a = use(sum.a, rep), b = use(sum.b, rep);
  const Masks fits = masksOf(s.a, rep);
  Number to{rep};
  for (std::size_t i = 0; i < pieceCount(rep); ++i) {
    const Zmm result = freshZmm(), first = inRegister(a.piece[i]);
    c_.emit(Inst::kIdVmovdqa64, result, source(other.piece[i]));
    c_.k(fits[i]).emit(formOf(sum.op == CodeOp::Add ? forms::addition : forms::subtraction, rep), result, first,
                       source(b.piece[i]));
    to.piece[i] = result;
  }
  return to;
}

WideNumber WideEmitter::select(const Step& s) {
  if (const auto sum = flow_.sumAt.find(step_); sum != flow_.sumAt.end())
    return sumUnlessOverflow(s, code_.steps[sum->second]);
  const Rep rep = numberFor(s.width);
  const Number on = use(s.b, rep), off = use(s.c, rep);
  const Masks masks = masksOf(s.a, rep);
  Number to{rep};
  for (std::size_t i = 0; i < pieceCount(rep); ++i) {
    const Zmm chosen = freshZmm(), other = inRegister(off.piece[i]);
    c_.k(masks[i]).emit(formOf(blend, rep), chosen, other, source(on.piece[i]));
    to.piece[i] = chosen;
  }
  return to;
}

WideNumber WideEmitter::joinOf(const Step& s) {
  const Rep own = repFor(widthOf(s));
  const Rep rep = std::max(own, Rep::Word);
  const Step& above = code_.steps[s.a];
  if (flow_.isPatched[s.a]) {  // the low part of a number anew
    constexpr std::uint32_t firstOrBoth = 0xF8;
    const Number low = use(s.b, rep), whole = use(above.a, rep);
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
  const Number high = shifted(use(s.a, rep), true, static_cast<std::uint32_t>(s.value));
  Number both = each(Inst::kIdVporq, high, use(s.b, rep));
  return fit(both, own, bitsOf(own));
}

WideNumber WideEmitter::real(const Step& s) {
  constexpr std::uint32_t unordered = 3;
  const Number a = use(s.a, Rep::Double);
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
  const Number result = each(id, a, use(s.b, Rep::Double)), oneNan = constant(0x7FC00000, Rep::Double);
  const Masks isNan = compared(Inst::kIdVcmpps, result, result, unordered);
  for (std::size_t i = 0; i < pieceCount(Rep::Double); ++i) {
    const Zmm chosen = freshZmm(), other = inRegister(result.piece[i]);
    c_.k(isNan[i]).emit(Inst::kIdVpblendmd, chosen, other, oneNan.piece[i]);
    to.piece[i] = chosen;
  }
  return to;
}

}  // namespace rungproof::lanes
