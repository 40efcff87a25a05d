// State in rows: what is read and written under the mask of the traces that run, and places found by computed
// addresses. Where all traces have the same address, which they mostly do, it is one row behind the other.
#include "engine/lanes/vector_forms.hpp"
#include "engine/lanes/wide_emitter.hpp"

namespace rungproof::lanes {

using namespace asmjit;  // its Operand: by its full name
namespace Inst = x86::Inst;

void WideEmitter::storePiece(const Mem& to, const Zmm& value, Rep rep, const Mask* mask) {
  if (mask != nullptr) c_.k(*mask);
  c_.emit(mask == nullptr ? InstId{Inst::kIdVmovdqa64} : formOf(forms::maskedMove, rep), to, value);
}

/// Under the mask: traces that wait elsewhere keep what they have.
void WideEmitter::storeTruth(std::size_t offset, const Gp& value) {
  const Mem to = at(offset, wideTruthBytes);
  const Gp all = freshGp();
  c_.mov(all, value);
  c_.xor_(all, to);
  c_.and_(all, active_);
  c_.xor_(to, all);
}
void WideEmitter::storeNumber(std::size_t offset, const Number& value) {
  const Masks masks = masksFrom(active_, value.rep);
  for (std::size_t i = 0; i < pieceCount(value.rep); ++i)
    storePiece(at(offset + wideBytes * i), inRegister(value.piece[i]), value.rep, &masks[i]);
}

void WideEmitter::storeRow(Row row, ValueId id) {
  const bool isMasked = flow_.isMaskedAt[step_];
  if (row.rep == Rep::Truth) {
    beforeStore(row.at, wideTruthBytes);
    if (isMasked) return storeTruth(row.at, truth(id));
    c_.mov(at(row.at, wideTruthBytes), truth(id));
    return;
  }
  if (flow_.merged.contains(id)) return storeMerged(row, code_.steps[id]);
  const Number value = use(id, row.rep);
  beforeStore(row.at, wideBytes * pieceCount(row.rep));
  if (isMasked) return storeNumber(row.at, value);
  save(row.at, value);
}

/// Those of the condition get a new value, the others keep what stands there.
void WideEmitter::storeMerged(Row row, const Step& choice) {
  const Number value = use(choice.b, row.rep);
  Number held{row.rep};
  for (std::size_t i = 0; i < pieceCount(row.rep); ++i) held.piece[i] = inRegister(value.piece[i]);
  const Masks masks = masksOf(choice.a, row.rep);
  const auto& ends = flow_.endsAt[step_];
  if (std::find(ends.begin(), ends.end(), choice.c) != ends.end()) dropNumber(keyOf(choice.c, row.rep));
  beforeStore(row.at, wideBytes * pieceCount(row.rep));
  for (std::size_t i = 0; i < pieceCount(row.rep); ++i)
    storePiece(at(row.at + wideBytes * i), held.piece[i].as<Zmm>(), row.rep, &masks[i]);
}

void WideEmitter::store(const Step& s) {
  switch (s.op) {
    case CodeOp::StoreBit: return storeRow({layout_.slot(s.value), Rep::Truth}, s.a);
    case CodeOp::StoreState:
    case CodeOp::StoreStateWord: return storeRow(layout_.state(s.value), s.a);
    case CodeOp::StoreRegister: {
      const auto number = oneNumber(s.value);
      if (number && isScalar(s.a) && !flow_.isMaskedAt[step_]) return void(c_.mov(at(*number, 8), scalar(s.a)));
      return storeRow(*layout_.reg(s.value), s.a);
    }
    case CodeOp::StoreMemory: return storeMemory(s);
    case CodeOp::StoreSlots: return storeSlots(s);
    default: return storeAt(s);
  }
}

/// Two numbers as one of twice the width.
WideNumber WideEmitter::together(const Number& high, const Number& low) {
  const Number wideLow = widened(low);
  return each(Inst::kIdVporq, shifted(widened(high), true, static_cast<std::uint32_t>(bitsOf(low.rep))), wideLow);
}

/// Stores byte number `k` of numbers, 0 the lowest.
void WideEmitter::storeByteOf(const Number& value, std::uint32_t k, const Mem& to, const Mask* mask) {
  Number byte = k == 0 ? value : shifted(value, false, 8 * k);
  while (byte.rep > Rep::Word || (byte.rep > Rep::Byte && mask != nullptr)) byte = narrowed(byte);
  if (byte.rep == Rep::Byte) return storePiece(to, inRegister(byte.piece[0]), Rep::Byte, mask);
  for (std::size_t i = 0; i < pieceCount(Rep::Word); ++i) {
    Mem half = to.cloneAdjusted(static_cast<std::int64_t>(i * wideBytes / 2));
    half.setSize(wideBytes / 2);
    c_.emit(Inst::kIdVpmovwb, half, inRegister(byte.piece[i]));
  }
}

void WideEmitter::storeMemory(const Step& s) {
  const std::uint32_t bytes = s.width / 8U;
  if (isClearing(s, code_)) {
    for (const Row& row : layout_.rowsWithin(s.area, static_cast<std::uint32_t>(s.value), bytes)) storeRow(row, s.a);
    return;
  }
  if (const auto row = layout_.cell(s.area, static_cast<std::uint32_t>(s.value), static_cast<int>(bytes)))
    return storeRow(*row, s.a);
  const Number value = isScalar(s.a)                ? Number{}
                       : flow_.merged.contains(s.a) ? select(code_.steps[s.a])
                                                    : use(s.a, repFor(s.width));
  for (std::uint32_t k = 0; k < bytes; ++k) {
    const std::size_t to = byteRow(s, k).at;
    const std::uint32_t number = bytes - 1 - k;
    beforeStore(to, wideBytes);
    const Masks masks = flow_.isMaskedAt[step_] ? masksFrom(active_, Rep::Byte) : Masks{};
    const Mask* const mask = flow_.isMaskedAt[step_] ? &masks[0] : nullptr;
    if (isScalar(s.a)) {
      const Gp part = copied(scalar(s.a));
      if (number > 0) c_.shr(part, imm(8 * number));
      storePiece(at(to), broadcast(part, Rep::Byte).piece[0].as<Zmm>(), Rep::Byte, mask);
    } else {
      storeByteOf(value, number, at(to), mask);
    }
  }
}

WideNumber WideEmitter::loadSlots(const Step& s) {
  const Zmm byte = freshZmm();
  for (std::uint64_t bit = 0; bit < 8; ++bit) {
    const Mask on = freshMask();
    c_.kmovq(on, at(layout_.slot(s.value + bit), wideTruthBytes));
    const asmjit::Operand own = constant(1ULL << bit, Rep::Byte).piece[0];
    if (bit == 0)
      c_.k(on).z().emit(Inst::kIdVmovdqu8, byte, own);
    else
      c_.k(on).emit(Inst::kIdVpaddb, byte, byte, own);
  }
  Number value{Rep::Byte};
  value.piece[0] = byte;
  return value;
}

void WideEmitter::storeSlots(const Step& s) {
  const Step& given = code_.steps[s.a];
  for (std::uint64_t bit = 0; bit < 8; ++bit) {
    const std::size_t offset = layout_.slot(s.value + bit);
    Gp on;
    if (given.op == CodeOp::Constant) {
      on = truth((given.value >> bit & 1) != 0 ? 1 : 0);
    } else {
      const Mask own = freshMask();
      c_.emit(Inst::kIdVptestmb, own, inRegister(use(s.a, Rep::Byte).piece[0]),
              constant(1ULL << bit, Rep::Byte).piece[0]);
      on = freshGp();
      c_.kmovq(on, own);
    }
    beforeStore(offset, wideTruthBytes);
    if (flow_.isMaskedAt[step_])
      storeTruth(offset, on);
    else
      c_.mov(at(offset, wideTruthBytes), on);
  }
}

void WideEmitter::saveActive() { c_.mov(at(layout_.active(), wideTruthBytes), active_); }

/// Where all traces that run have the same address, gives where its first row stands from rows_ on, and goes on behind
/// this; else at `differ`. The addresses then stand in the first scratch row.
x86::Gp WideEmitter::commonPlace(const Step& s, const Label& differ) {
  const ReachedRows& reached = layout_.reached(s.area);
  const auto bytes = s.width / 8U;
  Gp place = freshGp();
  if (isScalar(s.a)) {
    c_.mov(place, scalar(s.a));
  } else {
    beforeCall();
    const Number address = use(s.a, Rep::Double);
    const Gp active = freshGp();
    if (code_.isStraight)
      c_.mov(active, at(layout_.active(), wideTruthBytes));
    else
      c_.mov(active, active_);
    Number held{Rep::Double};
    for (std::size_t i = 0; i < pieceCount(Rep::Double); ++i) held.piece[i] = inRegister(address.piece[i]);
    save(layout_.scratch(0), held);
    c_.tzcnt(place, active);
    c_.and_(place.r32(), 63);  // nobody runs: any
    c_.mov(place.r32(), x86::ptr(rows_, place, 2, static_cast<std::int32_t>(layout_.scratch(0)), 4));
    const Number all = broadcast(place, Rep::Double);
    const Gp same = truthFrom(compared(Inst::kIdVpcmpd, held, all, 0), Rep::Double);
    c_.andn(same, same, active);
    c_.jnz(differ);
  }
  c_.sub(place, imm(static_cast<std::int64_t>(reached.first) - static_cast<std::int64_t>(s.value)));
  c_.cmp(place, imm(reached.count < bytes ? 0 : reached.count - bytes));
  c_.ja(differ);
  c_.shl(place, 6);
  return place;
}

x86::Mem WideEmitter::placeAt(const Gp& place, Area area, std::uint32_t byte) {
  return x86::ptr(rows_, place, 0, static_cast<std::int32_t>(layout_.reached(area).at + wideBytes * byte), wideBytes);
}

WideNumber WideEmitter::loadAt(const Step& s) {
  const Rep rep = repFor(s.width);
  const Label differ = c_.newLabel(), done = c_.newLabel();
  Number value{rep};
  for (std::size_t i = 0; i < pieceCount(rep); ++i) value.piece[i] = freshZmm();
  const Gp place = commonPlace(s, differ);
  const auto single = [&](std::uint32_t k) {
    Number byte{Rep::Byte};
    byte.piece[0] = placeAt(place, s.area, k);
    return byte;
  };
  const Number common = joined(s.width / 8, single);
  for (std::size_t i = 0; i < pieceCount(rep); ++i) c_.emit(Inst::kIdVmovdqa64, value.piece[i], common.piece[i]);
  c_.jmp(done);
  c_.bind(differ);
  if (!isScalar(s.a)) {
    callByTrace(s, rep, layout_.reached(s.area));
    for (std::size_t i = 0; i < pieceCount(rep); ++i)
      c_.emit(Inst::kIdVmovdqa64, value.piece[i], at(layout_.scratch(2) + wideBytes * i));
  }
  c_.bind(done);
  return value;
}

/// Of a store to memory from which the code takes it for granted that there is none (LaneFlow::guarded).
void WideEmitter::leaveWhereGuarded(const Step& s) {
  constexpr std::uint32_t askLessOrEqual = 2;
  for (const LaneFlow::Guarded& g : flow_.guarded) {
    if (g.area != s.area) continue;
    // From as many bytes before the place on as the store has behind its first.
    const std::uint64_t first = g.first + 1 - s.width / 8U - s.value, span = g.count + s.width / 8U - 2;
    if (isScalar(s.a)) {
      const Label isElsewhere = c_.newLabel();
      const Gp address = copied(scalar(s.a));
      c_.sub(address.r32(), imm(static_cast<std::int32_t>(first)));
      c_.cmp(address.r32(), imm(span));
      c_.ja(isElsewhere);
      const Gp all = copied(active_);
      leave(all);
      c_.bind(isElsewhere);
      continue;
    }
    const Number from = each(Inst::kIdVpsubd, use(s.a, Rep::Double), constant(first & 0xFFFFFFFF, Rep::Double));
    const Gp who =
        truthFrom(compared(Inst::kIdVpcmpud, from, constant(span, Rep::Double), askLessOrEqual), Rep::Double);
    c_.and_(who, active_);
    leave(who);
  }
}

void WideEmitter::storeAt(const Step& s) {
  leaveWhereGuarded(s);
  const Rep rep = repFor(s.width);
  const Label differ = c_.newLabel(), done = c_.newLabel();
  const ReachedRows& reached = layout_.reached(s.area);
  Number value = use(s.b, rep);
  for (std::size_t i = 0; i < pieceCount(rep); ++i) value.piece[i] = inRegister(value.piece[i]);
  beforeStore(reached.at, wideBytes * reached.count);
  const Gp place = commonPlace(s, differ);
  const std::uint32_t bytes = s.width / 8U;
  const bool isMasked = flow_.isMaskedAt[step_];
  const Masks masks = isMasked ? masksFrom(active_, Rep::Byte) : Masks{};
  for (std::uint32_t k = 0; k < bytes; ++k)
    storeByteOf(value, bytes - 1 - k, placeAt(place, s.area, k), isMasked ? &masks[0] : nullptr);
  c_.jmp(done);
  c_.bind(differ);
  if (!isScalar(s.a)) {
    save(layout_.scratch(1), value);
    callByTrace(s, rep, reached);
  }
  c_.bind(done);
}

}  // namespace rungproof::lanes
