// The family of the CPU answers.
#include "ir/address_limit.hpp"

#include <algorithm>

#include "ir/dialect.hpp"

namespace rungproof {

std::optional<AddressLimit> addressLimit(const Target& target, Area area, Width width) {
  return dialectOf(target).memory.addressLimit(target, area, width);
}

bool addressExists(const Target& target, Area area, Width width, std::uint32_t offset, unsigned bit) {
  return dialectOf(target).memory.addressExists(target, area, width, offset, bit);
}

std::uint32_t areaSize(const Target& target, Area area) {
  const Width width = areaInfo(area).width.value_or(Width::Byte);
  const std::optional<AddressLimit> limit = addressLimit(target, area, width);
  if (!limit) return 0;
  return limit->lastByte + static_cast<std::uint32_t>(isAnalogue(area) ? 2 : 1);
}

std::uint32_t rowEnd(const Target& target, Area area, std::uint32_t offset) {
  const std::uint32_t gap = dialectOf(target).memory.gapBehind(target, area, offset), size = areaSize(target, area);
  return gap == 0 ? size : std::min(gap, size);
}

}  // namespace rungproof
