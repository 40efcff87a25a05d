// Bits of memory that have bytes of their own while the machine code runs: out of their bytes before the program, and
// back behind it.
#include <algorithm>
#include <cstddef>

#include "engine/compiled/x86_emitter.hpp"

namespace rungproof::compiled {

using namespace asmjit;  // its Operand: by its full name

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

/// Bits that have a byte of memory to themselves, as variables of IEC 61131-3 do, stand alone: sixteen of them are
/// moved at once. Nothing reads or writes their bytes as a whole.
std::vector<X86Emitter::SlotPlace> X86Emitter::placesOfSlots(const Code& code) {
  std::vector<SlotPlace> places(code.slots.size(), {.isSingle = true});
  for (const Step& s : code.steps) {
    const bool isBit = s.op == CodeOp::LoadBit || s.op == CodeOp::StoreBit;
    const bool isByte = s.op == CodeOp::LoadSlots || s.op == CodeOp::StoreSlots;
    if (isByte || (isBit && s.value % 8 != 0)) places[s.value / 8].isSingle = false;
  }
  std::size_t singles = 0, others = 0;
  for (SlotPlace& place : places) place.index = place.isSingle ? singles++ : others++;
  return places;
}

std::vector<X86Emitter::SingleRun> X86Emitter::singleRuns() const {
  std::vector<SingleRun> runs;
  for (std::size_t i = 0; i < slotPlaces_.size(); ++i) {
    if (!slotPlaces_[i].isSingle) continue;
    const bool goesOn = i > 0 && slotPlaces_[i - 1].isSingle && !runs.empty() &&
                        code_.slots[i].area == code_.slots[i - 1].area &&
                        code_.slots[i].byte == code_.slots[i - 1].byte + 1;
    if (!goesOn) runs.push_back({i, 0});
    ++runs.back().count;
  }
  return runs;
}

/// Its address in rcx.
void X86Emitter::holdArea(Area area) {
  a_.mov(x86::rcx, at(offsetof(Workspace, area) + 8 * static_cast<std::size_t>(area)));
}

namespace {
constexpr std::size_t together = 16;
constexpr std::uint64_t lowestBits = 0x0101010101010101;
}  // namespace

/// Calls move(first, isWide, byte, place) with the address of the area in rcx and the lowest bits of sixteen bytes in
/// xmm3: for sixteen bits at once where a run has as many, else for each. The last sixteen may overlap those before.
template <class Move>
void X86Emitter::moveSingles(Move&& move) {
  a_.mov(x86::rax, lowestBits);
  a_.movq(x86::xmm3, x86::rax);
  a_.punpcklqdq(x86::xmm3, x86::xmm3);
  for (const SingleRun& run : singleRuns()) {
    holdArea(code_.slots[run.first].area);
    const bool isWide = run.count >= together;
    for (std::size_t i = 0; i < run.count; i += isWide ? together : 1) {
      const std::size_t first = run.first + (isWide ? std::min(i, run.count - together) : i);
      move(first, isWide, static_cast<std::int32_t>(code_.slots[first].byte),
           static_cast<std::size_t>(slotAt(8 * first)));
    }
  }
}

/// 0 or 255 for the lowest bit of each byte.
void X86Emitter::loadSingles() {
  moveSingles([&](std::size_t, bool isWide, std::int32_t byte, std::size_t place) {
    if (isWide) {
      a_.movdqu(x86::xmm0, x86::xmmword_ptr(x86::rcx, byte));
      a_.pand(x86::xmm0, x86::xmm3);
      a_.pxor(x86::xmm1, x86::xmm1);
      a_.psubb(x86::xmm1, x86::xmm0);
      a_.movdqu(at(place, 16), x86::xmm1);
    } else {
      a_.movzx(x86::eax, x86::byte_ptr(x86::rcx, byte));
      a_.and_(x86::eax, 1);
      a_.neg(x86::eax);
      a_.mov(at(place, 1), x86::al);
    }
  });
}

/// The other bits of their bytes stay as they are.
void X86Emitter::saveSingles(const std::vector<bool>& isWritten) {
  moveSingles([&](std::size_t first, bool isWide, std::int32_t byte, std::size_t place) {
    const auto begin = isWritten.begin() + static_cast<std::ptrdiff_t>(first);
    const auto end = begin + static_cast<std::ptrdiff_t>(isWide ? together : 1);
    if (std::find(begin, end, true) == end) return;
    if (isWide) {
      a_.movdqu(x86::xmm0, at(place, 16));
      a_.pand(x86::xmm0, x86::xmm3);
      a_.movdqu(x86::xmm1, x86::xmmword_ptr(x86::rcx, byte));
      a_.movdqa(x86::xmm2, x86::xmm3);
      a_.pandn(x86::xmm2, x86::xmm1);
      a_.por(x86::xmm0, x86::xmm2);
      a_.movdqu(x86::xmmword_ptr(x86::rcx, byte), x86::xmm0);
    } else {
      a_.movzx(x86::eax, at(place, 1));
      a_.and_(x86::eax, 1);
      a_.movzx(x86::edx, x86::byte_ptr(x86::rcx, byte));
      a_.and_(x86::edx, 0xFE);
      a_.or_(x86::eax, x86::edx);
      a_.mov(x86::byte_ptr(x86::rcx, byte), x86::al);
    }
  });
}

void X86Emitter::loadSlots() {
  loadSingles();
  a_.mov(x86::rdx, imm(spreadBytes.data()));
  std::optional<Area> area;
  for (std::size_t i = 0; i < code_.slots.size(); ++i) {
    const SlotByte& slot = code_.slots[i];
    if (slotPlaces_[i].isSingle) continue;
    if (std::exchange(area, slot.area) != slot.area) holdArea(slot.area);
    a_.movzx(x86::eax, x86::byte_ptr(x86::rcx, static_cast<std::int32_t>(slot.byte)));
    a_.mov(x86::rax, x86::ptr(x86::rdx, x86::rax, 3));
    a_.mov(at(static_cast<std::size_t>(slotAt(8 * i))), x86::rax);
  }
}

/// Local memory is nobody's behind the program.
void X86Emitter::saveSlots() {
  std::vector<bool> isWritten(code_.slots.size(), false);
  for (std::size_t i = 0; i < code_.steps.size(); ++i) {
    const Step& s = code_.steps[i];
    const bool isStore = isNeeded_[i] && (s.op == CodeOp::StoreBit || s.op == CodeOp::StoreSlots);
    if (isStore && code_.slots[s.value / 8].area != Area::L) isWritten[s.value / 8] = true;
  }
  saveSingles(isWritten);
  std::optional<Area> area;
  for (std::size_t i = 0; i < code_.slots.size(); ++i) {
    if (!isWritten[i] || slotPlaces_[i].isSingle) continue;
    const SlotByte& slot = code_.slots[i];
    if (std::exchange(area, slot.area) != slot.area) holdArea(slot.area);
    a_.movq(x86::xmm0, at(static_cast<std::size_t>(slotAt(8 * i))));
    a_.pmovmskb(x86::eax, x86::xmm0);
    a_.mov(x86::byte_ptr(x86::rcx, static_cast<std::int32_t>(slot.byte)), x86::al);
  }
}

void X86Emitter::storeSlots(const Step& s) {
  if (const auto constant = immediate(s.a); constant && *constant == 0)
    return void(a_.mov(at(static_cast<std::size_t>(slotAt(s.value))), 0));
  const Gp byte = values_.take(s.a), spread = values_.fresh();
  a_.mov(spread, imm(spreadBytes.data()));
  a_.mov(byte, x86::ptr(spread, byte, 3));
  a_.mov(at(static_cast<std::size_t>(slotAt(s.value))), byte);
}

}  // namespace rungproof::compiled
