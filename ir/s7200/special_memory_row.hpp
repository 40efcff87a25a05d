// What a row of a table of special memory says; the tables are ir/s7200/special_memory_s7200.hpp and _smart.hpp.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "ir/s7200/cpu.hpp"

namespace rungproof {

enum class SmSource : std::uint8_t {
  Constant,   ///< one value for ever
  Computed,   ///< by the CPU from the run: instructions, clocks, scan times
  FirstScan,  ///< any value in the first scan, 0 in all others
  Free,       ///< any value in every scan: switches, modules, faults, received characters
  Device,     ///< written by a device that the program has set going (analysis/encoding/device_writes.cpp)
  Program     ///< what the program has written
};

/// Bytes `first` to `last`, of each the bits `low` to `high`.
struct SmRow {
  std::uint16_t first, last;
  std::uint8_t low, high;
  SmSource source;
  std::string_view text;
  std::string_view manual;

  constexpr bool holds(std::uint32_t byte, std::uint32_t bit) const {
    return first <= byte && byte <= last && low <= bit && bit <= high;
  }
  constexpr bool isWritable() const { return first > smReadOnlyLast; }  // 001:2652
};

namespace detail {
/// Every bit up to the last stands in exactly one row, and the rows are in order.
template <std::size_t rows>
constexpr bool smTableIsComplete(const std::array<SmRow, rows>& table) {
  std::size_t at = 0;
  for (std::uint32_t byte = 0; byte <= table.back().last; ++byte) {
    for (std::uint32_t bit = 0; bit < 8; ++bit) {
      while (at < table.size() && !table[at].holds(byte, bit)) {
        const bool isOver = table[at].last < byte || (table[at].last == byte && table[at].high < bit);
        if (!isOver) return false;
        ++at;
      }
      if (at == table.size()) return false;
    }
  }
  return at + 1 == table.size();
}
}  // namespace detail

}  // namespace rungproof
