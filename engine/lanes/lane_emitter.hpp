// LaneEmitter: recorded code as instructions of AVX2, for groups of 32 traces, or 256 where there are truth values
// only. A truth value is a register of masks.
#pragma once

#include <unordered_map>

#include "engine/lanes/register_pool.hpp"
#include "engine/lanes/step_emitter.hpp"

namespace rungproof::lanes {

/// Registers of one form.
struct Vec {
  Rep rep = Rep::Truth;
  std::array<asmjit::x86::Ymm, mostPieces> piece{};
};

class LaneEmitter : public StepEmitter<LaneEmitter, Vec> {
 public:
  explicit LaneEmitter(const Translation& translation) : StepEmitter(translation, false) {}

 private:
  friend StepEmitter;
  using Ymm = asmjit::x86::Ymm;

  // lane_emitter.cpp
  void begin();
  void end() {}
  void store(const Step& s);
  void branch(const Step& s);
  void branchForward(const Step& s);
  void branchBack(const Step& s);
  Ymm takers(const Step& s);
  void wait(std::size_t row, const Ymm& who);
  void join(std::size_t waiting);
  void skipIfNobody(std::uint32_t block);
  void leave(const Step& s);
  void leaveAll();
  void count(const Step& s);
  void keep(ValueId id, const Vec& value);

  // lane_values.cpp
  void value(ValueId id);
  Vec valueOf(const Step& s);
  Vec numberOf(const Step& s);
  Vec truth(const Step& s);
  Vec testBit(const Step& s);
  Vec comparison(const Step& s);
  Vec overflow(const Step& s);
  Vec signOf(const Vec& number);
  Vec lessOf(const Step& s, Rep rep);
  Vec arithmetic(const Step& s);
  Vec bitwise(const Step& s);
  Vec select(const Step& s);
  Vec real(const Step& s);
  Vec joinOf(const Step& s);

  // lane_memory.cpp
  Vec loadSlots(const Step& s);
  Vec together(const Vec& high, const Vec& low);
  Vec byteOf(const Vec& value, std::uint32_t k);
  Gp commonPlace(const Step& s, const asmjit::Label& differ);
  Vec loadAt(const Step& s);
  void storeAt(const Step& s);
  void storeMemory(const Step& s);
  void storeSlots(const Step& s);
  void storeRow(Row row, const Vec& value);
  void saveActive() { save(layout_.active(), active_); }
  /// Vector registers outlast a call, as far as the code library sees to it.
  void beforeCall() {}

  // lane_vectors.cpp
  Ymm fresh() {
    return ymms_.take([&] { return c_.newYmm(); });
  }
  void hold(ValueId id, Rep rep, bool isMask, const Vec& value);
  void release();
  void forgetAll();
  /// A value of this or an earlier block, as a number or, of a truth value, as masks of such numbers.
  Vec use(ValueId id, Rep rep, bool isMask = false);
  Vec made(ValueId id);
  Vec loaded(Row row);
  Vec copyOf(Row row) { return loaded(row); }
  Vec constant(std::uint64_t value, Rep rep);
  Mem constantRow(std::uint64_t value, Rep rep);
  Vec widened(const Vec& value, bool isMask);
  Vec narrowed(const Vec& value, bool isMask);
  Vec toTruth(Vec mask);
  /// Where numbers are 1.
  Vec isOne(const Vec& number);
  Vec cut(const Vec& value, int width);
  /// The lowest bits in the form `rep`.
  Vec fit(Vec value, Rep rep, int width);
  Vec shifted(const Vec& value, bool isLeft, std::uint32_t count);
  Vec each(InstId id, const Vec& a, const Vec& b);
  Vec each(InstId id, const Vec& a, const Mem& b);
  Ymm inverted(const Ymm& truth);
  Ymm chosen(const Ymm& mask, const Ymm& ifOn, const Ymm& ifOff);
  Ymm op(InstId id, const asmjit::Operand& a, const asmjit::Operand& b);
  Ymm load(std::size_t offset);
  void save(std::size_t offset, const Ymm& value);
  void save(std::size_t offset, const Vec& value);
  Mem at(std::size_t offset, std::uint32_t bytes = rowBytes) { return StepEmitter::at(offset, bytes); }

  Ymm active_;                                     ///< traces that run; not of straight code
  std::unordered_map<std::uint64_t, Vec> values_;  ///< of this block, by value, form, and if it is a mask
  RegisterPool<Ymm> ymms_;
};

}  // namespace rungproof::lanes
