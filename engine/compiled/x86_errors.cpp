// What seldom happens stands out of the way, behind the code that every scan goes through: errors are counted there,
// and where a sum overflows its first operand comes back and the bits of special memory tell of it.
#include <cstddef>

#include "engine/compiled/x86_emitter.hpp"

namespace rungproof::compiled {

using namespace asmjit;  // its Operand: by its full name

namespace {

/// How far behind a sum the steps may stand that ask whether it overflows.
constexpr ValueId reach = 64;

}  // namespace

/// The steps behind a sum that are all who ask for it and for its overflow, and that do nothing but choose, count and
/// tell. Between them others may store words.
std::optional<X86Emitter::Seldom> X86Emitter::seldomOf(ValueId sum, const std::vector<ValueId>& uses) const {
  const Step& s = code_.steps[sum];
  const ValueId overflow = overflowOf_[sum];
  Seldom found;
  std::unordered_map<ValueId, ValueId> asked{{sum, 0}, {overflow, 0}};
  std::unordered_map<ValueId, Told> told{{overflow, Told::Overflow}};
  found.steps.push_back(overflow);
  ValueId fits = 0, zero = 0, negative = 0;
  const auto isTaken = [&](ValueId k) {
    const Step& t = code_.steps[k];
    switch (t.op) {
      case CodeOp::Not:
        if (t.a != overflow || fits != 0) return false;
        told[fits = k] = Told::Fits;
        break;
      case CodeOp::Count:
        if (t.a != overflow || found.site) return false;
        found.site = t.value;
        break;
      case CodeOp::Select:
        if (t.a != overflow || t.b != s.a || t.c != sum || found.result != 0) return false;
        found.result = k;
        break;
      case CodeOp::Equal:
        if (t.a != sum || zero != 0 || code_.steps[t.b].op != CodeOp::Constant || code_.steps[t.b].value != 0)
          return false;
        zero = k;
        break;
      case CodeOp::TestBit:
        if (t.a != sum || negative != 0 || t.value != s.width - 1U) return false;
        negative = k;
        break;
      case CodeOp::And: {
        const ValueId other = t.a == fits ? t.b : t.a;
        if (fits == 0 || (t.a != fits && t.b != fits) || other == 0 || (other != zero && other != negative))
          return false;
        told[k] = other == zero ? Told::Zero : Told::Negative;
        break;
      }
      case CodeOp::StoreBit:
        if (!told.contains(t.a)) return false;
        found.stores.push_back({t.value, told.at(t.a)});
        break;
      default: return false;
    }
    if (hasValue(t.op) && k != found.result) asked.try_emplace(k, 0);
    const int operands = operandCount(t.op);
    const std::array<ValueId, 3> values = {t.a, t.b, t.c};
    for (int i = 0; i < operands; ++i) {
      const auto of = asked.find(values[static_cast<std::size_t>(i)]);
      if (of != asked.end()) ++of->second;
    }
    found.steps.push_back(k);
    return true;
  };
  for (ValueId k = sum + 1; k < code_.steps.size() && k <= sum + reach; ++k) {
    const CodeOp op = code_.steps[k].op;
    const bool isOther = op == CodeOp::Constant || op == CodeOp::StoreMemory || op == CodeOp::StoreRegister;
    if (!isNeeded_[k] || k == overflow || isOther) continue;
    if (!isTaken(k)) break;
  }
  const bool isAll = std::ranges::all_of(asked, [&](const auto& of) { return uses[of.first] == of.second; });
  if (found.result == 0 || !found.site || !isAll) return std::nullopt;
  return found;
}

/// On the way that does not overflow the processor's flags tell everything.
void X86Emitter::sumThatFits(ValueId id, const Step& s) {
  const Seldom& seldom = seldom_.at(id);
  const auto tells = [&](Told what) {
    return std::ranges::any_of(seldom.stores, [&](const auto& store) { return store.second == what; });
  };
  const Gp zero = tells(Told::Zero) ? values_.fresh() : Gp(), negative = tells(Told::Negative) ? values_.fresh() : Gp();
  const Gp second = immediate(s.b) ? Gp() : values_.use(s.b);
  const Gp reg = values_.take(s.a);
  addTo(reg, s);
  const Overflowed& here = overflowed_.emplace_back(Overflowed{id, reg, second, a_.newLabel(), a_.newLabel()});
  a_.jo(here.from);
  clearHigh(reg, seldom.result);
  if (zero.isValid()) a_.sete(zero.r8());
  if (negative.isValid()) a_.sets(negative.r8());
  if (zero.isValid()) a_.neg(zero.r8());
  if (negative.isValid()) a_.neg(negative.r8());
  for (const auto& [slot, what] : seldom.stores) {
    const Mem to = at(static_cast<std::size_t>(slotAt(slot)), 1);
    if (what == Told::Zero || what == Told::Negative)
      a_.mov(to, (what == Told::Zero ? zero : negative).r8());
    else
      a_.mov(to, what == Told::Fits ? 0xFF : 0);
  }
  a_.bind(here.back);
  flagsOf_ = 0;
  values_.define(seldom.result, reg);
}

void X86Emitter::sumsThatOverflow() {
  for (const Overflowed& here : overflowed_) {
    const Step& s = code_.steps[here.sum];
    const Seldom& seldom = seldom_.at(here.sum);
    a_.bind(here.from);
    countAt(*seldom.site);
    const InstId back = s.op == CodeOp::Add ? x86::Inst::kIdSub : x86::Inst::kIdAdd;
    if (const auto constant = signedConstant(s.b, s.width))
      a_.emit(back, sized(here.reg, s.width), *constant);
    else
      a_.emit(back, sized(here.reg, s.width), sized(here.second, s.width));
    for (const auto& [slot, what] : seldom.stores)
      a_.mov(at(static_cast<std::size_t>(slotAt(slot)), 1), what == Told::Overflow ? 0xFF : 0);
    a_.jmp(here.back);
  }
}

void X86Emitter::count(const Step& s) {
  const Happened& here = happened_.emplace_back(Happened{s.value, a_.newLabel(), a_.newLabel()});
  a_.j(condition(s.a), here.from);
  a_.bind(here.back);
}

/// The flags stay as they are, as do all registers.
void X86Emitter::countAt(std::uint64_t site) {
  a_.push(x86::rax);
  a_.mov(x86::eax, site);
  a_.call(count_);
  a_.pop(x86::rax);
}

/// A site at which nothing has happened in this scan is listed.
void X86Emitter::countErrors() {
  if (code_.sites.empty()) return;
  count_ = a_.newLabel();
  for (const Happened& here : happened_) {
    a_.bind(here.from);
    countAt(here.site);
    a_.jmp(here.back);
  }
  sumsThatOverflow();
  const Label isFirst = a_.newLabel(), more = a_.newLabel();
  const x86::Gp site = x86::rax, times = x86::rcx, isNew = x86::rdx;
  const Mem timesOfSite = workspace_.at(site, 2, layout_.errors, 4);
  a_.bind(count_);
  a_.push(times);
  a_.mov(times.r32(), timesOfSite);
  a_.jecxz(times, isFirst);
  a_.bind(more);
  a_.lea(times, x86::ptr(times, 1));
  a_.mov(timesOfSite, times.r32());
  a_.pop(times);
  a_.ret();
  a_.bind(isFirst);
  a_.mov(times, at(offsetof(Workspace, happened)));
  a_.mov(workspace_.at(times, 2, layout_.happened, 4), site.r32());
  a_.lea(times, x86::ptr(times, 1));
  a_.mov(at(offsetof(Workspace, happened)), times);
  a_.push(isNew);
  a_.movzx(isNew.r32(), workspace_.at(site, 0, layout_.news, 1));
  a_.mov(times, at(offsetof(Workspace, hasNews)));
  a_.lea(times, x86::ptr(times, isNew));
  a_.mov(at(offsetof(Workspace, hasNews)), times);
  a_.pop(isNew);
  a_.mov(times.r32(), 0);
  a_.jmp(more);
}

}  // namespace rungproof::compiled
