// Which addresses a CPU has. The numbers are the family's (MemoryModel::addressLimit).
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "ir/area.hpp"
#include "ir/target.hpp"

namespace rungproof {

/// Highest legal start address of an access (table 6-2). Areas without such access give nothing.
struct AddressLimit {
  std::uint32_t lastByte = 0;  ///< highest start byte, or highest number for T, C, AC, HC
  std::string_view source;     ///< "001:2679"
  std::string_view note;       ///< the misprint that was resolved, or empty
};
std::optional<AddressLimit> addressLimit(const Target& target, Area area, Width width);
/// Whether the address exists; knows the gaps in an area.
bool addressExists(const Target& target, Area area, Width width, std::uint32_t offset, unsigned bit);
/// Size of an area in bytes on that CPU (T, C, AC, HC: count).
std::uint32_t areaSize(const Target& target, Area area);
/// Where the row of bytes (T, C, AC, HC: numbers) ends in which the address stands: a gap, or the size of the area.
std::uint32_t rowEnd(const Target& target, Area area, std::uint32_t offset);

/// The limit in an area of `size` bytes or numbers without gaps.
constexpr std::optional<AddressLimit> limitWithin(std::uint32_t size, Area area, Width width) {
  const auto length = static_cast<std::uint32_t>(hasBitAndWord(area) ? 1 : bytes(width));
  return size < length ? std::nullopt : std::optional(AddressLimit{size - length, {}, {}});
}
constexpr std::uint32_t noGapBehind(const Target&, Area, std::uint32_t) { return 0; }
constexpr bool isWithin(const std::optional<AddressLimit>& limit, Width width, std::uint32_t offset, unsigned bit) {
  return limit && offset <= limit->lastByte && (width != Width::Bit || bit <= 7);
}

}  // namespace rungproof
