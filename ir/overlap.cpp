// The ranges behind ir/overlap.hpp, in bits.
#include "ir/overlap.hpp"

#include <utility>

namespace rungproof {

bool overlaps(const Operand& a, const Operand& b) {
  if (a.kind != OperandKind::Direct || b.kind != OperandKind::Direct || a.area != b.area) return false;
  if (hasBitAndWord(a.area)) return a.offset == b.offset;
  const auto range = [](const Operand& o) {
    const std::uint32_t first = o.offset * 8 + (o.width == Width::Bit ? o.bit : 0);
    return std::pair(first, first + static_cast<std::uint32_t>(bits(o.width)));
  };
  return range(a).first < range(b).second && range(b).first < range(a).second;
}

}  // namespace rungproof
