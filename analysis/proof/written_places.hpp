// Which write may give a read its value: by address, through a pointer, or through the instance of a function block.
// Of data in instances it is known which block's they are: unless the program moves DI or AR2 itself, two function
// blocks share a byte only where one is a multi-instance in the other. Covered by tests/prover/networks_test.cpp.
#pragma once

#include <unordered_map>
#include <vector>

#include "analysis/flow/facts.hpp"

namespace rungproof {

class WrittenPlaces {
 public:
  explicit WrittenPlaces(const Facts& facts);

  /// Calls `take` with each access that may write what `read` reads; `block`: whose local memory L is.
  template <class Take>
  void eachWriter(const Access& read, std::uint32_t block, Take&& take) const;

 private:
  /// What is known of a place in data blocks.
  struct DataPlace {
    enum class Kind : std::uint8_t { Instance, Numbered, Any } kind = Kind::Any;
    std::uint32_t block = noBlock;  ///< function block whose data it is; Numbered: of whose instance, or noBlock
    std::uint32_t firstBit = 0, bits = 0;
  };

  void findNesting();
  void findMovedInstances();
  bool holds(std::uint32_t outer, std::uint32_t inner) const { return nested_[outer][inner]; }
  DataPlace dataPlaceOf(const Access& access) const;
  bool mayMeetInData(const Access& read, const Access& write) const;
  /// Whether the pointer of one of the two may lead to what the other one means.
  bool mayMeet(const Access& read, const Access& write) const;
  bool mayBeReached(Area area) const { return numbersArePointers_ ? !addressedByNumber(area) : mayBePointedTo(area); }
  static bool overlap(const Access& a, const Access& b);
  /// The accesses of a cell that write; many may only read it.
  const std::vector<std::uint32_t>& writesAt(std::uint32_t cell) const;

  const Facts& facts_;
  bool numbersArePointers_;
  bool movesInstances_ = false;            ///< any function block may work on any data block
  std::vector<std::vector<bool>> nested_;  ///< by block, by block: has it as a multi-instance, at any depth
  std::vector<std::uint32_t> pointed_;     ///< writes through pointers
  std::vector<std::uint32_t> long_;        ///< writes that the lists of the cells do not show
  mutable std::unordered_map<std::uint32_t, std::vector<std::uint32_t>> writesAt_;  ///< by cell that was asked for
};

template <class Take>
void WrittenPlaces::eachWriter(const Access& read, std::uint32_t block, Take&& take) const {
  for (const std::uint32_t i : pointed_) {
    if (mayMeet(read, facts_.access(i))) take(facts_.access(i));
  }
  if (read.viaPointer) {
    for (const Access& access : facts_.accesses().all()) {
      if ((access.write || access.maybe) && !access.viaPointer && mayMeet(read, access)) take(access);
    }
    return;
  }
  const AccessIndex& index = facts_.index();
  for (std::uint32_t i = 0; i < std::max<std::uint32_t>(read.possibleLength(), 1); ++i) {
    const std::uint32_t cell = index.cells().cell(read.area, read.offset + i, block);
    if (cell >= index.cells().size()) continue;
    for (const std::uint32_t at : writesAt(cell)) {
      if (overlap(read, facts_.access(at))) take(facts_.access(at));
    }
  }
  for (const std::uint32_t i : long_) {
    if (overlap(read, facts_.access(i))) take(facts_.access(i));
  }
}

}  // namespace rungproof
