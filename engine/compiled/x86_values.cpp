// Values as machine instructions. A truth value is a register of which the low 8 bits count, all of them equal; a word
// is a register of 64 bits whose bits above its width are 0.
#include <cstddef>

#include "engine/compiled/x86_emitter.hpp"
#include "engine/concrete.hpp"
#include "ir/check.hpp"

namespace rungproof::compiled {

using namespace asmjit;  // its Operand: by its full name

namespace {

class Silent final : public Outside {
 public:
  std::uint64_t external(const ExternalSite&, int) override { return 0; }
  void report(Hazard, const Instruction*) override {}
};
const Concrete& plainNumbers() {
  static Silent outside;
  static const Concrete domain(outside);
  return domain;
}
[[gnu::sysv_abi]] std::uint64_t realFunction(std::uint64_t a, std::uint64_t which) {
  return plainNumbers().rfunction(which, a);
}
[[gnu::sysv_abi]] std::uint64_t realToInt(std::uint64_t a, std::uint64_t round) {
  return plainNumbers().rtoInt(a, round != 0);
}
[[gnu::sysv_abi]] std::uint64_t divided(std::uint64_t a, std::uint64_t b, std::uint64_t w, std::uint64_t op) {
  const int width = static_cast<int>(w);
  switch (static_cast<CodeOp>(op)) {
    case CodeOp::DivideUnsigned: return plainNumbers().udiv(a, b, width);
    case CodeOp::RemainderUnsigned: return plainNumbers().urem(a, b, width);
    case CodeOp::DivideSigned: return plainNumbers().sdiv(a, b, width);
    default: return plainNumbers().srem(a, b, width);
  }
}

}  // namespace

std::optional<std::int32_t> X86Emitter::immediate(ValueId id) const {
  const Step& s = code_.steps[id];
  if (s.op != CodeOp::Constant || s.value > 0x7FFFFFFF) return std::nullopt;
  return static_cast<std::int32_t>(s.value);
}

void X86Emitter::keepWidth(Gp reg, int width) {
  if (width == 8)
    a_.movzx(reg.r32(), reg.r8());
  else if (width == 16)
    a_.movzx(reg.r32(), reg.r16());
  else if (width == 32)
    a_.mov(reg.r32(), reg.r32());
  else if (width < 32)
    a_.and_(reg.r32(), static_cast<std::uint32_t>(Concrete::mask(width)));
  else if (width < 64) {
    a_.shl(reg, 64 - width);
    a_.shr(reg, 64 - width);
  }
}

void X86Emitter::value(ValueId id) {
  const Step& s = code_.steps[id];
  switch (s.op) {
    case CodeOp::False:
    case CodeOp::True:
    case CodeOp::Constant: return;  // made where they are used
    case CodeOp::And:
    case CodeOp::Or:
    case CodeOp::Xor:
    case CodeOp::Not:
    case CodeOp::SelectBit:
    case CodeOp::TestBit:
    case CodeOp::Equal:
    case CodeOp::Less:
    case CodeOp::LessSigned:
    case CodeOp::AddOverflows:
    case CodeOp::SubOverflows: return truth(id, s);
    case CodeOp::LoadBit:
    case CodeOp::LoadState:
    case CodeOp::LoadMemory:
    case CodeOp::LoadSlots:
    case CodeOp::LoadRegister:
    case CodeOp::LoadTicks:
    case CodeOp::LoadAt:
    case CodeOp::LoadStateWord: return load(id, s);
    case CodeOp::DivideUnsigned:
    case CodeOp::RemainderUnsigned:
    case CodeOp::DivideSigned:
    case CodeOp::RemainderSigned: return call(id, s);
    case CodeOp::ShiftLeft:
    case CodeOp::ShiftRight: return shift(id, s);
    case CodeOp::RealEqual:
    case CodeOp::RealLess:
    case CodeOp::RealLegal:
    case CodeOp::RealAdd:
    case CodeOp::RealSub:
    case CodeOp::RealMul:
    case CodeOp::RealDiv:
    case CodeOp::RealFromInt: return real(id, s);
    case CodeOp::RealFunction:
    case CodeOp::RealToInt: return call(id, s);
    case CodeOp::Select: return select(id, s);
    default: return arithmetic(id, s);
  }
}

void X86Emitter::load(ValueId id, const Step& s) {
  switch (s.op) {
    case CodeOp::LoadBit:
    case CodeOp::LoadState: {
      const std::int32_t place = s.op == CodeOp::LoadBit ? slotAt(s.value) : stateAt(s.value);
      values_.stands(id, place, standsTo_[id]);
      if (standsTo_[id] >= values_.lastUse(id)) return;  // an operand of those that use it
      const Gp reg = values_.fresh();
      a_.movzx(reg.r32(), at(static_cast<std::size_t>(place), 1));
      return values_.define(id, reg);
    }
    case CodeOp::LoadStateWord: {
      const std::int32_t place = stateAt(s.value);
      values_.stands(id, place, standsTo_[id]);
      if (standsTo_[id] >= values_.lastUse(id)) return;
      const Gp reg = values_.fresh();
      a_.mov(reg, at(static_cast<std::size_t>(place)));
      return values_.define(id, reg);
    }
    case CodeOp::LoadTicks: return values_.stands(id, offsetof(Workspace, ticks100), ~ValueId{0});
    case CodeOp::LoadSlots: {
      const Gp reg = values_.fresh();
      a_.movq(x86::xmm0, at(static_cast<std::size_t>(slotAt(s.value))));
      a_.pmovmskb(reg.r32(), x86::xmm0);
      return values_.define(id, reg);
    }
    case CodeOp::LoadRegister: {
      const Gp reg = values_.fresh();
      a_.mov(reg.r32(), registerAt(s.value));
      return values_.define(id, reg);
    }
    default: return loadMemory(id, s);
  }
}

/// The highest byte first.
void X86Emitter::loadMemory(ValueId id, const Step& s) {
  const std::uint32_t size = s.width / 8U;
  const Mem from =
      s.op == CodeOp::LoadAt ? baseOf(s.area).at(values_.use(s.a), 0, s.value, size) : memory(s.area, s.value, size);
  const Gp reg = values_.fresh();
  if (size == 1) {
    a_.movzx(reg.r32(), from);
  } else if (size == 2) {
    a_.movzx(reg.r32(), from);
    a_.rol(reg.r16(), 8);
  } else if (hasMovbe_) {
    a_.movbe(reg.r32(), from);
  } else {
    a_.mov(reg.r32(), from);
    a_.bswap(reg.r32());
  }
  values_.define(id, reg);
}

void X86Emitter::compared(ValueId id, Cond holds) {
  const Gp reg = values_.fresh();
  a_.set(holds, reg.r8());
  a_.neg(reg.r8());
  truthMade(id);
  values_.define(id, reg);
}

void X86Emitter::truth(ValueId id, const Step& s) {
  if (isComparison(s.op)) {
    if (s.op == CodeOp::TestBit && s.value == 0 && code_.steps[s.a].width == 1) {
      const Gp reg = values_.take(s.a);
      a_.neg(reg.r32());
      return values_.define(id, reg);
    }
    return compared(id, comparison(s));
  }
  if (s.op == CodeOp::Not) {
    if (emittedAt_[s.a] > s.a) return compared(id, x86::negateCond(comparison(code_.steps[s.a])));
    const Gp reg = values_.take(s.a);
    a_.not_(reg.r32());
    return values_.define(id, reg);
  }
  if (s.op == CodeOp::SelectBit) {  // c ^ ((b ^ c) & a)
    const Gp reg = values_.take(s.b), other = values_.use(s.c);
    a_.xor_(reg.r32(), other.r32());
    a_.emit(x86::Inst::kIdAnd, reg.r8(), values_.byteOperand(s.a));
    a_.xor_(reg.r8(), other.r8());
    truthMade(id);
    return values_.define(id, reg);
  }
  const InstId op = s.op == CodeOp::And ? x86::Inst::kIdAnd : s.op == CodeOp::Or ? x86::Inst::kIdOr : x86::Inst::kIdXor;
  // The operand that ends here makes room for the result; one in memory stays there.
  const auto ends = [&](ValueId v) { return values_.isInRegister(v) && values_.lastUse(v) <= position_; };
  const bool fromFirst = ends(s.a) || (!ends(s.b) && values_.isInRegister(s.a));
  const ValueId kept = fromFirst ? s.a : s.b, joined = fromFirst ? s.b : s.a;
  const Gp reg = values_.take(kept);
  a_.emit(op, reg.r8(), values_.byteOperand(joined));
  truthMade(id);
  values_.define(id, reg);
}

void X86Emitter::arithmetic(ValueId id, const Step& s) {
  const bool isSum = s.op == CodeOp::Add || s.op == CodeOp::Sub;
  if (isSum && (s.width == 16 || s.width == 32)) return sum(id, s);
  const auto both = [&](InstId op) {
    const Gp reg = values_.take(s.a);
    if (const auto constant = immediate(s.b))
      a_.emit(op, reg, *constant);
    else
      a_.emit(op, reg, values_.use(s.b));
    return reg;
  };
  Gp reg;
  switch (s.op) {
    case CodeOp::FromBit:
      reg = values_.take(s.a);
      a_.and_(reg.r32(), 1);
      break;
    case CodeOp::Add: keepWidth(reg = both(x86::Inst::kIdAdd), s.width); break;
    case CodeOp::Sub: keepWidth(reg = both(x86::Inst::kIdSub), s.width); break;
    case CodeOp::Mul:
      reg = values_.take(s.a);
      a_.imul(reg, values_.use(s.b));
      keepWidth(reg, s.width);
      break;
    case CodeOp::BitAnd: reg = both(x86::Inst::kIdAnd); break;
    case CodeOp::BitOr:
      if (emittedAt_[s.a] > s.a) return replaceBit(id, s);
      reg = both(x86::Inst::kIdOr);
      break;
    case CodeOp::BitXor: reg = both(x86::Inst::kIdXor); break;
    case CodeOp::BitNot:
      reg = values_.take(s.a);
      a_.not_(reg);
      keepWidth(reg, s.width);
      break;
    case CodeOp::Signed:
      reg = values_.take(s.a);
      if (s.value == 8)
        a_.movsx(reg, reg.r8());
      else if (s.value == 16)
        a_.movsx(reg, reg.r16());
      else if (s.value == 32)
        a_.movsxd(reg, reg.r32());
      else {
        a_.shl(reg, 64 - static_cast<int>(s.value));
        a_.sar(reg, 64 - static_cast<int>(s.value));
      }
      keepWidth(reg, s.width);
      break;
    case CodeOp::Extract:
      reg = values_.take(s.a);
      if (s.value != 0) a_.shr(reg, s.value);
      keepWidth(reg, s.width);
      break;
    case CodeOp::Join:
      reg = values_.take(s.a);
      a_.shl(reg, s.value);
      a_.or_(reg, values_.use(s.b));
      break;
    default: CHECK(false, "no operation on words");
  }
  values_.define(id, reg);
}

/// The bits of the mask come from `rest`, the other one from the truth value, all bits of which are equal.
void X86Emitter::replaceBit(ValueId id, const Step& s) {
  const Step &rest = code_.steps[s.a], &shifted = code_.steps[s.b];
  const ValueId own = shifted.op == CodeOp::ShiftLeft ? shifted.a : s.b;
  const Gp reg = values_.take(rest.a), truth = values_.use(code_.steps[own].a);
  a_.xor_(reg.r8(), truth.r8());
  a_.and_(reg.r8(), static_cast<std::int8_t>(code_.steps[rest.b].value));
  a_.xor_(reg.r8(), truth.r8());
  values_.define(id, reg);
}

void X86Emitter::select(ValueId id, const Step& s) {
  const Gp reg = values_.take(s.c), chosen = values_.use(s.b);  // before the flags are set
  a_.cmov(condition(s.a), reg, chosen);
  values_.define(id, reg);
}

/// What is worth no instructions of its own: division, where the divisor 0 gives what the domain says, and functions of
/// REAL numbers.
void X86Emitter::call(ValueId id, const Step& s) {
  std::uintptr_t function = 0;
  if (s.op == CodeOp::RealFunction || s.op == CodeOp::RealToInt) {
    values_.prepareCall({s.a});
    a_.mov(x86::rsi, s.value);
    function = reinterpret_cast<std::uintptr_t>(s.op == CodeOp::RealFunction ? &realFunction : &realToInt);
  } else {
    values_.prepareCall({s.a, s.b});
    a_.mov(x86::edx, s.width);
    a_.mov(x86::ecx, static_cast<std::uint32_t>(s.op));
    function = reinterpret_cast<std::uintptr_t>(&divided);
  }
  a_.mov(x86::rax, imm(function));
  a_.call(x86::rax);
  values_.define(id, x86::rax);
}

void X86Emitter::shift(ValueId id, const Step& s) {
  const bool isLeft = s.op == CodeOp::ShiftLeft;
  const Gp reg = values_.take(s.a);
  if (const auto constant = immediate(s.b); constant && *constant < s.width) {
    isLeft ? a_.shl(reg, *constant) : a_.shr(reg, *constant);
    if (isLeft) keepWidth(reg, s.width);
    return values_.define(id, reg);
  }
  const Gp count = values_.take(s.b), zero = values_.fresh();
  a_.mov(zero, 0);
  a_.cmp(count, s.width);
  a_.cmovae(reg, zero);
  a_.cmovae(count, zero);
  isLeft ? a_.shlx(reg, reg, count) : a_.shrx(reg, reg, count);
  if (isLeft) keepWidth(reg, s.width);
  values_.define(id, reg);
}

void X86Emitter::real(ValueId id, const Step& s) {
  const x86::Xmm x = x86::xmm0, y = x86::xmm1;
  const Gp reg = values_.fresh();
  if (s.op == CodeOp::RealLegal) {  // the exponent is not all ones
    const Gp pattern = values_.take(s.a);
    a_.and_(pattern.r32(), 0x7F800000);
    a_.cmp(pattern.r32(), 0x7F800000);
    a_.setne(reg.r8());
    a_.neg(reg.r8());
    return values_.define(id, reg);
  }
  if (s.op == CodeOp::RealFromInt) {
    a_.xorps(x, x);
    a_.cvtsi2ss(x, values_.use(s.a).r32());
    a_.movd(reg.r32(), x);
    return values_.define(id, reg);
  }
  a_.movd(x, values_.use(s.a).r32());
  a_.movd(y, values_.use(s.b).r32());
  if (s.op == CodeOp::RealLess) {  // b above a; unordered is not above
    a_.ucomiss(y, x);
    a_.seta(reg.r8());
    a_.neg(reg.r8());
    return values_.define(id, reg);
  }
  if (s.op == CodeOp::RealEqual) {
    const Gp ordered = values_.fresh();
    a_.ucomiss(x, y);
    a_.setnp(ordered.r8());
    a_.sete(reg.r8());
    a_.and_(reg.r8(), ordered.r8());
    a_.neg(reg.r8());
    return values_.define(id, reg);
  }
  const InstId op = s.op == CodeOp::RealAdd   ? x86::Inst::kIdAddss
                    : s.op == CodeOp::RealSub ? x86::Inst::kIdSubss
                    : s.op == CodeOp::RealMul ? x86::Inst::kIdMulss
                                              : x86::Inst::kIdDivss;
  a_.emit(op, x, y);
  const Gp oneNan = values_.fresh();
  a_.mov(oneNan.r32(), 0x7FC00000);
  a_.movd(reg.r32(), x);
  a_.ucomiss(x, x);
  a_.cmovp(reg.r32(), oneNan.r32());
  values_.define(id, reg);
}

}  // namespace rungproof::compiled
