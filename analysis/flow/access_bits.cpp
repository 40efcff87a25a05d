// Counts by cell, then fills from the last access to the first; the few entries of a cell are put in order of their
// bits.
#include "analysis/flow/access_bits.hpp"

#include <algorithm>
#include <array>

namespace rungproof {

BitWrites::BitWrites(const AccessTable& table, const CellMap& cells, const BlockRow& blockOf) {
  first_.assign(cells.size() + 1, 0);
  const auto eachBit = [&](const Access& a, auto visit) {
    if (!a.write || a.viaPointer || a.width != Width::Bit || a.byNumber() || a.bit > 7) return;
    const std::uint32_t cell = cells.cell(a.area, a.offset, blockOf[a.instruction]);
    if (cell == cells.size()) return;
    const std::uint32_t room = (cells.length(a.area) - a.offset) * 8 - a.bit;
    for (std::uint32_t k = 0; k < std::min<std::uint32_t>(a.count, room); ++k) visit(cell * 8 + a.bit + k);
  };
  const std::span<const Access> all = table.all();
  for (const Access& a : all) eachBit(a, [&](std::uint32_t key) { ++first_[key / 8]; });
  for (std::size_t cell = 1; cell < first_.size(); ++cell) first_[cell] += first_[cell - 1];
  entries_.resize(first_.back());
  bits_.resize(entries_.size());
  for (std::uint32_t i = static_cast<std::uint32_t>(all.size()); i-- > 0;) {
    eachBit(all[i], [&](std::uint32_t key) {
      const std::uint32_t at = --first_[key / 8];
      entries_[at] = i;
      bits_[at] = static_cast<std::uint8_t>(key % 8);
    });
  }
  std::array<std::vector<std::uint32_t>, 8> ofBit;
  for (std::size_t cell = 0; cell + 1 < first_.size(); ++cell) {
    const auto bits = std::span(bits_).subspan(first_[cell], first_[cell + 1] - first_[cell]);
    if (std::ranges::is_sorted(bits)) continue;
    for (std::uint32_t i = first_[cell]; i < first_[cell + 1]; ++i) ofBit[bits_[i]].push_back(entries_[i]);
    std::uint32_t at = first_[cell];
    for (std::uint8_t bit = 0; bit < 8; ++bit) {
      for (const std::uint32_t entry : ofBit[bit]) {
        entries_[at] = entry;
        bits_[at++] = bit;
      }
      ofBit[bit].clear();
    }
  }
}

std::span<const std::uint32_t> BitWrites::at(std::uint32_t key) const {
  const auto bits = std::span(bits_).subspan(first_[key / 8], first_[key / 8 + 1] - first_[key / 8]);
  const auto [from, to] = std::ranges::equal_range(bits, static_cast<std::uint8_t>(key % 8));
  return std::span(entries_).subspan(first_[key / 8] + static_cast<std::size_t>(from - bits.begin()),
                                     static_cast<std::size_t>(to - from));
}

}  // namespace rungproof
