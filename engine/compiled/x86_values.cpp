// Values as machine instructions. A truth value is a register of which the low 8 bits count, all of them equal; a word
// is a register of 64 bits whose bits above its width are 0.
#include <cstddef>

#include "engine/compiled/x86_emitter.hpp"
#include "engine/concrete.hpp"
#include "ir/check.hpp"

namespace rungproof::compiled {

using namespace asmjit;  // its Operand: by its full name

namespace {

/// Steps after which a stored truth value is read from its slot instead of being kept in a register.
constexpr ValueId keptFor = 24;

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
std::uint64_t realFunction(std::uint64_t which, std::uint64_t a) { return plainNumbers().rfunction(which, a); }
std::uint64_t realToInt(std::uint64_t round, std::uint64_t a) { return plainNumbers().rtoInt(a, round != 0); }
std::uint64_t divideWide(std::uint64_t op, std::uint64_t a, std::uint64_t b, std::uint64_t w) {
  const int width = static_cast<int>(w);
  switch (static_cast<CodeOp>(op)) {
    case CodeOp::DivideUnsigned: return plainNumbers().udiv(a, b, width);
    case CodeOp::RemainderUnsigned: return plainNumbers().urem(a, b, width);
    case CodeOp::DivideSigned: return plainNumbers().sdiv(a, b, width);
    default: return plainNumbers().srem(a, b, width);
  }
}

}  // namespace

bool X86Emitter::isComparison(ValueId id) const {
  const CodeOp op = code_.steps[id].op;
  return op == CodeOp::Equal || op == CodeOp::Less || op == CodeOp::LessSigned || op == CodeOp::TestBit;
}

std::optional<std::int32_t> X86Emitter::immediate(ValueId id) const {
  const Step& s = code_.steps[id];
  if (s.op != CodeOp::Constant || s.value > 0x7FFFFFFF) return std::nullopt;
  return static_cast<std::int32_t>(s.value);
}

std::optional<std::uint64_t> X86Emitter::slotHolding(ValueId id) const {
  if (isInMemory_[id]) return code_.steps[id].value;
  const auto home = homes_.find(id);
  if (home == homes_.end() || position_ > home->second.until || position_ - touched_[id] <= keptFor)
    return std::nullopt;
  return home->second.slot;
}

X86Emitter::Gp X86Emitter::use(ValueId id) {
  const Step& s = code_.steps[id];
  if (s.op <= CodeOp::True || s.op == CodeOp::Constant) {
    const Gp reg = fresh();
    const std::uint64_t constant = s.op == CodeOp::Constant ? s.value : s.op == CodeOp::True ? 0xFF : 0;
    if (constant == 0)
      cc_.xor_(reg.r32(), reg.r32());
    else
      cc_.mov(reg, constant);
    return reg;
  }
  --uses_[id];
  if (const auto held = slotHolding(id)) {
    const Gp reg = fresh();
    cc_.movzx(reg.r32(), slot(*held));
    return reg;
  }
  touched_[id] = position_;
  return regs_[id];
}

X86Emitter::Gp X86Emitter::take(ValueId id) {
  const Step& s = code_.steps[id];
  const bool isOwn = s.op > CodeOp::True && s.op != CodeOp::Constant && uses_[id] > 1 && !slotHolding(id);
  const Gp reg = use(id);
  if (!isOwn) return reg;  // its last use, or a register that was made for this one
  const Gp copy = fresh();
  if (isTruth(s.op))
    cc_.mov(copy.r32(), reg.r32());
  else
    cc_.mov(copy, reg);
  return copy;
}

asmjit::Operand X86Emitter::byteOperand(ValueId id) {
  if (const auto held = slotHolding(id)) {
    --uses_[id];
    return slot(*held);
  }
  return use(id).r8();
}

void X86Emitter::keepWidth(Gp reg, int width) {
  if (width == 8)
    cc_.movzx(reg.r32(), reg.r8());
  else if (width == 16)
    cc_.movzx(reg.r32(), reg.r16());
  else if (width == 32)
    cc_.mov(reg.r32(), reg.r32());
  else if (width < 32)
    cc_.and_(reg.r32(), static_cast<std::uint32_t>(Concrete::mask(width)));
  else if (width < 64) {
    cc_.shl(reg, 64 - width);
    cc_.shr(reg, 64 - width);
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
    case CodeOp::LessSigned: return truth(id, s);
    case CodeOp::LoadBit:
    case CodeOp::LoadState:
    case CodeOp::LoadMemory:
    case CodeOp::LoadSlots:
    case CodeOp::LoadRegister:
    case CodeOp::LoadTicks:
    case CodeOp::LoadAt: return load(id, s);
    case CodeOp::DivideUnsigned:
    case CodeOp::RemainderUnsigned:
    case CodeOp::DivideSigned:
    case CodeOp::RemainderSigned: return division(id, s);
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
    case CodeOp::RealToInt: return callReal(id, s);
    default: return arithmetic(id, s);
  }
}

void X86Emitter::load(ValueId id, const Step& s) {
  const Gp reg = fresh();
  switch (s.op) {
    case CodeOp::LoadBit: cc_.movzx(reg.r32(), slot(s.value)); break;
    case CodeOp::LoadState: {
      const auto [place, isNew] = states_.try_emplace(s.value);
      if (isNew) place->second = fresh();
      cc_.mov(reg.r32(), place->second.r32());
      break;
    }
    case CodeOp::LoadSlots: {
      const x86::Xmm bits = cc_.newXmm();
      cc_.movq(bits, slot(s.value, 8));
      cc_.pmovmskb(reg.r32(), bits);
      break;
    }
    case CodeOp::LoadRegister: cc_.mov(reg.r32(), registerAt(s.value)); break;
    case CodeOp::LoadTicks: cc_.mov(reg, field(offsetof(Workspace, ticks100))); break;
    default: {
      const std::uint32_t size = s.width / 8U;
      const Mem from =
          s.op == CodeOp::LoadAt ? x86::ptr(baseOf(s.area), use(s.a), 0, 0, size) : memory(s.area, s.value, size);
      if (size == 1) {
        cc_.movzx(reg.r32(), from);
      } else if (size == 2) {
        cc_.movzx(reg.r32(), from);
        cc_.rol(reg.r16(), 8);
      } else if (hasMovbe_) {
        cc_.movbe(reg.r32(), from);
      } else {
        cc_.mov(reg.r32(), from);
        cc_.bswap(reg.r32());
      }
    }
  }
  define(id, reg);
}

X86Emitter::Cond X86Emitter::comparison(const Step& s) {
  if (s.op == CodeOp::TestBit) {
    const Gp a = use(s.a);
    if (s.value < 31)
      cc_.test(a.r32(), 1U << s.value);
    else {
      cc_.bt(a, s.value);
      return Cond::kC;
    }
    return Cond::kNZ;
  }
  const bool isSigned = s.op == CodeOp::LessSigned;
  const int shift = isSigned && s.width < 32 ? 32 - s.width : isSigned && s.width > 32 ? 64 - s.width : 0;
  const auto constant = immediate(s.b);
  if (shift == 0) {
    const Gp a = use(s.a);
    if (constant)
      s.width <= 32 ? cc_.cmp(a.r32(), *constant) : cc_.cmp(a, *constant);
    else
      s.width <= 32 ? cc_.cmp(a.r32(), use(s.b).r32()) : cc_.cmp(a, use(s.b));
  } else {
    // Both signs at the top.
    const Gp a = take(s.a);
    s.width < 32 ? cc_.shl(a.r32(), shift) : cc_.shl(a, shift);
    if (constant && s.width < 32) {
      cc_.cmp(a.r32(), static_cast<std::int32_t>(static_cast<std::uint32_t>(*constant) << shift));
    } else {
      const Gp b = take(s.b);
      s.width < 32 ? cc_.shl(b.r32(), shift) : cc_.shl(b, shift);
      s.width < 32 ? cc_.cmp(a.r32(), b.r32()) : cc_.cmp(a, b);
    }
  }
  return s.op == CodeOp::Equal ? Cond::kE : s.op == CodeOp::Less ? Cond::kB : Cond::kL;
}

X86Emitter::Cond X86Emitter::condition(ValueId id) {
  if (isDeferred_[id]) {
    --uses_[id];
    return comparison(code_.steps[id]);
  }
  if (const auto held = slotHolding(id)) {
    --uses_[id];
    cc_.cmp(slot(*held), 0);
    return Cond::kNZ;
  }
  const Gp reg = use(id);
  cc_.test(reg.r8(), reg.r8());
  return Cond::kNZ;
}

void X86Emitter::truth(ValueId id, const Step& s) {
  if (isComparison(id)) {
    if (s.op == CodeOp::TestBit && s.value == 0 && code_.steps[s.a].width == 1) {
      const Gp reg = take(s.a);
      cc_.neg(reg.r32());
      return define(id, reg);
    }
    const Cond holds = comparison(s);
    const Gp reg = fresh();
    cc_.set(holds, reg.r8());
    cc_.neg(reg.r8());
    return define(id, reg);
  }
  if (s.op == CodeOp::Not) {
    const Gp reg = take(s.a);
    cc_.not_(reg.r32());
    return define(id, reg);
  }
  if (s.op == CodeOp::SelectBit) {  // c ^ ((b ^ c) & a)
    const Gp reg = take(s.b), other = use(s.c);
    cc_.xor_(reg.r32(), other.r32());
    cc_.emit(x86::Inst::kIdAnd, reg.r8(), byteOperand(s.a));
    cc_.xor_(reg.r32(), other.r32());
    return define(id, reg);
  }
  const InstId op = s.op == CodeOp::And ? x86::Inst::kIdAnd : s.op == CodeOp::Or ? x86::Inst::kIdOr : x86::Inst::kIdXor;
  const bool fromFirst = slotHolding(s.b).has_value() || (uses_[s.a] == 1 && !slotHolding(s.a)) || uses_[s.b] > 1;
  const ValueId kept = fromFirst ? s.a : s.b, joined = fromFirst ? s.b : s.a;
  const Gp reg = take(kept);
  cc_.emit(op, reg.r8(), byteOperand(joined));
  define(id, reg);
}

void X86Emitter::arithmetic(ValueId id, const Step& s) {
  const auto both = [&](InstId op) {
    const Gp reg = take(s.a);
    if (const auto constant = immediate(s.b))
      cc_.emit(op, reg, *constant);
    else
      cc_.emit(op, reg, use(s.b));
    return reg;
  };
  Gp reg;
  switch (s.op) {
    case CodeOp::FromBit:
      reg = take(s.a);
      cc_.and_(reg.r32(), 1);
      break;
    case CodeOp::Add: keepWidth(reg = both(x86::Inst::kIdAdd), s.width); break;
    case CodeOp::Sub: keepWidth(reg = both(x86::Inst::kIdSub), s.width); break;
    case CodeOp::Mul:
      reg = take(s.a);
      cc_.imul(reg, use(s.b));
      keepWidth(reg, s.width);
      break;
    case CodeOp::BitAnd: reg = both(x86::Inst::kIdAnd); break;
    case CodeOp::BitOr: reg = both(x86::Inst::kIdOr); break;
    case CodeOp::BitXor: reg = both(x86::Inst::kIdXor); break;
    case CodeOp::BitNot:
      reg = take(s.a);
      cc_.not_(reg);
      keepWidth(reg, s.width);
      break;
    case CodeOp::Select: {
      reg = take(s.c);
      const Gp chosen = use(s.b);  // before the flags are set
      cc_.cmov(condition(s.a), reg, chosen);
      break;
    }
    case CodeOp::Signed:
      reg = take(s.a);
      if (s.value == 8)
        cc_.movsx(reg, reg.r8());
      else if (s.value == 16)
        cc_.movsx(reg, reg.r16());
      else if (s.value == 32)
        cc_.movsxd(reg, reg.r32());
      else {
        cc_.shl(reg, 64 - static_cast<int>(s.value));
        cc_.sar(reg, 64 - static_cast<int>(s.value));
      }
      keepWidth(reg, s.width);
      break;
    case CodeOp::Extract:
      reg = take(s.a);
      if (s.value != 0) cc_.shr(reg, s.value);
      keepWidth(reg, s.width);
      break;
    case CodeOp::Join:
      reg = take(s.a);
      cc_.shl(reg, s.value);
      cc_.or_(reg, use(s.b));
      break;
    default: CHECK(false, "no operation on words");
  }
  define(id, reg);
}

/// As the domain says: the divisor 0 gives all ones, signed -x or the dividend.
void X86Emitter::division(ValueId id, const Step& s) {
  const Gp a = use(s.a), b = use(s.b), op = fresh(), w = fresh(), result = fresh();
  cc_.mov(op.r32(), static_cast<std::uint32_t>(s.op));
  cc_.mov(w.r32(), static_cast<std::uint32_t>(s.width));
  InvokeNode* call = nullptr;
  cc_.invoke(&call, imm(reinterpret_cast<std::uintptr_t>(&divideWide)),
             FuncSignatureT<std::uint64_t, std::uint64_t, std::uint64_t, std::uint64_t, std::uint64_t>());
  call->setArg(0, op);
  call->setArg(1, a);
  call->setArg(2, b);
  call->setArg(3, w);
  call->setRet(0, result);
  define(id, result);
}

void X86Emitter::shift(ValueId id, const Step& s) {
  const bool isLeft = s.op == CodeOp::ShiftLeft;
  const Gp reg = take(s.a);
  if (const auto constant = immediate(s.b); constant && *constant < s.width) {
    isLeft ? cc_.shl(reg, *constant) : cc_.shr(reg, *constant);
    if (isLeft) keepWidth(reg, s.width);
    return define(id, reg);
  }
  const Gp count = take(s.b), zero = fresh();
  cc_.xor_(zero.r32(), zero.r32());
  cc_.cmp(count, s.width);
  cc_.cmovae(reg, zero);
  cc_.cmovae(count, zero);
  isLeft ? cc_.shl(reg, count.r8()) : cc_.shr(reg, count.r8());
  if (isLeft) keepWidth(reg, s.width);
  define(id, reg);
}

void X86Emitter::real(ValueId id, const Step& s) {
  const x86::Xmm x = cc_.newXmm(), y = cc_.newXmm();
  const Gp reg = fresh();
  if (s.op == CodeOp::RealLegal) {  // the exponent is not all ones
    const Gp pattern = take(s.a);
    cc_.and_(pattern.r32(), 0x7F800000);
    cc_.cmp(pattern.r32(), 0x7F800000);
    cc_.setne(reg.r8());
    cc_.neg(reg.r8());
    return define(id, reg);
  }
  if (s.op == CodeOp::RealFromInt) {
    cc_.xorps(x, x);
    cc_.cvtsi2ss(x, use(s.a).r32());
    cc_.movd(reg.r32(), x);
    return define(id, reg);
  }
  cc_.movd(x, use(s.a).r32());
  cc_.movd(y, use(s.b).r32());
  if (s.op == CodeOp::RealLess) {  // b above a; unordered is not above
    cc_.ucomiss(y, x);
    cc_.seta(reg.r8());
    cc_.neg(reg.r8());
    return define(id, reg);
  }
  if (s.op == CodeOp::RealEqual) {
    const Gp ordered = fresh();
    cc_.ucomiss(x, y);
    cc_.setnp(ordered.r8());
    cc_.sete(reg.r8());
    cc_.and_(reg.r8(), ordered.r8());
    cc_.neg(reg.r8());
    return define(id, reg);
  }
  const InstId op = s.op == CodeOp::RealAdd   ? x86::Inst::kIdAddss
                    : s.op == CodeOp::RealSub ? x86::Inst::kIdSubss
                    : s.op == CodeOp::RealMul ? x86::Inst::kIdMulss
                                              : x86::Inst::kIdDivss;
  cc_.emit(op, x, y);
  const Gp oneNan = fresh();
  cc_.mov(oneNan.r32(), 0x7FC00000);
  cc_.movd(reg.r32(), x);
  cc_.ucomiss(x, x);
  cc_.cmovp(reg.r32(), oneNan.r32());
  define(id, reg);
}

void X86Emitter::callReal(ValueId id, const Step& s) {
  const Gp which = fresh(), a = use(s.a), result = fresh();
  cc_.mov(which.r32(), static_cast<std::uint32_t>(s.value));
  const auto function = s.op == CodeOp::RealFunction ? &realFunction : &realToInt;
  InvokeNode* call = nullptr;
  cc_.invoke(&call, imm(reinterpret_cast<std::uintptr_t>(function)),
             FuncSignatureT<std::uint64_t, std::uint64_t, std::uint64_t>());
  call->setArg(0, which);
  call->setArg(1, a);
  call->setRet(0, result);
  define(id, result);
}

}  // namespace rungproof::compiled
