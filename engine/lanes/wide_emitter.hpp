// WideEmitter: recorded code as instructions of AVX-512 for groups of 64 traces. A truth value is 64 bits in a general
// register, a bit for each trace; numbers stand in registers of 512 bits in the order of the traces, and are chosen and
// compared by mask registers. A number that all traces have in common (LaneFlow) is one in a general register. Branches
// are followed as LaneEmitter does, by masks of those that run; but one on a common value is a jump.
#pragma once

#include <map>
#include <unordered_map>

#include "engine/lanes/register_pool.hpp"
#include "engine/lanes/step_emitter.hpp"

namespace rungproof::lanes {

/// Numbers of all traces: registers, or places in memory.
struct WideNumber {
  Rep rep = Rep::Byte;
  std::array<asmjit::Operand, mostPieces> piece{};
};

class WideEmitter : public StepEmitter<WideEmitter, WideNumber> {
 public:
  explicit WideEmitter(const Translation& translation) : StepEmitter(translation, true) {}

 private:
  friend StepEmitter;
  using Zmm = asmjit::x86::Zmm;
  using Mask = asmjit::x86::KReg;
  using Number = WideNumber;
  using Masks = std::array<Mask, mostPieces>;

  // wide_emitter.cpp
  void begin();
  void end() { spreadRegisters(); }
  void spreadRegisters();
  std::optional<std::size_t> oneNumber(std::uint64_t reg) const;
  void branch(const Step& s);
  void branchForward(const Step& s);
  void branchBack(const Step& s);
  void jump(const Step& s);
  Gp takers(const Step& s);
  void join(std::size_t waiting);
  void skipIfNobody(std::uint32_t block);
  void count(const Step& s);
  void leave(const Step& s);
  void leave(const Gp& who);
  void leaveAll();
  void keep(ValueId id);

  // wide_values.cpp
  void value(ValueId id);
  Number numberOf(const Step& s);
  Number arithmetic(const Step& s);
  Number select(const Step& s);
  Number sumUnlessOverflow(const Step& s, const Step& sum);
  Number joinOf(const Step& s);
  Number real(const Step& s);

  // wide_truths.cpp
  Gp truthOf(const Step& s);
  Gp testBit(const Step& s);
  Gp comparison(const Step& s);
  Gp overflow(const Step& s);
  Gp overflowByConstant(const Step& s, const Number& a, std::uint64_t constant);
  Gp realTruth(const Step& s);

  // wide_scalars.cpp
  bool isScalar(ValueId id) const;
  Gp scalar(ValueId id);
  Gp scalarOf(const Step& s);
  Gp scalarTruth(const Step& s);
  Gp cutScalar(const Gp& value, int width);
  Gp copied(const Gp& value);
  Gp loadScalar(const Step& s);
  Gp loadScalar(std::size_t offset, Rep rep);
  Number broadcast(const Gp& value, Rep rep);

  // wide_memory.cpp
  Number loadSlots(const Step& s);
  Number together(const Number& high, const Number& low);
  void storeByteOf(const Number& value, std::uint32_t k, const Mem& to, const Mask* mask);
  void store(const Step& s);
  void storeRow(Row row, ValueId id);
  void storeMerged(Row row, const Step& choice);
  void storeTruth(std::size_t offset, const Gp& value);
  void storeNumber(std::size_t offset, const Number& value);
  void storePiece(const Mem& to, const Zmm& value, Rep rep, const Mask* mask);
  void storeMemory(const Step& s);
  void storeSlots(const Step& s);
  void saveActive();
  /// Mask registers do not outlast a call: what stands in them only is brought to general ones.
  void beforeCall() { thinMasks(0); }
  Gp commonPlace(const Step& s, const asmjit::Label& differ);
  Number loadAt(const Step& s);
  void storeAt(const Step& s);
  void leaveWhereGuarded(const Step& s);
  Mem placeAt(const Gp& place, Area area, std::uint32_t byte);

  // wide_held.cpp
  Gp freshGp();
  Zmm freshZmm();
  Mask freshMask();
  void holdTruth(ValueId id, const Gp& value);
  void holdScalar(ValueId id, const Gp& value);
  void holdNumber(ValueId id, const Number& value);
  void holdMasks(ValueId id, Rep rep, const Masks& masks);
  void holdCopy(std::size_t place, const Zmm& value);
  void thinMasks(std::size_t most);
  void release();
  void forgetAll();
  void drop(const Number& value);
  void dropNumber(std::uint64_t key);
  /// Values that are read from a place in memory each time are loaded before it is written.
  void beforeStore(std::size_t first, std::size_t count);

  // wide_vectors.cpp
  /// A truth value, or the lowest bit of a number; in a register, or where it stands in memory.
  Gp truth(ValueId id);
  asmjit::Operand truthSource(ValueId id);
  void readHere(ValueId id);
  Gp writable(ValueId id);
  /// As a number of that form.
  Number use(ValueId id, Rep rep);
  Number made(ValueId id);
  Masks masksOf(ValueId id, Rep rep);
  Masks masksFrom(const asmjit::Operand& truth, Rep rep);
  Gp truthFrom(const Masks& masks, Rep rep);
  std::optional<std::size_t> placeOf(const asmjit::Operand& piece) const;
  asmjit::Operand source(const asmjit::Operand& piece);
  Zmm inRegister(const asmjit::Operand& piece);
  void save(std::size_t offset, const Number& value);
  Number each(InstId id, const Number& a, const Number& b);
  Masks compared(InstId id, const Number& a, const Number& b, std::uint32_t how);
  Masks tested(const Number& a, const Number& bits);
  Number constant(std::uint64_t value, Rep rep);
  /// Read from its place each time.
  Number loaded(Row row);
  /// Read at once, in registers.
  Number copyOf(Row row);
  Number widened(const Number& value);
  Number narrowed(const Number& value);
  Number cut(const Number& value, int width);
  /// The lowest bits in the form `rep`.
  Number fit(Number value, Rep rep, int width);
  Number shifted(const Number& value, bool isLeft, std::uint32_t count);
  Mem at(std::size_t offset, std::uint32_t bytes = wideBytes) { return StepEmitter::at(offset, bytes); }

  static std::uint64_t keyOf(ValueId id, Rep rep) { return std::uint64_t{id} << 3 | static_cast<std::uint64_t>(rep); }

  static std::uint64_t sumOf(CodeOp op, ValueId a, ValueId b) {
    return std::uint64_t{a} << 33 | std::uint64_t{b} << 1 | (op == CodeOp::Add ? 1 : 0);
  }

  Gp active_;  ///< traces that run; not of straight code

  RegisterPool<Gp> gps_;
  RegisterPool<Zmm> zmms_;
  RegisterPool<Mask> maskPool_;
  std::unordered_map<ValueId, Gp> truths_, scalars_;
  std::unordered_map<std::uint64_t, Number> numbers_;  ///< by value and form
  std::unordered_map<std::uint64_t, Masks> masks_;     ///< by value and form
  std::vector<std::uint64_t> recentMasks_;             ///< keys of masks_, the oldest first
  std::unordered_map<ValueId, std::size_t> slotOf_;    ///< truth values that stand in memory
  std::multimap<std::size_t, ValueId> readAt_;         ///< values by the place where they stand
  struct Copy {
    Zmm reg;
    ValueId usedAt;  ///< step that has used it last
  };
  std::map<std::size_t, Copy> copies_;               ///< by place: what has been read there a short while ago
  std::unordered_map<std::uint64_t, ValueId> sums_;  ///< by operands: Add or Sub of this block
};

}  // namespace rungproof::lanes
