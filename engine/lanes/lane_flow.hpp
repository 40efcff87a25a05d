// LaneFlow: what is found out about recorded code before vector instructions are made of it: its blocks, where traces
// may wait elsewhere meanwhile, which values other blocks use and where a value is used for the last time. Where it is
// asked for, also which values all traces have in common: what follows from constants alone, where all of them went the
// same way. Such a value is one number, a branch on it one jump. Straight code has parts in place of blocks.
#pragma once

#include <unordered_map>
#include <unordered_set>

#include "engine/lanes/lane_layout.hpp"

namespace rungproof::lanes {

class LaneFlow {
 public:
  /// `mostOfPart`: needed steps of a part of straight code.
  LaneFlow(const Code& code, const std::vector<bool>& isNeeded, bool seesCommon, std::size_t mostOfPart);

  std::vector<std::uint32_t> blockOf;                   ///< by step
  std::uint32_t lastBlock = 0;                          ///< number of it
  std::unordered_set<ValueId> partsAt;                  ///< first steps of the second part and those behind it
  std::vector<bool> isMaskedAt;                         ///< by step: traces may wait elsewhere meanwhile
  std::vector<bool> isInLoop;                           ///< by step: of which traces may leave in different rounds
  std::unordered_map<std::uint64_t, ValueId> markAt;    ///< by number of the mark
  std::unordered_map<ValueId, std::size_t> goOnBehind;  ///< by branch back: row of those that go on there
  /// Values that other blocks use: row, or number of a truth value. Some need not be kept: they are read once more.
  std::unordered_map<ValueId, std::size_t> keptAt;
  std::unordered_set<ValueId> readAgain;
  std::size_t keptRows = 0, keptTruths = 0;
  std::vector<bool> isFolded;                    ///< negations that only And of their block uses
  std::unordered_map<ValueId, ValueId> takenAt;  ///< SelectBit: And of its condition and of what it chooses
  std::unordered_map<ValueId, ValueId> sumAt;    ///< Select: the sum that it makes itself, where that does not overflow
  /// Select: only a store wants it, a choice between a new value and what stands there already.
  std::unordered_set<ValueId> merged;
  std::vector<bool> isDeferred;              ///< such sums and choices: made where they are used
  std::vector<bool> isFit;                   ///< overflows that are held as their opposite
  std::vector<bool> isPatched;               ///< upper parts of numbers that only get other lower parts
  std::vector<std::vector<ValueId>> endsAt;  ///< by step: values that the block uses no more
  std::vector<bool> isCommon;                ///< by step: a value, or the way that a branch takes
  struct Guarded {
    Area area;
    std::uint32_t first, count;
  };
  std::vector<Guarded> guarded;  ///< memory of which it is taken for granted that no computed address leads there
  /// Registers, each with a row that holds it as one number while the code runs: the last value is common, and who
  /// reads it before finds it common too.
  std::unordered_map<std::uint64_t, std::size_t> oneNumberAt;
  std::unordered_set<std::uint64_t> joins;  ///< numbers of marks that traces may wait for

 private:
  void findBlocks();
  void findParts(std::size_t mostOfPart);
  void findMasks();
  void findCommon();
  bool narrowCommon();
  void findGuarded();
  void findRegisters();
  bool isGuarded(Area area, std::uint64_t byte) const;
  void findKept();
  void findNextStores();
  void findFolded();
  void findTaken();
  void findSums();
  void findMerged();
  bool isSumUnlessOverflow(ValueId select) const;
  std::vector<std::uint32_t> useCounts() const;
  void findPatched();
  template <class Use>
  void eachOperand(const Step& s, Use&& use) const;
  void findEnds();

  std::vector<std::uint64_t> commonAtEnd_;  ///< registers
  std::vector<ValueId>
      nextStore_;  ///< by step of straight code that reads memory: the next one that writes there; or 0
  const Code& code_;
  const std::vector<bool>& isNeeded_;
};

template <class Use>
void LaneFlow::eachOperand(const Step& s, Use&& use) const {
  const int operands = compiled::operandCount(s.op);
  if (operands > 0) use(s.a);
  if (operands > 1) use(s.b);
  if (operands > 2) use(s.c);
}

}  // namespace rungproof::lanes
