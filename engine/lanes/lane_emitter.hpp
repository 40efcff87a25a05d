// LaneEmitter: goes through recorded code once and gives every needed step its vector instructions (AVX2), for all
// traces of a group. Branches are followed by masks: active() says which traces run; those that branch wait in the row
// of their mark until control, which always goes on with the first block that anybody waits for, comes there. A value
// that another block uses is kept in a row; within a block the library finds registers.
#pragma once

#include <asmjit/x86.h>

#include <deque>
#include <optional>
#include <unordered_map>

#include "engine/lanes/lane_code.hpp"
#include "engine/lanes/lane_flow.hpp"

namespace rungproof::lanes {

class LaneEmitter {
 public:
  LaneEmitter(const Code& code, const std::vector<bool>& isNeeded, LaneLayout& layout, std::deque<StepByTrace>& byTrace,
              asmjit::CodeHolder& holder);
  /// False: the library could not do it.
  bool emit();

 private:
  using Gp = asmjit::x86::Gp;
  using Ymm = asmjit::x86::Ymm;
  using Mem = asmjit::x86::Mem;
  using InstId = asmjit::InstId;
  struct Vec {
    Rep rep = Rep::Truth;
    std::array<Ymm, mostPieces> piece{};
  };

  // lane_emitter.cpp
  void control(const Step& s);
  void store(const Step& s);
  void branchForward(const Step& s);
  void branchBack(const Step& s);
  Ymm takers(const Step& s);
  void wait(std::size_t row, const Ymm& who);
  void beginBlock(std::uint32_t block, std::size_t waiting);
  void skipIfNobody();
  void leave(const Step& s);
  void checkTime();
  void keep(ValueId id, const Vec& value);

  // lane_values.cpp
  void value(ValueId id);
  Vec valueOf(const Step& s);
  Vec truth(const Step& s);
  Vec testBit(const Step& s);
  Vec comparison(const Step& s);
  Vec overflow(const Step& s);
  Vec signOf(const Vec& number);
  Vec lessOf(const Step& s, Rep rep);
  Vec arithmetic(const Step& s);
  Vec select(const Step& s);
  Vec shift(const Step& s);
  Vec real(const Step& s);
  Vec extract(const Step& s);
  Vec join(const Step& s);
  Vec byTrace(const Step& s);

  // lane_memory.cpp
  Vec loadMemory(const Step& s);
  Vec loadSlots(const Step& s);
  Vec together(const Vec& high, const Vec& low);
  Vec byteOf(const Vec& value, std::uint32_t k);
  Gp commonPlace(const Step& s, const asmjit::Label& differ);
  Vec loadAt(const Step& s);
  void storeAt(const Step& s);
  void storeMemory(const Step& s);
  void storeSlots(const Step& s);
  void storeRow(Row row, const Vec& value);
  void callByTrace(const StepByTrace& by, Rep rep);

  // lane_vectors.cpp
  /// A register of the library's, of which there are as many as hold something at once.
  Ymm fresh();
  void hold(ValueId id, Rep rep, bool isMask, const Vec& value);
  void release();
  /// A value of this or an earlier block, as a number or, of a truth value, as masks of such numbers.
  Vec use(ValueId id, Rep rep, bool isMask = false);
  Vec made(ValueId id);
  Vec loaded(Row row);
  Vec constant(std::uint64_t value, Rep rep);
  Mem constantRow(std::uint64_t value, Rep rep);
  Vec widened(const Vec& value, bool isMask);
  Vec narrowed(const Vec& value, bool isMask);
  Vec toTruth(Vec mask);
  Vec cut(const Vec& value, int width);
  Vec shifted(const Vec& value, bool isLeft, std::uint32_t count);
  Vec each(InstId id, const Vec& a, const Vec& b);
  Vec each(InstId id, const Vec& a, const Mem& b);
  Ymm inverted(const Ymm& truth);
  Ymm chosen(const Ymm& mask, const Ymm& ifOn, const Ymm& ifOff);
  Ymm op(InstId id, const asmjit::Operand& a, const asmjit::Operand& b);
  Ymm load(std::size_t offset);
  void save(std::size_t offset, const Ymm& value);
  Mem at(std::size_t offset, std::uint32_t bytes = rowBytes);

  const Code& code_;
  const std::vector<bool>& isNeeded_;
  LaneLayout& layout_;
  std::deque<StepByTrace>& byTrace_;
  asmjit::x86::Compiler c_;
  Gp rows_;
  Gp position_;  ///< time that this scan has taken at most, 10 ns
  Ymm active_;   ///< traces that run; not of straight code

  const LaneFlow flow_;
  std::unordered_map<std::uint64_t, Vec> values_;  ///< of this block, by value, form, and if it is a mask
  static constexpr int isFree = -1;
  std::unordered_map<std::uint32_t, int> holders_;    ///< by register: how often it stands in values_
  std::unordered_map<std::uint32_t, Ymm> registers_;  ///< by number
  std::vector<Ymm> ofStep_, free_;                    ///< registers given out in this step; unused ones
  std::vector<asmjit::Label> labels_;                 ///< by block, and one behind the last
  ValueId step_ = 0;                                  ///< that is being emitted
};

}  // namespace rungproof::lanes
