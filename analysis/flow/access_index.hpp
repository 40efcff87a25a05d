// From an address to its accesses. Memory is numbered in cells: one per byte, one per timer, counter, accumulator
// and fast counter; local memory has 64 cells for each block. Rules walk over cells and their lists, so that every
// rule stays linear in the size of the program. Tested by tests/rules/access_test.cpp.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "analysis/flow/access.hpp"
#include "analysis/flow/block_row.hpp"
#include "ir/block_map.hpp"

namespace rungproof {

/// Numbering of all cells of a program on its CPU.
class CellMap {
 public:
  explicit CellMap(const Program& program);

  std::uint32_t size() const { return size_; }
  /// Cell of a byte or number; `block` counts only for L. Gives size() for addresses that the CPU does not have.
  std::uint32_t cell(Area area, std::uint32_t offset, std::uint32_t block) const {
    const std::size_t a = static_cast<std::size_t>(area);
    if (area == Area::DB) offset = dataBlocks_.place(offset);
    if (offset >= length_[a]) return size_;
    return base_[a] + offset + (area == Area::L ? block * length_[a] : 0);
  }
  std::uint32_t length(Area area) const { return length_[static_cast<std::size_t>(area)]; }
  /// Cells from this one to the end of its area.
  std::uint32_t left(std::uint32_t cell, Area area) const {
    const std::size_t a = static_cast<std::size_t>(area);
    return length_[a] - (cell - base_[a]) % length_[a];
  }
  Area areaOf(std::uint32_t cell) const;
  /// Byte or number of a cell within its area (and block).
  std::uint32_t offsetOf(std::uint32_t cell) const;

 private:
  std::array<std::uint32_t, areaCount> base_{};
  std::array<std::uint32_t, areaCount> length_{};
  std::uint32_t size_ = 0;
  std::size_t blocks_;
  BlockMap dataBlocks_;
};

/// Accesses by cell. Accesses longer than `longest` cells, and those through pointers, are not in the lists of the
/// cells but in `wide`; the coverage marks contain them.
class AccessIndex {
 public:
  static constexpr std::uint32_t longest = 40;

  AccessIndex(const Program& program, const AccessTable& table, const BlockRow& blockOf);

  const CellMap& cells() const { return cells_; }
  /// Indices in AccessTable::all() of the accesses that touch the cell, in program order.
  std::span<const std::uint32_t> at(std::uint32_t cell) const {
    return std::span(entries_).subspan(first_[cell], first_[cell + 1] - first_[cell]);
  }
  std::span<const std::uint32_t> wide() const { return wide_; }
  /// Whether some access, block operation or data block may have written the cell, or may read it.
  bool mayBeWritten(std::uint32_t cell) const { return written_[cell] != 0; }
  bool mayBeRead(std::uint32_t cell) const { return read_[cell] != 0; }
  /// The same by accesses that the lists do not show in full: through pointers, long, of open length, or a data block.
  bool isWrittenAtLarge(std::uint32_t cell) const { return writtenAtLarge_[cell] != 0; }
  bool isReadAtLarge(std::uint32_t cell) const { return readAtLarge_[cell] != 0; }
  /// Whether accesses through pointers may reach the cell.
  bool mayBePointedTo(std::uint32_t cell) const { return pointed_[cell] != 0; }

 private:
  struct Cover {
    std::vector<std::uint8_t>*any, *atLarge;
  };
  void cover(const AccessTable& table, const BlockRow& blockOf, bool writes, Cover marks);
  void coverPointers(const Program& program, const AccessTable& table);

  CellMap cells_;
  std::vector<std::uint32_t> entries_;
  std::vector<std::uint32_t> first_;
  std::vector<std::uint32_t> wide_;
  std::vector<std::uint8_t> written_, read_, writtenAtLarge_, readAtLarge_, pointed_;
};

}  // namespace rungproof
