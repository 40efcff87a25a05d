// What a panel or a network writes, as settings name it: "VW100", "VB100..VB199", "V10.0", "DB10.DBW0..DB10.DBW8".
// The same as an `external` line among the properties. Tested by tests/cli/tags_test.cpp.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "analysis/property.hpp"
#include "ir/block_map.hpp"

namespace rungproof {

/// Whether what lies there can be written from outside: V, M, DB, S, SM and Q.
constexpr bool mayBeExternal(Area area) { return isMemoryArea(area) || area == Area::SM || area == Area::Q; }
/// Whether a range can lead from one to the other: in one area, of the data blocks in one block.
constexpr bool areOfOneArea(const Operand& first, const Operand& last) {
  const bool isOneBlock = first.area != Area::DB || blockOfByte(first.offset) == blockOfByte(last.offset);
  return first.area == last.area && isOneBlock;
}
/// Why the two ends are no range that is written from outside, and what to write; nothing if they are.
struct RangeFault {
  std::string message, help;
};
std::optional<RangeFault> faultOfRange(const Operand& first, const Operand& last);
/// The last address of a range as text: behind DB10.DBB0, DBB19 is one of DB10.
std::string lastOfRange(std::string_view first, std::string_view last);
/// Nothing if the text names no such place, or its ends do not fit together.
std::optional<ExternalRange> externalRangeNamed(std::string_view text);

}  // namespace rungproof
