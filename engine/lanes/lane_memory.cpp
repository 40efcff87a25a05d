// State in rows: what is read and written under the mask of the traces that run, and places found by computed
// addresses. Where all traces have the same address, which they mostly do, it is one row behind the other.
#include "engine/lanes/lane_emitter.hpp"
#include "ir/check.hpp"

namespace rungproof::lanes {

using namespace asmjit;  // its Operand: by its full name
namespace Inst = x86::Inst;

namespace {

/// By trace: the place of its number in a row of double words; behind the last one, as if nobody ran, the first.
constexpr auto doubleAt = [] {
  std::array<std::uint8_t, 65> places{};
  for (std::size_t lane = 0; lane < 32; ++lane) places[lane] = static_cast<std::uint8_t>(elementOf(Rep::Double, lane));
  return places;
}();

}  // namespace

/// Under the mask: traces that wait elsewhere keep what they have.
void LaneEmitter::storeRow(Row row, const Vec& value) {
  CHECK(row.rep == value.rep, "a row in another form");
  Vec mask{Rep::Truth, {active_}};
  if (flow_.isMaskedAt[step_]) {
    if (row.rep != Rep::Truth) mask.rep = Rep::Byte;
    while (mask.rep < row.rep) mask = widened(mask, true);
  }
  for (std::size_t i = 0; i < pieceCount(row.rep); ++i) {
    const std::size_t offset = row.at + rowBytes * i;
    save(offset, flow_.isMaskedAt[step_] ? chosen(mask.piece[i], value.piece[i], load(offset)) : value.piece[i]);
  }
}

/// Two numbers as one of twice the width.
Vec LaneEmitter::together(const Vec& high, const Vec& low) {
  const bool isByte = high.rep == Rep::Byte;
  Vec both{isByte ? Rep::Word : Rep::Double};
  for (std::size_t i = 0; i < pieceCount(high.rep); ++i) {
    both.piece[2 * i] = op(isByte ? Inst::kIdVpunpcklbw : Inst::kIdVpunpcklwd, low.piece[i], high.piece[i]);
    both.piece[2 * i + 1] = op(isByte ? Inst::kIdVpunpckhbw : Inst::kIdVpunpckhwd, low.piece[i], high.piece[i]);
  }
  return both;
}

/// Byte number `k` of numbers, 0 the lowest.
Vec LaneEmitter::byteOf(const Vec& value, std::uint32_t k) {
  const bool isTop = 8 * (static_cast<int>(k) + 1) == bitsOf(value.rep);
  return fit(k == 0 ? value : shifted(value, false, 8 * k), Rep::Byte, isTop ? bitsOf(value.rep) : 8);
}

void LaneEmitter::storeMemory(const Step& s) {
  const std::uint32_t bytes = s.width / 8U;
  if (isClearing(s, code_)) {
    for (const Row& row : layout_.rowsWithin(s.area, static_cast<std::uint32_t>(s.value), bytes))
      storeRow(row, constant(0, row.rep));
    return;
  }
  const Vec value = use(s.a, repFor(s.width));
  if (const auto row = layout_.cell(s.area, static_cast<std::uint32_t>(s.value), static_cast<int>(bytes)))
    return storeRow(*row, value);
  for (std::uint32_t k = 0; k < bytes; ++k) storeRow(byteRow(s, k), byteOf(value, bytes - 1 - k));
}

Vec LaneEmitter::loadSlots(const Step& s) {
  Vec byte{Rep::Byte};
  for (std::uint64_t bit = 0; bit < 8; ++bit) {
    const Ymm own = op(Inst::kIdVpand, load(layout_.slot(s.value + bit)), constantRow(1ULL << bit, Rep::Byte));
    byte.piece[0] = bit == 0 ? own : op(Inst::kIdVpor, byte.piece[0], own);
  }
  return byte;
}
void LaneEmitter::storeSlots(const Step& s) {
  if (const Step& given = code_.steps[s.a]; given.op == CodeOp::Constant) {
    for (std::uint64_t bit = 0; bit < 8; ++bit)
      storeRow({layout_.slot(s.value + bit), Rep::Truth}, constant(given.value >> bit & 1, Rep::Truth));
    return;
  }
  const Vec byte = use(s.a, Rep::Byte);
  for (std::uint64_t bit = 0; bit < 8; ++bit) {
    const Mem own = constantRow(1ULL << bit, Rep::Byte);
    const Ymm on = op(Inst::kIdVpcmpeqb, op(Inst::kIdVpand, byte.piece[0], own), own);
    storeRow({layout_.slot(s.value + bit), Rep::Truth}, {Rep::Truth, {on}});
  }
}

/// Where all traces that run have the same address, gives where its first row stands from rows_ on, and goes on behind
/// this; else at `differ`. The addresses then stand in the first scratch row.
x86::Gp LaneEmitter::commonPlace(const Step& s, const Label& differ) {
  const Vec address = use(s.a, Rep::Double);
  save(layout_.scratch(0), address);
  Ymm active = active_;
  if (code_.isStraight) active = load(layout_.active());
  const Gp place = c_.newGpq(), table = c_.newGpq();
  c_.vpmovmskb(place.r32(), active);
  c_.tzcnt(place, place);
  c_.mov(table, imm(reinterpret_cast<std::uintptr_t>(doubleAt.data())));
  c_.movzx(place.r32(), x86::byte_ptr(table, place));
  const Mem first = x86::ptr(rows_, place, 2, static_cast<std::int32_t>(layout_.scratch(0)), 4);
  const Ymm all = fresh();
  c_.vpbroadcastd(all, first);
  c_.mov(place.r32(), first);
  Vec isSame{Rep::Double};
  for (std::size_t i = 0; i < pieceCount(Rep::Double); ++i)
    isSame.piece[i] = op(Inst::kIdVpcmpeqd, address.piece[i], all);
  c_.vptest(toTruth(isSame).piece[0], active);
  c_.jnc(differ);
  const ReachedRows& reached = layout_.reached(s.area);
  const auto bytes = s.width / 8U;
  c_.sub(place, imm(static_cast<std::int64_t>(reached.first) - static_cast<std::int64_t>(s.value)));
  c_.cmp(place, imm(reached.count < bytes ? 0 : reached.count - bytes));
  c_.ja(differ);
  c_.shl(place, 5);
  return place;
}

Vec LaneEmitter::loadAt(const Step& s) {
  const Rep rep = repFor(s.width);
  const Label differ = c_.newLabel(), done = c_.newLabel();
  Vec value{rep};
  for (std::size_t i = 0; i < pieceCount(rep); ++i) value.piece[i] = fresh();
  const Gp place = commonPlace(s, differ);
  const ReachedRows& reached = layout_.reached(s.area);
  const auto single = [&](std::uint32_t k) {
    const Ymm byte = fresh();
    c_.vmovdqa(byte, x86::ptr(rows_, place, 0, static_cast<std::int32_t>(reached.at + rowBytes * k), rowBytes));
    return Vec{Rep::Byte, {byte}};
  };
  const Vec common = joined(s.width / 8, single);
  for (std::size_t i = 0; i < pieceCount(rep); ++i) c_.vmovdqa(value.piece[i], common.piece[i]);
  c_.jmp(done);
  c_.bind(differ);
  callByTrace(s, rep, reached);
  for (std::size_t i = 0; i < pieceCount(rep); ++i) c_.vmovdqa(value.piece[i], at(layout_.scratch(2) + rowBytes * i));
  c_.bind(done);
  return value;
}

void LaneEmitter::storeAt(const Step& s) {
  const Rep rep = repFor(s.width);
  const Label differ = c_.newLabel(), done = c_.newLabel();
  const Vec value = use(s.b, rep);
  const Gp place = commonPlace(s, differ);
  const ReachedRows& reached = layout_.reached(s.area);
  const std::uint32_t bytes = s.width / 8U;
  for (std::uint32_t k = 0; k < bytes; ++k) {
    const Mem row = x86::ptr(rows_, place, 0, static_cast<std::int32_t>(reached.at + rowBytes * k), rowBytes);
    Ymm byte = byteOf(value, bytes - 1 - k).piece[0];
    if (flow_.isMaskedAt[step_]) {
      const Ymm old = fresh();
      c_.vmovdqa(old, row);
      byte = chosen(active_, byte, old);
    }
    c_.vmovdqa(row, byte);
  }
  c_.jmp(done);
  c_.bind(differ);
  save(layout_.scratch(1), value);
  callByTrace(s, rep, reached);
  c_.bind(done);
}

}  // namespace rungproof::lanes
