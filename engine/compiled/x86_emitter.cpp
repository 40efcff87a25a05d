// The frame of the machine code, stores and branches.
#include "engine/compiled/x86_emitter.hpp"

#include <cstddef>
#include <unordered_set>

#include "ir/check.hpp"
#include "ir/machine/frame.hpp"

namespace rungproof::compiled {

using namespace asmjit;  // its Operand: by its full name

namespace {

std::uint64_t alignedTo8(std::uint64_t size) { return (size + 7) / 8 * 8; }

/// Registers that a function leaves as they were.
const std::array<x86::Gp, 6> savedRegisters = {x86::rbx, x86::rbp, x86::r12, x86::r13, x86::r14, x86::r15};

/// What a displacement of one byte reaches, and how far it reaches upwards.
constexpr std::uint64_t shortReach = 256, shortUp = 128;

/// The byte from which most of these are reached by short displacements.
std::int32_t originFor(std::vector<std::uint64_t> bytes) {
  std::ranges::sort(bytes);
  std::size_t first = 0, most = 0;
  std::uint64_t origin = 0;
  for (std::size_t last = 0; last < bytes.size(); ++last) {
    while (bytes[last] - bytes[first] >= shortReach) ++first;
    if (last - first < most) continue;
    most = last - first + 1;
    origin = bytes[first] + shortUp;
  }
  return static_cast<std::int32_t>(origin);
}

}  // namespace

Layout X86Emitter::layoutOf() const {
  const auto singles = static_cast<std::size_t>(std::ranges::count(slotPlaces_, true, &SlotPlace::isSingle));
  Layout layout;
  layout.singles = alignedTo8(sizeof(Workspace));
  layout.slots = alignedTo8(layout.singles + singles);
  layout.states = layout.slots + 8 * (slotPlaces_.size() - singles);
  layout.errors = layout.states + 8 * std::size_t{code_.states};
  layout.happened = layout.errors + 4 * code_.sites.size();
  layout.news = layout.happened + 4 * code_.sites.size();
  layout.size = alignedTo8(layout.news + code_.sites.size());
  return layout;
}

std::vector<X86Emitter::Gp> X86Emitter::valueRegisters(const Code& code) {
  std::vector<Gp> list = {x86::rax, x86::rcx, x86::rdx, x86::rbx, x86::rsi,
                          x86::rdi, x86::r8,  x86::r9,  x86::r10, x86::r11};
  if (!code.countsTime) list.push_back(x86::r12);
  return list;
}

/// Two of them, and around which of their bytes most steps do so.
std::array<X86Emitter::HeldArea, 2> X86Emitter::busiestAreas(const Code& code, const std::vector<bool>& isNeeded) {
  std::array<std::vector<std::uint64_t>, areaCount> bytes;
  std::array<std::size_t, areaCount> uses{};
  for (std::size_t i = 0; i < code.steps.size(); ++i) {
    const Step& s = code.steps[i];
    const bool isAccess =
        s.op == CodeOp::LoadMemory || s.op == CodeOp::StoreMemory || s.op == CodeOp::LoadAt || s.op == CodeOp::StoreAt;
    if (!isNeeded[i] || !isAccess) continue;
    ++uses[static_cast<std::size_t>(s.area)];
    if (s.op == CodeOp::LoadMemory || s.op == CodeOp::StoreMemory)
      bytes[static_cast<std::size_t>(s.area)].push_back(s.value);
  }
  std::array<HeldArea, 2> held{};
  for (std::size_t i = 0; i < held.size(); ++i) {
    const auto busiest = static_cast<std::size_t>(std::ranges::max_element(uses) - uses.begin());
    uses[busiest] = 0;
    held[i] = {static_cast<Area>(busiest), {i == 0 ? x86::r13 : x86::r15, originFor(std::move(bytes[busiest]))}};
  }
  return held;
}

X86Emitter::X86Emitter(const Code& code, const std::vector<bool>& isNeeded, CodeHolder& holder)
    : code_(code),
      isNeeded_(isNeeded),
      slotPlaces_(placesOfSlots(code)),
      layout_(layoutOf()),
      heldAreas_(busiestAreas(code, isNeeded)),
      hasMovbe_(CpuInfo::host().features().x86().hasMOVBE()),
      emittedAt_(emittedAt()),
      a_(&holder),
      workspace_{x86::rbp, static_cast<std::int32_t>(layout_.singles + shortUp)},
      values_(a_, workspace_, valueRegisters(code), static_cast<std::int32_t>(layout_.size), code, isNeeded,
              emittedAt_) {}

std::optional<Layout> X86Emitter::emit() {
  struct FirstError final : ErrorHandler {
    void handleError(Error, const char*, BaseEmitter*) override { isThere = true; }
    bool isThere = false;
  } error;
  a_.setErrorHandler(&error);
  findStores();
  prologue();
  for (position_ = 0; position_ < code_.steps.size(); ++position_) {
    if (!isNeeded_[position_] || emittedAt_[position_] != position_) continue;
    values_.begin(position_);
    step(position_);
  }
  epilogue();
  a_.setErrorHandler(nullptr);
  Layout layout = layout_;
  layout.size += 8 * values_.placeCount();
  return error.isThere ? std::nullopt : std::optional(layout);
}

/// Up to where slots keep what was loaded from or stored to them. What was loaded is used where only ways lead that
/// have loaded it, and between load and use stand all stores on these ways but those of another round of a loop.
void X86Emitter::findStores() {
  const auto count = static_cast<ValueId>(code_.steps.size());
  standsTo_.assign(count, 0);
  markBehind_.assign(count, count);
  std::vector<ValueId> nextBit(code_.slots.size() * 8, count), nextState(code_.states, count);
  ValueId nextMark = count, nextLoop = count;
  std::unordered_set<std::uint64_t> begun, loops;
  for (const Step& s : code_.steps) {
    if (s.op == CodeOp::Mark) begun.insert(s.value);
    if (isBranch(s.op) && begun.contains(s.value)) loops.insert(s.value);
  }
  for (ValueId i = count; i-- > 0;) {
    if (!isNeeded_[i]) continue;
    const Step& s = code_.steps[i];
    markBehind_[i] = nextMark;
    switch (s.op) {
      case CodeOp::Mark:
        nextMark = i;
        if (loops.contains(s.value)) nextLoop = i;
        break;
      case CodeOp::LoadBit: standsTo_[i] = std::min(nextBit[s.value], nextLoop); break;
      case CodeOp::LoadState:
      case CodeOp::LoadStateWord: standsTo_[i] = std::min(nextState[s.value], nextMark); break;
      case CodeOp::StoreBit:
        standsTo_[i] = std::min(nextBit[s.value], nextMark);
        nextBit[s.value] = i;
        break;
      case CodeOp::StoreState:
      case CodeOp::StoreStateWord: nextState[s.value] = i; break;
      case CodeOp::StoreSlots:
        for (std::uint64_t bit = 0; bit < 8; ++bit) nextBit[s.value + bit] = i;
        break;
      default: break;
    }
  }
}

void X86Emitter::prologue() {
  leave_ = a_.newLabel();
  for (const Gp& reg : savedRegisters) a_.push(reg);
  a_.sub(x86::rsp, 8);  // calls find the stack aligned
  a_.lea(workspace_.reg, x86::ptr(x86::rdi, workspace_.origin));
  a_.mov(x86::r14, at(offsetof(Workspace, registers)));
  for (const HeldArea& held : heldAreas_) {
    a_.mov(held.base.reg, at(offsetof(Workspace, area) + 8 * static_cast<std::size_t>(held.area)));
    if (held.base.origin != 0) a_.add(held.base.reg, held.base.origin);
  }
  if (code_.countsTime) a_.xor_(x86::r12.r32(), x86::r12.r32());
  a_.mov(at(offsetof(Workspace, isLeft)), 0);
  if (!code_.sites.empty()) a_.mov(at(offsetof(Workspace, hasNews)), 0);
  loadSlots();
}

void X86Emitter::epilogue() {
  if (code_.countsTime) {
    a_.cmp(x86::r12, at(offsetof(Workspace, mostTime)));
    a_.ja(leave_);
    a_.mov(at(offsetof(Workspace, position)), x86::r12);
  }
  if (code_.isStraight) {
    a_.cmp(at(offsetof(Workspace, isLeft), 1), 0);
    a_.jne(leave_);
  }
  if (!code_.sites.empty()) {
    a_.cmp(at(offsetof(Workspace, hasNews)), 0);
    a_.jne(leave_);
  }
  saveSlots();
  const Label end = a_.newLabel();
  a_.mov(x86::eax, 1);
  a_.bind(end);
  a_.add(x86::rsp, 8);
  for (std::size_t i = savedRegisters.size(); i-- > 0;) a_.pop(savedRegisters[i]);
  a_.ret();
  a_.bind(leave_);
  a_.xor_(x86::eax, x86::eax);
  a_.jmp(end);
  countErrors();
}

X86Emitter::Mem X86Emitter::memory(Area area, std::uint64_t byte, std::uint32_t size) {
  return baseOf(area).at(byte, size);
}
X86Base X86Emitter::baseOf(Area area) {
  for (const HeldArea& held : heldAreas_) {
    if (held.area == area) return held.base;
  }
  const Gp base = values_.fresh();
  a_.mov(base, at(offsetof(Workspace, area) + 8 * static_cast<std::size_t>(area)));
  return {base};
}

Label& X86Emitter::label(std::uint64_t mark) {
  const auto [place, isNew] = labels_.try_emplace(mark);
  if (isNew) place->second = a_.newLabel();
  return place->second;
}

void X86Emitter::step(ValueId id) {
  const Step& s = code_.steps[id];
  if (!keepsFlags(s)) flagsOf_ = 0;
  if (hasValue(s.op)) {
    value(id);
  } else if (s.op < CodeOp::Leave) {
    store(s);
  } else {
    control(s);
  }
}

void X86Emitter::store(const Step& s) {
  switch (s.op) {
    case CodeOp::StoreBit:
      if (values_.isConstant(s.a)) {
        a_.mov(at(static_cast<std::size_t>(slotAt(s.value)), 1), s.a == 0 ? 0 : 0xFF);
      } else {
        a_.mov(at(static_cast<std::size_t>(slotAt(s.value)), 1), values_.use(s.a).r8());
        values_.stands(s.a, slotAt(s.value), standsTo_[position_]);
      }
      break;
    case CodeOp::StoreState:
      if (values_.isConstant(s.a))
        a_.mov(at(static_cast<std::size_t>(stateAt(s.value)), 1), s.a == 0 ? 0 : 0xFF);
      else
        a_.mov(at(static_cast<std::size_t>(stateAt(s.value)), 1), values_.use(s.a).r8());
      break;
    case CodeOp::StoreStateWord:
      if (const auto constant = immediate(s.a)) {
        a_.mov(at(static_cast<std::size_t>(stateAt(s.value))), *constant);
      } else {
        a_.mov(at(static_cast<std::size_t>(stateAt(s.value))), values_.use(s.a));
      }
      break;
    case CodeOp::StoreSlots: storeSlots(s); break;
    case CodeOp::StoreRegister:
      if (const auto constant = immediate(s.a)) {
        a_.mov(registerAt(s.value), *constant);
      } else {
        a_.mov(registerAt(s.value), values_.use(s.a).r32());
      }
      break;
    default: storeWord(s);
  }
}

/// The highest byte first.
void X86Emitter::storeWord(const Step& s) {
  const bool isAt = s.op == CodeOp::StoreAt;
  const ValueId written = isAt ? s.b : s.a;
  const std::uint32_t size = s.width / 8U;
  const Mem to = isAt ? baseOf(s.area).at(values_.use(s.a), 0, s.value, size) : memory(s.area, s.value, size);
  const auto constant = immediate(written);
  if (size == 8) {
    a_.mov(to, 0);  // bytes that become 0 together
  } else if (constant) {
    const auto value = static_cast<std::uint32_t>(*constant);
    a_.mov(to, size == 1   ? value & 0xFF
               : size == 2 ? (value & 0xFF) << 8 | (value >> 8 & 0xFF)
                           : __builtin_bswap32(value));
  } else if (size == 1) {
    a_.mov(to, values_.use(written).r8());
  } else if (hasMovbe_) {
    const Gp reg = values_.use(written);
    size == 2 ? a_.movbe(to, reg.r16()) : a_.movbe(to, reg.r32());
  } else {
    const Gp turned = values_.take(written);
    size == 2 ? a_.rol(turned.r16(), 8) : a_.bswap(turned.r32());
    size == 2 ? a_.mov(to, turned.r16()) : a_.mov(to, turned.r32());
  }
}

void X86Emitter::control(const Step& s) {
  switch (s.op) {
    case CodeOp::Leave:
      if (s.a == 1)
        a_.jmp(leave_);
      else if (code_.isStraight)
        a_.or_(at(offsetof(Workspace, isLeft), 1), values_.use(s.a).r8());
      else
        a_.j(condition(s.a), leave_);
      break;
    case CodeOp::Count: count(s); break;
    case CodeOp::Mark:
      values_.settle(position_);
      values_.forget();
      a_.bind(label(s.value));
      break;
    case CodeOp::Branch:
      values_.settle(markBehind_[position_]);
      a_.jmp(label(s.value));
      break;
    case CodeOp::BranchIf:
    case CodeOp::BranchUnless: {
      values_.settle(markBehind_[position_]);
      const Cond holds = condition(s.a);
      a_.j(s.op == CodeOp::BranchIf ? holds : x86::negateCond(holds), label(s.value));
      break;
    }
    case CodeOp::AddTime: a_.add(x86::r12, s.value); break;
    case CodeOp::AddTimeIf: {
      const Gp more = values_.fresh();
      a_.movsx(more.r32(), values_.use(s.a).r8());
      a_.and_(more.r32(), s.value);
      a_.add(x86::r12, more);
      break;
    }
    case CodeOp::CheckTime:
      a_.cmp(x86::r12, at(offsetof(Workspace, mostTime)));
      a_.ja(leave_);
      break;
    default: CHECK(false, "no branch");
  }
}

}  // namespace rungproof::compiled
