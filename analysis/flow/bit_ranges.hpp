// Bits by name where a finding is about several: "Q0.2 to Q0.7", "M0.0, M0.2 to M0.3". One finding names the whole
// range that it is about once, and its address is the first bit. Tested by tests/rules/output_rules_test.cpp.
#pragma once

#include <string>
#include <vector>

#include "ir/operand.hpp"

namespace rungproof {

/// Bits of one area, each as byte * 8 + bit; of T and C as the number.
struct BitRow {
  Area area = Area::V;
  std::vector<std::uint32_t> bits{};

  bool empty() const { return bits.empty(); }
  /// Sorted, each bit once.
  void order();
  /// The first bit as an address: "Q0.2". The row must have one.
  std::string first() const;
  /// All of them, neighbours joined; a long list ends in "and 12 more". The row must be in order.
  std::string text() const;
};

/// Position of a bit in a BitRow.
constexpr std::uint32_t bitPosition(Area area, std::uint32_t offset, unsigned bit) {
  return hasBitAndWord(area) ? offset : offset * 8 + bit;
}

/// "MAIN", "MAIN and SBR_0", "MAIN, SBR_0 and SBR_1".
std::string joined(const std::vector<std::string>& names);

}  // namespace rungproof
