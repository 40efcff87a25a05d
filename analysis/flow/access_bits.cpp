// Two passes over the accesses: count, fill.
#include "analysis/flow/access_bits.hpp"

#include <algorithm>

namespace rungproof {

BitWrites::BitWrites(const AccessTable& table, const CellMap& cells, std::span<const std::uint32_t> blockOf) {
  first_.assign(static_cast<std::size_t>(cells.size()) * 8 + 1, 0);
  const auto eachBit = [&](const Access& a, auto visit) {
    if (!a.write || a.viaPointer || a.width != Width::Bit || a.byNumber() || a.bit > 7) return;
    const std::uint32_t cell = cells.cell(a.area, a.offset, blockOf[a.instruction]);
    if (cell == cells.size()) return;
    const std::uint32_t room = (cells.length(a.area) - a.offset) * 8 - a.bit;
    for (std::uint32_t k = 0; k < std::min<std::uint32_t>(a.count, room); ++k) visit(cell * 8 + a.bit + k);
  };
  const std::span<const Access> all = table.all();
  for (const Access& a : all) eachBit(a, [&](std::uint32_t key) { ++first_[key + 1]; });
  for (std::size_t key = 1; key < first_.size(); ++key) first_[key] += first_[key - 1];
  entries_.resize(first_.back());
  std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
  for (std::uint32_t i = 0; i < all.size(); ++i) eachBit(all[i], [&](std::uint32_t key) { entries_[next[key]++] = i; });
}

}  // namespace rungproof
