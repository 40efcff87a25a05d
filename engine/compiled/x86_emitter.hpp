// Emitter for x86-64: goes through the code once and gives every needed step its machine instructions; which registers
// they use is left to the library's allocator. A bit in memory is an operand of the instruction that uses it, as long
// as nothing was stored there since.
#pragma once

#include <asmjit/x86.h>

#include <optional>
#include <unordered_map>

#include "engine/compiled/emitter.hpp"

namespace rungproof::compiled {

class X86Emitter {
 public:
  X86Emitter(const Code& code, const std::vector<bool>& isNeeded, asmjit::CodeHolder& holder);
  /// False: the library could not do it.
  bool emit();

 private:
  using Gp = asmjit::x86::Gp;
  using Mem = asmjit::x86::Mem;
  using Cond = asmjit::x86::CondCode;

  // x86_emitter.cpp
  void findLifetimes();
  void prologue();
  void epilogue();
  void step(ValueId id);
  void store(const Step& step);
  void control(const Step& step);
  void count(const Step& step);
  Mem memory(Area area, std::uint64_t byte, std::uint32_t size);
  Mem slot(std::uint64_t number, std::uint32_t size = 1) {
    return asmjit::x86::ptr(slots_, static_cast<std::int32_t>(number), size);
  }
  Mem registerAt(std::uint64_t index) { return asmjit::x86::ptr(registers_, static_cast<std::int32_t>(4 * index), 4); }
  Mem field(std::size_t offset, std::uint32_t size = 8) {
    return asmjit::x86::ptr(workspace_, static_cast<std::int32_t>(offset), size);
  }
  Gp baseOf(Area area);
  asmjit::Label& label(std::uint64_t mark);

  // x86_values.cpp
  void value(ValueId id);
  void truth(ValueId id, const Step& step);
  void arithmetic(ValueId id, const Step& step);
  void division(ValueId id, const Step& step);
  void shift(ValueId id, const Step& step);
  void real(ValueId id, const Step& step);
  void callReal(ValueId id, const Step& step);
  void load(ValueId id, const Step& step);
  void keepWidth(Gp reg, int width);
  /// Sets the flags and says under which condition the value holds.
  Cond condition(ValueId id);
  Cond comparison(const Step& step);
  bool isComparison(ValueId id) const;

  /// A use of the value; the register must not be changed.
  Gp use(ValueId id);
  /// The last or any use of the value in a register that may be changed.
  Gp take(ValueId id);
  /// A truth value as an operand of 8 bits: a register, or where it stands in memory.
  asmjit::Operand byteOperand(ValueId id);
  std::optional<std::uint64_t> slotHolding(ValueId id) const;
  std::optional<std::int32_t> immediate(ValueId id) const;
  void define(ValueId id, Gp reg) {
    regs_[id] = reg;
    touched_[id] = position_;
  }
  Gp fresh() { return cc_.newUInt64(); }

  const Code& code_;
  const std::vector<bool>& isNeeded_;
  asmjit::x86::Compiler cc_;
  bool hasMovbe_;
  Gp workspace_, slots_, registers_, time_;
  std::array<Gp, areaCount> bases_;
  std::unordered_map<std::uint64_t, asmjit::Label> labels_;
  std::unordered_map<std::uint64_t, Gp> states_;
  asmjit::Label leave_;

  ValueId position_ = 0;             ///< step that is being emitted
  std::vector<std::uint32_t> uses_;  ///< that are still to come
  std::vector<ValueId> lastUse_;
  std::vector<ValueId> touched_;  ///< where the register of a value was used last
  std::vector<Gp> regs_;
  std::vector<bool> isInMemory_;  ///< LoadBit whose slot keeps the value up to the last use
  std::vector<bool> isDeferred_;  ///< a comparison that its only user makes
  struct Home {
    std::uint64_t slot;
    ValueId until;  ///< step that overwrites it, or at which other ways join
  };
  std::unordered_map<ValueId, Home> homes_;  ///< truth values that were stored
  std::vector<ValueId> homeEnd_;             ///< by StoreBit: the Home::until that it gives
};

}  // namespace rungproof::compiled
