// What the processor's flags say: comparisons made where their result is wanted, sums that overflow, and the last truth
// value that was made.
#include <cstddef>

#include "engine/compiled/x86_emitter.hpp"

namespace rungproof::compiled {

using namespace asmjit;  // its Operand: by its full name

namespace {

/// How far away a comparison may be made from where it is written.
constexpr ValueId nearBy = 8;

}  // namespace

/// A comparison of which the only user wants the processor's flags is made there; a sum and whether it overflows are
/// made together.
std::vector<ValueId> X86Emitter::emittedAt() {
  const std::size_t count = code_.steps.size();
  std::vector<ValueId> at(count), uses(count, 0);
  for (ValueId i = 0; i < count; ++i) {
    at[i] = i;
    const Step& s = code_.steps[i];
    const int operands = isNeeded_[i] ? operandCount(s.op) : 0;
    if (operands > 0) ++uses[s.a];
    if (operands > 1) ++uses[s.b];
    if (operands > 2) ++uses[s.c];
  }
  findSums(uses);
  findLowUses();
  findReplacedBits(uses, at);
  ValueId mark = 0;
  for (ValueId i = 0; i < count; ++i) {
    const Step& s = code_.steps[i];
    if (s.op == CodeOp::Mark) mark = i;
    if (overflowOf_[i] != 0) {
      at[overflowOf_[i]] = i;
      if (auto seldom = seldomOf(i, uses)) {
        for (const ValueId step : seldom->steps) at[step] = i;
        seldom_.emplace(i, std::move(*seldom));
      }
    }
    const bool wantsFlags = s.op == CodeOp::Select || (s.op == CodeOp::Leave && !code_.isStraight) || asksOpposite(s) ||
                            s.op == CodeOp::Count || s.op == CodeOp::BranchIf || s.op == CodeOp::BranchUnless;
    if (isNeeded_[i] && wantsFlags && uses[s.a] == 1 && isComparison(code_.steps[s.a].op) && s.a >= mark &&
        i - s.a <= nearBy && at[s.a] == s.a)
      at[s.a] = i;
  }
  return at;
}

/// Finds each sum that is asked in its block whether it overflows, and if the flags that it sets are all of the answer.
void X86Emitter::findSums(const std::vector<ValueId>& uses) {
  const std::size_t count = code_.steps.size();
  overflowOf_.assign(count, 0);
  isFlagOnly_.assign(count, false);
  for (ValueId i = 0; i < count; ++i) {
    const Step& s = code_.steps[i];
    const bool isSum = s.op == CodeOp::Add || s.op == CodeOp::Sub;
    if (!isNeeded_[i] || !isSum || (s.width != 16 && s.width != 32)) continue;
    const CodeOp wanted = s.op == CodeOp::Add ? CodeOp::AddOverflows : CodeOp::SubOverflows;
    ValueId overflow = i + 1;
    const auto isIt = [&](const Step& o) { return o.op == wanted && o.width == s.width && o.a == s.a && o.b == s.b; };
    while (overflow < count && overflow <= i + nearBy && code_.steps[overflow].op != CodeOp::Mark &&
           !(isNeeded_[overflow] && isIt(code_.steps[overflow])))
      ++overflow;
    if (overflow >= count || overflow > i + nearBy || code_.steps[overflow].op == CodeOp::Mark) continue;
    overflowOf_[i] = overflow;
    ValueId left = uses[overflow];
    for (ValueId k = i + 1; k < count && left > 0; ++k) {
      const Step& user = code_.steps[k];
      if (!isNeeded_[k] || k == overflow) continue;
      const bool asks = user.op == CodeOp::Select || user.op == CodeOp::Count;
      if (!keepsFlags(user) || (asks && user.a != overflow)) break;
      if (asks) --left;
    }
    isFlagOnly_[overflow] = left == 0;
  }
}

/// Finds each byte that is another one with a bit replaced by a truth value: what is made of that value for it, and
/// what is left of the other byte, are made together with the result.
void X86Emitter::findReplacedBits(const std::vector<ValueId>& uses, std::vector<ValueId>& at) const {
  const auto constant = [&](ValueId id) { return code_.steps[id].op == CodeOp::Constant ? code_.steps[id].value : 0; };
  for (ValueId i = 0; i < code_.steps.size(); ++i) {
    const Step& s = code_.steps[i];
    if (!isNeeded_[i] || s.op != CodeOp::BitOr || s.width != 8) continue;
    const Step &rest = code_.steps[s.a], &shifted = code_.steps[s.b];
    const bool isShifted = shifted.op == CodeOp::ShiftLeft;
    const ValueId own = isShifted ? shifted.a : s.b;
    const bool isSole = uses[s.a] == 1 && uses[s.b] == 1 && uses[own] == 1;
    if (!isSole || rest.op != CodeOp::BitAnd || code_.steps[own].op != CodeOp::FromBit) continue;
    const std::uint64_t replaced = 1ULL << (isShifted ? constant(shifted.b) : 0);
    if (constant(rest.b) == (0xFF & ~replaced)) at[s.a] = at[s.b] = at[own] = i;
  }
}

/// Whether it may be the comparison itself, the other way round. Overflows are known where their sum is made.
bool X86Emitter::asksOpposite(const Step& s) const {
  if (s.op != CodeOp::Not) return false;
  const CodeOp asked = code_.steps[s.a].op;
  return isComparison(asked) && asked != CodeOp::AddOverflows && asked != CodeOp::SubOverflows;
}

/// Finds the values of 16 bits of which nobody sees what stands above these in their register.
void X86Emitter::findLowUses() {
  seesHigh_.assign(code_.steps.size(), false);
  for (ValueId i = 0; i < code_.steps.size(); ++i) {
    const Step& s = code_.steps[i];
    const int operands = isNeeded_[i] ? operandCount(s.op) : 0;
    const bool isShort = s.width <= 16;
    const bool isPair = (s.op == CodeOp::LessSigned || s.op == CodeOp::Add || s.op == CodeOp::Sub ||
                         s.op == CodeOp::AddOverflows || s.op == CodeOp::SubOverflows) &&
                        s.width == 16;
    const bool isStore = s.op == CodeOp::StoreMemory && isShort;
    if (isPair || isStore) continue;
    if (operands > 0) seesHigh_[s.a] = true;
    if (operands > 1 && !(s.op == CodeOp::StoreAt && isShort)) seesHigh_[s.b] = true;
    if (operands > 2) seesHigh_[s.c] = true;
  }
}

/// Whether the processor's flags are behind the step as before.
bool X86Emitter::keepsFlags(const Step& s) const {
  switch (s.op) {
    case CodeOp::False:
    case CodeOp::True:
    case CodeOp::Constant:
    case CodeOp::Select:
    case CodeOp::Count:
    case CodeOp::LoadBit:
    case CodeOp::LoadState:
    case CodeOp::LoadStateWord:
    case CodeOp::LoadRegister:
    case CodeOp::StoreBit:
    case CodeOp::StoreRegister: return true;
    case CodeOp::Not: return !asksOpposite(s);
    case CodeOp::LoadMemory:
    case CodeOp::LoadAt: return s.width == 8 || (s.width == 32 && hasMovbe_);
    case CodeOp::StoreMemory:
    case CodeOp::StoreAt: return s.width == 8 || hasMovbe_;
    default: return false;
  }
}

X86Emitter::Gp X86Emitter::sized(Gp reg, int width) {
  return width == 8 ? Gp(reg.r8()) : width == 16 ? Gp(reg.r16()) : width == 32 ? Gp(reg.r32()) : reg;
}

/// The operand of an instruction that computes with so many bits.
std::optional<std::int32_t> X86Emitter::signedConstant(ValueId id, int width) const {
  const auto constant = immediate(id);
  if (!constant || width >= 32) return constant;
  return width == 8 ? static_cast<std::int8_t>(*constant) : static_cast<std::int16_t>(*constant);
}

/// A sum or difference in its own width, which sets the flags.
void X86Emitter::addTo(Gp reg, const Step& s) {
  const bool isSum = s.op == CodeOp::Add || s.op == CodeOp::AddOverflows;
  const InstId id = isSum ? x86::Inst::kIdAdd : x86::Inst::kIdSub;
  if (const auto constant = signedConstant(s.b, s.width))
    a_.emit(id, sized(reg, s.width), *constant);
  else
    a_.emit(id, sized(reg, s.width), sized(values_.use(s.b), s.width));
}

/// Together with whether it overflows, where somebody asks.
void X86Emitter::sum(ValueId id, const Step& s) {
  if (seldom_.contains(id)) return sumThatFits(id, s);
  const Gp reg = values_.take(s.a);
  addTo(reg, s);
  if (const ValueId overflow = overflowOf_[id]; overflow != 0) {
    flagsOf_ = overflow;
    flagsHold_ = Cond::kO;
    if (!isFlagOnly_[overflow]) {
      const Gp truth = values_.fresh();
      a_.mov(truth.r32(), 0);
      a_.cmovo(truth.r32(), at(offsetof(Workspace, allOnes), 4));
      values_.define(overflow, truth);
    }
  }
  clearHigh(reg, id);
  values_.define(id, reg);
}

/// The flags stay.
void X86Emitter::clearHigh(Gp reg, ValueId id) {
  if (code_.steps[id].width == 16 && seesHigh_[id]) a_.movzx(reg.r32(), reg.r16());
}

X86Emitter::Cond X86Emitter::comparison(const Step& s) {
  if (s.op == CodeOp::TestBit) {
    const Gp a = values_.use(s.a);
    if (s.value < 31)
      a_.test(a.r32(), 1U << s.value);
    else {
      a_.bt(a, s.value);
      return Cond::kC;
    }
    return Cond::kNZ;
  }
  if (s.op == CodeOp::AddOverflows || s.op == CodeOp::SubOverflows) {
    addTo(values_.take(s.a), s);
    return Cond::kO;
  }
  const bool isSigned = s.op == CodeOp::LessSigned;
  const auto constant = immediate(s.b);
  if (!isSigned || s.width == 8 || s.width == 16 || s.width == 32 || s.width == 64) {
    const int width = isSigned ? s.width : s.width <= 32 ? 32 : 64;
    const Gp a = sized(values_.use(s.a), width);
    if (constant)
      a_.cmp(a, *signedConstant(s.b, width));
    else
      a_.cmp(a, sized(values_.use(s.b), width));
  } else {  // both signs at the top
    const Gp a = values_.take(s.a), b = values_.take(s.b);
    a_.shl(a, 64 - s.width);
    a_.shl(b, 64 - s.width);
    a_.cmp(a, b);
  }
  return s.op == CodeOp::Equal ? Cond::kE : s.op == CodeOp::Less ? Cond::kB : Cond::kL;
}

X86Emitter::Cond X86Emitter::condition(ValueId id) {
  if (id != 0 && flagsOf_ == id) return flagsHold_;
  flagsOf_ = 0;
  if (emittedAt_[id] > id) return comparison(code_.steps[id]);
  const asmjit::Operand held = values_.byteOperand(id);
  if (held.isMem())
    a_.cmp(held.as<x86::Mem>(), 0);
  else
    a_.test(held.as<Gp>(), held.as<Gp>());
  truthMade(id);
  return Cond::kNZ;
}

}  // namespace rungproof::compiled
