// Lays the data blocks of a program out in one row.
#include "ir/block_map.hpp"

#include <algorithm>

namespace rungproof {

BlockMap::BlockMap(const Program& program) {
  for (const DataBlock& block : program.dataBlocks) {
    if (block.number > lastDataBlock || block.bytes.empty()) continue;
    if (block.number >= rows_.size()) rows_.resize(block.number + 1);
    rows_[block.number] = {size_, static_cast<std::uint32_t>(block.bytes.size()), block.readOnly, block.unlinked};
    ordered_.push_back(block.number);
    size_ += rows_[block.number].length + room;
  }
}

std::uint32_t BlockMap::dataByteAt(std::uint32_t place) const {
  const auto above = std::upper_bound(ordered_.begin(), ordered_.end(), place,
                                      [&](std::uint32_t at, std::uint32_t block) { return at < rows_[block].first; });
  if (above == ordered_.begin()) return 0;
  const std::uint32_t block = *std::prev(above);
  return dataByte(block, place - rows_[block].first);
}

}  // namespace rungproof
