// Registers and the places that values give way to.
#include "engine/compiled/x86_registers.hpp"

#include <algorithm>
#include <unordered_map>

#include "ir/check.hpp"

namespace rungproof::compiled {

using namespace asmjit;  // its Operand: by its full name

X86Registers::X86Registers(x86::Assembler& assembler, const X86Base& workspace, std::vector<Gp> registers,
                           std::int32_t places, const Code& code, const std::vector<bool>& isNeeded,
                           const std::vector<ValueId>& emittedAt)
    : a_(assembler),
      workspace_(workspace),
      registers_(std::move(registers)),
      placesAt_(places),
      code_(code),
      content_(registers_.size(), 0),
      lockedIn_(registers_.size(), ~ValueId{0}) {
  const std::size_t count = code.steps.size();
  registerOf_.assign(count, none);
  slots_.resize(count);
  placeOf_.assign(count, none);
  firstUse_.assign(count + 1, 0);
  lastUse_.assign(count, 0);
  const auto eachUse = [&](auto&& take) {
    for (ValueId i = 0; i < count; ++i) {
      if (!isNeeded[i] || emittedAt[i] < i) continue;  // or made by an earlier step with the same operands
      const Step& s = code.steps[i];
      const int operands = operandCount(s.op);
      if (operands > 0) take(s.a, emittedAt[i]);
      if (operands > 1) take(s.b, emittedAt[i]);
      if (operands > 2) take(s.c, emittedAt[i]);
    }
  };
  eachUse([&](ValueId value, ValueId step) {
    ++firstUse_[value + 1];
    lastUse_[value] = std::max(lastUse_[value], step);
  });
  lastUseInLoops();
  for (std::size_t i = 0; i < count; ++i) firstUse_[i + 1] += firstUse_[i];
  cursor_.assign(firstUse_.begin(), firstUse_.end() - 1);
  uses_.resize(firstUse_.back());
  std::vector<std::uint32_t> next = cursor_;
  eachUse([&](ValueId value, ValueId step) { uses_[next[value]++] = step; });
  for (std::size_t i = 0; i < count; ++i) {
    const auto first = uses_.begin() + firstUse_[i], last = uses_.begin() + firstUse_[i + 1];
    if (!std::is_sorted(first, last)) std::sort(first, last);
  }
}

/// A value from before a loop that is used in it is needed until the way back.
void X86Registers::lastUseInLoops() {
  struct Loop {
    ValueId first, last;
  };
  std::vector<Loop> loops;  // by where they end
  std::unordered_map<std::uint64_t, ValueId> marks;
  for (ValueId i = 0; i < code_.steps.size(); ++i) {
    const Step& s = code_.steps[i];
    if (s.op == CodeOp::Mark) marks.emplace(s.value, i);
    const auto mark = isBranch(s.op) ? marks.find(s.value) : marks.end();
    if (mark != marks.end()) loops.push_back({mark->second, i});
  }
  for (ValueId i = 0; i < code_.steps.size(); ++i) {
    if (lastUse_[i] == 0) continue;
    const auto behind =
        std::ranges::upper_bound(loops, lastUse_[i], std::less<>{}, [](const Loop& l) { return l.last; });
    for (auto loop = behind; loop != loops.end(); ++loop) {
      if (i < loop->first && loop->first <= lastUse_[i]) lastUse_[i] = std::max(lastUse_[i], loop->last);
    }
  }
}

bool X86Registers::isConstant(ValueId id) const {
  const CodeOp op = code_.steps[id].op;
  return op <= CodeOp::True || op == CodeOp::Constant;
}

void X86Registers::begin(ValueId step) {
  for (ValueId& content : content_) {
    if (content == 0 || lastUse_[content] >= step) continue;
    registerOf_[content] = none;
    content = 0;
  }
  while (!placed_.empty() && placed_.top().first < step) {
    freePlaces_.push_back(placeOf_[placed_.top().second]);
    placeOf_[placed_.top().second] = none;
    placed_.pop();
  }
  step_ = step;
}

ValueId X86Registers::nextUse(ValueId id) {
  std::uint32_t& cursor = cursor_[id];
  while (cursor < firstUse_[id + 1] && uses_[cursor] < step_) ++cursor;
  return cursor < firstUse_[id + 1] ? uses_[cursor] : ~ValueId{0};
}

std::optional<X86Registers::Mem> X86Registers::memory(ValueId id, std::uint32_t size) const {
  const Slot& slot = slots_[id];
  if (slot.isThere && step_ <= slot.until) return workspace_.at(static_cast<std::uint64_t>(slot.at), size);
  if (placeOf_[id] != none) return place(id, size);
  return std::nullopt;
}

void X86Registers::load(ValueId id, Gp reg) {
  const Step& s = code_.steps[id];
  if (isConstant(id)) {
    const std::uint64_t value = s.op == CodeOp::Constant ? s.value : s.op == CodeOp::True ? 0xFF : 0;
    if (value <= 0xFFFFFFFF)
      a_.mov(reg.r32(), static_cast<std::uint32_t>(value));  // the flags stay
    else
      a_.mov(reg, value);
    return;
  }
  const bool isBit = isTruth(s.op);
  const auto from = memory(id, isBit ? 1 : 8);
  CHECK(from, "a value that stands nowhere");
  isBit ? a_.movzx(reg.r32(), *from) : a_.mov(reg, *from);
}

void X86Registers::giveWay(std::size_t reg) {
  const ValueId id = content_[reg];
  content_[reg] = 0;
  if (id == 0) return;
  registerOf_[id] = none;
  const bool isDead = lastUse_[id] < step_;
  const bool standsBehind = slots_[id].isThere && slots_[id].until >= lastUse_[id];
  if (isDead || isConstant(id) || standsBehind || placeOf_[id] != none) return;
  if (freePlaces_.empty()) freePlaces_.push_back(static_cast<std::int32_t>(places_++));
  placeOf_[id] = freePlaces_.back();
  freePlaces_.pop_back();
  placed_.emplace(lastUse_[id], id);
  const Mem to = place(id, isTruth(code_.steps[id].op) ? 1 : 8);
  isTruth(code_.steps[id].op) ? a_.mov(to, registers_[reg].r8()) : a_.mov(to, registers_[reg]);
}

std::size_t X86Registers::freeOne() {
  std::size_t best = registers_.size();
  ValueId furthest = 0;
  for (std::size_t i = 0; i < registers_.size(); ++i) {
    if (lockedIn_[i] == step_) continue;
    if (content_[i] == 0) return i;
    const ValueId next = nextUse(content_[i]);
    if (best < registers_.size() && next <= furthest) continue;
    best = i;
    furthest = next;
  }
  CHECK(best < registers_.size(), "more registers than there are in one step");
  giveWay(best);
  return best;
}

std::size_t X86Registers::indexOf(Gp reg) const {
  for (std::size_t i = 0; i < registers_.size(); ++i) {
    if (registers_[i].id() == reg.id()) return i;
  }
  CHECK(false, "no register for values");
  return 0;
}

X86Registers::Gp X86Registers::fresh() {
  const std::size_t reg = freeOne();
  lockedIn_[reg] = step_;
  return registers_[reg];
}

X86Registers::Gp X86Registers::use(ValueId id) {
  if (registerOf_[id] >= 0) {
    const auto reg = static_cast<std::size_t>(registerOf_[id]);
    lockedIn_[reg] = step_;
    return registers_[reg];
  }
  const Gp reg = fresh();
  load(id, reg);
  if (!isConstant(id)) define(id, reg);
  return reg;
}

X86Registers::Gp X86Registers::take(ValueId id) {
  if (registerOf_[id] < 0) {
    const Gp reg = fresh();
    load(id, reg);
    return reg;
  }
  const auto own = static_cast<std::size_t>(registerOf_[id]);
  // Also the other operand of this step may be the same value.
  const bool isOnce = std::count(uses_.begin() + cursor_[id], uses_.begin() + firstUse_[id + 1], step_) <= 1;
  if (lastUse_[id] <= step_ && isOnce) {
    lockedIn_[own] = step_;
    content_[own] = 0;
    registerOf_[id] = none;
    return registers_[own];
  }
  lockedIn_[own] = step_;
  const Gp copy = fresh();
  isTruth(code_.steps[id].op) ? a_.mov(copy.r32(), registers_[own].r32()) : a_.mov(copy, registers_[own]);
  return copy;
}

void X86Registers::define(ValueId id, Gp reg) {
  const std::size_t index = indexOf(reg);
  content_[index] = id;
  registerOf_[id] = static_cast<std::int8_t>(index);
  lockedIn_[index] = step_;
}

asmjit::Operand X86Registers::byteOperand(ValueId id) {
  if (registerOf_[id] < 0) {
    if (const auto from = memory(id, 1)) return *from;
  }
  return use(id).r8();
}

void X86Registers::stands(ValueId id, std::int32_t at, ValueId until) { slots_[id] = {at, until, true}; }

void X86Registers::settle(ValueId at) {
  for (std::size_t i = 0; i < registers_.size(); ++i) {
    const ValueId id = content_[i];
    if (id == 0 || lastUse_[id] <= at) continue;
    giveWay(i);  // to its place, but it stays in the register too
    content_[i] = id;
    registerOf_[id] = static_cast<std::int8_t>(i);
  }
}

void X86Registers::forget() {
  for (ValueId& content : content_) {
    if (content != 0) registerOf_[content] = none;
    content = 0;
  }
}

void X86Registers::prepareCall(std::initializer_list<ValueId> arguments) {
  static const std::array<Gp, 4> argumentRegisters = {x86::rdi, x86::rsi, x86::rdx, x86::rcx};
  for (std::size_t i = 0; i < registers_.size(); ++i) giveWay(i);
  std::size_t next = 0;
  for (const ValueId id : arguments) {
    const Gp to = argumentRegisters[next++];
    const std::size_t index = indexOf(to);
    lockedIn_[index] = step_;
    load(id, to);
  }
}

}  // namespace rungproof::compiled
