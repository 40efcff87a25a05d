// CPU models: one row each, with what the manuals' tables give per CPU (tables 6-1, 6-45, 6-48; 001:2640-2717,
// 000:30-390; S7-200 SMART: system manual V2.8). Limits of addresses are in ir/s7200/cpu_tables.hpp. Sets of CPUs that
// descriptors name are derived from the rows, so a new CPU is a new row. Tests: tests/ir/cpu_table_test.cpp,
// tests/smart.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string_view>

#include "ir/address_limit.hpp"
#include "ir/area.hpp"
#include "ir/cpu_features.hpp"
#include "ir/target.hpp"

namespace rungproof {

/// Families of CPUs with one instruction set and one map of special memory each.
enum class Series : std::uint8_t { S7200, Smart };

/// What stands on the CPU itself (001:552-560, 001:11612-11622). Behind it the S7-200 numbers modules without holes in
/// their order (001:1439-1451); the S7-200 SMART gives every slot fixed addresses.
struct OnBoard {
  std::uint32_t inputs = 0, outputs = 0;              ///< points: I0.0 to I1.3 are 12
  std::uint32_t analogInputs = 0, analogOutputs = 0;  ///< words (001:1228)
};

struct CpuRow {
  std::string_view name;
  Series series;
  OnBoard onBoard;
  std::array<Edition, 2> editions;              ///< that describe it, the usual one first; twice the same: only that
  std::optional<std::uint8_t> identifier = {};  ///< SM6.4 to SM6.7 as the high half of the byte (001:14138)
  CpuFeatures features = {};                    ///< by the usual edition
  int olderSubroutines = 0, olderPidLoops = 0, olderPulseOutputs = 0;  ///< by the other one, where it differs
};

namespace cpu_rows {

inline constexpr std::array both = {Edition::Edition2004, Edition::Edition2003};
inline constexpr std::array only2003 = {Edition::Edition2003, Edition::Edition2003};
inline constexpr std::array only2004 = {Edition::Edition2004, Edition::Edition2004};
inline constexpr std::array smart = {Edition::Smart28, Edition::Smart27};
inline constexpr std::array onlySmart27 = {Edition::Smart27, Edition::Smart27};

// No table of the CPUs before 22x is at hand: general knowledge, except that the 212 lacks pulse outputs and clock
// (004:345, 004:734).
inline constexpr CpuFeatures of212 = {.subroutines = 16,
                                      .interruptRoutines = 32,
                                      .labels = 64,
                                      .pidLoops = 0,
                                      .queueIo = 4,
                                      .queueTimed = 2,
                                      .pulseOutputs = 0,
                                      .clockBuiltIn = false,
                                      .counters = numbers(0, 0),
                                      .events = numbers(0, 1) | numbers(8, 10) | numbers(12, 12)};
inline constexpr CpuFeatures of214 = {
    .pidLoops = 0, .queueTimed = 4, .counters = numbers(0, 2), .events = numbers(0, 20)};
inline constexpr CpuFeatures small = {.clockBuiltIn = false,
                                      .counters = numbers(0, 0) | numbers(3, 5),
                                      .events = numbers(0, 12) | numbers(19, 23) | numbers(27, 33)};
inline constexpr CpuFeatures of224 = {.events = numbers(0, 23) | numbers(27, 33)};
/// 001:2666 against 001:6751: the stricter number is kept, the rule names both lines.
inline constexpr CpuFeatures large = {.callable = 128, .ports = 2, .queueCommunication = 8};
inline constexpr CpuFeatures largest = {.subroutines = 128, .ports = 2, .queueCommunication = 8};

constexpr CpuFeatures smartFeatures(int ports, int pulseOutputs, int pidLoops, bool hasClock, NumberSet counters,
                                    NumberSet events) {
  return {.subroutines = 128,
          .edges = 1024,
          .pidLoops = pidLoops,
          .ports = ports,
          .pulseOutputs = pulseOutputs,
          .clockBuiltIn = hasClock,
          .stopsInCompare = false,
          .stackLevels = 32,
          .interruptNesting = 4,
          .counters = counters,
          .events = events,
          .unlistedEvents = numbers(14, 15) | numbers(39, 42)};
}
/// Without signal board, pulse outputs, second port and the counters 4 and 5.
inline constexpr CpuFeatures compact =
    smartFeatures(1, 0, 8, false, numbers(0, 3),
                  numbers(0, 13) | numbers(16, 18) | numbers(21, 23) | numbers(27, 28) | numbers(32, 32));
/// The numbers 14, 15 and 39 to 42 stand in no list; those of I7.0 and I7.1 and of HSC5 are uncertain
/// (ir/s7200/event.hpp).
constexpr CpuFeatures standard(int pulseOutputs) {
  const NumberSet pulses = pulseOutputs > 2 ? numbers(34, 34) : 0;
  return smartFeatures(2, pulseOutputs, 16, true, numbers(0, 5),
                       numbers(0, 13) | numbers(16, 33) | pulses | numbers(35, 38) | numbers(43, 44));
}

// clang-format off
inline constexpr auto rows = std::to_array<CpuRow>({
    {"212", Series::S7200, {8, 6}, both, {}, of212},
    {"214", Series::S7200, {14, 10}, both, {}, of214},
    {"221", Series::S7200, {6, 4}, both, 0x60, small},
    {"222", Series::S7200, {8, 6}, both, 0x00, small},
    {"224", Series::S7200, {14, 10}, both, 0x20, of224},
    {"224XP", Series::S7200, {14, 10, 2, 1}, only2004, {}, large},
    {"226", Series::S7200, {24, 16}, both, 0x90, largest, 64},
    {"226XM", Series::S7200, {24, 16}, only2003, 0x90, largest},
    {"CR20s", Series::Smart, {12, 8}, smart, {}, compact},
    {"CR30s", Series::Smart, {18, 12}, smart, {}, compact},
    {"CR40s", Series::Smart, {24, 16}, smart, {}, compact},
    {"CR60s", Series::Smart, {36, 24}, smart, {}, compact},
    {"CR40", Series::Smart, {24, 16}, onlySmart27, {}, compact},
    {"CR60", Series::Smart, {36, 24}, onlySmart27, {}, compact},
    {"SR20", Series::Smart, {12, 8}, smart, {}, standard(2), 0, 8},
    {"ST20", Series::Smart, {12, 8}, smart, {}, standard(2), 0, 8},
    {"SR30", Series::Smart, {18, 12}, smart, {}, standard(3), 0, 8},
    {"ST30", Series::Smart, {18, 12}, smart, {}, standard(3), 0, 8},
    {"SR40", Series::Smart, {24, 16}, smart, {}, standard(3), 0, 8},
    {"ST40", Series::Smart, {24, 16}, smart, {}, standard(3), 0, 8},
    {"SR60", Series::Smart, {36, 24}, smart, {}, standard(3), 0, 8},
    {"ST60", Series::Smart, {36, 24}, smart, {}, standard(4), 0, 8, 3},
});
// clang-format on

inline constexpr CpuRow none = {"", Series::S7200, {}, {Edition::Step7, Edition::Step7}, {}, noFeatures};

}  // namespace cpu_rows

inline constexpr std::size_t cpuCount = cpu_rows::rows.size();
/// The CPU of that name, which must stand in the rows: s7200Cpu("224XP").
consteval Cpu s7200Cpu(std::string_view name) {
  for (std::size_t i = 0; i < cpuCount; ++i) {
    if (cpu_rows::rows[i].name == name) return static_cast<Cpu>(i);
  }
  throw std::invalid_argument("no such CPU");
}

/// A CPU of another family has the row of one that has nothing of an S7-200's.
constexpr const CpuRow& cpuRow(Cpu cpu) {
  return static_cast<std::size_t>(cpu) < cpuCount ? cpu_rows::rows[static_cast<std::size_t>(cpu)] : cpu_rows::none;
}
constexpr bool isSmart(Cpu cpu) { return cpuRow(cpu).series == Series::Smart; }
constexpr bool isSmart(const Target& target) { return isSmart(target.cpu); }

/// The CPUs whose row fulfils the condition.
template <class Condition>
constexpr CpuSet cpusWith(Condition condition) {
  CpuSet set = 0;
  for (std::size_t i = 0; i < cpuCount; ++i) set |= condition(cpu_rows::rows[i]) ? cpuBit(static_cast<Cpu>(i)) : 0;
  return set;
}
inline constexpr CpuSet smartCpus = cpusWith([](const CpuRow& row) { return row.series == Series::Smart; });
/// The CPUs of the same series.
constexpr CpuSet seriesOf(Cpu cpu) {
  return cpusWith([series = cpuRow(cpu).series](const CpuRow& row) { return row.series == series; });
}
/// Place of facts on the S7-200 SMART: its manual has no line numbers here.
inline constexpr std::string_view smartManual = "S7-200 SMART system manual";
inline constexpr CpuSet s7200Cpus = cpusWith([](const CpuRow& row) { return row.series == Series::S7200; });

/// Whether the manual edition describes that CPU at all (224XP: 2004 only; 226XM: 2003 only; 212/214: seed 004).
constexpr bool editionCovers(Edition edition, Cpu cpu) {
  return cpuRow(cpu).editions[0] == edition || cpuRow(cpu).editions[1] == edition;
}
constexpr Edition usualEdition(Cpu cpu) { return cpuRow(cpu).editions[0]; }
/// The other edition that describes the CPU; the same if there is only one.
constexpr Edition otherEdition(const Target& target) {
  const std::array<Edition, 2>& editions = cpuRow(target.cpu).editions;
  return editions[0] == target.edition ? editions[1] : editions[0];
}

constexpr CpuFeatures cpuFeatures(const Target& target) {
  const CpuRow& row = cpuRow(target.cpu);
  CpuFeatures features = row.features;
  if (target.edition == row.editions[0]) return features;
  if (row.olderSubroutines != 0) features.subroutines = row.olderSubroutines;
  if (row.olderPidLoops != 0) features.pidLoops = row.olderPidLoops;
  if (row.olderPulseOutputs != 0) features.pulseOutputs = row.olderPulseOutputs;
  return features;
}
/// Whether the CPU has that interrupt event (001:5366).
constexpr bool eventExists(const Target& target, int event) { return contains(cpuFeatures(target).events, event); }
constexpr bool hscExists(const Target& target, int counter) { return contains(cpuFeatures(target).counters, counter); }
/// SM0..smReadOnlyLast are read only (001:2652).
inline constexpr std::uint32_t smReadOnlyLast = 29;

/// Resolution in ms of a timer number, 1, 10 or 100 (table 6-74, 001:6597-6603), or 0 if there is no such timer.
int timerResolution(int number);
/// Whether the number belongs to TONR (true) or to TON/TOF.
bool timerIsRetentive(int number);

/// Table 6-2; knows the gaps (HC1/HC2 on 221/222, odd AI/AQ, bytes 32 to 127 of the SMART's images).
std::optional<AddressLimit> s7200AddressLimit(const Target& target, Area area, Width width);
bool s7200AddressExists(const Target& target, Area area, Width width, std::uint32_t offset, unsigned bit);
/// The first byte of a gap behind that address; 0: none.
std::uint32_t s7200GapBehind(const Target& target, Area area, std::uint32_t offset);

}  // namespace rungproof
