// Looks at the limits of the CPU.
#include "frontend/stl/missing_address.hpp"

#include <fmt/format.h>

namespace rungproof {

std::optional<std::string> missingFrom(const Target& target, const Operand& operand) {
  if (operand.area == Area::L) return std::nullopt;
  const bool isNumbered = hasBitAndWord(operand.area);
  const Width width = isNumbered && operand.width == Width::Bit ? Width::Word : operand.width;
  const bool isBit = width == Width::Bit;
  if (addressExists(target, operand.area, width, operand.offset, isBit ? operand.bit : 0)) return std::nullopt;
  const std::optional<AddressLimit> limit = addressLimit(target, operand.area, width);
  const std::string name = toString(operand);
  if (!limit) return fmt::format("the CPU {} has no {}", cpuName(target.cpu), name);
  if (operand.offset > limit->lastByte)
    return fmt::format("the CPU {} has no {}: the last one is {}", cpuName(target.cpu), name,
                       addressName(operand.area, width, limit->lastByte, 7));
  if (operand.offset + static_cast<std::uint32_t>(bytes(width)) > rowEnd(target, operand.area, 0))
    return fmt::format("the CPU {} has no {}: {} has a gap behind {}", cpuName(target.cpu), name,
                       areaName(operand.area),
                       addressName(operand.area, Width::Byte, rowEnd(target, operand.area, 0) - 1, 7));
  if (isBit) return fmt::format("{} has bit number {}; a byte has bits 0 to 7", name, operand.bit);
  return fmt::format("the CPU {} has no {}", cpuName(target.cpu), name);
}

}  // namespace rungproof
