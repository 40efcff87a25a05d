// What is held in registers from step to step, and for how long.
#include "engine/lanes/wide_emitter.hpp"

namespace rungproof::lanes {

using namespace asmjit;  // its Operand: by its full name
namespace Inst = x86::Inst;

namespace {

/// Mask registers that hold something from step to step.
constexpr std::size_t mostMasks = 4;
/// Steps for which a register keeps what was read from a place and not used since.
constexpr ValueId mostUnused = 96;

}  // namespace

x86::Gp WideEmitter::freshGp() {
  return gps_.take([&] { return c_.newGpq(); });
}
x86::Zmm WideEmitter::freshZmm() {
  return zmms_.take([&] { return c_.newZmm(); });
}
x86::KReg WideEmitter::freshMask() {
  return maskPool_.take([&] { return c_.newKq(); });
}

void WideEmitter::holdTruth(ValueId id, const Gp& value) {
  if (truths_.try_emplace(id, value).second) gps_.hold(value);
}
void WideEmitter::holdScalar(ValueId id, const Gp& value) {
  if (scalars_.try_emplace(id, value).second) gps_.hold(value);
}
void WideEmitter::holdNumber(ValueId id, const Number& value) {
  if (!numbers_.try_emplace(keyOf(id, value.rep), value).second) return;
  for (std::size_t i = 0; i < pieceCount(value.rep); ++i) {
    if (value.piece[i].isReg()) zmms_.hold(value.piece[i].as<Zmm>());
  }
}
void WideEmitter::holdMasks(ValueId id, Rep rep, const Masks& masks) {
  if (!masks_.try_emplace(keyOf(id, rep), masks).second) return;
  for (std::size_t i = 0; i < pieceCount(rep); ++i) maskPool_.hold(masks[i]);
  recentMasks_.push_back(keyOf(id, rep));
}

void WideEmitter::holdCopy(std::size_t place, const Zmm& value) {
  if (copies_.try_emplace(place, Copy{value, step_}).second) zmms_.hold(value);
}

/// There are seven mask registers: what has stood there for long is soon made again of its bits.
void WideEmitter::thinMasks(std::size_t most) {
  std::erase_if(recentMasks_, [&](std::uint64_t key) { return !masks_.contains(key); });
  const auto countOf = [](std::uint64_t key) { return pieceCount(static_cast<Rep>(key & 7)); };
  std::size_t count = 0;
  for (const std::uint64_t key : recentMasks_) count += countOf(key);
  while (count > most) {
    const std::uint64_t key = recentMasks_.front();
    const auto id = static_cast<ValueId>(key >> 3);
    if (!slotOf_.contains(id)) truth(id);
    for (std::size_t i = 0; i < countOf(key); ++i) maskPool_.drop(masks_.at(key)[i]);
    masks_.erase(key);
    recentMasks_.erase(recentMasks_.begin());
    count -= countOf(key);
  }
}
void WideEmitter::drop(const Number& value) {
  for (std::size_t i = 0; i < pieceCount(value.rep); ++i) {
    if (value.piece[i].isReg()) zmms_.drop(value.piece[i].as<Zmm>());
  }
}

void WideEmitter::dropNumber(std::uint64_t key) {
  const auto found = numbers_.find(key);
  if (found == numbers_.end()) return;
  drop(found->second);
  numbers_.erase(found);
}

/// Behind a step: what nobody needs any more is free.
void WideEmitter::release() {
  for (const ValueId id : flow_.endsAt[step_]) {
    for (auto* held : {&truths_, &scalars_}) {
      if (const auto found = held->find(id); found != held->end()) {
        gps_.drop(found->second);
        held->erase(found);
      }
    }
    slotOf_.erase(id);
    for (int r = static_cast<int>(Rep::Byte); r <= static_cast<int>(Rep::Quad); ++r) {
      const std::uint64_t key = keyOf(id, static_cast<Rep>(r));
      dropNumber(key);
      if (const auto found = masks_.find(key); found != masks_.end()) {
        for (std::size_t i = 0; i < pieceCount(static_cast<Rep>(r)); ++i) maskPool_.drop(found->second[i]);
        masks_.erase(found);
      }
    }
  }
  std::erase_if(copies_, [&](const auto& entry) {
    const bool isOld = step_ - entry.second.usedAt > mostUnused;
    if (isOld) zmms_.drop(entry.second.reg);
    return isOld;
  });
  gps_.endStep();
  zmms_.endStep();
  maskPool_.endStep();
  thinMasks(mostMasks);
}

void WideEmitter::forgetAll() {
  truths_.clear();
  scalars_.clear();
  numbers_.clear();
  masks_.clear();
  recentMasks_.clear();
  copies_.clear();
  slotOf_.clear();
  readAt_.clear();
  sums_.clear();
  gps_.clear();
  zmms_.clear();
  maskPool_.clear();
}

void WideEmitter::beforeStore(std::size_t first, std::size_t count) {
  const auto begin = readAt_.lower_bound(first), end = readAt_.lower_bound(first + count);
  for (auto entry = begin; entry != end; ++entry) {
    const ValueId id = entry->second;
    if (slotOf_.contains(id)) {
      truth(id);
      slotOf_.erase(id);
    }
    const auto found = numbers_.find(keyOf(id, repFor(widthOf(code_.steps[id]))));
    if (found == numbers_.end() || found->second.piece[0].isReg()) continue;
    Number& value = found->second;
    for (std::size_t i = 0; i < pieceCount(value.rep); ++i) {
      value.piece[i] = inRegister(value.piece[i]);
      zmms_.hold(value.piece[i].as<Zmm>());
    }
  }
  readAt_.erase(begin, end);
  const auto firstCopy = copies_.lower_bound(first), endOfCopies = copies_.lower_bound(first + count);
  for (auto copy = firstCopy; copy != endOfCopies; ++copy) zmms_.drop(copy->second.reg);
  copies_.erase(firstCopy, endOfCopies);
}

}  // namespace rungproof::lanes
