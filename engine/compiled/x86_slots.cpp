// Bits of memory that have bytes of their own while the machine code runs: out of their bytes before the program, and
// back behind it.
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

void X86Emitter::loadSlots() {
  a_.mov(x86::rdx, imm(spreadBytes.data()));
  std::optional<Area> area;
  for (std::size_t i = 0; i < code_.slots.size(); ++i) {
    const SlotByte& slot = code_.slots[i];
    if (std::exchange(area, slot.area) != slot.area)
      a_.mov(x86::rcx, at(offsetof(Workspace, area) + 8 * static_cast<std::size_t>(slot.area)));
    a_.movzx(x86::eax, x86::byte_ptr(x86::rcx, static_cast<std::int32_t>(slot.byte)));
    a_.mov(x86::rax, x86::ptr(x86::rdx, x86::rax, 3));
    a_.mov(at(layout_.slots + 8 * i), x86::rax);
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
  std::optional<Area> area;
  for (std::size_t i = 0; i < code_.slots.size(); ++i) {
    if (!isWritten[i]) continue;
    const SlotByte& slot = code_.slots[i];
    if (std::exchange(area, slot.area) != slot.area)
      a_.mov(x86::rcx, at(offsetof(Workspace, area) + 8 * static_cast<std::size_t>(slot.area)));
    a_.movq(x86::xmm0, at(layout_.slots + 8 * i));
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
