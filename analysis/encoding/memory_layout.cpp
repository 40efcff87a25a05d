// Cuts memory into words and bits by the accesses of the program.
#include "analysis/encoding/memory_layout.hpp"

#include "analysis/flow/access.hpp"
#include "ir/s7200/special_memory.hpp"

namespace rungproof {

MemoryLayout::MemoryLayout(const Plan& plan) : blocks_(plan.blocks) {
  const Target& target = plan.program->target;
  for (int a = 0; a < areaCount; ++a) {
    const Area area = static_cast<Area>(a);
    const bool inRegisters = addressedByNumber(area);
    cuts_[static_cast<std::size_t>(a)].resize(inRegisters        ? 0
                                              : area == Area::L  ? plan.localBytes
                                              : area == Area::DB ? blocks_->size()
                                                                 : areaSize(target, area));
  }
  std::vector<Cut>& special = cuts_[static_cast<std::size_t>(Area::SM)];
  for (const SmRow& row : smTable(target)) {
    if (row.first >= special.size()) break;
    special[row.first].startsHere = true;
    if (row.low != 0 || row.high != 7) special[row.first].isSingleBits = true;
  }
}

void MemoryLayout::add(const Program& program, const Plan& plan) {
  const AccessTable table(program, plan);
  for (const Access& access : table.all()) {
    if (access.viaPointer || access.byNumber() || access.area == Area::L) continue;
    if (access.width == Width::Bit) {
      for (std::uint32_t i = 0; i < access.possibleLength(); ++i) add(access.area, Width::Bit, access.offset + i);
    } else {
      for (std::uint32_t k = 0; k < access.most; ++k)
        add(access.area, access.width, access.offset + k * static_cast<std::uint32_t>(bytes(access.width)));
    }
  }
  // The statements of IEC timers reach their instances through registers: IN, Q and the bits of STATE; PT, ET and
  // ATIME.
  for (const std::uint32_t instance : plan.iecTimers) {
    for (const std::uint32_t bit : {0U, 6U, 12U}) add(Area::DB, Width::Bit, instance + bit);
    for (const std::uint32_t time : {2U, 8U, 18U}) add(Area::DB, Width::DWord, instance + time);
  }
}

void MemoryLayout::add(Area area, Width width, std::uint32_t name) {
  const std::uint32_t byte = inRow(area, name);
  std::vector<Cut>& cuts = cuts_[static_cast<std::size_t>(area)];
  const std::uint32_t end = byte + static_cast<std::uint32_t>(bytes(width));
  if (end > cuts.size()) return;
  if (width == Width::Bit) cuts[byte].isSingleBits = true;
  cuts[byte].startsHere = true;
  if (end < cuts.size()) cuts[end].startsHere = true;
  for (std::uint32_t i = byte; i + 1 < end; ++i) cuts[i].joinsNext = true;
}

void MemoryLayout::beginAt(Area area, std::uint32_t name) {
  const std::uint32_t byte = inRow(area, name);
  std::vector<Cut>& cuts = cuts_[static_cast<std::size_t>(area)];
  if (byte < cuts.size()) cuts[byte].startsHere = true;
}

/// Whether the byte and the next belong to one word.
bool MemoryLayout::isJoined(Area area, std::uint32_t byte) const {
  if (byte + 1 >= size(area)) return false;
  const Cut& here = cut(area, byte);
  const Cut& next = cut(area, byte + 1);
  return here.joinsNext && !here.isSingleBits && !next.isSingleBits && !next.startsHere;
}

MemoryLayout::Word MemoryLayout::wordOf(Area area, std::uint32_t byte) const {
  std::uint32_t first = byte;
  while (first > 0 && isJoined(area, first - 1)) --first;
  std::uint32_t count = 1;
  while (isJoined(area, first + count - 1)) ++count;
  // Long rows of overlapping words are cut every four bytes from their start.
  const std::uint32_t start = first + (byte - first) / 4 * 4;
  return {start, std::min<std::uint32_t>(4, first + count - start)};
}

}  // namespace rungproof
