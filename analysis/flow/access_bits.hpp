// Writes of single bits, bit by bit: coils, latches, shift registers, parameters. S and R with N bits appear under each
// of them. Rules on outputs walk over bits and their writers. Tested by tests/rules/access_test.cpp.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "analysis/flow/access_index.hpp"

namespace rungproof {

class BitWrites {
 public:
  BitWrites(const AccessTable& table, const CellMap& cells, const BlockRow& blockOf);

  /// Number of bits: eight for each cell; bit `key` is bit key % 8 of cell key / 8.
  std::uint32_t size() const { return static_cast<std::uint32_t>(first_.size() - 1) * 8; }
  /// Indices in AccessTable::all() of the bit accesses that write the bit, in program order.
  std::span<const std::uint32_t> at(std::uint32_t key) const;

 private:
  std::vector<std::uint32_t> entries_;  ///< by cell, then by bit
  std::vector<std::uint8_t> bits_;      ///< of the entries, 0 to 7
  std::vector<std::uint32_t> first_;    ///< entry of each cell
};

}  // namespace rungproof
