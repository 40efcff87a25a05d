// Table of forced values.
#include "engine/force.hpp"

#include <algorithm>

namespace rungproof {

namespace {

constexpr std::size_t maxForcedMemory = 16;  // 001:7956

bool isImage(Area area) { return area == Area::I || area == Area::Q; }

bool sameOperand(const Operand& a, const Operand& b) {
  return a.area == b.area && a.width == b.width && a.offset == b.offset && a.bit == b.bit;
}

}  // namespace

bool ForceTable::set(const Operand& operand, std::uint64_t value) {
  if (operand.kind != OperandKind::Direct || !areaInfo(operand.area).mayBeForced) return false;
  if (operand.width == Width::Bit && !isImage(operand.area)) return false;
  const auto known = std::find_if(entries_.begin(), entries_.end(),
                                  [&](const Entry& entry) { return sameOperand(entry.operand, operand); });
  if (known != entries_.end()) {
    known->value = value;
    return true;
  }
  const auto memory =
      std::count_if(entries_.begin(), entries_.end(), [](const Entry& entry) { return !isImage(entry.operand.area); });
  if (!isImage(operand.area) && static_cast<std::size_t>(memory) >= maxForcedMemory) return false;
  entries_.push_back({operand, value});
  return true;
}

void ForceTable::remove(const Operand& operand) {
  std::erase_if(entries_, [&](const Entry& entry) { return sameOperand(entry.operand, operand); });
}

void ForceTable::apply(Area area, Concrete::Store& store) const {
  for (const Entry& entry : entries_) {
    if (entry.operand.area == area)
      store.save(area, entry.operand.offset * 8 + entry.operand.bit, bits(entry.operand.width), entry.value, true);
  }
}

std::optional<bool> ForceTable::bit(Area area, std::uint32_t index) const {
  std::optional<bool> result;
  for (const Entry& entry : entries_) {
    if (entry.operand.area != area) continue;
    const auto width = static_cast<std::uint32_t>(bits(entry.operand.width));
    const std::uint32_t first = entry.operand.offset * 8;
    if (width == 1) {
      if (index == first + entry.operand.bit) result = (entry.value & 1) != 0;
    } else if (index >= first && index < first + width) {
      const std::uint32_t byte = (index - first) / 8;  // the lowest address holds the most significant byte
      result = (entry.value >> (width - 8 * (byte + 1) + (index - first) % 8) & 1) != 0;
    }
  }
  return result;
}

std::optional<std::uint16_t> ForceTable::word(Area area, std::uint32_t offset) const {
  std::optional<std::uint16_t> result;
  for (const Entry& entry : entries_) {
    if (entry.operand.area == area && entry.operand.offset == offset) result = static_cast<std::uint16_t>(entry.value);
  }
  return result;
}

}  // namespace rungproof
