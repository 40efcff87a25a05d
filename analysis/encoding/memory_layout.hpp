// How memory is cut into state variables: bytes that the program touches bit by bit become eight variables of one
// bit; bytes that it only touches as words stay words. A good cut keeps bit logic free of slices and arithmetic free
// of concatenations; any cut is correct.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "ir/machine/frame.hpp"
#include "ir/machine/plan.hpp"

namespace rungproof {

class MemoryLayout {
 public:
  /// Special memory is cut where the source of its values changes (ir/s7200/special_memory.hpp).
  /// Bytes of data blocks are counted in the one row of all blocks, except where accesses are added.
  explicit MemoryLayout(const Plan& plan);

  /// Takes the direct operands of the program into account, each in the width of its instruction.
  void add(const Program& program, const Plan& plan);
  /// One more access, for example of a property.
  void add(Area area, Width width, std::uint32_t byte);

  /// No word lies across the start of that byte.
  void beginAt(Area area, std::uint32_t byte);

  /// Size of an area in bytes.
  std::uint32_t size(Area area) const {
    return static_cast<std::uint32_t>(cuts_[static_cast<std::size_t>(area)].size());
  }
  /// Whether the program has `bytes` bytes from `byte` on.
  bool holds(Area area, std::uint32_t byte, std::uint32_t bytes) const {
    return inRow(area, byte) + bytes <= size(area);
  }
  bool isSingleBits(Area area, std::uint32_t byte) const { return cut(area, byte).isSingleBits; }
  /// First byte and number of bytes of the word that holds `byte`; at most four.
  struct Word {
    std::uint32_t first;
    std::uint32_t bytes;
  };
  Word wordOf(Area area, std::uint32_t byte) const;

 private:
  struct Cut {
    bool isSingleBits = false;
    bool joinsNext = false;   ///< some word covers this byte and the next
    bool startsHere = false;  ///< some word starts at this byte or ended before it
  };
  const Cut& cut(Area area, std::uint32_t byte) const { return cuts_[static_cast<std::size_t>(area)][byte]; }
  bool isJoined(Area area, std::uint32_t byte) const;

  std::uint32_t inRow(Area area, std::uint32_t byte) const { return area == Area::DB ? blocks_->place(byte) : byte; }

  std::shared_ptr<const BlockMap> blocks_;
  std::array<std::vector<Cut>, areaCount> cuts_;
};

}  // namespace rungproof
