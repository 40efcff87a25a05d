// Special memory: where the value of each SM bit comes from. The engine, the encoder, the stimulus and the rules take
// it from here. A bit of the S7-200 that stands in no table, or that the manual reserves in a control byte, keeps what
// the program writes; reserved status bits have any value. Covered by tests/environment/special_memory_test.cpp, row by
// row of the manual's tables, and tests/smart.
#pragma once

#include <span>

#include "ir/s7200/special_memory_s7200.hpp"
#include "ir/s7200/special_memory_smart.hpp"
#include "ir/system_bit.hpp"

namespace rungproof {

/// SM0.0, SM0.1 and the clocks SM0.4 to SM0.6, alike on all CPUs (001:14050-14056).
inline constexpr SystemBits s7200SystemBits = {.alwaysOn = {Area::SM, 0, 0},
                                               .firstScan = {Area::SM, 0, 1},
                                               .minuteClock = {Area::SM, 0, 4},
                                               .secondClock = {Area::SM, 0, 5},
                                               .scanClock = {Area::SM, 0, 6}};

/// The table of the CPU's family.
constexpr std::span<const SmRow> smTable(Series series) {
  if (series == Series::Smart) return smartSmTable;
  return s7200SmTable;
}
constexpr std::span<const SmRow> smTable(const Target& target) { return smTable(cpuRow(target.cpu).series); }

/// The row of a bit; bytes behind the table, which no CPU has, count as its last row.
constexpr const SmRow& smRow(const Target& target, std::uint32_t byte, std::uint32_t bit) {
  const std::span<const SmRow> table = smTable(target);
  for (const SmRow& row : table) {
    if (row.holds(byte, bit)) return row;
  }
  return table.back();
}

/// Whether SM31.7 makes the CPU save a value to permanent memory (001:1643-1677).
constexpr bool savesMemory(const Target& target) { return smRow(target, 31, 7).source == SmSource::Device; }

/// The source of a bit on that CPU.
constexpr SmSource smSource(const Target& target, std::uint32_t byte, std::uint32_t bit) {
  const SmSource source = smRow(target, byte, bit).source;
  const bool isUnknownCpu = byte == 6 && source == SmSource::Constant && !cpuRow(target.cpu).identifier;
  return isUnknownCpu ? SmSource::Free : source;
}

}  // namespace rungproof
