// Which value stands in which register of an x86-64 while code is emitted from its first step to its last. A value that
// has to give way goes to a place of its own in the workspace, unless it stands somewhere already: a truth value that
// was stored stands in its slot, a constant in the instruction. Of several the one that is needed last gives way.
#pragma once

#include <asmjit/x86.h>

#include <functional>
#include <optional>
#include <queue>
#include <vector>

#include "engine/compiled/code.hpp"
#include "engine/compiled/x86_base.hpp"

namespace rungproof::compiled {

class X86Registers {
 public:
  using Gp = asmjit::x86::Gp;
  using Mem = asmjit::x86::Mem;

  /// `registers`: those that values may stand in. `places`: byte of the workspace from which on they give way to.
  /// `emittedAt`: by step, where it is emitted (comparisons: where their result is needed); needed steps only count.
  X86Registers(asmjit::x86::Assembler& assembler, const X86Base& workspace, std::vector<Gp> registers,
               std::int32_t places, const Code& code, const std::vector<bool>& isNeeded,
               const std::vector<ValueId>& emittedAt);

  /// Steps are emitted in their order; what was used in the one before may give way again.
  void begin(ValueId step);

  /// The value in a register that must not be changed.
  Gp use(ValueId id);
  /// The value in a register that may be changed.
  Gp take(ValueId id);
  /// A register for something new.
  Gp fresh();
  void define(ValueId id, Gp reg);
  /// A truth value as an operand of 8 bits.
  asmjit::Operand byteOperand(ValueId id);
  bool isInRegister(ValueId id) const { return registerOf_[id] >= 0; }
  bool isConstant(ValueId id) const;
  ValueId lastUse(ValueId id) const { return lastUse_[id]; }

  /// The value stands at that byte of the workspace up to step `until`.
  void stands(ValueId id, std::int32_t at, ValueId until);
  /// Everything that is needed behind step `at` stands in memory from here on.
  void settle(ValueId at);
  /// Nothing stands in a register any more.
  void forget();
  /// Brings these values to the argument registers of a call, and everything else out of the way.
  void prepareCall(std::initializer_list<ValueId> arguments);

  /// Places in the workspace that were needed, 8 bytes each.
  std::size_t placeCount() const { return places_; }

 private:
  static constexpr int none = -1;
  struct Slot {
    std::int32_t at = 0;
    ValueId until = 0;
    bool isThere = false;
  };
  std::optional<Mem> memory(ValueId id, std::uint32_t size) const;
  Mem place(ValueId id, std::uint32_t size) const {
    return workspace_.at(static_cast<std::uint64_t>(placesAt_ + 8 * placeOf_[id]), size);
  }
  void load(ValueId id, Gp reg);
  void giveWay(std::size_t reg);
  std::size_t freeOne();
  std::size_t indexOf(Gp reg) const;
  ValueId nextUse(ValueId id);
  void lastUseInLoops();

  asmjit::x86::Assembler& a_;
  X86Base workspace_;
  std::vector<Gp> registers_;
  std::int32_t placesAt_;
  const Code& code_;
  ValueId step_ = 0;
  std::vector<ValueId> content_;   ///< by register: the value, or 0
  std::vector<ValueId> lockedIn_;  ///< by register: step that uses it
  std::vector<std::int8_t> registerOf_;
  std::vector<Slot> slots_;            ///< by value
  std::vector<std::int32_t> placeOf_;  ///< by value: number of its place, or none
  std::vector<std::int32_t> freePlaces_;
  /// Values that have places, the one that is needed least long on top.
  std::priority_queue<std::pair<ValueId, ValueId>, std::vector<std::pair<ValueId, ValueId>>, std::greater<>> placed_;
  std::size_t places_ = 0;
  std::vector<std::uint32_t> firstUse_, cursor_;
  std::vector<ValueId> uses_, lastUse_;
};

}  // namespace rungproof::compiled
