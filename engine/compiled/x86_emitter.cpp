// The frame of the machine code, stores and branches.
#include "engine/compiled/x86_emitter.hpp"

#include <cstddef>

#include "ir/check.hpp"

namespace rungproof::compiled {

using namespace asmjit;

namespace {

/// By value of a byte: its bits as eight bytes of 0 or 255, the lowest first.
constexpr auto spreadBytes = [] {
  std::array<std::uint64_t, 256> table{};
  for (std::size_t byte = 0; byte < table.size(); ++byte) {
    for (std::size_t bit = 0; bit < 8; ++bit) table[byte] |= (byte >> bit & 1) != 0 ? 0xFFULL << 8 * bit : 0;
  }
  return table;
}();

}  // namespace

X86Emitter::X86Emitter(const Code& code, const std::vector<bool>& isNeeded, CodeHolder& holder)
    : code_(code), isNeeded_(isNeeded), cc_(&holder), hasMovbe_(CpuInfo::host().features().x86().hasMOVBE()) {}

bool X86Emitter::emit() {
  findLifetimes();
  prologue();
  for (position_ = 0; position_ < code_.steps.size(); ++position_) {
    if (isNeeded_[position_]) step(position_);
  }
  epilogue();
  return cc_.finalize() == kErrorOk;
}

/// How often and where last each value is used, and which slots still hold it then.
void X86Emitter::findLifetimes() {
  const std::size_t count = code_.steps.size();
  uses_.assign(count, 0);
  lastUse_.assign(count, 0);
  touched_.assign(count, 0);
  regs_.resize(count);
  isInMemory_.assign(count, false);
  isDeferred_.assign(count, false);
  homeEnd_.assign(count, 0);
  std::vector<ValueId> lastUser(count, 0);
  for (ValueId i = 0; i < count; ++i) {
    if (!isNeeded_[i]) continue;
    const Step& s = code_.steps[i];
    const int operands = operandCount(s.op);
    const std::array<ValueId, 3> all = {s.a, s.b, s.c};
    for (int k = 0; k < operands; ++k) {
      ++uses_[all[static_cast<std::size_t>(k)]];
      lastUse_[all[static_cast<std::size_t>(k)]] = i;
    }
  }
  std::vector<ValueId> nextStore(code_.slots.size() * 8, static_cast<ValueId>(count));
  auto nextMark = static_cast<ValueId>(count);
  for (auto i = static_cast<ValueId>(count); i-- > 0;) {
    if (!isNeeded_[i]) continue;
    const Step& s = code_.steps[i];
    if (s.op == CodeOp::Mark) nextMark = i;
    if (s.op == CodeOp::LoadBit) isInMemory_[i] = lastUse_[i] <= std::min(nextStore[s.value], nextMark);
    if (s.op == CodeOp::StoreBit) {
      homeEnd_[i] = std::min(nextStore[s.value], nextMark);
      nextStore[s.value] = i;
    }
    if (s.op == CodeOp::StoreSlots) {
      for (std::uint64_t bit = 0; bit < 8; ++bit) nextStore[s.value + bit] = i;
    }
    const bool wantsCondition = s.op == CodeOp::Select || s.op == CodeOp::Leave || s.op == CodeOp::Count ||
                                s.op == CodeOp::BranchIf || s.op == CodeOp::BranchUnless;
    if (wantsCondition && uses_[s.a] == 1 && isComparison(s.a) && nextMark > i) {
      bool isSameBlock = true;
      for (ValueId k = s.a; k < i; ++k) isSameBlock = isSameBlock && code_.steps[k].op != CodeOp::Mark;
      isDeferred_[s.a] = isSameBlock;
    }
  }
}

void X86Emitter::prologue() {
  FuncNode* function = cc_.addFunc(FuncSignatureT<std::uint64_t, void*>());
  workspace_ = cc_.newUIntPtr();
  function->setArg(0, workspace_);
  leave_ = cc_.newLabel();
  slots_ = cc_.newUIntPtr();
  registers_ = cc_.newUIntPtr();
  cc_.mov(slots_, field(offsetof(Workspace, slots)));
  cc_.mov(registers_, field(offsetof(Workspace, registers)));
  for (std::size_t a = 0; a < areaCount; ++a) {
    const auto isHere = [&](const auto& thing) { return thing.area == static_cast<Area>(a); };
    bool isUsed = std::any_of(code_.slots.begin(), code_.slots.end(), isHere);
    for (std::size_t i = 0; i < code_.steps.size() && !isUsed; ++i) {
      const CodeOp op = code_.steps[i].op;
      const bool isMemory =
          op == CodeOp::LoadMemory || op == CodeOp::StoreMemory || op == CodeOp::LoadAt || op == CodeOp::StoreAt;
      isUsed = isNeeded_[i] && isMemory && isHere(code_.steps[i]);
    }
    if (!isUsed) continue;
    bases_[a] = cc_.newUIntPtr();
    cc_.mov(bases_[a], field(offsetof(Workspace, area) + 8 * a));
  }
  if (code_.countsTime) {
    time_ = fresh();
    cc_.xor_(time_.r32(), time_.r32());
  }
  const Gp spread = cc_.newUIntPtr(), byte = fresh();
  if (!code_.slots.empty()) cc_.mov(spread, imm(spreadBytes.data()));
  for (std::size_t i = 0; i < code_.slots.size(); ++i) {
    cc_.movzx(byte.r32(), memory(code_.slots[i].area, code_.slots[i].byte, 1));
    cc_.mov(byte, x86::ptr(spread, byte, 3));
    cc_.mov(slot(8 * i, 8), byte);
  }
}

void X86Emitter::epilogue() {
  std::vector<bool> isWritten(code_.slots.size(), false);
  for (std::size_t i = 0; i < code_.steps.size(); ++i) {
    const Step& s = code_.steps[i];
    if (isNeeded_[i] && (s.op == CodeOp::StoreBit || s.op == CodeOp::StoreSlots)) isWritten[s.value / 8] = true;
  }
  if (code_.countsTime) {
    cc_.cmp(time_, field(offsetof(Workspace, mostTime)));
    cc_.ja(leave_);
    cc_.mov(field(offsetof(Workspace, position)), time_);
  }
  const x86::Xmm bits = cc_.newXmm();
  const Gp byte = fresh();
  for (std::size_t i = 0; i < code_.slots.size(); ++i) {
    if (!isWritten[i]) continue;
    cc_.movq(bits, slot(8 * i, 8));
    cc_.pmovmskb(byte.r32(), bits);
    cc_.mov(memory(code_.slots[i].area, code_.slots[i].byte, 1), byte.r8());
  }
  const Gp result = fresh();
  cc_.mov(result.r32(), 1);
  cc_.ret(result);
  cc_.bind(leave_);
  const Gp left = fresh();
  cc_.xor_(left.r32(), left.r32());
  cc_.ret(left);
  cc_.endFunc();
}

X86Emitter::Mem X86Emitter::memory(Area area, std::uint64_t byte, std::uint32_t size) {
  return x86::ptr(baseOf(area), static_cast<std::int32_t>(byte), size);
}
X86Emitter::Gp X86Emitter::baseOf(Area area) { return bases_[static_cast<std::size_t>(area)]; }

Label& X86Emitter::label(std::uint64_t mark) {
  const auto [place, isNew] = labels_.try_emplace(mark);
  if (isNew) place->second = cc_.newLabel();
  return place->second;
}

void X86Emitter::step(ValueId id) {
  const Step& s = code_.steps[id];
  if (hasValue(s.op)) {
    if (!isInMemory_[id] && !isDeferred_[id]) value(id);
  } else if (s.op < CodeOp::Leave) {
    store(s);
  } else {
    control(s);
  }
}

void X86Emitter::store(const Step& s) {
  switch (s.op) {
    case CodeOp::StoreBit:
      if (s.a <= 1) {
        cc_.mov(slot(s.value), s.a == 0 ? 0 : 0xFF);
      } else {
        cc_.mov(slot(s.value), use(s.a).r8());
        homes_[s.a] = {s.value, homeEnd_[position_]};
      }
      break;
    case CodeOp::StoreState: {
      const auto [place, isNew] = states_.try_emplace(s.value);
      if (isNew) place->second = fresh();
      cc_.mov(place->second.r32(), use(s.a).r32());
      break;
    }
    case CodeOp::StoreSlots: {
      const Gp byte = take(s.a), spread = cc_.newUIntPtr();
      cc_.mov(spread, imm(spreadBytes.data()));
      cc_.mov(byte, x86::ptr(spread, byte, 3));
      cc_.mov(slot(s.value, 8), byte);
      break;
    }
    case CodeOp::StoreRegister:
      if (const auto constant = immediate(s.a)) {
        cc_.mov(registerAt(s.value), *constant);
      } else {
        cc_.mov(registerAt(s.value), use(s.a).r32());
      }
      break;
    case CodeOp::StoreMemory:
    case CodeOp::StoreAt: {
      const bool isAt = s.op == CodeOp::StoreAt;
      const ValueId written = isAt ? s.b : s.a;
      const std::uint32_t size = s.width / 8U;
      const Mem to = isAt ? x86::ptr(baseOf(s.area), use(s.a), 0, 0, size) : memory(s.area, s.value, size);
      if (size == 8) {
        cc_.mov(to, 0);  // bytes that become 0 together
      } else if (size == 1) {
        cc_.mov(to, use(written).r8());
      } else if (hasMovbe_) {
        const Gp reg = use(written);
        size == 2 ? cc_.movbe(to, reg.r16()) : cc_.movbe(to, reg.r32());
      } else {
        const Gp turned = take(written);
        size == 2 ? cc_.rol(turned.r16(), 8) : cc_.bswap(turned.r32());
        size == 2 ? cc_.mov(to, turned.r16()) : cc_.mov(to, turned.r32());
      }
      break;
    }
    default: CHECK(false, "no store");
  }
}

void X86Emitter::control(const Step& s) {
  switch (s.op) {
    case CodeOp::Leave:
      if (s.a == 1)
        cc_.jmp(leave_);
      else
        cc_.j(condition(s.a), leave_);
      break;
    case CodeOp::Count: count(s); break;
    case CodeOp::Mark: cc_.bind(label(s.value)); break;
    case CodeOp::Branch: cc_.jmp(label(s.value)); break;
    case CodeOp::BranchIf: cc_.j(condition(s.a), label(s.value)); break;
    case CodeOp::BranchUnless: cc_.j(x86::negateCond(condition(s.a)), label(s.value)); break;
    case CodeOp::AddTime: cc_.add(time_, s.value); break;
    case CodeOp::AddTimeIf: {
      const Gp more = take(s.a);
      cc_.movsx(more.r32(), more.r8());
      cc_.and_(more.r32(), s.value);
      cc_.add(time_, more);
      break;
    }
    case CodeOp::CheckTime:
      cc_.cmp(time_, field(offsetof(Workspace, mostTime)));
      cc_.ja(leave_);
      break;
    default: CHECK(false, "no branch");
  }
}

/// An error that is listed is counted; one that is new is for the reference engine, which knows when it happened.
void X86Emitter::count(const Step& s) {
  const Label behind = cc_.newLabel();
  if (s.a != 1) cc_.j(x86::negateCond(condition(s.a)), behind);
  const Gp list = cc_.newUIntPtr();
  cc_.mov(list, field(offsetof(Workspace, isListed)));
  cc_.cmp(x86::ptr(list, static_cast<std::int32_t>(s.value), 1), 0);
  cc_.je(leave_);
  cc_.mov(list, field(offsetof(Workspace, counts)));
  cc_.inc(x86::ptr(list, static_cast<std::int32_t>(8 * s.value), 8));
  cc_.mov(field(offsetof(Workspace, hasCounted)), 1);
  cc_.bind(behind);
}

}  // namespace rungproof::compiled
