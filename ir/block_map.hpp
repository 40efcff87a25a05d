// Byte numbers of data blocks: a byte of Area::DB is numbered by its block and its place in it, so that a place names
// itself (DB10.DBX2.3). Memory is kept in one row; the map says where a block begins there.
// Tested by tests/ir/block_map_test.cpp.
#pragma once

#include <cstdint>
#include <vector>

#include "ir/program.hpp"

namespace rungproof {

/// Highest number of a data block that has a byte number: what lies above is told by the reader and not modelled.
inline constexpr std::uint32_t lastDataBlock = 8191;

constexpr std::uint32_t dataByte(std::uint32_t block, std::uint32_t byte) { return block << 16 | byte; }
constexpr std::uint32_t blockOfByte(std::uint32_t dataByte) { return dataByte >> 16; }
constexpr std::uint32_t byteInBlock(std::uint32_t dataByte) { return dataByte & 0xFFFF; }

class BlockMap {
 public:
  BlockMap() = default;
  explicit BlockMap(const Program& program);

  /// Bytes of all blocks, with some room behind each so that no access reaches into the next.
  std::uint32_t size() const { return size_; }
  /// Length of a block in bytes; 0: there is none of that number.
  std::uint32_t length(std::uint32_t block) const { return block < rows_.size() ? rows_[block].length : 0; }
  /// Whether it is write-protected (READ_ONLY) or stays in the load memory (UNLINKED), 002:537-563.
  bool isReadOnly(std::uint32_t block) const { return block < rows_.size() && rows_[block].isReadOnly; }
  bool isUnlinked(std::uint32_t block) const { return block < rows_.size() && rows_[block].isUnlinked; }
  /// Place of a byte in the row of all blocks; size() if its block does not exist.
  std::uint32_t place(std::uint32_t dataByte) const {
    const std::uint32_t block = blockOfByte(dataByte);
    if (block >= rows_.size() || rows_[block].length == 0) return size_;
    const std::uint32_t byte = byteInBlock(dataByte);
    return byte < rows_[block].length + room ? rows_[block].first + byte : size_;
  }
  /// The same for bits counted as byte * 8 + bit.
  std::uint32_t bitPlace(std::uint32_t dataBit) const { return place(dataBit / 8) * 8 + dataBit % 8; }
  /// The byte at a place of the row: the way back.
  std::uint32_t dataByteAt(std::uint32_t place) const;

 private:
  static constexpr std::uint32_t room = 4;
  struct Row {
    std::uint32_t first = 0;
    std::uint32_t length = 0;
    bool isReadOnly = false, isUnlinked = false;
  };
  std::vector<Row> rows_;               ///< by block number
  std::vector<std::uint32_t> ordered_;  ///< block numbers in the order of the row
  std::uint32_t size_ = 0;
};

}  // namespace rungproof
