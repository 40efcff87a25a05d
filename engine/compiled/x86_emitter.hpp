// Emitter for x86-64: goes through the code once and gives every needed step its machine instructions. A bit in memory
// is an operand of the instruction that uses it, as long as nothing was stored there since. Fixed registers: rbp the
// workspace, r14 the machine's registers, r13 and r15 the areas that are used most, r12 the time.
#pragma once

#include <asmjit/x86.h>

#include <unordered_map>

#include "engine/compiled/emitter.hpp"
#include "engine/compiled/x86_registers.hpp"

namespace rungproof::compiled {

class X86Emitter {
 public:
  X86Emitter(const Code& code, const std::vector<bool>& isNeeded, asmjit::CodeHolder& holder);
  /// Where things stand in the workspace; nothing: the library could not do it.
  std::optional<Layout> emit();

 private:
  using Gp = asmjit::x86::Gp;
  using Mem = asmjit::x86::Mem;
  using Cond = asmjit::x86::CondCode;

  /// One that most steps load from or store to.
  struct HeldArea {
    Area area;
    X86Base base;
  };

  // x86_emitter.cpp
  Layout layoutOf() const;
  static std::vector<Gp> valueRegisters(const Code& code);
  static std::array<HeldArea, 2> busiestAreas(const Code& code, const std::vector<bool>& isNeeded);
  void findStores();
  void prologue();
  void epilogue();
  void step(ValueId id);
  void store(const Step& step);
  void storeWord(const Step& step);
  void control(const Step& step);
  Mem memory(Area area, std::uint64_t byte, std::uint32_t size);
  std::int32_t slotAt(std::uint64_t number) const {
    const SlotPlace& place = slotPlaces_[number / 8];
    return static_cast<std::int32_t>(place.isSingle ? layout_.singles + place.index
                                                    : layout_.slots + 8 * place.index + number % 8);
  }
  std::int32_t stateAt(std::uint64_t number) const { return static_cast<std::int32_t>(layout_.states + 8 * number); }
  Mem at(std::size_t offset, std::uint32_t size = 8) { return workspace_.at(offset, size); }
  Mem registerAt(std::uint64_t index) {
    return asmjit::x86::ptr(asmjit::x86::r14, static_cast<std::int32_t>(4 * index), 4);
  }
  X86Base baseOf(Area area);
  asmjit::Label& label(std::uint64_t mark);

  // x86_slots.cpp
  /// Where the bits of one of Code::slots stand: a byte alone, or eight.
  struct SlotPlace {
    bool isSingle = false;
    std::size_t index = 0;  ///< among those of its kind
  };
  /// Bytes of one area that follow each other, in memory and among the singles.
  struct SingleRun {
    std::size_t first = 0, count = 0;  ///< indexes into Code::slots
  };
  static std::vector<SlotPlace> placesOfSlots(const Code& code);
  std::vector<SingleRun> singleRuns() const;
  void holdArea(Area area);
  template <class Move>
  void moveSingles(Move&& move);
  void loadSingles();
  void saveSingles(const std::vector<bool>& isWritten);
  void loadSlots();
  void saveSlots();
  void storeSlots(const Step& step);

  // x86_values.cpp
  void value(ValueId id);
  void truth(ValueId id, const Step& step);
  void compared(ValueId id, Cond holds);
  void arithmetic(ValueId id, const Step& step);
  void replaceBit(ValueId id, const Step& step);
  void select(ValueId id, const Step& step);
  void call(ValueId id, const Step& step);
  void shift(ValueId id, const Step& step);
  void real(ValueId id, const Step& step);
  void load(ValueId id, const Step& step);
  void loadMemory(ValueId id, const Step& step);
  void keepWidth(Gp reg, int width);
  std::optional<std::int32_t> immediate(ValueId id) const;

  // x86_flags.cpp
  std::vector<ValueId> emittedAt();
  void findSums(const std::vector<ValueId>& uses);
  void findReplacedBits(const std::vector<ValueId>& uses, std::vector<ValueId>& at) const;
  bool asksOpposite(const Step& step) const;
  void findLowUses();
  bool keepsFlags(const Step& step) const;
  void sum(ValueId id, const Step& step);
  void addTo(Gp reg, const Step& step);
  void clearHigh(Gp reg, ValueId id);
  static Gp sized(Gp reg, int width);
  std::optional<std::int32_t> signedConstant(ValueId id, int width) const;
  /// Sets the flags and says under which condition the value holds.
  Cond condition(ValueId id);
  Cond comparison(const Step& step);
  void truthMade(ValueId id) {
    flagsOf_ = id;
    flagsHold_ = Cond::kNZ;
  }

  // x86_errors.cpp
  /// What a bit tells of a sum.
  enum class Told : std::uint8_t { Overflow, Fits, Zero, Negative };
  struct Seldom {
    std::vector<ValueId> steps;                            ///< that are made together with the sum
    std::optional<std::uint64_t> site;                     ///< error that is an overflow
    ValueId result = 0;                                    ///< the sum, or where it overflows its first operand
    std::vector<std::pair<std::uint64_t, Told>> stores{};  ///< to slots
  };
  std::optional<Seldom> seldomOf(ValueId sum, const std::vector<ValueId>& uses) const;
  void sumThatFits(ValueId id, const Step& step);
  void sumsThatOverflow();
  void count(const Step& step);
  void countAt(std::uint64_t site);
  void countErrors();

  const Code& code_;
  const std::vector<bool>& isNeeded_;
  const std::vector<SlotPlace> slotPlaces_;  ///< by index into Code::slots
  const Layout layout_;
  const std::array<HeldArea, 2> heldAreas_;
  const bool hasMovbe_;
  std::vector<ValueId> overflowOf_;             ///< by sum: whether it overflows, 0: nobody asks
  std::unordered_map<ValueId, Seldom> seldom_;  ///< by sum: if all who ask for it are made with it
  std::vector<bool> isFlagOnly_;                ///< by overflow of a sum: the processor's flags are enough
  std::vector<bool> seesHigh_;                  ///< by value: whether what stands above 16 bits matters
  const std::vector<ValueId> emittedAt_;        ///< by step: itself, or the step that needs the comparison
  asmjit::x86::Assembler a_;
  const X86Base workspace_;
  X86Registers values_;
  std::unordered_map<std::uint64_t, asmjit::Label> labels_;
  asmjit::Label leave_;
  ValueId position_ = 0;        ///< step that is being emitted
  ValueId flagsOf_ = 0;         ///< truth value whose test the processor's flags hold, or 0
  Cond flagsHold_ = Cond::kNZ;  ///< where it is on
  struct Happened {             ///< code out of the way, which counts an error
    std::uint64_t site;
    asmjit::Label from, back;
  };
  std::vector<Happened> happened_;
  struct Overflowed {
    ValueId sum;
    Gp reg, second;  ///< where the sum stands, and the second operand if it is no constant
    asmjit::Label from, back;
  };
  std::vector<Overflowed> overflowed_;
  asmjit::Label count_;              ///< counts the error of which the site stands in eax
  std::vector<ValueId> standsTo_;    ///< by step that loads or stores a bit: up to where its slot keeps the value
  std::vector<ValueId> markBehind_;  ///< by branch: the next Mark
};

}  // namespace rungproof::compiled
